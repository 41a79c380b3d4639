/* scene.c: the growable arrays of a scene. Once memory has run out, scene.failed is set and every
 * function that adds something returns a spare element, so that the code of a scene needs no
 * checks. */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void scene_init(scene *s) {
    *s = (scene){
        .name = "",
        .title = "",
        .about = "",
        .gravity_y = -10,
        .length_scale = 1,
        .camera_height = 20,
        .material = {.density = 1, .friction = 0.6, .restitution = 0},
    };
}

void scene_free(scene *s) {
    free(s->bodies);
    free(s->shapes);
    free(s->points);
    free(s->joints);
    free(s->owned_text);
    scene_init(s);
}

double scene_grid(double x) {
    return floor(x * 65536.0 + 0.5) / 65536.0;
}

/* Makes room for `more` elements after the first `count`. False, with nothing changed, if memory
 * runs out. */
static bool make_room(void **array, int *capacity, int count, int more, size_t element) {
    if (more <= *capacity - count)
        return true;
    int wanted = *capacity < 64 ? 64 : *capacity;
    while (wanted - count < more) {
        if (wanted > (1 << 29))
            return false;
        wanted *= 2;
    }
    void *grown = realloc(*array, (size_t)wanted * element);
    if (!grown)
        return false;
    *array = grown;
    *capacity = wanted;
    return true;
}

scene_body *scene_add_body(scene *s, scene_body_kind kind, double x, double y) {
    scene_body *body = &s->spare_body;
    void *bodies = s->bodies;
    if (!s->failed && make_room(&bodies, &s->body_capacity, s->body_count, 1, sizeof *s->bodies)) {
        s->bodies = bodies;
        body = &s->bodies[s->body_count++];
    } else {
        s->failed = true;
    }
    *body = (scene_body){
        .kind = kind,
        .x = scene_grid(x),
        .y = scene_grid(y),
        .gravity_scale = 1,
        .may_sleep = true,
        .first_shape = s->shape_count,
    };
    return body;
}

/* Adds a shape to the latest body. */
static scene_shape *add_shape(scene *s, scene_shape_kind kind) {
    scene_shape *shape = &s->spare_shape;
    void *shapes = s->shapes;
    if (!s->failed && s->body_count > 0 &&
        make_room(&shapes, &s->shape_capacity, s->shape_count, 1, sizeof *s->shapes)) {
        s->shapes = shapes;
        shape = &s->shapes[s->shape_count++];
        s->bodies[s->body_count - 1].shape_count++;
    } else {
        s->failed = true;
    }
    *shape =
        (scene_shape){.kind = kind, .material = s->material, .category = 1, .mask = UINT32_MAX};
    return shape;
}

scene_shape *scene_add_circle(scene *s, double radius) {
    scene_shape *shape = add_shape(s, SCENE_CIRCLE);
    shape->hx = radius;
    return shape;
}

scene_shape *scene_add_aabb(scene *s, double hx, double hy) {
    scene_shape *shape = add_shape(s, SCENE_AABB);
    shape->hx = hx;
    shape->hy = hy;
    if (!s->failed)
        s->bodies[s->body_count - 1].fixed_rotation = true;
    return shape;
}

scene_shape *scene_add_obb(scene *s, double hx, double hy) {
    scene_shape *shape = add_shape(s, SCENE_OBB);
    shape->hx = hx;
    shape->hy = hy;
    return shape;
}

scene_shape *scene_add_flat(scene *s, double slope) {
    scene_shape *shape = add_shape(s, SCENE_TERRAIN_FLAT);
    shape->slope = slope;
    return shape;
}

/* Adds `count` points to a terrain; the caller fills them. Null, and s->failed is set, if memory
 * runs out. */
static scene_point *add_points(scene *s, scene_shape *shape, int count) {
    void *points = s->points;
    if (s->failed || count < 0 ||
        !make_room(&points, &s->point_capacity, s->point_count, count, sizeof *s->points)) {
        s->failed = true;
        return NULL;
    }
    s->points = points;
    shape->first_point = s->point_count;
    shape->point_count = count;
    s->point_count += count;
    return &s->points[shape->first_point];
}

scene_shape *scene_add_uniform(scene *s, double x0, double spacing, const double *heights,
                               int count) {
    scene_shape *shape = add_shape(s, SCENE_TERRAIN_UNIFORM);
    shape->spacing = spacing;
    scene_point *points = add_points(s, shape, count);
    for (int i = 0; points && i < count; i++)
        points[i] = (scene_point){x0 + i * spacing, heights[i]};
    return shape;
}

scene_shape *scene_add_irregular(scene *s, const scene_point *points, int count) {
    scene_shape *shape = add_shape(s, SCENE_TERRAIN_IRREGULAR);
    scene_point *copy = add_points(s, shape, count);
    if (copy && count > 0)
        memcpy(copy, points, (size_t)count * sizeof *points);
    return shape;
}

