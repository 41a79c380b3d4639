/* one_way.c: one-way rules: a shape, such as a plank through which one can jump from below,
 * collides on its solid side only.
 *
 * Each one-way contact is in one of two states (td_constraint.vetoed). TD_HELD: it acts until the
 * shapes part, wherever the body slides to. TD_PASSING: it does not act, until the shapes part or
 * are found apart on the solid side. A contact that begins is held if its normal is within the
 * solid side's cone and the shapes did not overlap before the motion that brought them together:
 * separation + closing speed * time step >= -TD_SLOP. */
#include "constraint/lanes.h"
#include "contact/contact.h"
#include "rules/rules.h"
#include "state/handles.h"
#include "state/surface.h"

/* A contact is on the solid side if the cosine between its normal and the solid side's direction is
 * greater than this: within 78.5 degrees. This excludes the normals of walls at the ends of a
 * plank, which rounding may tilt by a little. Chosen; not tuned. */
#define SOLID_COSINE_MIN 0.2f

/* The cosine between the direction of the solid side, in world axes, and the contact's normal as it
 * points away from the one-way shape. That shape is a, or b if the rule is reversed; (nx, ny)
 * points from a to b. */
static float solid_side_cosine(const thud_world *w, const td_rule *rule,
                               const td_body_index body[2], float nx, float ny) {
    const td_pose *pose = td_pose_at(w, body[rule->reversed]);
    float x = rule->rule.solid_side.x, y = rule->rule.solid_side.y;
    float along = (pose->c * x - pose->s * y) * nx + (pose->s * x + pose->c * y) * ny;
    return (rule->reversed ? -along : along) / __builtin_sqrtf(x * x + y * y);
}

/* Decides the state of one lane's contact, and removes its points if it is TD_PASSING. */
static void decide_lane(thud_world *w, td_block *block, int lane, const td_rule *rule) {
    td_contact *contact = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[contact->kind]->form);
    if (!(contact->vetoed & TD_HELD)) {
        float slack = TD_SLOP * w->length_scale, separation = 3.0e38f, closing = 0.0f;
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            if (p->normal_mass[lane] != 0.0f && p->separation[lane] + w->skin < separation) {
                separation = p->separation[lane] + w->skin;
                closing = td_contact_closing_speed(w, block, p, lane);
            }
        }
        if (!(contact->vetoed & TD_PASSING) && closing > 0.0f) {
            separation += closing * (float)w->def.time_step;
        }
        bool held = separation >= -slack &&
                    solid_side_cosine(w, rule, contact->body, block->nx[lane], block->ny[lane]) >
                        SOLID_COSINE_MIN;
        contact->vetoed = held ? TD_HELD : TD_PASSING | TD_VETOED;
    }
    contact->vetoed &= TD_HELD | TD_PASSING;
    if (contact->vetoed & TD_PASSING) {
        contact->vetoed |= TD_VETOED;
        td_surface_mute(block, points, lane);
    }
}

/* Decides all one-way contacts of the step, before it is solved. Also drops the impulse events of
 * the last step. */
void td_rules_decide(thud_world *w) {
    td_lane_marks one_way = {.rule = TD_RULE_ONE_WAY};
    w->rules->impulses.count = 0;
    for (int i = 0; i < w->scratch.blocks.count && w->rules->one_way; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int lanes = td_any_lane_marked(block, one_way) ? block->used : 0;
        for (int lane = 0; lane < lanes; lane++) {
            const td_rule *rule = td_rule_of_lane(w, block, lane, TD_RULE_ONE_WAY);
            if (rule) {
                decide_lane(w, block, lane, rule);
            }
        }
    }
}

/* Whether a one-way rule lets an impact within the step pass: its normal is not on the solid side.
 */
bool td_rules_let_through(const thud_world *w, const thud_contact *seen) {
    int a = (int)seen->shape_a.index1 - 1, b = (int)seen->shape_b.index1 - 1;
    const td_rule *rule = td_rule_of_pair(w, a, b);
    td_body_index body[2] = {td_shape_at(w, a)->body, td_shape_at(w, b)->body};
    return rule && rule->rule.kind == THUD_RULE_ONE_WAY &&
           solid_side_cosine(w, rule, body, seen->normal.x, seen->normal.y) <= SOLID_COSINE_MIN;
}

/* td_rule_hooks.hides: true without a one-way rule; with one only while the contact is TD_HELD,
 * because a plank that lets a body pass must not hide the face of the wall beside it
 * (contact/internal_edges.h). */
bool td_rules_hide(const thud_world *w, int shape, int other) {
    const td_rule *rule = td_rule_of_pair(w, shape, other);
    if (!rule || rule->rule.kind != THUD_RULE_ONE_WAY) {
        return true;
    }
    int e = td_body_at(w, td_shape_at(w, other)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *c = td_constraint_at(w, td_edge_constraint(e));
        if (c->vetoed & TD_HELD && ((c->shape_a == shape && c->shape_b == other) ||
                                    (c->shape_a == other && c->shape_b == shape))) {
            return true;
        }
    }
    return false;
}
