/* minkowski.c: Minkowski sums of circles and boxes.
 *
 * A box is the Minkowski sum of two segments, its axes. The sum of two boxes is the sum of four
 * segments: a polygon of eight edges, which are these segments in the order of their angles, each
 * twice, on opposite sides. Adding a circle grows it by the radius. Normals and offsets of the
 * faces are computed from the axes of the boxes, not from differences of vertices, which are
 * imprecise for short edges. */
#include "geometry/minkowski.h"

/* The first axis of a box, normalised by a Newton step for the inverse square root.
 * thud_geometry_check allows an error of 1e-5, which the step reduces to about 1e-10. */
static thud_pos axis_of(const thud_geometry *box) {
    double scale = 1.5 - 0.5 * (box->c * box->c + box->s * box->s);
    return (thud_pos){box->c * scale, box->s * scale};
}

/* Sets the sum of `count` segments, from -half to half along each axis; the axes are in the order
 * of their angles. */
static void set_segments(thud_minkowski *sum, int count, const thud_pos *axes,
                         const double *halves) {
    double x = 0.0, y = 0.0;
    sum->count = 2 * count;
    sum->radius = 0.0;
    for (int i = 0; i < count; i++) {
        x -= halves[i] * axes[i].x;
        y -= halves[i] * axes[i].y;
    }
    for (int i = 0; i < count; i++) {
        sum->vertices[i] = (thud_pos){x, y};
        sum->vertices[i + count] = (thud_pos){-x, -y};
        x += 2.0 * halves[i] * axes[i].x;
        y += 2.0 * halves[i] * axes[i].y;
        sum->normals[i] = (thud_pos){axes[i].y, -axes[i].x};
        sum->offsets[i] = 0.0;
        for (int j = 0; j < count; j++) {
            double projection = axes[i].y * axes[j].x - axes[i].x * axes[j].y;
            sum->offsets[i] += halves[j] * td_abs(projection);
        }
    }
}

/* Sets the sum of the two segments of one box, whose first axis is e. Without loops, since casts of
 * rays call it often. */
static void set_box(thud_minkowski *sum, thud_pos e, double hx, double hy) {
    double ux = hx * e.x, uy = hx * e.y, vx = -hy * e.y, vy = hy * e.x;
    sum->count = 4;
    sum->radius = 0.0;
    sum->vertices[0] = (thud_pos){-ux - vx, -uy - vy};
    sum->vertices[1] = (thud_pos){ux - vx, uy - vy};
    sum->vertices[2] = (thud_pos){ux + vx, uy + vy};
    sum->vertices[3] = (thud_pos){vx - ux, vy - uy};
    sum->normals[0] = (thud_pos){e.y, -e.x};
    sum->normals[1] = e;
    sum->offsets[0] = hy;
    sum->offsets[1] = hx;
}

/* The sum of two boxes: a box if they are parallel, otherwise an octagon. */
static void set_boxes(thud_minkowski *sum, const thud_geometry *a, const thud_geometry *b) {
    if (!td_kind_turns(a->kind) && !td_kind_turns(b->kind)) {
        set_box(sum, (thud_pos){1.0, 0.0}, a->hx + b->hx, a->hy + b->hy);
        return;
    }
    thud_pos e = axis_of(a), f = axis_of(b);
    double fhx = b->hx, fhy = b->hy;
    double c = e.x * f.x + e.y * f.y, s = e.x * f.y - e.y * f.x;
    /* A box that is rotated by 90 degrees is the same box with its extents exchanged: rotates f by
     * such steps until it is less than 90 degrees from e. */
    for (int quarter = 0; quarter < 3 && !(c > 0.0 && s >= 0.0); quarter++) {
        double old_c = c, old_hx = fhx;
        f = (thud_pos){-f.y, f.x};
        c = -s;
        s = old_c;
        fhx = fhy;
        fhy = old_hx;
    }
    if (s > 0.0) {
        set_segments(sum, 4, (thud_pos[]){e, f, {-e.y, e.x}, {-f.y, f.x}},
                     (double[]){a->hx, fhx, a->hy, fhy});
    } else {
        set_box(sum, e, a->hx + fhx, a->hy + fhy);
    }
}

void td_minkowski_of(const thud_geometry *shape, thud_minkowski *sum) {
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        sum->count = 1;
        sum->vertices[0] = (thud_pos){0.0, 0.0};
        sum->radius = shape->hx;
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN: /* never called for one */
        set_box(sum, axis_of(shape), shape->hx, shape->hy);
        break;
    }
}

void td_minkowski_sum(const thud_geometry *a, const thud_geometry *b, thud_minkowski *sum) {
    if (td_kind_is_round(b->kind)) {
        td_minkowski_of(a, sum);
        sum->radius += b->hx;
    } else if (td_kind_is_round(a->kind)) {
        td_minkowski_of(b, sum);
        sum->radius += a->hx;
    } else {
        set_boxes(sum, a, b);
    }
}

