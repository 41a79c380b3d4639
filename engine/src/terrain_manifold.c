/* terrain_manifold.c: see terrain_manifold.h.
 *
 * Every point of the plane belongs to one feature of the line. Above the line, what projects onto a
 * segment is the segment's, and the wedge over a ridge is its vertex's; below the line, a point
 * belongs to the segment of its column. A vertex is reported by the segment that it begins, the
 * last one by the segment that it ends. */
#include "terrain_manifold.h"

#include "placed.h"

typedef struct piece {
    thud_pos p, q;
    double tx, ty; /* unit along the segment; the normal is (-ty, tx) */
    double length;
} piece;

static piece piece_of(const thud_terrain *t, int segment, const thud_placed *shape)
{
    double reach = 2.0 * (shape->hx + shape->hy) + 1.0;
    piece s;
    td_terrain_ends(t, segment, shape->x - reach, shape->x + reach, &s.p, &s.q);
    double dx = s.q.x - s.p.x, dy = s.q.y - s.p.y;
    s.length = __builtin_sqrt(dx * dx + dy * dy);
    s.tx = dx / s.length;
    s.ty = dy / s.length;
    return s;
}

/* The normals that bound the wedge of a segment's vertex: the neighbour's before and after. At an
 * open end the wedge goes down to the horizontal. False where the ground is not convex. */
static bool wedge(const thud_terrain *t, int segment, const piece *s, bool at_end,
                  double before[2], double after[2])
{
    int vertex = segment + (at_end ? 1 : 0);
    double nx = -s->ty, ny = s->tx;
    if (t->kind == THUD_TERRAIN_FLAT) {
        return false;
    }
    if (at_end) {
        before[0] = nx, before[1] = ny;
        after[0] = 1.0, after[1] = 0.0;
        return true;
    }
    after[0] = nx, after[1] = ny;
    if (vertex == 0) {
        before[0] = -1.0, before[1] = 0.0;
        return true;
    }
    thud_pos p, q;
    td_terrain_ends(t, segment - 1, 0.0, 0.0, &p, &q);
    double dx = q.x - p.x, dy = q.y - p.y, length = __builtin_sqrt(dx * dx + dy * dy);
    before[0] = -dy / length, before[1] = dx / length;
    /* A ridge turns clockwise; what is straight to rounding is no ridge. */
    return before[0] * after[1] - before[1] * after[0] < -1e-9;
}

/* Whether (x, y) lies between the two normals, clockwise from `before` to `after`. */
static bool in_wedge(const double before[2], const double after[2], double x, double y)
{
    return before[0] * y - before[1] * x <= 0.0 && x * after[1] - y * after[0] <= 0.0;
}

/* ---- circle ---- */

static void circle(const thud_terrain *t, int segment, const thud_placed *shape, double margin,
                   td_terrain_manifold *out)
{
    piece s = piece_of(t, segment, shape);
    double x = shape->x - s.p.x, y = shape->y - s.p.y;
    double along = x * s.tx + y * s.ty, height = y * s.tx - x * s.ty;
    double nx = -s.ty, ny = s.tx, distance = height;
    bool in_column = shape->x >= s.p.x && shape->x < s.q.x;
    bool found;
    if (height < 0.0) {
        found = in_column || (segment == t->count - 2 && shape->x == s.q.x);
    } else if (along >= 0.0 && along <= s.length) {
        found = true;
    } else {
        /* Over a vertex. */
        bool at_end = along > s.length;
        double before[2], after[2];
        double vx = shape->x - (at_end ? s.q.x : s.p.x), vy = shape->y - (at_end ? s.q.y : s.p.y);
        distance = __builtin_sqrt(vx * vx + vy * vy);
        found = (!at_end || segment == t->count - 2) && distance > 0.0 &&
                wedge(t, segment, &s, at_end, before, after) && in_wedge(before, after, vx, vy);
        if (found) {
            nx = vx / distance;
            ny = vy / distance;
        }
    }
    double separation = distance - shape->hx;
    if (!found || separation >= margin) {
        return;
    }
    double reach = -(shape->hx + 0.5 * separation);
    out->nx = nx;
    out->ny = ny;
    out->count = 1;
    out->point[0] = (td_terrain_point){nx * reach, ny * reach, separation, 0};
}

