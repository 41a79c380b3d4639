/* volumes_points.c: bounding volumes of points, and of the part of a terrain between two values of
 * x.
 *
 * Circle: the smallest enclosing circle, by exchanging its supporting points (Elzinga and Hearn,
 * "Geometrical solutions for some minimax location problems", 1972): two or three points support
 * the circle; while some point is outside, the furthest one becomes a support, and the circle
 * grows. OBB: the box of least area has a side along an edge of the convex hull (Freeman and
 * Shapira, "Determining the minimum-area encasing rectangle", 1975), so that all edges are tried,
 * in the order of Jarvis's march around the hull (1973). */
#include "terrain/terrain.h"
#include "geometry/volumes.h"

/* Maximum iterations of both searches. If one is reached, the volume still contains all points, but
 * need not be the smallest: a circle's radius is measured at the end, and an OBB is the best of the
 * edges so far. Each edge of the hull takes two passes over all points. Chosen; not tuned. */
enum { EXCHANGES_MAX = 100, HULL_EDGES_MAX = 512 };

/* The points of an array; or the two end points of a part of a terrain and the vertices between
 * them. */
typedef struct point_set {
    const thud_pos *points;
    const thud_terrain *terrain; /* null: the points are in `points` */
    int first;                   /* first of the terrain's vertices */
    thud_pos ends[2]; /* the end points of the terrain's part; they are points 0 and 1 of the set */
    int count;        /* of all points, > 0 */
    thud_pos origin;  /* the first point; computations are relative to it */
} point_set;

/* Point i in the caller's coordinates. */
static thud_pos position_of(const point_set *set, int i) {
    if (!set->terrain) {
        return set->points[i];
    }
    int vertex = set->first + i - 2;
    return i < 2 ? set->ends[i]
                 : (thud_pos){td_terrain_x(set->terrain, vertex), set->terrain->points[vertex].y};
}

/* Point i relative to the origin of the set. */
static thud_pos point_of(const point_set *set, int i) {
    thud_pos place = position_of(set, i);
    return (thud_pos){place.x - set->origin.x, place.y - set->origin.y};
}

/* The span of the points along (c, s). */
static td_volume_span span_of(const point_set *set, double c, double s) {
    td_volume_span span = {0.0, 0.0, 0.0, 0.0};
    for (int i = 1; i < set->count; i++) {
        thud_pos p = point_of(set, i);
        double u = c * p.x + s * p.y, v = c * p.y - s * p.x;
        span.u_min = u < span.u_min ? u : span.u_min;
        span.u_max = u > span.u_max ? u : span.u_max;
        span.v_min = v < span.v_min ? v : span.v_min;
        span.v_max = v > span.v_max ? v : span.v_max;
    }
    return span;
}

/* ---- circle ---- */

/* A circle through the up to three points that support it. */
typedef struct circle {
    thud_pos centre, support[3];
    int count;
    double square; /* radius squared */
} circle;

static double square_between(thud_pos p, thud_pos q) {
    return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
}

static circle circle_of_two(thud_pos p, thud_pos q) {
    thud_pos centre = {p.x + 0.5 * (q.x - p.x), p.y + 0.5 * (q.y - p.y)};
    return (circle){centre, {p, q}, 2, 0.25 * square_between(p, q)};
}

/* The circle through three points; its radius is infinite or NaN if they are on a line. */
static circle circle_of_three(thud_pos p, thud_pos q, thud_pos r) {
    double qx = q.x - p.x, qy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
    double twice_area = qx * ry - qy * rx, qq = qx * qx + qy * qy, rr = rx * rx + ry * ry;
    double x = (ry * qq - qy * rr) / (2.0 * twice_area);
    double y = (qx * rr - rx * qq) / (2.0 * twice_area);
    return (circle){{p.x + x, p.y + y}, {p, q, r}, 3, x * x + y * y};
}

/* Whether a circle contains a point, with a tolerance for its supporting points. */
static bool contains(const circle *d, thud_pos p) {
    return square_between(d->centre, p) <= d->square * (1.0 + 1e-12);
}

/* Stores a candidate in *best if it is smaller and contains the points that support `old`. */
static void keep_smaller(circle *best, circle candidate, const circle *old) {
    bool all = candidate.square < best->square;
    for (int i = 0; i < old->count && all; i++) {
        all = contains(&candidate, old->support[i]);
    }
    *best = all ? candidate : *best;
}

/* Replaces the circle by the smallest one that contains its supporting points and p, a point
 * outside of it, and is supported by p and some of them. False if rounding leaves none. */
static bool exchange(circle *d, thud_pos p) {
    circle best = {.square = 1e300};
    for (int i = 0; i < d->count; i++) {
        keep_smaller(&best, circle_of_two(p, d->support[i]), d);
        for (int j = 0; j < i; j++) {
            keep_smaller(&best, circle_of_three(p, d->support[i], d->support[j]), d);
        }
    }
    *d = best.count > 0 ? best : *d;
    return best.count > 0;
}

