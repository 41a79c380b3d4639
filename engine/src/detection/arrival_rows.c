/* arrival_rows.c: see arrival_rows.h. td_arrival_rows_project computes the same as wide_project.c,
 * but one row at a time, since arrivals are few, and several may have the same body. */
#include "detection/arrival_rows.h"

#include "solver/friction.h"

/* The motion or velocity of b relative to a at the contact point, along (x, y). `a`, `b`: records
 * of motions, or of velocities. */
static float along(const td_arrival *r, const float *a, const float *b, float x, float y) {
    float px = b[0] - b[2] * r->by - a[0] + a[2] * r->ay;
    float py = b[1] + b[2] * r->bx - a[1] - a[2] * r->ax;
    return px * x + py * y;
}

/* Adds an impulse along (x, y) at the arm (rx, ry), times the inverse masses, to a body's record.
 * The record of a body with infinite mass does not change, even if the impulse is not finite: slot
 * 0 is shared by all static bodies. */
static void push_one(float *record, float inv_mass, float inv_inertia, float rx, float ry, float x,
                     float y) {
    if (inv_mass > 0.0f) {
        record[0] += inv_mass * x;
        record[1] += inv_mass * y;
        record[2] += inv_inertia * (rx * y - ry * x);
    }
}

/* Adds an impulse along (x, y) to the records of b, and its opposite to those of a. */
static void push(thud_world *w, const td_arrival *r, float *a, float *b, float x, float y) {
    float mass_a = td_row(&w->velocity, r->a)[3], mass_b = td_row(&w->velocity, r->b)[3];
    push_one(a, mass_a, r->inv_inertia[0], r->ax, r->ay, -x, -y);
    push_one(b, mass_b, r->inv_inertia[1], r->bx, r->by, x, y);
}

/* One step of projected Gauss-Seidel for one row, on motions or on velocities. `lack` is what is
 * still missing along the normal: how far (length), or how fast (length/s), b has to move away from
 * a beyond what the records say. With m the effective mass, the accumulated impulse p = *sum
 * becomes p' = max(0, p + m lack), and p' - p is applied to the records of both bodies. The sum is
 * clamped, not its change, so that an impulse that is too large becomes smaller again. */
static void correct(thud_world *w, const td_arrival *r, float *a, float *b, float *sum,
                    float lack) {
    float before = *sum;
    *sum = td_max_float(before + lack * r->mass, 0.0f);
    float change = *sum - before;
    push(w, r, a, b, change * r->nx, change * r->ny);
}

int td_arrival_rows_project(thud_world *w, const td_project_context *c) {
    int unfinished = 0;
    for (int i = 0; i < w->scratch.arrivals.count; i++) {
        td_arrival *r = TD_AT(td_arrival, &w->scratch.arrivals, i);
        float *a = td_row(&w->delta, r->a), *b = td_row(&w->delta, r->b);
        float gap = r->start + along(r, a, b, r->nx, r->ny), lack = r->gap_min - gap;
        if (!r->decided && (lack > 0.0f || r->motion > 0.0f)) {
            float *va = td_row(&w->velocity, r->a), *vb = td_row(&w->velocity, r->b);
            float closing = -along(r, va, vb, r->nx, r->ny);
            correct(w, r, a, b, &r->motion, c->over_relaxation * lack);
            correct(w, r, va, vb, &r->velocity, c->over_relaxation * closing);
            unfinished += lack > c->closing;
        }
    }
    return unfinished;
}

/* Applies friction to each row once: with the tangent t = (ny, -nx), its effective mass m_t and the
 * normal impulse p, the tangent impulse is clamp(-m_t slide, -friction p, friction p). */
void td_arrival_rows_rub(thud_world *w) {
    for (int i = 0; i < w->scratch.arrivals.count; i++) {
        td_arrival *r = TD_AT(td_arrival, &w->scratch.arrivals, i);
        if (r->velocity > 0.0f) {
            float *a = td_row(&w->velocity, r->a), *b = td_row(&w->velocity, r->b);
            float x = r->ny, y = -r->nx;
            float turn_a = r->ax * y - r->ay * x, turn_b = r->bx * y - r->by * x;
            float slide = along(r, a, b, x, y) - r->settings.surface_speed;
            float inverse_mass = a[3] + b[3] + r->inv_inertia[0] * turn_a * turn_a +
                                 r->inv_inertia[1] * turn_b * turn_b;
            float impulse_max =
                (float)td_friction_ratio((double)r->settings.friction, (double)slide) * r->velocity;
            float impulse = (float)td_clamp((double)(-slide / inverse_mass), (double)-impulse_max,
                                            (double)impulse_max);
            push(w, r, a, b, impulse * x, impulse * y);
            r->rubbed = impulse;
        }
    }
}
