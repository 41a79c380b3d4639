/* bits.c: guarantees of determinism: two worlds that differ only in a setting that must not matter
 * (broadphase, instruction set, workers, a shift, a restore, queries in between) end with the same
 * bits, and report the same events, errors and statistics for each step. */
#include "guarantee.h"
#include "yard.h"

#include <fenv.h>
#include <fenv.h>
#include <thud/thud_casts.h>
#include <thud/thud_draw.h>
#include <thud/thud_joint.h>
#include <thud/thud_queries.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_testing.h>

enum { STEPS = 40 };

/* Runs the trial's yard (yard.h) beside a second one that has another def, or that stands `away`
 * units from the origin; reports the first step after which yard_told differs. */
static void compare(trial *t, thud_world_def def, double away) {
    yard one, other;
    yard_make(&one, t, trial_def(t), 0);
    yard_make(&other, t, def, away);
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        yard_step(&one);
        yard_step(&other);
        if (!trial_failed(t) && yard_told(&one) != yard_told(&other)) {
            trial_fault(t, "step %d differs", i);
        }
    }
}

static void same_bits_any_broadphase(trial *t) {
    static const thud_broadphase *const all[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                 &thud_broadphase_all};
    for (int i = 1; i < 3; i++) {
        thud_world_def def = trial_def(t);
        def.broadphase = all[(t->set->value[BROADPHASE] + i) % 3];
        compare(t, def, 0);
    }
}

static void same_bits_baseline_simd(trial *t) {
    thud_world_def def = trial_def(t);
    thud_world_def_set_baseline_simd(&def, true);
    compare(t, def, 0);
}

static void same_bits_far_away(trial *t) {
    compare(t, trial_def(t), 1e7);
    compare(t, trial_def(t), -9999999);
}

static void same_bits_twice(trial *t) {
    compare(t, trial_def(t), 0);
}

/* ---- workers: a step uses worker threads from 64 blocks of contacts on ---- */

enum { COLUMNS = 300 };

/* A world of COLUMNS pairs of stacked boxes on a floor, which makes enough blocks of contacts. The
 * trial's source of random numbers is reset, so that each call makes the same scene. */
static thud_world *make_field(trial *t, int workers) {
    source start = t->random;
    thud_world_def def = trial_def(t);
    def.job_system = trial_jobs(workers);
    thud_world *world = trial_make(t, def);
    if (world) {
        trial_wall(t, world, 0, -1, 400, 1);
        for (int i = 0; i < COLUMNS; i++) {
            double x = i * 1.5 - 225.0;
            trial_add(t, world,
                      (part){.kind = THUD_BODY_DYNAMIC,
                             .form = TURNED,
                             .x = x,
                             .y = 0.3,
                             .hx = 0.5,
                             .hy = 0.3});
            trial_add(t, world,
                      (part){.kind = THUD_BODY_DYNAMIC,
                             .form = TURNED,
                             .x = x,
                             .y = 0.91,
                             .hx = 0.4,
                             .hy = 0.3,
                             .vx = trial_draw(t, -1, 1),
                             .spin = trial_draw(t, -1, 1)});
        }
    }
    t->random = start;
    return world;
}

static void same_bits_any_workers(trial *t) {
    long before = trial_shared_runs();
    thud_world *one = make_field(t, 1), *two = make_field(t, 2);
    for (int i = 1; i <= 10 && !trial_failed(t); i++) {
        trial_run(t, one, 1);
        trial_run(t, two, 1);
        thud_step_error a = thud_step_error_of(one), b = thud_step_error_of(two);
        if (thud_hash_of(one) != thud_hash_of(two) || a.penetration_max != b.penetration_max ||
            a.penetration_mean != b.penetration_mean || a.residual != b.residual ||
            a.energy_change != b.energy_change || a.overlaps != b.overlaps) {
            trial_fault(t, "step %d differs", i);
        }
    }
    if (trial_shared_runs() == before) {
        trial_fault(t, "no step was shared");
    }
}

/* ---- snapshots ---- */

/* Runs STEPS steps, and stores yard_told after each. */
static void walk(yard *y, uint64_t told[STEPS]) {
    for (int i = 0; i < STEPS && !trial_failed(y->t); i++) {
        yard_step(y);
        told[i] = yard_told(y);
    }
}

/* Restores the snapshot in the world itself, and in a second one with baseline SIMD and another
 * number of workers. */
