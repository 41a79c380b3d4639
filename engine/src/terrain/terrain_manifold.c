/* terrain_manifold.c: see terrain_manifold.h.
 *
 * The plane is divided into the Voronoi regions of the line's features, and each feature belongs to
 * one segment, so that each point of the plane has one owner:
 * - Above the line, the points that project onto a segment belong to the segment, and those in the
 *   wedge between the normals of two segments at a ridge belong to the vertex. A vertex belongs to
 *   the segment on its right, the last vertex to the last segment.
 * - In the ground, a point belongs to the segment through which it is nearest to the surface.
 * - The ground's vertical sides are treated as one more segment at each end, and reported by the
 *   first and last segment. Only a shape whose centre is beyond the end of the line can overlap
 * them; a corner of any box may be within the margin of them.
 *
 * A circle touches the owner of its centre. A box touches the segment with each corner that the
 * segment owns or that overlaps it in a valley; with fewer than two such points, also with a ridge
 * vertex that the segment owns and that is inside a face of the box; and if no point overlaps, with
 * the box's centre. */
#include "terrain/terrain_manifold.h"

#include "terrain/terrain.h"

/* Results of owner_of that are not segments; the right side is count - 1. */
enum { ABOVE_GROUND = -2, LEFT_SIDE = -1 };

/* Two segments form a ridge for a box, or a valley, if the sine of the angle between them is at
 * least this. Larger than rounding errors; chosen, not tuned. */
#define RIDGE_SINE_MIN 1e-9

/* The arguments of td_terrain_segment_manifold, and values derived from them. */
typedef struct query {
    const thud_terrain *terrain;
    const thud_geometry *shape;
    int segment;
    bool endless, first, last; /* endless: a flat line; first, last: the segment's left or right end
                                  is an end of the line with an open side */
    td_segment s;
    bool open_left,
        open_right; /* the line ends at this side, and no neighbour covers that end (`sealed` has no
                       bit for it), so that shapes may touch its vertical side */
    double margin;
} query;

static query query_of(const thud_terrain *t, int segment, const thud_geometry *shape,
                      unsigned sealed, double margin) {
    bool left = !(sealed & TD_SEALED_LEFT), right = !(sealed & TD_SEALED_RIGHT);
    /* Half the width of the piece that represents a flat line: wider than the shape. */
    double reach = 2.0 * td_reach(shape) + 1.0;
    bool endless = t->kind == THUD_TERRAIN_FLAT;
    return (query){.terrain = t,
                   .shape = shape,
                   .segment = segment,
                   .endless = endless,
                   .open_left = left,
                   .open_right = right,
                   .first = !endless && segment == 0 && left,
                   .last = !endless && segment == t->count - 2 && right,
                   .s = td_terrain_segment(t, segment, shape->x - reach, shape->x + reach),
                   .margin = margin};
}

/* A vertex of the segment with the unit tangents of the ground before and after it. */
typedef struct vertex {
    thud_pos at;
    double before_x, before_y, after_x, after_y;
} vertex;

/* The sine of the angle by which the line turns downwards at a vertex: positive on a ridge,
 * negative in a valley. */
static double ridge_of(const vertex *v) {
    return v->before_y * v->after_x - v->before_x * v->after_y;
}

/* The vertex at the segment's left or right end. */
static vertex vertex_of(const query *k, bool right) {
    const td_segment *s = &k->s;
    if (right) { /* at the right end of a segment it is called for the last one only, where the
                    vertical side comes next */
        return (vertex){s->q, s->tx, s->ty, 0.0, -1.0};
    }
    if (k->first) {
        return (vertex){s->p, 0.0, 1.0, s->tx, s->ty};
    }
    if (k->segment == 0) { /* the end is sealed: the tangent continues */
        return (vertex){s->p, s->tx, s->ty, s->tx, s->ty};
    }
    td_segment before = td_terrain_segment(k->terrain, k->segment - 1, 0.0, 0.0);
    return (vertex){s->p, before.tx, before.ty, s->tx, s->ty};
}

/* The distance of a point from a segment. */
static double distance_to(const td_segment *s, double x, double y) {
    double along = td_clamp(td_along(s->tx, s->ty, s->p, x, y), 0.0, s->length);
    double dx = x - (s->p.x + along * s->tx), dy = y - (s->p.y + along * s->ty);
    return __builtin_sqrt(dx * dx + dy * dy);
}

/* The segment, or LEFT_SIDE or count - 1 for the vertical sides, through which a point in the
 * ground is nearest to the surface; ABOVE_GROUND for a point above the line or beyond its ends.
 * Only the segments that the shape's bounds touch are searched, since only those report contacts of
 * this shape. */
