/* test_joints_hub.c: joints whose matrices or loops are dear take no more than their part of a
 * step.
 */
#include "joint_support.h"

#include <time.h>

enum { RIM = 900, STEPS = 30 };

/* Bodies around a hub, tied to it and each to the next: every loop is stretched at once as they
 * begin to fall. */
static void add_wheel(thud_world *world) {
    thud_body_id hub = add_body(world, THUD_STATIC, 0, 0, 0), rim[RIM];
    double radius[RIM];
    thud_shape_def alone = thud_default_shape_def();
    alone.filter.mask = 0;
    uint32_t random = 1;
    for (int i = 0; i < RIM; i++) {
        random = random * 1664525u + 1013904223u;
        radius[i] = 10 + 30 * ((random >> 8) / 16777216.0);
        rim[i] = add_body(world, THUD_DYNAMIC, radius[i] * cos(2 * PI * i / RIM),
                          radius[i] * sin(2 * PI * i / RIM), 0);
        add_shape(world, rim[i], 0.1f, 0, false, &alone);
        thud_joint_def spoke =
            between(THUD_DISTANCE, hub, rim[i], (thud_vec2){0, 0}, (thud_vec2){0, 0});
        spoke.length = (float)radius[i];
        make(world, spoke);
    }
    for (int i = 0; i < RIM; i++) {
        thud_pos a = state_of(world, rim[i]).position;
        thud_pos b = state_of(world, rim[(i + 1) % RIM]).position;
        thud_joint_def next = between(THUD_DISTANCE, rim[i], rim[(i + 1) % RIM], (thud_vec2){0, 0},
                                      (thud_vec2){0, 0});
        next.length = (float)hypot(a.x - b.x, a.y - b.y);
        make(world, next);
    }
}

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
