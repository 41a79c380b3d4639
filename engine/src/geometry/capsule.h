/* capsule.h: a capsule as its segment and a radius, for the functions that work on boxes. */
#ifndef TD_CAPSULE_H
#define TD_CAPSULE_H

#include "geometry/shape_instance.h"
#include "thud/thud_capsule.h"

/* The segment of a valid capsule: a box of thickness 0, or, where the ends coincide, a circle of
 * radius 0. */
thud_geometry td_capsule_segment(const thud_capsule *capsule);

/* Whether a motion is valid and does not turn. */
static inline bool td_motion_straight(thud_motion motion) {
    return td_motion_valid(motion) && motion.turn == 0.0;
}

/* Converts the closest points of two shapes into those of the same shapes grown by a radius each. A
 * capsule is its segment, grown by its radius. */
static inline void td_closest_grow(thud_closest *c, double radius_a, double radius_b) {
    c->distance -= radius_a + radius_b;
    c->ax += radius_a * c->nx;
    c->ay += radius_a * c->ny;
    c->bx -= radius_b * c->nx;
    c->by -= radius_b * c->ny;
}

#endif
