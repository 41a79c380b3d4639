/* joint.c: which directions the kinds of joints lock and drive, where a joint is in the world, and
 * its frame after motions of its bodies (joint.h), in double precision for the direct solver. */
#include "joints/joint.h"

#include "base/rotation.h"
#include "base/trig.h"

enum {
    ALONG = 1u << THUD_DIRECTION_ALONG,
    ACROSS = 1u << THUD_DIRECTION_ACROSS,
    TURN = 1u << THUD_DIRECTION_TURN,
    ALL = ALONG | ACROSS | TURN
};

_Static_assert((int)THUD_DIRECTION_COUNT == (int)TD_JOINT_DIRECTIONS, "a drive for each direction");

/* For each kind of joint: the directions that it locks, those of them that it locks only while they
 * have no drive (`unless_driven`), and those that may have a drive. */
static const struct {
    unsigned locked, unless_driven, drivable;
} of_kind[] = {[THUD_JOINT_DISTANCE] = {ALONG, ALONG, ALONG},
               [THUD_JOINT_HINGE] = {ALONG | ACROSS, 0, TURN},
               [THUD_JOINT_SLIDER] = {ACROSS | TURN, 0, ALONG},
               [THUD_JOINT_WELD] = {ALL, ALL, ALL},
               [THUD_JOINT_WHEEL] = {ACROSS, 0, ALONG | TURN},
               [THUD_JOINT_TARGET] = {0, 0, ALL},
               [THUD_JOINT_FILTER] = {0, 0, 0},
               [THUD_JOINT_GEAR] = {0, 0, 0}};
_Static_assert(sizeof of_kind / sizeof *of_kind == THUD_JOINT_KIND_COUNT, "every kind has a line");

unsigned td_joint_drivable(int kind) {
    return of_kind[kind].drivable;
}

void td_joint_sort_directions(td_joint *joint) {
    unsigned driven = 0;
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        driven |= (unsigned)td_drive_acts(&joint->drive[i]) << i;
    }
    driven &= td_joint_drivable(joint->kind);
    joint->driven = (uint8_t)driven;
    joint->locked =
        (uint8_t)(of_kind[joint->kind].locked & ~(of_kind[joint->kind].unless_driven & driven));
}

int td_joint_part_kind(const td_joint *joint, int part) {
    bool distance = joint->kind == THUD_JOINT_DISTANCE;
    if (joint->kind == THUD_JOINT_GEAR) {
        return TD_CONSTRAINT_GEAR;
    }
    switch (part) {
    case TD_JOINT_LOCK:
        return distance ? TD_CONSTRAINT_ROD : TD_CONSTRAINT_LOCK;
    case THUD_DIRECTION_TURN:
        return TD_CONSTRAINT_DRIVE_TURN;
    default:
        return distance ? TD_CONSTRAINT_DRIVE_LINE : TD_CONSTRAINT_DRIVE_AXIS;
    }
}

/* ---- geometry ---- */

/* The lever arm of an anchor, from the body's centre of mass, in the world. */
static void arm_of(const thud_world *w, td_body_index index, const float anchor[2], float arm[2]) {
    const td_body *body = td_body_at(w, index);
    const td_pose *pose = td_pose_at(w, index);
    float x = anchor[0] - body->center_x, y = anchor[1] - body->center_y;
    arm[0] = pose->c * x - pose->s * y;
    arm[1] = pose->s * x + pose->c * y;
}

td_joint_place td_joint_place_of(const thud_world *w, const td_joint *joint) {
    const td_pose *a = td_pose_at(w, joint->body[0]), *b = td_pose_at(w, joint->body[1]);
    td_joint_place place;
    for (int side = 0; side < 2; side++) {
        arm_of(w, joint->body[side], joint->anchor[side], place.arm[side]);
    }
    double x = (double)(b->center.x - a->center.x) / w->to_fixed;
    double y = (double)(b->center.y - a->center.y) / w->to_fixed;
    place.x = (float)x + place.arm[1][0] - place.arm[0][0];
    place.y = (float)y + place.arm[1][1] - place.arm[0][1];
    uint32_t turn = b->angle - a->angle - joint->turn;
    place.turn_sign = joint->swapped ? -1.0f : 1.0f;
    place.turn = (float)td_angle_radians(joint->swapped ? 0u - turn : turn);
    place.axis_x = a->c * joint->axis_c - a->s * joint->axis_s;
    place.axis_y = a->s * joint->axis_c + a->c * joint->axis_s;
    return place;
}

float td_joint_line(const td_joint_place *place, float *x, float *y) {
    float length = __builtin_sqrtf(place->x * place->x + place->y * place->y);
    *x = length > 0.0f ? place->x / length : 0.0f;
    *y = length > 0.0f ? place->y / length : 1.0f;
    return length;
}

double td_joint_closing_speed(double gap, double unit, double time) {
    double max_speed = (double)TD_JOINT_CLOSING_SPEED * unit, speed = -gap / time;
    return speed > max_speed ? max_speed : speed < -max_speed ? -max_speed : speed;
}

/* ---- in motion ---- */

