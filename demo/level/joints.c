/* joints.c: reads the objects that are joints: their kind, place, limits, springs and motors. tie.c
 * finds the bodies that they join after the whole map is read. */
#include "reader.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Max of lengths, of a frame's coordinates (length scales) and of motor speeds (length scales or
 * radians a second): the engine's 1e6 (THUD_JOINT_LENGTH_MAX, THUD_JOINT_ANGULAR_SPEED_MAX), with a
 * margin for rounding to float. SHORTEST: min length of a distance, length scales. The others are
 * THUD_JOINT_ANGLE_MAX, radians, and THUD_JOINT_FORCE_MAX. */
static const double LONGEST = 999999;
static const double SHORTEST = 1e-6;
static const double LARGEST_TURN = 3.1415927;
static const double LARGEST_FORCE = 1e30;

enum { ALONG = 1 << SCENE_ALONG, ACROSS = 1 << SCENE_ACROSS, TURN = 1 << SCENE_TURN };

/* For each kind its name, the directions that have limits, springs and motors, and whether it needs
 * both `a` and `b`. */
static const struct {
    const char *name;
    unsigned driven;
    bool needs_a;
} KINDS[] = {
    [SCENE_DISTANCE] = {"distance", ALONG, false},
    [SCENE_HINGE] = {"hinge", TURN, false},
    [SCENE_SLIDER] = {"slider", ALONG, false},
    [SCENE_WELD] = {"weld", ALONG | ACROSS | TURN, false},
    [SCENE_WHEEL] = {"wheel", ALONG | TURN, false},
    [SCENE_TARGET] = {"target", ALONG | ACROSS | TURN, false},
    [SCENE_FILTER] = {"filter", 0, true},
    [SCENE_GEAR] = {"gear", 0, true},
};
enum { KIND_COUNT = sizeof KINDS / sizeof KINDS[0] };

static const char *const DIRECTIONS[SCENE_DIRECTIONS] = {"along", "across", "turn"};
static const char *const FIELDS[] = {"lower",  "upper",        "frequency",   "damping",
                                     "target", "spring_force", "motor_speed", "motor_force"};

bool level_joint_fits(const level_reader *r, double length) {
    return fabs(length) <= LONGEST * r->unit;
}

const char *level_joint_name(scene_joint_kind kind) {
    return KINDS[kind].name;
}

int level_joint_kind(const char *name) {
    for (int i = 0; i < KIND_COUNT; i++)
        if (strcmp(KINDS[i].name, name) == 0)
            return i;
    return LEVEL_NO_JOINT;
}

/* Whether a kind of joint has limits, springs and motors in a direction. */
static bool drives(int kind, int direction) {
    return kind == LEVEL_ANY_JOINT || KINDS[kind].driven >> direction & 1;
}

bool level_joint_knows(int kind, const char *name) {
    if (kind == LEVEL_NO_JOINT)
        return false;
    if (strcmp(name, "a") == 0 || strcmp(name, "b") == 0)
        return true;
    if (strcmp(name, "length") == 0)
        return kind == SCENE_DISTANCE || kind == LEVEL_ANY_JOINT;
    if (strcmp(name, "ratio") == 0)
        return kind == SCENE_GEAR || kind == LEVEL_ANY_JOINT;
    if (strcmp(name, "break_force") == 0 || strcmp(name, "break_torque") == 0 ||
        strcmp(name, "collide_connected") == 0)
        return kind != SCENE_FILTER;
    for (int i = 0; i < SCENE_DIRECTIONS; i++) {
        size_t length = strlen(DIRECTIONS[i]);
        if (!drives(kind, i) || strncmp(name, DIRECTIONS[i], length) != 0 || name[length] != '_')
            continue;
        for (size_t k = 0; k < sizeof FIELDS / sizeof FIELDS[0]; k++)
            if (strcmp(name + length + 1, FIELDS[k]) == 0)
                return true;
    }
    return false;
}

/* ---- places ---- */

/* Whether an object is drawn in a way that a joint can be: as no tile or polygon, and, if as a
 * line, with two points. */
static bool is_drawn_fit(const cJSON *object) {
    const cJSON *line = level_field(object, "polyline");
    return !level_field(object, "gid") && !level_field(object, "polygon") &&
           (!line || (cJSON_IsArray(line) && cJSON_GetArraySize(line) == 2));
}

