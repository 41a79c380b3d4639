/* joint_at.c: defs of joints from positions in the world; see thud_joint_at.h. With p and t the
 * position and the angle of a body's origin, R(-t) the rotation by -t, the frame of a world
 * position q with an x axis at the angle u has, in the body's coordinates, the position R(-t) (q -
 * p) and the angle u - t. */
#include "thud/thud_joint_at.h"

#include "state/body.h"
#include "thud/thud_forces.h"
#include "thud/thud_reads.h"

/* The angle of the vector (x, y), radians, in (-pi, pi], to 1e-15; not a number for (0, 0). With
 * (x, y) in the right half plane tan(angle / 2) = y / (x + |(x, y)|); two more halvings, tan(a / 2)
 * = tan(a) / (1 + sqrt(1 + tan(a)^2)), bring the tangent below 0.2, where twelve terms of the arc
 * tangent's Taylor series suffice. atan2 of the C library is not used, since its bits may differ
 * between platforms. */
static double angle_of(double x, double y) {
    double largest = td_max_double(td_abs(x), td_abs(y));
    x /= largest;
    y /= largest;
    double ahead = td_abs(x), tangent = y / (ahead + __builtin_sqrt(ahead * ahead + y * y));
    for (int i = 0; i < 2; i++) {
        tangent /= 1.0 + __builtin_sqrt(1.0 + tangent * tangent);
    }
    double series = 0.0;
    for (int n = 23; n > 0; n -= 2) {
        series = 1.0 / n - tangent * tangent * series;
    }
    double angle = 8.0 * tangent * series;
    return x >= 0.0 ? angle : (y < 0.0 ? -TD_PI : TD_PI) - angle;
}

/* Sets the frame of a world position in a body's coordinates. If the body does not exist or the
 * position is not finite, the frame's position becomes NaN, so that thud_joint_create refuses the
 * def. */
static void place_frame(const thud_world *w, thud_body_id id, thud_pos place, double axis_angle,
                        thud_joint_frame *frame) {
    double body_angle = 0.0;
    if (thud_body_get_local_point(w, id, place, &frame->position) != THUD_OK) {
        frame->position.x = __builtin_nanf("");
    }
    thud_body_get_rotation(w, id, &body_angle, NULL, NULL);
    frame->angle = axis_angle - body_angle;
}

static bool is_number(float x) {
    return x == x;
}

static thud_joint_def def_at(const thud_world *w, thud_joint_kind kind, thud_body_id a,
                             thud_body_id b, thud_pos from, thud_pos to, double axis_angle) {
    thud_joint_def def = thud_default_joint_def(kind);
    def.body_a = a;
    def.body_b = b;
    place_frame(w, a, from, axis_angle, &def.frame_a);
    place_frame(w, b, to, axis_angle, &def.frame_b);
    return def;
}

/* A def of a joint whose x axis has a given direction in the world. */
static thud_joint_def def_along(const thud_world *w, thud_joint_kind kind, thud_body_id a,
                                thud_body_id b, thud_pos point, thud_vec2 axis) {
    double angle = angle_of((double)axis.x, (double)axis.y);
    return def_at(w, kind, a, b, point, point, angle);
}

thud_joint_def thud_hinge_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos point) {
    TD_IN_OWN_FLOAT_MODE;
    return def_at(w, THUD_JOINT_HINGE, a, b, point, point, 0.0);
}

thud_joint_def thud_weld_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos point) {
    TD_IN_OWN_FLOAT_MODE;
    return def_at(w, THUD_JOINT_WELD, a, b, point, point, 0.0);
}

thud_joint_def thud_slider_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos point,
                              thud_vec2 axis) {
    TD_IN_OWN_FLOAT_MODE;
    return def_along(w, THUD_JOINT_SLIDER, a, b, point, axis);
}

thud_joint_def thud_wheel_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos point,
                             thud_vec2 axis) {
    TD_IN_OWN_FLOAT_MODE;
    return def_along(w, THUD_JOINT_WHEEL, a, b, point, axis);
}

thud_joint_def thud_target_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos point) {
    TD_IN_OWN_FLOAT_MODE;
    return def_at(w, THUD_JOINT_TARGET, a, b, point, point, 0.0);
}

thud_joint_def thud_rod_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos from,
                           thud_pos to) {
    TD_IN_OWN_FLOAT_MODE;
    thud_joint_def def = def_at(w, THUD_JOINT_DISTANCE, a, b, from, to, 0.0);
    if (is_number(def.frame_a.position.x) && is_number(def.frame_b.position.x)) {
        td_position start = td_place_from(w, from), end = td_place_from(w, to);
        double x = (double)(end.x - start.x) / w->to_fixed;
        double y = (double)(end.y - start.y) / w->to_fixed;
        def.length = (float)__builtin_sqrt(x * x + y * y);
    }
    return def;
}

thud_joint_def thud_rope_at(const thud_world *w, thud_body_id a, thud_body_id b, thud_pos from,
                            thud_pos to, float length) {
    TD_IN_OWN_FLOAT_MODE;
    thud_joint_def def = def_at(w, THUD_JOINT_DISTANCE, a, b, from, to, 0.0);
    def.length = length;
    def.drive[THUD_DIRECTION_ALONG].limited = true;
    def.drive[THUD_DIRECTION_ALONG].upper = length;
    return def;
}

thud_joint_id thud_joint_make(thud_world *w, thud_joint_def def) {
    thud_joint_id joint = {0};
    thud_result result = thud_joint_create(w, &def, &joint);
    return result == THUD_OK ? joint : (thud_joint_id){0};
}
