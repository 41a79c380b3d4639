/* limits_place.h: the world in which limits are tested, with an object of every kind in it. */
#ifndef LIMITS_PLACE_H
#define LIMITS_PLACE_H

#include "engine_support.h"

#include <thud/thud_approximate.h>
#include <thud/thud_capsule.h>
#include <thud/thud_casts.h>
#include <thud/thud_edits.h>
#include <thud/thud_fields.h>
#include <thud/thud_joint.h>
#include <thud/thud_minkowski.h>
#include <thud/thud_mover.h>
#include <thud/thud_rollback.h>
#include <thud/thud_terrain.h>
#include <thud/thud_volumes.h>

#include <stdio.h>

/* A world, created anew for each test of a value, and the inputs and outputs of its calls. */
typedef struct place {
    double scale; /* the length scale, a power of two */
    thud_world *world;
    thud_body_id ball, stone, slab, lift, ground;
    thud_shape_id round, flat, line;
    thud_shape_def shape;
    thud_mover mover;
    thud_geometry box;
    thud_motion rest;
    thud_contact_settings *settings; /* written by the prologue; null: none */
    thud_result heard;
    char message[256]; /* the last log message */
    thud_contacts contacts;
    thud_minkowski sum;
    thud_volume volume;
    thud_vec2 out;
    double x, y, z;
    bool hit;
} place;

/* The log hook: stores result and message. */
static void hear(thud_result result, const char *message, void *context) {
    place *p = context;
    p->heard = result;
    snprintf(p->message, sizeof p->message, "%s", message);
}

/* The prologue: writes p->settings into the contact's settings. */
static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                void *context) {
    (void)world, (void)contact;
    place *p = context;
    if (p->settings) {
        *settings = *p->settings;
    }
    return true;
}

static double no_time(void *context) {
    (void)context;
    return 0.0;
}

static void each(thud_task_fn *task, void *argument, int workers, void *context) {
    (void)context;
    for (int i = 0; i < workers; i++) {
        task(argument);
    }
}

static thud_world_def def_of(place *p) {
    thud_world_def def = thud_default_world_def();
    def.length_scale = (float)p->scale;
    def.log = hear;
    def.log_context = p;
    return def;
}

static thud_body_id body_of(place *p, thud_body_kind kind, double x) {
    thud_body_def def = thud_default_body_def();
    thud_body_id body;
    def.kind = kind;
    def.position = (thud_pos){x * p->scale, 0};
    OK(thud_body_create(p->world, &def, &body));
    return body;
}

static void place_make(place *p, double scale) {
    static const thud_pos heights[] = {{0, -20}, {0, -20}, {0, -20}};
    thud_terrain line = {THUD_TERRAIN_UNIFORM, 0, -4, 4, heights, 3};
    *p = (place){.scale = scale, .shape = thud_default_shape_def()};
    thud_world_def def = def_of(p);
    OK(thud_world_create(&def, &p->world));
    set_listeners(p->world, ask, NULL, p);
    p->ball = body_of(p, THUD_BODY_DYNAMIC, 0);
    p->stone = body_of(p, THUD_BODY_DYNAMIC, 50);
    p->slab = body_of(p, THUD_BODY_STATIC, 1);
    p->lift = body_of(p, THUD_BODY_KINEMATIC, 100);
    p->ground = body_of(p, THUD_BODY_STATIC, 0);
    float half = (float)scale;
    OK(thud_shape_create_circle(p->world, p->ball, &p->shape, (thud_vec2){0, 0}, half, &p->round));
    OK(thud_shape_create_aabb(p->world, p->slab, &p->shape, (thud_vec2){0, 0},
                              (thud_vec2){half, half}, &p->flat));
    OK(thud_shape_create_terrain(p->world, p->ground, &p->shape, &line, &p->line));
    p->box = (thud_geometry){THUD_SHAPE_AABB, 0, 0, 1, 0, 1, 1};
    p->mover = thud_default_mover(p->box);
    OK(thud_minkowski_sum(&p->box, &p->box, &p->sum));
}

#endif
