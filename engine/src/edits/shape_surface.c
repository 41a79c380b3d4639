/* shape_surface.c: setters of a shape's friction, restitution, surface speed, events and user data;
 * see thud_edits.h. */
#include "thud/thud_edits.h"

#include "edits/edit.h"
#include "solver/restitution.h"
#include "state/handles.h"
#include "state/shape.h"

#include <stddef.h>
#include <string.h>

/* Sets the float at offset `field` of td_shape, if it is in [min, max]. `name` is for the log. */
static thud_result set(thud_world *w, thud_shape_id id, size_t field, float value, float min,
                       float max, const char *name) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check(w, name, (double)value, (double)min, (double)max);
    if (result != THUD_OK) {
        return result;
    }
    td_shape *shape = td_shape_at(w, index);
    memcpy((char *)shape + field, &value, sizeof value);
    td_edit_settle_contacts(w, index);
    td_edit_wake(w, shape->body, index);
    return THUD_OK;
}

thud_result thud_shape_set_friction(thud_world *w, thud_shape_id id, float friction) {
    return set(w, id, offsetof(td_shape, friction), friction, 0.0f, THUD_FRICTION_MAX,
               "set friction: friction");
}

thud_result thud_shape_set_restitution(thud_world *w, thud_shape_id id, float restitution) {
    thud_result result = set(w, id, offsetof(td_shape, restitution), restitution, 0.0f,
                             THUD_RESTITUTION_MAX, "set restitution: restitution");
    if (result == THUD_OK) {
        w->restitution_hooks = &td_restitution;
    }
    return result;
}

thud_result thud_shape_set_surface_speed(thud_world *w, thud_shape_id id, float surface_speed) {
    TD_IN_OWN_FLOAT_MODE;
    float max = w ? THUD_SURFACE_SPEED_MAX * w->length_scale : 0.0f;
    return set(w, id, offsetof(td_shape, surface_speed), surface_speed, -max, max,
               "set surface speed: surface_speed");
}

thud_result thud_shape_set_events(thud_world *w, thud_shape_id id, bool events) {
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result == THUD_OK) {
        uint8_t *flags = &td_shape_at(w, index)->flags;
        *flags = (uint8_t)(events ? *flags & ~TD_SHAPE_SILENT : *flags | TD_SHAPE_SILENT);
    }
    return result;
}

thud_result thud_shape_set_user_data(thud_world *w, thud_shape_id id, uint64_t user_data) {
    int index = 0;
    thud_result result = td_find_shape(w, id, &index);
    if (result == THUD_OK) {
        td_shape_at(w, index)->user_data = user_data;
    }
    return result;
}