static double dot(thud_pos v, double x, double y) {
    return v.x * x + v.y * y;
}

/* Of a face and its opposite, takes the one that faces the point, and returns where the point's
 * projection lies on its line: -1 before the face's first vertex, 1 beyond its second, 0 on the
 * face. */
static int beyond_face(const thud_minkowski *sum, int face, double x, double y) {
    thud_pos normal = sum->normals[face], from = sum->vertices[face], to = sum->vertices[face + 1];
    thud_pos tangent = {-normal.y, normal.x};
    double at = dot(normal, x, y) < 0.0 ? -dot(tangent, x, y) : dot(tangent, x, y);
    return at < dot(tangent, from.x, from.y) ? -1 : at > dot(tangent, to.x, to.y) ? 1 : 0;
}

/* The face from whose line the point has the greatest signed distance, *out; TD_NONE if the polygon
 * has no faces. For a point that projects onto a face from outside, it is that face. */
static int nearest_face(const thud_minkowski *sum, double x, double y, double *out) {
    int face = TD_NONE;
    *out = -1e300;
    for (int i = 0; i < sum->count / 2; i++) {
        double over = td_abs(dot(sum->normals[i], x, y)) - sum->offsets[i];
        if (over > *out) {
            *out = over;
            face = i;
        }
    }
    return face;
}

static int nearest_vertex(const thud_minkowski *sum, double x, double y) {
    double best = 1e300;
    int nearest = 0;
    for (int i = 0; i < sum->count; i++) {
        double dx = x - sum->vertices[i].x, dy = y - sum->vertices[i].y;
        double square = dx * dx + dy * dy;
        if (square < best) {
            best = square;
            nearest = i;
        }
    }
    return nearest;
}

/* The distance of a point from a vertex, and the direction from the vertex to the point. */
static double from_vertex(thud_pos vertex, double x, double y, double *nx, double *ny) {
    double dx = x - vertex.x, dy = y - vertex.y, length = __builtin_sqrt(dx * dx + dy * dy);
    *nx = length > 0.0 ? dx / length : 0.0;
    *ny = length > 0.0 ? dy / length : 1.0;
    return length;
}

/* The separation of a point and the polygon along the unit vector (nx, ny). */
static double gap_along(const thud_minkowski *sum, double nx, double ny, double x, double y) {
    double gap = 1e300;
    for (int i = 0; i < sum->count; i++) {
        double here = nx * (x - sum->vertices[i].x) + ny * (y - sum->vertices[i].y);
        gap = here < gap ? here : gap;
    }
    return gap;
}

double td_minkowski_distance(const thud_minkowski *sum, double x, double y, double *nx,
                             double *ny) {
    double out;
    int face = nearest_face(sum, x, y, &out);
    if (face == TD_NONE || (out > 0.0 && beyond_face(sum, face, x, y) != 0)) {
        thud_pos vertex = sum->vertices[nearest_vertex(sum, x, y)];
        double length = from_vertex(vertex, x, y, nx, ny);
        /* If the point nearly touches a vertex, the direction from the vertex is only rounding
         * error, and may even point into the sum. It is used only if it separates the two as well
         * as the face's normal does. */
        if (face == TD_NONE || gap_along(sum, *nx, *ny, x, y) >= out) {
            return length - sum->radius;
        }
    }
    double side = dot(sum->normals[face], x, y) < 0.0 ? -1.0 : 1.0;
    *nx = side * sum->normals[face].x;
    *ny = side * sum->normals[face].y;
    return out - sum->radius;
}

bool td_minkowski_contains(const thud_minkowski *sum, double x, double y) {
    double nx, ny;
    if (sum->count == 1) {
        return x * x + y * y <= sum->radius * sum->radius;
    }
    /* An edge too short to have a direction gives a distance that is NaN, so that this is false. */
    return td_minkowski_distance(sum, x, y, &nx, &ny) <= 0.0;
}

/* Clipping of the path against the faces, grown by the radius (Cyrus and Beck, "Generalized two-
 * and three-dimensional clipping", 1978): among the faces of which the point starts outside, it
 * enters through the one that it crosses last, if it is then inside of all other faces. The grown
 * polygon has sharp corners where the rounded sum has arcs: if the point enters at a corner, beyond
 * the end of the face, it is tested against the circle about the vertex instead. */
