/* body_kind.c: a static body moves, a moving one stands; see thud_edits.h.
 *
 * Contacts, lanes, colours and the awake slot go by the kind, so that all of them are given back
 * while it is still what it was; the body then enters the world as one that is enabled does. */
#include "thud/thud_edits.h"

#include "constraint/constraint.h"
#include "constraint/joint_hooks.h"
#include "contact/internal_edges.h"
#include "edits/edit.h"
#include "joints/joint.h"
#include "state/awake.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

static const char *shape_error(const thud_world *w, const td_body *body, int kind) {
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (!(shape->flags & TD_SHAPE_LIVE)) {
            continue;
        }
        if (td_kind_is_line(shape->kind)) {
            return "set kind: a body with terrain is static";
        }
        if (!td_shape_size_valid(w, kind, shape->half_x) ||
            (td_kind_is_box(shape->kind) && !td_shape_size_valid(w, kind, shape->half_y))) {
            return "set kind: a shape is too large for what moves";
        }
    }
    return NULL;
}

/* What never moves by itself stands first in its joints, and gears measure from there. */
static const char *joint_error(const thud_world *w, td_body_index index, int kind) {
    const td_body *body = td_body_at(w, index);
    for (int e = body->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *part = td_constraint_at(w, e / 2);
        if (td_is_contact(part)) {
            continue;
        }
        if (kind == THUD_STATIC || body->kind == THUD_STATIC) {
            return "set kind: a body with joints neither becomes static nor ceases to be";
        }
        const td_joint *joint = td_joint_of(w, part);
        bool second = td_same_body(joint->body[!joint->swapped], index);
        if (kind == THUD_KINEMATIC &&
            (joint->kind == THUD_GEAR || td_body_at(w, td_other_body(w, e))->kind != THUD_DYNAMIC ||
             (second && (joint->kind == THUD_WHEEL || joint->kind == THUD_TARGET)))) {
            return "set kind: a joint needs the body to be dynamic";
        }
    }
    return NULL;
}

static const char *error_of(const thud_world *w, td_body_index index, int kind) {
    const td_body *body = td_body_at(w, index);
    if (kind < 0 || kind >= THUD_BODY_KIND_COUNT) {
        return "set kind: kind is none";
    }
    if (body->flags & TD_BODY_QUARANTINED) {
        return "set kind: the body is quarantined";
    }
    const char *error = kind == THUD_STATIC ? NULL : shape_error(w, body, kind);
    return error ? error : joint_error(w, index, kind);
}

/* Faces are hidden by neighbours on the ground, or by those of the same body. */
static void forget_edges(thud_world *w, const td_body *body) {
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape *shape = td_shape_at(w, i);
        shape->internal_edges = shape->hidden = 0;
        shape->flags &= (uint8_t)~TD_SHAPE_UNSEEN;
    }
}

static int sensors_of(const thud_world *w, const td_body *body) {
    int count = 0;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        count += (td_shape_at(w, i)->flags & TD_SHAPE_SENSOR) != 0;
    }
    return count;
}

static void take(thud_world *w, td_body_index index, int kind) {
    td_body *body = td_body_at(w, index);
    int sensors = sensors_of(w, body);
    w->mobile_sensors -= body->kind == THUD_DYNAMIC ? sensors : 0;
    w->mobile_sensors += kind == THUD_DYNAMIC ? sensors : 0;
    body->kind = (uint8_t)kind;
    body->flags &= (uint8_t)~TD_BODY_MASS_GIVEN;
    td_body_weigh(w, index);
    float *velocity = body->velocity;
    if (kind == THUD_STATIC) {
        velocity[0] = velocity[1] = velocity[2] = 0.0f;
    } else if (kind == THUD_DYNAMIC && body->inv_inertia == 0.0f) {
        velocity[2] = 0.0f;
    }
    body->force[0] = body->force[1] = body->force[2] = 0.0f;
}

thud_result thud_body_set_kind(thud_world *w, thud_body_id id, thud_body_kind kind) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const char *error = error_of(w, index, (int)kind);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    td_body *body = td_body_at(w, index);
    if (body->kind == kind) {
        return THUD_OK;
    }
    /* Internal edges are lost only once there is room for all: the last that may fail. */
    if (!td_edit_ends_reserve(w, index, TD_NONE, true) ||
        (w->internal_edges && !w->internal_edges->lose(w, index))) {
        return td_refuse(w, THUD_ERROR_MEMORY, "set kind: out of memory");
    }
    td_edit_end_contacts(w, index, TD_NONE, true);
    td_deferred_apply(w); /* what callbacks asked for was asked of the body as it was */
    if (w->joint_hooks) {
        w->joint_hooks->suspend(w, index);
    }
    if (body->awake.at > 0) {
        td_awake_remove(w, index);
    }
    forget_edges(w, body);
    take(w, index, (int)kind);
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        *td_marks_at(w, i) |= TD_MARK_FRESH;
    }
    td_body_mark(w, index, TD_CHANGE_SHAPES | TD_CHANGE_ENABLE | TD_CHANGE_WAKE);
    return THUD_OK;
}
