/* touch.c: see touch.h. Circles by distance; boxes by the separating axis theorem and clipping of
 * one edge. */
#include "touch.h"

#include <math.h>
#include <stdbool.h>

/* Of axes that are equal up to rounding the first is chosen, so that the choice does not alternate:
 * a later one must separate by this much more, in m per m of box. */
static const double AXIS_PREFERENCE = 1e-9;

static touch_point flipped(touch_point p) {
    p.normal_x = -p.normal_x;
    p.normal_y = -p.normal_y;
    return p;
}

/* The contact point, half way across the gap from the point `from` on the surface of a, along the
 * normal. */
static touch_point point_at(scene_point from, double normal_x, double normal_y, double gap,
                            int feature) {
    return (touch_point){from.x + 0.5 * gap * normal_x,
                         from.y + 0.5 * gap * normal_y,
                         normal_x,
                         normal_y,
                         gap,
                         feature};
}

static touch_point circle_circle(const depth_shape *a, const depth_shape *b) {
    double dx = b->x - a->x, dy = b->y - a->y, distance = hypot(dx, dy);
    double nx = distance > 0 ? dx / distance : 0, ny = distance > 0 ? dy / distance : 1;
    scene_point from = {a->x + a->hx * nx, a->y + a->hx * ny};
    return point_at(from, nx, ny, distance - a->hx - b->hx, 0);
}

static double clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

static scene_point into_box(const depth_shape *box, double x, double y) {
    double dx = x - box->x, dy = y - box->y;
    return (scene_point){dx * box->cosine + dy * box->sine, dy * box->cosine - dx * box->sine};
}

static scene_point turned(const depth_shape *box, double x, double y) {
    return (scene_point){x * box->cosine - y * box->sine, x * box->sine + y * box->cosine};
}

static scene_point out_of_box(const depth_shape *box, double x, double y) {
    scene_point p = turned(box, x, y);
    return (scene_point){box->x + p.x, box->y + p.y};
}

static touch_point box_circle(const depth_shape *box, const depth_shape *circle) {
    scene_point p = into_box(box, circle->x, circle->y);
    scene_point near = {clamp(p.x, -box->hx, box->hx), clamp(p.y, -box->hy, box->hy)};
    double nx = p.x - near.x, ny = p.y - near.y, distance = hypot(nx, ny);
    if (distance > 0) {
        nx /= distance;
        ny /= distance;
    } else if (box->hx - fabs(p.x) < box->hy - fabs(p.y)) {
        nx = p.x < 0 ? -1 : 1;
        ny = 0;
        distance = fabs(p.x) - box->hx;
        near.x = nx * box->hx;
    } else {
        nx = 0;
        ny = p.y < 0 ? -1 : 1;
        distance = fabs(p.y) - box->hy;
        near.y = ny * box->hy;
    }
    scene_point normal = turned(box, nx, ny);
    return point_at(out_of_box(box, near.x, near.y), normal.x, normal.y, distance - circle->hx, 0);
}

/* A face of a box: its outward normal, its distance from the centre, and its half length. */
typedef struct face {
    double normal_x, normal_y, half_height, half_width;
    int index; /* 0 right, 1 top, 2 left, 3 bottom, in the box's frame */
} face;

static face face_of(const depth_shape *box, int index) {
    double sign = index < 2 ? 1 : -1;
    bool upright = index % 2 == 1;
    scene_point n = upright ? turned(box, 0, sign) : turned(box, sign, 0);
    return (face){n.x, n.y, upright ? box->hy : box->hx, upright ? box->hx : box->hy, index};
}

/* The separation of `other` from the box along the face's normal; negative if they overlap along
 * it. */
static double separation_of(const depth_shape *box, const face *f, const depth_shape *other) {
    double distance = (other->x - box->x) * f->normal_x + (other->y - box->y) * f->normal_y;
    double along_x = other->cosine * f->normal_x + other->sine * f->normal_y;
    double along_y = other->cosine * f->normal_y - other->sine * f->normal_x;
    return distance - f->half_height - other->hx * fabs(along_x) - other->hy * fabs(along_y);
}

