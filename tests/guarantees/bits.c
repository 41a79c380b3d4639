/* bits.c: guarantees of determinism: two worlds that differ only in what must not matter
 * (broadphase, instruction set, workers, a shift, a restore, queries in between, the caller's
 * rounding mode, the frame rate) have the same bits after each step. Most compare yard_told
 * (yard.h), which also covers the events, the errors (thud_step_error) and the statistics of the
 * step. */
#include "guarantee.h"
#include "yard.h"

#include <fenv.h>
#include <thud/thud_casts.h>
#include <thud/thud_draw.h>
#include <thud/thud_joint.h>
#include <thud/thud_prediction.h>
#include <thud/thud_queries.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_testing.h>

enum { STEPS = 40 }; /* of each run. Chosen. */

/* Runs the trial's yard beside a second one that has another def, or that is shifted by `away`
 * internal length units (trial_unit) to the right and upwards; reports the first step after which
 * the digests of what the worlds report (yard_told) differ. */
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

/* Compares the trial's broadphase with each of the others. */
static void same_bits_any_broadphase(trial *t) {
    int count = dimensions[BROADPHASE].count;
    for (int i = 1; i < count; i++) {
        settings other = *t->set;
        other.value[BROADPHASE] = (other.value[BROADPHASE] + i) % count;
        thud_world_def def = trial_def(t);
        def.broadphase = settings_broadphase(&other);
        compare(t, def, 0);
    }
}

static void same_bits_baseline_simd(trial *t) {
    thud_world_def def = trial_def(t);
    thud_world_def_set_baseline_simd(&def, true);
    compare(t, def, 0);
}

/* 10^7 units is the largest shift that is promised (docs/features.md). The second shift goes the
 * other way, by an odd number of units. */
static void same_bits_far_away(trial *t) {
    compare(t, trial_def(t), 1e7);
    compare(t, trial_def(t), -9999999);
}

static void same_bits_twice(trial *t) {
    compare(t, trial_def(t), 0);
}

/* ---- workers ---- */

/* Columns of two boxes. */
enum { COLUMNS = 1050, FIELD_STEPS = STEPS / 4 };

/* A world of COLUMNS pairs of stacked boxes on a floor. The trial's source of random numbers is
 * reset, so that each call makes the same scene. */
