/* contact_view.c: makes the public record of a contact (thud_contact) from its lane, and the hit
 * events of contacts that begin. A lane's separations, velocities and impulses are in the caller's
 * units already (constraint/block.h); only positions are converted, from position quanta. */
#include "state/body.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "constraint/lanes.h"
#include "api/step.h"

thud_contact td_contact_view(const thud_world *w, td_block *block, int lane) {
    const td_contact *contact = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[contact->kind]->form);
    const td_pose *pose_b = td_pose_at(w, contact->body[1]);
    thud_contact view = {
        .shape_a = td_shape_handle(w, contact->shape_a),
        .shape_b = td_shape_handle(w, contact->shape_b),
        .body_a = td_body_handle(w, contact->body[0]),
        .body_b = td_body_handle(w, contact->body[1]),
        .normal = {block->nx[lane], block->ny[lane]},
        .separation = FLT_MAX, /* this value remains in a muted lane, which has no points */
    };
    float nx = view.normal.x, ny = view.normal.y, cross_n = 0.0f;
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        if (p->normal_mass[lane] == 0.0f) {
            continue; /* no point here */
        }
        cross_n += p->cross_b[lane];
        view.point_count++;
        /* The solver subtracts the skin from its separations, so that they are 0 where a contact
         * rests. It is added again here. */
        view.separation = td_min_float(view.separation, p->separation[lane] + w->skin);
        view.normal_impulse += td_history_of(block, points)[k].total[lane];
    }
    view.tangent_impulse = td_surface_at(block, points)->total[lane];
    /* A block holds no positions of points, only cross products of their lever arms. With r the
     * mean lever arm from b's centre of mass and the tangent t = (ny, -nx), which is orthogonal to
     * n, r x n is r's coordinate along t, and -(r x t) that along n:
     *     r = (r x n) (ny, -nx) - (r x t) (nx, ny) */
    cross_n = view.point_count ? cross_n / (float)view.point_count : 0.0f;
    float cross_t = block->tangent_cross_b[lane];
    td_position point = {pose_b->center.x + td_length_from(w, cross_n * ny - cross_t * nx),
                         pose_b->center.y + td_length_from(w, -cross_n * nx - cross_t * ny)};
    view.point = td_place_to(w, point);
    return view;
}

float td_contact_closing_speed(const thud_world *w, const td_block *block, const td_point *p,
                               int lane) {
    const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
    const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
    return (a[0] - b[0]) * block->nx[lane] + (a[1] - b[1]) * block->ny[lane] +
           a[2] * p->cross_a[lane] - b[2] * p->cross_b[lane];
}

/* Adds hit events of contacts that have begun in this step and close faster than hit_speed. A lane
 * that has been muted (td_surface_mute: its contact is vetoed, or one-way and let through, or
 * bounces within the step) has no points and gets no event here. Where it bounces, impacts.c adds
 * the event when the bodies meet. Silent pairs, of a shape that makes no events, get none. */
void td_contacts_hit(thud_world *w) {
    if (!w->def.contact_events) {
        return;
    }
    float hit_speed =
        w->def.hit_speed * w->length_scale; /* length/s: the setting is in length scales/s */
    for (int i = 0; i < w->scratch.begins.count; i++) {
        int index = td_int_at(&w->scratch.begins, i);
        const td_contact *contact = td_contact_at(w, index);
        if (contact->state != TD_TOUCHING ||
            td_pair_is_silent(w, contact->shape_a, contact->shape_b)) {
            continue;
        }
        td_lane at = td_lane_of(w, contact);
        int points = td_form_points(w->kinds[contact->kind]->form);
        float normal_velocity = 0.0f; /* of the point that closes fastest */
        for (int k = 0; k < points; k++) {
            if (at.block->point[k].normal_mass[at.lane] != 0.0f) {
                const td_point_history *history = &td_history_of(at.block, points)[k];
                normal_velocity = td_min_float(normal_velocity, history->normal_velocity[at.lane]);
            }
        }
        if (normal_velocity >= -hit_speed) {
            continue;
        }
        thud_contact view = td_contact_view(w, at.block, at.lane);
        if (view.point_count > 0) {
            TD_PUSH(thud_hit_event, &w->events.hit) =
                (thud_hit_event){view.shape_a, view.shape_b, view.point, view.normal,
                                 td_hit_speed(-normal_velocity)};
        }
    }
}
