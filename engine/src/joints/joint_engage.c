/* joint_engage.c: gives lanes (places in blocks of eight constraints) to the constraints of joints,
 * and takes them back; see joint_hooks.h.
 *
 * The constraint of a joint waits until both bodies are in the world and enabled. As the next step
 * begins, it takes a lane, its bodies are woken, and contacts between them are ended, unless the
 * joint lets them collide. */
#include "constraint/joint_hooks.h"

#include "joints/gear.h"
#include "contact/contact.h"
#include "state/awake.h"

static bool is_solid_contact(const td_constraint *constraint) {
    return td_is_contact(constraint) && constraint->kind != TD_PAIR_SENSOR;
}

/* Whether the body is in the world: entered, enabled, and not quarantined. */
static bool in_world(const td_body *body) {
    return !(body->flags & (TD_BODY_DISABLED | TD_BODY_QUARANTINED)) &&
           !(body->changes & TD_CHANGE_ENTER);
}

/* Destroys the contacts between two bodies. False when memory is short; nothing has changed then.
 */
static bool end_contacts(thud_world *w, td_body_index a, td_body_index b) {
    int count = 0;
    for (int e = td_body_at(w, a)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        count += is_solid_contact(td_constraint_at(w, td_edge_constraint(e))) &&
                 td_same_body(td_other_body(w, e), b);
    }
    if (!td_contact_end_reserve(w, count)) {
        return false;
    }
    for (int e = td_body_at(w, a)->first_constraint; count && e != TD_NONE;) {
        int next = td_next_edge(w, e);
        if (is_solid_contact(td_constraint_at(w, td_edge_constraint(e))) &&
            td_same_body(td_other_body(w, e), b)) {
            td_contact_destroy(w, td_edge_constraint(e));
        }
        e = next;
    }
    return true;
}

/* Whether the joint is enabled and both bodies are in the world. */
static bool may_engage(const thud_world *w, const td_constraint *constraint) {
    return !td_joint_of(w, constraint)->disabled && in_world(td_body_at(w, constraint->body[0])) &&
           in_world(td_body_at(w, constraint->body[1]));
}

/* Before a constraint takes its lane: ends contacts between its bodies, unless the joint lets them
 * collide, and wakes them, unless it is a filter. False when memory is short. */
static bool prepare_bodies(thud_world *w, int index) {
    const td_constraint *constraint = td_constraint_at(w, index);
    const td_joint *joint = td_joint_of(w, constraint);
    if (!joint->collides && !end_contacts(w, constraint->body[0], constraint->body[1])) {
        return false;
    }
    for (int side = 0; side < 2 && joint->kind != THUD_JOINT_FILTER; side++) {
        td_body_index body = td_constraint_at(w, index)->body[side];
        if (td_body_sleeps(w, body) && !td_wake(w, body)) {
            return false;
        }
    }
    return true;
}

/* Removes the constraints of filter joints (THUD_JOINT_FILTER) from a list: they only exclude
 * contacts, and need no lane. */
static void remove_filters(const thud_world *w, td_array *list) {
    int kept_count = 0;
    for (int i = 0; i < list->count; i++) {
        int index = td_int_at(list, i);
        bool filter = td_joint_of(w, td_constraint_at(w, index))->kind == THUD_JOINT_FILTER;
        ((int *)list->data)[kept_count] = index;
        kept_count += !filter;
    }
    list->count = kept_count;
}

/* Gives lanes to all constraints of a kind that wait and may act. False when memory is short. */
static bool engage_kind(thud_world *w, int kind) {
    const td_array *waiting = &w->waiting[kind];
    for (int i = 0; i < waiting->count; i++) {
        int index = td_int_at(waiting, i);
        if (may_engage(w, td_constraint_at(w, index)) && !prepare_bodies(w, index)) {
            return false;
        }
    }
    td_array *list = &w->scratch.constraints;
    if (!td_array_reserve(&w->memory, list, waiting->count)) {
        return false;
    }
    list->count = 0;
    for (int i = 0; i < waiting->count; i++) {
        if (may_engage(w, td_constraint_at(w, td_int_at(waiting, i)))) {
            td_push_int(list, td_int_at(waiting, i));
        }
    }
    for (int i = 0; i < list->count; i++) {
        td_constraint_rest(w, td_int_at(list, i));
    }
    remove_filters(w, list);
    /* If memory is short, the constraints are put back into the list in the same order as before,
     * so that the next attempt gives them the same lanes. */
    if (!td_lanes_place(w, list->data, list->count)) {
        for (int i = 0; i < list->count; i++) {
            td_constraint_wait(w, td_int_at(list, i));
        }
        return false;
    }
    return true;
}

