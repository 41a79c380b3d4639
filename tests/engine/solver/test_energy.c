/* test_energy.c: under `swept` elastic bodies keep their energy and momentum, free bodies fly
 * parabolas, and no world gains energy, at any number of substeps. */
#include "energy_support.h"

/* ---- one ball ---- */

static void free_body_flies_an_exact_parabola(void **state) {
    (void)state;
    static const int substeps[] = {1, 4, 16};
    for (int k = 0; k < 3; k++) {
        bodies b = make_bodies(-10, substeps[k]);
        thud_body_id id = add(&b, CIRCLE, 0, 0, 0.5f, NULL);
        OK(thud_body_set_velocity(b.world, id, (thud_vec2){3, 8}, 0));
        for (int i = 1; i <= 120; i++) {
            run(b.world, 1);
            double t = i / 60.0;
            near_to(state_of(b.world, id).position.x, 3 * t, 1e-6);
            near_to(state_of(b.world, id).position.y, 8 * t - 5 * t * t, 1e-5);
        }
        thud_world_destroy(b.world);
    }
}

static void elastic_ball_keeps_its_height_for_a_minute(void **state) {
    (void)state;
    static const int substeps[] = {1, 2, 4, 16};
    thud_shape_def elastic = surface(1, 0);
    for (int k = 0; k < 4; k++) {
        for (int kind = 0; kind < 2; kind++) {
            bodies b = make_bodies(-10, substeps[k]);
            add_floor(b.world, &elastic);
            thud_body_id id = add(&b, kind, 0, 1.5, 0.5f, &elastic);
            double height = 0;
            for (int i = 0; i < MINUTE; i++) {
                run(b.world, 1);
                thud_body_state s = state_of(b.world, id);
                double up = s.position.y - 0.5 + (double)(s.velocity.y * s.velocity.y) / 20;
                assert_true(up < 1.0001);
                height = i > MINUTE - 120 ? fmax(height, s.position.y - 0.5) : 0;
            }
            assert_true(height > 0.999);
            thud_world_destroy(b.world);
        }
    }
}

/* Over ground of all kinds, in metres and in pixels, at long and short time steps. */
static void elastic_bodies_keep_their_energy_over_any_ground(void **state) {
    (void)state;
    static const struct {
        int kind;
        double scale, time_step, angle;
    } cases[] = {{CIRCLE, 1, 1 / 60.0, 0},   {UPRIGHT, 1, 1 / 60.0, 0},
                 {TURNED, 1, 1 / 60.0, 0.4}, {CIRCLE, 50, 1 / 60.0, 0},
                 {TURNED, 1, 1 / 15.0, 0.4}, {CIRCLE, 0.01, 1 / 240.0, 0}};
    thud_shape_def elastic = surface(1, 0);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double unit = cases[k].scale;
        thud_pos valley[] = {{-100 * unit, 20 * unit},
                             {-8 * unit, 0},
                             {0, 0.5 * unit},
                             {6 * unit, 0},
                             {100 * unit, 30 * unit}};
        thud_terrain grounds[] = {{.kind = THUD_TERRAIN_FLAT},
                                  {.kind = THUD_TERRAIN_IRREGULAR, .points = valley, .count = 5}};
        for (int ground = 0; ground < 2; ground++) {
            thud_world_def def = weightless();
            def.gravity.y = (float)(-10 * unit);
            def.length_scale = (float)unit;
            def.time_step = cases[k].time_step;
            def.detection = &thud_detection_swept;
            bodies b = {.world = make_world(def), .gravity = -10 * unit};
            thud_body_id floor = add_body(b.world, THUD_BODY_STATIC, 0, 0, 0);
            OK(thud_shape_create_terrain(b.world, floor, &elastic, &grounds[ground], NULL));
            thud_body_id id =
                add(&b, cases[k].kind, 0.3 * unit, 2.5 * unit, 0.4f * (float)unit, &elastic);
            OK(thud_body_set_transform(b.world, id, (thud_pos){0.3 * unit, 2.5 * unit},
                                       cases[k].angle));
            double before = energy_of(&b);
            run(b.world, 1200);
            near_to(energy_of(&b) / before, 1, 1e-4);
            thud_world_destroy(b.world);
        }
    }
}

