/* test_islands_gas.c: a gas of elastic circles keeps its energy where islands are solved directly,
 * no worse than at default. */
#include "island_support.h"

enum { SIDE = 10, STEPS = 1200 };

static void add_wall(thud_world *world, thud_body_id walls, double x, double y, float hx,
                     float hy) {
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id id;
    def.restitution = 1;
    def.friction = 0;
    OK(thud_shape_create_aabb(world, walls, &def, (thud_vec2){(float)x, (float)y},
                              (thud_vec2){hx, hy}, &id));
}

/* Elastic circles of one speed in a box, without gravity: the share of their energy that is lost
 * after STEPS steps. */
static double lost_by_gas(const thud_quality *quality) {
    thud_world_def world_def = def_of(quality);
    world_def.sleeping = false;
    world_def.gravity = (thud_vec2){0, 0};
    thud_world *world = make_world(world_def);
    thud_body_id walls = add_body(world, THUD_BODY_STATIC, 0, 0, 0), ball[SIDE * SIDE];
    for (int side = -1; side <= 1; side += 2) {
        add_wall(world, walls, side * (SIDE + 1), 0, 1, SIDE + 2);
        add_wall(world, walls, 0, side * (SIDE + 1), SIDE + 2, 1);
    }
    thud_shape_def elastic = thud_default_shape_def();
    elastic.restitution = 1;
    elastic.friction = 0;
    uint32_t random = 1;
    double left = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        random = random * 1664525u + 1013904223u;
        double angle = (random >> 8) / 16777216.0 * 6.283185307179586;
        ball[i] = add_body(world, THUD_BODY_DYNAMIC, 2 * (i % SIDE) - 9, 2 * (i / SIDE) - 9, 0);
        add_shape(world, ball[i], 0.3f, 0, false, &elastic);
        OK(thud_body_set_velocity(world, ball[i],
                                  (thud_vec2){(float)(5 * cos(angle)), (float)(5 * sin(angle))},
                                  0));
    }
    run(world, STEPS);
    for (int i = 0; i < SIDE * SIDE; i++) {
        thud_vec2 v = state_of(world, ball[i]).velocity;
        left += (double)v.x * (double)v.x + (double)v.y * (double)v.y;
    }
    thud_world_destroy(world);
    return 1 - left / (SIDE * SIDE * 25);
}

static void gas_loses_no_more_at_better_quality(void **state) {
    (void)state;
    assert_true(fabs(lost_by_gas(&thud_quality_default)) < 1e-3);
    assert_true(fabs(lost_by_gas(&thud_quality_high)) < 1e-3);
    assert_true(fabs(lost_by_gas(&thud_quality_exact)) < 1e-4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gas_loses_no_more_at_better_quality),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
