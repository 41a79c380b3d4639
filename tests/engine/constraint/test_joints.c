/* test_joints.c: each kind of joint against a formula, at every quality: periods, energy, forces,
 * sag, limits and motors. */
#include "joint_support.h"

static const thud_vec2 middle = {0, 0};

/* ---- hinges ---- */

/* A bar of 1 by 0.2 that hangs by its end has the period T = 2 pi sqrt(I / (m g l)); an amplitude
 * of 0.05 rad lengthens it by 1/6400. */
static void hinged_bar_swings_as_its_formula_says(void **state) {
    (void)state;
    double wanted = 2 * PI * sqrt((1.0 / 12 * (1 + 0.04) + 0.25) / (G * 0.5));
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id bar =
            add_body(world, THUD_BODY_DYNAMIC, 0.5 * sin(0.05), -0.5 * cos(0.05), 0.05);
        add_shape(world, bar, 0.1f, 0.5f, false, NULL);
        thud_joint_id hinge =
            make(world, between(THUD_JOINT_HINGE, hook, bar, middle, (thud_vec2){0, 0.5f}));
        int crossings = 0;
        double first = 0, last = 0, before = 0.05;
        for (int k = 1; k <= 1200; k++) {
            run(world, 1);
            double angle = state_of(world, bar).angle;
            if (before > 0 && angle <= 0) {
                last = (k - angle / (angle - before)) * STEP;
                first = crossings++ ? first : last;
            }
            before = angle;
        }
        near_to((last - first) / (crossings - 1), wanted, 0.01 * wanted);
        assert_true(joint_of(world, hinge).gap < 1e-3);
        thud_world_destroy(world);
    }
}

/* A pendulum falls from level and swings for a minute. `most` is the relative error of its energy:
 * rounding alone where islands are solved directly. */
static void pendulum_keeps_its_energy(void **state) {
    (void)state;
    const double most[QUALITIES] = {0.2, 0.02, 1e-5, 1e-5};
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id bar = add_box(world, 0.5, 0, 0.5f, 0.1f);
        make(world, between(THUD_JOINT_HINGE, hook, bar, middle, (thud_vec2){-0.5f, 0}));
        thud_measure before = thud_measure_of(world);
        double full = state_of(world, bar).mass * G * 0.5;
        run(world, 3600);
        thud_measure after = thud_measure_of(world);
        double gained = after.kinetic_energy + after.potential_energy - before.kinetic_energy -
                        before.potential_energy;
        near_to(gained / full, 0, most[i]);
        thud_world_destroy(world);
    }
}

/* A chain of thirty links of 0.5 m, with a weight of a thousand links at its end, falls from level
 * and swings for ten seconds. Bounds are the greatest gap in metres and the relative change of
 * energy. */
static void chain_with_a_weight_swings_without_stretching(void **state) {
    (void)state;
    const double gap[QUALITIES] = {0, 0.03, 5e-4, 5e-4}, energy[QUALITIES] = {0, 0.05, 0.01, 0.01};
    for (int i = 1; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id last = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_joint_id hinge[30];
        thud_shape_def heavy = thud_default_shape_def();
        heavy.density = 1000;
        for (int k = 0; k < 30; k++) {
            thud_body_id next = add_body(world, THUD_BODY_DYNAMIC, 0.25 + 0.5 * k, 0, 0);
            add_shape(world, next, 0.25f, 0.0625f, false, k == 29 ? &heavy : NULL);
            hinge[k] = make(world, between(THUD_JOINT_HINGE, last, next,
                                           (thud_vec2){k ? 0.25f : 0, 0}, (thud_vec2){-0.25f, 0}));
            last = next;
        }
        thud_measure before = thud_measure_of(world);
        double worst = 0, full = state_of(world, last).mass * G * 15;
        for (int n = 0; n < 600; n++) {
            run(world, 1);
            for (int k = 0; k < 30; k++) {
                worst = fmax(worst, joint_of(world, hinge[k]).gap);
            }
        }
        thud_measure after = thud_measure_of(world);
        assert_true(worst < gap[i]);
        near_to((after.kinetic_energy + after.potential_energy - before.kinetic_energy -
                 before.potential_energy) /
                    full,
                0, energy[i]);
        thud_world_destroy(world);
    }
}

