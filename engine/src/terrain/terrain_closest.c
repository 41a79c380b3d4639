/* terrain_closest.c: the signed distance of a shape from a terrain, with normal and closest points.
 *
 * It is the distance of the shape's centre, the origin here, from the outline of the grown ground
 * (grown_ground.h). For a centre outside, it is the distance to the nearest piece. For a centre
 * inside, pieces that lie below others do not belong to the outline. So the outline is walked from
 * piece to piece, from the point straight above the centre to both sides, until no nearer point can
 * follow. */
#include "terrain/grown_ground.h"

/* Bisections of an interval of x: more than the 53 bits of a double's fraction, so that further
 * ones would change nothing. */
enum { BISECTIONS = 64 };

/* A value of `enough` that td_grown_highest never reaches. */
#define ANY_HEIGHT 1e300

/* ---- candidates ---- */

/* Stores a candidate in *best if its absolute distance is smaller. z is its point of the outline,
 * on the piece e, from which the closest point on the ground follows. */
static void keep_nearer(const td_grown *k, const td_piece *e, thud_closest found, thud_pos z,
                        thud_closest *best) {
    if (td_abs(found.distance) >= td_abs(best->distance)) {
        return;
    }
    found.ax = e->at_vertex ? e->touch.x : z.x + e->touch.x;
    found.ay = e->at_vertex ? e->touch.y : z.y + e->touch.y;
    if (k->mirrored) {
        found.nx = -found.nx;
        found.ax = -found.ax;
    }
    *best = found;
}

/* Tries the point z of the outline as the nearest one: an end of piece e, or a point where two
 * pieces meet. `inside`: the centre is in the grown ground, and the distance is negative. */
static void try_point(const td_grown *k, const td_piece *e, thud_pos z, bool inside,
                      thud_closest *best) {
    double length = __builtin_sqrt(z.x * z.x + z.y * z.y), sign = inside ? 1.0 : -1.0;
    thud_pos n = {sign * z.x / length, sign * z.y / length};
    /* If z is so near that the direction to it is only rounding error, the piece's normal is
     * used. */
    if (length <= 1e-15 * (td_abs(e->touch.x) + td_abs(e->touch.y))) {
        n = td_piece_normal(e, z);
    }
    keep_nearer(k, e, (thud_closest){.distance = -sign * length, .nx = n.x, .ny = n.y}, z, best);
}

/* Tries the foot of the perpendicular from the centre to piece e, if it lies between x = from and x
 * = to. */
static void try_foot(const td_grown *k, const td_piece *e, double from, double to,
                     thud_closest *best) {
    thud_pos n = td_piece_normal(e, (thud_pos){0.0, 0.0});
    double distance = -(e->p.x * n.x + e->p.y * n.y);
    if (e->round) {
        distance = __builtin_sqrt(e->touch.x * e->touch.x + e->touch.y * e->touch.y) - e->radius;
    }
    thud_pos z = {-n.x * distance, -n.y * distance};
    /* A normal that points down belongs to the lower half of the circle, which is not part of the
     * piece. */
    if (z.x >= from && z.x <= to && n.y > 0.0) {
        keep_nearer(k, e, (thud_closest){.distance = distance, .nx = n.x, .ny = n.y}, z, best);
    }
}

/* Tries the nearest point of the vertical side under the right end of the line. */
static void try_side(const td_grown *k, thud_closest *best) {
    thud_pos last = td_grown_vertex(k, k->terrain->count - 1);
    double x = last.x - k->under[0].x, top;
    td_piece e;
    if (!td_grown_highest(k, x, ANY_HEIGHT, &e, &top) || top < 0.0) {
        return;
    }
    e = (td_piece){.at_vertex = true, .touch = {last.x, k->under[0].y}};
    e.touch.y = e.touch.y < last.y ? e.touch.y : last.y;
    keep_nearer(k, &e, (thud_closest){.distance = -x, .nx = 1.0}, e.touch, best);
}

/* ---- from outside: above and beside the ground ---- */

/* Tries the pieces of vertex i. */
static void try_vertex(const td_grown *k, int i, thud_closest *best) {
    for (int part = 0; part < TD_PIECES; part++) {
        td_piece e;
        if (td_grown_piece(k, i, part, &e)) {
            try_foot(k, &e, e.p.x, e.q.x, best);
            try_point(k, &e, e.p, false, best);
            try_point(k, &e, e.q, false, best);
        }
    }
}

/* Finds the nearest point of the outline for a centre outside of the grown ground: first from the
 * vertices above and below the shape, then from those to both sides, as long as they may be nearer.
 * `mirrored` is k with left and right exchanged. */
static void from_outside(const td_grown *k, const td_grown *mirrored, thud_closest *best) {
    int first, last;
    td_grown_vertices(k, 0.0, 0.0, &first, &last);
    for (int i = first; i <= last; i++) {
        try_vertex(k, i, best);
    }
    if (td_grown_vertex(k, k->terrain->count - 1).x < k->under[0].x) {
        try_side(k, best);
    }
    if (td_grown_vertex(k, 0).x > k->under[2].x) {
        try_side(mirrored, best);
    }
    while (first > 0 && k->under[0].x - td_grown_vertex(k, first).x < best->distance) {
        try_vertex(k, --first, best);
    }
    while (last < k->terrain->count - 1 &&
           td_grown_vertex(k, last).x - k->under[2].x < best->distance) {
        try_vertex(k, ++last, best);
    }
}

/* ---- from inside: below the outline ---- */

/* The height of one piece over another at x. */
static double rise(const td_piece *other, const td_piece *top, double x) {
    return td_piece_height(other, x) - td_piece_height(top, x);
}

