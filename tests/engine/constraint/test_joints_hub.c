/* test_joints_hub.c: joints whose matrices or loops are dear take no more than their part of a
 * step.
 */
#include "joint_wheel.h"

#include <time.h>

enum { STEPS = 30 };

/* Processor time of the dearest step, but for the first, which makes everything. */
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

/* Against the dearest of draft's, since machines differ: some 60 times here, and 4,000 where
 * nothing bounds what Newton steps take. */
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