/* The face of the box with the largest separation. */
static face best_face(const depth_shape *box, const depth_shape *other, double *separation) {
    face best = face_of(box, 0);
    *separation = separation_of(box, &best, other);
    for (int i = 1; i < 4; i++) {
        face f = face_of(box, i);
        double s = separation_of(box, &f, other);
        if (s > *separation) {
            best = f;
            *separation = s;
        }
    }
    return best;
}

/* The face of `box` whose normal is most opposed to (nx, ny). */
static face facing(const depth_shape *box, double nx, double ny) {
    face best = face_of(box, 0);
    for (int i = 1; i < 4; i++) {
        face f = face_of(box, i);
        if (f.normal_x * nx + f.normal_y * ny < best.normal_x * nx + best.normal_y * ny)
            best = f;
    }
    return best;
}

/* Clips the incident face to the sides of the reference face; normals point from the reference box
 * to the incident one. Returns the number of points. */
static int clip(const depth_shape *reference, const face *f, const depth_shape *incident,
                double separation, double margin, touch_point points[2]) {
    face g = facing(incident, f->normal_x, f->normal_y);
    double along[2], gap[2]; /* coordinates of the two ends in the frame of the reference face */
    for (int end = 0; end < 2; end++) {
        double side = end == 0 ? -g.half_width : g.half_width;
        double x = incident->x + g.half_height * g.normal_x + side * g.normal_y;
        double y = incident->y + g.half_height * g.normal_y - side * g.normal_x;
        double dx = x - reference->x, dy = y - reference->y;
        along[end] = dx * f->normal_y - dy * f->normal_x;
        gap[end] = dx * f->normal_x + dy * f->normal_y - f->half_height;
    }
    double slope = along[1] != along[0] ? (gap[1] - gap[0]) / (along[1] - along[0]) : 0;
    int deepest = gap[1] < gap[0];
    double low = fmax(fmin(along[0], along[1]), -f->half_width);
    double high = fmin(fmax(along[0], along[1]), f->half_width);
    if (low >
        high) { /* the face is beside the reference face: it touches only if the boxes overlap */
        if (separation > 0)
            return 0;
        low = high = along[deepest];
    }
    int count = 0;
    for (int end = 0; end < 2; end++) {
        double t = end == 0 ? low : high;
        double d = gap[deepest] + slope * (t - along[deepest]);
        if (d > margin || (end == 1 && low == high))
            continue;
        scene_point from = {
            reference->x + f->half_height * f->normal_x + t * f->normal_y,
            reference->y + f->half_height * f->normal_y - t * f->normal_x,
        };
        points[count++] =
            point_at(from, f->normal_x, f->normal_y, d, f->index * 8 + g.index * 2 + end);
    }
    return count;
}

static int box_box(const depth_shape *a, const depth_shape *b, double margin, touch_point points[2],
                   touch_axis *axis) {
    double by_a, by_b;
    face of_a = best_face(a, b, &by_a), of_b = best_face(b, a, &by_b);
    bool flip = by_b > by_a + AXIS_PREFERENCE * (a->hx + a->hy);
    face f = flip ? of_b : of_a;
    double separation = flip ? by_b : by_a, sign = flip ? -1 : 1;
    *axis = (touch_axis){sign * f.normal_x, sign * f.normal_y, separation};
    if (separation > margin)
        return 0;
    if (!flip)
        return clip(a, &f, b, separation, margin, points);
    int count = clip(b, &f, a, separation, margin, points);
    for (int i = 0; i < count; i++) {
        points[i] = flipped(points[i]);
        points[i].feature += 32;
    }
    return count;
}

int touch_pair(const depth_shape *a, const depth_shape *b, double margin, touch_point points[2],
               touch_axis *axis) {
    touch_axis unused;
    axis = axis ? axis : &unused;
    if (!a->circle && !b->circle)
        return box_box(a, b, margin, points, axis);
    points[0] = a->circle && b->circle ? circle_circle(a, b)
                : b->circle            ? box_circle(a, b)
                                       : flipped(box_circle(b, a));
    *axis = (touch_axis){points[0].normal_x, points[0].normal_y, points[0].gap};
    return points[0].gap <= margin;
}