/* Reads a line. A distance goes from its first to its last point; any other joint is at the first
 * point, with its axis along the line. */
static void read_line(level_values *v, const cJSON *line, level_joint *o) {
    double c, s, x[2], y[2];
    level_turn(o->rotation, &c, &s);
    for (int i = 0; i < 2; i++) {
        const cJSON *point = cJSON_GetArrayItem(line, i);
        double px = level_required(v, point, "x", -LEVEL_FAR, LEVEL_FAR);
        double py = level_required(v, point, "y", -LEVEL_FAR, LEVEL_FAR);
        x[i] = c * px - s * py;
        y[i] = s * px + c * py;
    }
    double dx = x[1] - x[0], dy = y[1] - y[0];
    int last = o->joint.kind == SCENE_DISTANCE ? 1 : 0;
    o->x[1] = o->x[0] + x[last];
    o->y[1] = o->y[0] + y[last];
    o->x[0] += x[0];
    o->y[0] += y[0];
    o->rotation = dx * dx + dy * dy > 0 ? level_direction(dx, dy) : 0;
}

/* Reads the places of a joint on both bodies, and the rotation of its axis. */
static void read_place(level_values *v, const cJSON *object, level_joint *o) {
    const cJSON *line = level_field(object, "polyline");
    if (line) {
        read_line(v, line, o);
        return;
    }
    double hx = 0.5 * level_optional(v, object, "width", 0, 0, LEVEL_FAR);
    double hy = 0.5 * level_optional(v, object, "height", 0, 0, LEVEL_FAR);
    double c, s, x = o->x[0], y = o->y[0];
    level_turn(o->rotation, &c, &s);
    o->x[0] = o->x[1] = x + (c * hx - s * hy);
    o->y[0] = o->y[1] = y + (s * hx + c * hy);
    if (o->joint.kind == SCENE_WHEEL) /* the suspension's axis points up, where the rotation is 0 */
        o->rotation = o->rotation - 90;
}

scene_point level_joint_place(const level_reader *r, const level_joint *o, int side) {
    return (scene_point){scene_grid(o->x[side] / r->pixels_per_unit),
                         scene_grid((r->map_height - o->y[side]) / r->pixels_per_unit)};
}

/* The distance between the two places of a joint, in units. */
static double length_as_drawn(const level_reader *r, const level_joint *o) {
    scene_point from = level_joint_place(r, o, 0), to = level_joint_place(r, o, 1);
    double dx = to.x - from.x, dy = to.y - from.y;
    return sqrt(dx * dx + dy * dy);
}

/* ---- limits, springs and motors ---- */

/* Room for the name of a property. */
enum { NAME = 32 };

/* Writes the name of a property, as "turn_motor_speed". */
static const char *name_of(char *name, int direction, const char *field) {
    snprintf(name, NAME, "%s_%s", DIRECTIONS[direction], field);
    return name;
}

static bool is_set(const level_values *v, int direction, const char *field) {
    char name[NAME];
    return level_property(v->chain, name_of(name, direction, field)) != NULL;
}

/* Reads a number of one direction. */
static double number(level_values *v, int direction, const char *field, double fallback, double low,
                     double high) {
    char name[NAME];
    return level_number(v, name_of(name, direction, field), fallback, low, high);
}

/* Reads limits, spring and motor of one direction. */
static void read_drive(const level_reader *r, level_values *v, scene_joint *joint, int direction) {
    scene_drive *d = &joint->drive[direction];
    bool distance = joint->kind == SCENE_DISTANCE;
    double fastest = direction == SCENE_TURN ? LONGEST : LONGEST * r->unit;
    double most = direction == SCENE_TURN ? LARGEST_TURN : LONGEST * r->unit;
    double least = distance ? 0 : -most;
    d->limited = is_set(v, direction, "lower") || is_set(v, direction, "upper");
    if (d->limited) {
        d->lower = number(v, direction, "lower", least, least, most);
        d->upper = number(v, direction, "upper", distance ? joint->length : most, least, most);
    }
    d->frequency = number(v, direction, "frequency", 0, 0, 1e4);
    d->damping = number(v, direction, "damping", 0.7, 0, 1e3);
    d->target = number(v, direction, "target", distance ? joint->length : 0, least, most);
    d->spring_force = number(v, direction, "spring_force", LARGEST_FORCE, 0, LARGEST_FORCE);
    d->motor_speed = number(v, direction, "motor_speed", 0, -fastest, fastest);
    d->motor_force = number(v, direction, "motor_force", 0, 0, LARGEST_FORCE);
    if (!v->bad && d->lower > d->upper) {
        v->bad = true;
        level_complain(v, LEVEL_SKIP, "%s_lower is larger than %s_upper", DIRECTIONS[direction],
                       DIRECTIONS[direction]);
    }
}

