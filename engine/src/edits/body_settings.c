/* body_settings.c: changing how a body moves, and what it weighs; see thud_edits.h. */
#include "thud/thud_edits.h"

#include "edits/edit.h"
#include "state/awake.h"
#include "state/body.h"
#include "state/handles.h"

thud_result thud_body_set_damping(thud_world *w, thud_body_id id, float linear, float angular) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (!(linear >= 0.0f && angular >= 0.0f) || !td_finite((double)linear) ||
        !td_finite((double)angular)) {
        return td_refuse(w, THUD_ERROR_INVALID, "set damping: it is negative or not finite");
    }
    td_body_at(w, index)->linear_damping = linear;
    td_body_at(w, index)->angular_damping = angular;
    td_awake_refresh(w, index);
    td_body_mark(w, index, TD_CHANGE_WAKE);
    return THUD_OK;
}

thud_result thud_body_set_gravity_scale(thud_world *w, thud_body_id id, float gravity_scale) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (!td_finite((double)gravity_scale)) {
        return td_refuse(w, THUD_ERROR_INVALID, "set gravity scale: it is not finite");
    }
    td_body_at(w, index)->gravity_scale = gravity_scale;
    td_awake_refresh(w, index);
    td_body_mark(w, index, TD_CHANGE_WAKE);
    return THUD_OK;
}

static void flag(td_body *body, int bit, bool on) {
    body->flags = (uint8_t)(on ? body->flags | bit : body->flags & ~bit);
}

/* A mass that was given is not looked at by td_body_weigh, but what fixes the rotation is. */
static void weigh(thud_world *w, td_body_index index) {
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
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result == THUD_OK) {
        td_body *body = td_body_at(w, index);
        flag(body, TD_BODY_FIXED, fixed);
        if (fixed && body->kind == THUD_DYNAMIC) {
            td_body_velocity(w, body)[2] = 0.0f;
        }
        weigh(w, index);
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

/* The change of shapes has them expected as far as the body goes, where its detection asks. */
thud_result thud_body_set_detection(thud_world *w, thud_body_id id,
                                    const thud_detection *detection) {
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result == THUD_OK) {
        td_body *body = td_body_at(w, index);
        flag(body, TD_BODY_CHOSE, detection != NULL);
        body->detection = detection ? detection : w->quality.detection;
        w->detections[body->detection->rank] = body->detection;
        td_body_mark(w, index, TD_CHANGE_SHAPES);
    }
    return result;
}

static bool within(float x, float least, float most) {
    return x >= least && x <= most;
}

static const char *mass_error(const thud_world *w, const td_body *body, const thud_mass *m) {
    float furthest = THUD_SIZE_MAX * w->unit;
    if (body->kind != THUD_DYNAMIC) {
        return "set mass: the body is not dynamic";
    }
    if (!m) {
        return NULL;
    }
    if (!within(m->mass, THUD_MASS_MIN, THUD_MASS_MAX)) {
        return "set mass: mass is not in [1e-30, 1e30]";
    }
    if (m->inertia != 0.0f && !within(m->inertia, THUD_MASS_MIN, THUD_MASS_MAX)) {
        return "set mass: inertia is neither 0 nor in [1e-30, 1e30]";
    }
    if (!within(m->center.x, -furthest, furthest) || !within(m->center.y, -furthest, furthest)) {
        return "set mass: center is beyond 16384 length scales";
    }
    return NULL;
}

thud_result thud_body_set_mass(thud_world *w, thud_body_id id, const thud_mass *mass) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    const char *error = result == THUD_OK ? mass_error(w, td_body_at(w, index), mass) : NULL;
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
        center->x += from.x - to.x; /* the origin stays where it is */
        center->y += from.y - to.y;
    }
    if (mass && mass->inertia == 0.0f) {
        td_body_velocity(w, body)[2] = 0.0f;
    }
    weigh(w, index);
    return THUD_OK;
}
