/* each.c: casts that tell a callback of their hits, one by one. */
#include "casts/walk.h"

#include "state/handles.h"
#include "thud/thud_casts.h"

/* Hits that are looked for at once. */
enum { BATCH = 16 };

static double told(const thud_world *w, const thud_ray_hit *hit, double limit, thud_cast_fn *fn,
                   void *context) {
    double answer = fn(hit, context);
    if (answer != answer) {
        td_refuse(w, THUD_ERROR_INVALID, "cast: the callback's answer is not a number");
    }
    return answer >= 0.0 && answer < 1.0 && answer < limit ? answer : limit;
}

static void tell(td_walk *walk, thud_cast_fn *fn, void *context) {
    const thud_world *w = walk->world;
    thud_ray_hit hits[BATCH];
    td_nearest k = {hits, BATCH, 0};
    double limit = 2.0; /* beyond the way */
    do {
        td_walk_next(walk, limit, &k);
        for (int i = 0; i < k.count && hits[i].fraction < limit; i++) {
            /* The callback may have destroyed it. */
            if (td_query_passes(w, (int)hits[i].shape.index1 - 1, walk->way->filter)) {
                limit = told(w, &hits[i], limit, fn, context);
            }
        }
    } while (k.count > 0);
}

static thud_result each(thud_world *w, td_path *way, thud_cast_fn *fn, void *context) {
    td_array *scratch = &w->scratch.hits;
    int size = td_walk_room(w);
    if (!td_query_prepare(w) || !td_array_reserve(&w->memory, scratch, size)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    way->from = td_place_from(w, way->origin);
    /* The callback may ask in turn: such queries list their candidates elsewhere. */
    td_array room = *scratch;
    *scratch = (td_array){.stride = room.stride};
    bool was_locked = w->locked;
    w->locked = true;
    td_walk walk = td_walk_begin(w, way, room.data, size);
    tell(&walk, fn, context);
    w->locked = was_locked;
    td_array_free(&w->memory, scratch);
    *scratch = room;
    return THUD_OK;
}

/* The callback may also write to what its caller gave: the cast goes by copies. */
static thud_query_filter copied(const thud_query_filter *filter) {
    return filter ? *filter : thud_default_query_filter();
}

thud_result thud_world_cast_ray_each(thud_world *w, thud_pos origin, double dx, double dy,
                                     const thud_query_filter *filter, thud_cast_fn *fn,
                                     void *context) {
    TD_IN_OWN_MODE;
    thud_query_filter own = copied(filter);
    td_path way = {td_point_meets, origin, .dx = dx, .dy = dy, .filter = &own};
    if (!w || !fn) {
        return td_refuse(w, THUD_ERROR_NULL, "cast ray: world or callback is null");
    }
    thud_result result = td_path_check(w, &way);
    return result != THUD_OK ? result : each(w, &way, fn, context);
}

thud_result thud_world_cast_shape_each(thud_world *w, thud_pos center,
                                       const thud_shape_instance *shape, double dx, double dy,
                                       const thud_query_filter *filter, thud_cast_fn *fn,
                                       void *context) {
    TD_IN_OWN_MODE;
    if (!w || !shape || !fn) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: world, shape or callback is null");
    }
    thud_query_filter own = copied(filter);
    thud_shape_instance moving = *shape;
    td_path way = {td_shape_meets, center, .dx = dx, .dy = dy, .shape = &moving, .filter = &own};
    thud_result result = td_path_check(w, &way);
    if (result == THUD_OK && td_query_check(w, center, &moving) != THUD_OK) {
        result = td_refuse(w, THUD_ERROR_INVALID, "cast: the shape is invalid");
    }
    return result != THUD_OK ? result : each(w, &way, fn, context);
}
