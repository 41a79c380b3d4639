/* pair.c: thud_world_get_pair: the bodies, user data and sensor flags of the two shapes of a
 * contact or event. */
#include "lists/lists.h"

#include "thud/thud_lists.h"

/* One side of the pair; all zero if the shape has been destroyed. That is no error, since many end
 * events come from destroyed shapes. */
static thud_pair_side side_of(const thud_world *w, thud_shape_id id) {
    if (!thud_shape_is_valid(w, id)) {
        return (thud_pair_side){0};
    }
    const td_shape *shape = td_shape_at(w, (int)(id.index1 - 1));
    return (thud_pair_side){
        .body = td_body_handle(w, shape->body),
        .body_data = td_body_at(w, shape->body)->user_data,
        .shape_data = shape->user_data,
        .sensor = (shape->flags & TD_SHAPE_SENSOR) != 0,
    };
}

thud_result thud_world_get_pair(const thud_world *w, thud_shape_id shape_a, thud_shape_id shape_b,
                                thud_pair *out) {
    if (!w || !out) {
        return td_refuse(w, THUD_ERROR_NULL, "pair: world or out is null");
    }
    *out = (thud_pair){side_of(w, shape_a), side_of(w, shape_b)};
    return THUD_OK;
}
