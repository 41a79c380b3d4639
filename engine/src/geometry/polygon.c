/* polygon.c: checks that points form a simple polygon, and cuts it into triangles by ear clipping
 * (G. Meisters, Polygons have ears, 1975): a corner whose triangle contains no other point is cut
 * off, until a triangle is left. */
#include "geometry/polygon.h"

#include "thud/thud_approximate.h"

double td_polygon_area(const thud_pos *points, int count) {
    double twice = 0.0;
    for (int i = 2; i < count; i++) {
        twice += td_turn_of(points[0], points[i - 1], points[i]);
    }
    return 0.5 * twice;
}

/* Whether q, on the line through a and b, is between them. */
static bool between(thud_pos a, thud_pos b, thud_pos q) {
    return (q.x - a.x) * (q.x - b.x) <= 0.0 && (q.y - a.y) * (q.y - b.y) <= 0.0;
}

/* Whether the segments from a to b and from p to q share a point. */
static bool segments_touch(thud_pos a, thud_pos b, thud_pos p, thud_pos q) {
    double ap = td_turn_of(a, b, p), aq = td_turn_of(a, b, q);
    double pa = td_turn_of(p, q, a), pb = td_turn_of(p, q, b);
    if (((ap > 0.0 && aq < 0.0) || (ap < 0.0 && aq > 0.0)) &&
        ((pa > 0.0 && pb < 0.0) || (pa < 0.0 && pb > 0.0))) {
        return true;
    }
    return (ap == 0.0 && between(a, b, p)) || (aq == 0.0 && between(a, b, q)) ||
           (pa == 0.0 && between(p, q, a)) || (pb == 0.0 && between(p, q, b));
}

/* Whether the edges that begin at points i and j share any point other than a common end of
 * consecutive edges. */
static bool edges_meet(const thud_pos *points, int count, int i, int j) {
    thud_pos a = points[i], b = points[(i + 1) % count], p = points[j], q = points[(j + 1) % count];
    if (j == i + 1) {
        return td_turn_of(a, b, q) == 0.0 &&
               (b.x - a.x) * (q.x - b.x) + (b.y - a.y) * (q.y - b.y) <= 0.0;
    }
    if ((j + 1) % count == i) {
        return td_turn_of(p, q, b) == 0.0 &&
               (q.x - p.x) * (b.x - q.x) + (q.y - p.y) * (b.y - q.y) <= 0.0;
    }
    return segments_touch(a, b, p, q);
}

/* The reason why points do not form a valid polygon, or null. */
static const char *polygon_error(const thud_pos *points, int count) {
    if (count < 3 || count > THUD_POLYGON_POINTS_MAX) {
        return "a polygon has too few or too many points";
    }
    thud_pos low = points[0], high = low;
    for (int i = 0; i < count; i++) {
        if (!(td_abs(points[i].x) <= THUD_POLYGON_PLACE_MAX &&
              td_abs(points[i].y) <= THUD_POLYGON_PLACE_MAX)) {
            return "a point of a polygon is not finite or out of range";
        }
        low.x = points[i].x < low.x ? points[i].x : low.x;
        low.y = points[i].y < low.y ? points[i].y : low.y;
        high.x = points[i].x > high.x ? points[i].x : high.x;
        high.y = points[i].y > high.y ? points[i].y : high.y;
    }
    for (int i = 0; i < count; i++) {
        for (int j = i + 1; j < count; j++) {
            if (edges_meet(points, count, i, j)) {
                return "edges of a polygon cross or touch each other";
            }
        }
    }
    double extent = td_max_double(high.x - low.x, high.y - low.y);
    double area = td_abs(td_polygon_area(points, count));
    return area >= THUD_POLYGON_AREA_MIN * extent * extent ? NULL : "a polygon has no area";
}

thud_result thud_polygon_check(const thud_pos *points, int count, const char **out_reason) {
    const char *reason = points ? polygon_error(points, count) : "the points are null";
    if (out_reason) {
        *out_reason = reason;
    }
    return !points ? THUD_ERROR_NULL : reason ? THUD_ERROR_INVALID : THUD_OK;
}

/* ---- triangles ---- */

/* Whether corner i of the `count` remaining ones, `left`, may be cut off. `closed`: other points
 * may not lie on the triangle's edges either. */
static bool is_ear(const thud_pos *points, const int *left, int count, int i, bool closed) {
    thud_pos a = points[left[(i + count - 1) % count]], b = points[left[i]],
             c = points[left[(i + 1) % count]];
    if (!(td_turn_of(a, b, c) > 0.0)) {
        return false;
    }
    for (int k = 2; k < count - 1; k++) {
        thud_pos p = points[left[(i + k) % count]];
        double ab = td_turn_of(a, b, p), bc = td_turn_of(b, c, p), ca = td_turn_of(c, a, p);
        if (closed ? ab >= 0.0 && bc >= 0.0 && ca >= 0.0 : ab > 0.0 && bc > 0.0 && ca > 0.0) {
            return false;
        }
    }
    return true;
}

/* The corner to cut off next. If rounding leaves no ear, it is any convex corner, or else the
 * first. */
static int next_ear(const thud_pos *points, const int *left, int count) {
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < count; i++) {
            if (is_ear(points, left, count, i, pass == 0)) {
                return i;
            }
        }
    }
    for (int i = 0; i < count; i++) {
        if (td_turn_of(points[left[(i + count - 1) % count]], points[left[i]],
                       points[left[(i + 1) % count]]) > 0.0) {
            return i;
        }
    }
    return 0;
}

int td_polygon_triangles(const thud_pos *points, int count, int *left, int (*triangles)[3]) {
    int made = 0;
    for (int i = 0; i < count; i++) {
        left[i] = i;
    }
    while (count > 2) {
        int cut = count > 3 ? next_ear(points, left, count) : 1;
        int a = left[(cut + count - 1) % count], b = left[cut], c = left[(cut + 1) % count];
        if (td_turn_of(points[a], points[b], points[c]) > 0.0) {
            triangles[made][0] = a;
            triangles[made][1] = b;
            triangles[made][2] = c;
            made++;
        }
        count--;
        for (int i = cut; i < count; i++) {
            left[i] = left[i + 1];
        }
    }
    return made;
}
