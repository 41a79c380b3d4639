/* terrain_contacts.c: the two points on which a shape stands on a whole ground line.
 *
 * The first is the nearest place, or that of the least way out. For the second, everything that may
 * touch is asked how far it is by itself; none of it can be deeper than the whole shape. Of what is
 * within the margin, the place furthest from the first is taken, and then of what is as deep as the
 * first the place furthest from the second: the two hold the shape best. */
#include "terrain/terrain.h"

/* Places closer than this share of the shape's reach are one, and depths as close are equal. */
#define SAME 1e-9
/* How far, in radians, a normal may lie outside what belongs to a ridge. */
#define SLACK 1e-9

/* For the place that is furthest from another. Places are relative to the shape's centre. */
typedef struct search {
    const thud_terrain *terrain;
    const thud_shape_instance *shape;
    double margin; /* places further from touching than this do not count */
    thud_closest from;
    double apart; /* how far the found place is from it at least */
    bool found;
    thud_closest best;
} search;

static void offer(search *k, const thud_closest *c) {
    double dx = c->ax - k->from.ax, dy = c->ay - k->from.ay;
    double apart = __builtin_sqrt(dx * dx + dy * dy);
    if (c->distance <= k->margin && apart > k->apart) {
        k->apart = apart;
        k->found = true;
        k->best = *c;
    }
}

/* The corners of a box, each with the place of the ground that is nearest to it. */
static void offer_corners(search *k) {
    thud_shape_instance box = *k->shape,
                        point = {.kind = THUD_CIRCLE, .x = box.x, .y = box.y, .c = 1.0};
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
        offer(k, &c);
    }
}

static thud_pos vertex_of(const search *k, int i) {
    return (thud_pos){td_terrain_x(k->terrain, i) - k->shape->x,
                      k->terrain->points[i].y - k->shape->y};
}

/* A vertex that sticks out of the ground, with the place of the shape that is nearest to it, if the
 * shape may stand on it from that direction: between the normals of the ground before and after. */
static void offer_ridge(search *k, int i) {
    const thud_terrain *t = k->terrain;
    td_segment before = {.ty = 1.0}, after = {.ty = -1.0}; /* upright at the ends */
    if (i > 0) {
        before = td_terrain_segment(t, i - 1, 0.0, 0.0);
    }
    if (i < t->count - 1) {
        after = td_terrain_segment(t, i, 0.0, 0.0);
    }
    if (before.ty * after.tx - before.tx * after.ty <= SLACK) {
        return;
    }
    thud_pos v = vertex_of(k, i);
    thud_shape_instance shape = *k->shape,
                        point = {.kind = THUD_CIRCLE, .x = v.x, .y = v.y, .c = 1.0};
    thud_closest c;
    shape.x = shape.y = 0.0;
    td_closest(&point, &shape, &c);
    if (c.nx * before.tx + c.ny * before.ty >= -SLACK &&
        c.nx * after.tx + c.ny * after.ty <= SLACK) {
        offer(k, &c);
    }
}

/* A segment with a circle's centre straight over it. */
static void offer_segment(search *k, int i) {
    td_segment s = td_terrain_segment(k->terrain, i, 0.0, 0.0);
    s.p = vertex_of(k, i);
    double along = td_along(s.tx, s.ty, s.p, 0.0, 0.0), above = td_above(&s, 0.0, 0.0);
    if (along < 0.0 || along > s.length || above < 0.0) {
        return;
    }
    double r = k->shape->hx;
    thud_closest c = {above - r, -s.ty, s.tx, s.ty * above, -s.tx * above, s.ty * r, -s.tx * r};
    offer(k, &c);
}

/* `centre_out`: the circle's centre is not in the ground, so that it may stand on segments. */
static bool find(search *k, bool centre_out) {
    bool circle = td_kind_is_round(k->shape->kind);
    double reach = td_half_width(k->shape) + k->margin;
    int first, last;
    if (td_kind_is_box(k->shape->kind)) {
        offer_corners(k);
    }
    thud_terrain_segments(k->terrain, k->shape->x - reach, k->shape->x + reach, &first, &last);
    if (k->terrain->kind == THUD_TERRAIN_FLAT || first > last) {
        return k->found;
    }
    for (int i = first; i <= last + 1; i++) {
        offer_ridge(k, i);
    }
    for (int i = first; circle && centre_out && i <= last; i++) {
        offer_segment(k, i);
    }
    return k->found;
}

static void find_points(const thud_terrain *t, const thud_shape_instance *shape, double margin,
                        thud_contacts *out) {
    thud_closest *first = &out->point[0], *second = &out->point[1];
    double same = SAME * td_reach(shape);
    bool centre_out = first->distance >= -shape->hx;
    search k = {.terrain = t, .shape = shape, .margin = margin, .from = *first, .apart = same};
    if (!find(&k, centre_out)) {
        return;
    }
    *second = k.best;
    out->count = 2;
    search back = {.terrain = t,
                   .shape = shape,
                   .margin = first->distance + same,
                   .from = *second,
                   .apart = k.apart};
    if (find(&back, centre_out)) {
        *first = back.best;
    }
}

thud_result thud_terrain_contacts(const thud_terrain *terrain, const thud_shape_instance *shape,
                                  double margin, thud_contacts *out) {
    if (!terrain || !shape || !out) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_placed_check(shape) != THUD_OK ||
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
