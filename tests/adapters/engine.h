/* engine.h: the interface to a physics engine, with which tests, benchmark, trade-off and envelope
 * use all engines in the same way. To add an engine, write engine_NAME.c and add a line in
 * engines.c. */
#ifndef THUD_ADAPTERS_ENGINE_H
#define THUD_ADAPTERS_ENGINE_H

#include "misuse.h"
#include "scene.h"

#include <stdbool.h>
#include <stdint.h>
#include <thud/thud_detection.h>
#include <thud/thud_quality.h>

#define ENGINE_TIME_STEP (1.0 / 60.0)

/* Each engine runs with its defaults on one thread, except for these settings. A comment that names
 * an engine means that the others ignore the setting. */
typedef struct engine_settings {
    double time_step; /* s; 0: ENGINE_TIME_STEP */
    bool sleeping;
    bool events;                     /* also if the engine's default is off */
    const thud_quality *quality;     /* thud; null: default */
    const thud_detection *detection; /* thud; null: the quality's */
    bool baseline_simd;              /* thud: uses the baseline instruction set, not AVX2; the same
                                        results */
    int substeps;                    /* Box2D; 0: 4, as its manual recommends */
    double contact_hertz;            /* Box2D: b2WorldDef.contactHertz; 0: its default */
    double joint_hertz;              /* Box2D: constraintHertz of all joints; 0: its default */
    int iterations;                  /* Chipmunk; 0: 10, its default */
    double joint_damping;            /* Box2D: constraintDampingRatio; 0: its default */
    bool bullets;                    /* Box2D: bodies for which the scene asks for swept detection
                                        are bullets, and the maximum speed is raised */
} engine_settings;

/* The state of a body, read through the engine's public API; x is NaN if the body is lost. */
typedef struct engine_body {
    double x, y, cosine, sine; /* of the body's origin */
    double vx, vy;             /* of the centre of mass */
    double angular_velocity;
    double mass, inertia;
    bool awake;
} engine_body;

/* The numbers of events in the last step. */
typedef struct engine_events {
    int begin, end, hit, sensor_begin, sensor_end;
} engine_events;

/* The functions of an engine. Those from `events` on are null if the engine does not support them.
 */
typedef struct physics_engine {
    const char *name;
    bool needs_avx2;   /* on x86-64: the library was built for AVX2 */
    bool only_by_name; /* runs only if it is asked for by name */
    bool (*can_build)(
        const scene *s); /* whether it supports everything in the scene; null: it does */
    /* Called by engine_create, which replaces 0 by the defaults that are numbers here. Null on
     * failure. */
    void *(*create)(const scene *s, const engine_settings *settings);
    void (*destroy)(void *world); /* may be null */
    bool (*step)(void *world);
    void (*read)(void *world, engine_body *bodies); /* writes all bodies in the scene's order */
    uint64_t (*bytes)(void *world);                 /* memory held */
    engine_events (*events)(void *world);
    uint64_t (*allocations)(void *world); /* memory allocations in the last step */
    bool (*set_time_step)(void *world, double seconds);
    /* The engine's own floats x, y, cosine, sine, relative to (x, y). */
    void (*pose)(void *world, int body, double x, double y, float out[4]);
    /* Destroys a body that has one circle and creates it again as in the scene. */
    bool (*renew)(void *world, const scene *s, int body);
    /* Makes an invalid call, on this body if the call concerns a body. True if the engine reports
     * an error. */
    bool (*misuse)(void *world, int body, misuse call, double value);
} physics_engine;

extern const physics_engine engine_thud;
extern const physics_engine engine_box2d;    /* only where THUD_BOX2D_BUILD is defined */
extern const physics_engine engine_rapier;   /* only where THUD_RAPIER_BUILD is defined */
extern const physics_engine engine_chipmunk; /* only where THUD_CHIPMUNK_BUILD is defined */

/* The engines of this build; thud is the first. */
extern const physics_engine *const BUILT_ENGINES[];
extern const int BUILT_ENGINE_COUNT;

const physics_engine *engine_find(const char *name); /* null if this build does not have it */

/* Whether the engine supports everything in the scene, such as joints. */
bool engine_can_build(const physics_engine *engine, const scene *s);

/* Creates a world. Null, with a line on stderr, on failure. The scene must outlive the world. */
void *engine_create(const physics_engine *engine, const scene *s, engine_settings settings);

#endif
