/* solve.c: the soft solver's order of passes: bounces, then the substeps, by one or more workers.
 *
 * The method is "soft step" (Catto, "Solver2D", 2024): each substep of length h
 *     1. integrates velocities (in the first substep td_begin_motion, then the warm start; in later
 *        ones td_integrate_velocity, which also carries the impulses over),
 *     2. solves contacts as soft constraints, with a bias that corrects overlaps,
 *     3. integrates positions,
 *     4. relaxes: solves again without bias.
 * wide_solve.h has the passes of contacts and their equations, joints/wide_*.c those of joints. The
 * stiffness is given as frequency over substep rate, so that contacts are stiffer with more
 * substeps.
 *
 * Workers take chunks of blocks. Blocks of one graph colour share no moving body, so that the
 * result does not depend on which worker solves which. */
#include "state/jobs.h"
#include "solver/error.h"
#include "solver/restitution.h"
#include "state/kinds.h"
#include "constraint/joint_hooks.h"
#include "constraint/chunks.h"
#include "api/step.h"

#include <string.h>

/* Pairs with a restitution of 1 or more bounce at lower speeds than restitution_threshold, but not
 * below ELASTIC_REST times g time_step, the speed that gravity gives in a step: otherwise a stack
 * of them would never come to rest. Chosen, as TD_BOUNCE_BORNE in bounces.h. */
#define ELASTIC_REST 4.0f

/* Sets the coefficients of a soft constraint (E. Catto, "Soft Constraints", GDC 2011; b2MakeSoft in
 * Box2D v3's src/solver.h): a spring and damper on the separation s, with angular frequency
 * omega = 2 pi hertz and damping ratio z. Its force on a row of effective mass m and speed v is
 *
 *     f = -m omega^2 s - 2 m z omega v.
 *
 * Implicit Euler takes both at the end of the substep, the speed v' and the separation s + h v':
 *
 *     p' = h f = -h m omega^2 s - m h omega (2 z + h omega) v'.
 *
 * Let a1 = 2 z + h omega and a2 = h omega a1. Division by m a2 gives the constraint
 *
 *     v' + bias_rate s + p' / (m a2) = 0  with  bias_rate = omega / a1.
 *
 * The velocities have the old impulse p already, so that v' = v + (p' - p) / m. This gives
 *
 *     p' - p = -m mass_scale (v + bias_rate s) - impulse_scale p
 *     with  mass_scale = a2 / (1 + a2)  and  impulse_scale = 1 / (1 + a2).
 *
 * `which`: 0 for pairs of moving bodies, 1 for contacts with a static body. h is in s. */
static void set_softness(td_solve_context *c, int which, float hertz, float damping, float h) {
    float omega = 2.0f * (float)TD_PI * hertz;
    float a1 = 2.0f * damping + h * omega;
    float a2 = h * omega * a1;
    float a3 = 1.0f / (1.0f + a2);
    c->bias_rate[which] = omega / a1;
    c->mass_scale[which] = a2 * a3;
    c->impulse_scale[which] = a3;
}

/* The constants that the passes of this step share: see td_solve_context for their meaning. h is
 * the length of a substep, s. */
static td_solve_context solve_context(const thud_world *w, float h) {
    float x = w->def.gravity.x, y = w->def.gravity.y, time = (float)w->def.time_step;
    float gravity_speed = __builtin_sqrtf(x * x + y * y) * time; /* gained in a step */
    td_solve_context c = {
        .velocity = w->velocity.data,
        .delta = w->delta.data,
        .substep_gain = w->substep_gain.data,
        .inv_h = 1.0f / h,
        .substeps = (float)w->substeps,
        .bounce_time = time + h,
        .push_speed = w->def.push_speed * w->length_scale,
        .joint_closing_speed = TD_JOINT_CLOSING_SPEED * w->length_scale,
        .bounce_speed = -w->def.restitution_threshold * w->length_scale,
        .fall = gravity_speed * time,
    };
    c.elastic_speed = td_max_float(c.bounce_speed, -ELASTIC_REST * gravity_speed);
    c.keep_tangents = w->tells || w->islands.adds_up;
    c.keep_totals = c.keep_tangents || w->adds_impulses;
    c.bounces = td_has_bounces(w);
    c.surface_speeds = w->surface_speeds > 0;
    c.passes_over = w->islands.passes_over;
    /* Contacts with static bodies have twice the frequency, as in Box2D, so that bodies are not
     * pressed into the ground by what lies on them. */
    float hertz = w->quality.contact_stiffness / h;
    set_softness(&c, 0, hertz, w->quality.contact_damping, h);
    set_softness(&c, 1, 2.0f * hertz, w->quality.contact_damping, h);
    return c;
}

