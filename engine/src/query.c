/* query.c: rays and overlaps against the whole world. Pending edits are applied first, so that a
 * query sees what the caller made; inside a callback it sees the step as it stands. */
#include "body.h"
#include "handles.h"
#include "kinds.h"
#include "shape.h"
#include "step.h"

#include <stdlib.h>

thud_query_filter thud_default_query_filter(void)
{
    return (thud_query_filter){UINT32_MAX, UINT32_MAX, false};
}

static bool passes(const thud_world *w, int index, const thud_query_filter *filter)
{
    const td_shape *shape = td_shape_at(w, index);
    thud_query_filter f = filter ? *filter : thud_default_query_filter();
    return (shape->flags & TD_SHAPE_LIVE) && (f.sensors || !(shape->flags & TD_SHAPE_SENSOR)) &&
           (shape->filter.category & f.mask) && (shape->filter.mask & f.category);
}

static int by_slot(const void *a, const void *b)
{
    return (*(const int *)a > *(const int *)b) - (*(const int *)a < *(const int *)b);
}

/* Lists in scratch.hits, in the order of their slots, the shapes whose bounds overlap the box, and
 * every terrain. Boxes too wide for the wrapping bounds list every shape. */
static bool candidates(thud_world *w, td_place lower, td_place upper)
{
    td_array *hits = &w->scratch.hits;
    if ((!w->locked && !td_changes_apply(w)) || !td_broadphase_refresh(w) ||
        !td_array_reserve(&w->memory, hits, w->shapes.count)) {
        return false;
    }
    hits->count = 0;
    int64_t most = (int64_t)(TD_SIZE_MAX * TD_FIXED_ONE);
    if (upper.x - lower.x > most || upper.y - lower.y > most) {
        for (int i = 0; i < w->shapes.count; i++) {
            td_push_int(hits, i);
        }
        return true;
    }
    td_bounds bounds = {td_coarse(lower.x), td_coarse(lower.y), td_coarse(upper.x) + 1,
                        td_coarse(upper.y) + 1};
    td_find_fn *query = w->def.broadphase->find[w->wide];
    if (!query(&w->awake_shapes, &w->memory, &bounds, lower, hits) ||
        !query(&w->rest_shapes, &w->memory, &bounds, lower, hits) ||
        !td_array_reserve(&w->memory, hits, hits->count + w->terrains.live)) {
        return false;
    }
    for (int i = 0; i < w->terrains.count; i++) {
        const td_terrain_record *record = td_slot_at(&w->terrains, i);
        if (record->shape != TD_NONE) {
            td_push_int(hits, record->shape);
        }
    }
    qsort(hits->data, (size_t)hits->count, sizeof(int), by_slot);
    return true;
}

static bool in_range(const thud_world *w, double x, double y)
{
    double most = TD_PLACE_MAX * (double)w->unit;
    return x >= -most && x <= most && y >= -most && y <= most;
}

/* ---- rays ---- */

static bool ray_hits(const thud_world *w, int index, td_place origin, double dx, double dy,
                     double *fraction, double *nx, double *ny)
{
    thud_placed shape = td_shape_placed(w, index, origin);
    if (shape.kind == THUD_TERRAIN) {
        thud_terrain terrain = td_terrain_view(w, index);
        return thud_terrain_cast_ray(&terrain, -shape.x, -shape.y, dx, dy, fraction, nx, ny);
    }
    return thud_shape_cast_ray(&shape, 0.0, 0.0, dx, dy, fraction, nx, ny);
}

