/* shared_waiting.c: tests of waiting contacts by workers, each of which takes TD_SHARE_WAITING
 * contacts at a time. Their results are joined in the order of the contacts, so that they are the
 * same as those of one thread. */
#include "contact/waiting.h"
#include "state/jobs.h"
#include "state/shared_stages.h"

/* Workers share the test if there are at least this many waiting contacts. With fewer the calling
 * thread finishes before another thread has woken up. Chosen; not tuned. */
enum { SHARED_WAITING_MIN = 1024 };

/* The arguments of the test; each worker has a copy, in which `thread` is its own number. */
typedef struct testing {
    thud_world *w;
    td_job *job;
    int shares, thread;
} testing;

static int shares_of(const thud_world *w, int kind) {
    return (w->waiting[kind].count + TD_SHARE_WAITING - 1) / TD_SHARE_WAITING;
}

static td_waiting_share *share_at(const thud_world *w, int index) {
    return &TD_AT(td_share, &w->scratch.shares, index)->waiting;
}

/* Tests one share of the contacts (a td_chunk_fn). The shares of a kind follow those of the kind
 * before. */
static void test_share(void *work, int index) {
    const testing *t = work;
    td_waiting_share *share = share_at(t->w, index);
    share->begins = td_share_list(share->room[0], TD_SHARE_WAITING);
    share->ends = td_share_list(share->room[1], TD_SHARE_WAITING);
    int kind = 0;
    for (; index >= shares_of(t->w, kind); kind++) {
        index -= shares_of(t->w, kind);
    }
    int first = index * TD_SHARE_WAITING;
    td_waiting_found found = {&share->begins, &share->ends, t->thread};
    const td_array *waiting = &t->w->waiting[kind];
    td_waiting_test(t->w, kind, (const int *)waiting->data + first,
                    td_min_int(waiting->count - first, TD_SHARE_WAITING), &found);
}

static void test_as_worker(void *argument) {
    testing own = *(const testing *)argument;
    td_worker worker = td_worker_arrive(own.job);
    own.thread = worker.index;
    td_worker_walk(&worker, own.shares, test_share, &own);
}

/* Whether workers share the test: there are enough contacts, and memory for the results. Otherwise
 * the calling thread tests all contacts alone. */
static bool is_shared(thud_world *w, int contacts, int shares) {
    return td_workers_for_bodies(w) > 1 && contacts >= SHARED_WAITING_MIN &&
           td_waiting_reserve(w, w->def.job_system.workers) &&
           td_array_reserve(&w->memory, &w->scratch.shares, shares);
}

void td_shared_waiting(thud_world *w) {
    td_job job;
    testing t = {.w = w, .job = &job};
    int contacts = 0;
    for (int kind = 0; kind < TD_PAIR_TOUCH_COUNT; kind++) {
        contacts += w->waiting[kind].count;
        t.shares += shares_of(w, kind);
    }
    if (!is_shared(w, contacts, t.shares)) {
        td_waiting_test_all(w);
        return;
    }
    td_job_begin(&job, w->def.job_system.workers);
    td_job_run(w, &job, test_as_worker, &t);
    for (int i = 0; i < t.shares; i++) {
        td_share_append(&w->scratch.begins, &share_at(w, i)->begins);
        td_share_append(&w->scratch.ends, &share_at(w, i)->ends);
    }
}
