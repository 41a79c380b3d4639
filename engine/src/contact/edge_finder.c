/* edge_finder.c: which faces of static shapes have something static at them, and which faces of one
 * body something else of it. */
#include "contact/contact.h"
#include "constraint/lanes.h"
#include "contact/edge_neighbours.h"
#include "contact/internal_edges.h"
#include "state/shape.h"
#include "terrain/terrain.h"

static void set(thud_world *w, int shape, unsigned internal_edges, unsigned hidden) {
    td_shape *s = td_shape_at(w, shape);
    bool same = s->internal_edges == internal_edges;
    s->internal_edges = (uint8_t)internal_edges;
    s->hidden = (uint8_t)hidden;
    int e = same ? TD_NONE : td_body_at(w, s->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, e / 2);
        if (td_is_contact(contact) && contact->state == TD_TOUCHING) {
            td_lane at = td_lane_of(w, contact);
            at.block->mark[at.lane].internal_edges =
                td_internal_edges_of(td_shape_at(w, contact->shape_a),
                                     td_shape_at(w, contact->shape_b));
        }
    }
}

/* A strip outside a face, from one to two widths away, short of its ends. */
static thud_shape_instance strip_of(const thud_shape_instance *box, int face, double width) {
    thud_shape_instance strip = *box;
    double along = face % 2 ? box->hx : box->hy, out = (face % 2 ? box->hy : box->hx) + 1.5 * width;
    double u = face % 2 ? 0.0 : out, v = face % 2 ? out : 0.0, x, y;
    td_from_frame(box, face >= 2 ? -u : u, face >= 2 ? -v : v, &x, &y);
    strip.x += x;
    strip.y += y;
    along = along > 2.0 * width ? along - width : 0.5 * along;
    strip.hx = face % 2 ? along : 0.5 * width;
    strip.hy = face % 2 ? 0.5 * width : along;
    return strip;
}

/* Whether both shapes meet the same others, so that what one hides of the other is hidden from all
 * of them. */
static bool alike(const thud_world *w, int a, int b) {
    const thud_filter *p = &td_shape_at(w, a)->filter, *q = &td_shape_at(w, b)->filter;
    return p->category == q->category && p->mask == q->mask && p->group == q->group;
}

static unsigned corners_of_face(int face) {
    bool upright = face % 2 == 0, far = face < 2; /* right and top lie at greater coordinates */
    return td_corner_bit(upright ? far : false, upright ? false : far) |
           td_corner_bit(upright ? far : true, upright ? true : far);
}

/* A corner is straight where a neighbour goes on past it however little a normal leans away from
 * either face. */
#define LEAN 0.01

/* The parts of a box that neighbours are asked about, worked out for the first of them. */
typedef struct box_parts {
    bool known;
    double x[4], y[4]; /* corners: bit 0 of the number tells right, bit 1 top */
    thud_shape_instance strip[TD_FACES];
} box_parts;

static void find_parts(box_parts *parts, const thud_shape_instance *box, double width) {
    parts->known = true;
    for (int k = 0; k < 4; k++) {
        double x, y;
        td_from_frame(box, k & 1 ? box->hx : -box->hx, k & 2 ? box->hy : -box->hy, &x, &y);
        parts->x[k] = box->x + x;
        parts->y[k] = box->y + y;
    }
    for (int f = 0; f < TD_FACES; f++) {
        parts->strip[f] = strip_of(box, f, width);
    }
}

/* Of a corner at (x, y) that the neighbour holds. */
static bool straightens(const td_internal_edge *s, int neighbour, const thud_shape_instance *placed,
                        int corner, double x, double y) {
    const thud_shape_instance *box = &s->a;
    double u = corner & 1 ? 1.0 : -1.0, v = corner & 2 ? 1.0 : -1.0, nx, ny, mx, my;
    double level = 0.5 * LEAN * (box->hx < box->hy ? box->hx : box->hy);
    td_from_frame(box, u, LEAN * v, &nx, &ny);
    td_from_frame(box, LEAN * u, v, &mx, &my);
    return td_internal_edge_rises(s, neighbour, placed, x, y, nx, ny, level) &&
           td_internal_edge_rises(s, neighbour, placed, x, y, mx, my, level);
}

