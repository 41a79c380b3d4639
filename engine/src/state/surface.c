/* surface.c: combines the surfaces of two shapes, and keeps the result in a lane; see surface.h. */
#include "state/surface.h"

#include "listeners/listener_hooks.h"
#include "rules/rule_hooks.h"
#include "state/handles.h"
#include "textures/texture_hooks.h"

thud_contact_settings td_surface_of_frictions(const thud_world *w, int shape_a, int shape_b,
                                              float friction_a, float friction_b) {
    const td_shape *a = td_shape_at(w, shape_a), *b = td_shape_at(w, shape_b);
    thud_contact_settings s = {.friction = __builtin_sqrtf(friction_a * friction_b),
                               .restitution = td_max_float(a->restitution, b->restitution),
                               .surface_speed = a->surface_speed + b->surface_speed};
    if (w->rule_hooks) {
        w->rule_hooks->settle(w, shape_a, shape_b, &s);
    }
    return s;
}

thud_contact_settings td_surface_of_pair(const thud_world *w, int shape_a, int shape_b) {
    return td_surface_of_frictions(w, shape_a, shape_b, td_shape_at(w, shape_a)->friction,
                                   td_shape_at(w, shape_b)->friction);
}

thud_contact_settings td_surface_of_impact(const thud_world *w, const thud_contact *seen) {
    thud_contact_settings s =
        td_surface_of_pair(w, (int)seen->shape_a.index1 - 1, (int)seen->shape_b.index1 - 1);
    if (w->texture_hooks) {
        w->texture_hooks->settle_one(w, seen, &s);
    }
    return s;
}

/* Asks the rules and then the prologue whether an impact within the step is to be resolved. */
bool td_surface_meet(thud_world *w, const thud_contact *seen, thud_contact_settings *settings) {
    return !(w->rule_hooks && w->rule_hooks->lets_through(w, seen)) &&
           (!w->asks || w->listener_hooks->ask_one(w, seen, settings));
}

/* Stores a lane's settings, and keeps the world's counts of lanes with restitution (w->bouncy) and
 * with a surface speed. */
void td_surface_set(thud_world *w, td_block *block, int points, int lane,
                    const thud_contact_settings *s) {
    td_surface *surface = td_surface_at(block, points);
    w->bouncy += (s->restitution > 0.0f) - (block->restitution[lane] > 0.0f);
    w->surface_speeds += (s->surface_speed != 0.0f) - (surface->speed[lane] != 0.0f);
    block->friction[lane] = s->friction;
    block->restitution[lane] = s->restitution;
    block->bouncy |= s->restitution > 0.0f;
    surface->speed[lane] = s->surface_speed;
    if (s->friction == 0.0f) {
        /* The relax pass skips the friction of a block in which no lane has any (relax_blocks). If
         * the old impulse stayed here, the warm start would apply it again in every step. */
        block->tangent_impulse[lane] = 0.0f;
    }
}

/* Removes the points of a lane for this step. */
void td_surface_mute(td_block *block, int points, int lane) {
    for (int k = 0; k < points; k++) {
        td_point *p = &block->point[k];
        p->normal_mass[lane] = p->normal_impulse[lane] = 0.0f;
        p->separation[lane] = p->start_separation[lane] = TD_APART;
    }
    block->tangent_mass[lane] = block->tangent_impulse[lane] = 0.0f;
}
