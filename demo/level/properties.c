/* properties.c: reads Tiled's custom properties, which objects inherit from their layer, groups and
 * the map, and checks their types and ranges. */
#include "reader.h"

#include <thud/thud_limits.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const KNOWN[] = {
    "body",
    "bodyType", /* the name in maps made for other engines */
    "fixed_rotation",
    "sensor",
    "may_sleep",
    "velocity_x",
    "velocity_y",
    "angular_velocity",
    "gravity_scale",
    "linear_damping",
    "angular_damping",
    "density",
    "friction",
    "restitution",
    "category",
    "mask",
    "group",
    "approximate",
    "solid",
    "gravity_x",
    "gravity_y",
    "pixels_per_unit",
    "length_scale",
    "camera_x",
    "camera_y",
    "camera_height",
    "character",
    "title",
    "about",
};

const cJSON *level_field(const cJSON *json, const char *name) {
    return cJSON_GetObjectItemCaseSensitive(json, name);
}

static const char *string_or(const cJSON *json, const char *fallback) {
    return cJSON_IsString(json) ? json->valuestring : fallback;
}

const char *level_field_text(const cJSON *json, const char *name, const char *fallback) {
    return string_or(level_field(json, name), fallback);
}

const cJSON *level_own_property(const cJSON *json, const char *name) {
    const cJSON *property;
    cJSON_ArrayForEach(property, level_field(json, "properties")) {
        if (strcmp(string_or(level_field(property, "name"), ""), name) == 0)
            return level_field(property, "value");
    }
    return NULL;
}

const cJSON *level_property(const level_chain *chain, const char *name) {
    for (int i = chain->count - 1; i >= 0; i--) {
        const cJSON *value = level_own_property(chain->links[i], name);
        if (value)
            return value;
    }
    return NULL;
}

/* Reports that a value cannot be used, and sets v->bad. */
static void complain(level_values *v, const char *name, const char *what) {
    v->bad = true;
    level_complain(v, LEVEL_SKIP, "%s %s", name, what);
}

/* Max characters of a number. Chosen, longer than any that is written in practice. */
enum { LONGEST_NUMBER = 60 };

static const char *skip_digits(const char *p) {
    while (*p >= '0' && *p <= '9')
        p++;
    return p;
}

bool level_number_of(const char *text, double *value) {
    const char *whole = text + (*text == '-');
    const char *p = skip_digits(whole);
    if (p == whole)
        return false;
    if (*p == '.') {
        const char *fraction = p + 1;
        p = skip_digits(fraction);
        if (p == fraction)
            return false;
    }
    if (*p == 'e' || *p == 'E') {
        const char *power = p + 1 + (p[1] == '-' || p[1] == '+');
        p = skip_digits(power);
        if (p == power)
            return false;
    }
    if (*p != 0 || p - text > LONGEST_NUMBER)
        return false;
    *value = strtod(text, NULL);
    return true;
}

/* `value`, if it is in range; else `low`, after a report. */
static double in_range(level_values *v, double value, const char *name, double low, double high) {
    if (isfinite(value) && value >= low && value <= high)
        return value;
    complain(v, name, "is out of range");
    return low;
}

/* The number in `value`, if it is one in range; else `low`, after a report. */
static double checked_number(level_values *v, const cJSON *value, const char *name, double low,
                             double high) {
    if (!cJSON_IsNumber(value)) {
        complain(v, name, "is not a number");
        return low;
    }
    return in_range(v, value->valuedouble, name, low, high);
}

double level_number(level_values *v, const char *name, double fallback, double low, double high) {
    const cJSON *value = level_property(v->chain, name);
    double number;
    /* Tiled gives a property the type string unless its author chooses another. */
    if (cJSON_IsString(value) && level_number_of(value->valuestring, &number))
        return in_range(v, number, name, low, high);
    return value ? checked_number(v, value, name, low, high) : fallback;
}

double level_required(level_values *v, const cJSON *json, const char *name, double low,
                      double high) {
    const cJSON *value = level_field(json, name);
    if (!value) {
        complain(v, name, "is missing");
        return low;
    }
    return checked_number(v, value, name, low, high);
}

double level_optional(level_values *v, const cJSON *json, const char *name, double fallback,
                      double low, double high) {
    return level_field(json, name) ? level_required(v, json, name, low, high) : fallback;
}

int level_flag_of(const cJSON *value) {
    const char *text = string_or(value, "");
    return cJSON_IsTrue(value) || strcmp(text, "true") == 0     ? 1
           : cJSON_IsFalse(value) || strcmp(text, "false") == 0 ? 0
                                                                : -1;
}

