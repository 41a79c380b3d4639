/* edge_neighbours.c: see edge_neighbours.h. Static neighbours are found by the broadphase's set of
 * resting shapes; those of one moving body by its list of shapes. */
#include "contact/edge_neighbours.h"

#include "contact/box_faces.h"
#include "contact/contact.h"
#include "rules/rule_hooks.h"
#include "state/shape.h"
#include "terrain/terrain.h"

void td_neighbourhood_between(td_neighbourhood *s, thud_world *w, int shape, int other,
                              const thud_geometry *a, const thud_geometry *b) {
    const td_shape *first = td_shape_at(w, shape);
    double x = b->x - a->x, y = b->y - a->y;
    s->w = w;
    s->shape = shape;
    s->other = other;
    s->origin = td_shape_proxy_at(w, shape)->center;
    s->moves = td_body_at(w, first->body)->kind != THUD_BODY_STATIC;
    s->c = 1.0;
    s->s = 0.0;
    s->length_scale = (double)w->length_scale;
    s->a = *a;
    s->b = *b;
    s->a.x = s->a.y = 0.0;
    if (s->moves) {
        thud_geometry own = {.c = (double)first->angle_c, .s = (double)first->angle_s};
        td_to_frame(&own, a->c, a->s, &s->c, &s->s);
        thud_geometry axes = {.c = s->c, .s = s->s};
        s->a.c = own.c;
        s->a.s = own.s;
        td_to_frame(&axes, x, y, &x, &y);
        td_to_frame(&axes, b->c, b->s, &s->b.c, &s->b.s);
    }
    s->b.x = x;
    s->b.y = y;
}

td_neighbourhood td_neighbourhood_of(thud_world *w, int shape, int other) {
    td_position origin = td_shape_proxy_at(w, shape)->center;
    thud_geometry a = td_shape_instance(w, shape, origin), b = a;
    if (other != TD_NONE) {
        b = td_shape_instance(w, other, origin);
    }
    td_neighbourhood s;
    td_neighbourhood_between(&s, w, shape, other, &a, &b);
    return s;
}

bool td_is_ground(const thud_world *w, int shape) {
    const td_shape *s = td_shape_at(w, shape);
    return (s->flags & (TD_SHAPE_LIVE | TD_SHAPE_HOLLOW)) == TD_SHAPE_LIVE &&
           td_body_at(w, s->body)->kind == THUD_BODY_STATIC &&
           !(td_body_at(w, s->body)->flags & TD_BODY_DISABLED);
}

thud_geometry td_neighbour_instance(const td_neighbourhood *s, int neighbour) {
    if (!s->moves) {
        return td_shape_instance(s->w, neighbour, s->origin);
    }
    const td_shape *n = td_shape_at(s->w, neighbour), *first = td_shape_at(s->w, s->shape);
    return (thud_geometry){.kind = (thud_shape_kind)n->kind,
                           .x = (double)(n->x - first->x),
                           .y = (double)(n->y - first->y),
                           .c = (double)n->angle_c,
                           .s = (double)n->angle_s,
                           .hx = (double)n->half_x,
                           .hy = (double)n->half_y};
}

/* Whether a vertex is the first or last one of a line and stands at x. `at` is the vertex's x. Such
 * an end does not count as ground that rises past a box's corner. The box may stand at the end of
 * the line and cover it: then its corner is not hidden by the line, and other shapes can touch it.
 */
static bool is_line_end(const td_neighbourhood *s, const thud_terrain *t, int vertex, double at,
                        double x) {
    bool end = t->kind != THUD_TERRAIN_FLAT && (vertex == 0 || vertex == t->count - 1);
    return end && td_abs(at - x) <= 2.0 * TD_NEIGHBOUR_GAP * s->length_scale;
}

bool td_neighbour_overlaps(const td_neighbourhood *s, int neighbour, const thud_geometry *n,
                           const thud_geometry *other) {
    switch (n->kind) {
    case THUD_SHAPE_CIRCLE:
        return thud_geometry_overlap(n, other);
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        return td_boxes_overlap(n, other);
    case THUD_SHAPE_TERRAIN: {
        thud_terrain terrain = td_terrain_view(s->w, neighbour);
        thud_geometry moved = *other;
        moved.x -= n->x;
        moved.y -= n->y;
        return thud_terrain_overlap(&terrain, &moved);
    }
    }
    return false;
}

