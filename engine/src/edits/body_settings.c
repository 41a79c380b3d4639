/* body_settings.c: changing how a body moves, and what it weighs; see thud_edits.h. */
#include "thud/thud_edits.h"

#include "edits/edit.h"
#include "state/awake.h"
#include "state/body.h"
#include "state/handles.h"

/* The check is that of a def of which all but what is changed is the default. */
static thud_result find(const thud_world *w, thud_body_id id, const thud_body_def *def,
                        td_body_index *index) {
    thud_result result = td_edit_body(w, id, index);
    const char *error = result == THUD_OK ? td_body_def_error(w, def) : NULL;
    return error ? td_refuse(w, THUD_ERROR_INVALID, error) : result;
}

thud_result thud_body_set_damping(thud_world *w, thud_body_id id, float linear, float angular) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_body_def def = {.linear_damping = linear, .angular_damping = angular};
    thud_result result = find(w, id, &def, &index);
    if (result == THUD_OK) {
        td_body_at(w, index)->linear_damping = linear;
        td_body_at(w, index)->angular_damping = angular;
        td_awake_refresh(w, index);
        td_body_mark(w, index, TD_CHANGE_WAKE);
    }
    return result;
}

thud_result thud_body_set_gravity_scale(thud_world *w, thud_body_id id, float gravity_scale) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_body_def def = {.gravity_scale = gravity_scale};
    thud_result result = find(w, id, &def, &index);
    if (result == THUD_OK) {
        td_body_at(w, index)->gravity_scale = gravity_scale;
        td_awake_refresh(w, index);
        td_body_mark(w, index, TD_CHANGE_WAKE);
    }
    return result;
}

static void flag(td_body *body, int bit, bool on) {
    body->flags = (uint8_t)(on ? body->flags | bit : body->flags & ~bit);
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
        td_edit_weigh(w, index);
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

static const char *mass_error(const thud_world *w, const thud_mass *m) {
    float furthest = (float)TD_SIZE_MAX * w->unit;
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
    if (result == THUD_OK) {
        result = td_body_check_dynamic(w, index, "set mass: the body is not dynamic");
    }
    const char *error = result == THUD_OK && mass ? mass_error(w, mass) : NULL;
    if (result != THUD_OK || error) {
        return error ? td_refuse(w, THUD_ERROR_INVALID, error) : result;
    }
    td_body *body = td_body_at(w, index);
    flag(body, TD_BODY_MASS_GIVEN, mass != NULL);
    if (mass) {
        body->mass = mass->mass;
        body->inertia = mass->inertia;
        td_body_set_center(w, index, (double)mass->center.x, (double)mass->center.y);
    }
    if (mass && mass->inertia == 0.0f) {
        td_body_velocity(w, body)[2] = 0.0f;
    }
    td_edit_weigh(w, index);
    return THUD_OK;
}
