/* one_shape.c: queries of one shape: a ray against it, whether it contains a point, its closest
 * point to a point, and its bounds. Like all queries they see the shape where the edits made so far
 * put it. */
#include "casts/path.h"

#include "state/handles.h"
#include "state/preview.h"
#include "state/shape.h"
#include "thud/thud_casts.h"

/* Finds a shape. Refuses one that was made inside the callback that asks, since it is not in the
 * world yet. */
static thud_result find(const thud_world *w, thud_shape_id id, int *index) {
    thud_result result = td_find_shape(w, id, index);
    if (result == THUD_OK && w->locked && td_shape_at(w, *index)->flags & TD_SHAPE_WAITS) {
        return td_refuse(w, THUD_ERROR_LOCKED, "this shape was made inside the callback");
    }
    return result;
}

/* Brings the preview of edits (preview.h) up to date. Not inside a callback, where it must not
 * change. */
static thud_result prepare(thud_world *w) {
    return w->locked || td_preview_make(w)
               ? THUD_OK
               : td_refuse(w, THUD_ERROR_MEMORY, "asking a shape: out of memory");
}

/* As `find`; also refuses a place that is out of range. */
static thud_result find_about(const thud_world *w, thud_shape_id id, thud_pos place, int *index) {
    thud_result result = find(w, id, index);
    return result != THUD_OK
               ? result
               : td_check_place(w, "asking a shape: x or y of point", place.x, place.y);
}

/* Finds the shape, and computes its distance, normal and closest point to `point`. */
static thud_result measure(thud_world *w, thud_shape_id id, thud_pos point, int *index,
                           thud_closest *closest) {
    thud_result result = find_about(w, id, point, index);
    result = result != THUD_OK ? result : prepare(w);
    if (result == THUD_OK) {
        td_query_measure(w, *index, td_place_from(w, point), closest);
    }
    return result;
}

thud_result thud_shape_cast_ray(thud_world *w, thud_shape_id id, thud_pos origin, double dx,
                                double dy, bool *out_hit, thud_ray_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    int index;
    td_path way = {.origin = origin, .dx = dx, .dy = dy};
    thud_result result = find(w, id, &index);
    result = result != THUD_OK ? result : td_path_check(w, &way);
    result = result != THUD_OK ? result : prepare(w);
    if (result != THUD_OK) {
        return result;
    }
    thud_ray_hit met = {.shape = id};
    way.from = td_place_from(w, origin);
    bool any = td_point_meets(w, index, &way, &met);
    if (out_hit) {
        *out_hit = any;
    }
    if (out && any) {
        *out = met;
    }
    return THUD_OK;
}

thud_result thud_shape_contains_point(thud_world *w, thud_shape_id id, thud_pos point,
                                      bool *out_inside) {
    TD_IN_OWN_FLOAT_MODE;
    int index;
    if (!w || !out_inside) {
        return td_refuse(w, THUD_ERROR_NULL, "shape contains point: world or inside is null");
    }
    thud_closest c;
    thud_result result = measure(w, id, point, &index, &c);
    if (result == THUD_OK) {
        *out_inside = c.distance <= 0.0;
    }
    return result;
}

thud_result thud_shape_closest_point(thud_world *w, thud_shape_id id, thud_pos point,
                                     thud_closest_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    int index;
    if (!w || !out) {
        return td_refuse(w, THUD_ERROR_NULL, "shape's closest point: world or out is null");
    }
    thud_closest c;
    thud_result result = measure(w, id, point, &index, &c);
    if (result == THUD_OK) {
        *out = td_query_closest_hit(w, index, point, &c);
    }
    return result;
}

/* The bounding box of a terrain's vertices, relative to its origin. */
static void line_bounds(const thud_terrain *line, thud_pos *lower, thud_pos *upper) {
    *lower = (thud_pos){1e300, 1e300};
    *upper = (thud_pos){-1e300, -1e300};
    for (int i = 0; i < line->count; i++) {
        bool uniform = line->kind == THUD_TERRAIN_UNIFORM;
        double x = uniform ? line->x0 + i * line->spacing : line->points[i].x;
        double y = line->points[i].y;
        *lower = (thud_pos){x < lower->x ? x : lower->x, y < lower->y ? y : lower->y};
        *upper = (thud_pos){x > upper->x ? x : upper->x, y > upper->y ? y : upper->y};
    }
}

thud_result thud_shape_get_bounds(thud_world *w, thud_shape_id id, thud_pos *out_lower,
                                  thud_pos *out_upper) {
    TD_IN_OWN_FLOAT_MODE;
    int index;
    if (!w || !out_lower || !out_upper) {
        return td_refuse(w, THUD_ERROR_NULL, "shape bounds: world, lower or upper is null");
    }
    thud_result result = find(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    bool line = td_kind_is_line(td_shape_at(w, index)->kind);
    if (line && td_terrain_view(w, index).kind == THUD_TERRAIN_FLAT) {
        return td_refuse(w, THUD_ERROR_INVALID, "shape bounds: a line without end");
    }
    result = prepare(w);
    if (result != THUD_OK) {
        return result;
    }
    thud_geometry shape = td_query_instance(w, index, (td_position){0, 0});
    if (line) {
        thud_terrain terrain = td_terrain_view(w, index);
        line_bounds(&terrain, out_lower, out_upper);
        *out_lower = (thud_pos){shape.x + out_lower->x, shape.y + out_lower->y};
        *out_upper = (thud_pos){shape.x + out_upper->x, shape.y + out_upper->y};
    } else {
        td_query_bounds((thud_pos){0.0, 0.0}, &shape, out_lower, out_upper);
    }
    return THUD_OK;
}
