/* solve.c: bounces, then the substeps.
 *
 * In each: integrate velocity and warm start, solve with bias, integrate position, relax. Contact
 * frequency rises with the substep rate, so that more substeps also make contacts stiffer. */
#include "state/jobs.h"
#include "solver/error.h"
#include "state/kinds.h"
#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "api/step.h"

#include <string.h>

/* Pairs of restitution 1 that close in more slowly than so many times the speed that gravity gives
 * in a step do not bounce, or a stack of them would never come to rest. */
#define ELASTIC_REST 4.0f

/* Soft constraint of Catto's "Soft Constraints" (2011) for frequency `hertz` and damping ratio. */
static void soften(td_solve_context *c, int which, float hertz, float damping, float h) {
    float omega = 2.0f * (float)TD_PI * hertz;
    float a1 = 2.0f * damping + h * omega;
    float a2 = h * omega * a1;
    float a3 = 1.0f / (1.0f + a2);
    c->bias_rate[which] = omega / a1;
    c->mass_scale[which] = a2 * a3;
    c->impulse_scale[which] = a3;
}

static td_solve_context solve_context(const thud_world *w, float h) {
    float x = w->def.gravity.x, y = w->def.gravity.y, time = (float)w->def.time_step;
    float gained = __builtin_sqrtf(x * x + y * y) * time;
    td_solve_context c = {
        .velocity = w->velocity.data,
        .delta = w->delta.data,
        .push = w->push.data,
        .inv_h = 1.0f / h,
        .substeps = (float)w->substeps,
        .time_step = time,
        .push_speed = w->def.push_speed * w->unit,
        .joint_closing = TD_JOINT_CLOSING * w->unit,
        .bounce_speed = -w->def.restitution_threshold * w->unit,
        .fall = gained * time,
    };
    c.elastic_speed = td_max_float(c.bounce_speed, -ELASTIC_REST * gained);
    c.keep_tangents = w->tells || w->islands.adds_up;
    c.keep_totals = c.keep_tangents || w->adds_impulses;
    c.bounces = w->bouncy > 0;
    c.surface_speeds = w->surface_speeds > 0;
    /* Against static bodies twice as stiff: nothing gives way there. */
    float hertz = w->quality.contact_stiffness / h;
    soften(&c, 0, hertz, w->quality.contact_damping, h);
    soften(&c, 1, 2.0f * hertz, w->quality.contact_damping, h);
    return c;
}

/* Turns an infinite push into not-a-number, which no limit of speed can hide from finalize.c. */
static float told_apart(float push) {
    return push + (push - push);
}

/* Velocity gained a substep from gravity and forces; forces act through one step only. */
static void refresh_push(thud_world *w, float h) {
    if (!w->push_stale) {
        return;
    }
    w->push_stale = false;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_body *body = td_body_at(w, td_body_of(w, slot));
        float *push = td_row(&w->push, slot);
        memset(push, 0, sizeof(float[4]));
        if (body->kind == THUD_DYNAMIC) {
            const float *force = body->force;
            float scale = body->gravity_scale, inv_mass = body->inv_mass;
            push[0] = told_apart(h * (w->def.gravity.x * scale + force[0] * inv_mass));
            push[1] = told_apart(h * (w->def.gravity.y * scale + force[1] * inv_mass));
            push[2] = told_apart(h * force[2] * body->inv_inertia);
        }
        w->push_stale |= body->force[0] != 0.0f || body->force[1] != 0.0f || body->force[2] != 0.0f;
        memset(body->force, 0, sizeof body->force);
    }
}

/* ---- the passes ---- */

typedef enum pass { WARM_START, BRACE, SOLVE, RELAX, BOUNCE } pass;

/* What all workers share; and, in each worker's copy, where it is. */
typedef struct solving {
    thud_world *w;
    td_solve_context contacts;
    td_motion_context motion;
    td_tally_context tally;
    td_tally *tallies; /* by worker */
    td_job *task;
    atomic_bool *bounced; /* in each pass before the substeps, and in the last one */
    atomic_flag *dummy;   /* set while a worker may write slot 0 */
    td_worker worker;
    pass which;      /* of the pass that is being walked */
    int first_chunk; /* of its phase */
    bool relaxed;    /* after the relax pass of a substep */
} solving;

/* Solves blocks of which the last may have empty lanes. These read slot 0, and write it back as it
 * was, so that of such blocks of several runs in a phase the workers solve one at a time. */
static void solve_in_turn(const solving *s, td_solve_fn *solve, td_block *const *blocks,
                          int count) {
    solve(blocks, count - 1, &s->contacts);
    while (atomic_flag_test_and_set_explicit(s->dummy, memory_order_acquire)) {
        td_pause();
    }
    solve(blocks + count - 1, 1, &s->contacts);
    atomic_flag_clear_explicit(s->dummy, memory_order_release);
}

