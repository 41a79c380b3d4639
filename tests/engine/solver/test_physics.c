/* test_physics.c: motion of simple scenes against analytic answers: restitution,
 * friction, rolling, elastic collision, columns. */
#include "engine_support.h"

static void ball_bounces_by_its_restitution(void **state) {
    (void)state;
    for (int i = 1; i <= 9; i += 4) {
        thud_shape_def bouncy = thud_default_shape_def();
        bouncy.restitution = 0.1f * (float)i;
        thud_world *world = make_world(thud_default_world_def());
        add_floor(world, NULL);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 5.5, 0);
        add_shape(world, ball, 0.5f, 0, false, &bouncy);
        double before = 0, after = 0;
        for (int k = 0; k < 120 && after <= 0; k++) {
            before = -(double)state_of(world, ball).velocity.y;
            run(world, 1);
            after = (double)state_of(world, ball).velocity.y;
        }
        /* The tolerance allows for gravity during one step. */
        near_to(after / before, 0.1 * i, 0.03);
        thud_world_destroy(world);
    }
}

/* A box (radius 0) or a disc on a plane of this slope with friction mu, after some seconds. */
static thud_body_state slide(double slope, float mu, float radius, double seconds) {
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    thud_world *world = make_world(def);
    thud_shape_def rough = thud_default_shape_def();
    rough.friction = mu;
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT, .slope = slope};
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    OK(thud_shape_create_terrain(world, ground, &rough, &flat, NULL));
    double angle = atan(slope), up = radius > 0 ? (double)radius : 0.5;
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, -up * sin(angle), up * cos(angle),
                                 radius > 0 ? 0 : angle);
    add_shape(world, body, radius > 0 ? radius : 0.5f, radius > 0 ? 0 : 0.5f, false, &rough);
    run(world, (int)(seconds * 60));
    thud_body_state s = state_of(world, body);
    thud_world_destroy(world);
    return s;
}

static void box_holds_below_and_slides_above_the_angle_of_friction(void **state) {
    (void)state;
    thud_body_state held = slide(-0.4, 0.5f, 0, 3);
    near_to((double)held.velocity.x, 0, 1e-3);
    thud_body_state free_of = slide(-0.6, 0.5f, 0, 3);
    double angle = atan(0.6), a = 10 * (sin(angle) - 0.5 * cos(angle));
    double speed = hypot((double)free_of.velocity.x, (double)free_of.velocity.y);
    near_to(speed, a * 3, 0.02 * a * 3);
}

static void disc_rolls_at_two_thirds_of_g_sin(void **state) {
    (void)state;
    thud_body_state s = slide(-0.5, 2, 0.5f, 2);
    double a = 2.0 / 3.0 * 10 * sin(atan(0.5));
    double speed = hypot((double)s.velocity.x, (double)s.velocity.y);
    near_to(speed, a * 2, 0.01 * a * 2);
    near_to((double)-s.angular_velocity * 0.5, speed, 0.01 * speed);
}

static void elastic_circles_exchange_momentum_and_keep_energy(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def elastic = thud_default_shape_def();
    elastic.restitution = 1;
    elastic.friction = 0;
    thud_body_id a = add_body(world, THUD_BODY_DYNAMIC, -2, 0, 0),
                 b = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    add_shape(world, a, 0.5f, 0, false, &elastic);
    elastic.density = 3;
    add_shape(world, b, 0.5f, 0, false, &elastic);
    OK(thud_body_set_velocity(world, a, (thud_vec2){4, 0}, 0));
    run(world, 60);
    /* v_a = (m_a - m_b) / (m_a + m_b) v, v_b = 2 m_a / (m_a + m_b) v. */
    near_to((double)state_of(world, a).velocity.x, -2, 1e-3);
    near_to((double)state_of(world, b).velocity.x, 2, 1e-3);
    thud_world_destroy(world);
}

