/* query_cast.c: ray and shape casts that return their first hit or all hits. A cast first tests
 * every terrain along its whole path, since terrains are in no proxy set of the broadphase; then
 * the other shapes near the path, piece by piece from the origin on (path.h). */
#include "casts/path.h"

#include "state/handles.h"

/* ---- the search ---- */

/* Tests the shapes that are listed in scratch.found_shapes, and keeps hits at a fraction in
 * (after, until] of the path. */
static void keep_hits(const thud_world *w, const td_path *path, double after, double until,
                      td_nearest *nearest) {
    for (int i = 0; i < w->scratch.found_shapes.count; i++) {
        int shape = td_int_at(&w->scratch.found_shapes, i);
        thud_ray_hit hit;
        if (td_path_meets(w, shape, path, &hit) && hit.fraction > after && hit.fraction <= until) {
            hit.shape = td_shape_handle(w, shape);
            td_nearest_keep(nearest, &hit);
        }
    }
}

/* Casts along the whole path. `first_only`: only the nearest hit is needed, so that the cast ends
 * with the piece in which it lies. False when memory is short. */
static bool search(thud_world *w, td_path *path, bool first_only, td_nearest *nearest) {
    if (!td_query_prepare(w)) {
        return false;
    }
    path->from = td_place_from(w, path->origin);
    w->scratch.found_shapes.count = 0;
    if (!td_query_list_terrains(w)) {
        return false;
    }
    keep_hits(w, path, -1.0, 1.0, nearest);
    double piece_length = td_piece_first(w, path); /* a fraction of the path */
    /* `searched`: the fraction of the path that has been searched; -1 at first, so that hits at 0
     * count. */
    for (double searched = -1.0; searched < 1.0;) {
        double start = searched > 0.0 ? searched : 0.0, end = td_piece_end(start, piece_length);
        thud_pos lower, upper;
        td_piece_bounds(path, start, end, &lower, &upper);
        if (!td_query_list(w, lower, upper)) { /* which replaces the list */
            return false;
        }
        keep_hits(w, path, searched, end, nearest);
        if (first_only && nearest->count && nearest->hits[0].fraction <= end) {
            break;
        }
        piece_length = td_piece_next(piece_length, w->scratch.found_shapes.count);
        searched = end;
    }
    return true;
}

/* The nearest hit: *out_hit says whether there is one. Both outputs may be null. */
static thud_result cast_first(thud_world *w, td_path *path, bool *out_hit, thud_ray_hit *out) {
    thud_ray_hit hit;
    td_nearest nearest = {.hits = &hit, .capacity = 1};
    if (!search(w, path, true, &nearest)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    if (out_hit) {
        *out_hit = nearest.count > 0;
    }
    if (out && nearest.count > 0) {
        *out = hit;
    }
    return THUD_OK;
}

/* The nearest `capacity` hits in order. *out_count, which may be null, gets the number of all hits,
 * also of those for which there is no room. */
static thud_result cast_all(thud_world *w, td_path *path, thud_ray_hit *out, int capacity,
                            int *out_count) {
    td_nearest nearest = {.hits = out, .capacity = capacity};
    if (!search(w, path, false, &nearest)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    if (out_count) {
        *out_count = nearest.count;
    }
    return THUD_OK;
}

/* ---- arguments ---- */

/* Sets *path to that of a ray, or refuses the ray. */
static thud_result path_of_ray(const thud_world *w, const thud_ray *ray, td_path *path) {
    if (!w || !ray) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: a pointer is null");
    }
    *path = (td_path){
        .meets = td_point_meets,
        .origin = ray->origin,
        .dx = ray->dx,
        .dy = ray->dy,
        .filter = ray->filter,
    };
    return td_path_check(w, path);
}

/* Sets *path to that of a shape cast, or refuses it. The path keeps a pointer to the cast's shape.
 */
static thud_result path_of_shape_cast(const thud_world *w, const thud_shape_cast *cast,
                                      td_path *path) {
    if (!w || !cast) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: a pointer is null");
    }
    *path = (td_path){
        .meets = td_shape_meets,
        .origin = cast->center,
        .dx = cast->dx,
        .dy = cast->dy,
        .shape = &cast->shape,
        .filter = cast->filter,
    };
    thud_result result = td_path_check(w, path);
    if (result == THUD_OK && td_query_check(w, path->origin, path->shape) != THUD_OK) {
        result = td_refuse(w, THUD_ERROR_INVALID, "cast: the shape is invalid");
    }
    return result;
}

/* Refuses a negative capacity, and a null `out` with a capacity. */
static thud_result check_capacity(const thud_world *w, const thud_ray_hit *out, int capacity) {
    if (capacity < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "cast: capacity is negative");
    }
    return out || capacity == 0 ? THUD_OK
                                : td_refuse(w, THUD_ERROR_NULL, "cast: no room for the hits");
}

/* ---- calls ---- */

/* For movers: see query.h. */
thud_result td_query_cast_sensors(thud_world *w, const thud_shape_cast *cast, thud_ray_hit *out,
                                  int capacity, int *out_count) {
    td_path path;
    thud_result result = path_of_shape_cast(w, cast, &path);
    if (result != THUD_OK) {
        return result;
    }
    path.only_sensors = true;
    return cast_all(w, &path, out, capacity, out_count);
}

thud_result thud_world_cast_ray(thud_world *w, const thud_ray *ray, bool *out_hit,
                                thud_ray_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_path path;
    thud_result result = path_of_ray(w, ray, &path);
    return result != THUD_OK ? result : cast_first(w, &path, out_hit, out);
}

thud_result thud_world_cast_ray_all(thud_world *w, const thud_ray *ray, thud_ray_hit *out,
                                    int capacity, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    td_path path;
    thud_result result = path_of_ray(w, ray, &path);
    result = result != THUD_OK ? result : check_capacity(w, out, capacity);
    return result != THUD_OK ? result : cast_all(w, &path, out, capacity, out_count);
}

thud_result thud_world_cast_shape(thud_world *w, const thud_shape_cast *cast, bool *out_hit,
                                  thud_ray_hit *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_path path;
    thud_result result = path_of_shape_cast(w, cast, &path);
    return result != THUD_OK ? result : cast_first(w, &path, out_hit, out);
}

thud_result thud_world_cast_shape_all(thud_world *w, const thud_shape_cast *cast, thud_ray_hit *out,
                                      int capacity, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    td_path path;
    thud_result result = path_of_shape_cast(w, cast, &path);
    result = result != THUD_OK ? result : check_capacity(w, out, capacity);
    return result != THUD_OK ? result : cast_all(w, &path, out, capacity, out_count);
}