/* The default quality without its direct solver. */
static thud_quality soft_alone(void) {
    thud_quality soft = thud_quality_default;
    soft.islands = NULL;
    soft.island_limit = 1;
    return soft;
}

/* Solved by the soft solver, a hanging chain has a small gap, and comes to rest. */
static void hung_chain_hangs_still(void **state) {
    (void)state;
    thud_quality soft = soft_alone();
    const thud_quality *const both[] = {&soft, &thud_quality_draft};
    const double gap[] = {0.002, 0.008};
    for (int i = 0; i < 2; i++) {
        enum { LINKS = 10 };
        thud_world *world = world_at(both[i]);
        thud_body_id last = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_joint_id hinge[LINKS];
        for (int k = 0; k < LINKS; k++) {
            thud_body_id next = add_body(world, THUD_BODY_DYNAMIC, 0, -0.25 - 0.5 * k, 0);
            add_shape(world, next, 0.0625f, 0.25f, false, NULL);
            hinge[k] = make(world, between(THUD_JOINT_HINGE, last, next,
                                           (thud_vec2){0, k ? -0.25f : 0}, (thud_vec2){0, 0.25f}));
            last = next;
        }
        run(world, 300);
        for (int k = 0; k < LINKS; k++)
            assert_true(joint_of(world, hinge[k]).gap < gap[i]);
        thud_body_state tip = state_of(world, last);
        near_to(hypot(tip.velocity.x, tip.velocity.y), 0, 0.01);
        thud_world_destroy(world);
    }
}

/* The gap of a soft joint grows with its load, also where push_speed is too low to close it within
 * a substep. */
static void soft_joint_gives_way_to_a_heavy_load_by_little(void **state) {
    (void)state;
    thud_quality soft = soft_alone();
    const double times[] = {200, 1000}, gap[] = {0.02, 0.2}, past[] = {0.05, 0.6};
    for (int i = 0; i < 2; i++) {
        thud_world *world = world_at(&soft);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id bar = add_box(world, 0.5, 0, 0.5f, 0.1f);
        thud_body_id load = add_body(world, THUD_BODY_DYNAMIC, 1, 0, 0);
        thud_shape_def heavy = thud_default_shape_def();
        heavy.density = (float)times[i];
        add_shape(world, load, 0.25f, 0.25f, false, &heavy);
        thud_joint_def def = between(THUD_JOINT_HINGE, hook, bar, middle, (thud_vec2){-0.5f, 0});
        def.drive[THUD_DIRECTION_TURN] = (thud_drive){.limited = true, .upper = 1};
        thud_joint_id hinge = make(world, def);
        make(world, between(THUD_JOINT_HINGE, bar, load, (thud_vec2){0.5f, 0}, middle));
        run(world, 600);
        assert_true(joint_of(world, hinge).gap < gap[i]);
        near_to(joint_of(world, hinge).value[THUD_DIRECTION_TURN], 0, past[i]);
        thud_world_destroy(world);
    }
}

static void hinge_stops_at_its_limits_and_turns_by_its_motor(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        for (int swapped = 0; swapped < 2; swapped++) {
            thud_world *world = world_at(qualities[i]);
            thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            thud_body_id bar = add_box(world, 0.5, 0, 0.5f, 0.1f);
            thud_vec2 end = {-0.5f, 0};
            thud_joint_def def = swapped ? between(THUD_JOINT_HINGE, bar, hook, end, middle)
                                         : between(THUD_JOINT_HINGE, hook, bar, middle, end);
            float sign = swapped ? -1.0f : 1.0f;
            def.drive[THUD_DIRECTION_TURN].limited = true;
            def.drive[THUD_DIRECTION_TURN].lower = -1;
            def.drive[THUD_DIRECTION_TURN].upper = 1;
            thud_joint_id hinge = make(world, def);
            run(world, 240);
            near_to(state_of(world, bar).angle, -1, 0.02);
            near_to(joint_of(world, hinge).value[THUD_DIRECTION_TURN], -sign, 0.02);
            near_to(sign * joint_of(world, hinge).torque, 0.2 * G * 0.5 * cos(1), 0.05);
            def.drive[THUD_DIRECTION_TURN].motor_speed = sign * 0.5f;
            def.drive[THUD_DIRECTION_TURN].motor_force = 10;
            OK(thud_joint_set_drive(world, hinge, THUD_DIRECTION_TURN,
                                    &def.drive[THUD_DIRECTION_TURN]));
            run(world, 60);
            near_to(state_of(world, bar).angle, -0.5, 0.03);
            near_to(state_of(world, bar).angular_velocity, 0.5, 0.02);
            run(world, 240);
            near_to(state_of(world, bar).angle, 1, 0.02);
            thud_world_destroy(world);
        }
    }
}

