/* terrain_contacts.c: the one or two contact points of a shape with a whole terrain. For queries;
 * the solver's contacts come from terrain_manifold.c, segment by segment.
 *
 * The first point is the closest point, or for a shape in the ground the point of the minimum
 * translation out of it. For the second, every feature that may touch (a corner of a box, a ridge
 * of the ground, a segment under a circle) is tested by itself; none can be deeper than the first
 * point. Among those within the margin, the point furthest from the first is taken; then, among
 * those as deep as the first, the point furthest from the second replaces the first. Points far
 * from each other describe best how the shape is supported. */
#include "terrain/terrain.h"

/* Two points count as one if their distance is less than this share of the shape's extent, and two
 * depths as equal if they differ by less. Larger than rounding errors; chosen, not tuned. */
#define SAME_POINT 1e-9
/* A normal may lie outside of a ridge's wedge (try_ridge) by this angle, given as its sine. Larger
 * than rounding errors; chosen, not tuned. */
#define WEDGE_SLACK 1e-9

/* A search for the point furthest from `from`. Points are relative to the shape's centre. */
typedef struct search {
    const thud_terrain *terrain;
    const thud_geometry *shape;
    double margin; /* points with a larger separation are left out */
    thud_closest from;
    double apart; /* distance of the best point so far from `from`; at first the minimum distance */
    bool found;
    thud_closest best;
} search;

/* Stores a candidate in `best` if it is within the margin and further from `from`. */
static void keep_further(search *k, const thud_closest *c) {
    double dx = c->ax - k->from.ax, dy = c->ay - k->from.ay;
    double apart = __builtin_sqrt(dx * dx + dy * dy);
    if (c->distance <= k->margin && apart > k->apart) {
        k->apart = apart;
        k->found = true;
        k->best = *c;
    }
}

/* Tries each corner of a box, with the point of the ground that is nearest to it. */
static void try_corners(search *k) {
    thud_geometry box = *k->shape,
                  point = {.kind = THUD_SHAPE_CIRCLE, .x = box.x, .y = box.y, .c = 1.0};
    box.x = box.y = 0.0;
    for (int i = 0; i < 4; i++) {
        thud_pos corner;
        thud_closest c;
        td_corner(&box, i, &corner.x, &corner.y);
        td_terrain_closest(k->terrain, &point, corner, &c);
        c.ax += corner.x;
        c.ay += corner.y;
        c.bx += corner.x;
        c.by += corner.y;
        keep_further(k, &c);
    }
}

/* Vertex i, relative to the shape's centre. */
static thud_pos vertex_of(const search *k, int i) {
    return (thud_pos){td_terrain_x(k->terrain, i) - k->shape->x,
                      k->terrain->points[i].y - k->shape->y};
}

/* The candidate of vertex i, with the nearest point of the shape, if the vertex is a ridge (the
 * line turns downwards there) and the normal from it to the shape lies in the ridge's wedge,
 * between the normals of the segments before and after it. */
static void try_ridge(search *k, int i) {
    const thud_terrain *t = k->terrain;
    td_segment before = {.ty = 1.0},
               after = {.ty = -1.0}; /* the side under an end of the line is vertical */
    if (i > 0) {
        before = td_terrain_segment(t, i - 1, 0.0, 0.0);
    }
    if (i < t->count - 1) {
        after = td_terrain_segment(t, i, 0.0, 0.0);
    }
    if (before.ty * after.tx - before.tx * after.ty <= WEDGE_SLACK) {
        return;
    }
    thud_pos v = vertex_of(k, i);
    thud_geometry shape = *k->shape,
                  point = {.kind = THUD_SHAPE_CIRCLE, .x = v.x, .y = v.y, .c = 1.0};
    thud_closest c;
    shape.x = shape.y = 0.0;
    td_closest(&point, &shape, &c);
    if (c.nx * before.tx + c.ny * before.ty >= -WEDGE_SLACK &&
        c.nx * after.tx + c.ny * after.ty <= WEDGE_SLACK) {
        keep_further(k, &c);
    }
}

/* The candidate of segment i, if the centre of a circle projects onto it from above. */
static void try_segment(search *k, int i) {
    td_segment s = td_terrain_segment(k->terrain, i, 0.0, 0.0);
    s.p = vertex_of(k, i);
    double along = td_along(s.tx, s.ty, s.p, 0.0, 0.0), above = td_above(&s, 0.0, 0.0);
    if (along < 0.0 || along > s.length || above < 0.0) {
        return;
    }
    double r = k->shape->hx;
    thud_closest c = {above - r, -s.ty, s.tx, s.ty * above, -s.tx * above, s.ty * r, -s.tx * r};
    keep_further(k, &c);
}

/* Tries all candidates. `centre_out`: a circle's centre is not in the ground, so that segments are
 * candidates. */
static bool find(search *k, bool centre_out) {
    bool circle = td_kind_is_round(k->shape->kind);
    double reach = td_half_width(k->shape) + k->margin;
    int first, last;
    if (td_kind_is_box(k->shape->kind)) {
        try_corners(k);
    }
    thud_terrain_segments(k->terrain, k->shape->x - reach, k->shape->x + reach, &first, &last);
    if (k->terrain->kind == THUD_TERRAIN_FLAT || first > last) {
        return k->found;
    }
    for (int i = first; i <= last + 1; i++) {
        try_ridge(k, i);
    }
    for (int i = first; circle && centre_out && i <= last; i++) {
        try_segment(k, i);
    }
    return k->found;
}

/* Given out->point[0], adds the second point, and then replaces the first one as the head of this
 * file describes. */
static void find_points(const thud_terrain *t, const thud_geometry *shape, double margin,
                        thud_contacts *out) {
    thud_closest *first = &out->point[0], *second = &out->point[1];
    double same = SAME_POINT * td_reach(shape);
    bool centre_out = first->distance >= -shape->hx;
    search k = {.terrain = t, .shape = shape, .margin = margin, .from = *first, .apart = same};
    if (!find(&k, centre_out)) {
        return;
    }
    *second = k.best;
    out->count = 2;
    search for_first = {.terrain = t,
                        .shape = shape,
                        .margin = first->distance + same,
                        .from = *second,
                        .apart = k.apart};
    if (find(&for_first, centre_out)) {
        *first = for_first.best;
    }
}

thud_result thud_terrain_contacts(const thud_terrain *terrain, const thud_geometry *shape,
                                  double margin, thud_contacts *out) {
    if (!terrain || !shape || !out) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_geometry_check(shape) != THUD_OK ||
        !(margin >= 0.0 && margin <= THUD_COORDINATE_MAX)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    *out = (thud_contacts){.count = 1};
    td_terrain_closest(terrain, shape, (thud_pos){0.0, 0.0}, &out->point[0]);
    if (out->point[0].distance > margin) {
        *out = (thud_contacts){0};
        return THUD_OK;
    }
    find_points(terrain, shape, margin, out);
    for (int i = 0; i < out->count; i++) {
        out->point[i].ax += shape->x;
        out->point[i].ay += shape->y;
        out->point[i].bx += shape->x;
        out->point[i].by += shape->y;
    }
    return THUD_OK;
}
