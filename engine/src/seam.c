/* seam.c: see seam.h. */
#include "seam.h"

#include "contact.h"
#include "shape.h"
#include "terrain.h"

td_seam td_seam_of(thud_world *w, int shape, int other)
{
    td_seam s = {.w = w, .shape = shape, .other = other, .origin = td_stance_at(w, shape)->center,
              .unit = (double)w->unit};
    s.a = td_shape_placed(w, shape, s.origin);
    if (other != TD_NONE) {
        s.b = td_shape_placed(w, other, s.origin);
    }
    return s;
}

bool td_is_ground(const thud_world *w, int shape)
{
    const td_shape *s = td_shape_at(w, shape);
    return (s->flags & (TD_SHAPE_LIVE | TD_SHAPE_HOLLOW)) == TD_SHAPE_LIVE &&
           td_body_at(w, s->body)->kind == THUD_STATIC &&
           !(td_body_at(w, s->body)->flags & TD_BODY_DISABLED);
}

bool td_seam_holds(const td_seam *s, int neighbour, double x, double y, double slack)
{
    thud_placed n = td_shape_placed(s->w, neighbour, s->origin);
    thud_placed point = {.kind = THUD_CIRCLE, .x = x, .y = y, .c = 1.0, .hx = slack};
    if (n.kind == THUD_TERRAIN) {
        thud_terrain terrain = td_terrain_view(s->w, neighbour);
        point.x -= n.x;
        point.y -= n.y;
        return thud_terrain_overlap(&terrain, &point);
    }
    if (n.kind == THUD_CIRCLE) {
        return thud_shapes_overlap(&n, &point);
    }
    double u, v;
    td_to_frame(&n, x - n.x, y - n.y, &u, &v);
    return td_abs(u) <= n.hx + slack && td_abs(v) <= n.hy + slack;
}

/* Whether a line ends at a place: its sealed end is no edge of its own, and leaves it to a box's corner
 * that is there. */
static bool ends_at(const td_seam *s, const thud_terrain *t, int vertex, double at, double x)
{
    bool end = t->kind != THUD_TERRAIN_FLAT && (vertex == 0 || vertex == t->count - 1);
    return end && td_abs(at - x) <= 2.0 * TD_FLUSH * s->unit;
}

bool td_seam_rises(const td_seam *s, int neighbour, double x, double y, double nx, double ny,
                  double level)
{
    thud_placed n = td_shape_placed(s->w, neighbour, s->origin);
    double past = (n.x - x) * nx + (n.y - y) * ny;
    if (n.kind == THUD_TERRAIN) {
        thud_terrain terrain = td_terrain_view(s->w, neighbour);
        double near = 2.0 * TD_FLUSH * s->unit; /* the ground further away is met on its own */
        int first, last;
        thud_terrain_segments(&terrain, x - n.x - near, x - n.x + near, &first, &last);
        bool higher = ny < 0.0;
        for (int i = first; i <= last; i++) {
            td_segment t = td_terrain_segment(&terrain, i, x - n.x - s->unit, x - n.x + s->unit);
            higher |= !ends_at(s, &terrain, i, t.p.x, x - n.x) &&
                      past + t.p.x * nx + t.p.y * ny > level;
            higher |= !ends_at(s, &terrain, i + 1, t.q.x, x - n.x) &&
                      past + t.q.x * nx + t.q.y * ny > level;
        }
        return higher;
    }
    return past + (n.kind == THUD_CIRCLE ? n.hx : td_shadow(&n, nx, ny)) > level;
}

bool td_seam_any(const td_seam *s, const thud_placed *where, td_neighbour_fn *fn, void *context)
{
    thud_world *w = s->w;
    td_array *hits = &w->scratch.hits;
    td_bounds b = td_placed_bounds(w, where, s->origin, 2.0 * TD_FLUSH * s->unit);
    hits->count = 0;
    if (where->kind != THUD_TERRAIN &&
        !w->def.broadphase->find[w->wide](&w->rest_shapes, &w->memory, &b, s->origin, hits)) {
        return false;
    }
    for (int i = 0; i < hits->count; i++) {
        int n = *(int *)td_at(hits, i);
        if (n != s->shape && td_is_ground(w, n) &&
            (s->other == TD_NONE || td_pair_allowed(w, n, s->other)) && fn(s, n, context)) {
            return true;
        }
    }
    for (int t = 0; t < w->terrains.count; t++) {
        const td_terrain_record *record = td_slot_at(&w->terrains, t);
        int n = record->shape;
        if (n != TD_NONE && n != s->shape && td_is_ground(w, n) &&
            (s->other == TD_NONE || td_pair_allowed(w, n, s->other)) && fn(s, n, context)) {
            return true;
        }
    }
    return false;
}