/* ---- welds ---- */

/* A horizontal beam of ten boxes, welded to a wall: the reported force is the weight, and the
 * torque weight times lever arm. */
static void welded_beam_carries_itself(void **state) {
    (void)state;
    for (int i = 1; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id last = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_joint_id first = {0, 0};
        for (int k = 0; k < 10; k++) {
            thud_body_id next = add_box(world, 0.25 + 0.5 * k, 0, 0.25f, 0.25f);
            thud_joint_id weld =
                make(world, between(THUD_JOINT_WELD, last, next, (thud_vec2){k ? 0.25f : 0, 0},
                                    (thud_vec2){-0.25f, 0}));
            first = k ? first : weld;
            last = next;
        }
        run(world, 240);
        near_to(state_of(world, last).angle, 0, 0.01);
        near_to(joint_of(world, first).force.y, 2.5 * G, 0.05 * G);
        near_to(joint_of(world, first).force.x, 0, 0.1 * G);
        thud_world_destroy(world);
    }
}

static void weld_with_a_spring_sags_by_its_formula(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id box = add_box(world, 0, 0, 0.5f, 0.5f);
        thud_joint_def def = between(THUD_JOINT_WELD, wall, box, middle, middle);
        def.drive[THUD_DIRECTION_ACROSS].frequency = 2;
        thud_joint_id weld = make(world, def);
        run(world, 600);
        near_to(state_of(world, box).position.y, -G / (16 * PI * PI), 2e-3);
        near_to(state_of(world, box).position.x, 0, 1e-4);
        near_to(joint_of(world, weld).value[THUD_DIRECTION_ACROSS], -G / (16 * PI * PI), 2e-3);
        near_to(joint_of(world, weld).force.y, G, 0.01 * G);
        assert_true(joint_of(world, weld).angle_gap < 1e-4);
        thud_world_destroy(world);
    }
}

/* ---- sliders and wheels ---- */

static void slider_stays_on_its_line_and_stops_at_its_limit(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id box = add_box(world, 0, 0, 0.5f, 0.5f);
        thud_joint_def def = between(THUD_JOINT_SLIDER, wall, box, middle, middle);
        def.frame_a.angle = def.frame_b.angle = -PI / 6;
        def.frame_b.angle = -PI / 6;
        def.drive[THUD_DIRECTION_ALONG].limited = true;
        def.drive[THUD_DIRECTION_ALONG].lower = -1;
        def.drive[THUD_DIRECTION_ALONG].upper = 3;
        thud_joint_id slider = make(world, def);
        run(world, 30);
        /* s = g sin(30 degrees) t^2 / 2 */
        near_to(joint_of(world, slider).value[THUD_DIRECTION_ALONG], 0.25 * G * 0.25, 0.06);
        run(world, 240);
        near_to(joint_of(world, slider).value[THUD_DIRECTION_ALONG], 3, 0.02);
        assert_true(joint_of(world, slider).gap < 2e-3);
        assert_true(joint_of(world, slider).angle_gap < 2e-3);
        thud_world_destroy(world);
    }
}

/* A frame and a slide without gravity, sliding and turning: linear and angular momentum are
 * conserved. */