/* Rotations within a part of a step are small. Up to TD_SERIES_ANGLE_MAX (rad) the Taylor series of
 * td_joint_sincos have errors below 2^-52 of their values: the terms left out are x^10 / 11! of the
 * sine, x^12 / 12! of the cosine. */

void td_joint_sincos(double angle, double *s, double *c) {
    if (!(td_abs(angle) <= TD_SERIES_ANGLE_MAX)) {
        td_sincos(angle, s, c);
        return;
    }
    double xx = angle * angle;
    *s = angle *
         (1.0 + xx * (-1.0 / 6 + xx * (1.0 / 120 + xx * (-1.0 / 5040 + xx * (1.0 / 362880)))));
    *c =
        1.0 + xx * (-0.5 + xx * (1.0 / 24 + xx * (-1.0 / 720 + xx * (1.0 / 40320 - xx / 3628800))));
}

void td_joint_rotate_arm(double angle, double *u, double *v) {
    double c, s, x = *u, y = *v;
    td_joint_sincos(angle, &s, &c);
    *u = c * x - s * y;
    *v = c * y + s * x;
}

/* The frame f rotated by the angle with cosine c and sine s: its anchors and its gap are the same
 * vectors, in the coordinates of the new axes. */
static td_joint_frame rotate_frame(td_joint_frame f, double c, double s) {
    return (td_joint_frame){.x = c * f.x - s * f.y,
                            .y = c * f.y + s * f.x,
                            .a_u = c * f.a_u + s * f.a_v,
                            .a_v = c * f.a_v - s * f.a_u,
                            .b_u = c * f.b_u + s * f.b_v,
                            .b_v = c * f.b_v - s * f.b_u,
                            .gap_u = c * f.gap_u + s * f.gap_v,
                            .gap_v = c * f.gap_v - s * f.gap_u};
}

td_joint_frame td_joint_frame_at(const td_block *block, int lane, double gap_u, double gap_v) {
    const td_point *p = &block->point[0], *q = &block->point[1];
    return (td_joint_frame){(double)block->nx[lane],
                            (double)block->ny[lane],
                            (double)p->cross_a[lane],
                            (double)q->cross_a[lane],
                            (double)p->cross_b[lane],
                            (double)q->cross_b[lane],
                            gap_u,
                            gap_v};
}

td_joint_frame td_joint_frame_after(const td_block *block, int lane, double gap_u, double gap_v,
                                    bool turns, const double a[3], const double b[3]) {
    td_joint_frame f = td_joint_frame_at(block, lane, gap_u, gap_v);
    double a_u = f.a_u, a_v = f.a_v, b_u = f.b_u, b_v = f.b_v;
    double x = b[0] - a[0], y = b[1] - a[1];
    td_joint_rotate_arm(a[2], &f.a_u, &f.a_v);
    td_joint_rotate_arm(b[2], &f.b_u, &f.b_v);
    f.gap_u += x * f.x + y * f.y + (f.b_v - b_v) - (f.a_v - a_v);
    f.gap_v += y * f.x - x * f.y - (f.b_u - b_u) + (f.a_u - a_u);
    if (turns) {
        double c, s;
        f.a_u -= f.gap_v;
        f.a_v += f.gap_u;
        td_joint_sincos(a[2], &s, &c);
        f = rotate_frame(f, c, s);
    }
    return f;
}

td_joint_frame td_joint_line_after(const td_block *block, int lane, double gap_u, double gap_v,
                                   const double a[3], const double b[3]) {
    td_joint_frame f = td_joint_frame_after(block, lane, gap_u, gap_v, false, a, b);
    double length = __builtin_sqrt(f.gap_u * f.gap_u + f.gap_v * f.gap_v);
    if (length > 0.0) {
        f = rotate_frame(f, f.gap_u / length, f.gap_v / length);
    }
    return f;
}

void td_joint_motion(const thud_world *w, const td_block *block, int lane, double a[3],
                     double b[3]) {
    const float *delta_a = td_row(&w->delta, td_slot_of_side(block->a[lane]));
    const float *delta_b = td_row(&w->delta, td_slot_of_side(block->b[lane]));
    for (int k = 0; k < 3; k++) {
        a[k] = (double)delta_a[k];
        b[k] = (double)delta_b[k];
    }
}

float td_joint_speed(const thud_world *w, const td_block *block, int lane, double x, double y,
                     double cross_a, double cross_b) {
    const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
    const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
    return (float)(((double)b[0] - (double)a[0]) * x + ((double)b[1] - (double)a[1]) * y +
                   (double)b[2] * cross_b - (double)a[2] * cross_a);
}

/* ---- lanes ---- */

float td_joint_inverse_mass(const thud_world *w, const td_block *block, int lane, float linear,
                            float cross_a, float cross_b) {
    float mass_a = td_inv_mass_of(w, td_slot_of_side(block->a[lane]));
    float mass_b = td_inv_mass_of(w, td_slot_of_side(block->b[lane]));
    return linear * (mass_a + mass_b) + block->inv_inertia_a[lane] * cross_a * cross_a +
           block->inv_inertia_b[lane] * cross_b * cross_b;
}
