/* test_joints_crowd.c: many jointed bodies in one world: an island keeps its accuracy where another
 * one exhausts the direct solver's budget, an island without a solution is tried only now and then,
 * cars drive at every quality, and in a heap of ragdolls a finer quality is not worse than a
 * coarser one. */
#include "joint_wheel.h"

#include "build_thud.h"
#include "engine.h"
#include "joint_gaps.h"
#include "penetration.h"
#include "tied_scenes.h"

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum { DETECTIONS = 4 };

/* ---- beside an island that exhausts the budget ---- */

enum { CHAINS = 12, LINKS = 6, SWING_STEPS = 30 };

/* Adds chains that swing from level, far from the wheel; the last link is ten times as heavy as the
 * others. */
static void add_chains(thud_world *world, thud_joint_id *joints) {
    thud_shape_def alone = thud_default_shape_def();
    alone.filter.mask = 0;
    for (int chain = 0; chain < CHAINS; chain++) {
        double x = 200, y = 10.0 * chain;
        thud_body_id before = add_body(world, THUD_BODY_STATIC, x, y, 0);
        for (int i = 0; i < LINKS; i++) {
            alone.density = i == LINKS - 1 ? 10 : 1;
            thud_body_id link = add_body(world, THUD_BODY_DYNAMIC, x + i + 0.5, y, 0);
            add_shape(world, link, 0.5f, 0.1f, false, &alone);
            joints[chain * LINKS + i] =
                make(world, between(THUD_JOINT_HINGE, before, link, (thud_vec2){i ? 0.5f : 0, 0},
                                    (thud_vec2){-0.5f, 0}));
            before = link;
        }
    }
}

static double worst_gap(const thud_world *world, const thud_joint_id *joints, int count) {
    double worst = 0;
    for (int i = 0; i < count; i++) {
        worst = fmax(worst, joint_of(world, joints[i]).gap);
    }
    return worst;
}

/* At high and exact the chains' gaps stay below 1e-6 m beside the wheel. */
static void chains_hold_beside_a_wheel_that_takes_all_effort(void **state) {
    (void)state;
    for (int q = 2; q < QUALITIES; q++) {
        thud_world *world = world_at(qualities[q]);
        thud_joint_id joints[CHAINS * LINKS];
        double worst = 0;
        add_wheel(world);
        add_chains(world, joints);
        for (int i = 0; i < SWING_STEPS; i++) {
            run(world, 1);
            worst = fmax(worst, worst_gap(world, joints, CHAINS * LINKS));
        }
        thud_world_destroy(world);
        assert_true(worst < 1e-6);
    }
}

/* ---- islands without a solution ---- */

/* A ball of radius 0.5 in a slot 0.8 wide, with a bar hinged to it. The two walls push it in
 * opposite directions, which no velocity satisfies, so that the direct solver fails. */
static thud_world *jam(const thud_world_def *def) {
    thud_world *world = make_world(*def);
    for (int side = -1; side <= 1; side += 2) {
        add_shape(world, add_body(world, THUD_BODY_STATIC, 1.4 * side, 0, 0), 1, 2, false, NULL);
    }
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    thud_body_id bar = add_body(world, THUD_BODY_DYNAMIC, 0, -2, 0);
    add_shape(world, bar, 0.1f, 1, false, NULL);
    make(world, between(THUD_JOINT_HINGE, ball, bar, (thud_vec2){0, 0}, (thud_vec2){0, 2}));
    return world;
}

/* Of the next `count` steps, those in which a matrix was factored and the soft solution was used
 * all the same. */
static int vain_steps(thud_world *world, int count) {
    int vain = 0;
    for (int i = 0; i < count; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        vain += stats.soft_islands > 0 && stats.factorings > 0;
    }
    return vain;
}

/* In 240 steps the island without a solution is tried at most 24 times, also where its bodies could
 * sleep. */
static void what_is_jammed_is_tried_now_and_then(void **state) {
    (void)state;
    for (int q = 1; q < QUALITIES; q++) {
        for (int i = 0; i < 2 * DETECTIONS; i++) {
            thud_world_def def = def_of(qualities[q]);
            def.detection = detections[i / 2];
            def.sleeping = i % 2;
            thud_world *world = jam(&def);
            int vain = vain_steps(world, 240);
            thud_world_destroy(world);
            assert_true(vain <= 24);
        }
    }
}

/* Boxes fall on four bridges, which swing too widely for the budget of `default`. That shows after
 * two searches for the active set, of eight factorisations each: in the steps in which no island is
 * solved they cost 15 each on average, where an interior point made it 24. */
