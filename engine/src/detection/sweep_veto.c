/* sweep_veto.c: asks rules and prologues whether a shape that continuous.c sweeps may pass through
 * a static one. The first rule or listener of a world plugs it in (thud_world.sweep_is_vetoed). */
#include "contact/contact.h"
#include "detection/trajectory.h"
#include "geometry/shape_instance.h"
#include "state/kinds.h"
#include "state/shape.h"
#include "state/surface.h"

/* The contact that the prologue is given: the shape at `time`, in its full size, against a static
 * one. */
static thud_contact contact_view(const thud_world *w, const td_swept *swept, int shape_index,
                                 int other, double time) {
    bool ground = td_kind_is_line(td_shape_at(w, other)->kind);
    td_position origin = ground ? td_shape_proxy_at(w, other)->center : swept->start;
    thud_geometry shape = td_placed_at(&swept->placed, &swept->motion, time);
    shape.x += (double)(swept->start.x - origin.x) / w->to_fixed;
    shape.y += (double)(swept->start.y - origin.y) / w->to_fixed;
    shape.hx += swept->shrink;
    shape.hy = td_kind_grown_hy(shape.kind, shape.hy, swept->shrink);
    thud_closest c;
    if (ground) {
        c = w->ground->below(w, other, &shape);
    } else {
        thud_geometry b = td_shape_instance(w, other, origin);
        w->instances->closest(&b, &shape, &c);
    }
    td_position at = {origin.x + td_round64(0.5 * (c.ax + c.bx) * w->to_fixed),
                      origin.y + td_round64(0.5 * (c.ay + c.by) * w->to_fixed)};
    return td_contact_between(w, other, shape_index, at, (thud_vec2){(float)c.nx, (float)c.ny},
                              c.distance);
}

/* For a pair that touched at the start of the step the prologue has been called already, and
 * td_contact.vetoed has its answer. A callback may create bodies and make queries, so that pointers
 * into arrays of the world are invalid afterwards. */
bool td_sweep_is_vetoed(thud_world *w, const td_swept *swept, int shape, int other, double time) {
    bool asked = false, vetoed = true;
    td_body_index body = td_shape_at(w, shape)->body;
    int e = td_surface_asks(w) ? td_body_at(w, body)->first_constraint : TD_NONE;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (contact->state == TD_TOUCHING && contact->shape_a == other &&
            contact->shape_b == shape) {
            asked = true;
            vetoed &= contact->vetoed;
        }
    }
    if (asked || !td_surface_asks(w)) {
        return asked && vetoed;
    }
    thud_contact seen = contact_view(w, swept, shape, other, time);
    thud_contact_settings settings = td_surface_of_impact(w, &seen);
    return !td_surface_meet(w, &seen, &settings);
}
