/* touch_ground.c: contact points of a shape and a terrain line with solid below. A circle touches a
 * segment at the foot of its centre, and a convex vertex if the foot is on neither of its segments;
 * a box touches segments with its corners and convex vertices with its faces. In this way nothing
 * catches on the vertex between two segments. */
#include "touch.h"

#include <math.h>
#include <stdbool.h>

typedef struct segment {
    scene_point start, along; /* unit vector, pointing to the right */
    double length;
} segment;

static segment segment_at(const depth_ground *ground, int index) {
    scene_point a = ground->points[index], b = ground->points[index + 1];
    double length = hypot(b.x - a.x, b.y - a.y);
    return (segment){a, {(b.x - a.x) / length, (b.y - a.y) / length}, length};
}

/* Index of the first segment whose right end is right of x. */
static int first_segment(const depth_ground *ground, double x) {
    int low = 0, high = ground->count - 2;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (ground->points[middle + 1].x <= x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The points found so far, the deepest ones if there are too many. */
typedef struct found {
    touch_point *points;
    int count;
} found;

/* Adds a point; if the list is full, it replaces the shallowest point that it is deeper than. */
static void keep(found *f, touch_point p) {
    if (f->count < TOUCH_GROUND_POINTS) {
        f->points[f->count++] = p;
        return;
    }
    int shallowest = 0;
    for (int i = 1; i < f->count; i++)
        if (f->points[i].gap > f->points[shallowest].gap)
            shallowest = i;
    if (p.gap < f->points[shallowest].gap)
        f->points[shallowest] = p;
}

/* A circle; a box's corner is one of radius 0. */
typedef struct ball {
    double x, y, radius;
    int feature; /* of its first contact */
} ball;

/* Whether the line bends upwards at a vertex, so that a point below it is below both segments. */
static bool is_valley(const depth_ground *ground, int index) {
    if (index <= 0 || index >= ground->count - 1)
        return false;
    segment left = segment_at(ground, index - 1), right = segment_at(ground, index);
    return left.along.x * right.along.y - left.along.y * right.along.x > 0;
}

/* Computes the foot of the ball's centre on a segment and its height above it; false if the foot is
 * not on the segment. The interval is half-open, so that each place belongs to one segment. */
static bool foot_on(const depth_ground *ground, const ball *b, int index, double *foot,
                    double *height) {
    segment s = segment_at(ground, index);
    double dx = b->x - s.start.x, dy = b->y - s.start.y;
    *foot = dx * s.along.x + dy * s.along.y;
    *height = dy * s.along.x - dx * s.along.y;
    /* Just below the vertex of a valley the foot is on neither segment, but both have a contact. */
    double beyond = *height < 0 ? -2 * *height : 0;
    double before = is_valley(ground, index) ? beyond : 0;
    double after = is_valley(ground, index + 1) ? beyond : 0;
    return *foot >= -before && *foot < s.length + after;
}

static bool is_below(const depth_ground *ground, const ball *b) {
    segment s = segment_at(ground, first_segment(ground, b->x));
    return (b->y - s.start.y) * s.along.x < (b->x - s.start.x) * s.along.y;
}

/* A centre below the ground is behind several segments; those within this multiple of the nearest
 * distance make contacts. */
static const double NEAR = 3;

static void ball_on_segments(const depth_ground *ground, const ball *b, double reach, double margin,
                             found *f) {
    const scene_point *vertices = ground->points;
    int first = first_segment(ground, b->x - reach), last = first;
    bool below = is_below(ground, b);
    double nearest = HUGE_VAL, foot, height;
    for (; last < ground->count - 1 && vertices[last].x <= b->x + reach; last++)
        if (foot_on(ground, b, last, &foot, &height) && height < 0)
            nearest = fmin(nearest, -height);
    for (int i = first; i < last; i++) {
        if (!foot_on(ground, b, i, &foot, &height) || height - b->radius > margin ||
            (height < 0 && (!below || -height > NEAR * nearest)))
            continue;
        segment s = segment_at(ground, i);
        touch_point p = {.normal_x = -s.along.y,
                         .normal_y = s.along.x,
                         .gap = height - b->radius,
                         .feature = b->feature + 8 * i};
        p.x = s.start.x + foot * s.along.x + 0.5 * p.gap * p.normal_x;
        p.y = s.start.y + foot * s.along.y + 0.5 * p.gap * p.normal_y;
        keep(f, p);
    }
}

/* Vertex `index` is between the segments index - 1 and index. */
static void ball_on_vertex(const depth_ground *ground, const ball *b, int index, double margin,
                           found *f) {
    segment left = segment_at(ground, index - 1), right = segment_at(ground, index);
    double dx = b->x - right.start.x, dy = b->y - right.start.y, distance = hypot(dx, dy);
    bool past_left = dx * left.along.x + dy * left.along.y >= 0;
    bool before_right = dx * right.along.x + dy * right.along.y < 0;
    if (!past_left || !before_right || distance == 0 || distance - b->radius > margin)
        return;
    double gap = distance - b->radius;
    double nx = dx / distance, ny = dy / distance;
    keep(f, (touch_point){right.start.x + 0.5 * gap * nx, right.start.y + 0.5 * gap * ny, nx, ny,
                          gap, b->feature + 8 * index + 1});
}

/* Sine of the largest angle by which a face's normal may be outside of the normals of a vertex's
 * two slopes if the vertex is inside the box. Chosen. */
static const double ASIDE = 0.5;

/* The contact of a convex vertex with the face of the box that is nearest to it. From outside, the
 * vertex can touch only a face whose normal is between those of its two slopes, otherwise a corner
 * touches first; from inside it may leave through a face a little beyond. */
static void vertex_in_box(const depth_ground *ground, const depth_shape *box, int index,
                          double margin, found *f) {
    segment left = segment_at(ground, index - 1), right = segment_at(ground, index);
    if (left.along.x * right.along.y - left.along.y * right.along.x >= 0)
        return; /* concave or straight */
    double dx = right.start.x - box->x, dy = right.start.y - box->y;
    touch_point best = {.gap = -HUGE_VAL};
    for (int face = 0; face < 4; face++) {
        double sign = face < 2 ? 1 : -1;
        bool upright = face % 2 == 1;
        /* Normal into the box, and the vertex's distances from the face and along it. */
        double nx = sign * (upright ? box->sine : -box->cosine);
        double ny = sign * (upright ? -box->cosine : -box->sine);
        double gap = -dx * nx - dy * ny - (upright ? box->hy : box->hx);
        double across = fabs(dx * ny - dy * nx), half = upright ? box->hx : box->hy;
        double aside =
            fmax(-nx * left.along.x - ny * left.along.y, nx * right.along.x + ny * right.along.y);
        bool outward = ny * (left.along.x + right.along.x) > nx * (left.along.y + right.along.y);
        if (gap > margin || across > half || !outward || aside > (gap < 0 ? ASIDE : 0))
            continue;
        if (gap > best.gap)
            best = (touch_point){
                right.start.x - 0.5 * gap * nx, right.start.y - 0.5 * gap * ny, nx, ny, gap,
                4 + 8 * index + face * 0x100000};
    }
    if (best.gap > -fmin(box->hx, box->hy))
        keep(f, best);
}

static void touch_circle(const depth_ground *ground, const depth_shape *circle, double margin,
                         found *f) {
    ball b = {circle->x, circle->y, circle->hx, 0};
    double reach = circle->hx + margin;
    ball_on_segments(ground, &b, reach, margin, f);
    for (int i = first_segment(ground, b.x - reach);
         i < ground->count - 1 && ground->points[i].x <= b.x + reach; i++)
        if (i > 0)
            ball_on_vertex(ground, &b, i, margin, f);
}

static void touch_box(const depth_ground *ground, const depth_shape *box, double margin, found *f) {
    for (int corner = 0; corner < 4; corner++) {
        double hx = corner & 1 ? box->hx : -box->hx, hy = corner & 2 ? box->hy : -box->hy;
        ball b = {box->x + hx * box->cosine - hy * box->sine,
                  box->y + hx * box->sine + hy * box->cosine, 0, corner};
        /* m: how far aside a segment with the foot of a corner below the ground may be. */
        ball_on_segments(ground, &b, margin + 0.1 * (box->hx + box->hy), margin, f);
    }
    double half = fabs(box->hx * box->cosine) + fabs(box->hy * box->sine) + margin;
    for (int i = first_segment(ground, box->x - half);
         i < ground->count - 1 && ground->points[i].x <= box->x + half; i++)
        if (i > 0)
            vertex_in_box(ground, box, i, margin, f);
}

int touch_ground(const depth_ground *ground, const depth_shape *shape, double margin,
                 touch_point points[TOUCH_GROUND_POINTS]) {
    found f = {points, 0};
    if (shape->circle)
        touch_circle(ground, shape, margin, &f);
    else
        touch_box(ground, shape, margin, &f);
    return f.count;
}
