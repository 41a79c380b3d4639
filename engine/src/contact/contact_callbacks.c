/* contact_callbacks.c: contacts as callbacks and statistics see them; prologue and epilogue. */
#include "state/body.h"
#include "detection/collide.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "constraint/lanes.h"
#include "rules/ruling.h"
#include "api/step.h"
#include "state/surface.h"

thud_contact td_contact_view(const thud_world *w, td_block *block, int lane) {
    const td_contact *contact = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[contact->kind]->form);
    const td_pose *pose = td_pose_at(w, contact->body[1]);
    thud_contact seen = {
        .shape_a = td_shape_handle(w, contact->shape_a),
        .shape_b = td_shape_handle(w, contact->shape_b),
        .body_a = td_body_handle(w, contact->body[0]),
        .body_b = td_body_handle(w, contact->body[1]),
        .normal = {block->nx[lane], block->ny[lane]},
        .separation = 3.0e38f,
    };
    float nx = seen.normal.x, ny = seen.normal.y, along = 0.0f;
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        if (p->normal_mass[lane] == 0.0f) {
            continue;
        }
        along += p->cross_b[lane];
        seen.point_count++;
        seen.separation = td_min_float(seen.separation, p->separation[lane] + w->skin);
        seen.normal_impulse += td_history_of(block, points)[k].total[lane];
    }
    seen.tangent_impulse = td_surface_at(block, points)->total[lane];
    /* The crosses of the mean arm with normal and tangent are the arm itself, turned. */
    float cn = seen.point_count ? along / (float)seen.point_count : 0.0f;
    float ct = block->tangent_cross_b[lane];
    td_position at = {pose->center.x + td_length_from(w, cn * ny - ct * nx),
                      pose->center.y + td_length_from(w, -cn * nx - ct * ny)};
    seen.point = td_place_to(w, at);
    return seen;
}

float td_contact_closing(const thud_world *w, const td_block *block, const td_point *p, int lane) {
    const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
    const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
    return (a[0] - b[0]) * block->nx[lane] + (a[1] - b[1]) * block->ny[lane] +
           a[2] * p->cross_a[lane] - b[2] * p->cross_b[lane];
}

/* Lanes that did not bounce before may not know how fast they close in. */
static void note_approach(const thud_world *w, td_block *block, int points, int lane) {
    for (int k = 0; k < points; k++) {
        td_history_of(block, points)[k].approach[lane] =
            -td_contact_closing(w, block, &block->point[k], lane);
    }
}

/* Settings are for this step: each time they start from the pair's own. */
static void ask(thud_world *w, td_block *block, int lane) {
    td_contact *contact = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[contact->kind]->form);
    if (contact->vetoed & TD_PASSING) {
        return; /* a rule lets them through */
    }
    thud_contact_settings own = td_surface_of_pair(w, contact->shape_a, contact->shape_b);
    thud_contact_settings settings = own;
    thud_contact seen = td_contact_view(w, block, lane);
    bool yes = td_surface_ask(w, &seen, &settings);
    contact->vetoed = (contact->vetoed & TD_HELD) | !yes;
    td_surface_set(w, block, points, lane, &settings);
    if (settings.restitution != own.restitution) {
        note_approach(w, block, points, lane);
    }
    if (!yes) {
        td_surface_mute(block, points, lane);
    }
}

/* Lanes in use of the i-th block, where it holds contacts; else none. */
static int contacts_in(const thud_world *w, int i) {
    const td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
    return block->used && td_is_contact(td_constraint_at(w, block->constraint[0])) ? block->used
                                                                                   : 0;
}

void td_contacts_ask(thud_world *w) {
    if (w->ruling) {
        w->ruling->decide(w);
    }
    for (int i = 0; i < w->scratch.blocks.count && w->def.prologue; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        for (int lane = 0, end = contacts_in(w, i); lane < end; lane++) {
            ask(w, block, lane);
        }
    }
}

/* Tells hits of contacts that the solver will stop. Those that detection resolves within the step,
 * and those that do nothing in it, have no points here: see bounces.c. */
void td_contacts_hit(thud_world *w) {
    float least = -w->def.hit_speed * w->unit;
    for (int i = 0; i < w->scratch.begins.count && w->def.contact_events; i++) {
        int index = td_int_at(&w->scratch.begins, i);
        const td_contact *contact = td_contact_at(w, index);
        if (contact->state != TD_TOUCHING) {
            continue;
        }
        td_lane at = td_lane_of(w, contact);
        int points = td_form_points(w->kinds[contact->kind]->form);
        const td_point_history *history = td_history_of(at.block, points);
        float approach = history[0].approach[at.lane];
        if (points == 2) {
            approach = td_min_float(approach, history[1].approach[at.lane]);
        }
        if (approach >= least) {
            continue;
        }
        thud_contact seen = td_contact_view(w, at.block, at.lane);
        if (seen.point_count > 0) {
            TD_PUSH(thud_hit_event, &w->events.hit) =
                (thud_hit_event){seen.shape_a, seen.shape_b, seen.point, seen.normal, -approach};
        }
    }
}

void td_contacts_tell(thud_world *w) {
    if (w->ruling) {
        w->ruling->tell(w);
    }
    if (!w->def.epilogue) {
        return;
    }
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        for (int lane = 0, end = contacts_in(w, i); lane < end; lane++) {
            thud_contact seen = td_contact_view(w, block, lane);
            if (seen.point_count) {
                w->def.epilogue(w, &seen, w->def.callback_context);
            }
        }
    }
    for (int i = 0; i < w->scratch.impacts.count; i++) {
        const td_impact *impact = TD_AT(td_impact, &w->scratch.impacts, i);
        w->def.epilogue(w, &impact->seen, w->def.callback_context);
    }
}
