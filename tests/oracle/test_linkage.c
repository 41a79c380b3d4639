/* test_linkage.c: compares linkage.h with formulas, and with the Euler-Lagrange equations of a
 * double pendulum. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "joint_gaps.h"
#include "linkage.h"
#include "oracle_support.h"
#include "tied_scenes.h"

static const double PI = 3.14159265358979323846, G = 10;

enum { MOST_BODIES = 80 };

static void run(const scene *s, double seconds, engine_body *bodies) {
    linkage *l = linkage_create(s, 0);
    assert_non_null(l);
    assert_true(linkage_advance(l, seconds));
    linkage_read(l, bodies);
    linkage_destroy(l);
}

/* The complete elliptic integral of the first kind, by the arithmetic-geometric mean. */
static double elliptic_integral(double k) {
    double a = 1, b = sqrt(1 - k * k);
    for (int i = 0; i < 10; i++) {
        double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return PI / (2 * a);
}

/* T = 4 sqrt(I / (m g d)) K(sin(a / 2)) for a start at the angle a, here 90 degrees. */
static void pendulum_from_level_is_down_after_a_quarter_of_its_period(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    fill_pendulum(&s, 1);
    double inertia = (1 + 0.125 * 0.125) / 12 + 0.25;
    double period = 4 * sqrt(inertia / (G * 0.5)) * elliptic_integral(sin(PI / 4));
    engine_body end[2];
    run(&s, 0.25 * period, end);
    assert_near(atan2(end[1].sine, end[1].cosine), -PI / 2, 1e-9);
    assert_near(end[1].y, -0.5, 1e-11);
    run(&s, 5 * period, end);
    assert_near(atan2(end[1].sine, end[1].cosine), 0, 1e-7);
    scene_free(&s);
}

/* The angles of both bars of a double pendulum from the horizontal, and their rates. */
typedef struct angles {
    double at[2], rate[2];
} angles;

/* Their derivatives for bars of 1 kg and 1 m, from the Lagrangian. */
static angles angles_slope(const angles *now) {
    const double inertia = (1 + 0.125 * 0.125) / 12, a = 0.25 + inertia + 1, b = 0.25 + inertia;
    double c = 0.5 * cos(now->at[0] - now->at[1]), s = 0.5 * sin(now->at[0] - now->at[1]);
    double one = -s * now->rate[1] * now->rate[1] - 1.5 * G * cos(now->at[0]);
    double two = s * now->rate[0] * now->rate[0] - 0.5 * G * cos(now->at[1]);
    double det = a * b - c * c;
    return (angles){{now->rate[0], now->rate[1]},
                    {(one * b - two * c) / det, (a * two - c * one) / det}};
}

/* from + h slope. */
static angles beyond(const angles *from, const angles *slope, double h) {
    return (angles){{from->at[0] + h * slope->at[0], from->at[1] + h * slope->at[1]},
                    {from->rate[0] + h * slope->rate[0], from->rate[1] + h * slope->rate[1]}};
}

/* Integrates the equations by the classical Runge-Kutta method. */
static angles euler_lagrange(double seconds, int steps) {
    angles now = {{0, 0}, {0, 0}};
    double h = seconds / steps;
    for (int i = 0; i < steps; i++) {
        angles k1 = angles_slope(&now), at = beyond(&now, &k1, h / 2);
        angles k2 = angles_slope(&at);
        at = beyond(&now, &k2, h / 2);
        angles k3 = angles_slope(&at);
        at = beyond(&now, &k3, h);
        angles k4 = angles_slope(&at);
        now = beyond(&now, &k1, h / 6);
        now = beyond(&now, &k2, h / 3);
        now = beyond(&now, &k3, h / 3);
        now = beyond(&now, &k4, h / 6);
    }
    return now;
}

static void double_pendulum_follows_its_euler_lagrange_equations(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    fill_pendulum(&s, 2);
    engine_body end[3];
    for (int i = 1; i <= 3; i++) {
        run(&s, i, end);
        angles expected = euler_lagrange(i, 20000 * i);
        for (int k = 0; k < 2; k++) {
            assert_near(end[k + 1].cosine, cos(expected.at[k]), 1e-6);
            assert_near(end[k + 1].sine, sin(expected.at[k]), 1e-6);
            assert_near(end[k + 1].angular_velocity, expected.rate[k], 1e-5);
        }
    }
    scene_free(&s);
}

static double energy_of(const scene *s, const engine_body *bodies) {
    double energy = 0;
    for (int i = 0; i < s->body_count; i++) {
        const engine_body *b = &bodies[i];
        energy += 0.5 * b->mass * (b->vx * b->vx + b->vy * b->vy) +
                  0.5 * b->inertia * b->angular_velocity * b->angular_velocity + b->mass * G * b->y;
    }
    return energy;
}

static void swinging_chain_keeps_its_energy_and_its_joints(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    fill_chain(&s, &(chain_scene){10, 10, true});
    engine_body end[MOST_BODIES];
    run(&s, 2, end);
    assert_near(energy_of(&s, end) / (100 * 5), 0, 1e-7);
    assert_near(joint_gaps_sum(&s, end), 0, 1e-10);
    scene_free(&s);
}

/* Up to the rounding of its positions to 2^-16. */
static void bridge_in_equilibrium_stays(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    bridge_scene bridge = {20, 18, 6, 40};
    fill_bridge(&s, &bridge);
    engine_body end[MOST_BODIES];
    run(&s, 1, end);
    for (int i = 0; i < s.body_count; i++)
        assert_near(hypot(end[i].x - s.bodies[i].x, end[i].y - s.bodies[i].y), 0, 1e-4);
    /* The posts carry the whole weight. */
    linkage *l = linkage_create(&s, 0);
    double left_x, left_y, right_x, right_y;
    assert_true(linkage_force(l, 0, &left_x, &left_y));
    assert_true(linkage_force(l, bridge.planks, &right_x, &right_y));
    assert_near(left_y - right_y, G * (20 * 5 + 6 * 40), 1e-2);
    assert_near(left_x - right_x, 0, 0.5);
    linkage_destroy(l);
    scene_free(&s);
}

/* The acceleration along the slot is g sin, also with a second box welded on. A wheel's slot does
 * not lock the rotation; its anchor is at the common centre of mass, so that nothing rotates them.
 */
static void boxes_on_slots_slide_as_their_formula_says(void **state) {
    (void)state;
    static const scene_joint_kind KINDS[] = {SCENE_SLIDER, SCENE_WHEEL};
    for (int i = 0; i < 2; i++) {
        scene s;
        scene_init(&s);
        scene_static_box(&s, 0, 0, 0.5, 0.5);
        scene_dynamic_box(&s, 0, 0, 0.5, 0.5);
        scene_dynamic_box(&s, 1, 0, 0.5, 0.5);
        scene_tie(&s, KINDS[i], 0, 1, KINDS[i] == SCENE_WHEEL ? 0.5 : 0, 0, -PI / 6);
        scene_tie(&s, SCENE_WELD, 1, 2, 0.5, 0, 0);
        engine_body end[3];
        run(&s, 1, end);
        double way = 0.5 * G * sin(PI / 6);
        assert_near(end[1].x, way * cos(PI / 6), 1e-9);
        assert_near(end[1].y, -way * sin(PI / 6), 1e-9);
        assert_near(end[2].y - end[1].y, 0, 1e-9);
        scene_free(&s);
    }
}

/* Two balls connected by a rod in free fall rotate about their centre of mass, which follows a
 * parabola. */
static void balls_on_a_rod_turn_about_their_middle(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_dynamic_circle(&s, -1, 0, 0.25)->vy = -3;
    scene_dynamic_circle(&s, 1, 0, 0.25)->vy = 3;
    scene_tie_distance(&s, 0, 1, -1, 0, 1, 0);
    engine_body end[2];
    run(&s, 1, end);
    assert_near(end[1].x, cos(3), 1e-9);
    assert_near(end[1].y, sin(3) - 0.5 * G, 1e-9);
    assert_near(end[0].x, -cos(3), 1e-9);
    scene_free(&s);
}

static void what_it_does_not_know_is_refused(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    fill_pendulum(&s, 1);
    assert_null(linkage_create(&s, -1));
    assert_null(linkage_create(&s, NAN));
    linkage *l = linkage_create(&s, 0.01);
    assert_false(linkage_advance(l, -1));
    assert_false(linkage_advance(l, NAN));
    assert_true(linkage_advance(l, 0));
    linkage_destroy(l);
    s.joints[0].drive[SCENE_TURN].limited = true;
    assert_null(linkage_create(&s, 0));
    s.joints[0].drive[SCENE_TURN].limited = false;
    scene_tie(&s, SCENE_HINGE, 0, 1, 0, 0, 0);
    l = linkage_create(&s, 0);
    assert_false(linkage_advance(l, 1));
    linkage_destroy(l);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pendulum_from_level_is_down_after_a_quarter_of_its_period),
        cmocka_unit_test(double_pendulum_follows_its_euler_lagrange_equations),
        cmocka_unit_test(swinging_chain_keeps_its_energy_and_its_joints),
        cmocka_unit_test(bridge_in_equilibrium_stays),
        cmocka_unit_test(boxes_on_slots_slide_as_their_formula_says),
        cmocka_unit_test(balls_on_a_rod_turn_about_their_middle),
        cmocka_unit_test(what_it_does_not_know_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
