/* ballistics.c: see ballistics.h. Only bodies with the detection `swept` follow parabolas, since
 * only its times of impact take the curvature into account.
 *
 * With v0 and v1 the velocities at the start and the end of the step, dt its length and gain = v1 -
 * v0 what gravity and forces add, the path is
 *   x(s) = (v0 dt) s + (gain dt) s^2 / 2,   s in [0, 1]
 * so that the motion in the step is v1 dt - gain dt / 2, and `acceleration` is gain dt. */
#include "detection/ballistics.h"

#include "constraint/constraint.h"
#include "detection/trajectory.h"

#include <float.h>

/* A body is in free flight if contacts change its velocity by at most this share of what gravity
 * and forces add in a step. Chosen, 1/16: at 0, a contact that hardly pushes a body would make it
 * follow the polygon of the substeps instead of the parabola. At half and at twice this value the
 * number of impacts in the scenes platformer and circle_pit, swept, changes by at most 3 and 14 %.
 */
#define FREE_SHARE_MAX 0.0625

void td_ballistics_save_velocities(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory *f = td_trajectory_at(w, slot);
        const float *velocity = td_row(&w->velocity, slot);
        *f = (td_trajectory){.body = td_body_of(w, slot)};
        for (int k = 0; k < 3; k++) {
            f->before[k] = (double)velocity[k];
        }
    }
}

/* Whether gravity and forces alone changed the body's velocity, up to a deviation of `share`
 * (length/s) at its centre and, by rotation, at its max_extent. With n substeps of semi-implicit
 * Euler, v1 = v0 + gain, and motion / dt is v1 - gain (n - 1) / (2 n), which lies between v1 - gain
 * / 2 (n without bound) and v1 (n = 1). `rounding` allows two units of single precision (2^-23
 * each) a substep. Impulses of the caller may have made the velocity before the step infinite; the
 * solver clamps it then, and the path is no parabola. */
static bool gained_only_gravity(const thud_world *w, td_awake_slot slot, double share) {
    const td_trajectory *f = td_trajectory_at(w, slot);
    const float *velocity = td_row(&w->velocity, slot), *delta = td_row(&w->delta, slot);
    const float *substep_gain = td_row(&w->substep_gain, slot);
    double n = w->substeps;
    bool free = true;
    for (int k = 0; k < 3 && free; k++) {
        double v1 = (double)velocity[k], gain = n * (double)substep_gain[k];
        double rounding = 0x1p-22 * n * (td_abs(f->before[k]) + td_abs(gain));
        double tolerance = rounding + (k < 2 ? share : share / (double)td_row(&w->reach, slot)[1]);
        double deviation = (double)delta[k] / w->def.time_step - (v1 - 0.25 * gain);
        free = tolerance < (double)FLT_MAX && td_abs(v1 - f->before[k] - gain) <= tolerance &&
               td_abs(deviation) <= 0.25 * td_abs(gain) + tolerance;
    }
    return free;
}

/* Sets the motion to that of the parabola that ends with the body's velocity. Where contacts did
 * not change the velocity at all (`touched` is false), the velocity itself is computed anew as that
 * before the step plus the gain, without the rounding of the substeps. */
static void set_parabola(thud_world *w, td_awake_slot slot, bool touched) {
    td_trajectory *f = td_trajectory_at(w, slot);
    double dt = w->def.time_step;
    for (int axis = 0; axis < 2; axis++) {
        float *velocity = td_row(&w->velocity, slot) + axis;
        double gain = w->substeps * (double)td_row(&w->substep_gain, slot)[axis];
        if (!touched) {
            *velocity = (float)(f->before[axis] + gain);
            gain = (double)*velocity - f->before[axis];
        }
        f->acceleration[axis] = gain * dt;
        td_row(&w->delta, slot)[axis] =
            (float)((double)*velocity * dt - 0.5 * f->acceleration[axis]);
    }
}

/* Sets the acceleration of a body that no constraint acts on. The solver has moved such a body on
 * its exact path (wide_motion.c), so that its motion stays as it is; the acceleration is the change
 * of its velocity in the step, in which damping is included. */
static void set_acceleration(const thud_world *w, td_awake_slot slot) {
    td_trajectory *f = td_trajectory_at(w, slot);
    const float *velocity = td_row(&w->velocity, slot);
    for (int axis = 0; axis < 2; axis++) {
        f->acceleration[axis] = ((double)velocity[axis] - f->before[axis]) * w->def.time_step;
    }
}

/* Whether the body has a joint that acts. Such a body does not count as in free flight: even an
 * impulse that is below FREE_SHARE_MAX may be what keeps the joint closed. */
static bool is_joined(const thud_world *w, const td_body *body) {
    bool joined = false;
    for (int e = w->joint_hooks ? body->first_constraint : TD_NONE; e != TD_NONE && !joined;
         e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        joined = !td_is_contact(constraint) && constraint->state == TD_TOUCHING;
    }
    return joined;
}

void td_ballistics_set_parabolas(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory *f = td_trajectory_at(w, slot);
        const td_body *body = td_body_at(w, f->body);
        if (body->kind != THUD_BODY_DYNAMIC || body->detection->rank != TD_RANK_SWEPT ||
            w->skin == 0.0f) {
            continue; /* the skin is 0 where the world's own detection is not bisect or swept */
        }
        const float *substep_gain = td_row(&w->substep_gain, slot);
        double x = (double)substep_gain[0], y = (double)substep_gain[1];
        double gain = w->substeps * __builtin_sqrt(x * x + y * y);
        /* A gain above the maximum speed is clamped by the substeps, and there is no parabola. */
        f->free = gain <= (double)(w->def.maximum_speed * w->length_scale) &&
                  gained_only_gravity(w, slot, FREE_SHARE_MAX * gain) && !is_joined(w, body);
        if (!f->free || gain == 0.0) {
            continue;
        }
        if (td_is_unconstrained(w, slot)) {
            set_acceleration(w, slot);
        } else {
            set_parabola(w, slot, !gained_only_gravity(w, slot, 0.0));
        }
    }
}
