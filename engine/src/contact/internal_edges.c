/* internal_edges.c: corrects contacts at internal edges (internal_edges.h).
 *
 * A contact with a normal n is a ghost where n is not a normal of the surface that the shape and
 * its neighbours form together:
 * - n is a face's, and neighbours cover the part of the face that the other shape can touch
 *   (face_hidden);
 * - n is a corner's, and a neighbour contains the corner and extends past it along n
 *   (corner_hidden).
 *
 * A circle's ghost is removed: the neighbour has the right contact. For two boxes the narrowphase
 * may have chosen a wrong axis, so that the separating axis test is made again without the hidden
 * ones (box_faces.h), and the contact is removed where no axis is left.
 *
 * The masks of td_shape answer most cases without a search for neighbours. */
#include "contact/internal_edges.h"

#include "contact/contact.h"
#include "constraint/lanes.h"
#include "contact/edge_neighbours.h"
#include "contact/box_faces.h"
#include "state/shape.h"

/* A neighbour hides a corner only if it extends past it by at least this, in length scales. Chosen;
 * not tuned. */
#define CORNER_RISE_MIN 1e-4
/* A normal counts as that of a face if the sine of the angle between the two is at most this.
 * Larger than the rounding error of single precision; chosen, not tuned. */
#define FACE_SINE_MAX 1e-5
/* FACE_SINE_MAX for two boxes that both have neighbours, if the normal is that of a face of one,
 * and is compared with the faces of the other. It is larger, since two boxes that rest flat on each
 * other are not exactly parallel. Chosen; not tuned. */
#define RESTING_FACE_SINE_MAX 0.01
/* The part of a face that must be covered is longer at each end than the part that the other shape
 * takes up, by this share of that shape's half thickness. Chosen; not tuned. */
#define COVER_MARGIN 0.05
/* A contact takes over the impulses of another one (transfer_impulses) only if the cosine of the
 * angle between their normals is at least this: about 26 degrees. Chosen. */
#define SAME_NORMAL_COSINE_MIN 0.9f

/* ---- which normals are hidden ---- */

/* A place on the surface of a shape, in the frame of the td_neighbourhood: within a face, or a
 * corner with a unit normal there. */
typedef struct probe {
    double x, y, nx, ny;
    bool corner;
} probe;

/* A td_neighbour_fn: whether the neighbour contains the place, and extends past a corner along the
 * normal. `context`: a probe. */
static bool covers(const td_neighbourhood *s, int neighbour, void *context) {
    const probe *p = context;
    thud_geometry n = td_neighbour_instance(s, neighbour);
    return td_neighbour_contains(s, neighbour, &n, p->x, p->y,
                                 (p->corner ? 1.0 : 0.5) * TD_NEIGHBOUR_GAP * s->length_scale) &&
           (!p->corner || td_neighbour_extends(s, neighbour, &n, p->x, p->y, p->nx, p->ny,
                                               CORNER_RISE_MIN * s->length_scale));
}

/* Whether some neighbour covers the place of `p`. Only neighbours whose bounds contain that point
 * are asked: no other one covers it. */
static bool is_covered(const td_neighbourhood *s, probe *p) {
    thud_geometry place = {.kind = THUD_SHAPE_CIRCLE, .x = p->x, .y = p->y, .c = 1.0};
    return td_neighbour_any(s, &place, covers, p);
}

/* Whether neighbours cover all of a face between the coordinates `from` and `to` along it. Four
 * places are tested: both ends, with a margin, the middle, and the coordinate `deepest` of the
 * other shape's deepest point. They lie outside of the face by twice TD_NEIGHBOUR_GAP, where a
 * neighbour whose own face is in line with this one does not reach. Coordinates are in the frame of
 * the box. */
static bool face_hidden(const td_neighbourhood *s, int face, double from, double to,
                        double deepest) {
    double half = face % 2 ? s->a.hx : s->a.hy, out = face % 2 ? s->a.hy : s->a.hx;
    double margin = COVER_MARGIN * td_kind_half_thickness(s->b.kind, s->b.hx, s->b.hy);
    out += 2.0 * TD_NEIGHBOUR_GAP * s->length_scale;
    out = face >= 2 ? -out : out;
    from = td_clamp(from - margin, -half, half);
    to = td_clamp(to + margin, -half, half);
    double at[] = {from, 0.5 * (from + to), to, td_clamp(deepest, -half, half)};
    for (int i = 0; i < 4; i++) {
        double x, y;
        td_from_frame(&s->a, face % 2 ? at[i] : out, face % 2 ? out : at[i], &x, &y);
        probe p = {.x = s->a.x + x, .y = s->a.y + y};
        if (!is_covered(s, &p)) {
            return false;
        }
    }
    return true;
}