/* Destroys gears one of whose joints was destroyed. */
static void end_idle_gears(thud_world *w) {
    for (int i = 0; i < w->joints.count && w->constraint_count[TD_CONSTRAINT_GEAR] > 0; i++) {
        const td_joint *joint = td_joint_at(w, i);
        if (joint->live && joint->kind == THUD_JOINT_GEAR && !td_gear_has_joints(w, joint)) {
            td_joint_end(w, i);
        }
    }
}

bool td_joints_engage(thud_world *w) {
    int bodies = w->bodies.live + 1; /* upper bound of the number of awake slots in this step */
    w->scratch.next_tied.count = w->scratch.brace_groups.count = 0;
    if (!td_array_reserve(&w->memory, &w->broken, w->breakable) ||
        !td_array_reserve(&w->memory, &w->scratch.parents, bodies) ||
        !td_array_reserve(&w->memory, &w->scratch.next_tied, bodies) ||
        !td_array_reserve(&w->memory, &w->scratch.before, bodies) ||
        !td_array_reserve(&w->memory, &w->scratch.brace_groups, bodies)) {
        return false;
    }
    end_idle_gears(w);
    for (int kind = TD_PAIR_COUNT; kind < TD_CONSTRAINT_KINDS; kind++) {
        if (w->waiting[kind].count > 0 && !engage_kind(w, kind)) {
            return false;
        }
    }
    return true;
}

void td_joints_suspend(thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->kind == TD_CONSTRAINT_GEAR) {
            td_joint_of(w, constraint)->gear.apart = 1;
        }
        if (!td_is_contact(constraint) && constraint->state == TD_TOUCHING) {
            td_lane_remove(w, td_edge_constraint(e));
            td_constraint_wait(w, td_edge_constraint(e));
        }
    }
}

/* Sets the frames of axis locks (edits/locks.c) to the body's present position. The other side of
 * such a joint is an anchor body: a static body at angle 0 without shapes, so that directions in
 * its frame are those of the world. */
void td_joints_move_locks(thud_world *w, td_body_index index) {
    const td_body *body = td_body_at(w, index);
    const td_position *center = &td_pose_at(w, index)->center;
    for (int e = body->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *part = td_constraint_at(w, td_edge_constraint(e));
        td_joint *joint = td_is_contact(part) ? NULL : td_joint_of(w, part);
        if (!joint || !td_joint_is_lock(w, joint, index)) {
            continue;
        }
        const td_position *from = &td_pose_at(w, joint->body[0])->center;
        joint->anchor[0][0] = (float)((double)(center->x - from->x) / w->to_fixed);
        joint->anchor[0][1] = (float)((double)(center->y - from->y) / w->to_fixed);
        joint->anchor[1][0] = body->center_x;
        joint->anchor[1][1] = body->center_y;
        if (part->state == TD_TOUCHING) {
            td_lane_renew(w, td_edge_constraint(e));
        }
    }
}

/* Visits the elements of both bodies' lists of constraints alternately, since either list contains
 * every joint between the two bodies: so the shorter list bounds the time. */
bool td_joints_exclude_contact(const thud_world *w, td_body_index a, td_body_index b) {
    const td_body *body_a = td_body_at(w, a), *body_b = td_body_at(w, b);
    if (!(body_a->passes & td_passing_bit(b) && body_b->passes & td_passing_bit(a))) {
        return false;
    }
    int e = body_a->first_constraint, f = body_b->first_constraint;
    td_body_index other = b;
    while (e != TD_NONE && f != TD_NONE) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (!td_is_contact(constraint) && td_same_body(td_other_body(w, e), other) &&
            !td_joint_of(w, constraint)->collides) {
            return true;
        }
        int next = td_next_edge(w, e);
        e = f;
        f = next;
        other = td_same_body(other, b) ? a : b;
    }
    return false;
}

/* Frees an anchor body of edits/locks.c that no joint uses any more. If it has pending changes, it
 * is removed when they take effect; otherwise it is in no list, and has no shapes, contacts or
 * awake slot to give back. */
static void end_idle_anchor(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    int both = TD_BODY_LIVE | TD_BODY_ANCHOR;
    if ((body->flags & both) != both || body->first_constraint != TD_NONE) {
        return;
    }
    if (body->changes) {
        body->flags &= (uint8_t)~TD_BODY_LIVE;
        body->changes |= TD_CHANGE_LEAVE;
        return;
    }
    body->flags = 0;
    body->generation++;
    td_slots_give(&w->bodies, index.at);
}

void td_joints_remove_part(thud_world *w, int index, int part) {
    td_joint *joint = td_slot_at(&w->joints, index);
    bool any = false;
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        joint->part[i] = joint->part[i] == part ? TD_NONE : joint->part[i];
        any |= joint->part[i] != TD_NONE;
    }
    if (!any) {
        w->breakable -= td_joint_breaks(joint);
        joint->live = 0;
        joint->generation++;
        td_slots_give(&w->joints, index);
        end_idle_anchor(w, joint->body[0]);
    }
}
