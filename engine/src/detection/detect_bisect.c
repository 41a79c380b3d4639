/* detect_bisect.c: a pair that is too near at the end of its motion is taken back to the time of
 * its collision, found by bisection. */
#include "detection/detection.h"
#include "detection/sensing.h"

/* The time of collision is found to this part of the rest of the step. */
#define TOLERANCE 0x1p-20

static bool met_at(const td_approach *p, double time) {
    thud_shape_instance a = td_placed_at(&p->a, &p->motion_a, time);
    thud_shape_instance b = td_placed_at(&p->b, &p->motion_b, time);
    thud_closest closest;
    td_closest(&a, &b, &closest);
    return closest.distance <= p->target;
}

static bool meet(const td_approach *p, double *time) {
    if (p->on_ground) {
        bool collided = false;
        thud_terrain_time_of_collision(&p->ground, &p->a, p->motion_a, TOLERANCE, &collided, time);
        return collided;
    }
    double before = 0.0, after = 1.0;
    bool met = met_at(p, 1.0);
    while (met && after - before > TOLERANCE) {
        double middle = 0.5 * (before + after);
        if (met_at(p, middle)) {
            after = middle;
        } else {
            before = middle;
        }
    }
    *time = before;
    return met;
}

const thud_detection thud_detection_bisect = {.name = "bisect",
                                              .rank = TD_RANK_BISECT,
                                              .stage = &td_stage_impacts,
                                              .meet = meet,
                                              .sensing = &td_sensing_on_ways};