/* The feature of a box that a normal belongs to: a face, or a corner. */
typedef struct contact_feature {
    int face;        /* the face; TD_NONE: a corner */
    bool right, top; /* the corner */
    unsigned bit;    /* its bit in td_shape.internal_edges and .hidden */
} contact_feature;

/* The feature of a box with rotation (c, s) for a unit normal out of the box. `straight`: sine of
 * the angle up to which a normal counts as a face's. */
static contact_feature feature_of(double c, double s, double nx, double ny, double straight) {
    double u = c * nx + s * ny, v = c * ny - s * nx;
    contact_feature at = {.face = TD_NONE, .right = u > 0.0, .top = v > 0.0};
    if (td_abs(u) > straight && td_abs(v) > straight) {
        at.bit = td_corner_bit(at.right, at.top);
        return at;
    }
    at.face = td_abs(u) > td_abs(v) ? (at.right ? TD_FACE_RIGHT : TD_FACE_LEFT)
                                    : (at.top ? TD_FACE_TOP : TD_FACE_BOTTOM);
    at.bit = 1u << at.face;
    return at;
}

/* Whether some neighbour hides the corner for the outward normal (nx, ny). */
static bool corner_hidden(const td_neighbourhood *s, const contact_feature *at, double nx,
                          double ny) {
    double x, y;
    td_from_frame(&s->a, at->right ? s->a.hx : -s->a.hx, at->top ? s->a.hy : -s->a.hy, &x, &y);
    probe p = {s->a.x + x, s->a.y + y, nx, ny, true};
    return is_covered(s, &p);
}

/* Whether the part of a face that the other shape's projection onto the face takes up is hidden. In
 * the frame of the face's box: `middle` is the coordinate of the other shape's centre along the
 * face, `half` its half extent there (0 for a circle, which touches at one place), and `deepest`
 * the coordinate, from `middle`, of its corner that lies furthest against the face's normal. */
static bool touched_part_hidden(const td_neighbourhood *s, int face) {
    double u, v, half = 0.0, deepest = 0.0;
    td_to_frame(&s->a, s->b.x - s->a.x, s->b.y - s->a.y, &u, &v);
    double middle = face % 2 ? u : v;
    if (td_kind_is_box(s->b.kind)) {
        double nx, ny, p, q;
        half = face % 2 ? td_projected_extent(&s->b, s->a.c, s->a.s)
                        : td_projected_extent(&s->b, -s->a.s, s->a.c);
        td_from_frame(&s->a, face % 2 ? 0.0 : 1.0, face % 2 ? 1.0 : 0.0, &nx, &ny);
        td_to_frame(&s->b, face >= 2 ? nx : -nx, face >= 2 ? ny : -ny, &u, &v);
        td_from_frame(&s->b, u < 0.0 ? -s->b.hx : s->b.hx, v < 0.0 ? -s->b.hy : s->b.hy, &p, &q);
        td_to_frame(&s->a, p, q, &u, &v);
        deepest = face % 2 ? u : v;
    }
    return face_hidden(s, face, middle - half, middle + half, middle + deepest);
}

/* Whether the outward unit normal (nx, ny) of the shape, in its neighbourhood's frame, is
 * hidden. */
static bool is_ghost(const td_neighbourhood *s, double nx, double ny, double straight) {
    const td_shape *shape = td_shape_at(s->w, s->shape);
    contact_feature at = feature_of(s->a.c, s->a.s, nx, ny, straight);
    if (!(shape->internal_edges & at.bit) || (shape->hidden & at.bit)) {
        return shape->hidden & at.bit;
    }
    return at.face == TD_NONE ? corner_hidden(s, &at, nx, ny) : touched_part_hidden(s, at.face);
}

/* A quick test by the masks alone, in single precision: whether the contact of a lane is at a face
 * or corner of shape a that has no neighbour. Most are. If it returns false, the feature may be
 * hidden, and is_ghost has to decide. Against rounding, a normal counts as a corner's from half of
 * FACE_SINE_MAX on, and then the nearest face has to be without a neighbour as well. */