static int owner_of(const query *k, double x, double y) {
    const thud_terrain *t = k->terrain;
    if (k->endless) {
        return td_above(&k->s, x, y) < 0.0 ? 0 : ABOVE_GROUND;
    }
    double left = td_terrain_x(t, 0), right = td_terrain_x(t, t->count - 1);
    if (x < left || x > right) {
        return ABOVE_GROUND;
    }
    int owner = td_terrain_segment_at(t, x), column = owner, first, last;
    td_segment s = td_terrain_segment(t, owner, 0.0, 0.0);
    if (td_above(&s, x, y) >= 0.0) {
        return ABOVE_GROUND;
    }
    double nearest = distance_to(&s, x, y), half = td_half_width(k->shape);
    thud_terrain_segments(t, k->shape->x - half, k->shape->x + half, &first, &last);
    for (int i = column - 1; i >= first && x - s.p.x < nearest; i--) {
        s = td_terrain_segment(t, i, 0.0, 0.0);
        double distance = distance_to(&s, x, y);
        if (distance < nearest) {
            nearest = distance;
            owner = i;
        }
    }
    s = td_terrain_segment(t, column, 0.0, 0.0);
    for (int i = column + 1; i <= last && s.q.x - x < nearest; i++) {
        s = td_terrain_segment(t, i, 0.0, 0.0);
        double distance = distance_to(&s, x, y);
        if (distance < nearest) {
            nearest = distance;
            owner = i;
        }
    }
    if (k->open_left && k->shape->x < left && x - left < nearest) {
        nearest = x - left;
        owner = LEFT_SIDE;
    }
    return k->open_right && k->shape->x > right && right - x < nearest ? t->count - 1 : owner;
}

/* Whether a point above the ground projects onto the segment. A point exactly over the segment's
 * left vertex projects onto it; one over the right vertex does not. */
static bool foot_within(const query *k, double x, double y) {
    const td_segment *s = &k->s;
    return k->endless ||
           (td_along(s->tx, s->ty, s->p, x, y) >= 0.0 && td_along(s->tx, s->ty, s->q, x, y) < 0.0);
}

/* ---- circle ---- */

/* Stores the circle's contact with this normal and distance of its centre in *out, if it is within
 * the margin and deeper than the present one. */
static void keep_deeper(td_terrain_manifold *out, const query *k, double nx, double ny,
                        double distance) {
    double separation = distance - k->shape->hx, reach = -(k->shape->hx + 0.5 * separation);
    if (separation <= k->margin && (!out->count || separation < out->point[0].separation)) {
        *out = (td_terrain_manifold){nx, ny, 1, {{nx * reach, ny * reach, separation, 0}}};
    }
}

/* The circle against a vertex of the segment, if its centre is in the wedge over the vertex: beyond
 * the end of the segment before, and before the start of the segment after. */
static void try_vertex(td_terrain_manifold *out, const query *k, bool right) {
    double x = k->shape->x, y = k->shape->y;
    vertex v = vertex_of(k, right);
    double dx = x - v.at.x, dy = y - v.at.y, distance = __builtin_sqrt(dx * dx + dy * dy);
    if (distance > 0.0 && ridge_of(&v) > 0.0 &&
        td_along(v.before_x, v.before_y, v.at, x, y) >= 0.0 &&
        td_along(v.after_x, v.after_y, v.at, x, y) < 0.0) {
        keep_deeper(out, k, dx / distance, dy / distance, distance);
    }
}

/* The manifold of a circle. */
static void circle(const query *k, td_terrain_manifold *out) {
    const td_segment *s = &k->s;
    double x = k->shape->x, y = k->shape->y, above = td_above(s, x, y);
    int owner = owner_of(k, x, y);
    if (owner == k->segment || (owner == ABOVE_GROUND && above >= 0.0 && foot_within(k, x, y))) {
        keep_deeper(out, k, -s->ty, s->tx, above);
    }
    if (owner != ABOVE_GROUND || k->endless) {
        return;
    }
    if (td_along(s->tx, s->ty, s->p, x, y) < 0.0) {
        try_vertex(out, k, false);
    }
    if (k->last) {
        try_vertex(out, k, true);
    }
    if (k->first && x < s->p.x && y < s->p.y) {
        keep_deeper(out, k, -1.0, 0.0, s->p.x - x);
    }
    if (k->last && x > s->q.x && y <= s->q.y) {
        keep_deeper(out, k, 1.0, 0.0, x - s->q.x);
    }
}

/* ---- box ---- */

/* Adds a contact point: the ground's surface is at (x, y), and the box's `separation` from there
 * along the normal. Of more than two points the two deepest are kept, ordered along the ground. */
