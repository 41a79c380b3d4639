/* contact_lanes.c: the lane operations of contacts (td_lane_ops): they write what a contact keeps
 * in its lane, which is its shapes, its surface (friction, restitution, surface speed) and its mark
 * of internal edges, and set td_block.has_offsets where the solver has to use the passes that
 * compute with lever arms. */
#include "constraint/lanes.h"
#include "contact/internal_edges.h"
#include "rules/rule_hooks.h"
#include "state/surface.h"

static int points_of(const thud_world *w, const td_contact *contact) {
    return td_form_points(w->kinds[contact->kind]->form);
}

void td_contact_settle(thud_world *w, td_block *block, int lane, int index) {
    const td_contact *contact = td_contact_at(w, index);
    thud_contact_settings own = td_surface_of_pair(w, contact->shape_a, contact->shape_b);
    td_surface_set(w, block, points_of(w, contact), lane, &own);
    if (w->rule_hooks) {
        block->mark[lane].rule = w->rule_hooks->settle(w, contact->shape_a, contact->shape_b, &own);
    }
}

/* Writes a contact into the lane that it takes (td_lane_ops.fill). */
static void fill(thud_world *w, td_block *block, int lane, int index) {
    const td_contact *contact = td_contact_at(w, index);
    const td_shape *a = td_shape_at(w, contact->shape_a);
    const td_shape *b = td_shape_at(w, contact->shape_b);
    block->shape_a[lane] = contact->shape_a;
    block->shape_b[lane] = contact->shape_b;
    td_contact_settle(w, block, lane, index);
    /* `centred` is 2 for a shape whose centre is its body's centre of mass and that is not turned
     * relative to its body. */
    block->has_offsets |= a->centred + b->centred < 2 * 2 || b->internal_edges ||
                          (a->internal_edges && td_body_at(w, a->body)->kind != THUD_BODY_STATIC);
    block->mark[lane].internal_edges = td_internal_edges_of(a, b);
}

/* Clears the surface of the lane that a contact leaves (td_lane_ops.clear): the world counts the
 * lanes with restitution and those with a surface speed, and td_surface_set corrects these counts.
 */
static void clear(thud_world *w, td_block *block, int lane, int index) {
    td_surface_set(w, block, points_of(w, td_contact_at(w, index)), lane,
                   &(thud_contact_settings){0.0f, 0.0f, 0.0f});
}

/* Makes the narrowphase compute the manifold anew: a lane without effective masses is not kept by
 * the manifold cache. */
static void renew(thud_world *w, td_block *block, int lane, int index) {
    block->has_offsets = 1; /* the body's centre of mass may have moved away from its shape's */
    for (int k = 0; k < points_of(w, td_contact_at(w, index)); k++) {
        block->point[k].normal_mass[lane] = 0.0f;
    }
}

const td_lane_ops td_contact_lanes = {.fill = fill, .clear = clear, .renew = renew};
