/* body_kind.c: thud_body_set_kind, which makes a body static, kinematic or dynamic.
 *
 * Contacts, lanes, graph colours and the awake slot depend on the kind. So all of them are released
 * while the body still has its old kind; then the kind changes, and the body enters the world anew
 * with the next step, in the way of a body that is enabled (TD_CHANGE_ENABLE). */
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

/* Why the body's shapes do not fit a kinematic or dynamic body, or null: terrain, and sizes that
 * only a static body may have. */
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

/* Why the body's joints do not allow the kind, or null. A body with joints cannot become static,
 * and a static body with joints cannot become anything else. It does not become kinematic where one
 * of its joints is a gear, joins it to a body that is not dynamic, or is a wheel or target joint of
 * which it is the second body. */
static const char *joint_error(const thud_world *w, td_body_index index, int kind) {
    const td_body *body = td_body_at(w, index);
    for (int e = body->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *part = td_constraint_at(w, td_edge_constraint(e));
        if (td_is_contact(part)) {
            continue;
        }
        if (kind == THUD_BODY_STATIC || body->kind == THUD_BODY_STATIC) {
            return "set kind: a body with joints neither becomes static nor ceases to be";
        }
        const td_joint *joint = td_joint_of(w, part);
        bool second = td_same_body(joint->body[!joint->swapped], index);
        if (kind == THUD_BODY_KINEMATIC &&
            (joint->kind == THUD_JOINT_GEAR ||
             td_body_at(w, td_other_body(w, e))->kind != THUD_BODY_DYNAMIC ||
             (second && (joint->kind == THUD_JOINT_WHEEL || joint->kind == THUD_JOINT_TARGET)))) {
            return "set kind: a joint needs the body to be dynamic";
        }
    }
    return NULL;
}

/* Why the change is refused, or null. */
static const char *error_of(const thud_world *w, td_body_index index, int kind) {
    const td_body *body = td_body_at(w, index);
    if (kind < 0 || kind >= THUD_BODY_KIND_COUNT) {
        return "set kind: kind is none";
    }
    if (body->flags & TD_BODY_QUARANTINED) {
        return "set kind: the body is quarantined";
    }
    const char *error = kind == THUD_BODY_STATIC ? NULL : shape_error(w, body, kind);
    return error ? error : joint_error(w, index, kind);
}

/* Clears the internal edges of the body's shapes, which depend on the neighbours that a body of the
 * old kind had. */
static void clear_internal_edges(thud_world *w, const td_body *body) {
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape *shape = td_shape_at(w, i);
        shape->internal_edges = shape->hidden = 0;
        shape->flags &= (uint8_t)~TD_SHAPE_UNSEEN;
    }
}

/* The number of the body's sensors. */
static int sensors_of(const thud_world *w, const td_body *body) {
    int count = 0;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        count += (td_shape_at(w, i)->flags & TD_SHAPE_SENSOR) != 0;
    }
    return count;
}

/* Sets the kind and recomputes the mass from the shapes, also where the caller had set it. Clears
 * the forces, and the velocities that the new kind cannot have. */
static void set_kind(thud_world *w, td_body_index index, int kind) {
    td_body *body = td_body_at(w, index);
    int sensors = sensors_of(w, body);
    w->mobile_sensors -= body->kind == THUD_BODY_DYNAMIC ? sensors : 0;
    w->mobile_sensors += kind == THUD_BODY_DYNAMIC ? sensors : 0;
    body->kind = (uint8_t)kind;
    body->flags &= (uint8_t)~TD_BODY_MASS_GIVEN;
    td_body_weigh(w, index);
    float *velocity = body->velocity;
    if (kind == THUD_BODY_STATIC) {
        velocity[0] = velocity[1] = velocity[2] = 0.0f;
    } else if (kind == THUD_BODY_DYNAMIC && body->inv_inertia == 0.0f) {
        velocity[2] = 0.0f;
    }
    body->force[0] = body->force[1] = body->force[2] = 0.0f;
}

thud_result thud_body_set_kind(thud_world *w, thud_body_id id, thud_body_kind kind) {
    TD_IN_OWN_FLOAT_MODE;
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
    /* Either call may run out of memory, after which nothing must have changed. The second call
     * changes the world when it succeeds, so that it has to be the last one. */
    if (!td_edit_ends_reserve(w, index, TD_NONE, true) ||
        (w->internal_edges && !w->internal_edges->lose(w, index))) {
        return td_refuse(w, THUD_ERROR_MEMORY, "set kind: out of memory");
    }
    td_edit_end_contacts(w, index, TD_NONE, true);
    td_deferred_apply(
        w); /* edits that callbacks have deferred were meant for the body with its old kind */
    if (w->joint_hooks) {
        w->joint_hooks->suspend(w, index);
    }
    if (body->awake.at > 0) {
        td_awake_remove(w, index);
    }
    clear_internal_edges(w, body);
    set_kind(w, index, (int)kind);
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        *td_marks_at(w, i) |= TD_MARK_FRESH;
    }
    td_body_mark(w, index, TD_CHANGE_SHAPES | TD_CHANGE_ENABLE | TD_CHANGE_WAKE);
    return THUD_OK;
}
