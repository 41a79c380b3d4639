/* quality.c: checks a quality (thud_quality.h: substeps, contact softness, detection, island
 * solver) and makes the world use it; and the public calls that set the quality and max_error. See
 * quality.h. */
#include "solver/quality.h"

#include "constraint/joint_hooks.h"
#include "state/body.h"
#include "state/handles.h"
#include "constraint/lanes.h"

const char *td_quality_error(const thud_quality *q, td_reason *why) {
    if (!q->detection) {
        return "quality: detection is null";
    }
    bool in =
        td_in(why, "quality: substeps", q->substeps, 1.0, THUD_SUBSTEPS_MAX) &&
        td_float_in(why, "quality: contact_stiffness", q->contact_stiffness,
                    THUD_CONTACT_STIFFNESS_MIN, THUD_CONTACT_STIFFNESS_MAX) &&
        td_float_in(why, "quality: contact_damping", q->contact_damping, 0.0f,
                    THUD_CONTACT_DAMPING_MAX) &&
        td_float_in(why, "quality: overlap_limit", q->overlap_limit, 0.0f, __builtin_inff()) &&
        td_in(why, "quality: island_limit", q->island_limit, 1.0, THUD_ISLAND_LIMIT_MAX) &&
        td_in(why, "quality: island_work", (double)q->island_work, 0.0, (double)INT64_MAX) &&
        td_in(why, "quality: island_slow_steps", q->island_slow_steps, 0.0,
              THUD_ISLAND_SLOW_STEPS_MAX);
    return in ? NULL : why->text;
}

const char *td_check_max_error(double max_error, const thud_quality *quality, td_reason *why) {
    if (!td_in(why, "max_error", max_error, 0.0, THUD_MAX_ERROR_MAX)) {
        return why->text;
    }
    return max_error > 0.0 && !quality->islands ? "max_error needs a quality with an island solver"
                                                : NULL;
}

/* The skin: the gap that the solver leaves between resting shapes, length. The detections `bisect`
 * and `swept` start from shapes that do not overlap, and need the gap; `overlap` and `continuous`
 * need none. */
static float skin_of(const thud_world *w) {
    /* At overlap_limit 0 the island solver solves every island. Contacts do not give way under a
     * load then, so that a thinner gap is enough. */
    bool direct = w->quality.islands && w->quality.overlap_limit == 0.0f;
    float gap = direct ? TD_IMPACT_DISTANCE : TD_SKIN; /* length scales */
    return w->quality.detection->rank >= TD_RANK_BISECT ? gap * w->length_scale : 0.0f;
}

/* Sets the detection of all bodies that have none of their own, and the skin. w->quality is set
 * already. */
static void set_detection(thud_world *w) {
    float skin = skin_of(w);
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        td_body *body = td_body_at(w, i);
        if (!(body->flags & TD_BODY_OWN_DETECTION)) {
            body->detection = w->quality.detection;
        }
    }
    if (skin == w->skin) {
        return;
    }
    w->skin = skin;
    /* Lanes hold separations less the skin: the next narrowphase computes all of them again. */
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, i);
        if (constraint->live && constraint->state == TD_TOUCHING) {
            td_lane_renew(w, i);
        }
    }
}

/* Multiplies the warm-start impulses of all constraints that act, contacts and joints. */
static void scale_impulses(thud_world *w, float scale) {
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, i);
        if (!constraint->live || constraint->state != TD_TOUCHING) {
            continue;
        }
        td_lane at = td_lane_of(w, constraint);
        at.block->tangent_impulse[at.lane] *= scale;
        for (int k = 0; k < td_form_points(w->kinds[constraint->kind]->form); k++) {
            at.block->point[k].normal_impulse[at.lane] *= scale;
        }
    }
}

int td_substeps_asked(const thud_world *w) {
    return w->def.substeps ? w->def.substeps : w->quality.substeps;
}

/* Minimum of substeps of a quality that gets its island solver from the detection, as draft does:
 * the number of default. With the two of draft, islands that are too large for the direct solver
 * give way under their load by more than the skin, 5 mm in a pyramid of 30 rows of 1 m. */
enum { SUBSTEPS_MIN = 4 };

/* `bisect` and `swept` let nothing overlap. Soft contacts under a load do overlap. gaps.c pushes
 * such shapes apart again, but without friction, so that a column which stands under `continuous`
 * would fall. These two detections therefore bring an island solver of their own. Within the
 * quality's limits it solves islands without joints directly, and their contacts do not give way.
 * Islands with joints are solved directly only if the quality itself names an island solver. With
 * an island_limit of 1 every island stays with the soft solver. */
static void take_island_solver(thud_quality *q) {
    if (q->detection->islands && !q->islands && q->island_limit > 1) {
        q->islands = q->detection->islands;
        q->substeps = td_max_int(q->substeps, SUBSTEPS_MIN);
    }
}

void td_substeps_set(thud_world *w, int substeps) {
    if (substeps != w->substeps) {
        /* An impulse of one substep is a force times the length of a substep. */
        scale_impulses(w, (float)w->substeps / (float)substeps);
        w->substeps = substeps;
        w->substep_gain_stale = true;
    }
}

/* Takes over the quality, except for what the world's def sets itself. */
static void take_quality(thud_world *w, const thud_quality *quality) {
    w->quality = *quality;
    /* A value of 0 in the def is not set, and leaves that of the quality. */
    if (w->def.contact_stiffness != 0.0f) {
        w->quality.contact_stiffness = w->def.contact_stiffness;
    }
    if (w->def.contact_damping != 0.0f) {
        w->quality.contact_damping = w->def.contact_damping;
    }
    if (w->def.detection) {
        w->quality.detection = w->def.detection;
    }
    take_island_solver(&w->quality);
    /* In a world with joints the direct solver is replaced by the one that also solves joints
     * (joint_hooks.h). */
    if (w->joint_hooks && w->quality.islands) {
        w->quality.islands = w->joint_hooks->islands;
    }
    w->detections[w->quality.detection->rank] = w->quality.detection;
}

void td_quality_begin(thud_world *w) {
    take_quality(w, w->def.quality);
    w->substeps = td_substeps_asked(w);
    w->substep_gain_stale = true;
    w->skin = skin_of(w);
}

static void apply_quality(thud_world *w, const thud_quality *quality) {
    take_quality(w, quality);
    td_substeps_set(w, td_substeps_asked(w));
    set_detection(w);
}

thud_result thud_world_set_quality(thud_world *w, const thud_quality *quality) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !quality) {
        return td_refuse(w, THUD_ERROR_NULL, "set quality: world or quality is null");
    }
    td_reason why;
    const char *error = td_quality_error(quality, &why);
    error = error ? error : td_check_max_error(w->def.max_error, quality, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "set quality: not inside a callback");
    }
    apply_quality(w, quality);
    td_wake_all(w);
    return THUD_OK;
}

thud_result thud_world_set_max_error(thud_world *w, double max_error) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    td_reason why;
    const char *error = td_check_max_error(max_error, &w->quality, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "set max_error: not inside a callback");
    }
    w->def.max_error = max_error;
    td_wake_all(w);
    return THUD_OK;
}
