/* query_overlap.c: overlap queries: candidates by bounds, sorted by slot, and tested exactly one by
 * one as the callback is called. */
#include "api/query.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* Whether a shape of the world overlaps the query's shape, which is relative to `origin`. */
static bool overlaps(const thud_world *w, int index, td_position origin,
                     const thud_geometry *exact) {
    thud_geometry shape = td_query_instance(w, index, origin);
    if (!td_kind_is_line(shape.kind)) {
        return thud_geometry_overlap(exact, &shape);
    }
    thud_terrain terrain = td_terrain_view(w, index);
    thud_geometry relative = *exact;
    relative.x -= shape.x;
    relative.y -= shape.y;
    return thud_terrain_overlap(&terrain, &relative);
}

/* Calls the callback for each candidate that overlaps, until it returns false. */
static void report_overlaps(thud_world *w, td_position origin, const thud_geometry *exact,
                            const thud_query_filter *filter, thud_overlap_fn *fn, void *context) {
    bool was_locked = w->locked;
    /* Queries that the callback makes list their candidates in an array of their own. */
    td_array found = w->scratch.found_shapes;
    w->scratch.found_shapes = (td_array){.stride = found.stride};
    w->locked = true;
    for (int i = 0; i < found.count; i++) {
        int index = td_int_at(&found, i);
        if (td_query_passes(w, index, filter) && overlaps(w, index, origin, exact) &&
            !fn(td_shape_handle(w, index), context)) {
            break;
        }
    }
    w->locked = was_locked;
    td_array_free(&w->memory, &w->scratch.found_shapes);
    w->scratch.found_shapes = found;
}

thud_result thud_world_overlap_shape(thud_world *w, thud_pos center, thud_geometry shape,
                                     const thud_query_filter *filter, thud_overlap_fn *fn,
                                     void *context) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !fn) {
        return td_refuse(w, THUD_ERROR_NULL, "overlap: a pointer is null");
    }
    if (td_query_check(w, center, &shape) != THUD_OK) {
        return td_refuse(w, THUD_ERROR_INVALID, "overlap: the shape or its place is invalid");
    }
    thud_result result = td_query_check_filter(w, filter);
    if (result != THUD_OK) {
        return result;
    }
    thud_pos lower, upper;
    td_query_bounds(center, &shape, &lower, &upper);
    if (!td_query_prepare(w) || !td_query_list(w, lower, upper) || !td_query_list_terrains(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "overlap: out of memory");
    }
    td_sort_ints(&w->scratch.found_shapes);
    report_overlaps(w, td_place_from(w, center), &shape, filter, fn, context);
    return THUD_OK;
}

thud_result thud_world_overlap_aabb(thud_world *w, thud_pos lower, thud_pos upper,
                                    const thud_query_filter *filter, thud_overlap_fn *fn,
                                    void *context) {
    TD_IN_OWN_FLOAT_MODE;
    thud_geometry box =
        thud_aabb_at(0.0, 0.0, 0.5 * (upper.x - lower.x), 0.5 * (upper.y - lower.y));
    thud_pos center = {lower.x + box.hx, lower.y + box.hy};
    return thud_world_overlap_shape(w, center, box, filter, fn, context);
}
