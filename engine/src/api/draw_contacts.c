/* draw_contacts.c: draws what the solver worked on in the last step: contacts and their normals,
 * manifold points with depth and impulse, graph colours, and the constraints of islands that were
 * solved directly. */
#include "state/body.h"
#include "contact/contact.h"
#include "api/debug_draw.h"
#include "constraint/lanes.h"
#include "contact/manifold.h"

/* Length of a drawn normal, in length scales of the world. Chosen: long enough to be seen beside a
 * body of one length scale, and too short to cover it. */
#define NORMAL_LENGTH 0.3f

/* The next constraint from index *i on that acts in the solver, or null; advances *i past it. */
static const td_constraint *next_acting(const thud_world *w, int *i) {
    while (*i < w->constraints.count) {
        const td_constraint *constraint = td_constraint_at(w, (*i)++);
        if (constraint->live && constraint->state == TD_TOUCHING &&
            !td_contact_is_ending(w, constraint)) {
            return constraint;
        }
    }
    return NULL;
}

/* As next_acting, but for contacts only. */
static const td_contact *next_touching(const thud_world *w, int *i) {
    const td_constraint *constraint;
    do {
        constraint = next_acting(w, i);
    } while (constraint && !td_is_contact(constraint));
    return constraint;
}

/* Draws a point, if the caller gave a function for points. */
static void draw_point(const td_drawing *d, thud_vec2 p, thud_style style) {
    if (d->draw->point) {
        d->draw->point(p, style, d->draw->context);
    }
}

/* p + length * normal */
static thud_vec2 along(thud_vec2 p, thud_vec2 normal, float length) {
    return (thud_vec2){p.x + length * normal.x, p.y + length * normal.y};
}

void td_draw_contacts(const td_drawing *d) {
    const thud_world *w = d->w;
    const td_contact *contact;
    for (int i = 0; (contact = next_touching(w, &i)) != NULL;) {
        td_lane at = td_lane_of(w, contact);
        thud_contact seen = td_contact_view(w, at.block, at.lane);
        if (seen.point_count == 0) {
            continue; /* the contact had no points in the last step (td_surface_mute): a prologue
                         vetoed it, a rule let it through, or it bounced */
        }
        thud_vec2 p = td_drawing_local(d, td_place_from(w, seen.point));
        draw_point(d, p, THUD_STYLE_CONTACT);
        td_drawing_line(d, p, along(p, seen.normal, NORMAL_LENGTH * w->length_scale),
                        THUD_STYLE_NORMAL);
    }
}

void td_draw_direct(const td_drawing *d) {
    const td_constraint *c;
    for (int i = 0; (c = next_acting(d->w, &i)) != NULL;) {
        td_lane at = td_lane_of(d->w, c);
        if (at.block->mark[at.lane].loaded & TD_DIRECT) {
            td_drawing_pair(d, c, THUD_STYLE_DIRECT);
        }
    }
}

void td_draw_colours(const td_drawing *d) {
    const td_constraint *c;
    for (int i = 0; (c = next_acting(d->w, &i)) != NULL;) {
        if (c->bin != TD_SLEEPING) {
            int style = THUD_STYLE_COLOUR + td_colour_of_bin(c->bin) % TD_COLOURS;
            td_drawing_pair(d, c, (thud_style)td_min_int(style, THUD_STYLE_COLOUR_LAST));
        }
    }
}

void td_draw_manifolds(const td_drawing *d) {
    const thud_world *w = d->w;
    const td_contact *contact;
    for (int i = 0; (contact = next_touching(w, &i)) != NULL;) {
        thud_manifold seen = td_manifold_of(w, contact);
        float inverse = td_max_float(td_body_at(w, contact->body[0])->inv_mass,
                                     td_body_at(w, contact->body[1])->inv_mass);
        for (int k = 0; k < seen.point_count; k++) {
            thud_vec2 p = td_drawing_local(d, td_place_from(w, seen.point[k]));
            float depth = td_max_float(-seen.separation[k], 0.0f);
            draw_point(d, p, THUD_STYLE_MANIFOLD);
            td_drawing_line(d, p, along(p, seen.normal, depth), THUD_STYLE_DEPTH);
            td_drawing_line(d, p, along(p, seen.normal, seen.normal_impulse[k] * inverse),
                            THUD_STYLE_IMPULSE);
        }
    }
}