/* Only the last block of a run has empty lanes. */
static void solve_part(const solving *s, const td_run *run, td_solve_fn *solve,
                       td_block *const *blocks, int count) {
    td_block *const *all = s->w->scratch.blocks.data;
    if (s->worker.phase && blocks + count == all + run->first + run->count) {
        solve_in_turn(s, solve, blocks, count);
    } else {
        solve(blocks, count, &s->contacts);
    }
}

/* Blocks are tallied a few at a time, right after their pass, while they are in the cache. */
static void solve_and_tally(const solving *s, const td_run *run, td_solve_fn *solve,
                            td_block *const *blocks, int count) {
    int points = td_form_points(s->w->kinds[run->kind]->form);
    td_tally_fn *tally = &TD_PICK_WIDE(s->w, td_tally_points);
    for (int i = 0; i < count; i += TD_CHUNK_BLOCKS) {
        int part = td_min_int(count - i, TD_CHUNK_BLOCKS);
        solve_part(s, run, solve, blocks + i, part);
        tally(s->contacts.tally, blocks + i, part, points, &s->tally);
    }
}

static void solve_chunk(void *work, int index) {
    const solving *s = work;
    const thud_world *w = s->w;
    const td_chunk *chunk = TD_AT(td_chunk, &w->scratch.chunks, s->first_chunk + index);
    const td_run *run = TD_AT(td_run, &w->scratch.runs, chunk->run);
    const td_constraint_ops *pair = w->kinds[run->kind];
    const td_solve_ops *ops = run->armed ? pair->solve : pair->solve_unarmed;
    td_block *const *blocks = (td_block **)w->scratch.blocks.data + chunk->first;
    td_solve_fn *const *fns = s->which == WARM_START ? ops->warm_start
                              : s->which == BRACE    ? ops->brace
                              : s->which == SOLVE    ? ops->solve
                                                     : ops->relax;
    td_solve_fn *solve = s->which == BOUNCE ? ops->bounce : fns[run->fixed];
    if (!solve) {
        return;
    }
    if (s->which == RELAX && s->contacts.last && !s->contacts.again && run->kind < TD_PAIR_COUNT) {
        solve_and_tally(s, run, solve, blocks, chunk->count);
    } else {
        solve_part(s, run, solve, blocks, chunk->count);
    }
}

static const td_run *run_of_chunk(const thud_world *w, int chunk) {
    return TD_AT(td_run, &w->scratch.runs, TD_AT(td_chunk, &w->scratch.chunks, chunk)->run);
}

/* Chunks of one bin have no moving body in common and make a phase; a run that may share bodies
 * with others is one chunk, and a phase by itself. */
static int phase_end(const thud_world *w, int first) {
    const td_run *run = run_of_chunk(w, first);
    int end = first + 1;
    while (end < w->scratch.chunks.count && !td_run_is_single(run) &&
           run_of_chunk(w, end)->bin == run->bin && !td_run_is_single(run_of_chunk(w, end))) {
        end++;
    }
    return end;
}

static void walk(solving *s, pass which) {
    s->which = which;
    for (int first = 0; first < s->w->scratch.chunks.count;) {
        int end = phase_end(s->w, first);
        s->first_chunk = first;
        td_worker_walk(&s->worker, end - first, solve_chunk, s);
        first = end;
    }
}

/* Awake slots that a worker takes at once; alone it takes all. */
enum { BODIES = 512 };

static int bodies_at_once(const solving *s) {
    return s->worker.phase ? BODIES : s->motion.count;
}

/* The motion context of some of the bodies. */
static td_motion_context part_of(const solving *s, int chunk) {
    const td_motion_context *m = &s->motion;
    td_motion_context part = *m;
    int most = bodies_at_once(s), first = chunk * most;
    part.velocity += first;
    part.delta += first;
    part.start += first;
    part.push += first;
    part.damping = m->damping ? m->damping + first : NULL;
    part.count = td_min_int(m->count - first, most);
    return part;
}

static void first_velocities(void *work, int chunk) {
    const solving *s = work;
    td_motion_context part = part_of(s, chunk);
    memset(part.delta, 0, (size_t)part.count * sizeof *part.delta);
    TD_PICK_WIDE(s->w, td_integrate_velocity)(&part, true);
}

static void velocities(void *work, int chunk) {
    const solving *s = work;
    td_motion_context part = part_of(s, chunk);
    TD_PICK_WIDE(s->w, td_integrate_velocity)(&part, false);
}

