/* test_energy_soft.c: elastic bodies at draft, default and high, with the detection of each: how
 * much energy they keep and gain. */
#include "energy_support.h"

/* ---- soft qualities with their own detection ---- */

/* Qualities whose substeps solve contacts softly. */
static const thud_quality *const SOFT[] = {&thud_quality_draft, &thud_quality_default,
                                           &thud_quality_high};

static bodies make_soft(const thud_quality *quality, double gravity) {
    thud_world_def def = thud_default_world_def_of(quality);
    def.gravity = (thud_vec2){0, (float)gravity};
    def.sleeping = false;
    return (bodies){.world = make_world(def), .gravity = gravity};
}

/* A hundred bodies in a room of 10 by 10 for 10 s, with sizes that differ by `spread`. *kept is the
 * energy at the end, and *gained the greatest gain, as shares of the energy at the start. */
static void soft_gas(const thud_quality *quality, double gravity, int kind, double spread,
                     double *kept, double *gained) {
    thud_shape_def elastic = surface(1, 0);
    bodies b = make_soft(quality, gravity);
    uint64_t seed = 12345;
    add_room(&b, 5, &elastic);
    for (int i = 0; i < MOST_BODIES; i++) {
        float size = (float)(0.2 * random_in(&seed, 1 - spread, 1 + spread));
        double angle = random_in(&seed, 0, 6.283), v = random_in(&seed, 1.5, 4.5);
        thud_body_id id = add(&b, kind, i % 10 - 4.5, i / 10 - 4.5, size, &elastic);
        OK(thud_body_set_velocity(b.world, id,
                                  (thud_vec2){(float)(v * cos(angle)), (float)(v * sin(angle))},
                                  0));
    }
    double floor = 0;
    for (int i = 0; i < b.count; i++) {
        floor -= (double)state_of(b.world, b.id[i]).mass * gravity * 4.8;
    }
    double before = energy_of(&b) + floor, now = before;
    *gained = 0;
    for (int i = 0; i < 600; i++) {
        run(b.world, 1);
        now = energy_of(&b) + floor;
        *gained = fmax(*gained, now / before - 1);
    }
    *kept = now / before;
    thud_world_destroy(b.world);
}

static void soft_elastic_gas_keeps_its_energy_and_gains_none(void **state) {
    (void)state;
    for (int q = 0; q < 3; q++) {
        for (int falls = 0; falls < 2; falls++) {
            double kept, gained;
            soft_gas(SOFT[q], falls ? -10 : 0, CIRCLE, 0, &kept, &gained);
            if (!(kept > (falls ? 0.997 : 0.9999) && gained < (falls ? 1e-5 : 1e-4))) {
                fail_msg("%s, falling %d: kept %g, gained %g", SOFT[q]->name, falls, kept, gained);
            }
        }
    }
}

static void soft_elastic_boxes_of_many_sizes_gain_no_energy(void **state) {
    (void)state;
    for (int q = 0; q < 3; q++) {
        for (int kind = UPRIGHT; kind <= TURNED; kind++) {
            double kept, gained;
            soft_gas(SOFT[q], 0, kind, 0.7, &kept, &gained);
            if (!(gained < 1e-4)) {
                fail_msg("%s, kind %d: gained %g", SOFT[q]->name, kind, gained);
            }
        }
    }
}

/* Two balls that meet bounce at every time step and wherever in a step they meet. What would meet
 * just after a step is stopped by its last relax pass, unless it has bounced. */
static void soft_elastic_pair_keeps_its_speed_at_every_time_step(void **state) {
    (void)state;
    static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                       &thud_detection_continuous,
                                                       &thud_detection_bisect,
                                                       &thud_detection_swept};
    thud_shape_def elastic = surface(1, 0);
    for (int i = 0; i < QUALITIES * 4; i++) {
        for (int hertz = 30; hertz <= 960; hertz *= 2) {
            for (int at = 0; at < 10; at++) {
                thud_world_def def = thud_default_world_def_of(qualities[i % QUALITIES]);
                def.gravity = (thud_vec2){0, 0};
                def.time_step = 1.0 / hertz;
                def.detection = detections[i / QUALITIES];
                bodies b = {.world = make_world(def)};
                for (int k = 0; k < 2; k++) {
                    thud_body_id id =
                        add(&b, CIRCLE, k ? 0.3 + 0.0113 * at : -0.3, 0, 0.2f, &elastic);
                    OK(thud_body_set_velocity(b.world, id, (thud_vec2){k ? -1.7f : 1.8f, 0}, 0));
                }
                run(b.world, hertz / 2);
                near_to((double)state_of(b.world, b.id[0]).velocity.x, -1.7, 1e-3);
                near_to((double)state_of(b.world, b.id[1]).velocity.x, 1.8, 1e-3);
                thud_world_destroy(b.world);
            }
        }
    }
}

