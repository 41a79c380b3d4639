/* test_joints_energy.c: at high and exact, whose substeps are of second order, spinning and
 * swinging mechanisms keep their energy, also where their joints have limits and motors that do not
 * act. At no quality do bridges and ropes whose joints give way gain energy as their gaps close. */
#include "joint_support.h"

#include <thud/thud_detection.h>

static const thud_vec2 middle = {0, 0};
static const thud_quality *const second_order[] = {&thud_quality_high, &thud_quality_exact};

static thud_world *calm_world(const thud_quality *quality, float gravity) {
    thud_world_def def = def_of(quality);
    def.gravity = (thud_vec2){0, gravity};
    def.sleeping = false;
    /* `swept` bounds paths that are straight, and would change the motion */
    def.detection = &thud_detection_overlap;
    return make_world(def);
}

/* Three balls in a row, joined by rods or hinges, turn about the middle one. */
static void what_spins_goes_on_spinning(void **state) {
    (void)state;
    const double rates[] = {5, 40, 300}; /* rad/s; the last one is 5 rad a step */
    for (int i = 0; i < 2 * 2 * 3; i++) {
        bool rods = i % 2;
        double rate = rates[i / 4];
        thud_world *world = calm_world(second_order[i / 2 % 2], 0);
        thud_body_id ball[3];
        for (int k = 0; k < 3; k++) {
            double x = 0.6 * (k - 1);
            ball[k] = add_ball(world, x, 0, 0.2f);
            OK(thud_body_set_velocity(world, ball[k], (thud_vec2){0, (float)(rate * x)},
                                      rods ? 0 : (float)rate));
            if (k) {
                thud_joint_def def =
                    between(rods ? THUD_JOINT_DISTANCE : THUD_JOINT_HINGE, ball[k - 1], ball[k],
                            (thud_vec2){rods ? 0 : 0.3f, 0}, (thud_vec2){rods ? 0 : -0.3f, 0});
                def.length = 0.6f;
                make(world, def);
            }
        }
        double before = thud_measure_of(world).kinetic_energy;
        run(world, 200);
        near_to(thud_measure_of(world).kinetic_energy / before, 1, rate < 100 ? 1e-3 : 5e-3);
        near_to(thud_step_error_of(world).joint_gap_max, 0, 1e-5);
        thud_world_destroy(world);
    }
}

/* Limits that are not reached, and a motor with a negligible maximum force, take no energy. */
static void limits_and_idle_motors_take_no_energy(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        thud_world *world = calm_world(second_order[i % 2], -10);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id bar = add_box(world, 0.5, 0, 0.5f, 0.05f);
        thud_joint_def def = between(THUD_JOINT_HINGE, hook, bar, middle, (thud_vec2){-0.5f, 0});
        def.drive[THUD_DIRECTION_TURN].limited = true;
        def.drive[THUD_DIRECTION_TURN].lower = -3.14f;
        def.drive[THUD_DIRECTION_TURN].upper = 1;
        def.drive[THUD_DIRECTION_TURN].motor_force = i / 2 ? 1e-6f : 0;
        make(world, def);
        thud_measure start = thud_measure_of(world);
        double weight = 10 * state_of(world, bar).mass * 0.5;
        run(world, 600);
        thud_measure m = thud_measure_of(world);
        double change =
            m.kinetic_energy + m.potential_energy - start.kinetic_energy - start.potential_energy;
        near_to(change / weight, 0, 5e-3);
        thud_world_destroy(world);
    }
}

/* A row of planks, joined by hinges: level between two points, or from the first point alone, and
 * then with a weight of ten planks at its end. It sags as its hinges give way, and closing their
 * gaps lifts it. */
static thud_world *planks(const thud_quality *quality, const thud_detection *detection, int count,
                          bool bridge) {
    thud_world_def def = def_of(quality);
    def.gravity = (thud_vec2){0, -10};
    def.sleeping = false;
    def.detection = detection;
    thud_world *world = make_world(def);
    thud_body_id last = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    for (int i = 0; i < count; i++) {
        thud_body_id plank = add_box(world, 0.5 + i, 0, 0.5f, 0.125f);
        make(world, between(THUD_JOINT_HINGE, last, plank, (thud_vec2){i ? 0.5f : 0, 0},
                            (thud_vec2){-0.5f, 0}));
        last = plank;
    }
    thud_body_id end = bridge ? add_body(world, THUD_BODY_STATIC, count, 0, 0)
                              : add_box(world, count, 0, 0.5f, 1.25f);
    make(world, between(THUD_JOINT_HINGE, last, end, (thud_vec2){0.5f, 0}, middle));
    return world;
}

static void closing_gaps_adds_no_energy(void **state) {
    (void)state;
    static const thud_quality *const every[] = {&thud_quality_draft, &thud_quality_default,
                                                &thud_quality_high, &thud_quality_exact};
    static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                       &thud_detection_continuous,
                                                       &thud_detection_swept};
    for (int i = 0; i < 4 * 3 * 2 * 2; i++) {
        int count = i % 2 ? 10 : 30;
        thud_world *world = planks(every[i / 4 % 4], detections[i / 16], count, i / 2 % 2 == 0);
        double start = thud_measure_of(world).potential_energy, most = 0;
        for (int step = 0; step < 240; step++) {
            OK(thud_world_step(world));
            thud_measure m = thud_measure_of(world);
            most = fmax(most, m.kinetic_energy + m.potential_energy - start);
        }
        /* The energy that lifts all planks, of mass 0.25 each, by a hundredth of their length. */
        assert_true(most < 0.01 * 10 * 0.25 * count);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_spins_goes_on_spinning),
        cmocka_unit_test(limits_and_idle_motors_take_no_energy),
        cmocka_unit_test(closing_gaps_adds_no_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
