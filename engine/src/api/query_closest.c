/* query_closest.c: thud_world_closest, the shape at the least signed distance from a point: the
 * search box about the point grows by a factor of four until the best shape is nearer than its half
 * width. */
#include "api/query.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "terrain/terrain.h"

void td_query_measure(const thud_world *w, int index, td_position origin, thud_closest *out) {
    thud_geometry shape = td_query_instance(w, index, origin);
    thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0};
    if (!td_kind_is_line(shape.kind)) {
        td_closest(&shape, &point, out);
        return;
    }
    thud_terrain terrain = td_terrain_view(w, index);
    td_terrain_closest(&terrain, &point, (thud_pos){-shape.x, -shape.y}, out);
}

thud_closest_hit td_query_closest_hit(const thud_world *w, int index, thud_pos point,
                                      const thud_closest *c) {
    return (
        thud_closest_hit){.shape = td_shape_handle(w, index),
                          .point = {point.x - c->nx * c->distance, point.y - c->ny * c->distance},
                          .normal = {(float)c->nx, (float)c->ny},
                          .distance = c->distance};
}

/* Updates *best and *nearest (its slot) with the nearest candidate in scratch.found_shapes; among
 * equals the lower slot. */
static void keep_nearest(const thud_world *w, td_position at, const thud_query_filter *filter,
                         int *nearest, thud_closest *best) {
    for (int i = 0; i < w->scratch.found_shapes.count; i++) {
        int index = td_int_at(&w->scratch.found_shapes, i);
        if (!td_query_passes(w, index, filter)) {
            continue;
        }
        thud_closest found;
        td_query_measure(w, index, at, &found);
        if (found.distance < best->distance ||
            (found.distance == best->distance && index < *nearest)) {
            *best = found;
            *nearest = index;
        }
    }
}

thud_result thud_world_closest(thud_world *w, thud_pos point, double max_distance,
                               const thud_query_filter *filter, bool *out_found,
                               thud_closest_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    thud_result result = td_check_place(w, "closest: x or y of point", point.x, point.y);
    if (result == THUD_OK) {
        result = td_check(w, "closest: max_distance", max_distance, 0.0,
                          THUD_PLACE_MAX * (double)w->length_scale);
    }
    if (result == THUD_OK) {
        result = td_query_check_filter(w, filter);
    }
    if (result != THUD_OK) {
        return result;
    }
    if (!td_query_prepare(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "closest: out of memory");
    }
    /* The first box reaches one length scale; the factor of four is chosen, not tuned. Every shape
     * that is not found in the box is further away than `reach`. So the search may end when
     * best.distance <= reach. */
    thud_closest best = {.distance = 1e300};
    int nearest = TD_NONE;
    double reach = max_distance < (double)w->length_scale ? max_distance : (double)w->length_scale;
    for (bool first = true;; first = false) {
        thud_pos lower = {point.x - reach, point.y - reach};
        thud_pos upper = {point.x + reach, point.y + reach};
        if (!td_query_list(w, lower, upper) || (first && !td_query_list_terrains(w))) {
            return td_refuse(w, THUD_ERROR_MEMORY, "closest: out of memory");
        }
        keep_nearest(w, td_place_from(w, point), filter, &nearest, &best);
        if (best.distance <= reach || reach >= max_distance) {
            break;
        }
        reach = 4.0 * reach < max_distance ? 4.0 * reach : max_distance;
    }
    bool any = best.distance <= max_distance;
    if (out_found) {
        *out_found = any;
    }
    if (out && any) {
        *out = td_query_closest_hit(w, nearest, point, &best);
    }
    return THUD_OK;
}