static bool is_open(const thud_world *w, const td_block *block, int lane) {
    const td_shape_proxy *a = td_shape_proxy_at(w, block->shape_a[lane]);
    float nx = block->nx[lane], ny = block->ny[lane];
    if (nx == 0.0f && a->s == 0.0f) { /* above or below an upright box: a short cut */
        unsigned upright = a->c * ny > 0.0f ? TD_FACE_TOP : TD_FACE_BOTTOM;
        return !(block->mark[lane].internal_edges >> upright & 1);
    }
    float u = a->c * nx + a->s * ny, v = a->c * ny - a->s * nx;
    float x = u < 0.0f ? -u : u, y = v < 0.0f ? -v : v;
    unsigned face = x > y ? (u > 0.0f ? TD_FACE_RIGHT : TD_FACE_LEFT)
                          : (v > 0.0f ? TD_FACE_TOP : TD_FACE_BOTTOM);
    bool corner = x > 0.5f * (float)FACE_SINE_MAX && y > 0.5f * (float)FACE_SINE_MAX;
    unsigned bits = corner ? td_corner_bit(u > 0.0f, v > 0.0f) | 1u << face : 1u << face;
    return !(block->mark[lane].internal_edges & bits);
}

/* Whether (nx, ny) is a normal of a face of the box, up to rounding. */
static bool is_face_normal(const thud_geometry *box, double nx, double ny) {
    return feature_of(box->c, box->s, nx, ny, FACE_SINE_MAX).face != TD_NONE;
}

/* The sides of a pair that have internal edges: none, one or both. */
typedef struct sides {
    const td_internal_edge_pair *pair;
    int count;
    td_neighbourhood neighbourhood[2];
    double sign[2]; /* 1 or -1: the factor by which a normal from shape 0 to shape 1 is multiplied
                       to point out of this side's shape */
} sides;

/* Terrains are left out: terrain_manifold.c takes their sealed ends into account. */
static void set_sides(sides *s, const td_internal_edge_pair *p) {
    s->pair = p;
    s->count = 0;
    for (int i = 0; i < 2; i++) {
        const td_shape *shape = td_shape_at(p->w, p->shape[i]);
        if (shape->internal_edges && !td_kind_is_line(shape->kind)) {
            td_neighbourhood_between(&s->neighbourhood[s->count], p->w, p->shape[i], p->shape[!i],
                                     &p->placed[i], &p->placed[!i]);
            s->sign[s->count++] = i ? -1.0 : 1.0;
        }
    }
}

/* A td_axis_hidden_fn: whether the normal (nx, ny), from shape 0 to shape 1, is hidden for at least
 * one of the two shapes. `context`: sides. */
static bool is_hidden(double nx, double ny, void *context) {
    const sides *s = context;
    const thud_geometry *placed = s->pair->placed;
    bool face =
        s->count > 1 && (is_face_normal(&placed[0], nx, ny) || is_face_normal(&placed[1], nx, ny));
    bool hidden = false;
    for (int i = 0; i < s->count && !hidden; i++) {
        const td_neighbourhood *neighbourhood = &s->neighbourhood[i];
        double x = s->sign[i] * nx, y = s->sign[i] * ny;
        if (neighbourhood->moves) {
            td_to_frame(&(thud_geometry){.c = neighbourhood->c, .s = neighbourhood->s}, x, y, &x,
                        &y);
        }
        hidden = is_ghost(neighbourhood, x, y, face ? RESTING_FACE_SINE_MAX : FACE_SINE_MAX);
    }
    return hidden;
}

/* td_internal_edge_ops.is_ghost. */
static bool is_ghost_of(const td_internal_edge_pair *p, double nx, double ny) {
    sides s;
    set_sides(&s, p);
    return is_hidden(nx, ny, &s);
}

/* ---- correcting a lane ---- */

/* Removes all points of a lane, with their impulses, so that it does nothing and does not touch. */
static void clear_points(td_block *block, int points, int lane) {
    for (int k = 0; k < points; k++) {
        td_point *p = &block->point[k];
        p->normal_mass[lane] = p->normal_impulse[lane] = 0.0f;
        p->separation[lane] = p->start_separation[lane] = TD_APART;
    }
    block->tangent_mass[lane] = block->tangent_impulse[lane] = 0.0f;
    block->touching &= ~(1u << lane);
}

/* The effective mass 1 / k, for the inverse mass k along a row; 0 where k is 0, since neither body
 * can be moved. */
static float inverse_or_zero(float k) {
    return k > 0.0f ? 1.0f / k : 0.0f;
}

/* Writes a manifold into a lane, as td_write_points (wide_collide.h) does for eight. Places in `c`
 * are relative to the centre of shape a. Impulses of the lane are kept if the normal has hardly
 * changed. */
