/* cover_distance.c: the greatest distance of a point of a set from a union of convex sets, by
 * branch and bound.
 *
 * The distance from a convex set is a convex function, so that over a convex piece its maximum is
 * at a corner (Boyd and Vandenberghe, Convex Optimization, 2004, 3.2.5). For each piece, the set
 * with the smallest such maximum (the nearest set) gives an upper bound of the distance from the
 * union; the distance of a corner from the union is a lower bound. A piece whose upper bound
 * exceeds the greatest lower bound of all pieces by more than the allowed error is cut. If a side
 * of the nearest set passes through it, it is cut along that side, so that the pieces of a polygon
 * that consists of boxes end up in one box each; otherwise it is cut in the middle of its greatest
 * extent.
 *
 * A circle is divided into a square and four segments between an arc and its chord. Each segment
 * lies in the triangle of the arc's ends and the point where the tangents at these ends meet. */
#include "geometry/cover.h"

#include "thud/thud_approximate.h"

/* How far the result may exceed the distance: a length, and a share of the distance. Chosen: the
 * difference is not visible. */
static const double PRECISION = 1.0 / 1024.0, PRECISION_SHARE = 1.0 / 16.0;
/* Each time this many pieces have been examined, PRECISION is doubled, so that the search ends
 * sooner. While the lower bound is 0 no error is allowed, and only TD_PIECE_DEPTH limits the
 * search. Chosen: most polygons need some hundreds. */
enum { PIECES = 4096 };
/* Tolerances: a point nearer to a line than the first is on it, and a distance below the second is
 * 0; coordinates are about 1. */
static const double ON_LINE = 1e-12, NO_DISTANCE = 1e-11;

static double length_of(double x, double y) {
    return __builtin_sqrt(x * x + y * y);
}

/* ---- convex sets ---- */

/* Completes a polygon whose corners are set. */
static void finish_polygon(td_convex *set, int count) {
    set->count = count;
    for (int i = 0; i < count; i++) {
        set->x += set->corners[i].x / count;
        set->y += set->corners[i].y / count;
    }
    for (int i = 0; i < count; i++) {
        thud_pos p = set->corners[i], q = set->corners[i + 1 < count ? i + 1 : 0];
        double x = q.x - p.x, y = q.y - p.y, length = length_of(x, y);
        set->normals[i] = (thud_pos){y / length, -x / length};
        set->reach = td_max_double(set->reach, length_of(p.x - set->x, p.y - set->y));
    }
}

td_convex td_convex_of_shape(const thud_geometry *shape) {
    td_convex set = {.x = 0.0};
    if (td_kind_is_round(shape->kind)) {
        set.x = shape->x;
        set.y = shape->y;
        set.reach = shape->hx;
        return set;
    }
    for (int i = 0; i < 4; i++) {
        td_corner(shape, i, &set.corners[i].x, &set.corners[i].y);
    }
    finish_polygon(&set, 4);
    return set;
}

td_convex td_convex_of_triangle(thud_pos a, thud_pos b, thud_pos c) {
    td_convex set = {.corners = {a, b, c}};
    finish_polygon(&set, 3);
    return set;
}

/* The distance of p from the line of an edge, positive outside. */
static double beyond(const td_convex *set, int edge, thud_pos p) {
    return (p.x - set->corners[edge].x) * set->normals[edge].x +
           (p.y - set->corners[edge].y) * set->normals[edge].y;
}

/* The distance of p from an edge as a segment; `out` is its distance outside of the edge's line. */
static double from_edge(const td_convex *set, int edge, double out, thud_pos p) {
    thud_pos a = set->corners[edge], b = set->corners[edge + 1 < set->count ? edge + 1 : 0];
    double tx = -set->normals[edge].y, ty = set->normals[edge].x;
    double before = (a.x - p.x) * tx + (a.y - p.y) * ty;
    double after = (p.x - b.x) * tx + (p.y - b.y) * ty;
    return before > 0.0  ? length_of(p.x - a.x, p.y - a.y)
           : after > 0.0 ? length_of(p.x - b.x, p.y - b.y)
                         : out;
}