/* Notes what of a box a neighbour stands at and hides. */
static bool note_own(const td_internal_edge *s, int neighbour, void *context) {
    box_parts *parts = context;
    double width = TD_FLUSH * s->unit;
    if (!parts->known) {
        find_parts(parts, &s->a, width);
    }
    const td_shape *noted = td_shape_at(s->w, s->shape);
    unsigned internal_edges = noted->internal_edges, hidden = noted->hidden, held = 0;
    thud_shape_instance other = td_internal_edge_place(s, neighbour);
    bool solid = !td_kind_is_line(other.kind) && alike(s->w, s->shape, neighbour);
    for (int k = 0; k < 4; k++) {
        double x = parts->x[k], y = parts->y[k];
        if (td_internal_edge_holds(s, neighbour, &other, x, y, width)) {
            unsigned bit = td_corner_bit(k & 1, k >> 1 & 1);
            held |= bit;
            hidden |= solid && straightens(s, neighbour, &other, k, x, y) ? bit : 0;
        }
    }
    for (int f = 0; f < TD_FACES; f++) {
        bool covered = td_internal_edge_meets(s, neighbour, &other, &parts->strip[f]);
        internal_edges |= (unsigned)covered << f;
        /* A convex shape that holds both ends of a face holds all of it. */
        bool whole = covered && solid && (held & corners_of_face(f)) == corners_of_face(f);
        hidden |= (unsigned)whole << f;
    }
    set(s->w, s->shape, internal_edges | held, hidden);
    return false;
}

/* Of a box that stands at nothing as far as is noted. */
static void note_neighbours(const td_internal_edge *s) {
    box_parts parts;
    parts.known = false;
    td_internal_edge_any(s, &s->a, note_own, &parts);
}

/* A line's end is sealed where a neighbour reaches up to it from outside. */
static uint8_t ends_at(const td_internal_edge *s, int terrain_shape, int neighbour) {
    thud_terrain t = td_terrain_view(s->w, terrain_shape);
    thud_shape_instance at = td_shape_instance(s->w, terrain_shape, s->origin);
    thud_shape_instance other = td_internal_edge_place(s, neighbour);
    double out = TD_FLUSH * s->unit;
    if (t.kind == THUD_TERRAIN_FLAT) {
        return 0;
    }
    double right = td_terrain_x(&t, t.count - 1), left = td_terrain_x(&t, 0);
    double last = t.points[t.count - 1].y, first = t.points[0].y;
    bool at_right =
        td_internal_edge_holds(s, neighbour, &other, at.x + right + out, at.y + last - out, out);
    bool at_left =
        td_internal_edge_holds(s, neighbour, &other, at.x + left - out, at.y + first - out, out);
    return (uint8_t)(at_right << TD_FACE_RIGHT | at_left << TD_FACE_LEFT);
}

static bool reserve(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.hits,
                            3 * w->rest_shapes.ids.count + 4 * TD_LANES);
}

bool td_internal_edges_see(thud_world *w, int shape) {
    td_internal_edge s = td_internal_edge_of(w, shape, TD_NONE);
    if (!reserve(w)) {
        return false;
    }
    td_shape_at(w, shape)->flags &= (uint8_t)~TD_SHAPE_UNSEEN;
    set(w, shape, 0, 0);
    note_neighbours(&s);
    return true;
}

static void forget(thud_world *w, int shape) {
    td_shape *s = td_shape_at(w, shape);
    if (td_kind_is_box(s->kind)) {
        s->flags |= TD_SHAPE_UNSEEN;
        set(w, shape, 0xff, 0);
    }
}

