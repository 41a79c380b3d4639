/* manifold.c: public manifolds of contacts, and the public call that lists those of one body. */
#include "contact/manifold.h"

#include "state/body.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "constraint/lanes.h"

thud_manifold td_manifold_of(const thud_world *w, const td_contact *contact) {
    const td_pose *pose = td_pose_at(w, contact->body[1]);
    td_lane held = td_lane_of(w, contact);
    const td_block *block = held.block;
    int lane = held.lane, points = td_form_points(w->kinds[contact->kind]->form);
    thud_manifold out = {
        .shape_a = td_shape_handle(w, contact->shape_a),
        .shape_b = td_shape_handle(w, contact->shape_b),
        .body_a = td_body_handle(w, contact->body[0]),
        .body_b = td_body_handle(w, contact->body[1]),
        .normal = {block->nx[lane], block->ny[lane]},
        .tangent_impulse = (float)w->substeps * block->tangent_impulse[lane],
        .direct = (block->mark[lane].loaded & TD_DIRECT) != 0,
    };
    float nx = out.normal.x, ny = out.normal.y, ct = block->tangent_cross_b[lane];
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        if (p->normal_mass[lane] == 0.0f) {
            continue;
        }
        /* The lever arm r from b's centre of mass, by its cross products with normal and tangent,
         * as in contact_view.c. Both points lie on one line along t, so that r x t is the same for
         * both, and is stored once. */
        float cn = p->cross_b[lane];
        td_position at = {pose->center.x + td_length_from(w, cn * ny - ct * nx),
                          pose->center.y + td_length_from(w, -cn * nx - ct * ny)};
        int n = out.point_count++;
        out.point[n] = td_place_to(w, at);
        out.separation[n] = p->separation[lane] + w->skin;
        out.normal_impulse[n] = (float)w->substeps * p->normal_impulse[lane];
    }
    return out;
}

thud_result thud_body_get_contacts(thud_world *w, thud_body_id id, thud_manifold *out, int capacity,
                                   int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    int n = 0;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (!out_count || (!out && capacity > 0)) {
        return td_refuse(w, THUD_ERROR_NULL, "body contacts: out or count is null");
    }
    if (capacity < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "body contacts: capacity is negative");
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "body contacts: not inside a callback");
    }
    for (int e = td_body_at(w, index)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (!td_is_contact(contact) || contact->state != TD_TOUCHING ||
            td_contact_is_ending(w, contact)) {
            continue;
        }
        if (n < capacity) {
            out[n] = td_manifold_of(w, contact);
        }
        n++;
    }
    *out_count = n;
    return THUD_OK;
}
