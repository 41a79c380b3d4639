/* body_settings.c: setters of a body's damping, gravity scale, fixed rotation, sleep, detection and
 * mass; see thud_edits.h. Each changes td_body and marks the body as changed. Damping and gravity
 * scale are copied to the awake slot at once (td_awake_refresh), a new mass by the next step. */
#include "thud/thud_edits.h"

#include "edits/edit.h"
#include "state/awake.h"
#include "state/body.h"
#include "state/handles.h"

thud_result thud_body_set_damping(thud_world *w, thud_body_id id, float linear, float angular) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check(w, "set damping: linear", (double)linear, 0.0, (double)FLT_MAX);
    if (result == THUD_OK) {
        result = td_check(w, "set damping: angular", (double)angular, 0.0, (double)FLT_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    td_body_at(w, index)->linear_damping = linear;
    td_body_at(w, index)->angular_damping = angular;
    td_awake_refresh(w, index);
    td_body_mark(w, index, TD_CHANGE_WAKE);
    return THUD_OK;
}

thud_result thud_body_set_gravity_scale(thud_world *w, thud_body_id id, float gravity_scale) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_finite(w, "set gravity scale: gravity_scale", gravity_scale, 0.0f, 0.0f);
    if (result != THUD_OK) {
        return result;
    }
    td_body_at(w, index)->gravity_scale = gravity_scale;
    td_awake_refresh(w, index);
    td_body_mark(w, index, TD_CHANGE_WAKE);
    return THUD_OK;
}

/* Sets or clears a bit of td_body.flags. */
static void flag(td_body *body, int bit, bool on) {
    body->flags = (uint8_t)(on ? body->flags | bit : body->flags & ~bit);
}

/* Recomputes inverse mass and inertia. td_body_weigh leaves a mass that the caller set
 * (TD_BODY_MASS_GIVEN) alone, so that its inverses follow here: the inertia counts only while the
 * rotation is free. */
static void update_mass(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    float inv_mass = body->inv_mass, inv_inertia = body->inv_inertia;
    if (body->flags & TD_BODY_MASS_GIVEN) {
        bool turns = body->inertia > 0.0f && !(body->flags & TD_BODY_FIXED);
        body->inv_mass = 1.0f / body->mass;
        body->inv_inertia = turns ? 1.0f / body->inertia : 0.0f;
    }
    td_edit_weigh(w, index, inv_mass, inv_inertia);
}

thud_result thud_body_set_fixed_rotation(thud_world *w, thud_body_id id, bool fixed) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result == THUD_OK) {
        td_body *body = td_body_at(w, index);
        flag(body, TD_BODY_FIXED, fixed);
        if (fixed && body->kind == THUD_BODY_DYNAMIC) {
            td_body_velocity(w, body)[2] = 0.0f;
        }
        update_mass(w, index);
    }
    return result;
}

thud_result thud_body_set_may_sleep(thud_world *w, thud_body_id id, bool may_sleep) {
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result == THUD_OK) {
        flag(td_body_at(w, index), TD_BODY_RESTLESS, !may_sleep);
        td_body_mark(w, index, TD_CHANGE_WAKE);
    }
    return result;
}

/* With TD_CHANGE_SHAPES the next step recomputes the fat bounds of the shapes, which some
 * detections extend along the body's motion (extend_bounds in changes.c). */
thud_result thud_body_set_detection(thud_world *w, thud_body_id id,
                                    const thud_detection *detection) {
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result == THUD_OK) {
        td_body *body = td_body_at(w, index);
        flag(body, TD_BODY_OWN_DETECTION, detection != NULL);
        body->detection = detection ? detection : w->quality.detection;
        w->detections[body->detection->rank] = body->detection;
        td_body_mark(w, index, TD_CHANGE_SHAPES);
    }
    return result;
}

/* Why the mass is refused, or null. */
static const char *mass_error(const thud_world *w, const td_body *body, const thud_mass *m,
                              td_reason *why) {
    double max_offset = (double)(THUD_SIZE_MAX * w->length_scale);
    double min = (double)THUD_MASS_MIN, max = (double)THUD_MASS_MAX;
    if (body->kind != THUD_BODY_DYNAMIC) {
        return "set mass: the body is not dynamic";
    }
    if (!m) {
        return NULL;
    }
    bool in =
        td_in(why, "set mass: mass", (double)m->mass, min, max) &&
        (m->inertia == 0.0f || td_in(why, "set mass: inertia", (double)m->inertia, min, max)) &&
        td_in(why, "set mass: x of center", (double)m->center.x, -max_offset, max_offset) &&
        td_in(why, "set mass: y of center", (double)m->center.y, -max_offset, max_offset);
    return in ? NULL : why->text;
}

thud_result thud_body_set_mass(thud_world *w, thud_body_id id, const thud_mass *mass) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    td_reason why;
    const char *error = result == THUD_OK ? mass_error(w, td_body_at(w, index), mass, &why) : NULL;
    if (result != THUD_OK || error) {
        return error ? td_refuse(w, THUD_ERROR_INVALID, error) : result;
    }
    td_body *body = td_body_at(w, index);
    flag(body, TD_BODY_MASS_GIVEN, mass != NULL);
    if (mass) {
        body->mass = mass->mass;
        body->inertia = mass->inertia;
        td_position from = td_body_origin(w, index), *center = &td_pose_at(w, index)->center;
        body->center_x = mass->center.x;
        body->center_y = mass->center.y;
        td_position to = td_body_origin(w, index);
        center->x +=
            from.x - to.x; /* the centre moves in the body, so that the origin stays in its place */
        center->y += from.y - to.y;
    }
    if (mass && mass->inertia == 0.0f) {
        td_body_velocity(w, body)[2] = 0.0f;
    }
    update_mass(w, index);
    return THUD_OK;
}