/* ---- box ---- */

/* Keeps the two deepest points, in the order in which they lie along the segment. */
static void keep(td_terrain_manifold *out, td_terrain_point point, const piece *s)
{
    if (out->count < 2) {
        out->point[out->count++] = point;
    } else {
        int higher = out->point[1].separation > out->point[0].separation;
        if (point.separation < out->point[higher].separation) {
            out->point[higher] = point;
        }
    }
    if (out->count == 2) {
        double a = out->point[0].px * s->tx + out->point[0].py * s->ty;
        double b = out->point[1].px * s->tx + out->point[1].py * s->ty;
        if (a > b) {
            td_terrain_point swapped = out->point[0];
            out->point[0] = out->point[1];
            out->point[1] = swapped;
        }
    }
}

/* Corners of the box in the segment's column. */
static void corners(const thud_terrain *t, int segment, const thud_placed *box, const piece *s,
                    double margin, td_terrain_manifold *out)
{
    bool last = segment == t->count - 2;
    for (int i = 0; i < 4; i++) {
        double x, y;
        td_corner(box, i, &x, &y);
        bool here = t->kind == THUD_TERRAIN_FLAT ||
                    (x >= s->p.x && (x < s->q.x || (last && x == s->q.x)));
        double separation = (y - s->p.y) * s->tx - (x - s->p.x) * s->ty;
        if (here && separation < margin) {
            keep(out,
                 (td_terrain_point){x - box->x + 0.5 * separation * s->ty,
                                    y - box->y - 0.5 * separation * s->tx, separation,
                                    (uint32_t)i},
                 s);
        }
    }
    out->nx = -s->ty;
    out->ny = s->tx;
}

/* A ridge in a face of the box: the face of least penetration that looks into the ground gives the
 * normal, held within the wedge of the ridge. */
static void ridge(const thud_placed *box, thud_pos vertex, const double before[2],
                  const double after[2], double margin, td_terrain_manifold *out)
{
    double u, v, best = -1e300, nx = 0.0, ny = 1.0;
    td_to_frame(box, vertex.x - box->x, vertex.y - box->y, &u, &v);
    if (td_abs(u) > box->hx + margin || td_abs(v) > box->hy + margin) {
        return;
    }
    for (int face = 0; face < 4; face++) {
        double fu = face == 0 ? 1.0 : face == 2 ? -1.0 : 0.0;
        double fv = face == 1 ? 1.0 : face == 3 ? -1.0 : 0.0;
        double fx, fy, separation = fu != 0.0 ? fu * u - box->hx : fv * v - box->hy;
        td_from_frame(box, fu, fv, &fx, &fy);
        if (fy < 0.0 && separation > best) {
            best = separation;
            nx = -fx;
            ny = -fy;
        }
    }
    if (best >= margin) {
        return;
    }
    if (!in_wedge(before, after, nx, ny)) {
        bool left = before[0] * nx + before[1] * ny > after[0] * nx + after[1] * ny;
        nx = left ? before[0] : after[0];
        ny = left ? before[1] : after[1];
    }
    out->nx = nx;
    out->ny = ny;
    out->count = 1;
    out->point[0] = (td_terrain_point){vertex.x - box->x + 0.5 * best * nx,
                                       vertex.y - box->y + 0.5 * best * ny, best, 4};
}

static void box(const thud_terrain *t, int segment, const thud_placed *shape, double margin,
                td_terrain_manifold *out)
{
    piece s = piece_of(t, segment, shape);
    corners(t, segment, shape, &s, margin, out);
    if (out->count) {
        return;
    }
    double before[2], after[2];
    if (wedge(t, segment, &s, false, before, after)) {
        ridge(shape, s.p, before, after, margin, out);
    }
    if (!out->count && segment == t->count - 2 && wedge(t, segment, &s, true, before, after)) {
        ridge(shape, s.q, before, after, margin, out);
    }
}

void td_terrain_segment_manifold(const thud_terrain *terrain, int segment, const thud_placed *shape,
                                 double margin, td_terrain_manifold *out)
{
    *out = (td_terrain_manifold){.ny = 1.0};
    if (shape->kind == THUD_CIRCLE) {
        circle(terrain, segment, shape, margin, out);
    } else {
        box(terrain, segment, shape, margin, out);
    }
}