static thud_pos furthest_from(const point_set *set, thud_pos centre) {
    thud_pos furthest = point_of(set, 0);
    for (int i = 1; i < set->count; i++) {
        thud_pos p = point_of(set, i);
        furthest = square_between(centre, p) > square_between(centre, furthest) ? p : furthest;
    }
    return furthest;
}

/* The radius is measured at the end, so that it contains all points even where EXCHANGES_MAX is
 * reached. */
static thud_volume circle_around(const point_set *set) {
    circle d = {point_of(set, 0), {point_of(set, 0)}, 1, 0.0};
    thud_pos furthest = furthest_from(set, d.centre);
    for (int i = 0; i < EXCHANGES_MAX && !contains(&d, furthest) && exchange(&d, furthest); i++) {
        furthest = furthest_from(set, d.centre);
    }
    return (thud_volume){.x = set->origin.x + d.centre.x,
                         .y = set->origin.y + d.centre.y,
                         .c = 1.0,
                         .hx = __builtin_sqrt(square_between(d.centre, furthest))};
}

/* ---- OBB ---- */

/* The next corner of the convex hull after p, counter-clockwise: no point is to the right of the
 * line from p to it, and none on the line is further away. */
static thud_pos next_corner(const point_set *set, thud_pos p) {
    thud_pos next = p;
    for (int i = 0; i < set->count; i++) {
        thud_pos q = point_of(set, i);
        double side = (next.x - p.x) * (q.y - p.y) - (next.y - p.y) * (q.x - p.x);
        bool further = side == 0.0 && square_between(p, q) > square_between(p, next);
        next = side < 0.0 || further ? q : next;
    }
    return next;
}

/* The smallest OBB over the directions of the hull's edges. */
static thud_volume obb_around(const point_set *set) {
    thud_pos start = point_of(set, 0);
    for (int i = 1; i < set->count; i++) {
        thud_pos p = point_of(set, i);
        start = p.y < start.y || (p.y == start.y && p.x < start.x) ? p : start;
    }
    thud_volume best = td_volume_of_span(set->origin, 1.0, 0.0, span_of(set, 1.0, 0.0));
    thud_pos corner = start;
    for (int side = 0; side < HULL_EDGES_MAX; side++) {
        thud_pos next = next_corner(set, corner);
        thud_pos along = td_volume_direction(next.x - corner.x, next.y - corner.y);
        td_volume_keep_smaller(&best, set->origin, along.x, along.y,
                               span_of(set, along.x, along.y));
        if (next.x == start.x && next.y == start.y) {
            break;
        }
        corner = next;
    }
    return best;
}

/* ---- public functions ---- */

/* The bounding volume of a set, whose origin is not set yet. */
static thud_result around(thud_shape_kind kind, point_set *set, thud_volume *out) {
    set->origin = position_of(set, 0);
    for (int i = 0; i < set->count; i++) {
        thud_pos p = position_of(set, i);
        if (!(td_abs(p.x) <= THUD_COORDINATE_MAX && td_abs(p.y) <= THUD_COORDINATE_MAX)) {
            return THUD_ERROR_INVALID;
        }
    }
    if (!td_kind_is_volume(kind)) {
        return THUD_ERROR_INVALID;
    }
    if (td_kind_is_round(kind)) {
        return td_volume_store(kind, circle_around(set), out);
    }
    if (td_kind_turns(kind)) {
        return td_volume_store(kind, obb_around(set), out);
    }
    td_volume_span span = span_of(set, 1.0, 0.0);
    return td_volume_store(kind, td_volume_of_span(set->origin, 1.0, 0.0, span), out);
}

thud_result thud_volume_around_points(thud_shape_kind kind, const thud_pos *points, int count,
                                      thud_volume *out) {
    if (!points || !out) {
        return THUD_ERROR_NULL;
    }
    if (count < 1) {
        return THUD_ERROR_INVALID;
    }
    point_set set = {.points = points, .count = count};
    return around(kind, &set, out);
}

thud_result thud_volume_around_terrain(thud_shape_kind kind, const thud_terrain *terrain,
                                       double x_min, double x_max, thud_volume *out) {
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || !out) {
        return readable != THUD_OK ? readable : THUD_ERROR_NULL;
    }
    if (!(x_min <= x_max && td_finite(x_min) && td_finite(x_max))) {
        return THUD_ERROR_INVALID;
    }
    point_set set = {.terrain = terrain, .count = 2};
    if (terrain->kind != THUD_TERRAIN_FLAT) {
        double left = td_terrain_x(terrain, 0), right = td_terrain_x(terrain, terrain->count - 1);
        x_min = x_min > left ? x_min : left;
        x_max = x_max < right ? x_max : right;
        set.first = td_terrain_segment_at(terrain, x_min) + 1;
        set.count += td_max_int(td_terrain_segment_at(terrain, x_max) + 1 - set.first, 0);
    }
    const double at[2] = {x_min, x_max};
    for (int i = 0; i < 2; i++) {
        thud_terrain_sample sample;
        if (thud_terrain_sample_at(terrain, at[i], &sample) != THUD_OK) {
            return THUD_ERROR_INVALID;
        }
        set.ends[i] = (thud_pos){at[i], sample.height};
    }
    return around(kind, &set, out);
}