/* Reads the other values of a joint, and its directions. */
static void read_values(const level_reader *r, level_values *v, level_joint *o) {
    scene_joint *joint = &o->joint;
    scene_joint_kind kind = joint->kind;
    if (kind == SCENE_DISTANCE)
        joint->length =
            level_number(v, "length", length_as_drawn(r, o), SHORTEST * r->unit, LONGEST * r->unit);
    joint->ratio = 1;
    if (kind == SCENE_GEAR) {
        joint->ratio = level_number(v, "ratio", 1, -1e4, 1e4);
        if (fabs(joint->ratio) < 1e-4) {
            v->bad = true;
            level_complain(v, LEVEL_SKIP, "ratio is too near to 0");
        }
    }
    joint->collide_connected = level_flag(v, "collide_connected", kind == SCENE_GEAR);
    joint->break_force = level_number(v, "break_force", LARGEST_FORCE, 0, LARGEST_FORCE);
    joint->break_torque = level_number(v, "break_torque", LARGEST_FORCE, 0, LARGEST_FORCE);
    for (int i = 0; i < SCENE_DIRECTIONS; i++) {
        joint->drive[i] = (scene_drive){.damping = 0.7, .spring_force = LARGEST_FORCE};
        if (drives((int)kind, i))
            read_drive(r, v, joint, i);
    }
}

/* ---- reading ---- */

/* Appends a joint to those of the map. */
static void keep(level_reader *r, const level_joint *o) {
    if (r->joint_count == r->joint_capacity) {
        int wanted = r->joint_capacity ? 2 * r->joint_capacity : 16;
        level_joint *grown = realloc(r->joints, (size_t)wanted * sizeof *grown);
        if (!grown) {
            r->s->failed = true;
            return;
        }
        r->joints = grown;
        r->joint_capacity = wanted;
    }
    r->joints[r->joint_count++] = *o;
}

void level_read_joint(level_reader *r, level_values *v, const cJSON *object, int kind, double x,
                      double y, double degrees) {
    level_joint o = {.joint = {.kind = (scene_joint_kind)kind}, .id = v->object};
    o.x[0] = x;
    o.y[0] = y;
    o.rotation = degrees;
    if (!is_drawn_fit(object)) {
        level_complain(v, LEVEL_SKIP,
                       "a joint is drawn as a point, a rectangle, an ellipse or a line of two "
                       "points");
        return;
    }
    if (kind == SCENE_DISTANCE && !level_field(object, "polyline")) {
        level_complain(v, LEVEL_SKIP, "a distance is drawn as a line of two points");
        return;
    }
    read_place(v, object, &o);
    if (v->bad)
        return;
    o.a = (uint32_t)level_whole_number(v, "a", 0, 0, UINT32_MAX);
    o.b = (uint32_t)level_whole_number(v, "b", 0, 0, UINT32_MAX);
    read_values(r, v, &o);
    if (o.joint.kind == SCENE_DISTANCE && !v->bad && o.joint.length < SHORTEST * r->unit) {
        v->bad = true;
        level_complain(v, LEVEL_SKIP, "its line is too short, and no length is given");
    }
    if (o.joint.kind == SCENE_DISTANCE && !v->bad && o.joint.length > LONGEST * r->unit) {
        v->bad = true;
        level_complain(v, LEVEL_SKIP, "its line is too long, and no length is given");
    }
    if (!v->bad && (o.b == 0 || (o.a == 0 && KINDS[kind].needs_a))) {
        v->bad = true;
        level_complain(v, LEVEL_SKIP, "a %s needs %s", KINDS[kind].name,
                       KINDS[kind].needs_a ? "both a and b" : "b, the body that it holds");
    }
    if (!v->bad && o.a == o.b) {
        v->bad = true;
        level_complain(v, LEVEL_SKIP, "a and b are the same object");
    }
    if (!v->bad)
        keep(r, &o);
}
