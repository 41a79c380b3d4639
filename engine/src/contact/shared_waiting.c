/* shared_waiting.c: tests of waiting contacts by workers, each of which takes TD_SHARE_WAITING
 * contacts at a time. What they find is joined in the order of the contacts, as one thread finds
 * it. */
#include "contact/waiting.h"
#include "state/jobs.h"
#include "state/shared_stages.h"

#include <string.h>

/* Waiting contacts from which on workers share them: fewer are tested before another thread has
 * woken. Chosen; not tuned. */
enum { SHARED_WAITING_MIN = 1024 };

/* What the workers share; each has a copy, with its own thread. */
typedef struct testing {
    thud_world *w;
    const td_waiting_part *parts;
    td_job *job;
    int shares, thread;
} testing;

static int shares_of(const td_waiting_part *part) {
    return (part->count + TD_SHARE_WAITING - 1) / TD_SHARE_WAITING;
}

static td_waiting_share *share_at(const thud_world *w, int index) {
    return &TD_AT(td_share, &w->scratch.shares, index)->waiting;
}

/* Tests one share of the contacts (a td_chunk_fn). The shares of a part follow those of the part
 * before. */
static void test_share(void *work, int index) {
    const testing *t = work;
    td_waiting_share *share = share_at(t->w, index);
    td_array *lists[2] = {&share->begins, &share->ends};
    for (int i = 0; i < 2; i++) {
        *lists[i] =
            (td_array){.data = share->room[i], .capacity = TD_SHARE_WAITING, .stride = sizeof(int)};
    }
    const td_waiting_part *whole = t->parts;
    for (; index >= shares_of(whole); whole++) {
        index -= shares_of(whole);
    }
    int first = index * TD_SHARE_WAITING;
    td_waiting_part part = {.kind = whole->kind,
                            .contacts = whole->contacts + first,
                            .count = td_min_int(whole->count - first, TD_SHARE_WAITING),
                            .begins = &share->begins,
                            .ends = &share->ends,
                            .thread = t->thread};
    td_waiting_test(t->w, &part);
}

static void test_as_worker(void *argument) {
    testing own = *(const testing *)argument;
    td_worker worker = td_worker_arrive(own.job);
    own.thread = worker.index;
    td_worker_walk(&worker, own.shares, test_share, &own);
}

static void append(td_array *list, const td_array *more) {
    if (more->count) {
        memcpy((int *)list->data + list->count, more->data, (size_t)more->count * sizeof(int));
        list->count += more->count;
    }
}

/* Whether there are enough contacts, and memory for what is found of them: without it the calling
 * thread tests them alone. */
static bool is_shared(thud_world *w, int contacts, int shares) {
    return w->def.job_system.workers > 1 && contacts >= SHARED_WAITING_MIN &&
           td_waiting_reserve(w, w->def.job_system.workers) &&
           td_array_reserve(&w->memory, &w->scratch.shares, shares);
}

void td_shared_waiting(thud_world *w, const td_waiting_part *parts, int count) {
    td_job job;
    testing t = {.w = w, .parts = parts, .job = &job};
    int contacts = 0;
    for (int i = 0; i < count; i++) {
        contacts += parts[i].count;
        t.shares += shares_of(&parts[i]);
    }
    if (!is_shared(w, contacts, t.shares)) {
        td_waiting_test_all(w, parts, count);
        return;
    }
    td_job_begin(&job, w->def.job_system.workers);
    td_job_run(w, &job, test_as_worker, &t);
    for (int i = 0; i < t.shares; i++) {
        append(parts->begins, &share_at(w, i)->begins);
        append(parts->ends, &share_at(w, i)->ends);
    }
}