static void write_lane(thud_world *w, td_block *block, int kind, int lane,
                       const td_internal_edge_contact *c) {
    int points = td_form_points(w->kinds[kind]->form);
    const td_shape_proxy *b = td_shape_proxy_at(w, block->shape_b[lane]),
                         *a = td_shape_proxy_at(w, block->shape_a[lane]);
    const float *va = (const float *)w->velocity.data + block->a[lane] / sizeof(float);
    const float *vb = (const float *)w->velocity.data + block->b[lane] / sizeof(float);
    float nx = (float)c->nx, ny = (float)c->ny, mid_x = 0.0f, mid_y = 0.0f;
    /* (dx, dy): from b's centre of mass to the centre of shape a. */
    float dx = (float)((double)(a->center.x - b->center.x) / w->to_fixed) + b->x;
    float dy = (float)((double)(a->center.y - b->center.y) / w->to_fixed) + b->y;
    float ia = block->inv_inertia_a[lane], ib = block->inv_inertia_b[lane], mass = va[3] + vb[3];
    bool a_static = block->a[lane] == 0;
    float to_a_x = a->x - dx, to_a_y = a->y - dy; /* from a's centre of mass to that of b */
    float ax = a_static ? 0.0f : to_a_x, ay = a_static ? 0.0f : to_a_y;
    float impulse[3] = {block->tangent_impulse[lane], block->point[0].normal_impulse[lane],
                        block->point[points - 1].normal_impulse[lane]};
    float cosine = nx * block->nx[lane] + ny * block->ny[lane];
    td_manifold_cache *kept =
        w->kinds[kind]->form == TD_FORM_TWO_CACHED ? td_manifold_cache_of(block, points) : NULL;
    if (kept) { /* the cache is valid from the present pose on; the old manifold may be of an
                   earlier one */
        kept->dx[lane] = to_a_x, kept->dy[lane] = to_a_y;
        kept->ac[lane] = a->c, kept->as[lane] = a->s;
        kept->bc[lane] = b->c, kept->bs[lane] = b->s;
    }
    clear_points(block, points, lane);
    block->nx[lane] = nx;
    block->ny[lane] = ny;
    int count = points < c->count ? points : c->count;
    for (int k = 0; k < count; k++) {
        td_point *p = &block->point[k];
        float x = dx + (float)c->x[k], y = dy + (float)c->y[k],
              separation = (float)c->separation[k];
        float cross = x * ny - y * nx, cross_a = a_static ? 0.0f : (ax + x) * ny - (ay + y) * nx;
        p->separation[lane] = p->start_separation[lane] = separation - w->skin;
        p->cross_a[lane] = cross_a;
        p->cross_b[lane] = cross;
        p->normal_impulse[lane] = cosine > SAME_NORMAL_COSINE_MIN ? impulse[1 + k] : 0.0f;
        p->normal_mass[lane] = inverse_or_zero(mass + ib * cross * cross + ia * cross_a * cross_a);
        td_history_of(block, points)[k].normal_velocity[lane] =
            (vb[0] - va[0]) * nx + (vb[1] - va[1]) * ny + vb[2] * cross - va[2] * cross_a;
        if (kept) {
            kept->separation[k][lane] = p->start_separation[lane];
        }
        mid_x += x / (float)count;
        mid_y += y / (float)count;
    }
    float turn = -(mid_x * nx + mid_y * ny);
    float turn_a = a_static ? 0.0f : -((ax + mid_x) * nx + (ay + mid_y) * ny);
    block->tangent_cross_a[lane] = turn_a;
    block->tangent_cross_b[lane] = turn;
    block->tangent_mass[lane] = inverse_or_zero(mass + ib * turn * turn + ia * turn_a * turn_a);
    block->tangent_impulse[lane] = cosine > SAME_NORMAL_COSINE_MIN ? impulse[0] : 0.0f;
    block->touching |= 1u << lane;
}

/* Replaces the points of a contact by their middle, for kinds of one point. */
static void average_points(td_internal_edge_contact *c) {
    c->x[0] = 0.5 * (c->x[0] + c->x[c->count - 1]);
    c->y[0] = 0.5 * (c->y[0] + c->y[c->count - 1]);
    c->separation[0] = 0.5 * (c->separation[0] + c->separation[c->count - 1]);
    c->count = 1;
}

/* Whether the shapes of both contacts on one side (0: a, 1: b) form one surface: they belong to one
 * body, or both to static bodies. */
static bool same_surface(const thud_world *w, const td_contact *to, const td_contact *from,
                         int side) {
    return td_same_body(to->body[side], from->body[side]) ||
           (td_body_at(w, to->body[side])->kind == THUD_BODY_STATIC &&
            td_body_at(w, from->body[side])->kind == THUD_BODY_STATIC);
}

