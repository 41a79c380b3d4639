/* body_volume.c: thud_body_get_volume, the bounding volume of a body: the bounding volumes of its
 * shapes, merged one by one (thud_volume_merge). */
#include "state/body.h"
#include "state/handles.h"
#include "state/preview.h"

#include "thud/thud_queries.h"

#define NO_VOLUME "body volume: no such volume, no shapes, or a line without end"

/* The volume around one shape, relative to `origin`; of a terrain, around its line. */
static thud_result around_shape(const thud_world *w, thud_shape_kind kind, int index,
                                td_position origin, thud_volume *out) {
    thud_geometry placed = td_shape_instance_of(w, index, td_preview_proxy(w, index), origin);
    if (!td_kind_is_line(placed.kind)) {
        return thud_volume_around_shape(kind, &placed, out);
    }
    thud_terrain line = td_terrain_view(w, index);
    bool uniform = line.kind == THUD_TERRAIN_UNIFORM;
    double first = uniform ? line.x0 : line.points[0].x;
    double last =
        uniform ? line.x0 + (line.count - 1) * line.spacing : line.points[line.count - 1].x;
    thud_result result = thud_volume_around_terrain(kind, &line, first, last, out);
    if (result == THUD_OK) {
        out->x += placed.x;
        out->y += placed.y;
    }
    return result;
}

/* Whether the shape lives and does not wait for the next step, as one that was made inside a
 * callback does. */
static bool counts(const td_shape *shape) {
    return (shape->flags & (TD_SHAPE_LIVE | TD_SHAPE_WAITS)) == TD_SHAPE_LIVE;
}

/* Whether `kind` is a kind of volume and the body has shapes that count, none of them endless
 * (flat) terrain. */
static bool has_volume(const thud_world *w, thud_shape_kind kind, td_body_index index) {
    bool any = false;
    for (int i = td_body_at(w, index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (!counts(shape)) {
            continue;
        }
        if (td_kind_is_line(shape->kind) && td_terrain_view(w, i).kind == THUD_TERRAIN_FLAT) {
            return false;
        }
        any = true;
    }
    return any && td_kind_is_volume(kind);
}

thud_result thud_body_get_volume(thud_world *w, thud_body_id id, thud_shape_kind kind,
                                 thud_pos origin, thud_volume *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    if (!w || !out) {
        return td_refuse(w, THUD_ERROR_NULL, "body volume: world or out is null");
    }
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_place(w, "body volume: x or y of origin", origin.x, origin.y);
    if (result != THUD_OK) {
        return result;
    }
    if (!has_volume(w, kind, index)) {
        return td_refuse(w, THUD_ERROR_INVALID, NO_VOLUME);
    }
    if (!w->locked && !td_preview_make(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "body volume: out of memory");
    }
    thud_volume volume, shape;
    bool first = true;
    int i = td_body_at(w, index)->first_shape;
    for (; i != TD_NONE && result == THUD_OK; i = td_shape_at(w, i)->next) {
        if (!counts(td_shape_at(w, i))) {
            continue;
        }
        result = around_shape(w, kind, i, td_place_from(w, origin), &shape);
        if (result == THUD_OK && !first) {
            result = thud_volume_merge(kind, &volume, &shape, &volume);
        } else {
            volume = shape;
        }
        first = false;
    }
    if (result != THUD_OK) {
        return td_refuse(w, result, NO_VOLUME);
    }
    *out = volume;
    return THUD_OK;
}
