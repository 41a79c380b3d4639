/* test_islands_corner.c: a box that stands on a corner falls over, whichever of its contact points
 * touches, at every quality and detection. */
#include "island_support.h"

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};

enum { DETECTIONS = sizeof detections / sizeof detections[0] };

static void islands_box_on_its_corner_falls_over(void **state) {
    (void)state;
    const double angles[] = {-0.75, -0.5, -0.3, 0.3, 0.5, 0.75};
    for (int i = 0; i < QUALITIES * DETECTIONS; i++) {
        for (int k = 0; k < 6; k++) {
            thud_world_def def = def_of(qualities[i % QUALITIES]);
            def.detection = detections[i / QUALITIES];
            thud_world *world = make_world(def);
            add_floor(world, NULL);
            double height = 0.5 * (cos(angles[k]) + sin(fabs(angles[k])));
            thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, height, angles[k]);
            add_shape(world, box, 0.5f, 0.5f, false, NULL);
            run(world, 240);
            thud_body_state end = state_of(world, box);
            near_to(atan2(end.sine, end.cosine), 0, 0.01);
            near_to(end.position.y, 0.5, 0.01);

            thud_world_destroy(world);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(islands_box_on_its_corner_falls_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