/* Moves the impulses of a lane that is about to be cleared to a contact of the same kind between
 * the same moving shape and a neighbour, if that has a similar normal and no impulse yet. Without a
 * warm start the shape would sink in a little as it slides from one tile to the next. */
static void transfer_impulses(thud_world *w, td_block *block, int kind, int lane) {
    const td_contact *from = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[kind]->form);
    int e = td_body_at(w, from->body[1])->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *to = td_constraint_at(w, td_edge_constraint(e));
        bool continues = (to->shape_b == from->shape_b && same_surface(w, to, from, 0)) ||
                         (to->shape_a == from->shape_a && same_surface(w, to, from, 1));
        if (to == from || to->kind != kind || to->state != TD_TOUCHING || !continues) {
            continue;
        }
        td_lane at = td_lane_of(w, to);
        float cosine =
            at.block->nx[at.lane] * block->nx[lane] + at.block->ny[at.lane] * block->ny[lane];
        if (cosine > SAME_NORMAL_COSINE_MIN && at.block->point[0].normal_impulse[at.lane] == 0.0f) {
            for (int k = 0; k < points; k++) {
                at.block->point[k].normal_impulse[at.lane] = block->point[k].normal_impulse[lane];
            }
            at.block->tangent_impulse[at.lane] = block->tangent_impulse[lane];
            return;
        }
    }
}

/* td_internal_edge_ops.contact. */
static bool open_contact(const td_internal_edge_pair *p, td_internal_edge_contact *contact) {
    const thud_geometry *a = &p->placed[0], *b = &p->placed[1];
    sides s;
    set_sides(&s, p);
    return td_kind_is_box(a->kind) && td_kind_is_box(b->kind) &&
           td_box_contact_on_open_axis(a, b, (double)(TD_SPECULATIVE * p->w->length_scale),
                                       is_hidden, &s, contact);
}

/* Replaces the manifold of a lane that is at a hidden feature, or clears the lane. */
static void correct_lane(thud_world *w, td_block *block, int kind, int lane) {
    int a = block->shape_a[lane], b = block->shape_b[lane];
    td_position origin = td_shape_proxy_at(w, a)->center;
    td_internal_edge_pair pair = {
        w, {a, b}, {td_shape_instance(w, a, origin), td_shape_instance(w, b, origin)}};
    if (!is_ghost_of(&pair, (double)block->nx[lane], (double)block->ny[lane])) {
        return;
    }
    int points = td_form_points(w->kinds[kind]->form);
    td_internal_edge_contact contact;
    if (!open_contact(&pair, &contact)) {
        if (block->constraint[lane] != TD_NONE &&
            td_contact_at(w, block->constraint[lane])->state == TD_TOUCHING) {
            transfer_impulses(w, block, kind, lane);
        }
        clear_points(block, points, lane);
        return;
    }
    if (points == 1) {
        average_points(&contact);
    }
    write_lane(w, block, kind, lane, &contact);
}

/* td_internal_edge_ops.amend. */
static void correct_block(thud_world *w, td_block *block, int kind) {
    /* terrain_manifold.c takes the sealed ends of lines into account. */
    int lanes = td_pair_is_on_line(kind) ? 0 : block->used;
    for (int lane = 0; lane < lanes; lane++) {
        if (block->mark[lane].internal_edges && (block->touching >> lane & 1) &&
            !is_open(w, block, lane)) {
            correct_lane(w, block, kind, lane);
        }
    }
}

/* Skips the runs of two moving bodies without offsets: a block in which a moving shape has
 * internal edges is marked as having offsets (contact_lanes.c). */
static void amend_all(thud_world *w) {
    td_block *const *blocks = w->scratch.blocks.data;
    td_block **separated = w->scratch.separated.data;
    for (int r = 0; r < w->scratch.runs.count; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        int count = run->a_static || run->has_offsets ? run->count : 0;
        for (int i = run->first; i < run->first + count; i++) {
            td_block *block = blocks[i];
            bool whole = block->touching == (1u << block->used) - 1u;
            correct_block(w, block, run->kind);
            if (whole && block->touching != (1u << block->used) - 1u) {
                separated[w->scratch.separated.count++] = block;
            }
        }
    }
}

const td_internal_edge_ops td_internal_edges = {td_internal_edges_find,
                                                td_internal_edges_see,
                                                td_internal_edges_lose,
                                                td_internal_edges_join,
                                                correct_block,
                                                amend_all,
                                                is_ghost_of,
                                                open_contact};
