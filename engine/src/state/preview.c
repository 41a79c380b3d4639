/* preview.c: copies the proxies that pending edits will give to shapes, and finds shapes by them;
 * see preview.h. */
#include "state/preview.h"

#include "state/body.h"

/* Whether pending changes of the body will place its shapes anew. */
static bool is_placed_by_edits(const td_body *body) {
    return body->changes & (TD_CHANGE_ENTER | TD_CHANGE_SHAPES | TD_CHANGE_PLACE) &&
           !(body->changes & TD_CHANGE_LEAVE);
}

/* Whether the shape is in the world once edits have taken effect: it lives, and was not made inside
 * a callback. */
static bool counts(const td_shape *shape) {
    return (shape->flags & (TD_SHAPE_LIVE | TD_SHAPE_WAITS)) == TD_SHAPE_LIVE;
}

/* The number of shapes that copy_shapes may add in all. */
static int count_previewed(const thud_world *w) {
    int count = 0;
    for (int i = 0; i < w->changed.count; i++) {
        const td_body *body = td_body_at(w, td_body_in(&w->changed, i));
        count += is_placed_by_edits(body) ? body->shape_count : 0;
    }
    return count;
}

/* Adds the proxies of a body's shapes as they will be placed. */
static void copy_shapes(thud_world *w, const td_body *body) {
    td_preview *p = &w->preview;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (counts(td_shape_at(w, i))) {
            td_int_set(&p->number, i, p->shape.count);
            td_push_int(&p->shape, i);
            TD_PUSH(td_shape_proxy, &p->proxy) = td_shape_placed(w, i);
        }
    }
}

bool td_preview_make(thud_world *w) {
    td_preview *p = &w->preview;
    if (!p->stale) {
        return true;
    }
    int count = count_previewed(w);
    p->shape.count = p->proxy.count = 0;
    if (count > 0 && (!td_array_reserve(&w->memory, &p->shape, count) ||
                      !td_array_reserve(&w->memory, &p->proxy, count) ||
                      !td_array_reserve(&w->memory, &p->number, w->shapes.count))) {
        return false;
    }
    for (int i = 0; i < w->changed.count; i++) {
        const td_body *body = td_body_at(w, td_body_in(&w->changed, i));
        if (is_placed_by_edits(body)) {
            copy_shapes(w, body);
        }
    }
    p->stale = false;
    return true;
}

/* Removes from the hits the shapes that have a copy: they were found by the bounds of the world,
 * and a copy is searched by its own bounds. */
static void drop_previewed(const thud_world *w, td_array *hits) {
    int kept_count = 0, number;
    for (int i = 0; i < hits->count && w->preview.shape.count > 0; i++) {
        int shape = td_int_at(hits, i);
        td_int_set(hits, kept_count, shape);
        kept_count += !td_preview_has(w, shape, &number);
    }
    hits->count = w->preview.shape.count > 0 ? kept_count : hits->count;
}

bool td_preview_find(const thud_world *w, td_memory *memory, const td_bounds *bounds,
                     td_position near_place, td_array *hits) {
    const td_preview *p = &w->preview;
    td_find_fn *find = w->def.broadphase->find[w->wide];
    if (!find(&w->awake_shapes, memory, bounds, near_place, hits, NULL) ||
        !find(&w->rest_shapes, memory, bounds, near_place, hits, NULL)) {
        return false;
    }
    drop_previewed(w, hits);
    if (!td_array_reserve(memory, hits, hits->count + p->shape.count)) {
        return false;
    }
    for (int i = 0; i < p->shape.count; i++) {
        int shape = td_int_at(&p->shape, i);
        if (!td_kind_is_line(td_shape_at(w, shape)->kind) &&
            td_bounds_overlap(&TD_AT(td_shape_proxy, &p->proxy, i)->fat, bounds)) {
            td_push_int(hits, shape);
        }
    }
    return true;
}