/* With restitution e, a ball rises to e^2 of its height after the first bounce. */
static void bounce_rises_by_the_square_of_restitution(void **state) {
    (void)state;
    for (float e = 0.3f; e < 0.95f; e += 0.15f) {
        for (double drop = 1; drop < 2; drop += 0.137) {
            bodies b = make_bodies(-10, 4);
            thud_shape_def def = surface(e, 0.5f);
            add_floor(b.world, &def);
            thud_body_id id = add(&b, CIRCLE, 0, 0.5 + drop, 0.5f, &def);
            int i = 0, hits = 0;
            for (; state_of(b.world, id).velocity.y <= 0 && i < 120; i++) {
                run(b.world, 1);
                hits += thud_events_of(b.world).hit_count;
            }
            thud_body_state s = state_of(b.world, id);
            double rise = s.position.y - 0.5 + (double)(s.velocity.y * s.velocity.y) / 20;
            /* contact is up to 2 mm above the floor */
            near_to(rise, (double)(e * e) * drop, 0.003);
            assert_int_equal(hits, 1);
            thud_world_destroy(b.world);
        }
    }
}

/* ---- many bodies ---- */

/* A hundred bodies in a room of 10 by 10, with a random rotation up to `spin`. */
static bodies make_gas(double gravity, int substeps, int kind, double speed, double spin,
                       const thud_shape_def *def) {
    bodies b = make_bodies(gravity, substeps);
    uint64_t seed = 12345;
    add_room(&b, 5, def);
    for (int i = 0; i < MOST_BODIES; i++) {
        thud_body_id id = add(&b, kind, i % 10 - 4.5, i / 10 - 4.5, 0.2f, def);
        double angle = random_in(&seed, 0, 6.283), v = speed * random_in(&seed, 0.5, 1.5);
        float turn = kind == TURNED ? (float)random_in(&seed, -spin, spin) : 0;
        OK(thud_body_set_velocity(b.world, id,
                                  (thud_vec2){(float)(v * cos(angle)), (float)(v * sin(angle))},
                                  turn));
    }
    return b;
}

static void elastic_gas_keeps_its_energy_for_a_minute(void **state) {
    (void)state;
    static const struct {
        double gravity, speed;
        int kind, substeps;
    } cases[] = {{0, 3, CIRCLE, 4},    {0, 0.3, CIRCLE, 4}, {-10, 3, CIRCLE, 4},
                 {-10, 3, CIRCLE, 16}, {0, 3, UPRIGHT, 4},  {-10, 3, UPRIGHT, 4},
                 {0, 3, TURNED, 4},    {-10, 3, TURNED, 16}};
    thud_shape_def elastic = surface(1, 0);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        bodies b = make_gas(cases[k].gravity, cases[k].substeps, cases[k].kind, cases[k].speed, 3,
                            &elastic);
        double floor = 0;
        for (int i = 0; i < b.count; i++) { /* potential energy relative to the floor */
            floor -= (double)state_of(b.world, b.id[i]).mass * b.gravity * 4.8;
        }
        double before = energy_of(&b) + floor;
        double minutes =
            cases[k].kind == TURNED ? 0.25 : 1; /* rotating boxes take the most computing time */
        run(b.world, (int)(minutes * MINUTE));
        double drift = (energy_of(&b) + floor) / before - 1;
        if (!(fabs(drift) < 1e-4 * minutes)) {
            fail_msg("case %d drifts by %g", (int)k, drift);
        }
        thud_world_destroy(b.world);
    }
}

/* Bodies thrown together, falling, with friction and spin: at no time is there more energy than at
 * the start. */
static void nothing_gains_energy(void **state) {
    (void)state;
    static const float restitutions[] = {0, 0.5f, 0.95f, 1};
    for (int k = 0; k < 4; k++) {
        for (int kind = 0; kind < KINDS; kind++) {
            for (int falls = 0; falls < 2; falls++) {
                thud_shape_def def = surface(restitutions[k], 0.6f);
                bodies b = make_gas(falls ? -10 : 0, 4, kind, 8, 20, &def);
                double before = energy_of(&b);
                for (int i = 0; i < 300; i++) {
                    run(b.world, 1);
                    double now = energy_of(&b);
                    if (!(now <= before + 1e-5 * fabs(before))) {
                        fail_msg("restitution %g, kind %d, step %d: from %g to %g",
                                 (double)restitutions[k], kind, i, before, now);
                    }
                }
                thud_world_destroy(b.world);
            }
        }
    }
}