static void bridges_that_exceed_the_budget_are_given_up_early(void **state) {
    (void)state;
    enum { BRIDGES = 4 };
    scene s;
    scene_init(&s);
    fill_bridges(&s, BRIDGES);
    thud_body_id *bodies = calloc((size_t)s.body_count, sizeof *bodies);
    thud_world_def def = def_of(&thud_quality_default);
    thud_world *world;
    OK(scene_build_thud(&s, &def, &world, bodies, NULL));
    int64_t vain = 0, islands = 0;
    for (int i = 0; i < 600; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        if (stats.direct_islands == stats.soft_islands) {
            vain += stats.factorings;
            islands += stats.direct_islands;
        }
    }
    thud_world_destroy(world);
    free(bodies);
    scene_free(&s);
    assert_true(islands > 2 * BRIDGES);
    assert_true(vain <= 17 * islands);
}

/* ---- cars ---- */

enum { CARS = 3, CAR_BODIES = 3 };

/* The shortest distance that a car drives from standstill, in metres. */
static double least_way(engine_settings settings) {
    scene s;
    scene_init(&s);
    fill_cars(&s, CARS);
    engine_body bodies[1 + CARS * CAR_BODIES];
    void *world = engine_create(&engine_thud, &s, settings);
    double least = INFINITY;
    assert_non_null(world);
    for (int i = 0; i < 180; i++) {
        assert_true(engine_thud.step(world));
    }
    engine_thud.read(world, bodies);
    for (int i = 0; i < CARS; i++) {
        int chassis = 1 + CAR_BODIES * i;
        least = fmin(least, bodies[chassis].x - s.bodies[chassis].x);
    }
    engine_thud.destroy(world);
    scene_free(&s);
    return least;
}

/* Every car drives at least 6 m in 3 s, at every quality and detection. */
static void cars_drive_over_waves_of_the_ground(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        for (int i = 0; i < 2 * DETECTIONS; i++) {
            double way = least_way((engine_settings){.quality = qualities[q],
                                                     .detection = detections[i / 2],
                                                     .sleeping = i % 2});
            assert_true(way > 6);
        }
    }
}

/* ---- a heap of ragdolls ---- */

enum { DOLLS = 50, FALL_STEPS = 240, REST_STEPS = 30 };

/* How limbs of fifty ragdolls are caught depends on chance, so a measure of a finer quality may be
 * up to this factor above that of the next coarser one. Chosen; measured are factors of 0.3 to
 * 0.75. */
#define CHANCE 1.2

/* Indices of the measures of a heap; see fall(). */
enum { GAP, WIDEST, BEYOND, STUCK, OVERLAP, MEASURES };

/* Measures of the heap: the mean gap of all joints; means over steps of the widest gap, of the
 * greatest excess over a limit in rad, and of the deepest overlap; and the greatest excess over a
 * limit after the fall. */
static void fall(const thud_quality *quality, double measures[MEASURES]) {
    scene s;
    scene_init(&s);
    fill_ragdoll_heap(&s, DOLLS);
    engine_body *bodies = calloc((size_t)s.body_count, sizeof *bodies);
    penetration_meter *meter = penetration_meter_create(&s);
    void *world = engine_create(&engine_thud, &s, (engine_settings){.quality = quality});
    assert_true(bodies && meter && world);
    for (int i = 0; i < FALL_STEPS; i++) {
        joint_gaps gaps = {0};
        penetration deep = {0};
        assert_true(engine_thud.step(world));
        engine_thud.read(world, bodies);
        joint_gaps_sample(&s, bodies, &gaps);
        penetration_sample(meter, bodies, &deep);
        assert_int_equal(gaps.lost + deep.lost, 0);
        double beyond = gaps.worst.beyond_angle;
        measures[GAP] += joint_gaps_mean(&gaps) / FALL_STEPS;
        measures[WIDEST] += gaps.worst.length / FALL_STEPS;
        measures[BEYOND] += beyond / FALL_STEPS;
        measures[STUCK] = i < FALL_STEPS - REST_STEPS ? 0 : fmax(measures[STUCK], beyond);
        measures[OVERLAP] += deep.worst / FALL_STEPS;
    }
    penetration_meter_destroy(meter);
    engine_thud.destroy(world);
    free(bodies);
    scene_free(&s);
}

static void finer_qualities_hold_fifty_ragdolls_no_worse(void **state) {
    (void)state;
    double coarser[MEASURES];
    for (int q = 0; q < QUALITIES; q++) {
        double measures[MEASURES] = {0};
        fall(qualities[q], measures);
        for (int k = 0; k < MEASURES; k++) {
            assert_true(q == 0 || measures[k] <= CHANCE * coarser[k]);
            coarser[k] = measures[k];
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chains_hold_beside_a_wheel_that_takes_all_effort),
        cmocka_unit_test(what_is_jammed_is_tried_now_and_then),
        cmocka_unit_test(bridges_that_exceed_the_budget_are_given_up_early),
        cmocka_unit_test(cars_drive_over_waves_of_the_ground),
        cmocka_unit_test(finer_qualities_hold_fifty_ragdolls_no_worse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