bool td_minkowski_enter(const thud_minkowski *sum, double x, double y, double dx, double dy,
                        double *fraction, double *nx, double *ny) {
    if (sum->count == 1) {
        return td_circle_enter(sum->vertices[0], sum->radius, x, y, dx, dy, fraction, nx, ny);
    }
    int faces = sum->count / 2, face = TD_NONE;
    double at[THUD_MINKOWSKI_VERTICES_MAX / 2], rate[THUD_MINKOWSKI_VERTICES_MAX / 2], enter = 0.0,
                                                                                       side = 1.0;
    for (int i = 0; i < faces; i++) {
        at[i] = dot(sum->normals[i], x, y);
        rate[i] = dot(sum->normals[i], dx, dy);
        double sign = at[i] < 0.0 ? -1.0 : 1.0;
        double over = sign * at[i] - (sum->offsets[i] + sum->radius), closing = -sign * rate[i];
        if (over < 0.0 || (over == 0.0 && closing == 0.0)) {
            continue;
        }
        if (!(closing > 0.0 && over <= closing)) {
            return false;
        }
        double time = over / closing;
        if (face == TD_NONE || time > enter) {
            enter = time;
            face = i;
            side = sign;
        }
    }
    if (face == TD_NONE) {
        if (sum->radius == 0.0) {
            return false;
        }
        thud_pos vertex = sum->vertices[nearest_vertex(sum, x, y)];
        return td_circle_enter(vertex, sum->radius, x, y, dx, dy, fraction, nx, ny);
    }
    /* Only faces towards which the point moves are tested: a face that is almost parallel to the
     * one through which it enters must not reject it because of a rounding error. */
    for (int i = 0; i < faces; i++) {
        double there = at[i] + enter * rate[i];
        if (i != face && (rate[i] < 0.0 ? -there : there) > sum->offsets[i] + sum->radius) {
            return false;
        }
    }
    double px = x + enter * dx, py = y + enter * dy, u, v;
    int corner = sum->radius > 0.0 ? beyond_face(sum, face, px, py) : 0;
    /* Of two almost parallel faces, rounding may have chosen the one beyond whose end the point is,
     * although it enters the rounded sum through the other. */
    double rounding = 1e-15 * (td_abs(px) + td_abs(py) + td_abs(x) + td_abs(y));
    if (corner != 0 && td_minkowski_distance(sum, px, py, &u, &v) > rounding) {
        int vertex = face + (corner > 0) + (side < 0.0 ? faces : 0);
        return td_circle_enter(sum->vertices[vertex % sum->count], sum->radius, x, y, dx, dy,
                               fraction, nx, ny);
    }
    *fraction = enter;
    *nx = side * sum->normals[face].x;
    *ny = side * sum->normals[face].y;
    return true;
}

/* ---- public functions ---- */

static bool in_range(double x, double y) {
    return td_abs(x) <= THUD_VOLUME_MAX && td_abs(y) <= THUD_VOLUME_MAX;
}

/* Whether a caller's sum can be read without an access out of bounds. */
static bool readable(const thud_minkowski *sum) {
    return (sum->count == 1 || sum->count == 4 || sum->count == 8) && sum->radius >= 0.0 &&
           sum->radius <= THUD_VOLUME_MAX;
}

thud_result thud_minkowski_sum(const thud_geometry *a, const thud_geometry *b,
                               thud_minkowski *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    *out = (thud_minkowski){0};
    td_minkowski_sum(a, b, out);
    return THUD_OK;
}

thud_result thud_minkowski_contains(const thud_minkowski *sum, double x, double y,
                                    bool *out_inside) {
    if (!sum || !out_inside) {
        return THUD_ERROR_NULL;
    }
    if (!readable(sum) || !in_range(x, y)) {
        return THUD_ERROR_INVALID;
    }
    *out_inside = td_minkowski_contains(sum, x, y);
    return THUD_OK;
}

thud_result thud_minkowski_distance(const thud_minkowski *sum, double x, double y,
                                    double *out_distance, double *out_nx, double *out_ny) {
    if (!sum || !out_distance || !out_nx || !out_ny) {
        return THUD_ERROR_NULL;
    }
    if (!readable(sum) || !in_range(x, y)) {
        return THUD_ERROR_INVALID;
    }
    *out_distance = td_minkowski_distance(sum, x, y, out_nx, out_ny);
    return THUD_OK;
}

thud_result thud_minkowski_cast(const thud_minkowski *sum, thud_segment path, bool *out_hit,
                                double *out_fraction, double *out_nx, double *out_ny) {
    if (!sum || !out_hit || !out_fraction || !out_nx || !out_ny) {
        return THUD_ERROR_NULL;
    }
    if (!readable(sum) || !in_range(path.x, path.y) || !in_range(path.dx, path.dy)) {
        return THUD_ERROR_INVALID;
    }
    *out_fraction = 1.0;
    *out_nx = 0.0;
    *out_ny = 0.0;
    *out_hit = td_minkowski_contains(sum, path.x, path.y);
    if (*out_hit) {
        *out_fraction = 0.0;
        td_minkowski_distance(sum, path.x, path.y, out_nx, out_ny);
    } else {
        *out_hit =
            td_minkowski_enter(sum, path.x, path.y, path.dx, path.dy, out_fraction, out_nx, out_ny);
    }
    return THUD_OK;
}