static void positions(void *work, int chunk) {
    const solving *s = work;
    td_motion_context part = part_of(s, chunk);
    TD_PICK_WIDE(s->w, td_integrate_position)(&part);
}

/* Until nobody closes in fast any more; whether anybody did. */
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

static void judge(void *work, int chunk) {
    const solving *s = work;
    (void)chunk;
    bool adds = s->w->joint_hooks->adds_energy(s->w, s->relaxed);
    atomic_store_explicit(s->contacts.adds, adds, memory_order_relaxed);
}

static void weigh(void *work, int chunk) {
    const solving *s = work;
    (void)chunk;
    s->w->joint_hooks->weigh(s->w, s->relaxed);
}

static void brace_by(solving *s, td_brace stage) {
    s->contacts.brace = stage;
    walk(s, BRACE);
}

/* Keeps what joints that are torn gave in this substep from having added energy; false where it
 * surely did not. */
static bool brace(solving *s) {
    brace_by(s, TD_BRACE_AFTER);
    td_worker_walk(&s->worker, 1, judge, s);
    /* A worker that is late still reads this flag, so that each brace has its own. */
    bool adds = atomic_load_explicit(s->contacts.adds, memory_order_relaxed);
    s->contacts.adds++;
    if (adds) {
        brace_by(s, TD_BRACE_TAKE);
        brace_by(s, TD_BRACE_BEFORE);
        td_worker_walk(&s->worker, 1, weigh, s);
        brace_by(s, TD_BRACE_KEEP);
    }
    return adds;
}

static bool is_torn(const solving *s) {
    return atomic_load_explicit(s->contacts.torn, memory_order_relaxed);
}

/* After bracing: rows correct what they miss without what it took, which takes energy out. */
static void ease(solving *s) {
    s->contacts.again = true;
    walk(s, RELAX);
    s->contacts.again = false;
}

/* One worker's way through all substeps. */
static void substeps(void *argument) {
    solving own = *(const solving *)argument, *s = &own;
    s->worker = td_worker_arrive(s->task);
    int bodies = (s->motion.count + bodies_at_once(s) - 1) / bodies_at_once(s);
    int last = s->w->substeps - 1;
    s->contacts.tally = &s->tallies[s->worker.index];
    bool bounced = bounce(s);
    for (int i = 0; i <= last; i++) {
        s->contacts.first = i == 0;
        td_worker_walk(&s->worker, bodies, i ? velocities : first_velocities, s);
        if (i == 0) {
            walk(s, WARM_START);
        }
        if (is_torn(s)) {
            if (i > 0) {
                brace_by(s, TD_BRACE_GIVE);
            }
            brace(s);
        }
        walk(s, SOLVE);
        td_worker_walk(&s->worker, bodies, positions, s);
        s->contacts.last = i == last;
        walk(s, RELAX);
        s->relaxed = true;
        if (is_torn(s) && s->w->joint_hooks->gape(s->w) && brace(s)) {
            ease(s);
        }
        s->relaxed = false;
    }
    if (bounced) {
        s->contacts.bounce = TD_BOUNCE_LAST;
        /* Who comes late still asks how the passes before went. */
        s->contacts.bounced = &s->bounced[TD_BOUNCE_PASSES];
        walk(s, BOUNCE);
    }
}

void td_solve(thud_world *w) {
    td_tally tallies[THUD_WORKERS_MAX];
    atomic_bool bounced[TD_BOUNCE_PASSES + 1] = {false}, torn = false;
    atomic_bool adds[2 * THUD_SUBSTEPS_MAX] = {false};
    atomic_flag dummy = ATOMIC_FLAG_INIT;
    float h = (float)(w->def.time_step / w->substeps);
    refresh_push(w, h);
    td_job task = td_job_begin(w);
    solving s = {
        .w = w,
        .contacts = solve_context(w, h),
        .motion = {.velocity = w->velocity.data,
                   .delta = w->delta.data,
                   .start = w->start.data,
                   .push = w->push.data,
                   .damping = w->damped ? w->damping.data : NULL,
                   .count = w->body_of.count,
                   .h = h,
                   .max_speed = w->def.maximum_speed * w->unit},
        .tally = {.skin = w->skin, .overlap = td_error_overlap(w), .to_fixed = w->to_fixed},
        .tallies = tallies,
        .task = &task,
        .bounced = bounced,
        .dummy = &dummy,
    };
    s.contacts.torn = &torn;
    s.contacts.adds = adds;
    memset(tallies, 0, (size_t)task.workers * sizeof *tallies);
    td_error_begin(w);
    td_job_run(w, &task, substeps, &s);
    for (int i = 0; i < task.workers; i++) {
        td_error_add(w, &tallies[i]);
    }
}