/* Returns x, or not-a-number for an infinite x: the velocity clamp would make infinity a finite
 * speed, but keeps not-a-number, by which finalize.c finds the body. */
static float infinity_to_nan(float x) {
    return x + (x - x);
}

void td_solve_begin(thud_world *w) {
    float h = (float)(w->def.time_step / w->substeps);
    if (!w->substep_gain_stale) {
        return;
    }
    w->substep_gain_stale = false;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_body *body = td_body_at(w, td_body_of(w, slot));
        float *substep_gain = td_row(&w->substep_gain, slot);
        memset(substep_gain, 0, sizeof(float[4]));
        if (body->kind == THUD_BODY_DYNAMIC) {
            const float *force = body->force;
            float scale = body->gravity_scale, inv_mass = body->inv_mass;
            substep_gain[0] = infinity_to_nan(h * (w->def.gravity.x * scale + force[0] * inv_mass));
            substep_gain[1] = infinity_to_nan(h * (w->def.gravity.y * scale + force[1] * inv_mass));
            substep_gain[2] = infinity_to_nan(h * force[2] * body->inv_inertia);
        }
        w->substep_gain_stale |=
            body->force[0] != 0.0f || body->force[1] != 0.0f || body->force[2] != 0.0f;
        memset(body->force, 0, sizeof body->force);
    }
}

/* ---- the passes ---- */

/* BRACE scales down the impulses of torn joints, whose gaps are too wide to close in a substep
 * (td_brace, brace). Contacts have no such pass. */
typedef enum pass { WARM_START, BRACE, SOLVE, RELAX, BOUNCE } pass;

/* The arguments of a solve. Each worker has a copy, whose fields from `worker` on are its own
 * state. */
typedef struct solving {
    thud_world *w;
    td_solve_context contacts;
    td_motion_context motion;
    td_tally_context tally;
    td_tally *tallies;      /* error statistics, by worker */
    const int *body_shares; /* of the passes over bodies, in chunks of body_chunk slots */
    int body_chunk;
    td_job *job;
    atomic_bool *bounced; /* a flag for each bounce pass: td_solve_context.bounced */
    atomic_flag *dummy;   /* a spin lock for the record of slot 0: see solve_in_turn */
    td_worker worker;
    pass which;            /* the present pass */
    const td_phase *phase; /* the present phase */
    td_bracing bracing;
} solving;

/* Solves the last blocks of a run. The last one may have empty lanes, which read the record of slot
 * 0 and write it back unchanged. Other runs of the same phase may end in such a block too, and two
 * workers must not write the same record: a lock lets only one worker at a time solve such a block.
 */
static void solve_in_turn(const solving *s, td_solve_fn *solve, td_block *const *blocks,
                          int count) {
    solve(blocks, count - 1, &s->contacts);
    while (atomic_flag_test_and_set_explicit(s->dummy, memory_order_acquire)) {
        td_pause();
    }
    solve(blocks + count - 1, 1, &s->contacts);
    atomic_flag_clear_explicit(s->dummy, memory_order_release);
}

/* Solves `count` blocks of a run; only the last block of a run may have empty lanes. */
TD_INLINE void solve_part(const solving *s, const td_run *run, td_solve_fn *solve,
                          td_block *const *blocks, int count) {
    td_block *const *all = s->w->scratch.blocks.data;
    if (td_worker_shares(&s->worker) && blocks + count == all + run->first + run->count) {
        solve_in_turn(s, solve, blocks, count);
    } else {
        solve(blocks, count, &s->contacts);
    }
}

/* Solves blocks and adds their points to the error statistics, a few blocks at a time, while they
 * are in the cache. */
static void solve_and_tally(const solving *s, const td_run *run, td_solve_fn *solve,
                            td_block *const *blocks, int count) {
    int points = td_form_points(s->w->kinds[run->kind]->form);
    td_tally_fn *tally = s->w->error_hooks->tally[s->w->wide];
    for (int i = 0; i < count; i += TD_TALLY_BLOCKS) {
        int part = td_min_int(count - i, TD_TALLY_BLOCKS);
        solve_part(s, run, solve, blocks + i, part);
        tally(s->contacts.tally, blocks + i, part, points, &s->tally);
    }
}

