/* test_sensors_many.c: the time of a step grows with the number of bodies, and not with its square,
 * where all bodies have sensors and are fast. */
#include "engine_support.h"
#include "every_choice.h"

#include <thud/thud_edits.h>
#include <time.h>

enum { FEW = 500, FACTOR = 8, STEPS = 6 };

/* Processor time in seconds of the fastest step of so many bodies with sensors, which are as dense
 * for each number. */
static double best_step(const thud_detection *detection, int count) {
    thud_quality quality = thud_quality_default;
    quality.detection = detection;
    thud_world_def def = weightless();
    def.quality = &quality;
    thud_world *world = make_world(def);
    uint64_t seed = 7;
    double side = 2 * sqrt((double)count), best = INFINITY;
    for (int i = 0; i < count; i++) {
        double x = random_in(&seed, 0, side), y = random_in(&seed, 0, side);
        thud_body_id ball = add_ball(world, x, y, 0.3f);
        thud_shape_id sensor = add_shape(world, ball, 0.6f, 0, false, NULL);
        OK(thud_shape_set_sensor(world, sensor, true));
        double angle = random_in(&seed, 0, 6.28);
        thud_vec2 velocity = {(float)(40 * cos(angle)), (float)(40 * sin(angle))};
        OK(thud_body_set_velocity(world, ball, velocity, 0));
    }
    for (int i = 0; i < STEPS; i++) {
        clock_t start = clock();
        run(world, 1);
        best = fmin(best, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    thud_world_destroy(world);
    return best;
}

/* Measured for eight times the bodies: 11 to 12 times the time. Where each sensor was compared with
 * all other shapes that moved, and each fast body with all others: 69 to 89 times. */
static void time_grows_with_the_number(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof detections / sizeof *detections; i++) {
        double few = best_step(detections[i], FEW);
        double many = best_step(detections[i], FACTOR * FEW);
        if (!(many < 3 * FACTOR * few)) {
            fail_msg("%s: %.1f ms for %.1f ms", thud_detection_name(detections[i]), many * 1e3,
                     few * 1e3);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(time_grows_with_the_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