static void same_bits_after_restore(trial *t) {
    yard y, kept;
    uint64_t first[STEPS] = {0}, again[STEPS] = {0};
    thud_world_def def = trial_def(t);
    yard_make(&y, t, def, 0);
    for (int i = 0; i < STEPS / 2; i++) {
        yard_step(&y);
    }
    thud_world_def_set_baseline_simd(&def, true);
    def.job_system = trial_jobs(3 - settings_workers(t->set));
    thud_world *other = trial_make(t, def);
    DO(t, thud_world_use_joints(other));
    kept = y;
    trial_bytes s = trial_snapshot(t, y.world);
    walk(&y, first);
    for (int i = 0; i < 2 && !trial_failed(t); i++) {
        thud_world *world = i ? other : y.world;
        DO(t, thud_world_restore(world, s.bytes, s.size));
        y = kept;
        y.world = world;
        walk(&y, again);
        if (memcmp(first, again, sizeof first) != 0) {
            trial_fault(t, "%s goes another way", i ? "another world" : "the same world");
        }
    }
    free(s.bytes);
}

/* ---- rounding modes, queries and thud_world_advance ---- */

static void same_bits_any_rounding_mode(trial *t) {
    static const int modes[] = {
#ifdef FE_UPWARD
        FE_UPWARD,
#endif
#ifdef FE_TOWARDZERO
        FE_TOWARDZERO,
#endif
        FE_TONEAREST};
    yard one, other;
    int usual = fegetround();
    yard_make(&one, t, trial_def(t), 0);
    yard_make(&other, t, trial_def(t), 0);
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        yard_step(&one);
        yard_before_step(&other);
        fesetround(modes[(size_t)i % (sizeof modes / sizeof *modes)]);
        thud_result result = thud_world_step(other.world);
        fesetround(usual);
        DO(t, result);
        if (yard_told(&one) != yard_told(&other)) {
            trial_fault(t, "step %d differs", i);
        }
    }
}

/* A query callback that continues. */
static bool see(thud_shape_id shape, void *context) {
    (void)shape;
    (void)context;
    return true;
}

static void draw_nothing(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    (void)a;
    (void)b;
    (void)style;
    (void)context;
}

/* Reads everything that the API offers about each body. */
static void ask_of_bodies(yard *y) {
    trial *t = y->t;
    for (int i = 0; i < YARD_BODIES; i++) {
        thud_manifold contacts[4];
        thud_shape_id shape;
        thud_volume volume;
        thud_closest_hit hit;
        int count = 0;
        DO(t, thud_body_get_contacts(y->world, y->body[i], contacts, 4, &count));
        DO(t, thud_body_get_volume(y->world, y->body[i], THUD_SHAPE_AABB, yard_origin(y), &volume));
        DO(t, thud_body_get_shapes(y->world, y->body[i], &shape, 1, &count));
        DO(t, thud_shape_closest_point(y->world, shape, trial_place(t, 0, 2), &hit));
    }
}

/* Calls all queries, reports, drawing and snapshots; what the world reports of the last step must
 * stay the same. */
static void ask_much(yard *y) {
    trial *t = y->t;
    double limit;
    thud_ray_hit hits[4];
    int count;
    thud_debug_draw draw = {.flags = ~0u, .line = draw_nothing};
    uint64_t told = yard_told(y);
    draw.lower = trial_place(t, -8, -2);
    draw.upper = trial_place(t, 8, 12);
    DO(t,
       thud_world_cast_ray_all(y->world, &(thud_ray){trial_place(t, -4, 2), 8 * t->scale, 0, NULL},
                               hits, 4, &count));
    DO(t, thud_world_overlap_shape(y->world, trial_place(t, 0, 2),
                                   thud_circle_at(0, 0, 2 * t->scale), NULL, see, NULL));
    DO(t, thud_world_get_bisection_limit(y->world, &limit));
    DO(t, thud_world_draw(y->world, &draw));
    ask_of_bodies(y);
    thud_poses_of(y->world, (thud_pos){0, 0}, 0.5, &count);
    thud_measure_of(y->world);
    free(trial_snapshot(t, y->world).bytes);
    if (yard_told(y) != told) {
        trial_fault(t, "what is told changes as it is asked for");
    }
}

enum { EDITS = 3 };

/* The second yard is queried after each edit and before the first step, when its joints have just
 * been made. */
static void same_bits_asked_or_not(trial *t) {
    yard one, other;
    yard_make(&one, t, trial_def(t), 0);
    yard_make(&other, t, trial_def(t), 0);
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        ask_much(&other);
        for (int k = 0; k < EDITS; k++) {
            yard_edit(&one);
            yard_edit(&other);
            ask_much(&other);
        }
        yard_step(&one);
        yard_step(&other);
        if (yard_told(&one) != yard_told(&other)) {
            trial_fault(t, "step %d differs", i);
        }
    }
}

/* thud_world_advance, called at random intervals, makes the same steps as thud_world_step, and as
 * many as the time that has passed contains. */
