/* edge_finder.c: finds the masks td_shape.internal_edges and td_shape.hidden (internal_edges.h):
 * which faces and corners have a neighbour at them. The neighbours of a static shape are other
 * static shapes; those of a moving body's shape are the other shapes of the same body.
 *
 * Static boxes are inspected lazily: a box that comes or moves, and its neighbours, are marked as
 * TD_SHAPE_UNSEEN, and the masks are computed when the box gets its first contact. A world of many
 * tiles of which few are touched then costs little. */
#include "contact/contact.h"
#include "constraint/lanes.h"
#include "contact/edge_neighbours.h"
#include "contact/internal_edges.h"
#include "state/shape.h"
#include "terrain/terrain.h"

/* Stores both masks of a shape, and updates the marks of the lanes that it has. */
static void set_masks(thud_world *w, int shape, unsigned internal_edges, unsigned hidden) {
    td_shape *s = td_shape_at(w, shape);
    bool same = s->internal_edges == internal_edges;
    s->internal_edges = (uint8_t)internal_edges;
    s->hidden = (uint8_t)hidden;
    int e = same ? TD_NONE : td_body_at(w, s->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (td_is_contact(contact) && contact->state == TD_TOUCHING) {
            td_lane at = td_lane_of(w, contact);
            at.block->mark[at.lane].internal_edges =
                td_internal_edges_of(td_shape_at(w, contact->shape_a),
                                     td_shape_at(w, contact->shape_b));
        }
    }
}

/* A thin box outside a face, for testing whether a neighbour covers some of the face: it reaches
 * from one to two `width`s away from the face, and ends one width short of the face's ends; of a
 * face that is not longer than four widths it has the middle half. */
