/* build_thud.c: builds a thud world from a scene. A scene's doubles are rounded to the engine's
 * floats here and nowhere else. */
#include "build_thud.h"

#include "act_thud.h"
#include "choices.h"
#include "texture.h"

#include <stdlib.h>
#include <thud/thud_joint.h>

static thud_vec2 vec2(double x, double y) {
    return (thud_vec2){(float)x, (float)y};
}

static thud_body_kind body_kind(scene_body_kind kind) {
    return kind == SCENE_STATIC      ? THUD_BODY_STATIC
           : kind == SCENE_KINEMATIC ? THUD_BODY_KINEMATIC
                                     : THUD_BODY_DYNAMIC;
}

static thud_result add_terrain(thud_world *world, thud_body_id body, const thud_shape_def *def,
                               const scene *s, const scene_shape *shape) {
    thud_terrain terrain = {.slope = shape->slope, .spacing = shape->spacing};
    if (shape->kind == SCENE_TERRAIN_FLAT) {
        terrain.kind = THUD_TERRAIN_FLAT;
        return thud_shape_create_terrain(world, body, def, &terrain, NULL);
    }
    thud_pos *points = malloc((size_t)shape->point_count * sizeof *points + 1);
    if (!points)
        return THUD_ERROR_MEMORY;
    for (int i = 0; i < shape->point_count; i++) {
        const scene_point *p = &s->points[shape->first_point + i];
        points[i] = (thud_pos){p->x, p->y};
    }
    bool uniform = shape->kind == SCENE_TERRAIN_UNIFORM;
    terrain.kind = uniform ? THUD_TERRAIN_UNIFORM : THUD_TERRAIN_IRREGULAR;
    terrain.x0 = uniform && shape->point_count > 0 ? points[0].x : 0;
    terrain.points = points;
    terrain.count = shape->point_count;
    thud_shape_id line;
    thud_result result = thud_shape_create_terrain(world, body, def, &terrain, &line);
    if (result == THUD_OK && shape->texture_row)
        result = texture_weave(world, line, shape->texture_row - 1, terrain.count);
    free(points);
    return result;
}

static thud_result add_shape(thud_world *world, thud_body_id body, const scene *s,
                             const scene_shape *shape) {
    thud_shape_def def = thud_default_shape_def();
    def.density = (float)shape->material.density;
    def.friction = (float)shape->material.friction;
    def.restitution = (float)shape->material.restitution;
    def.sensor = shape->sensor;
    def.filter = (thud_filter){shape->category, shape->mask, shape->group};
    thud_vec2 offset = vec2(shape->x, shape->y);
    thud_vec2 half = vec2(shape->hx, shape->hy);
    switch (shape->kind) {
    case SCENE_CIRCLE:
        return thud_shape_create_circle(world, body, &def, offset, half.x, NULL);
    case SCENE_AABB:
        return thud_shape_create_aabb(world, body, &def, offset, half, NULL);
    case SCENE_OBB:
        return thud_shape_create_obb(world, body, &def, offset, half, shape->angle, NULL);
    case SCENE_TERRAIN_FLAT:
    case SCENE_TERRAIN_UNIFORM:
    case SCENE_TERRAIN_IRREGULAR:
        return add_terrain(world, body, &def, s, shape);
    }
    return THUD_ERROR_INVALID;
}

static thud_result add_body(thud_world *world, const scene *s, const scene_body *body,
                            thud_body_id *out) {
    thud_body_def def = thud_default_body_def();
    def.kind = body_kind(body->kind);
    def.position = (thud_pos){body->x, body->y};
    def.angle = body->angle;
    def.velocity = vec2(body->vx, body->vy);
    def.angular_velocity = (float)body->angular_velocity;
    def.gravity_scale = (float)body->gravity_scale;
    def.linear_damping = (float)body->linear_damping;
    def.angular_damping = (float)body->angular_damping;
    def.fixed_rotation = body->fixed_rotation;
    def.may_sleep = body->may_sleep;
    def.user_data = body->id;
    if (body->detection != SCENE_AS_WORLD)
        def.detection = DETECTIONS[1 + body->detection - SCENE_OVERLAP].detection;
    thud_result result = thud_body_create(world, &def, out);
    for (int i = 0; result == THUD_OK && i < body->shape_count; i++)
        result = add_shape(world, *out, s, &s->shapes[body->first_shape + i]);
    return result;
}

