/* contact_rows.c: the rows of a contact: its points push, and its tangent rubs. */
#include "islands/rows.h"

/* Part of the overlap that goes in a step. */
#define PUSH_SHARE 0.2
/* A gap counts as none below BLUR times the arms, or BLUR_MOST length scales where that is less,
 * and BLUR_LEAST length scales on top. Without BLUR_MOST, ground that is thousands of length scales
 * long would hold bodies up where it is far from its middle. */
#define BLUR 1e-6
#define BLUR_LEAST 1e-7
#define BLUR_MOST 1e-4

enum { TANGENT = TD_DIRECT_TANGENT };

/* Apart: not to meet before the end. Within the skin: not to come nearer. Overlapping: apart again.
 */
static double wanted_of(const thud_world *w, double gap, double blur) {
    double most = (double)(w->def.push_speed * w->unit), time = w->def.time_step;
    if (gap > blur) {
        return -gap / time;
    }
    double depth = -(gap + (double)w->skin), pushed = PUSH_SHARE * (depth - blur) / time;
    return depth < blur ? 0.0 : pushed < most ? pushed : most;
}

/* Floats tell gaps no better than this. Contacts that carry too little to be sure of would come and
 * go with the noise, and a heap at rest has many such. */
static double blur_of(const thud_world *w, const td_direct_row *r) {
    double arm_a = r->a[2] < 0.0 ? -r->a[2] : r->a[2], arm_b = r->b[2] < 0.0 ? -r->b[2] : r->b[2];
    double blur = BLUR * (arm_a + arm_b), most = BLUR_MOST * (double)w->unit;
    return (blur < most ? blur : most) + BLUR_LEAST * (double)w->unit;
}

/* Bodies that do not turn feel no arms. */
bool td_contact_take_rows(const thud_world *w, td_block *block, int lane, const float *impulses,
                          td_direct_constraint *c) {
    int points = td_form_points(w->kinds[td_contact_at(w, block->constraint[lane])->kind]->form);
    double x = (double)block->nx[lane], y = (double)block->ny[lane];
    double turns_a = c->a == TD_NONE || block->inv_inertia_a[lane] > 0.0f;
    double turns_b = c->b == TD_NONE || block->inv_inertia_b[lane] > 0.0f;
    bool bounces = false;
    c->friction = (double)block->friction[lane];
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        if (p->normal_mass[lane] == 0.0f) {
            continue;
        }
        td_row_set(&c->row[k], TD_ROW_PUSH, x, y, turns_a * (double)p->cross_a[lane],
                   turns_b * (double)p->cross_b[lane]);
        c->row[k].impulse = 0.5 * (double)impulses[k];
        c->row[k].wanted = wanted_of(w, (double)p->base[lane], blur_of(w, &c->row[k]));
        bounces |=
            block->restitution[lane] > 0.0f && td_surface_at(block, points)->energy[lane] >= 0.0f;
    }
    /* Arms end in the middle of the gap. Where that is open, as it is about a skin, a disc would
     * roll as if it were greater: beside what does not move, friction acts at the surface. */
    bool second = points > 1 && block->point[0].normal_mass[lane] == 0.0f;
    double gap = (double)(block->point[second].base[lane] + w->skin);
    double outside = c->a == TD_NONE && gap > 0.0 ? 0.5 * gap : 0.0;
    td_direct_row *tangent = &c->row[TANGENT];
    td_row_set(tangent, TD_ROW_FRICTION, y, -x, turns_a * (double)block->tangent_cross_a[lane],
               turns_b * ((double)block->tangent_cross_b[lane] - outside));
    tangent->impulse = 0.5 * (double)impulses[TANGENT];
    tangent->wanted = (double)td_surface_at(block, points)->speed[lane] * (w->surface_speeds > 0);
    tangent->used = block->tangent_mass[lane] > 0.0f && c->friction > 0.0;
    return bounces;
}
