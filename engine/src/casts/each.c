/* each.c: casts that call a function for each hit in order. The callback may clip the rest of the
 * path; the search goes no further than the clip (walk.h). */
#include "casts/walk.h"

#include "state/handles.h"
#include "thud/thud_casts.h"

/* Hits that td_walk_next finds before the callback is called for them. Chosen; not tuned. Smaller
 * batches test the candidates of a piece more often, larger ones test shapes needlessly that lie
 * behind the place at which the callback clips the path. */
enum { BATCH = 16 };

/* Calls the callback for one hit; returns the new limit, a fraction of the path, which never grows.
 * A limit of 1 or more means that there is none. */
static double call_back(const thud_world *w, const thud_ray_hit *hit, double limit,
                        thud_cast_fn *fn, void *context) {
    double answer = fn(hit, context);
    if (answer != answer) {
        td_refuse(w, THUD_ERROR_INVALID, "cast: the callback's answer is not a number");
    }
    return answer >= 0.0 && answer < 1.0 && answer < limit ? answer : limit;
}

/* Calls the callback for all hits in order, until the limit. */
static void report_hits(td_walk *walk, thud_cast_fn *fn, void *context) {
    const thud_world *w = walk->world;
    thud_ray_hit hits[BATCH];
    td_nearest k = {hits, BATCH, 0};
    double limit = 2.0; /* above any fraction */
    do {
        td_walk_next(walk, limit, &k);
        for (int i = 0; i < k.count && hits[i].fraction < limit; i++) {
            /* The callback may have destroyed the shape since it was found. */
            if (td_query_passes(w, (int)hits[i].shape.index1 - 1, walk->way->filter)) {
                limit = call_back(w, &hits[i], limit, fn, context);
            }
        }
    } while (k.count > 0);
}

/* The cast after its checks. */
static thud_result each(thud_world *w, td_path *way, thud_cast_fn *fn, void *context) {
    td_array *scratch = &w->scratch.found_shapes;
    int size = td_walk_room(w);
    if (!td_query_prepare(w) || !td_array_reserve(&w->memory, scratch, size)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    way->from = td_place_from(w, way->origin);
    /* Queries that the callback makes list their candidates in an array of their own. */
    td_array room = *scratch;
    *scratch = (td_array){.stride = room.stride};
    bool was_locked = w->locked;
    w->locked = true;
    td_walk walk = td_walk_begin(w, way, room.data, size);
    report_hits(&walk, fn, context);
    w->locked = was_locked;
    td_array_free(&w->memory, scratch);
    *scratch = room;
    return THUD_OK;
}

/* A copy of the caller's filter, since the callback may change the original while the cast goes on.
 */
static thud_query_filter copied(const thud_query_filter *filter) {
    return filter ? *filter : thud_default_query_filter();
}

thud_result thud_world_cast_ray_each(thud_world *w, const thud_ray *ray, thud_cast_fn *fn,
                                     void *context) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !ray || !fn) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: a pointer is null");
    }
    thud_query_filter own = copied(ray->filter);
    td_path way = {td_point_meets, ray->origin, .dx = ray->dx, .dy = ray->dy, .filter = &own};
    thud_result result = td_path_check(w, &way);
    return result != THUD_OK ? result : each(w, &way, fn, context);
}

thud_result thud_world_cast_shape_each(thud_world *w, const thud_shape_cast *cast, thud_cast_fn *fn,
                                       void *context) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !cast || !fn) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: a pointer is null");
    }
    thud_query_filter own = copied(cast->filter);
    thud_geometry moving = cast->shape;
    td_path way = {td_shape_meets, cast->center,     .dx = cast->dx,
                   .dy = cast->dy, .shape = &moving, .filter = &own};
    thud_result result = td_path_check(w, &way);
    if (result == THUD_OK && td_query_check(w, way.origin, &moving) != THUD_OK) {
        result = td_refuse(w, THUD_ERROR_INVALID, "cast: the shape is invalid");
    }
    return result != THUD_OK ? result : each(w, &way, fn, context);
}
