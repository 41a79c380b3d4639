/* test_flight.c: what no constraint acts on moves by the exact path of its acceleration and
 * damping, at every quality, detection and time step. */
#include "engine_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_forces.h>

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
static const double time_steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 240};
enum { DETECTIONS = 4, TIME_STEPS = 3, SETTINGS = QUALITIES * DETECTIONS * TIME_STEPS };

/* The time step of setting i, s. */
static double step_of(int i) {
    return time_steps[i / QUALITIES / DETECTIONS];
}

/* A world of setting i under a gravity of 10, with one body in it. */
static thud_world *fly(int i, thud_body_id *body) {
    thud_world_def def = thud_default_world_def_of(qualities[i % QUALITIES]);
    def.detection = detections[i / QUALITIES % DETECTIONS];
    def.time_step = step_of(i);
    thud_world *world = make_world(def);
    *body = add_box(world, 0, 0, 0.5f, 0.3f);
    return world;
}

/* Positions are off by the rounding of velocities alone, single precision in every step: half a
 * unit of 8 to 16 length scales a second, 5e-7, over two seconds. */
static void flight_follows_the_parabola(void **state) {
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        for (int thrown = 0; thrown < 2; thrown++) {
            thud_body_id body;
            thud_world *world = fly(i, &body);
            double step = step_of(i), vx = 3 * thrown, vy = 8 * thrown;
            OK(thud_body_set_velocity(world, body, (thud_vec2){(float)vx, (float)vy}, 2));
            for (int k = 1; k * step < 2.001; k++) {
                double t = k * step, tolerance = step < 0.01 ? 4e-5 : 1e-5;
                run(world, 1);
                thud_body_state s = state_of(world, body);
                near_to(s.position.x, vx * t, tolerance);
                near_to(s.position.y, vy * t - 5 * t * t, tolerance);
                near_to((double)s.velocity.y, vy - 10 * t, 5 * tolerance);
                near_to(cos(s.angle - 2 * t), 1, 1e-9);
            }
            thud_world_destroy(world);
        }
    }
}

/* A force off the centre, in every step: acceleration and spin grow evenly. */
static void flight_under_a_force_is_a_parabola_too(void **state) {
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        thud_body_id body;
        thud_world *world = fly(i, &body);
        thud_body_state s = state_of(world, body);
        double mass = (double)s.mass, inertia = (double)s.inertia;
        double step = step_of(i), t = 0;
        for (int k = 1; k * step < 1.001; k++) {
            OK(thud_body_apply_center_force(world, body, (thud_vec2){(float)(6 * mass), 0}));
            OK(thud_body_apply_torque(world, body, (float)(2 * inertia)));
            run(world, 1);
            t = k * step;
        }
        s = state_of(world, body);
        near_to(s.position.x, 3 * t * t, 1e-5);
        near_to(s.position.y, -5 * t * t, 1e-5);
        near_to(s.angle, t * t, 1e-5);
        thud_world_destroy(world);
    }
}

/* dv/dt = g - c v: v = g/c + (v0 - g/c) exp(-c t), and the integral of that. */
static void damped_flight_follows_its_closed_form(void **state) {
    (void)state;
    static const double dampings[] = {1e-4, 0.01, 0.5, 3, 20};
    for (int i = 0; i < SETTINGS; i++) {
        for (int k = 0; k < 5; k++) {
            thud_body_id body;
            thud_world *world = fly(i, &body);
            double c = dampings[k], step = step_of(i);
            OK(thud_body_set_damping(world, body, (float)c, (float)c));
            OK(thud_body_set_velocity(world, body, (thud_vec2){3, 8}, 2));
            int steps = (int)(1 / step + 0.5);
            run(world, steps);
            double t = steps * step, left = exp(-c * t), way = (1 - left) / c, end = -10 / c;
            thud_body_state s = state_of(world, body);
            near_to((double)s.velocity.x, 3 * left, 3e-5);
            near_to((double)s.velocity.y, end + (8 - end) * left, 3e-5);
            near_to((double)s.angular_velocity, 2 * left, 3e-5);
            near_to(s.position.x, 3 * way, 3e-5);
            near_to(s.position.y, c < 1e-3 ? 8 * t - 5 * t * t : end * t + (8 - end) * way,
                    c < 1e-3 ? 1e-3 : 3e-5);
            near_to(cos(s.angle - 2 * way), 1, 1e-9);
            thud_world_destroy(world);
        }
    }
}

/* Damping so strong that nothing is left of a velocity after a step is no reason to stop: gravity
 * still moves the body by g / c. */
static void strong_damping_leaves_the_speed_that_gravity_holds(void **state) {
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        thud_body_id body;
        thud_world *world = fly(i, &body);
        OK(thud_body_set_damping(world, body, 2000, 2000));
        double step = step_of(i);
        OK(thud_world_set_sleeping(world, false));
        run(world, 100);
        double before = state_of(world, body).position.y;
        run(world, 100);
        double speed = (before - state_of(world, body).position.y) / (100 * step);
        near_to(speed, 10.0 / 2000, 0.02 * 10 / 2000);
        thud_world_destroy(world);
    }
}

/* A force that depends on the place, taken where the body is in the middle of the step: ten turns
 * of an orbit of radius 5, around a centre that draws by 125 / r^2. */
static void orbit_keeps_its_energy(void **state) {
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        thud_body_id body;
        thud_world *world = fly(i, &body);
        double step = step_of(i), worst = 0;
        double mass = (double)state_of(world, body).mass;
        OK(thud_world_set_gravity(world, (thud_vec2){0, 0}));
        OK(thud_body_set_transform(world, body, (thud_pos){5, 0}, 0));
        OK(thud_body_set_velocity(world, body, (thud_vec2){0, 5}, 0));
        for (int k = 0; k * step < 20 * 3.14159; k++) {
            thud_body_state s = state_of(world, body);
            double x = s.position.x + 0.5 * step * (double)s.velocity.x;
            double y = s.position.y + 0.5 * step * (double)s.velocity.y;
            double r = hypot(x, y), pull = -125 * mass / (r * r * r);
            OK(thud_body_apply_center_force(world, body,
                                            (thud_vec2){(float)(pull * x), (float)(pull * y)}));
            run(world, 1);
            s = state_of(world, body);
            double v = hypot((double)s.velocity.x, (double)s.velocity.y);
            double energy = 0.5 * v * v - 125 / hypot(s.position.x, s.position.y);
            worst = fmax(worst, fabs(energy / -12.5 - 1));
        }
        near_to(worst, 0, step > 0.02 ? 2e-3 : 5e-4);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flight_follows_the_parabola),
        cmocka_unit_test(flight_under_a_force_is_a_parabola_too),
        cmocka_unit_test(damped_flight_follows_its_closed_form),
        cmocka_unit_test(strong_damping_leaves_the_speed_that_gravity_holds),
        cmocka_unit_test(orbit_keeps_its_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