/* The bounce pass of a run of contacts; null: joints do not bounce. */
static td_solve_fn *bounce_of(const thud_world *w, const td_run *run) {
    const td_restitution_hooks *hooks = w->restitution_hooks;
    bool two = td_form_points(w->kinds[run->kind]->form) == 2;
    return run->kind >= TD_PAIR_COUNT ? NULL
           : two                      ? hooks->two_points[w->wide]
                                      : hooks->one_point[w->wide];
}

/* Runs the present pass on one chunk. A kind of constraint that has no such pass is skipped. */
static void solve_chunk(void *work, int index) {
    const solving *s = work;
    const thud_world *w = s->w;
    const td_chunk *chunk = TD_AT(td_chunk, &w->scratch.chunks, index);
    const td_run *run = TD_AT(td_run, &w->scratch.runs, chunk->run);
    const td_constraint_ops *pair = w->kinds[run->kind];
    const td_solve_ops *ops = run->has_offsets ? pair->solve : pair->solve_centered;
    td_block *const *blocks = (td_block **)w->scratch.blocks.data + chunk->first;
    td_solve_fn *const *fns = s->which == WARM_START ? ops->warm_start
                              : s->which == BRACE    ? ops->brace
                              : s->which == SOLVE    ? ops->solve
                                                     : ops->relax;
    td_solve_fn *solve = s->which == BOUNCE ? bounce_of(w, run) : fns[run->a_static];
    if (!solve) {
        return;
    }
    if (s->which == RELAX && s->contacts.last && !s->contacts.again && run->kind < TD_PAIR_COUNT &&
        w->error_hooks) {
        solve_and_tally(s, run, solve, blocks, chunk->count);
    } else {
        solve_part(s, run, solve, blocks, chunk->count);
    }
}

/* Runs the present pass on one part of the present phase (td_phase: the work between two points at
 * which workers wait for each other). A td_chunk_fn. */
static void solve_part_of_phase(void *work, int part) {
    const solving *s = work;
    td_phase_run(s->w, s->phase, part, solve_chunk, work);
}

/* Runs a pass over all blocks: with several workers phase by phase. */
static void walk(solving *s, pass which) {
    s->which = which;
    if (!td_worker_shares(&s->worker)) {
        for (int i = 0; i < s->w->scratch.chunks.count; i++) {
            solve_chunk(s, i);
        }
        return;
    }
    for (int i = 0; i < s->w->scratch.phases.count; i++) {
        s->phase = TD_AT(td_phase, &s->w->scratch.phases, i);
        td_worker_take(&s->worker, s->phase->shares, solve_part_of_phase, s);
        td_worker_wait(&s->worker);
    }
}

/* Runs a pass over all bodies. */
static void walk_bodies(solving *s, td_chunk_fn *integrate) {
    if (!td_worker_shares(&s->worker)) {
        integrate(s, 0);
        return;
    }
    td_worker_take(&s->worker, s->body_shares, integrate, s);
    td_worker_wait(&s->worker);
}

/* The motion context of one chunk of bodies; a worker that is alone has them all in one. */
static td_motion_context part_of(const solving *s, int chunk) {
    td_motion_context part = s->motion;
    if (td_worker_shares(&s->worker)) {
        int first = chunk * s->body_chunk;
        part.velocity += first;
        part.delta += first;
        part.start += first;
        part.substep_gain += first;
        part.damping = part.damping ? part.damping + first : NULL;
        part.colours += first;
        part.count = td_min_int(part.count - first, s->body_chunk);
    }
    return part;
}

/* The three integrations, each for one chunk of bodies (td_chunk_fn): velocities of the first
 * substep, velocities of later ones, and positions. */
static void first_velocities(void *work, int chunk) {
    const solving *s = work;
    td_motion_context part = part_of(s, chunk);
    TD_PICK_WIDE(s->w, td_begin_motion)(&part);
}

static void velocities(void *work, int chunk) {
    const solving *s = work;
    td_motion_context part = part_of(s, chunk);
    TD_PICK_WIDE(s->w, td_integrate_velocity)(&part);
}

static void positions(void *work, int chunk) {
    const solving *s = work;
    td_motion_context part = part_of(s, chunk);
    TD_PICK_WIDE(s->w, td_integrate_position)(&part);
    if (s->contacts.last && part.bouncy) {
        s->w->restitution_hooks->end_flights[s->w->wide](&part);
    }
}

/* Runs bounce passes until one finds no pair that bounces, at most TD_BOUNCE_PASSES. Returns
 * whether any pair bounced. */
