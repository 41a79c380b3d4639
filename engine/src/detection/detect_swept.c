/* detect_swept.c: the detection `swept`. A pair is stopped at the first time of impact along its
 * motion, found by conservative advancement (geometry/toi.c). */
#include "detection/detection.h"
#include "detection/sensing.h"
#include "thud/thud_quality.h"

/* See td_time_of_impact_fn. */
static bool time_of_impact(const td_approach *p, double *time) {
    bool hit = false;
    if (p->on_ground) {
        thud_terrain_time_of_impact(&p->ground, &p->a, p->motion_a, p->target, &hit, time);
    } else {
        td_time_of_near_impact(&p->a, p->motion_a, &p->b, p->motion_b, p->target, p->tolerance,
                               td_time_across_faces, &hit, time);
    }
    return hit;
}

const thud_detection thud_detection_swept = {.name = "swept",
                                             .rank = TD_RANK_SWEPT,
                                             .stage = &td_stage_impacts,
                                             .time_of_impact = time_of_impact,
                                             .islands = &thud_islands_direct,
                                             .senses = true,
                                             .sense_awake = td_sensing_test_awake};