static thud_world *make_field(trial *t, int workers) {
    source start = t->random;
    thud_world_def def = trial_def(t);
    def.job_system = trial_jobs(workers);
    thud_world *world = trial_make(t, def);
    if (world) {
        trial_wall(t, world, 0, -1, COLUMNS, 1);
        for (int i = 0; i < COLUMNS; i++) {
            double x = (i - COLUMNS / 2) * 1.5;
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

/* One worker beside two, the numbers that trials have. The worlds are no yards, which have too few
 * blocks for more than a chunk of each colour. */
static void same_bits_any_workers(trial *t) {
    long before = trial_shared_runs();
    thud_world *one = make_field(t, 1), *two = make_field(t, 2);
    for (int i = 1; i <= FIELD_STEPS && !trial_failed(t); i++) {
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
        trial_fault(t, "no step ran on two workers");
    }
}

/* ---- snapshots ---- */

/* Runs STEPS steps, and stores yard_told after each. */
static void run_and_record(yard *y, uint64_t told[STEPS]) {
    for (int i = 0; i < STEPS && !trial_failed(y->t); i++) {
        yard_step(y);
        told[i] = yard_told(y);
    }
}

/* Runs on from a snapshot three times: at first, after a restore in the world itself, and after one
 * in a second world, which has baseline SIMD and another number of workers. */
static void same_bits_after_restore(trial *t) {
    yard y, at_snapshot;
    uint64_t first[STEPS] = {0}, again[STEPS] = {0};
    thud_world_def def = trial_def(t);
    yard_make(&y, t, def, 0);
    for (int i = 0; i < STEPS / 2; i++) {
        yard_step(&y);
    }
    thud_world_def_set_baseline_simd(&def, true);
    def.job_system = trial_jobs(settings_workers(t->set) == 1 ? 2 : 1);
    thud_world *other = trial_make(t, def);
    DO(t, thud_world_use_joints(other)); /* needed before a snapshot with joints is restored */
    at_snapshot = y;
    trial_bytes s = trial_snapshot(t, y.world);
    run_and_record(&y, first);
    for (int i = 0; i < 2 && !trial_failed(t); i++) {
        thud_world *world = i ? other : y.world;
        DO(t, thud_world_restore(world, s.bytes, s.size));
        y = at_snapshot;
        y.world = world;
        run_and_record(&y, again);
        if (memcmp(first, again, sizeof first) != 0) {
            trial_fault(t, "steps differ after a restore in %s",
                        i ? "another world" : "the same world");
        }
    }
    free(s.bytes);
}

/* ---- rounding modes, queries and thud_world_advance ---- */

/* The caller's rounding mode changes from step to step. */
static void same_bits_any_rounding_mode(trial *t) {
    static const int modes[] = {
#ifdef FE_UPWARD
        FE_UPWARD,
#endif
#ifdef FE_DOWNWARD
        FE_DOWNWARD,
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

/* A query callback that continues with the next shape. */
static bool visit_shape(thud_shape_id shape, void *context) {
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

/* Reads the contacts, the volume and the shape of each body, and the point of the shape that is
 * closest to the middle of the yard. */
static void read_bodies(yard *y) {
    trial *t = y->t;
    for (int i = 0; i < YARD_BODIES; i++) {
        thud_manifold contacts[4];
        thud_shape_id shape = {0, 0};
        thud_volume volume;
        thud_closest_hit hit;
        int count = 0;
        DO(t, thud_body_get_contacts(y->world, y->body[i], contacts, 4, &count));
        DO(t, thud_body_get_volume(y->world, y->body[i], THUD_SHAPE_AABB, yard_origin(y), &volume));
        DO(t, thud_body_get_shapes(y->world, y->body[i], &shape, 1, &count));
        DO(t, thud_shape_closest_point(y->world, shape, trial_place(t, 0, 2), &hit));
    }
}

/* Calls read-only functions of each group: queries, poses, measures, drawing, snapshots. What the
 * world reports of the last step must stay the same. */
static void read_world(yard *y) {
    trial *t = y->t;
    double limit;
    thud_ray_hit hits[4];
    thud_prediction ahead[4];
    int count;
    thud_debug_draw draw = {.flags = ~0u, .line = draw_nothing};
    uint64_t told = yard_told(y);
    draw.lower = trial_place(t, -8, -2);
    draw.upper = trial_place(t, 8, 12);
    DO(t,
       thud_world_cast_ray_all(y->world, &(thud_ray){trial_place(t, -4, 2), 8 * t->scale, 0, NULL},
                               hits, 4, &count));
    DO(t, thud_world_overlap_shape(y->world, trial_place(t, 0, 2),
                                   thud_circle_at(0, 0, 2 * t->scale), NULL, visit_shape, NULL));
    DO(t, thud_world_extrapolate_awake(y->world, 0.3, ahead, 4, &count));
    DO(t, thud_world_predict(y->world, y->body, 2, 0.3, ahead));
    DO(t, thud_world_get_bisection_limit(y->world, &limit));
    DO(t, thud_world_draw(y->world, &draw));
    read_bodies(y);
    thud_poses_of(y->world, (thud_pos){0, 0}, 0.5, &count);
    thud_measure_of(y->world);
    free(trial_snapshot(t, y->world).bytes);
    if (yard_told(y) != told) {
        trial_fault(t, "reading the world changes what it reports of the last step");
    }
}

enum { EDITS = 3 }; /* before each step, beside those of yard_step */

/* The second yard is read before and after each edit; the first time before any step, when its
 * bodies, shapes and joints have just been created. */
static void same_bits_asked_or_not(trial *t) {
    yard one, other;
    yard_make(&one, t, trial_def(t), 0);
    yard_make(&other, t, trial_def(t), 0);
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        read_world(&other);
        for (int k = 0; k < EDITS; k++) {
            yard_edit(&one);
            yard_edit(&other);
            read_world(&other);
        }
        yard_step(&one);
        yard_step(&other);
        if (yard_told(&one) != yard_told(&other)) {
            trial_fault(t, "step %d differs", i);
        }
    }
}

/* Bound of the steps that the following calls of thud_world_advance may make, which never need more
 * than four; and tolerance of the time that they keep, in steps, for the rounding of sums. Chosen.
 */
enum { STEPS_PER_CALL_MAX = 8 };
#define KEPT_TIME_TOLERANCE 1e-6

/* thud_world_advance, called at random intervals of up to three steps, makes the same steps as
 * thud_world_step, and as many as fit into the time that has passed; alpha is the rest. */
static void same_bits_in_advance(trial *t) {
    yard one, other;
    int made = 0, stepped = 0, steps = 0; /* by `one`, by `other`, by the last call */
    double alpha = 0, passed = 0;         /* both in steps */
    yard_make(&one, t, trial_def(t), 0);
    yard_make(&other, t, trial_def(t), 0);
    while (made < STEPS && !trial_failed(t)) {
        double elapsed = trial_draw(t, 0, 3) * t->step;
        DO(t, thud_world_advance(one.world, elapsed, STEPS_PER_CALL_MAX, &steps, &alpha));
        if (!(alpha >= 0 && alpha < 1)) {
            trial_fault(t, "alpha is %g", alpha);
        }
        made += steps;
        passed += elapsed / t->step;
        if (fabs(made + alpha - passed) > KEPT_TIME_TOLERANCE) {
            trial_fault(t, "%d steps were made, and %g are left, of %g", made, alpha, passed);
        }
        for (; stepped < made; stepped++) {
            trial_run(t, other.world, 1);
        }
        if (thud_hash_of(one.world) != thud_hash_of(other.world)) {
            trial_fault(t, "step %d differs", made);
        }
    }
}

/* ---- a program that calls thud_world_advance once a frame ---- */

/* A program with a yard, and two more balls that it pushes. */
typedef struct program {
    yard y;
    /* The balls get a force once a frame, so that no edit may change them: edits are made once a
     * step, and at another frame rate would come between other forces. */
    thud_body_id pushed[2];
    int steps_made;
    uint64_t told[STEPS]; /* yard_told after each step */
    long events;          /* number of events that it has read, after each frame */
} program;

/* The callback of thud_world_advance_with before each step: edits, and a force that varies with the
 * step. */
static void before_step(thud_world *world, void *context) {
    program *p = context;
    thud_vec2 force = {0, (float)(p->steps_made % 7)};
    yard_before_step(&p->y);
    DO(p->y.t, thud_body_apply_center_force(world, p->y.body[0], force));
    DO(p->y.t, thud_body_apply_torque(world, p->y.body[0], 0.5f));
}

/* The callback after each step: stores yard_told, and applies a force for the next step, which
 * depends on the events of this one. */
static void after_step(thud_world *world, void *context) {
    program *p = context;
    thud_vec2 force = {(float)thud_events_of(world).begin_count, 1};
    p->told[p->steps_made++] = yard_told(&p->y);
    DO(p->y.t, thud_body_apply_center_force(world, p->y.body[1], force));
}

static void start_program(program *p, trial *t) {
    *p = (program){.steps_made = 0};
    yard_make(&p->y, t, trial_def(t), 0);
    for (int i = 0; i < 2; i++) {
        part ball = {.kind = THUD_BODY_DYNAMIC, .form = BALL, .x = 2 * i - 1, .y = 3, .hx = 0.3};
        p->pushed[i] = trial_add(t, p->y.world, ball);
    }
}

/* Pushes the balls, by the same forces before each frame. thud_world_advance applies them over the
 * whole time of the frame, also where that is a part of a step, or several steps: a step gets the
 * mean of the forces over its time, which here is the same in every step at any frame rate. */
static void before_frame(program *p) {
    for (int i = 0; i < 2; i++) {
        thud_vec2 force = {0.3f * (float)i, 1.1f};
        DO(p->y.t, thud_body_apply_center_force(p->y.world, p->pushed[i], force));
        DO(p->y.t, thud_body_apply_torque(p->y.world, p->pushed[i], 0.1f));
    }
}

/* Counts the events that the world reports: those of all steps of the frame. */
static void after_frame(program *p) {
    thud_events e = thud_events_of(p->y.world);
    p->events += e.begin_count + e.end_count + e.hit_count;
    p->events += e.sensor_begin_count + e.sensor_end_count;
}

/* A program that makes its steps by thud_world_step, one a frame, beside programs that advance by
 * the time of a frame. These also restore a snapshot after each frame: it contains the time left
 * over, the forces over that time, and the events. */
static void same_outcome_at_any_rate(trial *t) {
    /* Frames a second where a step is 1/60 s; a frame advances by 60 / rate steps. */
    static const double rates[] = {20, 30, 60, 144};
    program by_steps;
    start_program(&by_steps, t);
    while (by_steps.steps_made < STEPS && !trial_failed(t)) {
        before_frame(&by_steps);
        before_step(by_steps.y.world, &by_steps);
        DO(t, thud_world_step(by_steps.y.world));
        after_step(by_steps.y.world, &by_steps);
        after_frame(&by_steps);
    }
    for (int i = 0; i < 4 && !trial_failed(t); i++) {
        program by_frames;
        const thud_step_calls calls = {before_step, after_step, &by_frames};
        double elapsed = t->step * 60 / rates[i];
        start_program(&by_frames, t);
        while (by_frames.steps_made < STEPS && !trial_failed(t)) {
            thud_world *world = by_frames.y.world;
            before_frame(&by_frames);
            DO(t, thud_world_advance_with(world, elapsed, STEPS - by_frames.steps_made, &calls,
                                          NULL, NULL));
            trial_bytes s = trial_snapshot(t, world);
            DO(t, thud_world_restore(world, s.bytes, s.size));
            free(s.bytes);
            after_frame(&by_frames);
        }
        if (memcmp(by_frames.told, by_steps.told, sizeof by_steps.told) != 0) {
            trial_fault(t, "steps differ at %g frames a second", rates[i]);
        }
        if (by_frames.events != by_steps.events) {
            trial_fault(t, "%ld events at %g frames a second, of %ld", by_frames.events, rates[i],
                        by_steps.events);
        }
    }
}

const guarantee guarantees_of_bits[] = {
    GUARANTEE(same_bits_any_broadphase),
    GUARANTEE(same_bits_any_rounding_mode),
    GUARANTEE(same_bits_any_workers),
    GUARANTEE(same_bits_after_restore),
    GUARANTEE(same_bits_asked_or_not),
    GUARANTEE(same_bits_baseline_simd),
    GUARANTEE(same_bits_far_away),
    GUARANTEE(same_bits_in_advance),
    GUARANTEE(same_bits_twice),
    GUARANTEE(same_outcome_at_any_rate),
    {.name = NULL},
};