/* The distance of p from a set, 0 inside. */
static double distance_from(const td_convex *set, thud_pos p) {
    if (set->count == 0) {
        return td_max_double(length_of(p.x - set->x, p.y - set->y) - set->reach, 0.0);
    }
    double nearest = 1e300;
    bool outside = false;
    for (int i = 0; i < set->count; i++) {
        double out = beyond(set, i, p);
        if (out > 0.0) {
            outside = true;
            nearest = td_min_double(nearest, from_edge(set, i, out, p));
        }
    }
    return outside ? nearest : 0.0;
}

/* ---- bounds ---- */

/* An upper and a lower bound of the greatest distance of a piece's points from the union. */
typedef struct bounds {
    double upper, lower;
} bounds;

/* The greatest distance of the corners from one set. Lowers `nearest`, the distance of each corner
 * from the union, accordingly. */
static double farthest(const td_convex *set, const td_cover_piece *piece, int corners,
                       double *nearest) {
    double distance_max = 0.0;
    for (int k = 0; k < corners; k++) {
        double distance = distance_from(set, piece->corners[k]);
        distance_max = td_max_double(distance_max, distance);
        nearest[k] = td_min_double(nearest[k], distance);
    }
    return distance_max;
}

/* The signed distance of p from the outline of a polygon, negative inside: a point is inside if a
 * ray to the right crosses an odd number of edges. */
static double depth_in(const thud_pos *points, int count, thud_pos p) {
    double square_min = 1e300;
    bool inside = false;
    for (int i = 0; i < count; i++) {
        thud_pos a = points[i], b = points[i + 1 < count ? i + 1 : 0];
        double x = b.x - a.x, y = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
        if ((a.y > p.y) != (b.y > p.y) && px < py * (x / y)) {
            inside = !inside;
        }
        double square = x * x + y * y; /* 0 if rounding made two points equal */
        double t = square > 0.0 ? td_clamp((px * x + py * y) / square, 0.0, 1.0) : 0.0;
        double dx = px - t * x, dy = py - t * y;
        square_min = td_min_double(square_min, dx * dx + dy * dy);
    }
    double distance = __builtin_sqrt(square_min);
    return inside ? -distance : distance;
}

/* Whether a circle around a piece lies in the polygon; false if that is not certain. */
static bool is_deep(const td_cover_piece *piece, const thud_pos *points, int count) {
    int corners = piece->count > 0 ? piece->count : 3;
    thud_pos centre = {0.0, 0.0};
    double reach = 0.0;
    for (int k = 0; k < corners; k++) {
        centre.x += piece->corners[k].x / corners;
        centre.y += piece->corners[k].y / corners;
    }
    for (int k = 0; k < corners; k++) {
        reach = td_max_double(reach, length_of(piece->corners[k].x - centre.x,
                                               piece->corners[k].y - centre.y));
    }
    return depth_in(points, count, centre) + reach <= 0.0;
}

/* The bounds of one piece. Sets piece->nearest to the set that gives the upper one. Sets that are
 * too far away to change either bound are skipped; the nearest set of the piece before it was cut
 * is tried first. */
static bounds bounds_of(td_cover_piece *piece, const td_convex *to, int count) {
    int corners = piece->count > 0 ? piece->count : 3;
    double nearest[TD_PIECE_CORNERS], reach = 0.0;
    thud_pos first = piece->corners[0];
    for (int k = 0; k < corners; k++) {
        nearest[k] = 1e300;
        reach = td_max_double(reach, length_of(piece->corners[k].x - first.x,
                                               piece->corners[k].y - first.y));
    }
    int best = piece->nearest;
    bounds result = {farthest(&to[best], piece, corners, nearest), 0.0};
    for (int i = 0; i < count; i++) {
        double apart = length_of(first.x - to[i].x, first.y - to[i].y) - to[i].reach - reach;
        if (apart < result.upper && i != best) {
            double upper = farthest(&to[i], piece, corners, nearest);
            if (upper < result.upper) {
                result.upper = upper;
                piece->nearest = i;
            }
        }
    }
    /* The point where two tangents meet does not belong to the set. */
    for (int k = 0; k < (piece->count > 0 ? corners : 2); k++) {
        result.lower = td_max_double(result.lower, nearest[k]);
    }
    return result;
}

