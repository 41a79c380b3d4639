/* volumes_points.c: bounding volumes around points, and around the points of a ground line. */
#include "terrain/terrain.h"
#include "geometry/volumes.h"

enum { MAX_EXCHANGES = 100, MAX_SIDES = 512 };

/* Points in an array, or the vertices of a line between two points of it. */
typedef struct point_set {
    const thud_pos *points;
    const thud_terrain *terrain; /* or null */
    int first;                   /* of the line's vertices */
    thud_pos ends[2];            /* come first */
    int count;                   /* of all points, > 0 */
    thud_pos origin;             /* the first point; all are worked on as seen from there */
} point_set;

static thud_pos place_of(const point_set *set, int i) {
    if (!set->terrain) {
        return set->points[i];
    }
    int vertex = set->first + i - 2;
    return i < 2 ? set->ends[i]
                 : (thud_pos){td_terrain_x(set->terrain, vertex), set->terrain->points[vertex].y};
}

static thud_pos point_of(const point_set *set, int i) {
    thud_pos place = place_of(set, i);
    return (thud_pos){place.x - set->origin.x, place.y - set->origin.y};
}

/* What the points take up along (c, s). */
static td_span span_of(const point_set *set, double c, double s) {
    td_span span = {0.0, 0.0, 0.0, 0.0};
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

/* A circle through the up to three points that it rests on. */
typedef struct disc {
    thud_pos centre, rests[3];
    int count;
    double square; /* of the radius */
} disc;

static double square_between(thud_pos p, thud_pos q) {
    return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
}

static disc disc_of_two(thud_pos p, thud_pos q) {
    thud_pos centre = {p.x + 0.5 * (q.x - p.x), p.y + 0.5 * (q.y - p.y)};
    return (disc){centre, {p, q}, 2, 0.25 * square_between(p, q)};
}

/* Through three points; without a radius if they are on a line. */
static disc disc_of_three(thud_pos p, thud_pos q, thud_pos r) {
    double qx = q.x - p.x, qy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
    double twice_area = qx * ry - qy * rx, qq = qx * qx + qy * qy, rr = rx * rx + ry * ry;
    double x = (ry * qq - qy * rr) / (2.0 * twice_area);
    double y = (qx * rr - rx * qq) / (2.0 * twice_area);
    return (disc){{p.x + x, p.y + y}, {p, q, r}, 3, x * x + y * y};
}

/* Points that it rests on are off by a rounding. */
static bool holds(const disc *d, thud_pos p) {
    return square_between(d->centre, p) <= d->square * (1.0 + 1e-12);
}

/* The smaller of *best and a candidate that holds what `old` rests on. */
static void keep_smaller(disc *best, disc candidate, const disc *old) {
    bool all = candidate.square < best->square;
    for (int i = 0; i < old->count && all; i++) {
        all = holds(&candidate, old->rests[i]);
    }
    *best = all ? candidate : *best;
}

/* Rests the circle on a point outside of it and on some of those that it rested on, and so makes it
 * larger. False if no such circle holds them all, for a rounding. */
static bool exchange(disc *d, thud_pos p) {
    disc best = {.square = 1e300};
    for (int i = 0; i < d->count; i++) {
        keep_smaller(&best, disc_of_two(p, d->rests[i]), d);
        for (int j = 0; j < i; j++) {
            keep_smaller(&best, disc_of_three(p, d->rests[i], d->rests[j]), d);
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

/* Its radius is measured last, so that it holds all points even where the exchanges end early. */
static thud_volume circle_around(const point_set *set) {
    disc d = {point_of(set, 0), {point_of(set, 0)}, 1, 0.0};
    thud_pos outermost = furthest_from(set, d.centre);
    for (int i = 0; i < MAX_EXCHANGES && !holds(&d, outermost) && exchange(&d, outermost); i++) {
        outermost = furthest_from(set, d.centre);
    }
    return (thud_volume){.x = set->origin.x + d.centre.x,
                         .y = set->origin.y + d.centre.y,
                         .c = 1.0,
                         .hx = __builtin_sqrt(square_between(d.centre, outermost))};
}

/* ---- OBB ---- */

/* The hull's next corner after p, counter-clockwise: no point lies to the right of the way there,
 * and none further along it (Jarvis, On the identification of the convex hull, 1973). */
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

static thud_volume obb_around(const point_set *set) {
    thud_pos start = point_of(set, 0);
    for (int i = 1; i < set->count; i++) {
        thud_pos p = point_of(set, i);
        start = p.y < start.y || (p.y == start.y && p.x < start.x) ? p : start;
    }
    thud_volume best = td_volume_of_span(set->origin, 1.0, 0.0, span_of(set, 1.0, 0.0));
    thud_pos corner = start;
    for (int side = 0; side < MAX_SIDES; side++) {
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

/* ---- what a caller may ask ---- */

static thud_result around(thud_shape_kind kind, point_set *set, thud_volume *out) {
    set->origin = place_of(set, 0);
    for (int i = 0; i < set->count; i++) {
        thud_pos p = place_of(set, i);
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
    td_span span = span_of(set, 1.0, 0.0);
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