static void slider_of_two_free_bodies_keeps_momentum(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world_def def = weightless();
        def.quality = qualities[i];
        thud_world *world = make_world(def);
        thud_body_id a = add_box(world, 0, 0, 1, 0.2f), b = add_box(world, 0, 0.5, 0.3f, 0.3f);
        thud_joint_id slider =
            make(world, between(THUD_JOINT_SLIDER, a, b, middle, (thud_vec2){0, -0.5f}));
        OK(thud_body_set_velocity(world, b, (thud_vec2){1, 0}, 1));
        run(world, 120);
        thud_body_state s = state_of(world, a), t = state_of(world, b);
        near_to(s.mass * s.velocity.x + t.mass * t.velocity.x, t.mass, 1e-3);
        near_to(s.mass * s.velocity.y + t.mass * t.velocity.y, 0, 1e-3);
        near_to(joint_of(world, slider).angle_gap, 0, 1e-2);
        near_to(joint_of(world, slider).gap, 0, 2e-2);
        thud_world_destroy(world);
    }
}

/* A cart on two sprung wheels sags by m g / k, and its motors drive it. */
static void cart_sags_on_its_springs_and_drives(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_of(qualities[i]);
        thud_body_id cart = add_box(world, 0, 1.2, 1, 0.2f);
        thud_joint_id joint[2];
        for (int k = 0; k < 2; k++) {
            float x = k ? 0.8f : -0.8f;
            thud_body_id wheel = add_ball(world, (double)x, 0.7, 0.3f);
            thud_joint_def def =
                between(THUD_JOINT_WHEEL, cart, wheel, (thud_vec2){x, -0.5f}, middle);
            def.frame_a.angle = def.frame_b.angle = PI / 2;
            def.drive[THUD_DIRECTION_ALONG].frequency = 4;
            joint[k] = make(world, def);
        }
        run(world, 240);
        double load = joint_of(world, joint[0]).force.y;
        near_to(load + joint_of(world, joint[1]).force.y, -state_of(world, cart).mass * G, 0.5);
        assert_true(joint_of(world, joint[0]).value[THUD_DIRECTION_ALONG] > 0.01);
        thud_drive motor = thud_default_joint_def(THUD_JOINT_WHEEL).drive[THUD_DIRECTION_TURN];
        motor.motor_speed = -4;
        motor.motor_force = 20;
        for (int k = 0; k < 2; k++) {
            OK(thud_joint_set_drive(world, joint[k], THUD_DIRECTION_TURN, &motor));
        }
        run(world, 240);
        near_to(state_of(world, cart).velocity.x, 4 * 0.3, 0.1);
        thud_world_destroy(world);
    }
}

/* ---- distances and targets ---- */

static void rope_is_slack_until_it_is_taut(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id ball = add_ball(world, 0, -0.5, 0.1f);
        thud_joint_def def = between(THUD_JOINT_DISTANCE, hook, ball, middle, middle);
        def.drive[THUD_DIRECTION_ALONG].limited = true;
        def.drive[THUD_DIRECTION_ALONG].upper = 2;
        thud_joint_id rope = make(world, def);
        run(world, 18);
        near_to(state_of(world, ball).position.y, -0.5 - 0.5 * G * 0.09, 0.03);
        run(world, 240);
        near_to(joint_of(world, rope).value[THUD_DIRECTION_ALONG], 2, 0.01);
        thud_world_destroy(world);
    }
}

/* An undamped spring of 2 Hz swings about its rest length with the period 0.5 s. */
static void spring_swings_at_its_frequency(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world_def def = weightless();
        def.quality = qualities[i];
        thud_world *world = make_world(def);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id ball = add_ball(world, 2.5, 0, 0.1f);
        thud_joint_def spring = between(THUD_JOINT_DISTANCE, hook, ball, middle, middle);
        spring.drive[THUD_DIRECTION_ALONG].frequency = 2;
        spring.drive[THUD_DIRECTION_ALONG].damping = 0;
        spring.drive[THUD_DIRECTION_ALONG].target = 2;
        make(world, spring);
        int crossings = 0;
        double first = 0, last = 0, before = 0.5;
        for (int k = 1; k <= 150; k++) {
            run(world, 1);
            double x = state_of(world, ball).position.x - 2;
            if (before > 0 && x <= 0) {
                last = (k - x / (x - before)) * STEP;
                first = crossings++ ? first : last;
            }
            before = x;
        }
        near_to((last - first) / (crossings - 1), 0.5, 0.01);
        thud_world_destroy(world);
    }
}

