/* finalize.c: the stage that adds the motion of the step to poses. It reads velocity and delta of
 * every awake body, and writes poses, shapes, fat bounds, idle times, the list of moved shapes and
 * the list of fast bodies. A body whose velocity or motion is not finite is quarantined: it stays
 * where it was, its contacts end, an event tells of it, and its values reach no other body. */
#include "state/awake.h"
#include "state/body.h"
#include "constraint/tied_bodies.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "state/shared_stages.h"
#include "state/kinds.h"
#include "base/rotation.h"
#include "solver/wide_energy.h"
#include "api/step.h"

#include <string.h>

/* Whether the first three numbers of a record (x, y and rotation) are finite. */
static bool row_finite(const float *row) {
    return td_finite((double)row[0] + (double)row[1] + (double)row[2]);
}

/* Replaces `from` by `to` in a list of slots, after a body has moved from one slot to the other. */
static void follow_slot(td_array *slots, td_awake_slot from, td_awake_slot to) {
    td_awake_slot *list = slots->data;
    for (int i = 0; i < slots->count; i++) {
        list[i] = list[i].at == from.at ? to : list[i];
    }
}

/* Quarantines a body: ends its contacts and takes it out of the awake bodies; see the head of this
 * file. */
static void quarantine(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    td_awake_slot slot = body->awake;
    memset(td_row(&w->velocity, body->awake), 0, sizeof(float[4]));
    for (int e = body->first_constraint; e != TD_NONE;) {
        int next = td_next_edge(w, e);
        if (!td_contact_end_reserve(w, 1)) {
            td_constraint_at(w, td_edge_constraint(e))->open =
                0; /* without memory for its end event the contact ends without one */
        }
        td_contact_destroy(w, td_edge_constraint(e));
        e = next;
    }
    td_tied_leave(w, slot);
    td_awake_remove(w, index);
    follow_slot(&w->scratch.fast, (td_awake_slot){w->body_of.count}, slot);
    body->flags |= TD_BODY_QUARANTINED;
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
    if (td_array_reserve(&w->memory, &w->events.quarantined, w->events.quarantined.count + 1)) {
        TD_PUSH(thud_body_id, &w->events.quarantined) = td_body_handle(w, index);
    }
    td_refuse(w, THUD_ERROR_INVALID, "a body is not finite and is quarantined");
}

/* Adds a motion to the pose of one body. */
static void move(thud_world *w, td_body_index index, const float *delta) {
    td_pose *pose = td_pose_at(w, index);
    pose->center.x = td_wrap_add64(pose->center.x, td_length_from(w, delta[0]));
    pose->center.y = td_wrap_add64(pose->center.y, td_length_from(w, delta[1]));
    if (delta[2] != 0.0f) {
        pose->angle += td_angle_between((double)delta[2]);
        td_angle_turn(pose->angle, &pose->c, &pose->s);
    }
}

bool td_finalize_reserve(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.fast, w->body_of.count) &&
           td_array_reserve(&w->memory, &w->scratch.odd, w->body_of.count);
}

/* Moves all bodies eight at a time, except for those that this pass cannot move: it lists them in
 * scratch.odd (wide_finalize.c). */
static void finalize_bodies(thud_world *w) {
    const thud_shared_stages *shared = TD_HAS_THREADS ? w->def.job_system.stages : NULL;
    td_energy_sums sums = {0};
    td_finalize_part all = {.end = w->body_of.count,
                            .odd = &w->scratch.odd,
                            .fast = &w->scratch.fast,
                            .moved = &w->moved,
                            .sums = &sums};
    (shared ? shared->finalize : TD_PICK_WIDE(w, td_finalize_bodies))(w, &all);
    w->awake_shapes.valid &= !all.has_moved;
    w->idle_bodies = all.idle;
    w->drowsy_bodies = all.drowsy;
    w->kinetic = td_total_of(&sums.kinetic);
    w->kinetic_stale = false;
    w->errors.energy_change += w->kinetic - td_total_of(&sums.gained);
}

void td_finalize(thud_world *w) {
    w->scratch.fast.count = w->scratch.odd.count = 0;
    finalize_bodies(w);
    /* From the last slot down: quarantine moves the body of the last slot into the one that is
     * freed. */
    for (int i = w->scratch.odd.count - 1; i >= 0; i--) {
        td_awake_slot slot = td_slot_in(&w->scratch.odd, i);
        td_body_index index = td_body_of(w, slot);
        const float *delta = td_row(&w->delta, slot), *reach = td_row(&w->reach, slot);
        if (!row_finite(td_row(&w->velocity, slot)) || !row_finite(delta)) {
            quarantine(w, index);
            continue;
        }
        move(w, index, delta);
        td_body_place_shapes(w, index);
        /* The condition of wide_finalize.c: a dynamic body that moved by more than half of its
         * least extent. */
        if (w->detections[TD_RANK_CONTINUOUS] && td_inv_mass_of(w, slot) > 0.0f &&
            delta[0] * delta[0] + delta[1] * delta[1] > 0.25f * reach[0] * reach[0]) {
            td_push_slot(&w->scratch.fast, slot);
        }
    }
}
