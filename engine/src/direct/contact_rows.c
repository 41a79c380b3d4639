/* contact_rows.c: the rows of a contact: a unilateral row for each point, along the normal, and a
 * friction row along the tangent.
 *
 * With the separation s of a point (beyond the skin at which contacts rest) and the time step h,
 * the target speed of its row, as the mean speed of the step, is
 *     s > blur:    -s / h   (a speculative contact: the gap closes to contact and no further),
 *     else, with the depth d = -(s + skin) of the overlap,
 *     d < blur:    0,
 *     d >= blur:   min(PUSH_SHARE (d - blur) / h, push_speed)   (Baumgarte stabilisation).
 */
#include "direct/rows.h"

/* The share of an overlap that a step corrects, as Box2D's b2_baumgarte of 0.2. Chosen; what is
 * left is corrected in later steps. */
#define PUSH_SHARE 0.2
/* The blur is the rounding error that a separation may have; a separation or overlap below it
 * counts as 0. It is BLUR times the sum of both lever arms (BLUR is some ten times the rounding of
 * floats, 2^-24), at most BLUR_MAX length scales, plus BLUR_MIN length scales for bodies whose arms
 * are 0. Without BLUR_MAX, ground that is thousands of length scales wide would hold bodies up in
 * the air far from its centre. */
#define BLUR 1e-6
#define BLUR_MIN 1e-7
#define BLUR_MAX 1e-4

enum { TANGENT = TD_DIRECT_TANGENT };

/* The target speed of a point, length/s, by the formulas at the head of this file; `gap` is s, its
 * separation beyond the skin. */
static double target_speed_of(const thud_world *w, double gap, double blur) {
    double push_max = (double)(w->def.push_speed * w->length_scale), time = w->def.time_step;
    if (gap > blur) {
        return -gap / time;
    }
    double depth = -(gap + (double)w->skin), pushed = PUSH_SHARE * (depth - blur) / time;
    return depth < blur ? 0.0 : pushed < push_max ? pushed : push_max;
}

/* The blur of a row's point, a length: separations are computed in single precision. Without this
 * tolerance, contacts of a heap at rest that carry almost no load would enter and leave the active
 * set at random. */
static double blur_of(const thud_world *w, const td_direct_row *r) {
    double arm_a = r->a[2] < 0.0 ? -r->a[2] : r->a[2], arm_b = r->b[2] < 0.0 ? -r->b[2] : r->b[2];
    double blur = BLUR * (arm_a + arm_b), max = BLUR_MAX * (double)w->length_scale;
    return (blur < max ? blur : max) + BLUR_MIN * (double)w->length_scale;
}

/* A body of the problem that does not turn gets lever arms of 0. Its angular velocity then stays 0,
 * whatever finite moment of inertia the matrix has for it (inertia_of, newton_step.c). A body
 * outside of the problem keeps its arms, since its given angular velocity moves the contact point.
 */
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
        td_row_set(&c->row[k], TD_ROW_UNILATERAL, x, y, turns_a * (double)p->cross_a[lane],
                   turns_b * (double)p->cross_b[lane]);
        c->row[k].impulse = 0.5 * (double)impulses[k];
        c->row[k].target_speed =
            target_speed_of(w, (double)p->start_separation[lane], blur_of(w, &c->row[k]));
        bounces |=
            block->restitution[lane] > 0.0f && td_surface_at(block, points)->energy[lane] >= 0.0f;
    }
    /* The contact point is in the middle of the gap. Under `bisect` and `swept` contacts rest at a
     * gap of one skin, so that a disc would roll as if its radius were larger by half a skin;
     * against a body that does not move, friction acts at the disc's own surface instead. */
    bool second = points > 1 && block->point[0].normal_mass[lane] == 0.0f;
    double gap = (double)(block->point[second].start_separation[lane] + w->skin);
    double outside = c->a == TD_NONE && gap > 0.0 ? 0.5 * gap : 0.0;
    td_direct_row *tangent = &c->row[TANGENT];
    td_row_set(tangent, TD_ROW_FRICTION, y, -x, turns_a * (double)block->tangent_cross_a[lane],
               turns_b * ((double)block->tangent_cross_b[lane] - outside));
    tangent->impulse = 0.5 * (double)impulses[TANGENT];
    tangent->target_speed =
        (double)td_surface_at(block, points)->speed[lane] * (w->surface_speeds > 0);
    tangent->used = block->tangent_mass[lane] > 0.0f && c->friction > 0.0;
    return bounces;
}