/* Reference for the next test by Euler steps of 1e-4 s: the place of a body of mass 1 that falls
 * from (1, 0), pulled to the origin by a critically damped spring of 4 Hz with a maximum force of 5
 * N. */
static thud_pos dragged_to(double seconds) {
    const double omega = 2 * PI * 4, h = 1e-4;
    double x = 1, y = 0, vx = 0, vy = 0;
    for (double t = 0; t < seconds; t += h) {
        double fx = -omega * (omega * x + 2 * vx), fy = -omega * (omega * y + 2 * vy);
        double cut = fmin(1, 5 / fmax(hypot(fx, fy), 1e-9));
        vx += cut * fx * h;
        vy += (cut * fy - G) * h;
        x += vx * h;
        y += vy * h;
    }
    return (thud_pos){x, y};
}

/* A target drags a box to it with a strong spring; with a weak one, whose force is below the
 * weight, the box falls as the reference does. */
static void target_drags_with_no_more_than_its_force(void **state) {
    (void)state;
    thud_pos falls = dragged_to(2);
    for (int i = 0; i < QUALITIES; i++) {
        for (int strong = 0; strong < 2; strong++) {
            thud_world *world = world_at(qualities[i]);
            thud_body_id hand = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            thud_body_id box = add_box(world, 1, 0, 0.5f, 0.5f);
            thud_joint_def def = between(THUD_JOINT_TARGET, hand, box, middle, middle);
            for (int k = 0; k < 2; k++) {
                def.drive[k].frequency = 4;
                def.drive[k].damping = 1;
                def.drive[k].spring_force = strong ? 100.0f : 5.0f;
            }
            make(world, def);
            run(world, 120);
            double y = state_of(world, box).position.y;
            if (strong) {
                near_to(y, -G / (64 * PI * PI), 3e-3);
                near_to(state_of(world, box).position.x, 0, 1e-3);
            } else {
                /* -10 where each direction has a maximum force of its own */
                near_to(y, falls.y, 0.1);
                near_to(state_of(world, box).position.x, falls.x, 0.05);
            }
            thud_world_destroy(world);
        }
    }
}

/* A weld that is open by a radian closes by the same angle in a step at every length scale. */
static void angle_of_a_weld_closes_alike_at_every_length_scale(void **state) {
    (void)state;
    static const float scales[] = {1, 64, 1.0f / 64};
    for (int i = 0; i < QUALITIES; i++) {
        double closed[3];
        for (int k = 0; k < 3; k++) {
            thud_world_def def = def_of(qualities[i]);
            def.gravity = (thud_vec2){0, 0};
            def.sleeping = false;
            def.length_scale = scales[k];
            thud_world *world = make_world(def);
            thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            thud_body_id box = add_box(world, 0, 0, 0.5f * scales[k], 0.5f * scales[k]);
            thud_joint_def weld = between(THUD_JOINT_WELD, wall, box, middle, middle);
            weld.frame_b.angle = 1;
            make(world, weld);
            run(world, 1);
            closed[k] = state_of(world, box).angle;
            near_to(closed[k], closed[0], 1e-4);
            thud_world_destroy(world);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hinged_bar_swings_as_its_formula_says),
        cmocka_unit_test(pendulum_keeps_its_energy),
        cmocka_unit_test(chain_with_a_weight_swings_without_stretching),
        cmocka_unit_test(hung_chain_hangs_still),
        cmocka_unit_test(soft_joint_gives_way_to_a_heavy_load_by_little),
        cmocka_unit_test(hinge_stops_at_its_limits_and_turns_by_its_motor),
        cmocka_unit_test(welded_beam_carries_itself),
        cmocka_unit_test(weld_with_a_spring_sags_by_its_formula),
        cmocka_unit_test(slider_stays_on_its_line_and_stops_at_its_limit),
        cmocka_unit_test(slider_of_two_free_bodies_keeps_momentum),
        cmocka_unit_test(cart_sags_on_its_springs_and_drives),
        cmocka_unit_test(rope_is_slack_until_it_is_taut),
        cmocka_unit_test(spring_swings_at_its_frequency),
        cmocka_unit_test(target_drags_with_no_more_than_its_force),
        cmocka_unit_test(angle_of_a_weld_closes_alike_at_every_length_scale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
