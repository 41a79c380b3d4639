/* joining.c: see joining.h. */
#include "constraint/joining.h"

#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "islands/wake.h"

static bool is_there(const td_body *body) {
    return !(body->flags & (TD_BODY_DISABLED | TD_BODY_QUARANTINED)) &&
           !(body->changes & TD_CHANGE_ENTER);
}

/* A sleeping body wakes, since something new holds it. */
static bool engage(thud_world *w, int index) {
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

static bool engage_all(thud_world *w) {
    for (int kind = TD_PAIR_COUNT; kind < TD_CONSTRAINT_KINDS; kind++) {
        for (int i = 0; i < w->waiting[kind].count;) {
            int index = td_int_at(&w->waiting[kind], i);
            const td_constraint *constraint = td_constraint_at(w, index);
            if (!is_there(td_body_at(w, constraint->body[0])) ||
                !is_there(td_body_at(w, constraint->body[1]))) {
                i++; /* it goes on waiting */
            } else if (!engage(w, index)) {
                return false;
            }
        }
    }
    return true;
}

static void suspend(thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        if (!td_is_contact(constraint) && constraint->state == TD_TOUCHING) {
            td_lane_remove(w, e / 2);
            td_constraint_wait(w, e / 2);
        }
    }
}

const td_joining_ops td_joining = {engage_all, suspend};
