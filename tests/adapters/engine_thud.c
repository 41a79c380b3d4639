/* engine_thud.c: thud, by the interface of engine.h. */
#include "act_thud.h"
#include "build_thud.h"
#include "engine.h"
#include "misuse_thud.h"

#include <thud/thud_testing.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct own_world {
    thud_world *world;
    scene_fields fields;
    int body_count;
    thud_body_id bodies[];
} own_world;

static void print_log(thud_result result, const char *message, void *context) {
    (void)context;
    fprintf(stderr, "thud: %s (%s)\n", message, thud_result_text(result));
}

static void *create(const scene *s, const engine_settings *settings) {
    own_world *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    if (!own)
        return NULL;
    thud_world_def def = thud_default_world_def();
    if (settings->quality)
        def.quality = settings->quality;
    def.detection = settings->detection;
    def.time_step = settings->time_step;
    def.sleeping = settings->sleeping;
    thud_world_def_set_baseline_simd(&def, settings->baseline_simd);
    def.log = print_log;
    if (scene_build_thud(s, &def, &own->world, own->bodies, NULL) != THUD_OK) {
        free(own);
        return NULL;
    }
    own->body_count = s->body_count;
    own->fields = s->fields;
    return own;
}

static void destroy(void *state) {
    own_world *own = state;
    if (own)
        thud_world_destroy(own->world);
    free(own);
}

static bool step(void *state) {
    own_world *own = state;
    return scene_step_thud(&own->fields, own->world) == THUD_OK;
}

/* A quarantined body counts as lost. */
static void read_bodies(void *state, engine_body *bodies) {
    own_world *own = state;
    for (int i = 0; i < own->body_count; i++) {
        thud_body_state body;
        if (thud_body_get_state(own->world, own->bodies[i], &body) != THUD_OK || body.quarantined) {
            bodies[i] = (engine_body){.x = NAN, .y = NAN};
            continue;
        }
        bodies[i] = (engine_body){
            .x = body.position.x,
            .y = body.position.y,
            .cosine = body.cosine,
            .sine = body.sine,
            .vx = body.velocity.x,
            .vy = body.velocity.y,
            .angular_velocity = body.angular_velocity,
            .mass = body.mass,
            .inertia = body.inertia,
            .awake = body.awake,
        };
    }
}

static uint64_t bytes(void *state) {
    own_world *own = state;
    return thud_stats_of(own->world).bytes;
}

static engine_events events(void *state) {
    own_world *own = state;
    thud_events e = thud_events_of(own->world);
    return (engine_events){e.begin_count, e.end_count, e.hit_count, e.sensor_begin_count,
                           e.sensor_end_count};
}

static uint64_t allocations(void *state) {
    own_world *own = state;
    return thud_stats_of(own->world).step_allocations;
}

static bool set_time_step(void *state, double seconds) {
    own_world *own = state;
    return thud_world_set_time_step(own->world, seconds) == THUD_OK;
}

static void read_pose(void *state, int body, double x, double y, float out[4]) {
    own_world *own = state;
    int count;
    const thud_pose *poses = thud_poses_of(own->world, (thud_pos){x, y}, 1, &count);
    uint32_t slot = own->bodies[body].index1 - 1;
    thud_pose pose = (thud_pose){NAN, NAN, NAN, NAN};
    if (poses && slot < (uint32_t)count)
        pose = poses[slot];
    out[0] = pose.x, out[1] = pose.y, out[2] = pose.c, out[3] = pose.s;
}

/* Destroys a body and creates a dynamic circle in its place. */
static bool renew(void *state, const scene *s, int body) {
    own_world *own = state;
    const scene_body *from = &s->bodies[body];
    const scene_shape *circle = &s->shapes[from->first_shape];
    thud_body_def def = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){from->x, from->y};
    return thud_body_destroy(own->world, own->bodies[body]) == THUD_OK &&
           thud_body_create(own->world, &def, &own->bodies[body]) == THUD_OK &&
           thud_shape_create_circle(own->world, own->bodies[body], &shape, (thud_vec2){0, 0},
                                    (float)circle->hx, NULL) == THUD_OK;
}

static bool misuse_body(void *state, int body, misuse call, double value) {
    own_world *own = state;
    return misuse_thud(own->world, own->bodies[body], call, value);
}

const physics_engine engine_thud = {
    .name = "thud",
    .create = create,
    .destroy = destroy,
    .step = step,
    .read = read_bodies,
    .bytes = bytes,
    .events = events,
    .allocations = allocations,
    .set_time_step = set_time_step,
    .pose = read_pose,
    .renew = renew,
    .misuse = misuse_body,
};