bool td_neighbour_contains(const td_neighbourhood *s, int neighbour, const thud_geometry *n,
                           double x, double y, double slack) {
    if (td_kind_is_box(n->kind)) {
        double u, v;
        td_to_frame(n, x - n->x, y - n->y, &u, &v);
        return td_abs(u) <= n->hx + slack && td_abs(v) <= n->hy + slack;
    }
    thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1.0, .hx = slack};
    return td_neighbour_overlaps(s, neighbour, n, &point);
}

bool td_neighbour_extends(const td_neighbourhood *s, int neighbour, const thud_geometry *n,
                          double x, double y, double nx, double ny, double level) {
    double past = (n->x - x) * nx + (n->y - y) * ny;
    if (td_kind_is_line(n->kind)) {
        thud_terrain terrain = td_terrain_view(s->w, neighbour);
        double near = 2.0 * TD_NEIGHBOUR_GAP *
                      s->length_scale; /* Ground further away gives contacts of its own. */
        int first, last;
        thud_terrain_segments(&terrain, x - n->x - near, x - n->x + near, &first, &last);
        bool higher = ny < 0.0; /* the ground below a line is solid down to any depth */
        for (int i = first; i <= last; i++) {
            td_segment t = td_terrain_segment(&terrain, i, x - n->x - s->length_scale,
                                              x - n->x + s->length_scale);
            higher |= !is_line_end(s, &terrain, i, t.p.x, x - n->x) &&
                      past + t.p.x * nx + t.p.y * ny > level;
            higher |= !is_line_end(s, &terrain, i + 1, t.q.x, x - n->x) &&
                      past + t.q.x * nx + t.q.y * ny > level;
        }
        return higher;
    }
    return past + td_half_along(n, nx, ny) > level;
}

/* Calls `fn` for shape n, except where n is the shape itself; where the shape is static and n is
 * not (td_is_ground); and where n cannot hide edges from `other`, because n and `other` do not
 * collide, or a one-way rule lets `other` pass through n. */
static bool visit(const td_neighbourhood *s, int n, td_neighbour_fn *fn, void *context) {
    return n != s->shape && (s->moves || td_is_ground(s->w, n)) &&
           (s->other == TD_NONE ||
            (td_pair_allowed(s->w, n, s->other) &&
             (!s->w->rule_hooks || s->w->rule_hooks->hides(s->w, n, s->other)))) &&
           fn(s, n, context);
}

/* td_neighbour_any for the shapes of one moving body, by their bounding squares. */
static bool any_in_body(const td_neighbourhood *s, const thud_geometry *where, td_neighbour_fn *fn,
                        void *context) {
    double near = td_reach(where) + 2.0 * TD_NEIGHBOUR_GAP * s->length_scale;
    int n = td_body_at(s->w, td_shape_at(s->w, s->shape)->body)->first_shape;
    for (; n != TD_NONE; n = td_shape_at(s->w, n)->next) {
        thud_geometry p = td_neighbour_instance(s, n);
        double reach = near + td_reach(&p);
        int flags = td_shape_at(s->w, n)->flags & (TD_SHAPE_LIVE | TD_SHAPE_HOLLOW);
        if (td_abs(p.x - where->x) <= reach && td_abs(p.y - where->y) <= reach &&
            flags == TD_SHAPE_LIVE && visit(s, n, fn, context)) {
            return true;
        }
    }
    return false;
}

bool td_neighbour_any(const td_neighbourhood *s, const thud_geometry *where, td_neighbour_fn *fn,
                      void *context) {
    thud_world *w = s->w;
    td_array *found = &w->scratch.found_shapes;
    if (s->moves) {
        return any_in_body(s, where, fn, context);
    }
    td_bounds b = td_placed_bounds(w, where, s->origin, 2.0 * TD_NEIGHBOUR_GAP * s->length_scale);
    found->count = 0;
    if (!td_kind_is_line(where->kind) &&
        !w->def.broadphase->find[w->wide](&w->rest_shapes, &w->memory, &b, s->origin, found,
                                          NULL)) {
        return false;
    }
    for (int i = 0; i < found->count; i++) {
        int n = td_int_at(found, i);
        if (visit(s, n, fn, context)) {
            return true;
        }
    }
    for (int t = 0; t < w->terrains.count; t++) {
        const td_terrain_record *record = td_terrain_record_at(w, t);
        int n = record->shape;
        if (n != TD_NONE && visit(s, n, fn, context)) {
            return true;
        }
    }
    return false;
}
