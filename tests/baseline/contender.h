/* contender.h: what a comparison asks of a physics engine, so that the benchmark and the tests
 * treat all of them alike. Adding an engine is adding one contender. */
#ifndef THUD_BASELINE_CONTENDER_H
#define THUD_BASELINE_CONTENDER_H

#include "scene.h"

#include <stdbool.h>
#include <stdint.h>

#define CONTENDER_TIME_STEP (1.0 / 60.0)

/* Each engine at its defaults, but for these. */
typedef struct contender_settings {
    bool sleeping;
    bool events; /* also where the engine leaves them out by default */
} contender_settings;

/* One body, read back through the engine's public API; x is NaN if the engine lost it. */
typedef struct contender_body {
    double x, y, cosine, sine; /* of the body's origin */
    double vx, vy;             /* of the centre of mass */
    double angular_velocity;
    double mass, inertia;
    bool awake;
} contender_body;

/* How many events the last step brought. */
typedef struct contender_events {
    int begin, end, hit, sensor_begin, sensor_end;
} contender_events;

typedef struct contender {
    const char *name;
    /* Null when it fails, and a line on stderr says why. The scene must outlive the world. */
    void *(*create)(const scene *s, contender_settings settings);
    void (*destroy)(void *world); /* null is fine */
    bool (*step)(void *world);
    void (*read)(void *world, contender_body *bodies); /* in the scene's order */
    contender_events (*events)(void *world);
    uint64_t (*bytes)(void *world); /* memory held */
} contender;

extern const contender contender_thud, contender_box2d;
extern const contender contender_rapier; /* only where THUD_RAPIER_BUILD is defined */

#endif