static void add_point(td_terrain_manifold *out, const query *k, double x, double y,
                      double separation, uint32_t id) {
    td_terrain_point point = {x - k->shape->x + 0.5 * separation * out->nx,
                              y - k->shape->y + 0.5 * separation * out->ny, separation, id};
    if (out->count < 2) {
        out->point[out->count++] = point;
    } else {
        int higher = out->point[1].separation > out->point[0].separation;
        if (point.separation < out->point[higher].separation) {
            out->point[higher] = point;
        }
    }
    if (out->count == 2) {
        td_terrain_point a = out->point[0], b = out->point[1];
        if ((b.px - a.px) * out->ny - (b.py - a.py) * out->nx < 0.0) {
            out->point[0] = b;
            out->point[1] = a;
        }
    }
}

/* Whether a corner of the box that the neighbouring segment `owner` owns also has a contact with
 * this segment, as in a valley, where the corner overlaps both slopes. It has one if its foot on
 * this segment's line is on the segment, or beyond the valley's vertex by at most four times the
 * corner's depth below the other segment. A corner straight below the vertex of a valley with
 * slopes of 75 degrees is beyond it by tan 75 degrees = 3.7 times that depth. */
static bool in_valley(const query *k, int owner, double x, double y) {
    if (k->endless || owner < 0 || owner > k->terrain->count - 2 ||
        (owner != k->segment - 1 && owner != k->segment + 1)) {
        return false;
    }
    td_segment other = td_terrain_segment(k->terrain, owner, 0.0, 0.0);
    const td_segment *s = &k->s;
    bool left = owner < k->segment;
    double turn = s->tx * other.ty - s->ty * other.tx;
    double past_p = -td_along(s->tx, s->ty, s->p, x, y);
    double past_q = td_along(s->tx, s->ty, s->q, x, y);
    double slack = -4.0 * td_above(&other, x, y);
    return (left ? -turn : turn) > RIDGE_SINE_MIN && (left ? past_p : past_q) <= slack &&
           (left ? past_q : past_p) <= 0.0;
}

/* Adds the contact points of the box's corners with the segment. */
static void corners_on_segment(const query *k, td_terrain_manifold *out) {
    const td_segment *s = &k->s;
    out->nx = -s->ty;
    out->ny = s->tx;
    for (uint32_t i = 0; i < 4; i++) {
        double x, y;
        td_corner(k->shape, (int)i, &x, &y);
        double above = td_above(s, x, y);
        if (above > k->margin) {
            continue;
        }
        int owner = owner_of(k, x, y);
        if (owner == k->segment || in_valley(k, owner, x, y) ||
            (owner == ABOVE_GROUND && above >= 0.0 && foot_within(k, x, y))) {
            add_point(out, k, x - above * out->nx, y - above * out->ny, above, i);
        }
    }
}

/* Adds the contact points of the box's corners with the vertical side under an end of the line. */
static void corners_on_side(const query *k, int side, td_terrain_manifold *out) {
    thud_pos end = side == LEFT_SIDE ? k->s.p : k->s.q;
    out->nx = side == LEFT_SIDE ? -1.0 : 1.0;
    out->ny = 0.0;
    for (uint32_t i = 0; i < 4; i++) {
        double x, y;
        td_corner(k->shape, (int)i, &x, &y);
        double beyond = (x - end.x) * out->nx;
        if (beyond > k->margin) {
            continue;
        }
        int owner = owner_of(k, x, y);
        if (owner == side || (owner == ABOVE_GROUND && beyond >= 0.0 && y < end.y)) {
            add_point(out, k, end.x, y, beyond, i);
        }
    }
}

/* A box's four faces (normal i at i * 90 degrees) and the separation of a vertex from each. */
typedef struct faces {
    double nx[4], ny[4], separation[4];
} faces;

/* The faces of a box about the vertex v. */
static faces faces_around(const thud_geometry *box, thud_pos v) {
    faces f;
    double u, w;
    td_to_frame(box, v.x - box->x, v.y - box->y, &u, &w);
    for (int i = 0; i < 4; i++) {
        double fu = i == 0 ? 1.0 : i == 2 ? -1.0 : 0.0, fw = i == 1 ? 1.0 : i == 3 ? -1.0 : 0.0;
        td_from_frame(box, fu, fw, &f.nx[i], &f.ny[i]);
        f.separation[i] = i % 2 ? fw * w - box->hy : fu * u - box->hx;
    }
    return f;
}

/* The separation of a vertex from the box's surface along the unit normal (nx, ny), out of the
 * ground: the distance by which the box must move against the normal until the vertex is on the
 * box's surface. Only faces that face the ground are used: the cosine between a face's normal and
 * the negated normal is above 0.001. */
