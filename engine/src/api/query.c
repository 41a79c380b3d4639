/* query.c: what all queries share (query.h): the filter, checks of arguments, the query's own
 * shape, and the candidates: shapes whose fat bounds overlap a box, by the broadphase. */
#include "api/query.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/preview.h"
#include "state/shape.h"
#include "api/step.h"
#include "base/trig.h"

static const thud_query_filter match_all = {.category = UINT32_MAX, .mask = UINT32_MAX};

thud_query_filter thud_default_query_filter(void) {
    return match_all;
}

bool td_query_passes(const thud_world *w, int index, const thud_query_filter *filter) {
    const td_shape *shape = td_shape_at(w, index);
    const td_body *body = td_body_at(w, shape->body);
    const thud_query_filter *f = filter ? filter : &match_all;
    if ((shape->flags & (TD_SHAPE_LIVE | TD_SHAPE_WAITS)) != TD_SHAPE_LIVE ||
        (body->flags & TD_BODY_DISABLED) || (!f->sensors && shape->flags & TD_SHAPE_SENSOR) ||
        (f->ignore.index1 == (uint32_t)shape->body.at + 1 &&
         f->ignore.generation == td_tag(w, body->generation))) {
        return false;
    }
    if (f->group != 0 && f->group == shape->filter.group) {
        return f->group > 0;
    }
    return (shape->filter.category & f->mask) && (shape->filter.mask & f->category);
}

thud_result td_query_check_filter(const thud_world *w, const thud_query_filter *filter) {
    bool meets = !filter || filter->category || filter->mask || filter->group > 0;
    return meets ? THUD_OK
                 : td_refuse(w, THUD_ERROR_INVALID,
                             "query: category and mask of its filter are 0: begin with "
                             "thud_default_query_filter()");
}

thud_result td_query_check(const thud_world *w, thud_pos center, const thud_geometry *shape) {
    bool valid = thud_geometry_check(shape) == THUD_OK && td_place_valid(w, center.x, center.y) &&
                 td_place_valid(w, center.x + shape->x, center.y + shape->y);
    return valid ? THUD_OK : THUD_ERROR_INVALID;
}

thud_geometry td_query_instance(const thud_world *w, int index, td_position origin) {
    thud_geometry shape = td_shape_instance_of(w, index, td_preview_proxy(w, index), origin);
    double scale =
        1.5 - 0.5 * (shape.c * shape.c +
                     shape.s * shape.s); /* a Newton step for 1 / sqrt(x) from x = 1: scales (c, s)
                                            to length 1 in double precision */
    shape.c *= scale;
    shape.s *= scale;
    return shape;
}

void td_query_bounds(thud_pos center, const thud_geometry *shape, thud_pos *lower,
                     thud_pos *upper) {
    double half_x = td_half_along(shape, 1.0, 0.0), half_y = td_half_along(shape, 0.0, 1.0);
    double x = center.x + shape->x, y = center.y + shape->y;
    *lower = (thud_pos){x - half_x, y - half_y};
    *upper = (thud_pos){x + half_x, y + half_y};
}

/* ---- candidates ---- */

bool td_query_prepare(thud_world *w) {
    return (w->locked || td_preview_make(w)) && td_broadphase_refresh(w);
}

/* The position of (x, y), held to the outermost place that any part of a shape can reach:
 * differences of such positions fit in 64 bits. */
static td_position clamped_place(const thud_world *w, double x, double y) {
    double max = (THUD_PLACE_MAX + 2.0 * (double)THUD_SIZE_MAX) * (double)w->length_scale;
    return td_place_from(w, (thud_pos){td_clamp(x, -max, max), td_clamp(y, -max, max)});
}

/* Lists every shape but terrain. False when memory is short. */
static bool list_all(thud_world *w) {
    if (!td_array_reserve(&w->memory, &w->scratch.found_shapes, w->shapes.count)) {
        return false;
    }
    for (int i = 0; i < w->shapes.count; i++) {
        if (!td_kind_is_line(td_shape_at(w, i)->kind)) {
            td_push_int(&w->scratch.found_shapes, i);
        }
    }
    return true;
}

bool td_query_list(thud_world *w, thud_pos lower, thud_pos upper) {
    td_array *found = &w->scratch.found_shapes;
    found->stride = (int)sizeof(int);
    found->count = 0;
    td_position from = clamped_place(w, lower.x, lower.y), to = clamped_place(w, upper.x, upper.y);
    /* Bounds are 32-bit and wrap around: those of a wider box would be ambiguous. */
    int64_t max = (int64_t)((double)THUD_SIZE_MAX * TD_FIXED_ONE);
    if (to.x - from.x > max || to.y - from.y > max) {
        return list_all(w);
    }
    td_bounds bounds = {td_coarse(from.x), td_coarse(from.y), td_coarse(to.x) + 1,
                        td_coarse(to.y) + 1};
    return td_preview_find(w, &w->memory, &bounds, from, found);
}

bool td_query_list_terrains(thud_world *w) {
    td_array *found = &w->scratch.found_shapes;
    if (!td_array_reserve(&w->memory, found, found->count + w->terrains.live)) {
        return false;
    }
    for (int i = 0; i < w->terrains.count; i++) {
        const td_terrain_record *record = td_terrain_record_at(w, i);
        if (record->shape != TD_NONE) {
            td_push_int(found, record->shape);
        }
    }
    return true;
}