/* What has contacts is seen at once. */
static bool is_shape_due(const thud_world *w, int shape) {
    const td_shape *s = td_shape_at(w, shape);
    return (s->flags & TD_SHAPE_UNSEEN) && td_body_at(w, s->body)->first_constraint != TD_NONE;
}

static bool is_due(const td_internal_edge *s, int neighbour, void *context) {
    bool due = is_shape_due(s->w, neighbour);
    *(int *)context = due ? neighbour : *(int *)context;
    return due;
}

/* Lines note their ends at once, since they are few. */
static bool forget_pair(const td_internal_edge *s, int neighbour, void *context) {
    int pair[] = {s->shape, neighbour};
    for (int i = 0; i < 2; i++) {
        if (td_kind_is_line(td_shape_at(s->w, pair[i])->kind)) {
            unsigned ends = ends_at(s, pair[i], pair[!i]);
            set(s->w, pair[i], td_shape_at(s->w, pair[i])->internal_edges | ends, 0);
        }
    }
    forget(s->w, neighbour);
    is_due(s, neighbour, context);
    return false;
}

/* Each shape at rest came or moved, as in a world's first step, and is on the moved list itself:
 * neighbours need not be looked for. Lines are not among the shapes at rest. */
static bool all_come(const thud_world *w) {
    return w->terrains.live == 0 &&
           w->moved.count - w->awake_shapes.moved_count == w->rest_shapes.ids.count;
}

/* Boxes are found by a terrain that came as well: all of them, since lines are few. */
bool td_internal_edges_find(thud_world *w, int shape) {
    int due = TD_NONE;
    if (!td_is_ground(w, shape)) {
        return true;
    }
    if (all_come(w)) {
        forget(w, shape);
        return !is_shape_due(w, shape) || td_internal_edges_see(w, shape);
    }
    td_internal_edge s = td_internal_edge_of(w, shape, TD_NONE);
    if (td_kind_is_line(s.a.kind)) {
        for (int i = 0; i < w->rest_shapes.ids.count; i++) {
            int n = td_int_at(&w->rest_shapes.ids, i);
            if (!td_is_ground(w, n)) {
                continue;
            }
            forget_pair(&s, n, &due);
            if (due == n && !td_internal_edges_see(w, n)) {
                return false;
            }
        }
    }
    if (!reserve(w)) {
        return false;
    }
    due = TD_NONE;
    forget(w, shape);
    td_internal_edge_any(&s, &s.a, forget_pair, &due);
    is_due(&s, shape, &due);
    while (due != TD_NONE) {
        if (!td_internal_edges_see(w, due)) {
            return false;
        }
        due = TD_NONE;
        td_internal_edge_any(&s, &s.a, is_due, &due);
    }
    return true;
}

static bool look_anew(const td_internal_edge *s, int neighbour, void *context) {
    (void)context;
    set(s->w, neighbour, 0, 0);
    td_shape_mark_moved(s->w, neighbour);
    return false;
}

/* The shapes that rest are still those of the last step; who came since will look for himself. */
bool td_internal_edges_lose(thud_world *w, td_body_index body) {
    int i = td_body_at(w, body)->first_shape;
    if (td_body_at(w, body)->kind != THUD_STATIC || i == TD_NONE) {
        return true;
    }
    if (!reserve(w)) {
        return false;
    }
    for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (td_shape_at(w, i)->internal_edges) {
            td_internal_edge s = td_internal_edge_of(w, i, TD_NONE);
            td_internal_edge_any(&s, &s.a, look_anew, NULL);
            set(w, i, 0, 0);
        }
    }
    return true;
}

void td_internal_edges_join(thud_world *w, td_body_index body) {
    const td_body *b = td_body_at(w, body);
    for (int i = b->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (td_kind_is_box(shape->kind) && !(shape->flags & TD_SHAPE_HOLLOW)) {
            td_internal_edge s = td_internal_edge_of(w, i, TD_NONE);
            set(w, i, 0, 0);
            note_neighbours(&s);
        }
    }
}
