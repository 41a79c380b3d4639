/* query_cast.c: ray and shape casts that return their first hit or all hits. A cast tests every
 * terrain at once, and then the shapes near its path piece by piece, from the origin on (path.h).
 */
#include "casts/path.h"

#include "state/handles.h"

/* ---- candidates ---- */

/* Tests the candidates in scratch.found_shapes, and keeps hits at a fraction in (after, until]. */
static void keep_hits(const thud_world *w, const td_path *way, double after, double until,
                      td_nearest *k) {
    for (int i = 0; i < w->scratch.found_shapes.count; i++) {
        int index = td_int_at(&w->scratch.found_shapes, i);
        thud_ray_hit hit;
        if (td_path_meets(w, index, way, &hit) && hit.fraction > after && hit.fraction <= until) {
            hit.shape = td_shape_handle(w, index);
            td_nearest_keep(k, &hit);
        }
    }
}

/* Casts along the whole path. `first`: only the nearest hit is needed, so that the cast ends with
 * the piece in which it lies. `done`: the fraction of the path that has been searched; -1 at first,
 * so that hits at 0 count. False when memory is short. */
static bool cast(thud_world *w, const td_path *way, bool first, td_nearest *k) {
    if (!td_query_prepare(w)) {
        return false;
    }
    w->scratch.found_shapes.count = 0;
    if (!td_query_list_terrains(w)) {
        return false;
    }
    keep_hits(w, way, -1.0, 1.0, k);
    double piece = td_piece_first(w, way);
    for (double done = -1.0; done < 1.0;) {
        double from = done > 0.0 ? done : 0.0, to = td_piece_end(from, piece);
        thud_pos lower, upper;
        td_piece_bounds(way, from, to, &lower, &upper);
        if (!td_query_list(w, lower, upper)) {
            return false;
        }
        keep_hits(w, way, done, to, k);
        if (first && k->count && k->hits[0].fraction <= to) {
            break;
        }
        piece = td_piece_next(piece, w->scratch.found_shapes.count);
        done = to;
    }
    return true;
}

/* The nearest hit. */
static thud_result cast_first(thud_world *w, td_path *way, bool *hit, thud_ray_hit *out) {
    thud_ray_hit nearest;
    td_nearest k = {&nearest, 1, 0};
    way->from = td_place_from(w, way->origin);
    if (!cast(w, way, true, &k)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    if (hit) {
        *hit = k.count > 0;
    }
    if (out && k.count > 0) {
        *out = nearest;
    }
    return THUD_OK;
}

/* The nearest `capacity` hits in order, and the number of all. */
static thud_result cast_all(thud_world *w, td_path *way, thud_ray_hit *out, int capacity,
                            int *count) {
    td_nearest k = {out, capacity, 0};
    way->from = td_place_from(w, way->origin);
    if (!cast(w, way, false, &k)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    if (count) {
        *count = k.count;
    }
    return THUD_OK;
}

/* ---- the API ---- */

static thud_result check_ray(const thud_world *w, const thud_ray *ray, td_path *way) {
    if (!w || !ray) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: world or ray is null");
    }
    *way =
        (td_path){td_point_meets, ray->origin, .dx = ray->dx, .dy = ray->dy, .filter = ray->filter};
    return td_path_check(w, way);
}

static thud_result check_shape(const thud_world *w, const thud_shape_cast *cast, td_path *way) {
    if (!w || !cast) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: world or cast is null");
    }
    *way = (td_path){td_shape_meets, cast->center,          .dx = cast->dx,
                     .dy = cast->dy, .shape = &cast->shape, .filter = cast->filter};
    thud_result result = td_path_check(w, way);
    if (result == THUD_OK && td_query_check(w, way->origin, way->shape) != THUD_OK) {
        result = td_refuse(w, THUD_ERROR_INVALID, "cast: the shape is invalid");
    }
    return result;
}

/* Refuses a negative capacity, and a null `out` with a capacity. */
static thud_result check_room(const thud_world *w, const thud_ray_hit *out, int capacity) {
    if (capacity < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "cast: capacity is negative");
    }
    return out || capacity == 0 ? THUD_OK
                                : td_refuse(w, THUD_ERROR_NULL, "cast: no room for the hits");
}

thud_result thud_world_cast_ray(thud_world *w, const thud_ray *ray, bool *out_hit,
                                thud_ray_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_path way;
    thud_result result = check_ray(w, ray, &way);
    return result != THUD_OK ? result : cast_first(w, &way, out_hit, out);
}

thud_result thud_world_cast_ray_all(thud_world *w, const thud_ray *ray, thud_ray_hit *out,
                                    int capacity, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    td_path way;
    thud_result result = check_ray(w, ray, &way);
    result = result != THUD_OK ? result : check_room(w, out, capacity);
    return result != THUD_OK ? result : cast_all(w, &way, out, capacity, out_count);
}

thud_result thud_world_cast_shape(thud_world *w, const thud_shape_cast *cast, bool *out_hit,
                                  thud_ray_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_path way;
    thud_result result = check_shape(w, cast, &way);
    return result != THUD_OK ? result : cast_first(w, &way, out_hit, out);
}

thud_result td_query_cast_sensors(thud_world *w, const thud_shape_cast *cast, thud_ray_hit *out,
                                  int capacity, int *count) {
    td_path way;
    thud_result result = check_shape(w, cast, &way);
    if (result != THUD_OK) {
        return result;
    }
    way.sensors = true;
    return cast_all(w, &way, out, capacity, count);
}

thud_result thud_world_cast_shape_all(thud_world *w, const thud_shape_cast *cast, thud_ray_hit *out,
                                      int capacity, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    td_path way;
    thud_result result = check_shape(w, cast, &way);
    result = result != THUD_OK ? result : check_room(w, out, capacity);
    return result != THUD_OK ? result : cast_all(w, &way, out, capacity, out_count);
}