thud_result thud_world_cast_ray(thud_world *w, thud_pos origin, double dx, double dy,
                                const thud_query_filter *filter, bool *hit, thud_ray_hit *out)
{
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (!in_range(w, origin.x, origin.y) || !in_range(w, origin.x + dx, origin.y + dy)) {
        return td_refuse(w, THUD_ERROR_INVALID, "cast ray: not finite or out of range");
    }
    td_place from = td_place_from(w, origin);
    td_place to = td_place_from(w, (thud_pos){origin.x + dx, origin.y + dy});
    td_place lower = {from.x < to.x ? from.x : to.x, from.y < to.y ? from.y : to.y};
    td_place upper = {from.x < to.x ? to.x : from.x, from.y < to.y ? to.y : from.y};
    if (!candidates(w, lower, upper)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast ray: out of memory");
    }
    thud_ray_hit best = {.fraction = 2.0};
    for (int i = 0; i < w->scratch.hits.count; i++) {
        int index = *(int *)td_at(&w->scratch.hits, i);
        double fraction, nx, ny;
        if (passes(w, index, filter) && ray_hits(w, index, from, dx, dy, &fraction, &nx, &ny) &&
            fraction < best.fraction) {
            best = (thud_ray_hit){.shape = td_shape_handle(w, index),
                                  .point = {origin.x + fraction * dx, origin.y + fraction * dy},
                                  .normal = {(float)nx, (float)ny},
                                  .fraction = fraction};
        }
    }
    bool found = best.fraction <= 1.0;
    if (hit) {
        *hit = found;
    }
    if (out && found) {
        *out = best;
    }
    return THUD_OK;
}

/* ---- overlaps ---- */

/* Tells `fn` of the candidates that pass; `exact` null: by bounds alone. */
static void tell(thud_world *w, td_place origin, const thud_placed *exact,
                 const thud_query_filter *filter, thud_overlap_fn *fn, void *context)
{
    bool was_locked = w->locked;
    w->locked = true;
    for (int i = 0; i < w->scratch.hits.count; i++) {
        int index = *(int *)td_at(&w->scratch.hits, i);
        if (!passes(w, index, filter)) {
            continue;
        }
        thud_placed shape = td_shape_placed(w, index, origin);
        bool overlaps = true;
        if (shape.kind == THUD_TERRAIN) {
            thud_terrain terrain = td_terrain_view(w, index);
            thud_placed relative = *exact;
            relative.x -= shape.x;
            relative.y -= shape.y;
            overlaps = thud_terrain_overlap(&terrain, &relative);
        } else {
            overlaps = thud_shapes_overlap(exact, &shape);
        }
        if (overlaps && !fn(td_shape_handle(w, index), context)) {
            break;
        }
    }
    w->locked = was_locked;
}

static thud_result overlap(thud_world *w, thud_pos center, const thud_placed *shape, double half_x,
                           double half_y, const thud_query_filter *filter, thud_overlap_fn *fn,
                           void *context)
{
    td_place lower = td_place_from(w, (thud_pos){center.x + shape->x - half_x,
                                                 center.y + shape->y - half_y});
    td_place upper = td_place_from(w, (thud_pos){center.x + shape->x + half_x,
                                                 center.y + shape->y + half_y});
    if (!candidates(w, lower, upper)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "overlap: out of memory");
    }
    tell(w, td_place_from(w, center), shape, filter, fn, context);
    return THUD_OK;
}

thud_result thud_world_overlap_aabb(thud_world *w, thud_pos lower, thud_pos upper,
                                    const thud_query_filter *filter, thud_overlap_fn *fn,
                                    void *context)
{
    if (!w || !fn) {
        return td_refuse(w, THUD_ERROR_NULL, "overlap: world or callback is null");
    }
    if (!in_range(w, lower.x, lower.y) || !in_range(w, upper.x, upper.y) ||
        !(lower.x < upper.x && lower.y < upper.y)) {
        return td_refuse(w, THUD_ERROR_INVALID, "overlap: the box is empty or out of range");
    }
    thud_placed box = {.kind = THUD_AABB, .c = 1.0, .hx = 0.5 * (upper.x - lower.x),
                       .hy = 0.5 * (upper.y - lower.y)};
    thud_pos center = {lower.x + box.hx, lower.y + box.hy};
    return overlap(w, center, &box, box.hx, box.hy, filter, fn, context);
}

thud_result thud_world_overlap_shape(thud_world *w, thud_pos center, const thud_placed *shape,
                                     const thud_query_filter *filter, thud_overlap_fn *fn,
                                     void *context)
{
    if (!w || !fn || !shape) {
        return td_refuse(w, THUD_ERROR_NULL, "overlap: world, shape or callback is null");
    }
    if (!in_range(w, center.x, center.y) || thud_placed_check(shape) != THUD_OK ||
        !in_range(w, center.x + shape->x, center.y + shape->y)) {
        return td_refuse(w, THUD_ERROR_INVALID, "overlap: the shape or its place is invalid");
    }
    double reach = shape->hx + shape->hy;
    return overlap(w, center, shape, reach, reach, filter, fn, context);
}
