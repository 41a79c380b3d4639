/* trial.h: a trial is one guarantee tested on one combination of settings: helpers that create
 * worlds and bodies by these settings, and the first fault that was found. Lengths are in length
 * scales and speeds in length scales per second, unless said otherwise. */
#ifndef TRIAL_H
#define TRIAL_H

#include "geometry_random.h"
#include "settings.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <thud/thud_listeners.h>

enum { TRIAL_WORLDS = 16 };

typedef struct trial {
    const settings *set;
    source random;
    double scale; /* the caller's length units in a length scale */
    double step;  /* time step, s */
    thud_world *world[TRIAL_WORLDS];
    int worlds;
    int heard; /* how often the log hook was called, and the result of its last call */
    thud_result heard_result;
    char fault[512]; /* text of the first fault; empty if there is none */
} trial;

void trial_begin(trial *t, const settings *set, uint64_t seed);
void trial_end(trial *t); /* destroys its worlds */

/* Stores the text of a fault, unless there is one already. */
__attribute__((format(printf, 2, 3))) void trial_fault(trial *t, const char *format, ...);

static inline bool trial_failed(const trial *t) {
    return t->fault[0] != 0;
}

/* DO expects a call to return THUD_OK; REFUSED expects it to return this result and to call the log
 * hook. */
#define DO(t, call) trial_expect(t, call, THUD_OK, #call)
#define REFUSED(t, call, result) trial_refused(t, call, result, #call)
void trial_expect(trial *t, thud_result got, thud_result wanted, const char *call);
void trial_refused(trial *t, thud_result got, thud_result wanted, const char *call);

/* ---- worlds ---- */

thud_world_def trial_def(trial *t);
thud_world_def trial_weightless(trial *t);
/* Null if the world was refused, which is then the trial's fault. */
thud_world *trial_make(trial *t, thud_world_def def);
/* Does nothing if `world` is null. */
void trial_listen(trial *t, thud_world *world, thud_prologue_fn *prologue,
                  thud_epilogue_fn *epilogue, void *context);
void trial_run(trial *t, thud_world *world, int steps);
/* The number of time steps in these seconds, rounded up. */
int trial_steps(const trial *t, double seconds);

/* How often the worlds of all trials have run a task on the thread pool. */
long trial_shared_runs(void);
/* A job system with this number of workers, on threads that all trials share. */
thud_job_system trial_jobs(int workers);

/* A snapshot of a world; the caller frees the bytes. */
typedef struct trial_bytes {
    char *bytes;
    size_t size;
} trial_bytes;
trial_bytes trial_snapshot(trial *t, const thud_world *world);

/* ---- bodies ---- */

typedef enum form { BALL, UPRIGHT, TURNED, FORMS } form;

typedef struct part {
    thud_body_kind kind;
    form form;
    double x, y, angle, hx, hy; /* a ball's radius is hx */
    double vx, vy, spin;
    const thud_shape_def *shape;     /* null: the default def */
    const thud_detection *detection; /* null: the world's detection */
} part;

/* Creates a body with one shape. Positions are rounded to 2^-20 of the world's internal unit
 * (trial_unit), so that a shift by whole units is exact. */
thud_body_id trial_add(trial *t, thud_world *world, part p);
/* Creates a dynamic ball or box; creates a static box. */
thud_body_id trial_drop(trial *t, thud_world *world, form kind, double x, double y, double hx);
thud_body_id trial_wall(trial *t, thud_world *world, double x, double y, double hx, double hy);
thud_shape_id trial_shape(trial *t, thud_world *world, thud_body_id body); /* its first shape */

/* A position or a velocity of the world, from length scales. */
thud_pos trial_place(const trial *t, double x, double y);
thud_vec2 trial_speed(const trial *t, double x, double y);
/* The world's internal unit of length: the largest power of two that is not above the length scale.
 */
double trial_unit(const trial *t);

/* A body's state, with lengths in length scales and speeds in length scales per second. */
thud_body_state trial_state(trial *t, const thud_world *world, thud_body_id body);

/* A body's only shape as an instance for geometry, in length scales. */
thud_geometry trial_placed(trial *t, const thud_world *world, thud_body_id body);

static inline double trial_draw(trial *t, double low, double high) {
    return draw(&t->random, low, high);
}

static inline int trial_pick(trial *t, int count) {
    return draw_below(&t->random, count);
}

#endif