/* ---- cuts ---- */

/* Computes the two parts of a piece on both sides of the line through `at` with this normal. */
static void cut_along(const td_cover_piece *piece, thud_pos at, double nx, double ny,
                      td_cover_piece out[2]) {
    out[0].count = out[1].count = 0;
    for (int i = 0; i < piece->count; i++) {
        thud_pos p = piece->corners[i], q = piece->corners[i + 1 < piece->count ? i + 1 : 0];
        double dp = (p.x - at.x) * nx + (p.y - at.y) * ny;
        double dq = (q.x - at.x) * nx + (q.y - at.y) * ny;
        if (dp >= -ON_LINE) {
            out[0].corners[out[0].count++] = p;
        }
        if (dp <= ON_LINE) {
            out[1].corners[out[1].count++] = p;
        }
        if ((dp > ON_LINE && dq < -ON_LINE) || (dp < -ON_LINE && dq > ON_LINE)) {
            double f = dp / (dp - dq);
            thud_pos cross = {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
            out[0].corners[out[0].count++] = cross;
            out[1].corners[out[1].count++] = cross;
        }
    }
}

/* Cuts a piece along the line from corner 0 to the opposite corner, so that no new corners are
 * needed. */
static void cut_across(const td_cover_piece *piece, td_cover_piece out[2]) {
    int half = piece->count / 2;
    out[0].count = out[1].count = 0;
    for (int i = 0; i <= half; i++) {
        out[0].corners[out[0].count++] = piece->corners[i];
    }
    for (int i = half; i <= piece->count; i++) {
        out[1].corners[out[1].count++] = piece->corners[i % piece->count];
    }
}

/* Cuts a piece in the middle of its greatest extent. */
static void cut_middle(const td_cover_piece *piece, td_cover_piece out[2]) {
    int a = 0, b = 1;
    double length_max = -1.0;
    for (int i = 0; i < piece->count; i++) {
        for (int j = i + 1; j < piece->count; j++) {
            double length = length_of(piece->corners[j].x - piece->corners[i].x,
                                      piece->corners[j].y - piece->corners[i].y);
            if (length > length_max) {
                length_max = length, a = i, b = j;
            }
        }
    }
    thud_pos p = piece->corners[a], q = piece->corners[b];
    thud_pos middle = {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
    cut_along(piece, middle, (q.x - p.x) / length_max, (q.y - p.y) / length_max, out);
}

/* Of the sides of a polygon whose line passes through the piece, chooses the one beyond which the
 * piece extends the most, and cuts along it. False if there is none. */
static bool cut_at_side(const td_cover_piece *piece, const td_convex *set, td_cover_piece out[2]) {
    int side = TD_NONE;
    double high_max = 1e-6;
    for (int edge = 0; edge < set->count; edge++) {
        double low = 0.0, high = 0.0;
        for (int k = 0; k < piece->count; k++) {
            double out_by = beyond(set, edge, piece->corners[k]);
            low = td_min_double(low, out_by);
            high = td_max_double(high, out_by);
        }
        if (low < -1e-6 && high > high_max) {
            high_max = high;
            side = edge;
        }
    }
    if (side == TD_NONE) {
        return false;
    }
    cut_along(piece, set->corners[side], set->normals[side].x, set->normals[side].y, out);
    return true;
}

/* The segment of the circle `of` between the arc from a to b and its chord. */
static td_cover_piece arc_of(const td_convex *of, thud_pos a, thud_pos b) {
    double ax = a.x - of->x, ay = a.y - of->y, bx = b.x - of->x, by = b.y - of->y;
    double square = of->reach * of->reach, far = square / (square + ax * bx + ay * by);
    return (td_cover_piece){.corners = {a, b, {of->x + far * (ax + bx), of->y + far * (ay + by)}}};
}

/* Cuts a circle segment into the segments of both halves of its arc, and the triangle below
 * them. */
static int cut_arc(const td_cover_piece *piece, const td_convex *of, td_cover_piece out[3]) {
    thud_pos a = piece->corners[0], b = piece->corners[1];
    double x = 0.5 * (a.x + b.x) - of->x, y = 0.5 * (a.y + b.y) - of->y;
    double to_edge = of->reach / length_of(x, y);
    thud_pos middle = {of->x + x * to_edge, of->y + y * to_edge};
    out[0] = arc_of(of, a, middle);
    out[1] = arc_of(of, middle, b);
    out[2] = (td_cover_piece){.corners = {a, middle, b}, .count = 3};
    return 3;
}

/* Cuts a piece of the set `of`. Returns the number of parts. */
static int cut(const td_cover_piece *piece, const td_convex *of, const td_convex *to,
               td_cover_piece out[3]) {
    if (piece->count == 0) {
        return cut_arc(piece, of, out);
    }
    if (piece->count + 1 >= TD_PIECE_CORNERS) {
        cut_across(piece, out);
    } else if (piece->depth % 4 == 3 || !cut_at_side(piece, to, out)) {
        cut_middle(piece, out);
    }
    return 2;
}

/* The pieces of a whole set. */
static int pieces_of(const td_convex *of, td_cover_piece *out) {
    if (of->count > 0) {
        out[0] = (td_cover_piece){.count = of->count};
        for (int i = 0; i < of->count; i++) {
            out[0].corners[i] = of->corners[i];
        }
        return 1;
    }
    double x = of->x, y = of->y, r = of->reach;
    const thud_pos at[4] = {{x + r, y}, {x, y + r}, {x - r, y}, {x, y - r}};
    out[0] = (td_cover_piece){.corners = {at[0], at[1], at[2], at[3]}, .count = 4};
    for (int i = 0; i < 4; i++) {
        out[i + 1] = arc_of(of, at[i], at[(i + 1) % 4]);
    }
    return 5;
}

double td_cover_distance(const td_convex *from, const td_convex *to, int count,
                         const thud_pos *points, int point_count, double known,
                         td_cover_piece *stack) {
    int height = pieces_of(from, stack);
    double upper = 0.0, lower = known, precision = PRECISION;
    for (int done = 1; height > 0; done++) {
        td_cover_piece piece = stack[--height];
        if (points && is_deep(&piece, points, point_count)) {
            continue;
        }
        bounds of_piece = bounds_of(&piece, to, count);
        lower = td_max_double(lower, of_piece.lower);
        double enough = lower + td_max_double(precision, PRECISION_SHARE * lower);
        if (of_piece.upper <= (lower > NO_DISTANCE ? enough : NO_DISTANCE) ||
            piece.depth >= TD_PIECE_DEPTH) {
            upper = td_max_double(upper, of_piece.upper);
            continue;
        }
        td_cover_piece parts[3];
        int made = cut(&piece, from, &to[piece.nearest], parts);
        for (int i = 0; i < made; i++) {
            if (parts[i].count == 1 || parts[i].count == 2) {
                continue; /* a degenerate part, from rounding of a cut at a corner: the other part
                             covers it */
            }
            parts[i].depth = piece.depth + 1;
            parts[i].nearest = piece.nearest;
            stack[height++] = parts[i];
        }
        precision = done % PIECES == 0 ? 2.0 * precision : precision;
    }
    return upper;
}
