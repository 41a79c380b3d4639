/* rolling.c: thud_body_apply_rolling_resistance: a torque against the rotation of a body relative
 * to the bodies that its circles touch. It is coefficient * radius * normal force, and at most the
 * torque that stops the rotation within the step. */
#include "fields/fields.h"

#include "constraint/constraint.h"
#include "contact/contact.h"
#include "contact/manifold.h"
#include "state/body.h"
#include "state/handles.h"

/* Sums over the touching contacts of a body's circles. */
typedef struct rolling_sum {
    double grip;          /* sum of radius * normal impulse of the last step */
    double weighted_turn; /* the same sum with each term times the angular velocity of the other
                             body */
} rolling_sum;

/* Adds the contact of an edge to the sums, if it touches a circle of the body. */
static void add_contact(const thud_world *w, td_body_index body, int edge, rolling_sum *sum) {
    const td_constraint *contact = td_constraint_at(w, td_edge_constraint(edge));
    if (!td_is_contact(contact) || contact->state != TD_TOUCHING ||
        td_contact_is_ending(w, contact)) {
        return;
    }
    bool second = td_same_body(contact->body[1], body);
    const td_shape *shape = td_shape_at(w, second ? contact->shape_b : contact->shape_a);
    if (shape->kind != THUD_SHAPE_CIRCLE) {
        return;
    }
    thud_manifold manifold = td_manifold_of(w, contact);
    double grip = 0.0;
    for (int i = 0; i < manifold.point_count; i++) {
        grip += (double)shape->half_x * (double)manifold.normal_impulse[i];
    }
    const float *other = td_body_velocity(w, td_body_at(w, td_other_body(w, edge)));
    sum->grip += grip;
    sum->weighted_turn += grip * (double)other[2];
}

thud_result thud_body_apply_rolling_resistance(thud_world *w, thud_body_id id, float coefficient) {
    TD_IN_OWN_FLOAT_MODE;
    td_field_body a;
    thud_result result = td_field_body_find(w, id, &a);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_field(w, "apply rolling resistance: coefficient", coefficient, THUD_DRAG_MAX);
    if (result != THUD_OK) {
        return result;
    }
    const td_body *body = td_body_at(w, a.index);
    rolling_sum sum = {0};
    for (int e = body->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        add_contact(w, a.index, e, &sum);
    }
    if (!a.takes_force || !(sum.grip > 0.0) || !(body->inv_inertia > 0.0f)) {
        return THUD_OK;
    }
    double turn = a.turn - sum.weighted_turn / sum.grip; /* relative to the weighted mean of the
                                                            touched bodies */
    double stopping_impulse = td_abs(turn) / (double)body->inv_inertia;
    double torque =
        td_min_double((double)coefficient * sum.grip, stopping_impulse) / w->def.time_step;
    return td_field_push(w, &a, (td_push){.turn = turn > 0.0 ? -torque : torque});
}
