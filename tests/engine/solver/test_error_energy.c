/* test_error_energy.c: the change of energy that a step reports, against the energy before and
 * after. */
#include "error_support.h"

/* ---- energy ---- */

static void free_flight_changes_no_energy_at_all(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    for (int i = 0; i < 19; i++) {
        thud_body_id box = add_box(world, 3 * i, 0, 0.5f, 0.3f);
        OK(thud_body_set_velocity(world, box, (thud_vec2){(float)i, 7}, 3.3f));
    }
    for (int i = 0; i < 60; i++) {
        assert_true(error_of_step(world).energy_change == 0);
    }
    thud_world_destroy(world);
}

static void fall_changes_no_more_energy_than_the_integrator_loses(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.substeps = 4;
    thud_world *world = make_world(def);
    double mass = (double)state_of(world, add_ball(world, 0, 0, 0.5f)).mass;
    double h = def.time_step / 4, lost = 4 * 0.5 * mass * 10 * h * 10 * h; /* of Euler's substeps */
    for (int i = 0; i < 60; i++) {
        double before = energy_of(world), change = error_of_step(world).energy_change;
        double tolerance = 1e-6 * thud_measure_of(world).kinetic_energy + 1e-7;
        near_to(change, energy_of(world) - before, tolerance);
        assert_true(change < tolerance && change > -lost - tolerance);
    }
    thud_world_destroy(world);
}

static void fall_on_exact_parabolas_changes_no_energy(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.detection = &thud_detection_swept;
    thud_world *world = make_world(def);
    add_ball(world, 0, 0, 0.5f);
    for (int i = 0; i < 60; i++) {
        double change = error_of_step(world).energy_change;
        near_to(change, 0, 1e-6 * thud_measure_of(world).kinetic_energy + 1e-6);
    }
    thud_world_destroy(world);
}

/* The energy that a sliding box loses is the friction force times the distance. */
static void slide_loses_what_friction_works(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    thud_world *world = make_world(def);
    thud_shape_def rough = thud_default_shape_def();
    rough.friction = 0.3f;
    add_floor(world, &rough);
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0.25, 0);
    add_shape(world, box, 0.5f, 0.25f, false, &rough);
    OK(thud_body_set_velocity(world, box, (thud_vec2){5, 0}, 0));
    run(world, 10); /* until its contact has settled */
    double x = state_of(world, box).position.x, lost = 0;
    for (int i = 0; i < 40; i++) {
        thud_step_error e = error_of_step(world);
        assert_true(e.energy_change < 0);
        lost -= e.energy_change;
    }
    thud_body_state end = state_of(world, box);
    double work = 0.3 * (double)end.mass * 10 * (end.position.x - x);
    near_to(lost, work, 0.01 * work);
    thud_world_destroy(world);
}

/* Edits between steps are not part of the reported change. */
static void energy_change_leaves_edits_out(void **state) {
    (void)state;
    uint64_t seed = 5;
    thud_world_def def = weightless();
    def.detection = &thud_detection_overlap;
    def.sleeping = true;
    thud_world *world = make_world(def);
    thud_body_id body[40];
    thud_shape_def bouncy = thud_default_shape_def();
    bouncy.restitution = 0.7f;
    for (int i = 0; i < 40; i++) {
        body[i] = add_body(world, THUD_BODY_DYNAMIC, 1.2 * (i % 8), 1.2 * (i / 8), 0);
        add_shape(world, body[i], 0.5f, i % 2 ? 0.5f : 0, false, &bouncy);
    }
    bool collided = false;
    for (int step = 0; step < 300; step++) {
        int i = (int)random_in(&seed, 0, 40);
        thud_vec2 v = {(float)random_in(&seed, -5, 5), (float)random_in(&seed, -5, 5)};
        thud_body_state s = state_of(world, body[i]);
        switch ((int)random_in(&seed, 0, 8)) {
        case 0:
            OK(thud_body_set_velocity(world, body[i], v, 1));
            break;
        case 1:
            OK(thud_body_apply_impulse(world, body[i], v, s.position));
            break;
        case 2:
            OK(thud_body_set_awake(world, body[i], false));
            break;
        case 3:
            OK(thud_body_set_transform(world, body[i], (thud_pos){20, 3 * i}, 0));
            break;
        case 4:
            OK(thud_body_set_enabled(world, body[i], !s.enabled));
            break;
        case 5:
            add_shape(world, body[i], 0.3f, 0.3f, false, &bouncy);
            break;
        case 6:
            OK(thud_body_destroy(world, body[i]));
            body[i] = add_ball(world, -3, 3 * i, 0.5f);
            OK(thud_body_set_velocity(world, body[i], v, 1));
            break;
        default:
            break;
        }
        double before = thud_measure_of(world).kinetic_energy;
        double change = error_of_step(world).energy_change;
        double after = thud_measure_of(world).kinetic_energy;
        near_to(change, after - before, 1e-5 * (before + 1));
        collided |= change < -0.01;
    }
    assert_true(collided);
    thud_world_destroy(world);
}

/* After an impact within the step, the reported change of energy is that of the whole step. */
static void energy_counts_anew_after_a_collision_within_the_step(void **state) {
    (void)state;
    thud_world_def def = weightless();
    def.detection = &thud_detection_swept;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 2, 0.5f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){10, -100}, 0));
    bool met = false;
    for (int i = 0; i < 10; i++) {
        double before = energy_of(world);
        thud_step_error e = error_of_step(world);
        if (met) { /* from now on it slides or rests, and no single step loses much */
            assert_true(e.energy_change > -0.1 * before);
        }
        met |= thud_stats_of(world).impacts > 0;
    }
    assert_true(met);
    thud_world_destroy(world);
}

/* Finite values whose squares or products overflow a float. */
static void energies_are_told_whatever_acts(void **state) {
    (void)state;
    for (int pushed = 0; pushed < 2; pushed++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_body_def def = thud_default_body_def();
        def.kind = THUD_BODY_DYNAMIC;
        def.gravity_scale = pushed ? 1.0f : 1e35f;
        thud_body_id body;
        OK(thud_body_create(world, &def, &body));
        run(world, 1);
        assert_true(isfinite(thud_step_error_of(world).energy_change));
        for (int i = 0; i < 3 * pushed; i++) {
            OK(thud_body_apply_impulse(world, body, (thud_vec2){3e38f, 3e38f}, (thud_pos){0, 0}));
        }
        assert_true(isfinite(thud_measure_of(world).kinetic_energy));
        run(world, 1);
        assert_true(isfinite(thud_step_error_of(world).energy_change));
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_flight_changes_no_energy_at_all),
        cmocka_unit_test(fall_changes_no_more_energy_than_the_integrator_loses),
        cmocka_unit_test(fall_on_exact_parabolas_changes_no_energy),
        cmocka_unit_test(slide_loses_what_friction_works),
        cmocka_unit_test(energy_change_leaves_edits_out),
        cmocka_unit_test(energy_counts_anew_after_a_collision_within_the_step),
        cmocka_unit_test(energies_are_told_whatever_acts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
