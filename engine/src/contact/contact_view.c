/* contact_view.c: the public view of contacts (thud_contact), and hit events. */
#include "state/body.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "constraint/lanes.h"
#include "api/step.h"

thud_contact td_contact_view(const thud_world *w, td_block *block, int lane) {
    const td_contact *contact = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[contact->kind]->form);
    const td_pose *pose = td_pose_at(w, contact->body[1]);
    thud_contact view = {
        .shape_a = td_shape_handle(w, contact->shape_a),
        .shape_b = td_shape_handle(w, contact->shape_b),
        .body_a = td_body_handle(w, contact->body[0]),
        .body_b = td_body_handle(w, contact->body[1]),
        .normal = {block->nx[lane], block->ny[lane]},
        .separation = 3.0e38f,
    };
    float nx = view.normal.x, ny = view.normal.y, along = 0.0f;
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        if (p->normal_mass[lane] == 0.0f) {
            continue;
        }
        along += p->cross_b[lane];
        view.point_count++;
        view.separation = td_min_float(view.separation, p->separation[lane] + w->skin);
        view.normal_impulse += td_history_of(block, points)[k].total[lane];
    }
    view.tangent_impulse = td_surface_at(block, points)->total[lane];
    /* The blocks have no points, only r x n and r x t of the arm r from b's centre of mass. With n
     * and t orthonormal these two are r's coordinates: r = (r x n) (ny, -nx) - (r x t) (nx, ny). */
    float cn = view.point_count ? along / (float)view.point_count : 0.0f;
    float ct = block->tangent_cross_b[lane];
    td_position at = {pose->center.x + td_length_from(w, cn * ny - ct * nx),
                      pose->center.y + td_length_from(w, -cn * nx - ct * ny)};
    view.point = td_place_to(w, at);
    return view;
}

float td_contact_closing(const thud_world *w, const td_block *block, const td_point *p, int lane) {
    const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
    const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
    return (a[0] - b[0]) * block->nx[lane] + (a[1] - b[1]) * block->ny[lane] +
           a[2] * p->cross_a[lane] - b[2] * p->cross_b[lane];
}

/* Adds hit events of contacts that have begun in this step and close faster than hit_speed.
 * Contacts that detection resolves at their time of impact are muted (bounces.c), have no points
 * here, and get their events there. */
void td_contacts_hit(thud_world *w) {
    float threshold = -w->def.hit_speed * w->unit;
    for (int i = 0; i < w->scratch.begins.count && w->def.contact_events; i++) {
        int index = td_int_at(&w->scratch.begins, i);
        const td_contact *contact = td_contact_at(w, index);
        if (contact->state != TD_TOUCHING ||
            td_pair_is_silent(w, contact->shape_a, contact->shape_b)) {
            continue;
        }
        td_lane at = td_lane_of(w, contact);
        int points = td_form_points(w->kinds[contact->kind]->form);
        const td_point_history *history = td_history_of(at.block, points);
        float approach = history[0].approach[at.lane];
        if (points == 2) {
            approach = td_min_float(approach, history[1].approach[at.lane]);
        }
        if (approach >= threshold) {
            continue;
        }
        thud_contact view = td_contact_view(w, at.block, at.lane);
        if (view.point_count > 0) {
            TD_PUSH(thud_hit_event, &w->events.hit) =
                (thud_hit_event){view.shape_a, view.shape_b, view.point, view.normal,
                                 td_hit_speed(-approach)};
        }
    }
}