/* Rows of five and of a hundred balls. */
static void soft_cradle_hands_on_all_momentum(void **state) {
    (void)state;
    thud_shape_def elastic = surface(1, 0);
    for (int q = 0; q < 3; q++) {
        for (int moving = 1; moving < 4; moving++) {
            for (int length = 5; length <= 100; length += 95) {
                bodies b = make_soft(SOFT[q], 0);
                for (int i = 0; i < length; i++) {
                    double x = i - (i < moving ? 1 : 0);
                    thud_body_id id = add(&b, CIRCLE, x, 0, 0.5f, &elastic);
                    OK(thud_body_set_velocity(b.world, id, (thud_vec2){i < moving ? 5 : 0, 0}, 0));
                }
                run(b.world, 60);
                for (int i = length - moving; i < length; i++) {
                    assert_true((double)state_of(b.world, b.id[i]).velocity.x > 0.95 * 5);
                }
                thud_world_destroy(b.world);
            }
        }
    }
}

/* The ball falls 5 m, so that it overlaps the floor deeply and is fast enough that the detection
 * stops it. */
static void soft_elastic_ball_keeps_its_height_for_a_minute(void **state) {
    (void)state;
    thud_shape_def elastic = surface(1, 0);
    for (int q = 0; q < 3; q++) {
        for (float radius = 0.1f; radius < 0.6f; radius += 0.4f) {
            bodies b = make_soft(SOFT[q], -10);
            add_floor(b.world, &elastic);
            thud_body_id id = add(&b, CIRCLE, 0, 5 + (double)radius, radius, &elastic);
            double height = 0;
            for (int i = 0; i < MINUTE; i++) {
                run(b.world, 1);
                double y = state_of(b.world, id).position.y - (double)radius;
                assert_true(y < 5 * 1.01);
                height = i > MINUTE - 150 ? fmax(height, y) : 0;
            }
            if (!(height > 4.5)) {
                fail_msg("%s, radius %g: %g", SOFT[q]->name, (double)radius, height);
            }
            thud_world_destroy(b.world);
        }
    }
}

/* A ball falls on a box that rests on the ground; neither box nor ground is elastic. */
static void soft_ball_bounces_off_what_stands_and_stack_stays_at_rest(void **state) {
    (void)state;
    thud_shape_def elastic = surface(1, 0.6f), dull = surface(0, 0.6f);
    bodies b = make_soft(&thud_quality_default, -10);
    add_floor(b.world, &dull);
    add(&b, TURNED, 0, 0.5, 0.5f, &dull);
    thud_body_id ball = add(&b, CIRCLE, 0, 4.2, 0.2f, &elastic);
    for (int i = 0; i < 3; i++) {
        add(&b, TURNED, 10, 0.5 + i, 0.5f, &elastic);
    }
    double highest = 0;
    for (int i = 0; i < 120; i++) {
        run(b.world, 1);
        thud_body_state s = state_of(b.world, ball);
        highest = s.velocity.y > 0 ? fmax(highest, s.position.y - 1.2) : highest;
        assert_true(s.position.y - 1.2 < 3.001);
    }
    assert_true(highest > 2.6);
    for (int i = 2; i < 5; i++) {
        thud_body_state s = state_of(b.world, b.id[i]);
        near_to(s.position.y, 0.5 + i - 2, 0.02);
        assert_true(hypotf(s.velocity.x, s.velocity.y) < 1e-2f);
    }
    thud_world_destroy(b.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(soft_elastic_gas_keeps_its_energy_and_gains_none),
        cmocka_unit_test(soft_elastic_boxes_of_many_sizes_gain_no_energy),
        cmocka_unit_test(soft_elastic_pair_keeps_its_speed_at_every_time_step),
        cmocka_unit_test(soft_cradle_hands_on_all_momentum),
        cmocka_unit_test(soft_elastic_ball_keeps_its_height_for_a_minute),
        cmocka_unit_test(soft_ball_bounces_off_what_stands_and_stack_stays_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
