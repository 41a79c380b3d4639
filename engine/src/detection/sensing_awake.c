/* sensing_awake.c: the part of sensing.c for detections that test the paths of both bodies:
 * overlaps of fast bodies with sensors of awake bodies, and of fast sensors with awake bodies. */
#include "contact/contact.h"
#include "detection/sensing.h"
#include "state/body.h"
#include "state/shape.h"

/* Whether two bodies with straight paths are too far apart to have met in the step. False for
 * bodies with several legs. */
static bool are_apart(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    if (!td_sensing_is_straight(w, a) || !td_sensing_is_straight(w, b)) {
        return false;
    }
    const td_position *p = &td_pose_at(w, td_body_of(w, a))->center;
    const td_position *q = &td_pose_at(w, td_body_of(w, b))->center;
    double x = (double)(q->x - p->x) / w->to_fixed, y = (double)(q->y - p->y) / w->to_fixed;
    double reach = (double)(td_row(&w->reach, a)[1] + td_row(&w->reach, b)[1]);
    for (int i = 0; i < 2; i++) {
        const float *delta = td_row(&w->delta, i ? b : a);
        reach += td_abs((double)delta[0]) + td_abs((double)delta[1]);
    }
    return x * x + y * y > reach * reach;
}

/* Tests all pairs of shapes of two bodies. If both are fast, the function is called for both
 * orders, and only the call with the lower slot first tests them. */
static void test_bodies(thud_world *w, td_awake_slot slot, td_awake_slot other) {
    if (other.at == slot.at || (other.at < slot.at && td_sensing_is_fast(w, other)) ||
        are_apart(w, slot, other)) {
        return;
    }
    int a = td_body_at(w, td_body_of(w, slot))->first_shape;
    for (; a != TD_NONE; a = td_shape_at(w, a)->next) {
        int b = td_body_at(w, td_body_of(w, other))->first_shape;
        for (; b != TD_NONE; b = td_shape_at(w, b)->next) {
            td_sensing_test_pair(w, a, b);
        }
    }
}

/* Whether a shape of the body is a sensor. */
static bool has_sensor(const thud_world *w, td_awake_slot slot) {
    int i = td_body_at(w, td_body_of(w, slot))->first_shape;
    while (i != TD_NONE && !(td_shape_at(w, i)->flags & TD_SHAPE_SENSOR)) {
        i = td_shape_at(w, i)->next;
    }
    return i != TD_NONE;
}

/* Tests a fast body against awake bodies: against all if it has a sensor, else against those with
 * sensors. */
void td_sensing_test_awake(thud_world *w, td_awake_slot slot) {
    const td_array *sensing = &w->scratch.sensing;
    if (sensing->count > 0 && has_sensor(w, slot)) {
        for (td_awake_slot other = {1}; other.at < w->body_of.count; other.at++) {
            test_bodies(w, slot, other);
        }
        return;
    }
    for (int i = 0; i < sensing->count; i++) {
        test_bodies(w, slot, td_slot_in(sensing, i));
    }
}
