/* thud_hooks.h: what a world asks of its caller: memory, threads, a clock, and somebody to hear
 * what went wrong. No hook (allocator, log, clock, job system) calls any function of its world. */
#ifndef THUD_HOOKS_H
#define THUD_HOOKS_H

#include "thud_limits.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- memory ---- */

typedef struct thud_allocator {
    void *(*allocate)(size_t bytes, void *context); /* 64-byte aligned, or null */
    void (*release)(void *block, size_t bytes, void *context);
    void *context;
} thud_allocator; /* all zero: the C library's; one function without the other is refused */

/* ---- log and clock ---- */

/* Hears why a call was refused; with THUD_OK, that one was done which is hardly meant. Where one
 * number is at fault the message names it, and tells the number and its range: "shape def: friction
 * is -1, not in [0, 1000000]". It is valid during the call. */
typedef void thud_log_fn(thud_result result, const char *message, void *context);
/* One line to the C library's stderr. A program that does not name it does not link that, but where
 * thud itself is built without NDEBUG: defs then have it as their log. */
THUD_API void thud_log_to_stderr(thud_result result, const char *message, void *context);
typedef double thud_clock_fn(void *context); /* seconds, from any start, never backwards */

/* ---- threads: the engine starts none itself, it asks the caller's own job system or thread pool.
 * Any number of workers gives the same bits ---- */

typedef void thud_task_fn(void *argument);

/* Calls task(argument) `workers` times, each on a thread of its own if it can, one of them the
 * calling thread, and returns when all calls have returned. Calls share the work among themselves
 * and never wait for one that has not begun, so that fewer threads make a step slower, not wrong.
 * It is called once or twice a step, from inside thud_world_step, and once by calls for many casts
 * (thud_casts.h), and never while an earlier call is under way. */
typedef void thud_parallel_fn(thud_task_fn *task, void *argument, int workers, void *context);

typedef struct thud_job_system {
    thud_parallel_fn *run; /* null (the default): the calling thread alone */
    void *context;         /* handed to run */
    int workers;           /* 0 (as 1) .. THUD_WORKERS_MAX; more than 1 needs run */
} thud_job_system;

#ifdef __cplusplus
}
#endif

#endif
