/* test_joints_hub.c: an island of joints with many loops, which is expensive to factor, costs no
 * step more than a bounded multiple of draft's time. */
#include "joint_wheel.h"

#include <time.h>

enum { STEPS = 30 };

/* Processor time in seconds of the slowest step, without the first, which creates constraints and
 * reserves memory. */
static double worst_step(const thud_quality *quality) {
    thud_world *world = world_at(quality);
    double worst = 0;
    add_wheel(world);
    for (int i = 0; i < STEPS; i++) {
        clock_t start = clock();
        run(world, 1);
        double taken = (double)(clock() - start) / CLOCKS_PER_SEC;
        worst = i && taken > worst ? taken : worst;
    }
    thud_world_destroy(world);
    return worst;
}

/* The bound is relative to the slowest step of draft, since machines differ: measured some 60 times
 * that, and 4,000 times where the Newton iterations are not bounded. */
static void no_step_takes_long(void **state) {
    (void)state;
    double draft = worst_step(&thud_quality_draft);
    assert_true(worst_step(&thud_quality_high) < 600 * draft);
    assert_true(worst_step(&thud_quality_exact) < 600 * draft);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_step_takes_long),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