static void column_of_thirty_stands_for_twenty_seconds(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    thud_body_id top = {0, 0};
    for (int i = 0; i < 30; i++) {
        top = add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    run(world, 1200);
    near_to(state_of(world, top).position.y, 29.5, 0.31);
    near_to(state_of(world, top).position.x, 0, 0.1);
    thud_world_destroy(world);
}

/* The greatest penetration depth in a column of ten boxes after 2 s, in metres. */
static double depth_of_column(const thud_quality *quality) {
    thud_world_def def = thud_default_world_def();
    def.quality = quality;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    for (int i = 0; i < 10; i++) {
        add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    run(world, 120);
    double depth = thud_measure_of(world).penetration_max;
    thud_world_destroy(world);
    return depth;
}

static void more_substeps_sink_less(void **state) {
    (void)state;
    double last = 1e9;
    for (int substeps = 2; substeps <= 16; substeps *= 2) {
        thud_quality soft = thud_quality_draft;
        soft.substeps = substeps;
        double depth = depth_of_column(&soft);
        assert_true(depth < 0.7 * last);
        last = depth;
    }
}

static void column_solved_directly_does_not_sink(void **state) {
    (void)state;
    assert_true(depth_of_column(&thud_quality_default) <
                0.7 * depth_of_column(&thud_quality_draft));
    assert_true(depth_of_column(&thud_quality_high) < 1e-5);
    assert_true(depth_of_column(&thud_quality_exact) < 1e-5);
}

/* The heaviest and largest, and the lightest and smallest bodies that shapes can make, in a column:
 * they stay finite and turn, with a mass and an inertia of the same proportion as any other's. */
static void bodies_of_any_weight_are_finite(void **state) {
    (void)state;
    const struct {
        float scale, size, density;
    } cases[] = {
        {THUD_LENGTH_SCALE_MAX, THUD_SIZE_MAX, THUD_DENSITY_MAX},
        {THUD_LENGTH_SCALE_MAX, THUD_SIZE_MAX, 1},
        {THUD_LENGTH_SCALE_MAX, 100, 1},
        {THUD_LENGTH_SCALE_MAX, 1, 1e-44f},
        {1, THUD_SIZE_MAX, THUD_DENSITY_MAX},
        {1, 1, 1e-26f},
        {1, 1, 1e-44f},
        {THUD_LENGTH_SCALE_MIN, 1, 1},
        {THUD_LENGTH_SCALE_MIN, 1, 1e-30f},
        {THUD_LENGTH_SCALE_MIN, THUD_SIZE_MIN, 1},
        {THUD_LENGTH_SCALE_MIN, THUD_SIZE_MIN, 1e-40f},
        {THUD_LENGTH_SCALE_MIN, THUD_SIZE_MIN, THUD_DENSITY_MAX},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases * 4; i++) {
        thud_world_def def = thud_default_world_def_of(qualities[i % 4]);
        double unit = exp2(floor(log2((double)cases[i / 4].scale)));
        double r = (double)cases[i / 4].size * unit;
        def.length_scale = cases[i / 4].scale;
        def.gravity.y *= (float)unit;
        thud_world *world = make_world(def);
        thud_shape_def made = thud_default_shape_def();
        made.density = cases[i / 4].density;
        thud_terrain line = {.kind = THUD_TERRAIN_FLAT};
        thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0), boxes[3];
        OK(thud_shape_create_terrain(world, ground, &made, &line, NULL));
        for (int k = 0; k < 3; k++) {
            boxes[k] = add_body(world, THUD_BODY_DYNAMIC, 0.1 * k * r, (1.05 + 2.2 * k) * r, 0.1);
            add_shape(world, boxes[k], (float)r, (float)r, false, &made);
        }
        run(world, 120);
        for (int k = 0; k < 3; k++) {
            thud_body_state s = state_of(world, boxes[k]);
            assert_false(s.quarantined);
            assert_true(s.mass > 0 && isfinite(s.mass) && s.inertia > 0 && isfinite(s.inertia));
            near_to((double)s.inertia / (double)s.mass / (r * r), 2.0 / 3, 1e-4);
            double mass = (double)made.density * 4 * r * r, weight = mass * r * sqrt(2.0 / 3);
            double share = fmin(fmax(weight, 0x1p-90), 0x1p90) / weight;
            near_to((double)s.mass / mass / share, 1, 1e-4);
        }
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ball_bounces_by_its_restitution),
        cmocka_unit_test(box_holds_below_and_slides_above_the_angle_of_friction),
        cmocka_unit_test(disc_rolls_at_two_thirds_of_g_sin),
        cmocka_unit_test(elastic_circles_exchange_momentum_and_keep_energy),
        cmocka_unit_test(column_of_thirty_stands_for_twenty_seconds),
        cmocka_unit_test(more_substeps_sink_less),
        cmocka_unit_test(column_solved_directly_does_not_sink),
        cmocka_unit_test(bodies_of_any_weight_are_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