static thud_geometry strip_outside(const thud_geometry *box, int face, double width) {
    thud_geometry strip = *box;
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

/* Whether both shapes have the same filter. Everything that can collide with one then collides with
 * the other, too, so that what one hides of the other is hidden from all shapes. */
static bool same_filter(const thud_world *w, int a, int b) {
    const thud_filter *p = &td_shape_at(w, a)->filter, *q = &td_shape_at(w, b)->filter;
    return p->category == q->category && p->mask == q->mask && p->group == q->group;
}

/* The bits of the two corners at a face's ends. */
static unsigned corners_of_face(int face) {
    bool upright = face % 2 == 0, far = face < 2; /* right and top lie at greater coordinates */
    return td_corner_bit(upright ? far : false, upright ? false : far) |
           td_corner_bit(upright ? far : true, upright ? true : far);
}

/* Two normals are tested at a corner, one near the normal of each of its faces; this is the tangent
 * of the angle between them. A neighbour that extends past the corner along both extends past it
 * along all normals between. Chosen; not tuned. */
#define FLAT_CORNER_SLOPE 0.01

/* The parts of a box that are tested against each neighbour; computed when the first is tested. */
typedef struct box_parts {
    bool known;        /* the rest is set */
    double x[4], y[4]; /* corners: of the number, bit 0 is right, bit 1 top */
    thud_geometry strip[TD_FACES];
} box_parts;

/* Computes corners and strips of a box; `width`: that of the strips. */
static void find_parts(box_parts *parts, const thud_geometry *box, double width) {
    parts->known = true;
    for (int k = 0; k < 4; k++) {
        double x, y;
        td_from_frame(box, k & 1 ? box->hx : -box->hx, k & 2 ? box->hy : -box->hy, &x, &y);
        parts->x[k] = box->x + x;
        parts->y[k] = box->y + y;
    }
    for (int f = 0; f < TD_FACES; f++) {
        parts->strip[f] = strip_outside(box, f, width);
    }
}

/* Whether a neighbour that contains the corner at (x, y) hides the corner from all sides. It does
 * if it extends past the corner along the two contact normals that are closest to the normals of
 * the corner's faces. */
static bool flattens_corner(const td_neighbourhood *s, int neighbour, const thud_geometry *placed,
                            int corner, double x, double y) {
    const thud_geometry *box = &s->a;
    double u = corner & 1 ? 1.0 : -1.0, v = corner & 2 ? 1.0 : -1.0, nx, ny, mx, my;
    double level = 0.5 * FLAT_CORNER_SLOPE * (box->hx < box->hy ? box->hx : box->hy);
    td_from_frame(box, u, FLAT_CORNER_SLOPE * v, &nx, &ny);
    td_from_frame(box, FLAT_CORNER_SLOPE * u, v, &mx, &my);
    return td_neighbour_extends(s, neighbour, placed, x, y, nx, ny, level) &&
           td_neighbour_extends(s, neighbour, placed, x, y, mx, my, level);
}

/* A td_neighbour_fn: adds to the box's masks the faces and corners that have the neighbour at them.
 * `context` is the box's box_parts. */
static bool add_neighbour_bits(const td_neighbourhood *s, int neighbour, void *context) {
    box_parts *parts = context;
    double width = TD_NEIGHBOUR_GAP * s->length_scale;
    if (!parts->known) {
        find_parts(parts, &s->a, width);
    }
    const td_shape *inspected = td_shape_at(s->w, s->shape);
    unsigned internal_edges = inspected->internal_edges, hidden = inspected->hidden, corners = 0;
    thud_geometry other = td_neighbour_instance(s, neighbour);
    bool solid = !td_kind_is_line(other.kind) && same_filter(s->w, s->shape, neighbour);
    for (int k = 0; k < 4; k++) {
        double x = parts->x[k], y = parts->y[k];
        if (td_neighbour_contains(s, neighbour, &other, x, y, width)) {
            unsigned bit = td_corner_bit(k & 1, k >> 1 & 1);
            corners |= bit;
            hidden |= solid && flattens_corner(s, neighbour, &other, k, x, y) ? bit : 0;
        }
    }
    for (int f = 0; f < TD_FACES; f++) {
        bool covered = td_neighbour_overlaps(s, neighbour, &other, &parts->strip[f]);
        internal_edges |= (unsigned)covered << f;
        /* A convex shape that contains both ends of a face contains all of it. */
        bool whole = covered && solid && (corners & corners_of_face(f)) == corners_of_face(f);
        hidden |= (unsigned)whole << f;
    }
    set_masks(s->w, s->shape, internal_edges | corners, hidden);
    return false;
}

/* Adds the bits of all neighbours to the masks of a box. The caller has set the masks to 0. */
static void find_masks(const td_neighbourhood *s) {
    box_parts parts;
    parts.known = false;
    td_neighbour_any(s, &s->a, add_neighbour_bits, &parts);
}

/* The bits of the ends of a terrain's line that a neighbour seals: the neighbour contains the place
 * just outside and below the end vertex, so that the ground's upright side there cannot be met. */
static uint8_t sealed_ends(const td_neighbourhood *s, int terrain_shape, int neighbour) {
    thud_terrain t = td_terrain_view(s->w, terrain_shape);
    thud_geometry at = td_shape_instance(s->w, terrain_shape, s->origin);
    thud_geometry other = td_neighbour_instance(s, neighbour);
    double out = TD_NEIGHBOUR_GAP * s->length_scale;
    if (t.kind == THUD_TERRAIN_FLAT) {
        return 0;
    }
    double right = td_terrain_x(&t, t.count - 1), left = td_terrain_x(&t, 0);
    double last = t.points[t.count - 1].y, first = t.points[0].y;
    bool at_right =
        td_neighbour_contains(s, neighbour, &other, at.x + right + out, at.y + last - out, out);
    bool at_left =
        td_neighbour_contains(s, neighbour, &other, at.x + left - out, at.y + first - out, out);
    return (uint8_t)(at_right << TD_FACE_RIGHT | at_left << TD_FACE_LEFT);
}

/* Room for the broadphase's results in td_neighbour_any, so that it does not fail. False when
 * memory is short. */
static bool reserve_hits(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.found_shapes,
                            3 * w->rest_shapes.ids.count + 4 * TD_LANES);
}

bool td_internal_edges_see(thud_world *w, int shape) {
    td_neighbourhood s = td_neighbourhood_of(w, shape, TD_NONE);
    if (!reserve_hits(w)) {
        return false;
    }
    td_shape_at(w, shape)->flags &= (uint8_t)~TD_SHAPE_UNSEEN;
    set_masks(w, shape, 0, 0);
    find_masks(&s);
    return true;
}

/* Marks a box as not inspected. Until it is, every bit of its mask is set. */
static void mark_unseen(thud_world *w, int shape) {
    td_shape *s = td_shape_at(w, shape);
    if (td_kind_is_box(s->kind)) {
        s->flags |= TD_SHAPE_UNSEEN;
        set_masks(w, shape, 0xff, 0);
    }
}

/* Whether a shape must be inspected now rather than at its first contact, since its body has some
 * already. */