static double separation_along(const faces *f, double nx, double ny) {
    double best = -1e300;
    for (int i = 0; i < 4; i++) {
        double facing = -(f->nx[i] * nx + f->ny[i] * ny);
        if (facing > 1e-3 && f->separation[i] > best * facing) {
            best = f->separation[i] / facing;
        }
    }
    return best;
}

/* Adds the contact of a ridge vertex inside a face of the box. If the manifold has no point yet,
 * the normal is opposite to that of the face of least penetration among the faces that point into
 * the ground, clamped to the wedge between the normals of the two segments; otherwise the
 * manifold's normal is kept. */
static void add_vertex(const query *k, bool right, td_terrain_manifold *out) {
    if (td_abs((right ? k->s.q.x : k->s.p.x) - k->shape->x) > td_half_width(k->shape) + k->margin) {
        return;
    }
    vertex v = vertex_of(k, right);
    double ax = v.before_x, ay = v.before_y, bx = v.after_x, by = v.after_y;
    if (ridge_of(&v) < RIDGE_SINE_MIN) {
        return;
    }
    faces f = faces_around(k->shape, v.at);
    /* The sum of both segments' normals points out of the ridge, however sharp it is. */
    double rx = -ay - by, ry = ax + bx, length = __builtin_sqrt(rx * rx + ry * ry);
    double best = -1e300, nx = 0.0, ny = 1.0;
    int outside = 0;
    for (int i = 0; i < 4; i++) {
        outside += f.separation[i] > 0.0;
        /* Cosine below -0.001: faces that are nearly perpendicular to the ridge's normal are left
         * out. */
        bool into_ground = f.nx[i] * rx + f.ny[i] * ry < -1e-3 * length;
        if (into_ground && f.separation[i] > best) {
            best = f.separation[i];
            nx = -f.nx[i];
            ny = -f.ny[i];
        } else if (!into_ground && f.separation[i] > 0.0) {
            return;
        }
    }
    if (outside > 1) {
        return;
    }
    if (out->count) {
        nx = out->nx;
        ny = out->ny;
    } else if (nx * ax + ny * ay < 0.0 || nx * bx + ny * by > 0.0) {
        /* The normal is outside of the wedge: use the nearer side of the wedge. */
        bool before = ny * ax - nx * ay > ny * bx - nx * by;
        nx = before ? -ay : -by;
        ny = before ? ax : bx;
    }
    double separation = separation_along(&f, nx, ny);
    if (separation <= k->margin) {
        out->nx = nx;
        out->ny = ny;
        add_point(out, k, v.at.x, v.at.y, separation, right ? 5 : 4);
    }
}

/* Replaces a manifold without an overlapping point by a contact of the box's centre, if that is in
 * the ground and owned by the segment: if a hill passes through a thin box, there may be neither a
 * corner in the ground nor a vertex in a face. */
static void add_centre(const query *k, td_terrain_manifold *out) {
    double x = k->shape->x, y = k->shape->y, above = td_above(&k->s, x, y);
    if (above < 0.0 && owner_of(k, x, y) == k->segment) {
        double nx = -k->s.ty, ny = k->s.tx;
        double separation = above - td_projected_extent(k->shape, nx, ny);
        *out = (td_terrain_manifold){.nx = nx, .ny = ny};
        add_point(out, k, x - above * nx, y - above * ny, separation, 6);
    }
}

/* The smallest separation of a manifold; 1e300 without points. */
static double deepest(const td_terrain_manifold *m) {
    double depth = m->count > 0 ? m->point[0].separation : 1e300;
    return m->count > 1 && m->point[1].separation < depth ? m->point[1].separation : depth;
}

/* The manifold of a box: the vertical side at an end of the line replaces the segment if its
 * contact is deeper. */
static void box(const query *k, td_terrain_manifold *out) {
    corners_on_segment(k, out);
    for (int end = 0; end < 2; end++) {
        if (end ? k->last : k->first) {
            td_terrain_manifold side = {0};
            corners_on_side(k, end ? k->segment + 1 : LEFT_SIDE, &side);
            if (deepest(&side) < deepest(out)) {
                *out = side;
            }
        }
    }
    if (!k->endless && out->count < 2) {
        add_vertex(k, false, out);
    }
    if (k->last && out->count < 2) {
        add_vertex(k, true, out);
    }
    if (deepest(out) >= 0.0) {
        add_centre(k, out);
    }
}

void td_terrain_segment_manifold(const thud_terrain *terrain, int segment,
                                 const thud_geometry *shape, unsigned sealed, double margin,
                                 td_terrain_manifold *out) {
    query k = query_of(terrain, segment, shape, sealed, margin);
    *out = (td_terrain_manifold){.ny = 1.0};
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        circle(&k, out);
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        box(&k, out);
        break;
    case THUD_SHAPE_TERRAIN: /* lines do not meet each other */
        break;
    }
}
