/* thud_jobs.h: letting a step run on several threads. The engine starts none itself: it asks the
 * caller's own job system or thread pool. Any number of workers gives the same bits. */
#ifndef THUD_JOBS_H
#define THUD_JOBS_H

enum { THUD_WORKERS_MAX = 64 };

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

#endif
