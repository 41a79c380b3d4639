/* thud_hooks.h: services that the caller may provide to a world: memory, a log, a clock, and
 * threads. A hook (allocator, log, clock, job system) must not call any function of the world.
 * Included by thud.h. */
#ifndef THUD_HOOKS_H
#define THUD_HOOKS_H

#include "thud_limits.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- memory ---- */

/* All zero: the C library's memory. One function without the other is refused. */
typedef struct thud_allocator {
    void *(*allocate)(size_t bytes, void *context);            /* 64-byte aligned memory, or null */
    void (*release)(void *block, size_t bytes, void *context); /* bytes: as it was allocated */
    void *context;                                             /* passed to both */
} thud_allocator;

/* ---- log and clock ---- */

/* Called with the reason when a call is refused; with THUD_OK, it warns of a call that succeeded
 * but is probably a mistake. If one number is out of range, the message names it, its value and its
 * range: "shape def: friction is -1, not in [0, 1000000]". The message is valid during the call. */
typedef void thud_log_fn(thud_result result, const char *message, void *context);
/* A log that writes one line to the C library's stderr. A program that does not use it does not
 * link it, unless thud is built without NDEBUG: it is then the default log of defs. */
THUD_API void thud_log_to_stderr(thud_result result, const char *message, void *context);
/* The time in seconds since any start; it must not go backwards. */
typedef double thud_clock_fn(void *context);

/* ---- threads ---- */

/* A task of the engine. */
typedef void thud_task_fn(void *argument);

/* Must call task(argument) `workers` times, each on a thread of its own if possible, one of them
 * the calling thread, and return when all calls have returned. The calls divide the work among
 * themselves and never wait for a call that has not begun: with fewer threads a step is slower, but
 * the same. The engine calls it at most six times in a step, from inside thud_world_step, and
 * once in each call for many casts (thud_casts.h), but never before an earlier call has returned.
 */
typedef void thud_parallel_fn(thud_task_fn *task, void *argument, int workers, void *context);

/* Which stages of a large step workers share, beside contact manifolds and the solver. A program
 * links the code that shares a stage only where it names a choice that has it. */
typedef struct thud_shared_stages thud_shared_stages;
/* Every stage that can be shared: the search for pairs of awake shapes whose bounds overlap, the
 * test which of these pairs touch, the end of the step, which moves bodies and bounds and adds up
 * energies, and the search for static shapes in the way of fast bodies (thud_detection_continuous).
 * Results are the same, bit for bit, as without it. */
extern THUD_API const thud_shared_stages thud_shared_stages_all;

/* Threads among which a world divides its steps. A world starts none itself: it uses those of the
 * caller, or the pool of thud_threads.h. The number of workers does not change any result. A
 * WebAssembly program without threads (-pthread) calls no job system. */
typedef struct thud_job_system {
    thud_parallel_fn *run; /* null (the default): the calling thread alone */
    void *context;         /* passed to run */
    int workers; /* 0 .. THUD_WORKERS_MAX; default 0, which means 1; more than 1 needs run */
    const thud_shared_stages *stages; /* null (the default): manifolds and solver alone */
    /* Workers share steps with so many blocks of contacts (thud_stats.blocks; those with two
     * points, as of boxes, count twice) or more, or with four times as many awake bodies. With
     * fewer, the data of bodies that move between processors cost more time than a second thread
     * saves. Default 0, which means 2048, as measured with two threads (docs/performance.md); 1:
     * all that have a contact or four bodies; UINT32_MAX: none. */
    uint32_t share_from;
} thud_job_system;

#ifdef __cplusplus
}
#endif

#endif
