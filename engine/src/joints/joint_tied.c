/* joint_tied.c: finds the groups of tied bodies of a step (constraint/tied_bodies.h), and stops all
 * bodies of a group together. Groups are found by union-find over the joints (islands/label.h); the
 * circular lists are merged at each union. */
#include "constraint/joint_hooks.h"
#include "constraint/tied_bodies.h"
#include "detection/detection.h"
#include "islands/label.h"
#include "joints/joint.h"

/* Joins the groups of two bodies. Swapping the next links of one element in each of two circular
 * lists makes one circular list of both. */
static void join_groups(thud_world *w, td_awake_slot a, td_awake_slot b) {
    if (td_join_trees(w->scratch.parents.data, a, b)) {
        td_awake_slot next = td_next_tied(w, a);
        *td_tied_link(w, a) = td_next_tied(w, b);
        *td_tied_link(w, b) = next;
    }
}

/* Whether a joint to a static or kinematic body locks so many directions that its gap would open if
 * detection stopped the dynamic body within the step. Rods do not count, since they lock one
 * direction, nor do the joints by which edits/locks.c locks single axes. */
static bool fixes_body(const thud_world *w, const td_joint *joint) {
    return joint->kind != THUD_JOINT_DISTANCE && !td_joint_is_lock(w, joint, joint->body[1]);
}

/* Marks a body that is alone in its group as fixed to a static or kinematic body: sets its
 * td_tied_link to TD_NONE. Slot 0 stands for all static bodies and is left out. */
static void mark_fixed(const thud_world *w, td_awake_slot slot) {
    if (td_tied_link(w, slot)->at == slot.at && slot.at > 0) {
        td_tied_link(w, slot)->at = TD_NONE;
    }
}

/* The awake slot of a dynamic body; slot 0 for other bodies and sleeping ones. */
static td_awake_slot moving_slot(const thud_world *w, td_body_index body) {
    const td_body *b = td_body_at(w, body);
    return b->kind == THUD_BODY_DYNAMIC && b->awake.at > 0 ? b->awake : (td_awake_slot){0};
}

/* Only joints with locked directions tie their bodies: a body on a spring or motor may be stopped
 * without its partner. td_joints_engage has reserved the memory. */
void td_joints_tie(thud_world *w) {
    if (w->scratch.next_tied.count > 0) {
        return;
    }
    w->scratch.next_tied.count = w->body_of.count;
    td_awake_slot *parents = w->scratch.parents.data;
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        parents[slot.at] = slot;
        *td_tied_link(w, slot) = slot;
    }
    for (int i = 0; i < w->joints.count; i++) {
        const td_joint *joint = td_joint_at(w, i);
        if (joint->live && joint->locked && td_joint_acts(w, joint)) {
            td_awake_slot a = moving_slot(w, joint->body[0]), b = moving_slot(w, joint->body[1]);
            if (a.at > 0 && b.at > 0) {
                join_groups(w, a, b);
            } else if (fixes_body(w, joint)) {
                mark_fixed(w, a.at > 0 ? a : b);
            }
        }
    }
}

void td_joints_hold_back(thud_world *w, td_awake_slot slot, double time) {
    td_joints_tie(w);
    td_awake_slot other = td_next_tied(w, slot);
    while (other.at != slot.at) {
        td_hold_at(w, other, time);
        other = td_next_tied(w, other);
    }
}
