/* narrowphase.c: the stage that finds which pairs touch, and computes their manifolds.
 *
 * Contacts whose shapes do not touch wait. Each step tests them in scratch blocks, and those that
 * touch take a lane. Then the manifolds of all lanes are computed in place, in the blocks that the
 * solver works on; a contact that no longer touches gives its lane back and waits. The stage has
 * five parts, and a step that is made again after it ran out of memory goes on with the part that
 * failed, also in a world that was restored from a snapshot in between: manifolds that were
 * computed twice would differ, since the impulses of the step before are assigned to their points.
 * What one part leaves for a later one is therefore in snapshots: scratch.begins, scratch.ends and
 * thud_world.narrowed. */
#include "contact/contact.h"
#include "state/jobs.h"
#include "state/handles.h"
#include "constraint/chunks.h"
#include "contact/internal_edges.h"
#include "contact/waiting.h"
#include "state/shape.h"
#include "state/shared_stages.h"
#include "api/step.h"
#include "state/awake.h"

/* Part 1: finds the waiting contacts that touch. If the step before ran out of memory after
 * contacts had begun, these contacts stay in scratch.begins, since their events have not been
 * published. */
static bool find_touching(thud_world *w) {
    const thud_shared_stages *shared = TD_HAS_THREADS ? w->def.job_system.stages : NULL;
    int contacts = w->constraints.live, *begins = w->scratch.begins.data, kept_count = 0;
    for (int i = 0; i < w->scratch.begins.count; i++) {
        const td_contact *contact = td_contact_at(w, begins[i]);
        if (contact->live && contact->state == TD_TOUCHING) {
            begins[kept_count++] = begins[i];
        }
    }
    w->scratch.begins.count = kept_count;
    w->scratch.ends.count = 0;
    if (!td_waiting_reserve(w, 1) ||
        !td_array_reserve(&w->memory, &w->scratch.begins, kept_count + contacts) ||
        !td_array_reserve(&w->memory, &w->scratch.ends, contacts)) {
        return false;
    }
    (shared ? shared->waiting : td_waiting_test_all)(w);
    return true;
}

/* Part 2: wakes islands that are touched, and gives the contacts that touch lanes and begin events.
 */
static bool begin_contacts(thud_world *w) {
    td_array *begins = &w->scratch.begins;
    if (begins->count == 0) {
        return true;
    }
    const int *list = begins->data;
    /* The contacts at indices below `first` have begun already, in an earlier attempt at this step
     * that ran out of memory. */
    int first = 0;
    while (first < begins->count && td_contact_at(w, list[first])->state == TD_TOUCHING) {
        first++;
    }
    int count = begins->count - first;
    list += first;
    for (int i = 0; i < count; i++) {
        td_constraints_fetch(w, list, count, i);
        const td_contact *contact = td_contact_at(w, list[i]);
        td_body_index sleeper = contact->body[td_body_sleeps(w, contact->body[0]) ? 0 : 1];
        if (td_body_sleeps(w, sleeper) && !td_wake(w, sleeper)) {
            return false;
        }
    }
    td_event_lists *events = &w->events;
    if (w->def.contact_events &&
        (!td_array_reserve(&w->memory, &events->begin, events->begin.count + count) ||
         !td_array_reserve(&w->memory, &events->hit, events->hit.count + begins->count))) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        td_constraint_rest(w, list[i]);
    }
    bool placed = td_lanes_place(w, list, count);
    /* Without memory for lanes, the contacts wait again. */
    for (int i = 0; i < count; i++) {
        td_constraints_fetch(w, list, count, i);
        (placed ? td_contact_begin : td_constraint_wait)(w, list[i]);
    }
    return placed;
}

/* ---- lanes ---- */

/* The argument of all workers of collide_lanes. */
typedef struct colliding {
    thud_world *w;
    td_job job;
} colliding;

/* One worker's state: the phase of the chunks that it works on. */
typedef struct colliding_phase {
    thud_world *w;
    const td_phase *phase;
} colliding_phase;

/* Chunks list blocks with separated lanes in disjoint pieces of one array: each has room for one
 * more than its blocks, hence `first + index`. */
static void collide_chunk(void *world, int index) {
    thud_world *w = world;
    td_chunk *chunk = TD_AT(td_chunk, &w->scratch.chunks, index);
    const td_run *run = TD_AT(td_run, &w->scratch.runs, chunk->run);
    td_block **separated = (td_block **)w->scratch.separated.data + chunk->first + index;
    chunk->separated = 0;
    chunk->has_offsets =
        td_collide_blocks(w, run->kind, (td_block **)w->scratch.blocks.data + chunk->first,
                          chunk->count, separated, &chunk->separated);
}

/* Computes the manifolds of one part of a phase, which is the work between two points at which
 * workers wait for each other (td_phase). A td_chunk_fn. */
