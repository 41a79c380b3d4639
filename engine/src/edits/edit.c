/* edit.c: what setters of bodies and shapes share: finding the object, waking its neighbours,
 * ending and updating its contacts, and searching for new pairs; see edit.h. Constraints of a body
 * form a list of edges: td_edge_of. */
#include "edits/edit.h"

#include "constraint/lanes.h"
#include "contact/contact.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "state/surface.h"

/* `found`, or THUD_ERROR_LOCKED inside a callback. */
static thud_result unlocked(const thud_world *w, thud_result found) {
    return found == THUD_OK && w->locked
               ? td_refuse(w, THUD_ERROR_LOCKED, "change of a body or shape: not inside a callback")
               : found;
}

thud_result td_edit_body(const thud_world *w, thud_body_id id, td_body_index *index) {
    return unlocked(w, td_find_body(w, id, index));
}

thud_result td_edit_shape(const thud_world *w, thud_shape_id id, int *index) {
    return unlocked(w, td_find_shape(w, id, index));
}

/* Wakes the body on the other side of an open contact. Static bodies are left out: they never
 * sleep, and TD_CHANGE_WAKE on a static body means that its terrain was edited. */
static void wake_other(thud_world *w, int edge) {
    td_body_index other = td_other_body(w, edge);
    if (td_constraint_at(w, td_edge_constraint(edge))->open &&
        td_body_at(w, other)->kind != THUD_BODY_STATIC) {
        td_body_mark(w, other, TD_CHANGE_WAKE);
    }
}

void td_edit_wake(thud_world *w, td_body_index body, int shape) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (td_edit_concerns(constraint, shape) && constraint->kind != TD_PAIR_SENSOR) {
            wake_other(w, e);
        }
    }
    td_body_mark(w, body, TD_CHANGE_WAKE);
}

/* Whether td_edit_end_contacts ends the contact of this edge. */
static bool ends(const thud_world *w, int edge, int shape, bool all) {
    const td_constraint *c = td_constraint_at(w, td_edge_constraint(edge));
    return td_edit_concerns(c, shape) && (all || !td_pair_allowed(w, c->shape_a, c->shape_b));
}

bool td_edit_ends_reserve(thud_world *w, td_body_index body, int shape, bool all) {
    int count = 0;
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        count += ends(w, e, shape, all);
    }
    return td_contact_end_reserve(w, count);
}

void td_edit_end_contacts(thud_world *w, td_body_index body, int shape, bool all) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE;) {
        int next = td_next_edge(w, e);
        if (ends(w, e, shape, all)) {
            wake_other(w, e);
            td_contact_destroy(w, td_edge_constraint(e));
        }
        e = next;
    }
}

void td_edit_settle_contacts(thud_world *w, int shape) {
    td_body_index body = td_shape_at(w, shape)->body;
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (td_edit_concerns(contact, shape) && contact->state == TD_TOUCHING) {
            td_lane at = td_lane_of(w, contact);
            uint16_t *mark = &at.block->mark[at.lane].rule, before = *mark;
            td_contact_settle(w, at.block, at.lane, td_edge_constraint(e));
            *mark |=
                before & (TD_LANE_ALTERED | TD_LANE_REFUSED); /* set by prologues, not by rules */
            contact->vetoed = before == *mark ? contact->vetoed : 0;
            td_lane_renew(w, td_edge_constraint(e));
        }
    }
}

/* Terrain has no bounds in the broadphase. So every shape that the filters let collide with the
 * terrain is marked to search for its pairs. */
static void search_for_terrain(thud_world *w, int line) {
    for (int i = 0; i < w->shapes.count; i++) {
        const td_shape *shape = td_shape_at(w, i);
        if ((shape->flags & TD_SHAPE_LIVE) && td_pair_allowed(w, line, i)) {
            td_shape_mark_moved(w, i);
            *td_marks_at(w, i) |= TD_MARK_WOKEN;
        }
    }
}

void td_edit_look_around(thud_world *w, int shape) {
    td_shape_mark_moved(w, shape);
    *td_marks_at(w, shape) |= TD_MARK_WOKEN;
    if (td_kind_is_line(td_shape_at(w, shape)->kind)) {
        search_for_terrain(w, shape);
    }
}

/* Scales the accumulated (warm-start) impulses of the body's constraints that act. */
static void scale_impulses(thud_world *w, td_body_index body, float scale) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->state != TD_TOUCHING) {
            continue;
        }
        td_lane at = td_lane_of(w, constraint);
        at.block->tangent_impulse[at.lane] *= scale;
        for (int k = 0; k < td_form_points(w->kinds[constraint->kind]->form); k++) {
            at.block->point[k].normal_impulse[at.lane] *= scale;
        }
    }
}

void td_edit_weigh(thud_world *w, td_body_index index, float inv_mass, float inv_inertia) {
    const td_body *body = td_body_at(w, index);
    float scale = 1.0f;
    td_body_weigh(w, index);
    td_body_mark(w, index, TD_CHANGE_SHAPES);
    if (body->inv_mass > inv_mass) {
        scale = inv_mass / body->inv_mass;
    }
    if (body->inv_inertia > inv_inertia && inv_inertia > 0.0f) {
        scale = td_min_float(scale, inv_inertia / body->inv_inertia);
    }
    if (scale < 1.0f) {
        scale_impulses(w, index, scale);
    }
}