scene_body *scene_static_box(scene *s, double x, double y, double hx, double hy) {
    scene_body *body = scene_add_body(s, SCENE_STATIC, x, y);
    scene_add_aabb(s, hx, hy);
    return body;
}

scene_body *scene_dynamic_box(scene *s, double x, double y, double hx, double hy) {
    scene_body *body = scene_add_body(s, SCENE_DYNAMIC, x, y);
    scene_add_obb(s, hx, hy);
    return body;
}

scene_body *scene_dynamic_circle(scene *s, double x, double y, double radius) {
    scene_body *body = scene_add_body(s, SCENE_DYNAMIC, x, y);
    scene_add_circle(s, radius);
    return body;
}

/* Adds a joint with the default values; its frames are set by the caller. */
static scene_joint *add_joint(scene *s, scene_joint_kind kind, int a, int b) {
    scene_joint *joint = &s->spare_joint;
    void *joints = s->joints;
    if (!s->failed &&
        make_room(&joints, &s->joint_capacity, s->joint_count, 1, sizeof *s->joints)) {
        s->joints = joints;
        joint = &s->joints[s->joint_count++];
    } else {
        s->failed = true;
    }
    *joint = (scene_joint){
        .kind = kind,
        .body = {a, b},
        .length = 1,
        .ratio = 1,
        .collide_connected = kind == SCENE_GEAR,
        .break_force = 1e30,
        .break_torque = 1e30,
    };
    for (int i = 0; i < SCENE_DIRECTIONS; i++)
        joint->drive[i] = (scene_drive){.damping = 0.7, .spring_force = 1e30};
    return joint;
}

/* Sets the frame of one side of a joint from a place in the world. The body's angle is taken to be
 * 0. */
static void see(const scene *s, scene_joint *joint, int side, double x, double y, double angle) {
    const scene_body *body = &s->bodies[joint->body[side]];
    joint->x[side] = scene_grid(x) - body->x;
    joint->y[side] = scene_grid(y) - body->y;
    joint->angle[side] = angle;
}

scene_joint *scene_tie(scene *s, scene_joint_kind kind, int a, int b, double x, double y,
                       double angle) {
    scene_joint *joint = add_joint(s, kind, a, b);
    if (!s->failed) {
        see(s, joint, 0, x, y, angle);
        see(s, joint, 1, x, y, angle);
    }
    return joint;
}

scene_joint *scene_tie_distance(scene *s, int a, int b, double ax, double ay, double bx,
                                double by) {
    scene_joint *joint = add_joint(s, SCENE_DISTANCE, a, b);
    if (!s->failed) {
        see(s, joint, 0, ax, ay, 0);
        see(s, joint, 1, bx, by, 0);
        double dx = scene_grid(bx) - scene_grid(ax), dy = scene_grid(by) - scene_grid(ay);
        joint->length = sqrt(dx * dx + dy * dy);
    }
    return joint;
}

scene_joint *scene_tie_gear(scene *s, int first, int second, double ratio) {
    scene_joint *joint = add_joint(s, SCENE_GEAR, first, second);
    joint->ratio = ratio;
    return joint;
}

void scene_add_blast(scene *s, scene_blast blast) {
    if (s->fields.blast_count < SCENE_BLASTS_MAX)
        s->fields.blasts[s->fields.blast_count++] = blast;
    else
        s->failed = true;
}

scene_rule *scene_add_rule(scene *s, uint32_t first, uint32_t second, scene_rule_kind meeting) {
    scene_rule *rule = &s->spare_rule;
    if (s->fields.rule_count < SCENE_RULES_MAX)
        rule = &s->fields.rules[s->fields.rule_count++];
    else
        s->failed = true;
    *rule = (scene_rule){.first = first,
                         .second = second,
                         .kind = meeting,
                         .friction = NAN,
                         .restitution = NAN,
                         .surface_speed = NAN,
                         .event_impulse = INFINITY};
    return rule;
}

bool scene_has_fields(const scene *s) {
    const scene_fields *f = &s->fields;
    return f->water_density > 0 || f->air_density > 0 || f->blast_count > 0 || f->rule_count > 0;
}

size_t scene_shown(const scene *s, char *out) {
    return (size_t)snprintf(out, SCENE_SHOWN_MAX,
                            "{\"view\": {\"x\": %.17g, \"y\": %.17g, \"height\": %.17g, \"width\": "
                            "%.17g}, \"lengthScale\": %.17g}",
                            s->camera_x, s->camera_y, s->camera_height, s->camera_width,
                            s->length_scale);
}

void scene_shift(scene *s, double dx, double dy) {
    for (int i = 0; i < s->body_count; i++) {
        s->bodies[i].x += dx;
        s->bodies[i].y += dy;
    }
    for (int i = 0; i < s->fields.blast_count; i++) {
        s->fields.blasts[i].x += dx;
        s->fields.blasts[i].y += dy;
    }
    s->fields.water_level += dy;
    s->fields.wind_origin += dx;
    s->camera_x += dx;
    s->camera_y += dy;
    s->spawn_x += dx;
    s->spawn_y += dy;
}
