/* without.c: see without.h. */
#include "without.h"

#include <math.h>
#include <string.h>

static const char *const NAMES[WITHOUT_PARTS] = {"obbs",   "turning", "friction", "bounce",
                                                 "sleep",  "direct",  "joints",   "sensors",
                                                 "fields", "rules",   "events"};

const char *without_name(int index) {
    return index >= 0 && index < WITHOUT_PARTS ? NAMES[index] : "";
}

unsigned without_find(const char *names) {
    unsigned found = 0;
    for (const char *name = names; *name;) {
        size_t length = strcspn(name, ",");
        int i = 0;
        while (i < WITHOUT_PARTS &&
               (strlen(NAMES[i]) != length || strncmp(NAMES[i], name, length) != 0))
            i++;
        if (i == WITHOUT_PARTS)
            return 0;
        found |= 1u << i;
        name += length + (name[length] == ',');
    }
    return found;
}

/* Whether each oriented box of a body is upright, so that it may be an AABB. */
static bool is_upright(const scene *s, const scene_body *body) {
    bool upright = body->angle == 0 && body->angular_velocity == 0;
    for (int i = 0; i < body->shape_count; i++) {
        const scene_shape *shape = &s->shapes[body->first_shape + i];
        upright &= shape->kind != SCENE_OBB || shape->angle == 0;
    }
    return upright;
}

/* Whether the scene has oriented boxes, and all of them can be AABBs: only then a program can do
 * without them. */
static bool can_be_aabbs(const scene *s) {
    bool any = false;
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *body = &s->bodies[i];
        for (int k = 0; k < body->shape_count; k++)
            if (s->shapes[body->first_shape + k].kind == SCENE_OBB) {
                any = true;
                if (!is_upright(s, body))
                    return false;
            }
    }
    return any;
}

static void change_boxes(scene *s) {
    for (int i = 0; i < s->body_count; i++) {
        scene_body *body = &s->bodies[i];
        for (int k = 0; k < body->shape_count; k++) {
            scene_shape *shape = &s->shapes[body->first_shape + k];
            if (shape->kind == SCENE_OBB) {
                shape->kind = SCENE_AABB;
                body->fixed_rotation = true;
            }
        }
    }
}

/* Removes all sensors, and closes the gaps that they leave. */
static void remove_sensors(scene *s) {
    int kept = 0;
    for (int i = 0; i < s->body_count; i++) {
        scene_body *body = &s->bodies[i];
        int first = kept;
        for (int k = 0; k < body->shape_count; k++)
            if (!s->shapes[body->first_shape + k].sensor)
                s->shapes[kept++] = s->shapes[body->first_shape + k];
        body->first_shape = first;
        body->shape_count = kept - first;
    }
    s->shape_count = kept;
}

static void remove_fields(scene_fields *fields) {
    fields->water_density = fields->air_density = 0;
    fields->blast_count = 0;
}

void without_change_scene(scene *s, unsigned parts) {
    if (parts & WITHOUT_OBBS && can_be_aabbs(s))
        change_boxes(s);
    if (parts & WITHOUT_TURNING)
        for (int i = 0; i < s->body_count; i++)
            if (s->bodies[i].kind == SCENE_DYNAMIC) {
                s->bodies[i].fixed_rotation = true;
                s->bodies[i].angular_velocity = 0;
            }
    for (int i = 0; i < s->shape_count; i++) {
        scene_material *material = &s->shapes[i].material;
        material->friction = parts & WITHOUT_FRICTION ? 0 : material->friction;
        material->restitution = parts & WITHOUT_BOUNCE ? 0 : material->restitution;
    }
    for (int i = 0; i < s->fields.rule_count; i++) {
        scene_rule *rule = &s->fields.rules[i];
        rule->friction = parts & WITHOUT_FRICTION ? 0 : rule->friction;
        rule->restitution = parts & WITHOUT_BOUNCE ? 0 : rule->restitution;
    }
    if (parts & WITHOUT_JOINTS)
        s->joint_count = 0;
    if (parts & WITHOUT_SENSORS)
        remove_sensors(s);
    if (parts & WITHOUT_FIELDS)
        remove_fields(&s->fields);
    if (parts & WITHOUT_RULES) {
        s->fields.rule_count = 0;
        s->fields.breaks = 0;
    }
}

void without_change_world(thud_world_def *def, thud_quality *quality, unsigned parts) {
    if (parts & WITHOUT_SLEEP)
        def->sleeping = false;
    if (parts & WITHOUT_EVENTS)
        def->contact_events = false;
    if (parts & WITHOUT_DIRECT) {
        *quality = *def->quality;
        quality->islands = NULL;
        quality->island_limit = 1;
        def->quality = quality;
    }
}

unsigned without_possible(const scene *s) {
    unsigned parts = WITHOUT_SLEEP | WITHOUT_DIRECT | WITHOUT_EVENTS;
    bool turns = false;
    for (int i = 0; i < s->body_count; i++)
        turns |= s->bodies[i].kind == SCENE_DYNAMIC && !s->bodies[i].fixed_rotation;
    parts |= turns ? WITHOUT_TURNING : 0;
    parts |= can_be_aabbs(s) ? WITHOUT_OBBS : 0;
    for (int i = 0; i < s->shape_count; i++) {
        const scene_shape *shape = &s->shapes[i];
        parts |= shape->material.friction > 0 ? WITHOUT_FRICTION : 0;
        parts |= shape->material.restitution > 0 ? WITHOUT_BOUNCE : 0;
        parts |= shape->sensor ? WITHOUT_SENSORS : 0;
    }
    parts |= s->joint_count > 0 ? WITHOUT_JOINTS : 0;
    parts |= s->fields.rule_count > 0 ? WITHOUT_RULES : 0;
    bool fields =
        s->fields.water_density > 0 || s->fields.air_density > 0 || s->fields.blast_count > 0;
    return parts | (fields ? WITHOUT_FIELDS : 0);
}
