/* shape_meets.c: setters of a shape's filter and of whether it is a sensor: they end contacts, and
 * let the next step find new ones; see thud_edits.h. */
#include "thud/thud_edits.h"

#include "contact/internal_edges.h"
#include "contact/sensors.h"
#include "edits/edit.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* Internal edges exist only between neighbours with equal filters: TD_CHANGE_SHAPES makes the step
 * compute them anew. */
thud_result thud_shape_set_filter(thud_world *w, thud_shape_id id, thud_filter filter) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_shape *shape = td_shape_at(w, index);
    thud_filter before = shape->filter;
    shape->filter = filter;
    if (!td_edit_ends_reserve(w, shape->body, index, false)) {
        shape->filter = before;
        return td_refuse(w, THUD_ERROR_MEMORY, "set filter: out of memory");
    }
    td_edit_end_contacts(w, shape->body, index, false);
    td_edit_settle_contacts(w, index); /* a rule is found by the categories */
    td_edit_look_around(w, index);
    td_body_mark(w, shape->body, TD_CHANGE_SHAPES);
    if (!(filter.category | filter.mask | (uint32_t)filter.group)) {
        td_refuse(w, THUD_OK, "set filter: done, but the shape meets nothing: its filter is zero");
    }
    return THUD_OK;
}

thud_result thud_shape_set_sensor(thud_world *w, thud_shape_id id, bool sensor) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_shape *shape = td_shape_at(w, index);
    if (sensor == ((shape->flags & TD_SHAPE_SENSOR) != 0)) {
        return THUD_OK;
    }
    if (!td_edit_ends_reserve(w, shape->body, index, true)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "set sensor: out of memory");
    }
    td_edit_end_contacts(w, shape->body, index, true);
    int kind = td_body_at(w, shape->body)->kind;
    shape->flags ^= TD_SHAPE_SENSOR;
    w->sensor_hooks = &td_sensor_stages;
    w->sensors += sensor ? 1 : -1;
    w->mobile_sensors += kind == THUD_BODY_DYNAMIC ? (sensor ? 1 : -1) : 0;
    if (kind !=
        THUD_BODY_STATIC) { /* TD_CHANGE_SHAPES recomputes those of the body's other shapes */
        shape->internal_edges = shape->hidden = 0;
    }
    *td_marks_at(w, index) |= TD_MARK_FRESH;
    td_body_mark(w, shape->body, TD_CHANGE_SHAPES);
    return THUD_OK;
}
