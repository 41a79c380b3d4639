/* terrain_capsule.c: capsules against terrain, by their segments; see geometry/capsule.h. */
#include "geometry/capsule.h"
#include "terrain/terrain.h"

thud_result thud_terrain_capsule_closest(const thud_terrain *terrain, const thud_capsule *capsule,
                                         thud_closest *out) {
    if (!terrain || !capsule || !out) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_capsule_check(capsule) != THUD_OK) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    thud_geometry segment = td_capsule_segment(capsule);
    td_terrain_closest(terrain, &segment, (thud_pos){0.0, 0.0}, out);
    td_closest_grow(out, 0.0, capsule->radius);
    out->ax += segment.x;
    out->ay += segment.y;
    out->bx += segment.x;
    out->by += segment.y;
    return THUD_OK;
}

thud_result thud_terrain_capsule_time_of_impact(const thud_terrain *terrain,
                                                const thud_capsule *capsule, thud_motion motion,
                                                double target, bool *out_hit, double *out_time) {
    if (!terrain || !capsule || !out_hit || !out_time) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_capsule_check(capsule) != THUD_OK ||
        !td_motion_straight(motion) || !td_target_valid(target)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    thud_geometry segment = td_capsule_segment(capsule);
    td_terrain_time_of_impact(terrain, &segment, motion, target + capsule->radius, out_hit,
                              out_time);
    return THUD_OK;
}
