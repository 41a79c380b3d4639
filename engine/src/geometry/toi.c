/* toi.c: time of impact of two moving shapes.
 *
 * Shapes that do not turn: the relative path of b's centre against the Minkowski sum of both, in
 * closed form (minkowski.c).
 *
 * Turning shapes: conservative advancement (Mirtich, "Impulse-based Dynamic Simulation of Rigid
 * Body Systems", 1996). Along the normal n of the present closest points, the shapes cannot meet
 * before the first corner has crossed the gap. So time advances to that moment, and n is computed
 * again. The motion of a corner along n is bounded by its Taylor polynomial of second order, with
 * the maximum of the second derivative:
 *
 *     gap(t) >= gap - speed t - bend t^2,  bend = (turn_a^2 radius_a + turn_b^2 radius_b) / 2
 *
 * so that near the impact each advance squares the remaining gap (quadratic convergence).
 * td_time_across_faces also uses the separation from a face of a turning box, which allows longer
 * advances for shapes that slide on each other. Motions take one unit of time; speeds are per that
 * unit. */
#include "geometry/minkowski.h"

/* Maximum number of advances; the search then ends with a time before the impact. Most pairs need
 * fewer than ten; shapes that turn close to each other for a long time need many. Chosen; not
 * tuned. */
enum { ADVANCES_MAX = 1000 };

/* Time of impact of shapes that do not turn: when b's centre, as a point, enters the Minkowski sum
 * of both. */
static void translating(const thud_geometry *a, const thud_motion *ma, const thud_geometry *b,
                        const thud_motion *mb, double target, bool *hit, double *time) {
    double x = b->x - a->x, y = b->y - a->y, nx, ny;
    thud_minkowski sum;
    td_minkowski_sum(a, b, &sum);
    sum.radius += target;
    *time = 0.0;
    *hit = td_minkowski_contains(&sum, x, y);
    if (!*hit) {
        *time = 1.0;
        *hit = td_minkowski_enter(&sum, x, y, mb->dx - ma->dx, mb->dy - ma->dy, time, &nx, &ny);
    }
}

/* Whether the motion turns the shape, and the rotation changes it. */
static bool turns(const thud_geometry *shape, const thud_motion *m) {
    return td_kind_turns(shape->kind) && m->turn != 0.0;
}

/* A corner that may be the first to cross the gap: its coordinate along the direction, from its
 * shape's centre, and its speed along it. */
typedef struct corner {
    double along, speed;
} corner;

/* The corners of a shape that turns by `turn`, along (nx, ny); for a shape that does not turn, its
 * extent as a single corner. Returns their number. */
static int corners_along(const thud_geometry *shape, double turn, double nx, double ny,
                         corner out[4]) {
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        turn = 0.0; /* the rotation of a circle changes nothing */
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        break;
    }
    if (turn == 0.0) {
        out[0] = (corner){td_half_along(shape, nx, ny), 0.0};
        return 1;
    }
    thud_geometry box = *shape;
    box.x = box.y = 0.0;
    for (int i = 0; i < 4; i++) {
        double x, y;
        td_corner(&box, i, &x, &y);
        out[i] = (corner){x * nx + y * ny, turn * (x * ny - y * nx)};
    }
    return 4;
}

/* The smallest positive root of gap = speed t + bend t^2, for gap > 0; 2 if there is none, which is
 * after the end of the motion. */
static double time_to_close(double gap, double speed, double bend) {
    double root = __builtin_sqrt(speed * speed + 4.0 * bend * gap);
    if (speed > 0.0) {
        return 2.0 * gap / (speed + root);
    }
    return bend > 0.0 ? (root - speed) / (2.0 * bend) : 2.0;
}

/* The distance of a box's corners from its centre. */
static double radius_of(const thud_geometry *box) {
    return __builtin_sqrt(box->hx * box->hx + box->hy * box->hy);
}

/* The shapes cannot meet before the circles around turning shapes do, nor before the first pair of
 * corners. The later of both bounds is valid. */
double td_time_across(const thud_geometry *a, const thud_motion *ma, const thud_geometry *b,
                      const thud_motion *mb, double nx, double ny, double target) {
    corner of_a[4], of_b[4];
    double turn_a = turns(a, ma) ? ma->turn : 0.0, turn_b = turns(b, mb) ? mb->turn : 0.0;
    int count_a = corners_along(a, turn_a, nx, ny, of_a);
    int count_b = corners_along(b, turn_b, -nx, -ny, of_b);
    double radius_a = count_a > 1 ? radius_of(a) : of_a[0].along;
    double radius_b = count_b > 1 ? radius_of(b) : of_b[0].along;
    double bend = 0.5 * (turn_a * turn_a * radius_a + turn_b * turn_b * radius_b);
    double apart = (b->x - a->x) * nx + (b->y - a->y) * ny - target;
    double closing = (ma->dx - mb->dx) * nx + (ma->dy - mb->dy) * ny;
    double circles = apart - radius_a - radius_b, corners = 2.0;
    for (int i = 0; i < count_a; i++) {
        for (int j = 0; j < count_b; j++) {
            double time = time_to_close(apart - of_a[i].along - of_b[j].along,
                                        closing + of_a[i].speed + of_b[j].speed, bend);
            corners = time < corners ? time : corners;
        }
    }
    return circles > 0.0 ? td_max_double(corners, time_to_close(circles, closing, 0.0)) : corners;
}