static bool needs_masks(const thud_world *w, int shape) {
    const td_shape *s = td_shape_at(w, shape);
    return (s->flags & TD_SHAPE_UNSEEN) && td_body_at(w, s->body)->first_constraint != TD_NONE;
}

/* A td_neighbour_fn: stores a neighbour that must be inspected now in *context (int). */
static bool find_due(const td_neighbourhood *s, int neighbour, void *context) {
    bool due = needs_masks(s->w, neighbour);
    *(int *)context = due ? neighbour : *(int *)context;
    return due;
}

/* A td_neighbour_fn: marks a neighbour of a shape that is new or has moved as unseen. If the shape
 * or the neighbour is a terrain, its sealed ends are found at once, since terrains are few. */
static bool mark_neighbour(const td_neighbourhood *s, int neighbour, void *context) {
    int pair[] = {s->shape, neighbour};
    for (int i = 0; i < 2; i++) {
        if (td_kind_is_line(td_shape_at(s->w, pair[i])->kind)) {
            unsigned ends = sealed_ends(s, pair[i], pair[!i]);
            set_masks(s->w, pair[i], td_shape_at(s->w, pair[i])->internal_edges | ends, 0);
        }
    }
    mark_unseen(s->w, neighbour);
    find_due(s, neighbour, context);
    return false;
}

/* Whether all resting shapes are new or have moved in this step, as in a world's first step. Then
 * td_internal_edges_find is called for each of them, and need not look for its neighbours. False in
 * a world with terrains, which are not in the set of resting shapes. */
static bool all_are_new(const thud_world *w) {
    return w->terrains.live == 0 &&
           w->moved.count - w->awake_shapes.moved_count == w->rest_shapes.ids.count;
}

/* For a terrain that is new or has moved, all resting shapes are marked, not only those near it:
 * terrains are few. */
bool td_internal_edges_find(thud_world *w, int shape) {
    int due = TD_NONE;
    if (!td_is_ground(w, shape)) {
        return true;
    }
    if (all_are_new(w)) {
        mark_unseen(w, shape);
        return !needs_masks(w, shape) || td_internal_edges_see(w, shape);
    }
    td_neighbourhood s = td_neighbourhood_of(w, shape, TD_NONE);
    if (td_kind_is_line(s.a.kind)) {
        for (int i = 0; i < w->rest_shapes.ids.count; i++) {
            int n = td_int_at(&w->rest_shapes.ids, i);
            if (n == TD_NONE || !td_is_ground(w, n)) {
                continue;
            }
            mark_neighbour(&s, n, &due);
            if (due == n && !td_internal_edges_see(w, n)) {
                return false;
            }
        }
    }
    if (!reserve_hits(w)) {
        return false;
    }
    due = TD_NONE;
    mark_unseen(w, shape);
    td_neighbour_any(&s, &s.a, mark_neighbour, &due);
    find_due(&s, shape, &due);
    while (due != TD_NONE) {
        if (!td_internal_edges_see(w, due)) {
            return false;
        }
        due = TD_NONE;
        td_neighbour_any(&s, &s.a, find_due, &due);
    }
    return true;
}

/* A td_neighbour_fn: clears the masks of a neighbour and marks it as moved. */
static bool reset_neighbour(const td_neighbourhood *s, int neighbour, void *context) {
    (void)context;
    set_masks(s->w, neighbour, 0, 0);
    td_shape_mark_moved(s->w, neighbour);
    return false;
}

/* The set of resting shapes is that of the last step; a shape that came since then is in the list
 * of moved shapes, and gets its masks from td_internal_edges_find. */
bool td_internal_edges_lose(thud_world *w, td_body_index body) {
    int i = td_body_at(w, body)->first_shape;
    if (td_body_at(w, body)->kind != THUD_BODY_STATIC || i == TD_NONE) {
        return true;
    }
    if (!reserve_hits(w)) {
        return false;
    }
    for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (td_shape_at(w, i)->internal_edges) {
            td_neighbourhood s = td_neighbourhood_of(w, i, TD_NONE);
            td_neighbour_any(&s, &s.a, reset_neighbour, NULL);
            set_masks(w, i, 0, 0);
        }
    }
    return true;
}

void td_internal_edges_join(thud_world *w, td_body_index body) {
    const td_body *b = td_body_at(w, body);
    for (int i = b->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (td_kind_is_box(shape->kind) && !(shape->flags & TD_SHAPE_HOLLOW)) {
            td_neighbourhood s = td_neighbourhood_of(w, i, TD_NONE);
            set_masks(w, i, 0, 0);
            find_masks(&s);
        }
    }
}
