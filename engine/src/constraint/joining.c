/* joining.c: see joining.h. */
#include "constraint/joining.h"

#include "constraint/joint.h"
#include "contact/contact.h"
#include "islands/wake.h"

static bool is_solid_contact(const td_constraint *constraint) {
    return td_is_contact(constraint) && constraint->kind != TD_PAIR_SENSOR;
}

static bool is_there(const td_body *body) {
    return !(body->flags & (TD_BODY_DISABLED | TD_BODY_QUARANTINED)) &&
           !(body->changes & TD_CHANGE_ENTER);
}

/* Contacts of two bodies that are to meet no more. */
static bool end_contacts(thud_world *w, td_body_index a, td_body_index b) {
    int count = 0;
    for (int e = td_body_at(w, a)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        count +=
            is_solid_contact(td_constraint_at(w, e / 2)) && td_same_body(td_other_body(w, e), b);
    }
    if (count && !td_contact_end_reserve(w, count)) {
        return false;
    }
    for (int e = td_body_at(w, a)->first_constraint; count && e != TD_NONE;) {
        int next = td_next_edge(w, e);
        if (is_solid_contact(td_constraint_at(w, e / 2)) && td_same_body(td_other_body(w, e), b)) {
            td_contact_destroy(w, e / 2);
        }
        e = next;
    }
    return true;
}

/* A sleeping body wakes, since something new holds it. */
static bool engage(thud_world *w, int index) {
    const td_constraint *constraint = td_constraint_at(w, index);
    if (!td_joint_of(w, constraint)->collides &&
        !end_contacts(w, constraint->body[0], constraint->body[1])) {
        return false;
    }
    for (int side = 0; side < 2; side++) {
        td_body_index body = td_constraint_at(w, index)->body[side];
        if (td_body_sleeps(w, body) && !td_wake(w, body)) {
            return false;
        }
    }
    td_constraint_rest(w, index);
    if (!td_lanes_place(w, &index, 1, false)) {
        td_constraint_wait(w, index);
        return false;
    }
    return true;
}

bool td_joints_engage(thud_world *w) {
    for (int kind = TD_PAIR_COUNT; kind < TD_CONSTRAINT_KINDS; kind++) {
        for (int i = 0; i < w->waiting[kind].count;) {
            int index = td_int_at(&w->waiting[kind], i);
            const td_constraint *constraint = td_constraint_at(w, index);
            if (td_joint_of(w, constraint)->disabled ||
                !is_there(td_body_at(w, constraint->body[0])) ||
                !is_there(td_body_at(w, constraint->body[1]))) {
                i++; /* it goes on waiting */
            } else if (!engage(w, index)) {
                return false;
            }
        }
    }
    return true;
}

void td_joints_suspend(thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        if (!td_is_contact(constraint) && constraint->state == TD_TOUCHING) {
            td_lane_remove(w, e / 2);
            td_constraint_wait(w, e / 2);
        }
    }
}

/* Both bodies' constraints are walked in turns: the shorter list decides. */
bool td_joints_keep_apart(const thud_world *w, td_body_index a, td_body_index b) {
    int e = td_body_at(w, a)->first_constraint, f = td_body_at(w, b)->first_constraint;
    td_body_index other = b;
    while (e != TD_NONE && f != TD_NONE) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
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

void td_joints_leave(thud_world *w, int index, int part) {
    td_joint *joint = td_slot_at(&w->joints, index);
    bool any = false;
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        joint->part[i] = joint->part[i] == part ? TD_NONE : joint->part[i];
        any |= joint->part[i] != TD_NONE;
    }
    if (!any) {
        joint->live = 0;
        joint->generation++;
        td_slots_give(&w->joints, index);
    }
}
