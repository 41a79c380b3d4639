/* test_joints_bridge.c: boxes on a bridge of hinged planks stay on it, also where the island
 * exceeds the direct solver's budget and its joints alone are solved directly. */
#include "joint_support.h"

#include <thud/thud_detection.h>

enum { PLANKS = 50, BOXES = 20, STEPS = 300 };

/* Adds planks of 1 by 0.25 in an arc between two points whose distance is shorter than the planks
 * by the share `SLACK`. Boxes of edge 0.5 begin 0.02 above evenly spread planks and are `ratio`
 * times as heavy as a plank. */
#define SLACK 0.01

static void add_bridge(thud_world *world, float ratio, thud_body_id *boxes) {
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0), before = ground;
    double slope = sqrt(6 * SLACK), x = 0, y = 0;
    thud_shape_def heavy = thud_default_shape_def();
    heavy.density = ratio; /* a box of density 1 has mass 0.25, as a plank */
    for (int i = 0, box = 0; i < PLANKS; i++) {
        double angle = slope * (2 * (i + 0.5) / PLANKS - 1), c = cos(angle), s = sin(angle);
        thud_body_id plank = add_body(world, THUD_BODY_DYNAMIC, x + 0.5 * c, y + 0.5 * s, angle);
        add_shape(world, plank, 0.5f, 0.125f, false, NULL);
        make(world, between(THUD_JOINT_HINGE, before, plank, (thud_vec2){i ? 0.5f : 0, 0},
                            (thud_vec2){-0.5f, 0}));
        if (box < BOXES && i == (int)((box + 0.5) * PLANKS / BOXES)) {
            double up = 0.125 + 0.25 + 0.02;
            boxes[box] = add_body(world, THUD_BODY_DYNAMIC, x + 0.5 * c - up * s,
                                  y + 0.5 * s + up * c, angle);
            add_shape(world, boxes[box++], 0.25f, 0.25f, false, &heavy);
        }
        x += c;
        y += s;
        before = plank;
    }
    make(world, between(THUD_JOINT_HINGE, before, ground, (thud_vec2){0.5f, 0},
                        (thud_vec2){(float)x, (float)y}));
}

/* How many boxes are still on the bridge after STEPS steps. */
static int boxes_kept(const thud_world_def *def, float ratio) {
    thud_world *world = make_world(*def);
    thud_body_id boxes[BOXES];
    int kept = 0;
    add_bridge(world, ratio, boxes);
    run(world, STEPS);
    for (int i = 0; i < BOXES; i++) {
        kept += state_of(world, boxes[i]).position.y > -0.25 * PLANKS;
    }
    thud_world_destroy(world);
    return kept;
}

static void boxes_stay_on_a_long_bridge(void **state) {
    (void)state;
    const float ratios[] = {0.5f, 1, 2, 4, 8};
    for (int q = 0; q < QUALITIES; q++) {
        for (int i = 0; i < 5; i++) {
            thud_world_def def = def_of(qualities[q]);
            assert_int_equal(boxes_kept(&def, ratios[i]), BOXES);
        }
    }
}

static void boxes_stay_with_each_detection(void **state) {
    (void)state;
    const thud_detection *const detections[] = {&thud_detection_overlap, &thud_detection_continuous,
                                                &thud_detection_bisect, &thud_detection_swept};
    for (int i = 0; i < 4; i++) {
        for (int q = 1; q < QUALITIES; q++) {
            thud_world_def def = def_of(qualities[q]);
            def.detection = detections[i];
            def.sleeping = false;
            assert_int_equal(boxes_kept(&def, 8), BOXES);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_stay_on_a_long_bridge),
        cmocka_unit_test(boxes_stay_with_each_detection),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
