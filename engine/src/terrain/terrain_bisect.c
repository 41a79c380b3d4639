/* terrain_bisect.c: the time at which a moving shape begins to overlap a terrain, by bisection
 * (geometry/bisect.h). */
#include "geometry/bisect.h"
#include "terrain/terrain.h"

/* A moving shape and a terrain at rest. */
typedef struct landing {
    const thud_terrain *terrain;
    const thud_geometry *shape;
    thud_motion motion;
} landing;

/* A td_overlap_at_fn for a `landing`. */
static bool overlap_at(const void *pair, double time) {
    const landing *m = pair;
    thud_geometry shape = td_placed_at(m->shape, &m->motion, time);
    return thud_terrain_overlap(m->terrain, &shape);
}

thud_result thud_terrain_time_of_collision(const thud_terrain *terrain, const thud_geometry *shape,
                                           thud_motion motion, double tolerance, bool *out_collided,
                                           double *out_time) {
    if (!terrain || !shape || !out_collided || !out_time) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_geometry_check(shape) != THUD_OK || !td_motion_valid(motion) ||
        !td_tolerance_valid(tolerance)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    landing m = {terrain, shape, motion};
    *out_collided = td_bisect(overlap_at, &m, tolerance, out_time);
    return THUD_OK;
}
