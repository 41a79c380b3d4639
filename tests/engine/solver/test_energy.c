/* test_energy.c: in swept worlds elastic bodies keep their energy and momentum, free ones fly
 * parabolas, and nothing ever gains energy, whatever the substeps. At draft, default and high
 * nothing gains any either, and elastic bodies keep nearly all. */
#include "engine_support.h"

enum { CIRCLE, UPRIGHT, TURNED, KINDS, MOST_BODIES = 100, MINUTE = 3600 };

typedef struct bodies {
    thud_world *world;
    thud_body_id id[MOST_BODIES];
    int count;
    double gravity; /* along y */
} bodies;

static bodies make_bodies(double gravity, int substeps) {
    thud_world_def def = weightless();
    def.gravity.y = (float)gravity;
    def.substeps = substeps;
    def.detection = &thud_detection_swept;
    return (bodies){.world = make_world(def), .gravity = gravity};
}

static thud_shape_def surface(float restitution, float friction) {
    thud_shape_def def = thud_default_shape_def();
    def.restitution = restitution;
    def.friction = friction;
    return def;
}

/* hx: a circle's radius, or half the width of a square. */
static thud_body_id add(bodies *b, int kind, double x, double y, float hx,
                        const thud_shape_def *def) {
    thud_body_id id = add_body(b->world, THUD_DYNAMIC, x, y, 0);
    add_shape(b->world, id, hx, kind == CIRCLE ? 0 : hx, kind == UPRIGHT, def);
    return b->id[b->count++] = id;
}

/* Potential energy is 0 at y = 0. */
static double energy_of(const bodies *b) {
    double energy = 0;
    for (int i = 0; i < b->count; i++) {
        thud_body_state s = state_of(b->world, b->id[i]);
        double x = (double)s.velocity.x, y = (double)s.velocity.y, w = (double)s.angular_velocity;
        energy += 0.5 * ((double)s.mass * (x * x + y * y) + (double)s.inertia * w * w) -
                  (double)s.mass * b->gravity * s.center.y;
    }
    return energy;
}

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

/* Over ground of all kinds, in metres and in pixels, at long steps and short ones. */
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
            thud_body_id floor = add_body(b.world, THUD_STATIC, 0, 0, 0);
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

/* Restitution e: after the first bounce it rises e^2 as high. */
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
                hits += thud_world_events(b.world).hit_count;
            }
            thud_body_state s = state_of(b.world, id);
            double rise = s.position.y - 0.5 + (double)(s.velocity.y * s.velocity.y) / 20;
            near_to(rise, (double)(e * e) * drop, 0.003); /* it meets up to 2 mm above the floor */
            assert_int_equal(hits, 1);
            thud_world_destroy(b.world);
        }
    }
}

/* ---- many ---- */

static void add_room(bodies *b, double half, const thud_shape_def *def) {
    thud_body_id walls = add_body(b->world, THUD_STATIC, 0, 0, 0);
    for (int side = 0; side < 4; side++) {
        float out = (side < 2 ? 1 : -1) * (float)(half + 1), length = (float)half + 2;
        OK(thud_shape_create_aabb(b->world, walls, def,
                                  (thud_vec2){side % 2 ? out : 0, side % 2 ? 0 : out},
                                  (thud_vec2){side % 2 ? 1 : length, side % 2 ? length : 1}, NULL));
    }
}

/* A hundred in a room of 10 by 10, which may turn at first by `spin`. */
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
        for (int i = 0; i < b.count; i++) { /* potential energy from the floor on */
            floor -= (double)state_of(b.world, b.id[i]).mass * b.gravity * 4.8;
        }
        double before = energy_of(&b) + floor;
        double minutes =
            cases[k].kind == TURNED ? 0.25 : 1; /* boxes that turn take the most time */
        run(b.world, (int)(minutes * MINUTE));
        double drift = (energy_of(&b) + floor) / before - 1;
        if (!(fabs(drift) < 1e-4 * minutes)) {
            fail_msg("case %d drifts by %g", (int)k, drift);
        }
        thud_world_destroy(b.world);
    }
}

/* Thrown together and falling, with friction and spin: at no time is there more than at the start.
 */
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

/* A box that spins, slides and lands on a corner, with friction: Newton's restitution and Coulomb's
 * friction, each by itself, would give it energy (Kane and Levinson 1985). */
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

/* Of five circles that touch, the first `moving` come in at 2: as many leave at the other end. */
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

/* ---- at the other qualities, as they detect ---- */

static const thud_quality *const SOFT[] = {&thud_quality_draft, &thud_quality_default,
                                           &thud_quality_high};

static bodies make_soft(const thud_quality *quality, double gravity) {
    thud_world_def def = thud_world_def_of(quality);
    def.gravity = (thud_vec2){0, (float)gravity};
    def.sleeping = false;
    return (bodies){.world = make_world(def), .gravity = gravity};
}

/* A hundred in a room of 10 by 10, of sizes that differ by `spread`; 10 s. */
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
            /* Falling bodies' speeds are half a substep's fall behind their places. */
            double least = SOFT[q] == &thud_quality_default ? 0.99 : 0.97;
            if (!(kept > least && gained < (falls ? 5e-3 : 1e-5))) {
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

/* Of rows of five and of a hundred. */
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

/* Free fall as a height is v^2 / 20: the ball meets the floor deep, and fast enough to be stopped.
 */
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

/* A ball that falls on a box that stands on the ground, neither of which bounces by itself. */
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
        cmocka_unit_test(free_body_flies_an_exact_parabola),
        cmocka_unit_test(elastic_ball_keeps_its_height_for_a_minute),
        cmocka_unit_test(elastic_bodies_keep_their_energy_over_any_ground),
        cmocka_unit_test(bounce_rises_by_the_square_of_restitution),
        cmocka_unit_test(elastic_gas_keeps_its_energy_for_a_minute),
        cmocka_unit_test(nothing_gains_energy),
        cmocka_unit_test(rough_elastic_impact_never_gains_energy),
        cmocka_unit_test(cradle_hands_all_momentum_to_as_many_at_the_other_end),
        cmocka_unit_test(elastic_stack_stays_at_rest),
        cmocka_unit_test(soft_elastic_gas_keeps_its_energy_and_gains_none),
        cmocka_unit_test(soft_elastic_boxes_of_many_sizes_gain_no_energy),
        cmocka_unit_test(soft_cradle_hands_on_all_momentum),
        cmocka_unit_test(soft_elastic_ball_keeps_its_height_for_a_minute),
        cmocka_unit_test(soft_ball_bounces_off_what_stands_and_stack_stays_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
