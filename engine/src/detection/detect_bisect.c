/* detect_bisect.c: the detection `bisect`. A pair that is within the target distance at the end of
 * its motion is taken back to the time of its collision, found by bisection of the time. A pair
 * that passes through within the step is not found. */
#include "detection/detection.h"
#include "detection/sensing.h"
#include "thud/thud_quality.h"

/* Bisection ends when the interval is this share of the rest of the step: 20 distance tests a
 * pair. Chosen: at a speed of 100 length scales/s and 60 steps/s it is 1.6e-6 length scales of
 * motion, far below TD_IMPACT_DISTANCE (1e-3). */
#define TIME_TOLERANCE 0x1p-20

/* Whether the pair is within its target distance at a time in [0, 1]. */
static bool is_within_target(const td_approach *p, double time) {
    thud_geometry a = td_placed_at(&p->a, &p->motion_a, time);
    thud_geometry b = td_placed_at(&p->b, &p->motion_b, time);
    thud_closest closest;
    td_closest(&a, &b, &closest);
    return closest.distance <= p->target;
}

/* A td_time_of_impact_fn. Sets *time to the last tested time, in [0, 1), at which the pair is still
 * apart. */
static bool time_of_impact(const td_approach *p, double *time) {
    if (p->on_ground) {
        bool collided = false;
        thud_terrain_time_of_collision(&p->ground, &p->a, p->motion_a, TIME_TOLERANCE, &collided,
                                       time);
        return collided;
    }
    double before = 0.0, after = 1.0;
    bool hits = is_within_target(p, 1.0);
    while (hits && after - before > TIME_TOLERANCE) {
        double middle = 0.5 * (before + after);
        if (is_within_target(p, middle)) {
            after = middle;
        } else {
            before = middle;
        }
    }
    *time = before;
    return hits;
}

const thud_detection thud_detection_bisect = {.name = "bisect",
                                              .rank = TD_RANK_BISECT,
                                              .stage = &td_stage_impacts,
                                              .time_of_impact = time_of_impact,
                                              .islands = &thud_islands_direct,
                                              .senses = true,
                                              .sense_awake = td_sensing_test_awake};
