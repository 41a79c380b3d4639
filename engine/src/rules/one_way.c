/* one_way.c: shapes that hold others on one of their sides only.
 *
 * What has come to the solid side is held until the two part, wherever it slides to; what has come
 * from elsewhere passes until they part or it stands clear of that side. Whoever begins to touch is
 * on the solid side if it was before this step's motion began: a step may carry it in. */
#include "constraint/lanes.h"
#include "contact/contact.h"
#include "rules/rules.h"
#include "state/handles.h"
#include "state/surface.h"

/* A side is that of normals within some 78 degrees of it: whoever slides down a wall is not on top.
 */
#define LEAST_COSINE 0.2f

/* How far the normal, from a to b, goes along the solid side: the cosine between them. */
static float along_side(const thud_world *w, const td_rule *rule, const td_body_index body[2],
                        float nx, float ny) {
    const td_pose *pose = td_pose_at(w, body[rule->reversed]);
    float x = rule->rule.solid_side.x, y = rule->rule.solid_side.y;
    float along = (pose->c * x - pose->s * y) * nx + (pose->s * x + pose->c * y) * ny;
    return (rule->reversed ? -along : along) / __builtin_sqrtf(x * x + y * y);
}

static void consider(thud_world *w, td_block *block, int lane, const td_rule *rule) {
    td_contact *contact = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[contact->kind]->form);
    if (!(contact->vetoed & TD_HELD)) {
        float slack = TD_SLOP * w->unit, separation = 3.0e38f, closing = 0.0f;
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            if (p->normal_mass[lane] != 0.0f && p->separation[lane] + w->skin < separation) {
                separation = p->separation[lane] + w->skin;
                closing = td_contact_closing(w, block, p, lane);
            }
        }
        if (!(contact->vetoed & TD_PASSING) && closing > 0.0f) {
            separation += closing * (float)w->def.time_step;
        }
        bool held = separation >= -slack && along_side(w, rule, contact->body, block->nx[lane],
                                                       block->ny[lane]) > LEAST_COSINE;
        contact->vetoed = held ? TD_HELD : TD_PASSING | TD_VETOED;
    }
    contact->vetoed &= TD_HELD | TD_PASSING;
    if (contact->vetoed & TD_PASSING) {
        contact->vetoed |= TD_VETOED;
        td_surface_mute(block, points, lane);
    }
}

void td_rules_decide(thud_world *w) {
    td_lane_marks one_way = {.rule = TD_RULE_ONE_WAY};
    w->rules->impulses.count = 0;
    for (int i = 0; i < w->scratch.blocks.count && w->rules->one_way; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int lanes = td_any_lane_marked(block, one_way) ? block->used : 0;
        for (int lane = 0; lane < lanes; lane++) {
            const td_rule *rule = td_rule_of_lane(w, block, lane, TD_RULE_ONE_WAY);
            if (rule) {
                consider(w, block, lane, rule);
            }
        }
    }
}

bool td_rules_let_through(const thud_world *w, const thud_contact *seen) {
    int a = (int)seen->shape_a.index1 - 1, b = (int)seen->shape_b.index1 - 1;
    const td_rule *rule = td_rule_of_pair(w, a, b);
    td_body_index body[2] = {td_shape_at(w, a)->body, td_shape_at(w, b)->body};
    return rule && rule->rule.meeting == THUD_ONE_WAY &&
           along_side(w, rule, body, seen->normal.x, seen->normal.y) <= LEAST_COSINE;
}

/* A plank beside a wall hides nothing of it from whom it lets through. */
bool td_rules_hide(const thud_world *w, int shape, int other) {
    const td_rule *rule = td_rule_of_pair(w, shape, other);
    if (!rule || rule->rule.meeting != THUD_ONE_WAY) {
        return true;
    }
    int e = td_body_at(w, td_shape_at(w, other)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *c = td_constraint_at(w, e / 2);
        if (c->vetoed & TD_HELD && ((c->shape_a == shape && c->shape_b == other) ||
                                    (c->shape_a == other && c->shape_b == shape))) {
            return true;
        }
    }
    return false;
}
