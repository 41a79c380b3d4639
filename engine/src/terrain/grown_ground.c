/* grown_ground.c: see grown_ground.h. Every end of a piece is always computed by the same
 * expression, so that neighbouring pieces share their end point exactly and leave no gap. */
#include "terrain/grown_ground.h"

td_grown td_grown_by(const thud_terrain *t, const thud_geometry *s, thud_pos offset) {
    td_grown k = {.terrain = t, .shape = s, .offset = offset};
    switch (s->kind) {
    case THUD_SHAPE_CIRCLE:
        k.radius = s->hx;
        k.under[0].x = -s->hx;
        k.under[1].y = -s->hx;
        k.under[2].x = s->hx;
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB: {
        double u = s->c > 0.0 ? s->hx : -s->hx, v = s->s > 0.0 ? s->hy : -s->hy;
        td_from_frame(s, -u, v, &k.under[0].x, &k.under[0].y);
        td_from_frame(s, s->s > 0.0 ? -s->hx : s->hx, s->c > 0.0 ? -s->hy : s->hy, &k.under[1].x,
                      &k.under[1].y);
        td_from_frame(s, u, -v, &k.under[2].x, &k.under[2].y);
        break;
    }
    case THUD_SHAPE_TERRAIN: /* never called for one */
        break;
    }
    return k;
}

td_grown td_grown_mirrored(const td_grown *k) {
    td_grown m = *k;
    m.mirrored = !k->mirrored;
    for (int i = 0; i < 3; i++) {
        m.under[i] = (thud_pos){-k->under[2 - i].x, k->under[2 - i].y};
    }
    return m;
}

thud_pos td_grown_vertex(const td_grown *k, int i) {
    i = k->mirrored ? k->terrain->count - 1 - i : i;
    double x = td_terrain_x(k->terrain, i) - k->shape->x - k->offset.x;
    return (thud_pos){k->mirrored ? -x : x, k->terrain->points[i].y - k->shape->y - k->offset.y};
}

void td_grown_vertices(const td_grown *k, double x_min, double x_max, int *first, int *last) {
    double left = x_min + k->under[0].x, right = x_max + k->under[2].x;
    double from = k->mirrored ? -right : left, to = k->mirrored ? -left : right;
    double x = k->shape->x + k->offset.x;
    int end = k->terrain->count - 1;
    int a = td_max_int(td_terrain_segment_at(k->terrain, x + from) - 1, 0);
    int b = td_min_int(td_terrain_segment_at(k->terrain, x + to) + 2, end);
    *first = k->mirrored ? end - b : a;
    *last = k->mirrored ? end - a : b;
}

/* The piece of the segment from p to q: the segment, minus the point of the shape that is lowest
 * along the segment's normal. */
static td_piece shifted(const td_grown *k, thud_pos p, thud_pos q) {
    double dx = q.x - p.x, dy = q.y - p.y;
    thud_pos low = k->under[0];
    for (int i = 1; i < 3; i++) {
        if (dx * (k->under[i].y - low.y) < dy * (k->under[i].x - low.x)) {
            low = k->under[i];
        }
    }
    if (k->radius > 0.0) {
        double length = __builtin_sqrt(dx * dx + dy * dy);
        low = (thud_pos){dy / length * k->radius, -dx / length * k->radius};
    }
    return (
        td_piece){.p = {p.x - low.x, p.y - low.y}, .q = {q.x - low.x, q.y - low.y}, .touch = low};
}

td_piece td_grown_line(const td_grown *k) {
    double slope = k->terrain->slope;
    double above = slope * (k->shape->x + k->offset.x) - (k->shape->y + k->offset.y);
    return shifted(k, (thud_pos){0.0, above}, (thud_pos){1.0, above + slope});
}

bool td_grown_piece(const td_grown *k, int index, int part, td_piece *out) {
    thud_pos v = td_grown_vertex(k, index);
    if (part == 2) {
        if (index == k->terrain->count - 1) {
            return false;
        }
        *out = shifted(k, v, td_grown_vertex(k, index + 1));
    } else if (k->radius > 0.0) {
        *out = (td_piece){.p = {v.x - k->radius, v.y},
                          .q = {v.x + k->radius, v.y},
                          .round = true,
                          .at_vertex = true,
                          .touch = v,
                          .radius = k->radius};
        return part == 0;
    } else {
        const thud_pos *left = &k->under[2 - part], *right = &k->under[1 - part];
        *out = (td_piece){.p = {v.x - left->x, v.y - left->y},
                          .q = {v.x - right->x, v.y - right->y},
                          .at_vertex = true,
                          .touch = v};
    }
    return out->p.x < out->q.x;
}

double td_piece_height(const td_piece *e, double x) {
    if (e->round) {
        double dx = td_abs(x - e->touch.x);
        double square = (e->radius - dx) * (e->radius + dx);
        return e->touch.y + (square > 0.0 ? __builtin_sqrt(square) : 0.0);
    }
    if (x - e->p.x < e->q.x - x) { /* interpolates from the nearer end, so that the heights at both
                                      ends are exact */
        return e->p.y + (x - e->p.x) * ((e->q.y - e->p.y) / (e->q.x - e->p.x));
    }
    return e->q.y + (x - e->q.x) * ((e->q.y - e->p.y) / (e->q.x - e->p.x));
}

double td_piece_steepness(const td_piece *e, double x) {
    double rise = e->round ? x - e->touch.x : e->q.y - e->p.y;
    double run = e->round ? td_piece_height(e, x) - e->touch.y : e->q.x - e->p.x;
    return run > 0.0 ? td_abs(rise / run) : 1e300;
}

thud_pos td_piece_normal(const td_piece *e, thud_pos at) {
    thud_pos n = {at.x - e->touch.x, at.y - e->touch.y};
    if (!e->round) {
        n = (thud_pos){e->p.y - e->q.y, e->q.x - e->p.x};
    }
    double length = __builtin_sqrt(n.x * n.x + n.y * n.y);
    return (thud_pos){n.x / length, n.y / length};
}

/* Whether a piece of a vertex may lie over x, by its vertices alone: cheaper than computing it. */
static bool may_cover(const td_grown *k, int index, int part, double x) {
    int end = part == 2 && index < k->terrain->count - 1 ? index + 1 : index;
    return x >= td_grown_vertex(k, index).x - k->under[2].x &&
           x <= td_grown_vertex(k, end).x - k->under[0].x;
}

bool td_grown_highest(const td_grown *k, double x, double enough, td_piece *out, double *height) {
    bool found = false;
    int first, last;
    if (k->terrain->kind == THUD_TERRAIN_FLAT) {
        *out = td_grown_line(k);
        *height = out->p.y + (x - out->p.x) * k->terrain->slope;
        return true;
    }
    td_grown_vertices(k, x, x, &first, &last);
    for (int i = first * TD_PIECES; i < (last + 1) * TD_PIECES; i++) {
        td_piece e;
        int index = i / TD_PIECES, part = i % TD_PIECES;
        if (!may_cover(k, index, part, x) || !td_grown_piece(k, index, part, &e) || x < e.p.x ||
            x > e.q.x) {
            continue;
        }
        double here = td_piece_height(&e, x);
        if (!found || here > *height || (here == *height && e.q.x > out->q.x)) {
            found = true;
            *height = here;
            *out = e;
        }
        if (here >= enough) {
            break;
        }
    }
    return found;
}
