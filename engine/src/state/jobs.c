/* jobs.c: distributes the chunks of each phase among workers by atomic counters; see jobs.h. */
#include "state/jobs.h"

#include <string.h>

/* Blocks from which on a task is shared: fewer are solved before another thread has woken, so that
 * sharing would only cost. A greater value leaves more small worlds to one thread. Chosen; not
 * tuned. */
enum { SHARED_BLOCKS_MIN = 64 };

/* A phase for one worker: takes chunks of each part, its own first, and waits until all are done.
 */
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

/* The number of counters for the task with the most phases, which is the solver's (solve.c): for
 * each substep two phases over bodies and two passes over the bins (solve and relax); once the warm
 * start and the passes of restitution; and with joints, bracing twice in each substep
 * (joint_brace.c), of whose second the relax pass stands for TD_BRACE_WARM_START. A pass has a
 * phase for each entry of scratch.chunks, and a phase has 1 + workers counters. */
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

/* A task with cleared counters, or one without, for the calling thread alone. */
td_job td_job_begin(thud_world *w) {
    if (w->def.job_system.workers < 2 || w->scratch.blocks.count < SHARED_BLOCKS_MIN) {
        return (td_job){.workers = 1};
    }
    memset(w->scratch.counters.data, 0, (size_t)counter_count(w) * sizeof(atomic_int));
    return (td_job){.counters = w->scratch.counters.data, .workers = w->def.job_system.workers};
}

/* A task for the job system, whose threads may have another floating-point mode (simd.h). */
typedef struct shared_work {
    thud_task_fn *run;
    void *argument;
} shared_work;

/* Runs the task in the engine's mode, and restores the thread's. */
static void run_in_own_float_mode(void *work) {
    TD_IN_OWN_FLOAT_MODE;
    const shared_work *shared = work;
    shared->run(shared->argument);
}

void td_job_run(const thud_world *w, const td_job *task, thud_task_fn *run, void *argument) {
    const thud_job_system *job_system = &w->def.job_system;
    if (task->counters) {
        shared_work shared = {run, argument};
        job_system->run(run_in_own_float_mode, &shared, job_system->workers, job_system->context);
    } else {
        run(argument);
    }
}
