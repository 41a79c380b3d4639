/* depth.c: see depth.h. Boxes by the separating axis theorem, circles and terrain by the distance
 * of points from segments. */
#include "depth.h"

#include <math.h>

static double smaller(double a, double b) {
    return a < b ? a : b;
}

static double larger(double a, double b) {
    return a > b ? a : b;
}

static double clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

/* The point in the box's frame. */
static scene_point into_box(const depth_shape *box, double x, double y) {
    double dx = x - box->x, dy = y - box->y;
    return (scene_point){dx * box->cosine + dy * box->sine, dy * box->cosine - dx * box->sine};
}

static double circle_circle(const depth_shape *a, const depth_shape *b) {
    return a->hx + b->hx - hypot(b->x - a->x, b->y - a->y);
}

static double circle_box(const depth_shape *circle, const depth_shape *box) {
    scene_point p = into_box(box, circle->x, circle->y);
    double nearest_x = clamp(p.x, -box->hx, box->hx), nearest_y = clamp(p.y, -box->hy, box->hy);
    if (nearest_x != p.x || nearest_y != p.y)
        return circle->hx - hypot(p.x - nearest_x, p.y - nearest_y);
    return circle->hx + smaller(box->hx - fabs(p.x), box->hy - fabs(p.y));
}

/* The overlap of the boxes' projections on the axes of `a`, the smaller of both. The Minkowski sum
 * of two boxes has only face normals of the two, so that the penetration depth is the minimum over
 * the four axes. */
static double shadow_overlap(const depth_shape *a, const depth_shape *b) {
    scene_point offset = into_box(a, b->x, b->y);
    double c = fabs(a->cosine * b->cosine + a->sine * b->sine);
    double s = fabs(a->cosine * b->sine - a->sine * b->cosine);
    double along_x = a->hx + b->hx * c + b->hy * s - fabs(offset.x);
    double along_y = a->hy + b->hx * s + b->hy * c - fabs(offset.y);
    return smaller(along_x, along_y);
}

double depth_of_pair(const depth_shape *a, const depth_shape *b) {
    if (a->circle && b->circle)
        return circle_circle(a, b);
    if (a->circle)
        return circle_box(a, b);
    if (b->circle)
        return circle_box(b, a);
    return smaller(shadow_overlap(a, b), shadow_overlap(b, a));
}

static double distance_to_segment(scene_point a, scene_point b, double x, double y) {
    double ex = b.x - a.x, ey = b.y - a.y;
    double t = clamp(((x - a.x) * ex + (y - a.y) * ey) / (ex * ex + ey * ey), 0, 1);
    return hypot(x - a.x - t * ex, y - a.y - t * ey);
}

/* Index of the last vertex at or left of x; -1 if there is none. */
static int vertex_left_of(const depth_ground *ground, double x) {
    int low = -1, high = ground->count;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (ground->points[middle].x <= x)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Signed distance of the point from the line, positive above it. HUGE_VAL beyond the ends, and for
 * a point more than `reach` above the line. */
static double height_above(const depth_ground *ground, double x, double y, double reach) {
    const scene_point *p = ground->points;
    int here = vertex_left_of(ground, x);
    if (here < 0 || x > p[ground->count - 1].x)
        return HUGE_VAL;
    if (here == ground->count - 1)
        here--;
    double t = (x - p[here].x) / (p[here + 1].x - p[here].x);
    double gap = y - (p[here].y + t * (p[here + 1].y - p[here].y));
    /* The line is |gap| above or below the point, so no segment farther aside is nearer. */
    double aside = gap < 0 ? -gap : smaller(gap, reach);
    double nearest = HUGE_VAL;
    for (int i = here; i >= 0 && p[i + 1].x >= x - aside; i--)
        nearest = smaller(nearest, distance_to_segment(p[i], p[i + 1], x, y));
    for (int i = here + 1; i + 1 < ground->count && p[i].x <= x + aside; i++)
        nearest = smaller(nearest, distance_to_segment(p[i], p[i + 1], x, y));
    if (gap < 0)
        return -nearest;
    return nearest > reach ? HUGE_VAL : nearest;
}

static double box_in_ground(const depth_ground *ground, const depth_shape *box) {
    double depth = -HUGE_VAL;
    for (int corner = 0; corner < 4; corner++) {
        double hx = corner & 1 ? box->hx : -box->hx, hy = corner & 2 ? box->hy : -box->hy;
        double x = box->x + hx * box->cosine - hy * box->sine;
        double y = box->y + hx * box->sine + hy * box->cosine;
        depth = larger(depth, -height_above(ground, x, y, 0));
    }
    double half_width = fabs(box->hx * box->cosine) + fabs(box->hy * box->sine);
    int first = vertex_left_of(ground, box->x - half_width) + 1;
    for (int i = first; i < ground->count && ground->points[i].x <= box->x + half_width; i++) {
        scene_point p = into_box(box, ground->points[i].x, ground->points[i].y);
        depth = larger(depth, smaller(box->hx - fabs(p.x), box->hy - fabs(p.y)));
    }
    return depth;
}

double depth_in_ground(const depth_ground *ground, const depth_shape *shape) {
    if (shape->circle)
        return shape->hx - height_above(ground, shape->x, shape->y, shape->hx);
    return box_in_ground(ground, shape);
}