static thud_drive drive_of(const scene_drive *d) {
    return (thud_drive){.limited = d->limited,
                        .lower = (float)d->lower,
                        .upper = (float)d->upper,
                        .frequency = (float)d->frequency,
                        .damping = (float)d->damping,
                        .target = (float)d->target,
                        .spring_force = (float)d->spring_force,
                        .motor_speed = (float)d->motor_speed,
                        .motor_force = (float)d->motor_force};
}

static thud_result add_joint(thud_world *world, const scene_joint *joint,
                             const thud_body_id *bodies, thud_joint_id *joints, int index) {
    thud_joint_def def = thud_default_joint_def((thud_joint_kind)joint->kind);
    for (int side = 0; side < 2; side++) {
        thud_joint_frame *frame = side == 0 ? &def.frame_a : &def.frame_b;
        *frame = (thud_joint_frame){vec2(joint->x[side], joint->y[side]), joint->angle[side]};
        if (joint->kind == SCENE_GEAR)
            def.gear[side] = joints[joint->body[side]];
    }
    if (joint->kind != SCENE_GEAR) {
        def.body_a = bodies[joint->body[0]];
        def.body_b = bodies[joint->body[1]];
    }
    for (int i = 0; i < SCENE_DIRECTIONS; i++)
        def.drive[i] = drive_of(&joint->drive[i]);
    def.length = (float)joint->length;
    def.ratio = (float)joint->ratio;
    def.collide_connected = joint->collide_connected;
    def.break_force = (float)joint->break_force;
    def.break_torque = (float)joint->break_torque;
    return thud_joint_create(world, &def, &joints[index]);
}

/* Creates all joints in the scene's order; a gear refers to joints before it. */
static thud_result add_joints(thud_world *world, const scene *s, const thud_body_id *bodies) {
    thud_joint_id *joints = malloc((size_t)s->joint_count * sizeof *joints);
    if (!joints)
        return THUD_ERROR_MEMORY;
    thud_result result = THUD_OK;
    for (int i = 0; result == THUD_OK && i < s->joint_count; i++)
        result = add_joint(world, &s->joints[i], bodies, joints, i);
    free(joints);
    return result;
}

thud_result scene_build_thud(const scene *s, const thud_world_def *settings, thud_world **out,
                             thud_body_id *bodies, int *failed_body) {
    *out = NULL;
    if (failed_body)
        *failed_body = -1;
    if (s->failed)
        return THUD_ERROR_MEMORY;
    thud_world_def def = settings ? *settings : thud_default_world_def();
    def.gravity = vec2(s->gravity_x, s->gravity_y);
    def.length_scale = (float)s->length_scale;
    thud_body_id *ids = malloc((size_t)s->body_count * sizeof *ids + 1);
    if (!ids)
        return THUD_ERROR_MEMORY;
    thud_world *world = NULL;
    thud_result result = thud_world_create(&def, &world);
    for (int i = 0; result == THUD_OK && i < s->body_count; i++) {
        result = add_body(world, s, &s->bodies[i], &ids[i]);
        if (result != THUD_OK && failed_body)
            *failed_body = i;
        if (result == THUD_OK && bodies)
            bodies[i] = ids[i];
    }
    if (result == THUD_OK && s->joint_count > 0)
        result = add_joints(world, s, ids);
    if (result == THUD_OK)
        result = scene_rule_thud(&s->fields, world);
    free(ids);
    if (result != THUD_OK) {
        thud_world_destroy(world);
        return result;
    }
    *out = world;
    return THUD_OK;
}
