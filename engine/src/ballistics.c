/* ballistics.c: see ballistics.h. Of swept bodies only: their impacts heed the parabola. */
#include "ballistics.h"

#include "flight.h"

/* What contacts gave a body is too little to bear it, if it is no more than this share of what gravity
 * gives in a step. */
#define LITTLE 0.0625

void td_ballistics_note(thud_world *w)
{
    for (int slot = 1; slot < w->body_of.count; slot++) {
        td_flight *f = td_flight_at(w, slot);
        const float *velocity = td_row(&w->velocity, slot);
        *f = (td_flight){.body = *(int *)td_at(&w->body_of, slot)};
        for (int k = 0; k < 3; k++) {
            f->motion[k] = (double)velocity[k];
        }
    }
}

/* What the solver did to a body beside gravity. */
typedef struct kick {
    double velocity[3], motion[3]; /* a second; a step */
} kick;

/* n substeps make of `push` alone v1 = v0 + n p, and the motion
 * d = h (v0 + p) + h (v0 + 2 p) + ... = n h v1 - h p n (n - 1) / 2. */
static kick kick_of(const thud_world *w, int slot, double *rounding)
{
    const td_flight *f = td_flight_at(w, slot);
    const float *velocity = td_row(&w->velocity, slot), *delta = td_row(&w->delta, slot);
    const float *push = td_row(&w->push, slot);
    double n = w->substeps, h = w->def.time_step / n;
    kick k;
    for (int axis = 0; axis < 3; axis++) {
        double v1 = (double)velocity[axis], gain = n * (double)push[axis];
        k.velocity[axis] = v1 - f->motion[axis] - gain;
        k.motion[axis] = (double)delta[axis] - h * (n * v1 - 0.5 * (n - 1.0) * gain);
        rounding[axis] = 0x1p-22 * n * (td_abs(f->motion[axis]) + td_abs(gain));
    }
    return k;
}

static bool is_small(const kick *k, const double *least, double share, double rim, double dt)
{
    bool small = true;
    for (int axis = 0; axis < 3; axis++) {
        double most = least[axis] + (axis < 2 ? share : share / rim);
        small &= td_abs(k->velocity[axis]) <= most && td_abs(k->motion[axis]) <= most * dt;
    }
    return small;
}

/* The parabola that ends with the body's velocity. Who was not touched at all gets that velocity from
 * the one before, without the roundings of the substeps. */
static void fly(thud_world *w, int slot, bool touched)
{
    td_flight *f = td_flight_at(w, slot);
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

void td_ballistics_fly(thud_world *w)
{
    double dt = w->def.time_step;
    for (int slot = 1; slot < w->body_of.count; slot++) {
        td_flight *f = td_flight_at(w, slot);
        const td_body *body = td_body_at(w, f->body);
        if (body->kind != THUD_DYNAMIC || body->detection->rank != TD_RANK_SWEPT ||
            w->skin == 0.0f) {
            continue;
        }
        const float *push = td_row(&w->push, slot);
        double gain = w->substeps * __builtin_sqrt((double)(push[0] * push[0] + push[1] * push[1]));
        double rounding[3], rim = (double)td_row(&w->reach, slot)[1];
        kick k = kick_of(w, slot, rounding);
        f->free = is_small(&k, rounding, LITTLE * gain, rim, dt);
        if (f->free) {
            fly(w, slot, !is_small(&k, rounding, 0.0, rim, dt));
        }
    }
}
