/* solve.c: the substeps.
 *
 * In each: integrate velocity and warm start, solve with bias, integrate position, relax. Contact
 * frequency rises with the substep rate, so that more substeps also make contacts stiffer. */
#include "kinds.h"
#include "lanes.h"
#include "step.h"

#include <string.h>

/* Soft constraint of Catto's "Soft Constraints" (2011) for frequency `hertz` and damping ratio. */
static void soften(td_solve_context *c, int which, float hertz, float damping, float h)
{
    float omega = 2.0f * (float)TD_PI * hertz;
    float a1 = 2.0f * damping + h * omega;
    float a2 = h * omega * a1;
    float a3 = 1.0f / (1.0f + a2);
    c->bias_rate[which] = omega / a1;
    c->mass_scale[which] = a2 * a3;
    c->impulse_scale[which] = a3;
}

static td_solve_context solve_context(const thud_world *w, float h)
{
    td_solve_context c = {
        .velocity = w->velocity.data,
        .delta = w->delta.data,
        .inv_h = 1.0f / h,
        .push_speed = w->def.push_speed * w->unit,
        .bounce_speed = w->def.restitution_threshold * w->unit,
    };
    c.keep_totals = w->def.epilogue != NULL || w->bouncy > 0;
    /* Against static bodies twice as stiff: nothing gives way there. */
    float hertz = w->def.contact_stiffness / h;
    soften(&c, 0, hertz, w->def.contact_damping, h);
    soften(&c, 1, 2.0f * hertz, w->def.contact_damping, h);
    return c;
}

/* Velocity gained a substep from gravity and forces; forces act through one step only. */
static void refresh_push(thud_world *w, float h)
{
    if (!w->push_stale) {
        return;
    }
    w->push_stale = false;
    for (int slot = 1; slot < w->body_of.count; slot++) {
        td_body *body = td_body_at(w, *(int *)td_at(&w->body_of, slot));
        float *push = td_row(&w->push, slot);
        memset(push, 0, sizeof(float[4]));
        if (body->kind == THUD_DYNAMIC) {
            push[0] = h * (w->def.gravity.x * body->gravity_scale + body->force[0] * body->inv_mass);
            push[1] = h * (w->def.gravity.y * body->gravity_scale + body->force[1] * body->inv_mass);
            push[2] = h * body->force[2] * body->inv_inertia;
        }
        w->push_stale |= body->force[0] != 0.0f || body->force[1] != 0.0f || body->force[2] != 0.0f;
        memset(body->force, 0, sizeof body->force);
    }
}

typedef enum pass { WARM_START, SOLVE, RELAX, BOUNCE } pass;

static void run(const thud_world *w, const td_solve_context *c, pass which)
{
    td_block **blocks = w->scratch.blocks.data;
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *r = td_at(&w->scratch.runs, i);
        const td_pair_ops *pair = w->pairs[r->kind];
        const td_solve_ops *ops = r->armed ? pair->solve : pair->solve_unarmed;
        td_solve_fn *const *fns = which == WARM_START ? ops->warm_start
                                  : which == SOLVE    ? ops->solve
                                  : which == RELAX    ? ops->relax
                                                      : ops->bounce;
        fns[r->fixed](blocks + r->first, r->count, c);
    }
}

void td_solve(thud_world *w)
{
    float h = (float)(w->def.time_step / w->substeps);
    refresh_push(w, h);
    memset(w->delta.data, 0, (size_t)w->body_of.count * sizeof(float[4]));
    td_solve_context c = solve_context(w, h);
    td_motion_context m = {
        .velocity = w->velocity.data,
        .delta = w->delta.data,
        .start = w->start.data,
        .push = w->push.data,
        .damping = w->damped ? w->damping.data : NULL,
        .count = w->body_of.count,
        .h = h,
        .max_speed = w->def.maximum_speed * w->unit,
        .max_turn = 0.25f * (float)TD_PI / h, /* an eighth of a turn a substep */
    };
    td_integrate_velocity_fn *velocity = TD_PICK_WIDE(w, td_integrate_velocity);
    td_integrate_position_fn *position = TD_PICK_WIDE(w, td_integrate_position);
    for (int i = 0; i < w->substeps; i++) {
        c.first = i == 0;
        velocity(&m, i == 0);
        if (i == 0) {
            run(w, &c, WARM_START);
        }
        run(w, &c, SOLVE);
        position(&m);
        run(w, &c, RELAX);
    }
    if (c.keep_totals) {
        run(w, &c, BOUNCE);
    }
}
