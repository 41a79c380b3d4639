/* contender_box2d.c: Box2D v3.2, one thread, 4 substeps as its manual recommends. */
#include "build_box2d.h"
#include "contender.h"
#include "read_box2d.h"

#include <stdio.h>
#include <stdlib.h>

#define SUBSTEPS 4

typedef struct box2d_world {
    b2WorldId id;
    int body_count;
    b2BodyId bodies[];
} box2d_world;

static void *create(const scene *s, contender_settings settings) {
    if (!box2d_can_run())
        return NULL;
    box2d_world *world = calloc(1, sizeof *world + (size_t)s->body_count * sizeof world->bodies[0]);
    box2d_settings own = {.sleeping = settings.sleeping, .events = settings.events};
    if (!world || !scene_build_box2d(s, own, &world->id, world->bodies)) {
        fprintf(stderr, "box2d: scene %s could not be built\n", s->name);
        free(world);
        return NULL;
    }
    world->body_count = s->body_count;
    return world;
}

static void destroy(void *state) {
    box2d_world *world = state;
    if (world)
        b2DestroyWorld(world->id);
    free(world);
}

static bool step(void *state) {
    box2d_world *world = state;
    b2World_Step(world->id, (float)CONTENDER_TIME_STEP, SUBSTEPS);
    return true;
}

static void read_bodies(void *state, contender_body *bodies) {
    box2d_world *world = state;
    read_box2d(world->bodies, world->body_count, bodies);
}

static contender_events events(void *state) {
    box2d_world *world = state;
    b2ContactEvents contact = b2World_GetContactEvents(world->id);
    b2SensorEvents sensor = b2World_GetSensorEvents(world->id);
    return (contender_events){contact.beginCount, contact.endCount, contact.hitCount,
                              sensor.beginCount, sensor.endCount};
}

/* Box2D counts over all its worlds; the comparison never has more than one at a time. */
static uint64_t bytes(void *state) {
    box2d_world *world = state;
    return (uint64_t)b2World_GetCounters(world->id).byteCount;
}

const contender contender_box2d = {
    .name = "box2d",
    .create = create,
    .destroy = destroy,
    .step = step,
    .read = read_bodies,
    .events = events,
    .bytes = bytes,
};
