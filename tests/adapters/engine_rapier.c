/* engine_rapier.c: Rapier 2D, by the interface of engine.h, with its defaults: 4 substeps,
 * continuous detection against static shapes. Its events are not read: only speed and overlap are
 * compared.
 *
 * As in Box2D, terrain is a one-sided line whose points go from right to left, and an endless one
 * gets ends. Collision groups by number, which only levels use, are not supported. */
#include "engine.h"
#include "rapier.h"

#include <stdlib.h>

/* m: half the length of the segment that represents an endless line. */
#define FLAT_HALF_WIDTH 4096.0

typedef struct own_world {
    rapier_world *world;
    rapier_state *states;
    int body_count;
} own_world;

static bool add_terrain(rapier_world *world, const scene *s, const scene_shape *shape,
                        const rapier_shape *own) {
    const scene_point ends[2] = {{-FLAT_HALF_WIDTH, -FLAT_HALF_WIDTH * shape->slope},
                                 {FLAT_HALF_WIDTH, FLAT_HALF_WIDTH * shape->slope}};
    bool flat = shape->kind == SCENE_TERRAIN_FLAT;
    const scene_point *points = flat ? ends : s->points + shape->first_point;
    int count = flat ? 2 : shape->point_count;
    float *xy = malloc(2 * (size_t)count * sizeof *xy);
    if (!xy)
        return false;
    for (int i = 0; i < count; i++) {
        xy[2 * i] = (float)points[count - 1 - i].x;
        xy[2 * i + 1] = (float)points[count - 1 - i].y;
    }
    rapier_add_line(world, own, xy, (size_t)count);
    free(xy);
    return true;
}

static bool add_shape(rapier_world *world, const scene *s, const scene_shape *shape) {
    rapier_shape own = {
        .x = (float)shape->x,
        .y = (float)shape->y,
        .angle = shape->kind == SCENE_OBB ? (float)shape->angle : 0,
        .density = (float)shape->material.density,
        .friction = (float)shape->material.friction,
        .restitution = (float)shape->material.restitution,
        .category = shape->category,
        .mask = shape->mask,
        .sensor = shape->sensor,
    };
    switch (shape->kind) {
    case SCENE_CIRCLE:
        rapier_add_circle(world, &own, (float)shape->hx);
        return true;
    case SCENE_AABB:
    case SCENE_OBB:
        rapier_add_box(world, &own, (float)shape->hx, (float)shape->hy);
        return true;
    case SCENE_TERRAIN_FLAT:
    case SCENE_TERRAIN_UNIFORM:
    case SCENE_TERRAIN_IRREGULAR:
        return add_terrain(world, s, shape, &own);
    }
    return false;
}

static bool add_body(rapier_world *world, const scene *s, const scene_body *body, bool sleeping) {
    rapier_body own = {
        .kind = body->kind == SCENE_STATIC      ? 0
                : body->kind == SCENE_KINEMATIC ? 1
                                                : 2,
        .x = (float)body->x,
        .y = (float)body->y,
        .angle = (float)body->angle,
        .vx = (float)body->vx,
        .vy = (float)body->vy,
        .angular_velocity = (float)body->angular_velocity,
        .gravity_scale = (float)body->gravity_scale,
        .linear_damping = (float)body->linear_damping,
        .angular_damping = (float)body->angular_damping,
        .fixed_rotation = body->fixed_rotation,
        .may_sleep = sleeping && body->may_sleep,
    };
    rapier_add_body(world, &own);
    bool ok = true;
    for (int i = 0; ok && i < body->shape_count; i++)
        ok = add_shape(world, s, &s->shapes[body->first_shape + i]);
    return ok;
}

static void destroy(void *state) {
    own_world *own = state;
    if (!own)
        return;
    if (own->world)
        rapier_destroy(own->world);
    free(own->states);
    free(own);
}

static void *create(const scene *s, const engine_settings *settings) {
    own_world *own = calloc(1, sizeof *own);
    bool ok = own != NULL;
    if (ok) {
        own->body_count = s->body_count;
        own->states = calloc((size_t)s->body_count + 1, sizeof *own->states);
        own->world = rapier_create((float)s->gravity_x, (float)s->gravity_y,
                                   (float)settings->time_step, (float)s->length_scale);
        ok = own->states && own->world;
    }
    for (int i = 0; ok && i < s->body_count; i++)
        ok = add_body(own->world, s, &s->bodies[i], settings->sleeping);
    if (ok)
        return own;
    destroy(own);
    return NULL;
}

static bool step(void *state) {
    own_world *own = state;
    rapier_step(own->world);
    return true;
}

static void read_bodies(void *state, engine_body *bodies) {
    own_world *own = state;
    rapier_read(own->world, own->states);
    for (int i = 0; i < own->body_count; i++) {
        const rapier_state *now = &own->states[i];
        bodies[i] = (engine_body){
            .x = now->x,
            .y = now->y,
            .cosine = now->cosine,
            .sine = now->sine,
            .vx = now->vx,
            .vy = now->vy,
            .angular_velocity = now->angular_velocity,
            .mass = now->mass,
            .inertia = now->inertia,
            .awake = now->awake,
        };
    }
}

static uint64_t bytes(void *state) {
    (void)state;
    return rapier_bytes();
}

/* Joints are not translated for Rapier. */
static bool has_no_joints(const scene *s) {
    return s->joint_count == 0;
}

const physics_engine engine_rapier = {
    .name = "rapier",
    .can_build = has_no_joints,
    .needs_avx2 = true,
    .create = create,
    .destroy = destroy,
    .step = step,
    .read = read_bodies,
    .bytes = bytes,
};