/* Finds the smallest x between `x` and `stop`, *at, at which the piece `other` rises above the
 * piece `top`; false if there is none. The difference of their heights changes sign at most once in
 * the searched interval: for two straight pieces it is linear; for two round ones, whose radii are
 * equal, it is monotonic; for a straight piece over a round one it is convex and not positive at
 * the start; for a round piece over a straight one it is concave, and is searched only to the x at
 * which both are parallel, where it is greatest. */
static bool overtakes(const td_piece *other, const td_piece *top, double x, double stop,
                      double tolerance, double *at) {
    double low = x > other->p.x ? x : other->p.x;
    double high = stop < other->q.x ? stop : other->q.x;
    if (low >= high) {
        return false;
    }
    if (other->round && !top->round) {
        double dx = top->q.x - top->p.x, dy = top->q.y - top->p.y;
        double parallel = other->touch.x - other->radius * dy / __builtin_sqrt(dx * dx + dy * dy);
        high = td_clamp(parallel, low, high);
    }
    double below = rise(other, top, low), above = rise(other, top, high);
    *at = low;
    if (!(above > tolerance) || !(below < 0.0)) { /* also if heights are NaN */
        return above > tolerance;
    }
    if (!other->round && !top->round) {
        *at = low + (high - low) * (below / (below - above));
        return true;
    }
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = 0.5 * (low + high);
        if (rise(other, top, middle) < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    *at = high;
    return true;
}

/* Tries the point where the outline changes from one piece to the next: in a valley, or at their
 * common end. The height of the point is taken from the flatter piece: x is rounded, and that
 * piece's height changes less with x. The point on the ground is taken from the piece whose normal
 * is nearer to the direction from the shape's centre to this point, in which the shape would leave
 * the ground. */
static void try_corner(const td_grown *k, const td_piece *top, const td_piece *next, double x,
                       thud_closest *best) {
    bool flatter = td_piece_steepness(next, x) < td_piece_steepness(top, x);
    thud_pos z = {x, td_piece_height(flatter ? next : top, x)};
    thud_pos n = td_piece_normal(top, z), m = td_piece_normal(next, z);
    bool leaves_next = m.x * z.x + m.y * z.y > n.x * z.x + n.y * z.y;
    try_point(k, leaves_next ? next : top, z, true, best);
}

/* Walks the outline to the right, from the point of piece `top` at x, and tries all candidates that
 * may be nearer than *best. `tolerance`: heights that differ by less count as equal, length. */
static void walk(const td_grown *k, td_piece top, double x, double tolerance, thud_closest *best) {
    double end = td_grown_vertex(k, k->terrain->count - 1).x - k->under[0].x, height;
    while (x < end && x < -best->distance) {
        td_piece next = top;
        double stop = top.q.x, at;
        int first, last;
        td_grown_vertices(k, x, stop, &first, &last);
        for (int i = first * TD_PIECES; i < (last + 1) * TD_PIECES; i++) {
            td_piece e;
            if (td_grown_piece(k, i / TD_PIECES, i % TD_PIECES, &e) &&
                overtakes(&e, &top, x, stop, tolerance, &at) && at < stop) {
                stop = at;
                next = e;
            }
        }
        try_foot(k, &top, x, stop, best);
        try_corner(k, &top, &next, stop, best);
        bool ended = stop >= top.q.x;
        x = stop > x ? stop : x + tolerance; /* advances in any case, so that rounding cannot make
                                                the loop endless */
        top = next;
        if (ended && !td_grown_highest(k, x, ANY_HEIGHT, &top, &height)) {
            break;
        }
    }
    if (x >= end) {
        try_side(k, best);
    }
}

/* The result for a flat terrain, in closed form. */
static void on_endless_line(const td_grown *k, thud_closest *out) {
    double slope = k->terrain->slope, length = __builtin_sqrt(1.0 + slope * slope);
    td_piece e = td_grown_line(k);
    out->nx = -slope / length;
    out->ny = 1.0 / length;
    out->distance = -(e.p.x * out->nx + e.p.y * out->ny);
    out->ax = e.touch.x - out->nx * out->distance;
    out->ay = e.touch.y - out->ny * out->distance;
}

void td_terrain_closest(const thud_terrain *t, const thud_geometry *shape, thud_pos offset,
                        thud_closest *out) {
    td_grown k = td_grown_by(t, shape, offset), mirrored = td_grown_mirrored(&k);
    td_piece top;
    double height;
    *out = (thud_closest){.distance = 1e300, .ny = 1.0};
    if (t->kind == THUD_TERRAIN_FLAT) {
        on_endless_line(&k, out);
    } else if (td_grown_highest(&k, 0.0, ANY_HEIGHT, &top, &height) && height >= 0.0) {
        double tolerance = 1e-15 * (td_reach(shape) + height);
        *out = (thud_closest){.distance = -1e300, .ny = 1.0};
        try_point(&k, &top, (thud_pos){0.0, height}, true, out);
        walk(&k, top, 0.0, tolerance, out);
        if (td_grown_highest(&mirrored, 0.0, ANY_HEIGHT, &top, &height)) {
            walk(&mirrored, top, 0.0, tolerance, out);
        }
    } else {
        from_outside(&k, &mirrored, out);
    }
    out->bx = out->ax + out->nx * out->distance;
    out->by = out->ay + out->ny * out->distance;
}

thud_result thud_terrain_closest(const thud_terrain *terrain, const thud_geometry *shape,
                                 thud_closest *out) {
    if (!terrain || !shape || !out) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_geometry_check(shape) != THUD_OK) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    td_terrain_closest(terrain, shape, (thud_pos){0.0, 0.0}, out);
    out->ax += shape->x;
    out->ay += shape->y;
    out->bx += shape->x;
    out->by += shape->y;
    return THUD_OK;
}