static bool bounce(solving *s) {
    int passes = 0;
    bool any = s->contacts.bounces;
    while (any && passes < TD_BOUNCE_PASSES) {
        s->contacts.bounce = passes ? TD_BOUNCE_AGAIN : TD_BOUNCE_FIRST;
        s->contacts.bounced = &s->bounced[passes++];
        walk(s, BOUNCE);
        any = atomic_load_explicit(s->contacts.bounced, memory_order_relaxed);
    }
    return passes > 1;
}

/* Runs a pass of bracing (td_bracing.pass). */
static void brace_pass(void *solver, td_brace stage) {
    solving *s = solver;
    s->contacts.brace = stage;
    walk(s, BRACE);
}

/* Bracing (joints/joint_brace.c), in steps whose warm start found a torn joint (flag_torn). Returns
 * whether it may have changed impulses. */
static bool brace(solving *s, bool relaxed) {
    s->bracing.first = s->contacts.first;
    s->bracing.relaxed = relaxed;
    return atomic_load_explicit(s->contacts.torn, memory_order_relaxed) &&
           s->w->joint_hooks->brace(&s->bracing);
}

/* A second relax pass of the substep, after bracing: corrects the errors in the rows' speeds that
 * bracing has left by taking impulses away. */
static void relax_again(solving *s) {
    s->contacts.again = true;
    walk(s, RELAX);
    s->contacts.again = false;
}

/* Runs all passes of the step, as one worker of the task (a thud_task_fn). All workers run the same
 * passes in the same order, and wait for each other at the end of each phase. */
static void run_passes(void *argument) {
    solving own = *(const solving *)argument, *s = &own;
    s->worker = td_worker_arrive(s->job);
    s->bracing.worker = &s->worker;
    s->bracing.solver = s;
    int last = s->w->substeps - 1;
    s->contacts.tally = &s->tallies[s->worker.index];
    bool bounced = bounce(s);
    for (int i = 0; i <= last; i++) {
        s->contacts.first = i == 0;
        walk_bodies(s, i ? velocities : first_velocities);
        if (i == 0) {
            walk(s, WARM_START);
        }
        brace(s, false);
        walk(s, SOLVE);
        s->contacts.last = i == last;
        walk_bodies(s, positions);
        walk(s, RELAX);
        if (brace(s, true)) {
            relax_again(s);
        }
    }
    if (bounced) {
        s->contacts.bounce = TD_BOUNCE_LAST;
        /* A worker that is late may still read the flag of the previous pass. */
        s->contacts.bounced = &s->bounced[TD_BOUNCE_PASSES];
        walk(s, BOUNCE);
    }
}

/* Fills the context, runs the passes by all workers, and adds up their error statistics. */
void td_solve(thud_world *w) {
    td_tally tallies[THUD_WORKERS_MAX];
    atomic_bool bounced[TD_BOUNCE_PASSES + 1] = {false}, torn = false;
    atomic_bool adds[2 * THUD_SUBSTEPS_MAX] = {false};
    atomic_flag dummy = ATOMIC_FLAG_INIT;
    float h = (float)(w->def.time_step / w->substeps);
    int body_shares[THUD_WORKERS_MAX + 1];
    td_job job;
    td_job_begin(&job, td_workers_for_bodies(w));
    solving s = {
        .w = w,
        .contacts = solve_context(w, h),
        .motion = {.velocity = w->velocity.data,
                   .delta = w->delta.data,
                   .start = w->start.data,
                   .substep_gain = w->substep_gain.data,
                   .damping = w->damped ? w->damping.data : NULL,
                   .bouncy = td_has_bounces(w),
                   .colours = w->colours.data,
                   .count = w->body_of.count,
                   .substeps = w->substeps,
                   .h = h,
                   .max_speed = w->def.maximum_speed * w->length_scale},
        .tally = {.skin = w->skin, .overlap = td_overlap_depth_min(w), .to_fixed = w->to_fixed},
        .bracing = {.w = w, .pass = brace_pass, .adds = adds},
        .tallies = tallies,
        .job = &job,
        .bounced = bounced,
        .dummy = &dummy,
    };
    s.contacts.torn = &torn;
    if (td_job_is_shared(&job)) {
        td_share_bodies(w, job.workers, body_shares);
        s.body_shares = body_shares;
        s.body_chunk = td_body_chunk(w, job.workers);
    }
    memset(tallies, 0, (size_t)job.workers * sizeof *tallies);
    if (w->error_hooks) {
        w->error_hooks->begin(w);
    }
    td_job_run(w, &job, run_passes, &s);
    for (int i = 0; i < job.workers && w->error_hooks; i++) {
        w->error_hooks->add(w, &tallies[i]);
    }
}