/* A box that rotates, slides and lands on a corner, with friction: Newton's restitution and
 * Coulomb's friction, each applied alone, would add energy (Kane and Levinson 1985). */
static void rough_elastic_impact_never_gains_energy(void **state) {
    (void)state;
    uint64_t seed = 99;
    thud_shape_def rough = surface(1, 1), ice = surface(1, 0);
    for (int k = 0; k < 300; k++) {
        bodies b = make_bodies(0, 4);
        add_floor(b.world, k % 3 ? &rough : &ice);
        thud_body_id id = add(&b, TURNED, 0, 1, 0.5f, k % 3 ? &rough : &ice);
        OK(thud_body_set_transform(b.world, id, (thud_pos){0, 1}, random_in(&seed, 0, 3)));
        OK(thud_body_set_velocity(b.world, id, (thud_vec2){(float)random_in(&seed, -5, 5), -3},
                                  (float)random_in(&seed, -10, 10)));
        double before = energy_of(&b);
        run(b.world, 60);
        assert_true(state_of(b.world, id).velocity.y > -3);
        assert_true(energy_of(&b) <= before * 1.000001);
        assert_true(k % 3 || energy_of(&b) >= before * 0.999999);
        thud_world_destroy(b.world);
    }
}

/* ---- touching chains ---- */

/* Of five circles in contact, the first `moving` come in at 2 m/s, and as many must leave at the
 * other end. */
static void cradle_hands_on(double gravity, int moving, double gap) {
    thud_shape_def elastic = surface(1, 0);
    bodies b = make_bodies(gravity, 4);
    if (gravity != 0) {
        add_floor(b.world, &elastic);
    }
    for (int i = 0; i < 5; i++) {
        double x = i * (1 + gap) - (i < moving ? 1 : 0);
        thud_body_id id = add(&b, CIRCLE, x, 0.5, 0.5f, &elastic);
        OK(thud_body_set_velocity(b.world, id, (thud_vec2){i < moving ? 2 : 0, 0}, 0));
    }
    run(b.world, 90);
    for (int i = 0; i < 5; i++) {
        double wanted = i >= 5 - moving ? 2 : 0;
        near_to((double)state_of(b.world, b.id[i]).velocity.x, wanted, 0.001);
    }
    thud_world_destroy(b.world);
}

static void cradle_hands_all_momentum_to_as_many_at_the_other_end(void **state) {
    (void)state;
    for (int moving = 1; moving < 5; moving++) {
        cradle_hands_on(0, moving, 0);
        cradle_hands_on(0, moving, 0.01);
        cradle_hands_on(-10, moving, 0);
        cradle_hands_on(-10, moving, 0.005);
    }
}

/* ---- at rest ---- */

static void elastic_stack_stays_at_rest(void **state) {
    (void)state;
    thud_shape_def elastic = surface(1, 0.6f);
    for (int kind = UPRIGHT; kind <= TURNED; kind++) {
        bodies b = make_bodies(-10, 4);
        add_floor(b.world, &elastic);
        for (int i = 0; i < 10; i++) {
            add(&b, kind, 0, 0.5 + i, 0.5f, &elastic);
        }
        run(b.world, 600);
        for (int i = 0; i < 10; i++) {
            thud_body_state s = state_of(b.world, b.id[i]);
            near_to(s.position.y, 0.5 + i, 0.01 * (i + 1));
            near_to(s.position.x, 0, 1e-3);
            assert_true(hypotf(s.velocity.x, s.velocity.y) < 1e-3f);
        }
        thud_world_destroy(b.world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_body_flies_an_exact_parabola),
        cmocka_unit_test(elastic_ball_keeps_its_height_for_a_minute),
        cmocka_unit_test(elastic_bodies_keep_their_energy_over_any_ground),
        cmocka_unit_test(bounce_rises_by_the_square_of_restitution),
        cmocka_unit_test(elastic_gas_keeps_its_energy_for_a_minute),
        cmocka_unit_test(nothing_gains_energy),
        cmocka_unit_test(rough_elastic_impact_never_gains_energy),
        cmocka_unit_test(cradle_hands_all_momentum_to_as_many_at_the_other_end),
        cmocka_unit_test(elastic_stack_stays_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
