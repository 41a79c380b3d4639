/* jobs.c: distributes the chunks of each phase among workers by atomic counters; see jobs.h. */
#include "state/jobs.h"

void td_job_begin_shared(td_job *job) {
    atomic_init(&job->arrived.value, 0);
    atomic_init(&job->done.value, 0);
    for (int i = 0; i < job->workers; i++) {
        atomic_init(&job->taken[i].value, 0);
    }
}

/* Takes and runs chunks of one part of the phase, [first, end), until none is left. Returns how
 * many. `before`: the number of chunks of this part in all earlier phases. The part's counter is at
 * least that now, and greater than `before` plus the size of the part only where other workers are
 * in a later phase already. */
static int run_part(atomic_int *taken, int before, int first, int end, td_chunk_fn *run,
                    void *work) {
    int ran = 0, next = atomic_load_explicit(taken, memory_order_relaxed);
    while (next - before < end - first) {
        if (atomic_compare_exchange_weak_explicit(taken, &next, next + 1, memory_order_relaxed,
                                                  memory_order_relaxed)) {
            run(work, first + (next - before));
            ran++;
            next = atomic_load_explicit(taken, memory_order_relaxed);
        }
    }
    return ran;
}

/* How many chunks of a part are not taken yet; see run_part for `before`. */
static int chunks_left(atomic_int *taken, int before, int size) {
    return before + size - atomic_load_explicit(taken, memory_order_relaxed);
}

/* Polls after which a worker takes chunks that another one still has not taken. Chosen: about as
 * long as a chunk takes. */
enum { POLLS_BEFORE_STEALING = 32 };

/* Takes chunks of another worker's part, and returns how many. While more than a quarter of that
 * part is left, it takes them at once. The last ones it takes only if the other worker has taken
 * none for a while (POLLS_BEFORE_STEALING): the data of a stolen chunk move to this processor, and
 * in the next phase back again. */
static int steal_part(atomic_int *taken, int before, int first, int end, td_chunk_fn *run,
                      void *work) {
    int size = end - first, ran = 0, polls = 0;
    for (int left; (left = chunks_left(taken, before, size)) > 0;) {
        int next = before + size - left;
        if (left <= size / 4 + 1 && polls < POLLS_BEFORE_STEALING) {
            td_pause();
            polls++;
        } else if (atomic_compare_exchange_weak_explicit(taken, &next, next + 1,
                                                         memory_order_relaxed,
                                                         memory_order_relaxed)) {
            run(work, end - left);
            ran++;
            polls = 0;
        }
    }
    return ran;
}

/* A phase for one worker: takes chunks of each part, its own first. It adds the number of its
 * chunks to td_job.done once, at the end, since an addition for each chunk would make the counter's
 * cache line move between processors each time. */
void td_worker_take(td_worker *worker, const int *shares, td_chunk_fn *run, void *work) {
    td_job *job = worker->job;
    int workers = job->workers, ran = 0;
    for (int k = 0; k < workers; k++) {
        int part = (worker->index + k) % workers, *before = &worker->before_of[part];
        ran += (k == 0 ? run_part : steal_part)(&job->taken[part].value, *before, shares[part],
                                                shares[part + 1], run, work);
        *before += shares[part + 1] - shares[part];
    }
    worker->before += shares[workers];
    if (ran > 0) {
        atomic_fetch_add_explicit(&job->done.value, ran, memory_order_acq_rel);
    }
}

void td_worker_wait(const td_worker *worker) {
    td_job *job = worker->job;
    while (td_worker_shares(worker) &&
           atomic_load_explicit(&job->done.value, memory_order_acquire) < worker->before) {
        td_pause();
    }
}

void td_share_evenly(int chunks, int workers, int *shares) {
    for (int i = 0; i <= workers; i++) {
        shares[i] = (int)((int64_t)chunks * i / workers);
    }
}

void td_worker_walk_shared(td_worker *worker, int chunks, td_chunk_fn *run, void *work) {
    int shares[THUD_WORKERS_MAX + 1], workers = worker->job->workers;
    td_share_evenly(chunks, workers, shares);
    td_worker_take(worker, shares, run, work);
    td_worker_wait(worker);
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

void td_job_run_shared(const thud_world *w, const td_job *job, thud_task_fn *task, void *argument) {
    const thud_job_system *job_system = &w->def.job_system;
    shared_work shared = {task, argument};
    job_system->run(run_in_own_float_mode, &shared, job->workers, job_system->context);
}
