/* terrain_manifold.c: see terrain_manifold.h.
 *
 * Every point of the plane belongs to one feature of the line, and a feature to one segment. Above
 * the line, what projects onto a segment is the segment's, and the wedge over a ridge is its
 * vertex's. In the ground, a point belongs to the segment through which it is nearest to the
 * surface. A vertex is reported by the segment that it begins, the last one by the segment that it
 * ends. The ground's upright sides count as a segment before the first and one after the last, and
 * are reported by those; they are met only by shapes whose centre is beyond the end. */
#include "terrain/terrain_manifold.h"

#include "terrain/terrain.h"

enum { NOWHERE = -2, LEFT_SIDE = -1 }; /* the right side is count - 1 */

/* A ridge that rises less than this over its neighbours, in radians, is none for a box. */
#define STRAIGHT 1e-9

typedef struct place {
    const thud_terrain *terrain;
    const thud_shape_instance *shape;
    int segment;
    bool endless, first, last; /* the segment has an end of the line that can be met */
    td_segment s;
    bool open_left, open_right;
    double margin;
} place;

static place place_of(const thud_terrain *t, int segment, const thud_shape_instance *shape,
                      unsigned sealed, double margin) {
    bool left = !(sealed & TD_SEALED_LEFT), right = !(sealed & TD_SEALED_RIGHT);
    double reach = 2.0 * td_reach(shape) + 1.0;
    bool endless = t->kind == THUD_TERRAIN_FLAT;
    return (place){.terrain = t,
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

/* The sine of the angle by which the ground turns down: positive on a ridge. */
static double ridge_of(const vertex *v) {
    return v->before_y * v->after_x - v->before_x * v->after_y;
}

static vertex vertex_of(const place *k, bool right) {
    const td_segment *s = &k->s;
    if (right) { /* asked for the last segment alone: the ground goes straight down after it */
        return (vertex){s->q, s->tx, s->ty, 0.0, -1.0};
    }
    if (k->first) {
        return (vertex){s->p, 0.0, 1.0, s->tx, s->ty};
    }
    if (k->segment == 0) { /* sealed: the ground goes straight on */
        return (vertex){s->p, s->tx, s->ty, s->tx, s->ty};
    }
    td_segment before = td_terrain_segment(k->terrain, k->segment - 1, 0.0, 0.0);
    return (vertex){s->p, before.tx, before.ty, s->tx, s->ty};
}

static double distance_to(const td_segment *s, double x, double y) {
    double along = td_clamp(td_along(s->tx, s->ty, s->p, x, y), 0.0, s->length);
    double dx = x - (s->p.x + along * s->tx), dy = y - (s->p.y + along * s->ty);
    return __builtin_sqrt(dx * dx + dy * dy);
}

/* The segment or side through which a point is nearest to the surface; NOWHERE above the ground.
 * Only what the shape's bounds touch is searched: nobody asks about the rest. */
static int owner_of(const place *k, double x, double y) {
    const thud_terrain *t = k->terrain;
    if (k->endless) {
        return td_above(&k->s, x, y) < 0.0 ? 0 : NOWHERE;
    }
    double left = td_terrain_x(t, 0), right = td_terrain_x(t, t->count - 1);
    if (x < left || x > right) {
        return NOWHERE;
    }
    int owner = td_terrain_segment_at(t, x), column = owner, first, last;
    td_segment s = td_terrain_segment(t, owner, 0.0, 0.0);
    if (td_above(&s, x, y) >= 0.0) {
        return NOWHERE;
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

/* Does a point above the ground project onto the segment? A foot on a vertex that it shares with
 * the segment before is its own, one on a vertex shared with the next is not. */
static bool foot_within(const place *k, double x, double y) {
    const td_segment *s = &k->s;
    return k->endless ||
           (td_along(s->tx, s->ty, s->p, x, y) >= 0.0 && td_along(s->tx, s->ty, s->q, x, y) < 0.0);
}

/* ---- circle ---- */

static void offer(td_terrain_manifold *out, const place *k, double nx, double ny, double distance) {
    double separation = distance - k->shape->hx, reach = -(k->shape->hx + 0.5 * separation);
    if (separation <= k->margin && (!out->count || separation < out->point[0].separation)) {
        *out = (td_terrain_manifold){nx, ny, 1, {{nx * reach, ny * reach, separation, 0}}};
    }
}

/* The wedge over a vertex: past the end of what is before, short of the start of what is after. */
static void offer_vertex(td_terrain_manifold *out, const place *k, bool right) {
    double x = k->shape->x, y = k->shape->y;
    vertex v = vertex_of(k, right);
    double dx = x - v.at.x, dy = y - v.at.y, distance = __builtin_sqrt(dx * dx + dy * dy);
    if (distance > 0.0 && ridge_of(&v) > 0.0 &&
        td_along(v.before_x, v.before_y, v.at, x, y) >= 0.0 &&
        td_along(v.after_x, v.after_y, v.at, x, y) < 0.0) {
        offer(out, k, dx / distance, dy / distance, distance);
    }
}

static void circle(const place *k, td_terrain_manifold *out) {
    const td_segment *s = &k->s;
    double x = k->shape->x, y = k->shape->y, above = td_above(s, x, y);
    int owner = owner_of(k, x, y);
    if (owner == k->segment || (owner == NOWHERE && above >= 0.0 && foot_within(k, x, y))) {
        offer(out, k, -s->ty, s->tx, above);
    }
    if (owner != NOWHERE || k->endless) {
        return;
    }
    if (td_along(s->tx, s->ty, s->p, x, y) < 0.0) {
        offer_vertex(out, k, false);
    }
    if (k->last) {
        offer_vertex(out, k, true);
    }
    if (k->first && x < s->p.x && y < s->p.y) {
        offer(out, k, -1.0, 0.0, s->p.x - x);
    }
    if (k->last && x > s->q.x && y <= s->q.y) {
        offer(out, k, 1.0, 0.0, x - s->q.x);
    }
}

/* ---- box ---- */

/* Adds a point where the box's surface is `separation` along the normal from (x, y) of the
 * ground's surface; of more than two the deepest stay, in their order along the ground. */
static void add(td_terrain_manifold *out, const place *k, double x, double y, double separation,
                uint32_t id) {
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

/* A corner in the ground next to a valley is in the way of both its slopes. It is the neighbour's
 * if it would be in reach of this segment too, once it is out of its owner's; the foot may be as
 * far past the valley as a corner in a valley of 75 degrees to either side can be. */
static bool in_valley(const place *k, int owner, double x, double y) {
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
    return (left ? -turn : turn) > STRAIGHT && (left ? past_p : past_q) <= slack &&
           (left ? past_q : past_p) <= 0.0;
}

/* Corners that meet the segment itself. */
static void corners_on_segment(const place *k, td_terrain_manifold *out) {
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
            (owner == NOWHERE && above >= 0.0 && foot_within(k, x, y))) {
            add(out, k, x - above * out->nx, y - above * out->ny, above, i);
        }
    }
}

/* Corners that meet the upright side under an end of the line. */
static void corners_on_side(const place *k, int side, td_terrain_manifold *out) {
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
        if (owner == side || (owner == NOWHERE && beyond >= 0.0 && y < end.y)) {
            add(out, k, end.x, y, beyond, i);
        }
    }
}

/* The faces of the box around a vertex of the ground. */
typedef struct faces {
    double nx[4], ny[4], separation[4];
} faces;

static faces faces_around(const thud_shape_instance *box, thud_pos v) {
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

/* How far the box must move against the normal until the vertex is at its surface. */
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

/* A ridge in a face of the box. Without corners on the segment, the face of least penetration that
 * looks into the ground gives the normal, held within the wedge of the ridge. */
static void add_vertex(const place *k, bool right, td_terrain_manifold *out) {
    if (td_abs((right ? k->s.q.x : k->s.p.x) - k->shape->x) > td_half_width(k->shape) + k->margin) {
        return;
    }
    vertex v = vertex_of(k, right);
    double ax = v.before_x, ay = v.before_y, bx = v.after_x, by = v.after_y;
    if (ridge_of(&v) < STRAIGHT) {
        return;
    }
    faces f = faces_around(k->shape, v.at);
    /* The sum of the neighbours' normals is the ridge's own direction, however sharp it is. */
    double rx = -ay - by, ry = ax + bx, length = __builtin_sqrt(rx * rx + ry * ry);
    double best = -1e300, nx = 0.0, ny = 1.0;
    int outside = 0;
    for (int i = 0; i < 4; i++) {
        outside += f.separation[i] > 0.0;
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
        /* Out of the wedge: to its nearer side. */
        bool before = ny * ax - nx * ay > ny * bx - nx * by;
        nx = before ? -ay : -by;
        ny = before ? ax : bx;
    }
    double separation = separation_along(&f, nx, ny);
    if (separation <= k->margin) {
        out->nx = nx;
        out->ny = ny;
        add(out, k, v.at.x, v.at.y, separation, right ? 5 : 4);
    }
}

/* A plank run through by a hill has neither corner in the ground nor ridge in itself, but then its
 * centre is in the ground: out through the line. */
static void add_centre(const place *k, td_terrain_manifold *out) {
    double x = k->shape->x, y = k->shape->y, above = td_above(&k->s, x, y);
    if (above < 0.0 && owner_of(k, x, y) == k->segment) {
        double nx = -k->s.ty, ny = k->s.tx;
        double separation = above - td_projected_extent(k->shape, nx, ny);
        *out = (td_terrain_manifold){.nx = nx, .ny = ny};
        add(out, k, x - above * nx, y - above * ny, separation, 6);
    }
}

static double deepest(const td_terrain_manifold *m) {
    double depth = m->count > 0 ? m->point[0].separation : 1e300;
    return m->count > 1 && m->point[1].separation < depth ? m->point[1].separation : depth;
}

static void box(const place *k, td_terrain_manifold *out) {
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
                                 const thud_shape_instance *shape, unsigned sealed, double margin,
                                 td_terrain_manifold *out) {
    place k = place_of(terrain, segment, shape, sealed, margin);
    *out = (td_terrain_manifold){.ny = 1.0};
    switch (shape->kind) {
    case THUD_CIRCLE:
        circle(&k, out);
        break;
    case THUD_AABB:
    case THUD_OBB:
        box(&k, out);
        break;
    case THUD_TERRAIN: /* lines do not meet each other */
        break;
    }
}