bool level_flag(level_values *v, const char *name, bool fallback) {
    const cJSON *value = level_property(v->chain, name);
    if (!value)
        return fallback;
    int flag = level_flag_of(value);
    if (flag < 0)
        complain(v, name, "is neither true nor false");
    return flag == 1;
}

const char *level_text(level_values *v, const char *name, const char *fallback) {
    const cJSON *value = level_property(v->chain, name);
    if (!value)
        return fallback;
    if (!cJSON_IsString(value))
        complain(v, name, "is not a text");
    return string_or(value, fallback);
}

/* Whether a property has a meaning for an object that is this joint, or none (LEVEL_NO_JOINT). */
static bool means_something(const char *name, int joint) {
    bool known = level_joint_knows(joint, name);
    for (size_t i = 0; joint < 0 && i < sizeof KNOWN / sizeof KNOWN[0]; i++)
        known = known || strcmp(KNOWN[i], name) == 0;
    return known;
}

void level_note_unknown(level_report *report, const cJSON *json, uint32_t object, const char *where,
                        int joint) {
    const cJSON *property;
    cJSON_ArrayForEach(property, level_field(json, "properties")) {
        const char *name = string_or(level_field(property, "name"), "");
        if (means_something(name, joint))
            continue;
        if (object != 0)
            level_problem_add(report, LEVEL_NOTE, object, "property '%.40s' has no meaning here",
                              name);
        else
            level_problem_add(report, LEVEL_NOTE, LEVEL_NO_OBJECT,
                              "%.60s: property '%.40s' has no meaning here", where, name);
    }
}

/* The kind of body that the property `body` or `bodyType` names; static, after a report, if it is
 * none. */
static scene_body_kind read_kind(level_values *v) {
    const char *kind = level_text(v, "body", level_text(v, "bodyType", "static"));
    if (strcmp(kind, "dynamic") == 0)
        return SCENE_DYNAMIC;
    if (strcmp(kind, "kinematic") == 0)
        return SCENE_KINEMATIC;
    if (strcmp(kind, "static") != 0)
        complain(v, "body", "is none of static, kinematic, dynamic");
    return SCENE_STATIC;
}

double level_whole_number(level_values *v, const char *name, double fallback, double low,
                          double high) {
    double value = level_number(v, name, fallback, low, high);
    if (value != floor(value))
        complain(v, name, "is not a whole number");
    return value;
}

level_physics level_read_physics(level_values *v) {
    /* Beyond this, values computed from it could exceed the range of float. */
    const double huge = 1e9;
    level_physics p;
    p.kind = read_kind(v);
    p.fixed_rotation = level_flag(v, "fixed_rotation", false);
    p.sensor = level_flag(v, "sensor", false);
    p.may_sleep = level_flag(v, "may_sleep", true);
    p.vx = level_number(v, "velocity_x", 0, -huge, huge);
    p.vy = level_number(v, "velocity_y", 0, -huge, huge);
    p.angular_velocity = level_number(v, "angular_velocity", 0, -huge, huge);
    p.gravity_scale = level_number(v, "gravity_scale", 1, -huge, huge);
    p.linear_damping = level_number(v, "linear_damping", 0, 0, huge);
    p.angular_damping = level_number(v, "angular_damping", 0, 0, huge);
    p.material.density = level_number(v, "density", 1, 1e-6, huge);
    p.material.friction = level_number(v, "friction", 0.6, 0, THUD_FRICTION_MAX);
    p.material.restitution = level_number(v, "restitution", 0, 0, 1);
    p.category = (uint32_t)level_whole_number(v, "category", 1, 0, UINT32_MAX);
    p.mask = (uint32_t)level_whole_number(v, "mask", UINT32_MAX, 0, UINT32_MAX);
    p.group = (int32_t)level_whole_number(v, "group", 0, INT32_MIN, INT32_MAX);
    p.approximate = (int)level_whole_number(v, "approximate", 0, 0, THUD_APPROXIMATE_SHAPES_MAX);
    return p;
}

void level_apply_body(const level_physics *p, scene_body *body) {
    body->kind = p->kind;
    body->may_sleep = p->may_sleep;
    body->gravity_scale = p->gravity_scale;
    body->linear_damping = p->linear_damping;
    body->angular_damping = p->angular_damping;
    if (p->kind != SCENE_STATIC) {
        body->vx = p->vx;
        body->vy = p->vy;
        body->angular_velocity = p->angular_velocity;
    }
    if (p->fixed_rotation)
        body->fixed_rotation = true;
}

void level_apply_shape(const level_physics *p, scene_shape *shape) {
    shape->material = p->material;
    shape->sensor = p->sensor;
    shape->category = p->category;
    shape->mask = p->mask;
    shape->group = p->group;
}
