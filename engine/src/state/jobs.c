/* jobs.c: see jobs.h. */
#include "state/jobs.h"

#include <string.h>

/* Fewer blocks than this are done before another thread has woken. */
enum { WORTH_SHARING = 64 };

void td_worker_walk(td_worker *worker, int chunks, td_chunk_fn *run, void *work) {
    atomic_int *phase = worker->phase;
    if (!phase) {
        for (int i = 0; i < chunks; i++) {
            run(work, i);
        }
        return;
    }
    int workers = worker->workers;
    for (int k = 0; k < workers; k++) {
        int part = (worker->index + k) % workers;
        int first = chunks * part / workers, end = chunks * (part + 1) / workers, i;
        while (first < end && (i = first + atomic_fetch_add(&phase[1 + part], 1)) < end) {
            run(work, i);
            atomic_fetch_add_explicit(&phase[0], 1, memory_order_acq_rel);
        }
    }
    while (atomic_load_explicit(&phase[0], memory_order_acquire) < chunks) {
        td_pause();
    }
    worker->phase += 1 + workers;
}

/* Most has the solver: two passes over bodies and two over each bin a substep, the warm start,
 * those of restitution, and in each substep those that brace joints, twice; the second time a relax
 * pass stands for TD_BRACE_GIVE. */
static int counter_count(const thud_world *w) {
    int bounces = w->bouncy > 0 || w->asks ? TD_BOUNCE_PASSES + 1 : 0;
    int braces = w->joint_hooks ? 2 * w->substeps : 0, passes = 2 * w->substeps + 1 + bounces;
    int phases = 2 * w->substeps + braces * TD_BRACE_TASKS +
                 (passes + braces * TD_BRACE_STAGES) * w->scratch.chunks.count;
    return phases * (1 + w->def.job_system.workers);
}

bool td_job_reserve(thud_world *w) {
    return w->def.job_system.workers < 2 ||
           td_array_reserve(&w->memory, &w->scratch.counters, counter_count(w));
}

td_job td_job_begin(thud_world *w) {
    if (w->def.job_system.workers < 2 || w->scratch.blocks.count < WORTH_SHARING) {
        return (td_job){.workers = 1};
    }
    memset(w->scratch.counters.data, 0, (size_t)counter_count(w) * sizeof(atomic_int));
    return (td_job){.counters = w->scratch.counters.data, .workers = w->def.job_system.workers};
}

/* Each thread has a floating-point mode of its own. */
typedef struct shared_work {
    thud_task_fn *run;
    void *argument;
} shared_work;

static void run_in_own_mode(void *work) {
    TD_IN_OWN_MODE;
    const shared_work *shared = work;
    shared->run(shared->argument);
}

void td_job_run(const thud_world *w, const td_job *task, thud_task_fn *run, void *argument) {
    const thud_job_system *job_system = &w->def.job_system;
    if (task->counters) {
        shared_work shared = {run, argument};
        job_system->run(run_in_own_mode, &shared, job_system->workers, job_system->context);
    } else {
        run(argument);
    }
}
