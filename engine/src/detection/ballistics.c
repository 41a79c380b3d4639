/* ballistics.c: see ballistics.h. Only swept bodies fly parabolas, since only
 * their impacts heed them. */
#include "detection/ballistics.h"

#include "constraint/constraint.h"
#include "detection/trajectory.h"

/* Contacts do not bear a body to which they gave no more than this share of what gravity gives it
 * in a step. */
#define FREE_SHARE_MAX 0.0625

void td_ballistics_save_velocities(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory *f = td_trajectory_at(w, slot);
        const float *velocity = td_row(&w->velocity, slot);
        *f = (td_trajectory){.body = td_body_of(w, slot)};
        for (int k = 0; k < 3; k++) {
            f->motion[k] = (double)velocity[k];
        }
    }
}

/* Whether the solver, beside gravity, gave the body no more than `share` of velocity, at its rim as
 * at its centre, and of motion. With steps of any number that is v1 = v0 + gain, and a motion from
 * dt (v1 - gain / 2), of steps without end, to dt v1, of one. */
static bool gained_only_gravity(const thud_world *w, td_awake_slot slot, double share) {
    const td_trajectory *f = td_trajectory_at(w, slot);
    const float *velocity = td_row(&w->velocity, slot), *delta = td_row(&w->delta, slot);
    const float *push = td_row(&w->push, slot);
    double n = w->substeps;
    bool free = true;
    for (int k = 0; k < 3 && free; k++) {
        double v1 = (double)velocity[k], gain = n * (double)push[k];
        double rounding = 0x1p-22 * n * (td_abs(f->motion[k]) + td_abs(gain));
        double tolerance = rounding + (k < 2 ? share : share / (double)td_row(&w->reach, slot)[1]);
        double deviation = (double)delta[k] / w->def.time_step - (v1 - 0.25 * gain);
        free = td_abs(v1 - f->motion[k] - gain) <= tolerance &&
               td_abs(deviation) <= 0.25 * td_abs(gain) + tolerance;
    }
    return free;
}

/* Sets the motion to that of the parabola that ends with the body's velocity. A body that was not
 * touched at all gets that velocity from the one before, without the roundings of the substeps. */
static void set_parabola(thud_world *w, td_awake_slot slot, bool touched) {
    td_trajectory *f = td_trajectory_at(w, slot);
    double dt = w->def.time_step;
    for (int axis = 0; axis < 2; axis++) {
        float *velocity = td_row(&w->velocity, slot) + axis;
        double gain = w->substeps * (double)td_row(&w->push, slot)[axis];
        if (!touched) {
            *velocity = (float)(f->motion[axis] + gain);
            gain = (double)*velocity - f->motion[axis];
        }
        f->fall[axis] = gain * dt;
        td_row(&w->delta, slot)[axis] = (float)((double)*velocity * dt - 0.5 * f->fall[axis]);
    }
}

/* What a joint gives may be little, and still be what keeps the joint whole. */
static bool is_joined(const thud_world *w, const td_body *body) {
    bool joined = false;
    for (int e = w->joint_hooks ? body->first_constraint : TD_NONE; e != TD_NONE && !joined;
         e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        joined = !td_is_contact(constraint) && constraint->state == TD_TOUCHING;
    }
    return joined;
}

void td_ballistics_set_parabolas(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory *f = td_trajectory_at(w, slot);
        const td_body *body = td_body_at(w, f->body);
        if (body->kind != THUD_DYNAMIC || body->detection->rank != TD_RANK_SWEPT ||
            w->skin == 0.0f) {
            continue;
        }
        const float *push = td_row(&w->push, slot);
        double x = (double)push[0], y = (double)push[1];
        double gain = w->substeps * __builtin_sqrt(x * x + y * y);
        /* A parabola steeper than the highest speed is not flown. */
        f->free = gain <= (double)(w->def.maximum_speed * w->unit) &&
                  gained_only_gravity(w, slot, FREE_SHARE_MAX * gain) && !is_joined(w, body);
        if (f->free && gain > 0.0) {
            set_parabola(w, slot, !gained_only_gravity(w, slot, 0.0));
        }
    }
}
