/* test_joints_phase.c: pendulums and springs keep their frequency where islands are solved
 * directly: their phase error is of second order in the substep. References are an integration by
 * Runge and Kutta and the formula of the harmonic oscillator. */
#include "joint_support.h"

static const thud_quality *const direct[] = {&thud_quality_high, &thud_quality_exact};
enum { DIRECT = 2, SECONDS = 20, STEPS = 60 * SECONDS };

static thud_world *world_with(const thud_quality *quality, int substeps, double gravity) {
    thud_world_def def = def_of(quality);
    def.sleeping = false;
    def.substeps = substeps;
    def.gravity = (thud_vec2){0, -(float)gravity};
    return make_world(def);
}

/* ---- a pendulum of length 1 that is released at 1 rad ---- */

/* Radius of the pendulum's bob, in metres. */
#define BOB 0.1
/* Moment of inertia about the hinge, divided by the mass. */
#define INERTIA (1 + 0.5 * BOB * BOB)

/* Angular acceleration at an angle. */
static double pull(double angle) {
    return -G / INERTIA * sin(angle);
}

/* Reference: angle and angular velocity after `time` seconds, by Runge and Kutta's method of fourth
 * order. */
static void swing(double time, double out[2]) {
    enum { STEPS_A_SECOND = 20000 };
    double h = 1.0 / STEPS_A_SECOND, a = 1, v = 0;
    for (int i = 0; i < (int)(time * STEPS_A_SECOND + 0.5); i++) {
        double a1 = v, v1 = pull(a), a2 = v + h / 2 * v1, v2 = pull(a + h / 2 * a1);
        double a3 = v + h / 2 * v2, v3 = pull(a + h / 2 * a2), a4 = v + h * v3,
               v4 = pull(a + h * a3);
        a += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        v += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    }
    out[0] = a;
    out[1] = v;
}

/* Phase of the oscillation in radians. */
static double phase(double angle, double turn) {
    return atan2(-turn / sqrt(G / INERTIA), angle);
}

/* Phase error of the engine's pendulum after SECONDS, in degrees. */
static double pendulum_off(const thud_quality *quality, int substeps) {
    thud_world *world = world_with(quality, substeps, G);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id bob = add_ball(world, sin(1), -cos(1), (float)BOB);
    make(world, between(THUD_JOINT_HINGE, hook, bob, (thud_vec2){0, 0},
                        (thud_vec2){-(float)sin(1), (float)cos(1)}));
    run(world, STEPS);
    thud_body_state b = state_of(world, bob);
    double wanted[2];
    swing(SECONDS, wanted);
    double off =
        phase(atan2(b.position.x, -b.position.y), b.angular_velocity) - phase(wanted[0], wanted[1]);
    thud_world_destroy(world);
    return fabs(remainder(off, 2 * PI)) * 180 / PI;
}

static void pendulum_keeps_time_by_its_substeps(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        double few = pendulum_off(direct[q], 8);
        assert_true(few < 0.4);
        assert_true(pendulum_off(direct[q], 16) < few / 3.5);
        assert_true(pendulum_off(direct[q], 64) < few / 40);
    }
}

/* ---- an undamped spring with a ball of 0.03 kg, stretched by 0.25 ---- */

/* What is measured of a spring. */
typedef struct measured {
    double frequency; /* relative to that of the def */
    double energy;    /* relative to that at the start */
    int soft;         /* steps of the soft solver */
} measured;

/* Runs the spring for SECONDS and measures it. */
static measured spring(const thud_quality *quality, int substeps, double frequency) {
    thud_world *world = world_with(quality, substeps, 0);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                 ball = add_ball(world, 0.25, 0, 0.1f);
    thud_joint_def def =
        between(THUD_JOINT_SLIDER, wall, ball, (thud_vec2){0, 0}, (thud_vec2){0, 0});
    def.drive[THUD_DIRECTION_ALONG].frequency = (float)frequency;
    def.drive[THUD_DIRECTION_ALONG].damping = 0;
    make(world, def);
    measured m = {0};
    double omega = 2 * PI * frequency, before = 0, turned = 0;
    for (int i = 0; i < STEPS; i++) {
        run(world, 1);
        thud_body_state b = state_of(world, ball);
        double x = b.position.x, v = b.velocity.x / omega, now = atan2(-v, x), part = now - before;
        /* Below half the step rate the phase advances by less than pi in a step. */
        turned += part < 0 ? part + 2 * PI : part;
        before = now;
        m.energy = (x * x + v * v) / (0.25 * 0.25);
        m.soft += thud_stats_of(world).direct_islands == 0 || thud_stats_of(world).soft_islands > 0;
    }
    m.frequency = turned / (SECONDS * omega);
    thud_world_destroy(world);
    return m;
}

static void springs_keep_their_frequency(void **state) {
    (void)state;
    const double frequencies[] = {0.5, 5, 20};
    for (int q = 0; q < DIRECT; q++) {
        for (int i = 0; i < 3; i++) {
            double worst[3];
            for (int k = 0; k < 3; k++) {
                measured m = spring(direct[q], 8 << k, frequencies[i]);
                worst[k] = fabs(m.frequency - 1);
                near_to(m.energy, 1, 1e-3);
                assert_int_equal(m.soft, 0);
            }
            assert_true(worst[0] < 5e-3 && worst[1] < 1.4e-3 && worst[2] < 4e-4);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pendulum_keeps_time_by_its_substeps),
        cmocka_unit_test(springs_keep_their_frequency),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