static void same_bits_in_advance(trial *t) {
    yard one, other;
    int made = 0, stepped = 0, steps = 0;
    double alpha = 0, passed = 0;
    yard_make(&one, t, trial_def(t), 0);
    yard_make(&other, t, trial_def(t), 0);
    while (made < STEPS && !trial_failed(t)) {
        double elapsed = trial_draw(t, 0, 3) * t->step;
        DO(t, thud_world_advance(one.world, elapsed, 8, &steps, &alpha));
        if (!(alpha >= 0 && alpha < 1)) {
            trial_fault(t, "alpha is %g", alpha);
        }
        made += steps;
        passed += elapsed / t->step;
        if (fabs(made + alpha - passed) > 1e-6) {
            trial_fault(t, "%d steps and %g were made of %g", made, alpha, passed);
        }
        for (; stepped < made; stepped++) {
            trial_run(t, other.world, 1);
        }
        if (thud_hash_of(one.world) != thud_hash_of(other.world)) {
            trial_fault(t, "step %d differs", made);
        }
    }
}

/* ---- a program that calls thud_world_advance at a frame rate, beside one that makes each step
 * ---- */

typedef struct player {
    yard y;
    thud_body_id pulled[2]; /* bodies that no edit changes: edits come in steps, and these forces
                               come in frames */
    int made;
    uint64_t told[STEPS]; /* yard_told after each step */
    long events;          /* events counted by the program after each of its calls */
} player;

/* The callback of thud_world_advance before each step: edits, and a force that varies with the
 * step. */
static void before_step(thud_world *world, void *context) {
    player *p = context;
    yard_before_step(&p->y);
    thud_body_apply_center_force(world, p->y.body[0], (thud_vec2){0, (float)(p->made % 7)});
    thud_body_apply_torque(world, p->y.body[0], 0.5f);
}

/* Stores yard_told of the step, and applies a force for the next one. */
static void after_step(thud_world *world, void *context) {
    player *p = context;
    thud_events e = thud_events_of(world);
    p->told[p->made++] = yard_told(&p->y);
    thud_body_apply_center_force(world, p->y.body[1], (thud_vec2){(float)e.begin_count, 1});
}

/* Starts a game: a yard with two more balls, which forces pull. */
static void play(player *p, trial *t) {
    *p = (player){.made = 0};
    yard_make(&p->y, t, trial_def(t), 0);
    for (int i = 0; i < 2; i++) {
        part ball = {.kind = THUD_BODY_DYNAMIC, .form = BALL, .x = 2 * i - 1, .y = 3, .hx = 0.3};
        p->pulled[i] = trial_add(t, p->y.world, ball);
    }
}

/* Applies a force to each ball before a picture's steps. */
static void before_picture(player *p) {
    for (int i = 0; i < 2; i++) {
        thud_vec2 force = {0.3f * (float)i, 1.1f};
        DO(p->y.t, thud_body_apply_center_force(p->y.world, p->pulled[i], force));
        DO(p->y.t, thud_body_apply_torque(p->y.world, p->pulled[i], 0.1f));
    }
}

/* Counts the events of a picture's steps. */
static void after_picture(player *p) {
    thud_events e = thud_events_of(p->y.world);
    p->events += e.begin_count + e.end_count + e.hit_count;
    p->events += e.sensor_begin_count + e.sensor_end_count;
}

static void same_outcome_at_any_rate(trial *t) {
    static const double rates[] = {20, 30, 60, 144};
    player steps;
    play(&steps, t);
    while (steps.made < STEPS && !trial_failed(t)) {
        before_picture(&steps);
        before_step(steps.y.world, &steps);
        DO(t, thud_world_step(steps.y.world));
        after_step(steps.y.world, &steps);
        after_picture(&steps);
    }
    for (int i = 0; i < 4 && !trial_failed(t); i++) {
        player pictures;
        const thud_step_calls calls = {before_step, after_step, &pictures};
        play(&pictures, t);
        while (pictures.made < STEPS && !trial_failed(t)) {
            thud_world *world = pictures.y.world;
            before_picture(&pictures);
            DO(t, thud_world_advance_with(world, t->step * 60 / rates[i], STEPS - pictures.made,
                                          &calls, NULL, NULL));
            trial_bytes s = trial_snapshot(t, world);
            DO(t, thud_world_restore(world, s.bytes, s.size));
            free(s.bytes);
            after_picture(&pictures);
        }
        if (memcmp(pictures.told, steps.told, sizeof steps.told) != 0) {
            trial_fault(t, "steps differ at %g pictures a second", rates[i]);
        }
        if (pictures.events != steps.events) {
            trial_fault(t, "%ld events at %g pictures a second, of %ld", pictures.events, rates[i],
                        steps.events);
        }
    }
}

const guarantee guarantees_of_bits[] = {
    GUARANTEE(same_outcome_at_any_rate),
    GUARANTEE(same_bits_any_broadphase),
    GUARANTEE(same_bits_any_rounding_mode),
    GUARANTEE(same_bits_any_workers),
    GUARANTEE(same_bits_after_restore),
    GUARANTEE(same_bits_asked_or_not),
    GUARANTEE(same_bits_baseline_simd),
    GUARANTEE(same_bits_far_away),
    GUARANTEE(same_bits_in_advance),
    GUARANTEE(same_bits_twice),
    {.name = NULL},
};
