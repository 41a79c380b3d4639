/* extrapolate.c: the free flight of a body in closed form (flight.h), and the API calls that return
 * where it ends.
 *
 * With z = c t, p = (1 - exp(-z)) / z and r = (1 - p) / z, a velocity v0 under the acceleration g
 * and the damping c becomes in the time t
 *   v1 = v0 - v0 z p + g t p,   and the way is   t (v0 p + g t r),
 * as in damping.h, whose series is only valid for small z, as within a step; here z may be large.
 */
#include "casts/flight.h"

#include "base/rotation.h"
#include "state/body.h"
#include "state/handles.h"

/* ---- the flight ---- */

/* From this z on exp(-z) is below the rounding of 1 in double precision: 2^-53 is exp(-36.7). */
#define Z_MAX 40.0

/* p and r. Below Z_MAX they follow from q = (exp(z) - 1) / z and d = (q - 1) / z. These are
 * computed by Taylor's series for x = z / 2^n <= 1/8 in place of z (the first term left out, x^11 /
 * 13!, is below the rounding of d), and then by n doublings of x, in each of which q becomes q (1 +
 * x q / 2), and d becomes d / 2 + q^2 / 4. */
static void damped(double z, double *p, double *r) {
    if (z > Z_MAX) {
        *p = 1.0 / z;
        *r = (1.0 - *p) / z;
        return;
    }
    int doublings = 0;
    double x = z, d = 1.0;
    for (; x > 0.125; x *= 0.5) {
        doublings++;
    }
    for (int k = 12; k > 2; k--) {
        d = 1.0 + x * d / k;
    }
    d *= 0.5;
    double q = 1.0 + x * d;
    for (int i = 0; i < doublings; i++) {
        d = 0.5 * d + 0.25 * q * q;
        q += 0.5 * x * q * q;
        x += x;
    }
    *p = q / (1.0 + z * q);
    *r = (q - d) / (1.0 + z * q);
}

/* Coordinate k of the flight after the time t, if there were no maximum speed. */
static void fly(const td_flight *f, int k, double t, double *moved, double *velocity) {
    double p, r, v = f->velocity[k], gain = f->gain[k] * t;
    damped(f->damping[k] * t, &p, &r);
    *velocity = v - v * f->damping[k] * t * p + gain * p;
    *moved = t * (v * p + gain * r);
}

/* Halvings of the time until a flight reaches the maximum speed: as many as a double has digits. */
enum { HALVINGS = 53 };

/* Each velocity only grows or only falls during a flight. So once a velocity has reached the
 * maximum, it stays there. */
td_flight_point td_flight_at(const td_flight *f, double seconds) {
    td_flight_point at = {0};
    for (int k = 0; k < 3 && f->moves; k++) {
        double max = f->speed_max[k], *moved = &at.moved[k], *velocity = &at.velocity[k];
        fly(f, k, seconds, moved, velocity);
        if (td_abs(*velocity) > max) {
            double end = *velocity > 0.0 ? max : -max, before = 0.0, length = seconds;
            for (int i = 0; i < HALVINGS; i++) {
                length *= 0.5;
                fly(f, k, before + length, moved, velocity);
                before += td_abs(*velocity) > max ? 0.0 : length;
            }
            fly(f, k, before, moved, velocity);
            *moved += end * (seconds - before);
            *velocity = end;
        }
    }
    for (int k = 0; k < 3 && !f->moves; k++) {
        at.velocity[k] = f->velocity[k];
    }
    return at;
}

td_flight td_flight_of(const thud_world *w, td_body_index index) {
    const td_body *body = td_body_at(w, index);
    bool falls = body->kind == THUD_BODY_DYNAMIC;
    double scale = falls ? (double)body->gravity_scale : 0.0;
    double speed = (double)(w->def.maximum_speed * w->length_scale);
    double linear = (double)body->linear_damping;
    td_flight f = {.moves = td_body_is_awake(body),
                   .gain = {(double)w->def.gravity.x * scale, (double)w->def.gravity.y * scale},
                   .damping = {linear, linear, (double)body->angular_damping},
                   .speed_max = {speed, speed, (double)THUD_ANGULAR_SPEED_MAX},
                   .body = index};
    const float *velocity = td_body_velocity(w, body);
    for (int k = 0; k < 3; k++) {
        double v = (double)velocity[k], max = f.speed_max[k];
        f.velocity[k] = !f.moves ? v : v > max ? max : v < -max ? -max : v;
    }
    return f;
}

thud_prediction td_flight_tell(const thud_world *w, const td_flight *f, const td_flight_point *at,
                               double seconds) {
    td_pose pose = *td_pose_at(w, f->body);
    pose.center.x += td_round64(at->moved[0] * w->to_fixed);
    pose.center.y += td_round64(at->moved[1] * w->to_fixed);
    if (at->moved[2] != 0.0) {
        pose.angle += td_angle_between(at->moved[2]);
        td_angle_turn(pose.angle, &pose.c, &pose.s);
    }
    const double *v = at->velocity;
    return (thud_prediction){.body = td_body_handle(w, f->body),
                             .position = td_place_to(w, td_origin_at(w, f->body, &pose)),
                             .angle = td_angle_radians(pose.angle),
                             .velocity = {(float)v[0], (float)v[1]},
                             .angular_velocity = (float)v[2],
                             .seconds = seconds};
}

thud_result td_flight_check(const thud_world *w, const thud_body_id *bodies, int count,
                            double seconds, const thud_prediction *out) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (count < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "predict: the count is negative");
    }
    if (count > 0 && (!bodies || !out)) {
        return td_refuse(w, THUD_ERROR_NULL, "predict: bodies or out is null");
    }
    thud_result result = td_check(w, "predict: seconds", seconds, 0.0, THUD_AHEAD_MAX);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        td_body_index index;
        result = td_find_body(w, bodies[i], &index);
    }
    return result;
}

/* ---- the API ---- */

static thud_prediction extrapolate(const thud_world *w, td_body_index index, double seconds) {
    td_flight f = td_flight_of(w, index);
    td_flight_point end = td_flight_at(&f, seconds);
    return td_flight_tell(w, &f, &end, seconds);
}

thud_result thud_world_extrapolate(const thud_world *w, const thud_body_id *bodies, int count,
                                   double seconds, thud_prediction *out) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = td_flight_check(w, bodies, count, seconds, out);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        td_body_index index;
        result = td_find_body(w, bodies[i], &index);
        out[i] = extrapolate(w, index, seconds);
    }
    return result;
}

thud_result thud_world_extrapolate_awake(const thud_world *w, double seconds, thud_prediction *out,
                                         int capacity, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = td_list_check(w, out, capacity, out_count);
    if (result == THUD_OK) {
        result = td_check(w, "predict: seconds", seconds, 0.0, THUD_AHEAD_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    int count = 0;
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        if (td_body_lives(w, i) && td_body_is_awake(td_body_at(w, i))) {
            if (count < capacity) {
                out[count] = extrapolate(w, i, seconds);
            }
            count++;
        }
    }
    *out_count = count;
    return THUD_OK;
}
