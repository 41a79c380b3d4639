/* joint_draw.c: debug drawing of joints through the caller's functions: lines from the centres of
 * mass to the anchors and between them, axes, limits, and forces. */
#include "joints/gear.h"

#include "api/debug_draw.h"
#include "base/rotation.h"
#include "base/trig.h"
#include "constraint/joint_hooks.h"

/* Length of drawn axes and angle limits, length scales. Chosen. */
#define AXIS_LENGTH 0.5f

/* A joint in the coordinates of the drawing. Side 0 is the caller's a. */
typedef struct drawn {
    thud_vec2 centre[2], place[2]; /* centres of mass; anchors */
    float x, y;                    /* direction `along`, fixed in body[0] of the td_joint */
} drawn;

static thud_vec2 offset_by(thud_vec2 p, float x, float y) {
    return (thud_vec2){p.x + x, p.y + y};
}

static drawn drawn_of(const td_drawing *d, const td_joint *joint) {
    td_joint_place place = td_joint_place_of(d->w, joint);
    drawn out = {.x = place.axis_x, .y = place.axis_y};
    for (int side = 0; side < 2; side++) {
        int of = side ^ joint->swapped;
        out.centre[side] = td_drawing_local(d, td_pose_at(d->w, joint->body[of])->center);
        out.place[side] = offset_by(out.centre[side], place.arm[of][0], place.arm[of][1]);
    }
    return out;
}

static void point(const td_drawing *d, thud_vec2 p) {
    if (d->draw->point) {
        d->draw->point(p, THUD_STYLE_JOINT, d->draw->context);
    }
}

/* A line from a's anchor at an angle (rad) to the axis. */
static void angle_line(const td_drawing *d, const drawn *j, double angle, float length,
                       thud_style style) {
    double s, c;
    td_sincos(angle, &s, &c);
    float x = (float)c * j->x - (float)s * j->y, y = (float)s * j->x + (float)c * j->y;
    td_drawing_line(d, j->place[0], offset_by(j->place[0], length * x, length * y), style);
}

/* Both limits of a direction (x, y): a line between them, and a mark across each end. */
static void limit_marks(const td_drawing *d, thud_vec2 from, float x, float y, const td_drive *of) {
    float half = 0.25f * AXIS_LENGTH * d->w->length_scale, at[2] = {of->lower, of->upper};
    thud_vec2 end[2];
    for (int i = 0; i < 2; i++) {
        end[i] = offset_by(from, at[i] * x, at[i] * y);
        td_drawing_line(d, offset_by(end[i], half * y, -half * x),
                        offset_by(end[i], -half * y, half * x), THUD_STYLE_JOINT_LIMIT);
    }
    td_drawing_line(d, end[0], end[1], THUD_STYLE_JOINT_LIMIT);
}

static void draw_limits(const td_drawing *d, const td_joint *joint, const drawn *j) {
    float length = AXIS_LENGTH * d->w->length_scale, x = j->x, y = j->y;
    if (joint->kind == THUD_JOINT_DISTANCE) {
        float u = j->place[1].x - j->place[0].x, v = j->place[1].y - j->place[0].y;
        float size = __builtin_sqrtf(u * u + v * v);
        x = size > 0.0f ? u / size : 1.0f;
        y = size > 0.0f ? v / size : 0.0f;
    }
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        const td_drive *of = &joint->drive[i];
        if (!(joint->driven >> i & 1u) || !of->limited) {
            continue;
        }
        if (i == THUD_DIRECTION_TURN) {
            angle_line(d, j, (double)of->lower, length, THUD_STYLE_JOINT_LIMIT);
            angle_line(d, j, (double)of->upper, length, THUD_STYLE_JOINT_LIMIT);
        } else {
            bool across = i == THUD_DIRECTION_ACROSS;
            limit_marks(d, j->place[0], across ? -y : x, across ? x : y, of);
        }
    }
}

static void draw_joint(const td_drawing *d, const td_joint *joint) {
    drawn j = drawn_of(d, joint);
    if (joint->kind == THUD_JOINT_GEAR || joint->kind == THUD_JOINT_FILTER) {
        td_drawing_line(d, j.centre[0], j.centre[1], THUD_STYLE_JOINT);
        return;
    }
    for (int side = 0; side < 2; side++) {
        if (td_body_at(d->w, joint->body[side ^ joint->swapped])->kind != THUD_BODY_STATIC) {
            td_drawing_line(d, j.centre[side], j.place[side], THUD_STYLE_JOINT);
        }
        point(d, j.place[side]);
    }
    td_drawing_line(d, j.place[0], j.place[1], THUD_STYLE_JOINT);
    if (joint->kind != THUD_JOINT_DISTANCE) {
        angle_line(d, &j, 0.0, AXIS_LENGTH * d->w->length_scale, THUD_STYLE_JOINT_AXIS);
    }
    draw_limits(d, joint, &j);
}

/* The force on the caller's b, as a line whose length is half the acceleration: half the force
 * times b's inverse mass, or times a's if b's is 0. */
static void draw_force(const td_drawing *d, const td_joint *joint) {
    drawn j = drawn_of(d, joint);
    td_joint_load load = td_joint_load_of(d->w, joint);
    int b = 1 ^ joint->swapped;
    float mass = td_body_at(d->w, joint->body[b])->inv_mass;
    mass = mass > 0.0f ? mass : td_body_at(d->w, joint->body[1 - b])->inv_mass;
    float part = 0.5f * mass;
    td_drawing_line(d, j.place[1], offset_by(j.place[1], part * load.force.x, part * load.force.y),
                    THUD_STYLE_JOINT_FORCE);
}

void td_joints_draw(const td_drawing *d) {
    for (int i = 0; i < d->w->joints.count; i++) {
        const td_joint *joint = td_joint_at(d->w, i);
        if (!joint->live || joint->disabled) {
            continue;
        }
        if (d->draw->flags & THUD_DRAW_JOINTS) {
            draw_joint(d, joint);
        }
        if (d->draw->flags & THUD_DRAW_JOINT_FORCES) {
            draw_force(d, joint);
        }
    }
}
