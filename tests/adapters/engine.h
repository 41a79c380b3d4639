/* engine.h: what a comparison asks of a physics engine, so that the tests, the benchmark, the
 * trade-off and the envelope treat all of them alike. A new engine is a file engine_NAME.c and a
 * line in engines.c. */
#ifndef THUD_ADAPTERS_ENGINE_H
#define THUD_ADAPTERS_ENGINE_H

#include "misuse.h"
#include "scene.h"

#include <stdbool.h>
#include <stdint.h>
#include <thud/thud_detection.h>
#include <thud/thud_quality.h>

#define ENGINE_TIME_STEP (1.0 / 60.0)

/* Each engine at its defaults, on one thread, but for these. An engine heeds what names it, and
 * what names none. */
typedef struct engine_settings {
    double time_step; /* s; 0: ENGINE_TIME_STEP */
    bool sleeping;
    bool events;                     /* also where the engine leaves them out by default */
    const thud_quality *quality;     /* thud; null: the default one */
    const thud_detection *detection; /* thud; null: the quality's */
    bool baseline_simd;              /* thud: never takes AVX2, the same bits */
    int substeps;                    /* Box2D; 0: 4, as its manual recommends */
    double contact_hertz;            /* Box2D: b2WorldDef.contactHertz; 0: its default */
    double joint_hertz;              /* Box2D: constraintHertz of all joints; 0: its default */
    int iterations;                  /* Chipmunk; 0: 10, its default */
    double joint_damping;            /* Box2D: constraintDampingRatio; 0: its default */
    bool bullets;                    /* Box2D: bodies for which the scene wants swept detection are
                                        bullets, and no speed is cut */
} engine_settings;

/* One body, read back through the engine's public API; x is NaN if the engine lost it. */
typedef struct engine_body {
    double x, y, cosine, sine; /* of the body's origin */
    double vx, vy;             /* of the centre of mass */
    double angular_velocity;
    double mass, inertia;
    bool awake;
} engine_body;

/* How many events the last step brought. */
typedef struct engine_events {
    int begin, end, hit, sensor_begin, sensor_end;
} engine_events;

/* The operations on a world. Those from `events` on are null where an engine has not got them. */
typedef struct physics_engine {
    const char *name;
    bool needs_avx2;                   /* on x86-64: its library was built for it */
    bool only_by_name;                 /* runs where it is asked for by name alone */
    bool (*can_build)(const scene *s); /* whether it has all that is in the scene; null: it has */
    /* For engine_create, which fills in the defaults that have a number here. Null when it fails.
     */
    void *(*create)(const scene *s, const engine_settings *settings);
    void (*destroy)(void *world); /* null is fine */
    bool (*step)(void *world);
    void (*read)(void *world, engine_body *bodies); /* in the scene's order */
    uint64_t (*bytes)(void *world);                 /* memory held */
    engine_events (*events)(void *world);
    uint64_t (*allocations)(void *world); /* memory blocks that the last step asked for */
    bool (*set_time_step)(void *world, double seconds);
    /* The engine's own floats relative to the place: x, y, cosine, sine. */
    void (*pose)(void *world, int body, double x, double y, float out[4]);
    /* Destroys a body of one circle, and makes it anew as the scene has it. */
    bool (*renew)(void *world, const scene *s, int body);
    /* A wrong call, about this body where it is about one. True if the engine says that it is. */
    bool (*misuse)(void *world, int body, misuse call, double value);
} physics_engine;

extern const physics_engine engine_thud;
extern const physics_engine engine_box2d;    /* only where THUD_BOX2D_BUILD is defined */
extern const physics_engine engine_rapier;   /* only where THUD_RAPIER_BUILD is defined */
extern const physics_engine engine_chipmunk; /* only where THUD_CHIPMUNK_BUILD is defined */

/* Those of this build, thud first. */
extern const physics_engine *const BUILT_ENGINES[];
extern const int BUILT_ENGINE_COUNT;

const physics_engine *engine_find(const char *name); /* null if this build has none */

/* Whether the engine has all that is in the scene, such as joints. */
bool engine_can_build(const physics_engine *engine, const scene *s);

/* Null when it fails, and a line on stderr says why. The scene must outlive the world. */
void *engine_create(const physics_engine *engine, const scene *s, engine_settings settings);

#endif