/* As td_time_across, but along the normal of the turning box's face with the greatest separation
 * from the other shape, and in the frame of the box, where the corners of the face do not move
 * towards the gap. In this frame, a corner of the other shape is at
 *
 *     R(-turn t) (from + path t) + R((other turn - turn) t) corner
 *
 * whose second derivative, with twist = other turn - turn, is at most turn (turn (|from| + |path|)
 * + 2 |path|) + twist^2 radius. */
static double time_across_face(const thud_geometry *box, const thud_motion *m,
                               const thud_geometry *other, const thud_motion *mo, double target) {
    double x = other->x - box->x, y = other->y - box->y, vx = mo->dx - m->dx, vy = mo->dy - m->dy;
    double twist = (td_kind_turns(other->kind) ? mo->turn : 0.0) - m->turn, apart = 0.0, nx = 0.0,
           ny = 0.0;
    corner corners[4];
    for (int i = 0; i < 2; i++) {
        double ax = i ? -box->s : box->c, ay = i ? box->c : box->s, along = x * ax + y * ay;
        double sign = along < 0.0 ? -1.0 : 1.0,
               far = sign * along - (i ? box->hy : box->hx) - target;
        corners_along(other, 0.0, ax, ay, corners);
        if (far - corners[0].along > apart) {
            apart = far - corners[0].along, nx = sign * ax, ny = sign * ay;
        }
    }
    if (apart == 0.0) {
        return 0.0;
    }
    double path = __builtin_sqrt(vx * vx + vy * vy), from = __builtin_sqrt(x * x + y * y);
    double turn = td_abs(m->turn), radius = td_kind_is_round(other->kind) ? 0.0 : radius_of(other);
    double bend = 0.5 * (turn * (turn * (from + path) + 2.0 * path) + twist * twist * radius);
    double closing = m->turn * (x * ny - y * nx) - vx * nx - vy * ny, time = 2.0;
    corners_along(other, 0.0, nx, ny, corners);
    double nearest = corners[0].along;
    int count = corners_along(other, twist, -nx, -ny, corners);
    for (int i = 0; i < count; i++) {
        double gap = apart + nearest - corners[i].along;
        time = td_min_double(time, time_to_close(gap, closing + corners[i].speed, bend));
    }
    return time;
}

double td_time_across_faces(const thud_geometry *a, const thud_motion *ma, const thud_geometry *b,
                            const thud_motion *mb, double nx, double ny, double target) {
    double time = td_time_across(a, ma, b, mb, nx, ny, target);
    if (turns(a, ma)) {
        time = td_max_double(time, time_across_face(a, ma, b, mb, target));
    }
    if (turns(b, mb)) {
        time = td_max_double(time, time_across_face(b, mb, a, ma, target));
    }
    return time;
}

/* The distance at which turning shapes count as touching, length: 1e-10 of their extent, far below
 * visibility, and above the rounding of their coordinates. Chosen. */
static double tolerance_of(const thud_geometry *a, const thud_motion *ma, const thud_geometry *b,
                           const thud_motion *mb) {
    double path = td_abs(ma->dx) + td_abs(ma->dy) + td_abs(mb->dx) + td_abs(mb->dy);
    return 1e-10 * (td_reach(a) + td_reach(b)) + 1e-15 * (td_abs(b->x) + td_abs(b->y) + path);
}

void td_time_of_near_impact(const thud_geometry *a, thud_motion ma, const thud_geometry *b,
                            thud_motion mb, double target, double tolerance, td_jump_fn *jump,
                            bool *hit, double *time) {
    if (!turns(a, &ma) && !turns(b, &mb) && target >= 0.0) {
        translating(a, &ma, b, &mb, target, hit, time);
        return;
    }
    /* Both shapes are moved so that a's centre is the origin: far from the origin rounding errors
     * would be too large. */
    thud_geometry here = *a, there = *b;
    here.x = here.y = 0.0;
    there.x -= a->x;
    there.y -= a->y;
    tolerance = td_max_double(tolerance, tolerance_of(&here, &ma, &there, &mb));
    double t = 0.0;
    *hit = false;
    *time = 1.0;
    for (int i = 0; i < ADVANCES_MAX; i++) {
        thud_geometry pa = td_placed_at(&here, &ma, t), pb = td_placed_at(&there, &mb, t);
        thud_closest closest;
        td_closest(&pa, &pb, &closest);
        if (closest.distance - target <= tolerance) {
            break;
        }
        t += jump(&pa, &ma, &pb, &mb, closest.nx, closest.ny, target);
        if (t > 1.0) {
            return;
        }
    }
    /* After ADVANCES_MAX advances a hit is reported too, although the shapes may still be further
     * apart than the tolerance and may never reach the target; the time is never later than an
     * impact. */
    *hit = true;
    *time = t;
}

void td_time_of_impact(const thud_geometry *a, thud_motion ma, const thud_geometry *b,
                       thud_motion mb, double target, bool *hit, double *time) {
    td_time_of_near_impact(a, ma, b, mb, target, 0.0, td_time_across, hit, time);
}

thud_result thud_geometry_time_of_impact(const thud_geometry *a, thud_motion motion_a,
                                         const thud_geometry *b, thud_motion motion_b,
                                         double target, bool *out_hit, double *out_time) {
    if (!a || !b || !out_hit || !out_time) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b) || !td_target_valid(target)) {
        return THUD_ERROR_INVALID;
    }
    td_time_of_impact(a, motion_a, b, motion_b, target, out_hit, out_time);
    return THUD_OK;
}

const td_instance_ops td_all_instances = {thud_geometry_overlap, thud_geometry_time_of_impact,
                                          td_closest};