static void collide_part(void *work, int part) {
    const colliding_phase *c = work;
    td_phase_run(c->w, c->phase, part, collide_chunk, c->w);
}

/* A worker: takes chunks until none is left. It takes them by the phases of the solver (td_phase),
 * so that the solver gives the same blocks to the same worker, in whose cache they are. */
static void collide_as_worker(void *argument) {
    colliding *shared = argument;
    colliding_phase own = {.w = shared->w};
    td_worker worker = td_worker_arrive(&shared->job);
    if (!td_worker_shares(&worker)) {
        for (int i = 0; i < own.w->scratch.chunks.count; i++) {
            collide_chunk(own.w, i);
        }
        return;
    }
    for (int i = 0; i < own.w->scratch.phases.count; i++) {
        own.phase = TD_AT(td_phase, &own.w->scratch.phases, i);
        td_worker_take(&worker, own.phase->shares, collide_part, &own);
    }
    td_worker_wait(&worker);
}

/* Computes the manifolds of all lanes, and joins the lists of the chunks. */
static void collide_lanes(thud_world *w) {
    colliding c;
    c.w = w;
    td_job_begin(&c.job, td_workers_for_blocks(w));
    td_job_run(w, &c.job, collide_as_worker, &c);
    for (int i = 0; i < w->scratch.runs.count; i++) {
        TD_AT(td_run, &w->scratch.runs, i)->has_offsets = 0;
    }
    td_block **separated = w->scratch.separated.data;
    w->scratch.separated.count = 0;
    for (int i = 0; i < w->scratch.chunks.count; i++) {
        const td_chunk *chunk = TD_AT(td_chunk, &w->scratch.chunks, i);
        TD_AT(td_run, &w->scratch.runs, chunk->run)->has_offsets |= chunk->has_offsets;
        for (int k = 0; k < chunk->separated; k++) {
            separated[w->scratch.separated.count++] = separated[chunk->first + i + k];
        }
    }
}

/* Sets scratch.ends to the contacts that no longer touch. Part 1 has made room for them. */
static void list_separated(thud_world *w) {
    td_array *ends = &w->scratch.ends;
    ends->count = 0;
    for (int i = 0; i < w->scratch.separated.count; i++) {
        const td_block *block = *TD_AT(td_block *, &w->scratch.separated, i);
        unsigned separated = ((1u << block->used) - 1u) & ~block->touching;
        for (; separated; separated &= separated - 1) {
            td_push_int(ends, block->constraint[__builtin_ctz(separated)]);
        }
    }
}

/* Part 5: contacts that no longer touch give their lanes back and wait. */
static bool part_contacts(thud_world *w) {
    td_array *ends = &w->scratch.ends;
    if (!td_contact_end_reserve(w, ends->count)) {
        return false;
    }
    for (int i = 0; i < ends->count; i++) {
        int contact = td_int_at(ends, i);
        td_constraints_fetch(w, ends->data, ends->count, i);
        td_contact_part(w, contact);
        /* After a teleport even the fat bounds may no longer overlap. Then the contact is
         * destroyed, since a contact of shapes that do not touch exists only while they do
         * (broadphase.c). */
        if (!td_contact_bounds_meet(w, td_contact_at(w, contact))) {
            td_contact_destroy(w, contact);
        }
    }
    ends->count = 0;
    return true;
}

/* Part 3: destroys contacts whose bounds have parted, those of sensors too, whose end event is
 * added. */
static bool part_waiting(thud_world *w) {
    const td_array *sensed = &w->waiting[TD_PAIR_SENSOR];
    if (!td_contact_end_reserve(w, sensed->count)) {
        return false;
    }
    for (int i = 0; i < sensed->count; i++) {
        int index = td_int_at(sensed, i);
        if (!td_contact_bounds_meet(w, td_contact_at(w, index))) {
            td_push_int(&w->scratch.ends, index);
        }
    }
    for (int i = 0; i < w->scratch.ends.count; i++) {
        td_constraints_fetch(w, w->scratch.ends.data, w->scratch.ends.count, i);
        td_contact_destroy(w, td_int_at(&w->scratch.ends, i));
    }
    return true;
}

/* Part 4: manifolds of all lanes, and internal edges. */
static bool collide_all(thud_world *w) {
    if (!td_lanes_sequence(w)) {
        return false;
    }
    collide_lanes(w);
    if (w->internal_edges) {
        w->internal_edges->amend_all(w);
    }
    list_separated(w);
    return true;
}

bool td_narrowphase(thud_world *w) {
    enum { PARTS = 5 };
    static bool (*const parts[PARTS])(thud_world *) = {find_touching, begin_contacts, part_waiting,
                                                       collide_all, part_contacts};
    while (w->narrowed < PARTS && parts[w->narrowed](w)) {
        w->narrowed++;
    }
    /* Part 5 has changed the sequence of blocks, and after a restore there is none: it is listed
     * again. */
    return w->narrowed == PARTS && td_lanes_sequence(w);
}
