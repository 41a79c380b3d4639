/* shape_instance.c: the instance of a moving shape at a time of its motion. */
#include "geometry/shape_instance.h"

#include "base/trig.h"

thud_geometry td_placed_at(const thud_geometry *shape, const thud_motion *m, double t) {
    thud_geometry p = *shape;
    p.x += m->dx * t;
    p.y += m->dy * t;
    if (td_kind_turns(p.kind) && m->turn != 0.0) {
        double s, c;
        td_sincos(m->turn * t, &s, &c);
        p.c = shape->c * c - shape->s * s;
        p.s = shape->s * c + shape->c * s;
    }
    return p;
}
