/* internal_edges.c: see internal_edges.h.
 *
 * A contact is a ghost where its normal is not one of the ground as a whole: where the place of its
 * shape is covered by a neighbour, or is a corner that a neighbour goes past in the direction of
 * the normal. Circles then have no contact with that shape: the neighbour has one. Boxes may only
 * have chosen the wrong axis of several: the separating axes are searched again without hidden
 * faces. */
#include "contact/internal_edges.h"

#include "contact/contact.h"
#include "constraint/lanes.h"
#include "contact/edge_neighbours.h"
#include "contact/box_faces.h"
#include "state/shape.h"

/* In length scales: a corner is flat where no neighbour rises further than this above it. */
#define LEVEL 1e-4
/* A normal off by less than this, in radians, is a face's. */
#define STRAIGHT 1e-5
/* The same where both shapes have neighbours: a normal of a face of the one is a face's of the
 * other if it is off by less than this. */
#define NEARLY_STRAIGHT 0.01
/* Beyond each end of what touches, so much of the other shape's size has to be covered too. */
#define BEYOND 0.05
/* Cosine between normals that go on bearing what another bore. */
#define ALIKE 0.9f

/* ---- ghosts ---- */

typedef struct probe {
    double x, y, nx, ny;
} probe;

static bool covers(const td_internal_edge *s, int neighbour, void *context) {
    const probe *p = context;
    thud_shape_instance n = td_internal_edge_place(s, neighbour);
    return td_internal_edge_holds(s, neighbour, &n, p->x, p->y, 0.5 * TD_FLUSH * s->unit);
}

static bool hides_corner(const td_internal_edge *s, int neighbour, void *context) {
    const probe *p = context;
    thud_shape_instance n = td_internal_edge_place(s, neighbour);
    return td_internal_edge_holds(s, neighbour, &n, p->x, p->y, TD_FLUSH * s->unit) &&
           td_internal_edge_rises(s, neighbour, &n, p->x, p->y, p->nx, p->ny, LEVEL * s->unit);
}

/* A shape that covers a place touches the point there, so that no others need to be asked. */
static bool any_at(const td_internal_edge *s, td_neighbour_fn *fn, probe *p) {
    thud_shape_instance place = {.kind = THUD_CIRCLE, .x = p->x, .y = p->y, .c = 1.0};
    return td_internal_edge_any(s, &place, fn, p);
}

/* Whether what touches a face between two places along it, and deepest at a third, in the box's
 * frame, meets nothing open. */
static bool face_hidden(const td_internal_edge *s, int face, double from, double to,
                        double deepest) {
    double half = face % 2 ? s->a.hx : s->a.hy, out = face % 2 ? s->a.hy : s->a.hx;
    double beyond = BEYOND * td_kind_half_thickness(s->b.kind, s->b.hx, s->b.hy);
    out += 2.0 * TD_FLUSH * s->unit;
    out = face >= 2 ? -out : out;
    from = td_clamp(from - beyond, -half, half);
    to = td_clamp(to + beyond, -half, half);
    double at[] = {from, 0.5 * (from + to), to, td_clamp(deepest, -half, half)};
    for (int i = 0; i < 4; i++) {
        double x, y;
        td_from_frame(&s->a, face % 2 ? at[i] : out, face % 2 ? out : at[i], &x, &y);
        probe p = {s->a.x + x, s->a.y + y, 0.0, 0.0};
        if (!any_at(s, covers, &p)) {
            return false;
        }
    }
    return true;
}

/* Where the first box is met along a normal: at one of its faces, or at a corner. */
typedef struct site {
    int face;        /* or TD_NONE */
    bool right, top; /* of a corner */
    unsigned bit;    /* of td_shape.hidden */
} site;

static site site_of(double c, double s, double nx, double ny, double straight) {
    double u = c * nx + s * ny, v = c * ny - s * nx;
    site at = {.face = TD_NONE, .right = u > 0.0, .top = v > 0.0};
    if (td_abs(u) > straight && td_abs(v) > straight) {
        at.bit = td_corner_bit(at.right, at.top);
        return at;
    }
    at.face = td_abs(u) > td_abs(v) ? (at.right ? TD_FACE_RIGHT : TD_FACE_LEFT)
                                    : (at.top ? TD_FACE_TOP : TD_FACE_BOTTOM);
    at.bit = 1u << at.face;
    return at;
}

/* A normal at a corner of the first box. */
static bool corner_hidden(const td_internal_edge *s, const site *at, double nx, double ny) {
    double x, y;
    td_from_frame(&s->a, at->right ? s->a.hx : -s->a.hx, at->top ? s->a.hy : -s->a.hy, &x, &y);
    probe p = {s->a.x + x, s->a.y + y, nx, ny};
    return any_at(s, hides_corner, &p);
}

/* Whether the part of a face that the second box or circle takes up is hidden. */
static bool shadow_hidden(const td_internal_edge *s, int face) {
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

/* Whether the first shape cannot be met along a normal. */
static bool is_ghost(const td_internal_edge *s, double nx, double ny, double straight) {
    const td_shape *shape = td_shape_at(s->w, s->shape);
    site at = site_of(s->a.c, s->a.s, nx, ny, straight);
    if (!(shape->internal_edges & at.bit) || (shape->hidden & at.bit)) {
        return shape->hidden & at.bit;
    }
    return at.face == TD_NONE ? corner_hidden(s, &at, nx, ny) : shadow_hidden(s, at.face);
}

/* Most lanes are met where nothing stands: told in single precision, without looking around. */
static bool is_plain(const thud_world *w, const td_block *block, int lane) {
    const td_shape_proxy *a = td_shape_proxy_at(w, block->shape_a[lane]);
    float nx = block->nx[lane], ny = block->ny[lane];
    float u = a->c * nx + a->s * ny, v = a->c * ny - a->s * nx;
    float x = u < 0.0f ? -u : u, y = v < 0.0f ? -v : v;
    unsigned face = x > y ? (u > 0.0f ? TD_FACE_RIGHT : TD_FACE_LEFT)
                          : (v > 0.0f ? TD_FACE_TOP : TD_FACE_BOTTOM);
    bool corner = x > 0.5f * (float)STRAIGHT && y > 0.5f * (float)STRAIGHT;
    unsigned bits = corner ? td_corner_bit(u > 0.0f, v > 0.0f) | 1u << face : 1u << face;
    return !(block->mark[lane].internal_edges & bits);
}

static bool looks_out(const thud_shape_instance *box, double nx, double ny) {
    return site_of(box->c, box->s, nx, ny, STRAIGHT).face != TD_NONE;
}

/* Either shape may be the one that has neighbours. */
typedef struct sides {
    const td_internal_edge_pair *pair;
    int count;
    td_internal_edge internal_edge[2];
    double sign[2]; /* of a normal as the side sees it */
} sides;

static sides sides_of(const td_internal_edge_pair *p) {
    sides s = {.pair = p};
    for (int i = 0; i < 2; i++) {
        const td_shape *shape = td_shape_at(p->w, p->shape[i]);
        if (shape->internal_edges && !td_kind_is_line(shape->kind)) {
            s.internal_edge[s.count] = td_internal_edge_between(p->w, p->shape[i], p->shape[!i],
                                                                &p->placed[i], &p->placed[!i]);
            s.sign[s.count++] = i ? -1.0 : 1.0;
        }
    }
    return s;
}

static bool is_hidden(double nx, double ny, void *context) {
    const sides *s = context;
    const thud_shape_instance *placed = s->pair->placed;
    bool face = s->count > 1 && (looks_out(&placed[0], nx, ny) || looks_out(&placed[1], nx, ny));
    bool hidden = false;
    for (int i = 0; i < s->count && !hidden; i++) {
        const td_internal_edge *internal_edge = &s->internal_edge[i];
        double x = s->sign[i] * nx, y = s->sign[i] * ny;
        if (internal_edge->moves) {
            td_to_frame(&(thud_shape_instance){.c = internal_edge->c, .s = internal_edge->s}, x, y,
                        &x, &y);
        }
        hidden = is_ghost(internal_edge, x, y, face ? NEARLY_STRAIGHT : STRAIGHT);
    }
    return hidden;
}

static bool is_ghost_of(const td_internal_edge_pair *p, double nx, double ny) {
    sides s = sides_of(p);
    return is_hidden(nx, ny, &s);
}

/* ---- amending a lane ---- */

/* No lane has a point of its own after this. */
static void drop(td_block *block, int points, int lane) {
    for (int k = 0; k < points; k++) {
        td_point *p = &block->point[k];
        p->normal_mass[lane] = p->normal_impulse[lane] = 0.0f;
        p->separation[lane] = p->base[lane] = TD_APART;
    }
    block->tangent_mass[lane] = block->tangent_impulse[lane] = 0.0f;
    block->touching &= ~(1u << lane);
}

static float inverse_or_zero(float k) {
    return k > 0.0f ? 1.0f / k : 0.0f;
}

/* Does for one lane what td_write_points does for eight. */
static void write_lane(thud_world *w, td_block *block, int kind, int lane,
                       const td_internal_edge_contact *c) {
    int points = td_form_points(w->kinds[kind]->form);
    const td_shape_proxy *b = td_shape_proxy_at(w, block->shape_b[lane]),
                         *a = td_shape_proxy_at(w, block->shape_a[lane]);
    const float *va = (const float *)w->velocity.data + block->a[lane] / sizeof(float);
    const float *vb = (const float *)w->velocity.data + block->b[lane] / sizeof(float);
    float nx = (float)c->nx, ny = (float)c->ny, mid_x = 0.0f, mid_y = 0.0f;
    float dx = (float)((double)(a->center.x - b->center.x) / w->to_fixed) + b->x;
    float dy = (float)((double)(a->center.y - b->center.y) / w->to_fixed) + b->y;
    float ia = block->inv_inertia_a[lane], ib = block->inv_inertia_b[lane], mass = va[3] + vb[3];
    bool fixed = block->a[lane] == 0;
    float apart_x = a->x - dx, apart_y = a->y - dy; /* the centres of mass */
    float ax = fixed ? 0.0f : apart_x, ay = fixed ? 0.0f : apart_y;
    float impulse[3] = {block->tangent_impulse[lane], block->point[0].normal_impulse[lane],
                        block->point[points - 1].normal_impulse[lane]};
    float alike = nx * block->nx[lane] + ny * block->ny[lane];
    td_manifold_cache *kept =
        w->kinds[kind]->form == TD_FORM_TWO_CACHED ? td_manifold_cache_of(block, points) : NULL;
    if (kept) { /* from this pose on; the manifold may be of an earlier one */
        kept->dx[lane] = apart_x, kept->dy[lane] = apart_y;
        kept->ac[lane] = a->c, kept->as[lane] = a->s;
        kept->bc[lane] = b->c, kept->bs[lane] = b->s;
    }
    drop(block, points, lane);
    block->nx[lane] = nx;
    block->ny[lane] = ny;
    int count = points < c->count ? points : c->count;
    for (int k = 0; k < count; k++) {
        td_point *p = &block->point[k];
        float x = dx + (float)c->x[k], y = dy + (float)c->y[k],
              separation = (float)c->separation[k];
        float cross = x * ny - y * nx, cross_a = fixed ? 0.0f : (ax + x) * ny - (ay + y) * nx;
        p->separation[lane] = p->base[lane] = separation - w->skin;
        p->cross_a[lane] = cross_a;
        p->cross_b[lane] = cross;
        p->normal_impulse[lane] = alike > ALIKE ? impulse[1 + k] : 0.0f;
        p->normal_mass[lane] = inverse_or_zero(mass + ib * cross * cross + ia * cross_a * cross_a);
        td_history_of(block, points)[k].approach[lane] =
            (vb[0] - va[0]) * nx + (vb[1] - va[1]) * ny + vb[2] * cross - va[2] * cross_a;
        if (kept) {
            kept->base[k][lane] = p->base[lane];
        }
        mid_x += x / (float)count;
        mid_y += y / (float)count;
    }
    float turn = -(mid_x * nx + mid_y * ny);
    float turn_a = fixed ? 0.0f : -((ax + mid_x) * nx + (ay + mid_y) * ny);
    block->tangent_cross_a[lane] = turn_a;
    block->tangent_cross_b[lane] = turn;
    block->tangent_mass[lane] = inverse_or_zero(mass + ib * turn * turn + ia * turn_a * turn_a);
    block->tangent_impulse[lane] = alike > ALIKE ? impulse[0] : 0.0f;
    block->touching |= 1u << lane;
}

/* A box with two points where its kind has one: their middle. */
static void join_points(td_internal_edge_contact *c) {
    c->x[0] = 0.5 * (c->x[0] + c->x[c->count - 1]);
    c->y[0] = 0.5 * (c->y[0] + c->y[c->count - 1]);
    c->separation[0] = 0.5 * (c->separation[0] + c->separation[c->count - 1]);
    c->count = 1;
}

/* Whether a shape is of the ground that a contact of the same body has its ghost from. */
static bool goes_on(const thud_world *w, const td_contact *to, const td_contact *from, int side) {
    return td_same_body(to->body[side], from->body[side]) ||
           (td_body_at(w, to->body[side])->kind == THUD_STATIC &&
            td_body_at(w, from->body[side])->kind == THUD_STATIC);
}

/* The neighbour that the body goes on to takes over what bore it: a contact that began without any
 * impulse would give way a little first. */
static void hand_over(thud_world *w, td_block *block, int kind, int lane) {
    const td_contact *from = td_contact_at(w, block->constraint[lane]);
    int points = td_form_points(w->kinds[kind]->form);
    int e = td_body_at(w, from->body[1])->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *to = td_constraint_at(w, e / 2);
        bool alike_sides = (to->shape_b == from->shape_b && goes_on(w, to, from, 0)) ||
                           (to->shape_a == from->shape_a && goes_on(w, to, from, 1));
        if (to == from || to->kind != kind || to->state != TD_TOUCHING || !alike_sides) {
            continue;
        }
        td_lane at = td_lane_of(w, to);
        float alike =
            at.block->nx[at.lane] * block->nx[lane] + at.block->ny[at.lane] * block->ny[lane];
        if (alike > ALIKE && at.block->point[0].normal_impulse[at.lane] == 0.0f) {
            for (int k = 0; k < points; k++) {
                at.block->point[k].normal_impulse[at.lane] = block->point[k].normal_impulse[lane];
            }
            at.block->tangent_impulse[at.lane] = block->tangent_impulse[lane];
            return;
        }
    }
}

static bool contact_of(const td_internal_edge_pair *p, td_internal_edge_contact *contact) {
    const thud_shape_instance *a = &p->placed[0], *b = &p->placed[1];
    sides s = sides_of(p);
    return td_kind_is_box(a->kind) && td_kind_is_box(b->kind) &&
           td_internal_edge_boxes(a, b, (double)(TD_SPECULATIVE * p->w->unit), is_hidden, &s,
                                  contact);
}

static void amend_lane(thud_world *w, td_block *block, int kind, int lane) {
    int a = block->shape_a[lane], b = block->shape_b[lane];
    td_position origin = td_shape_proxy_at(w, a)->center;
    td_internal_edge_pair pair = {
        w, {a, b}, {td_shape_instance(w, a, origin), td_shape_instance(w, b, origin)}};
    if (!is_ghost_of(&pair, (double)block->nx[lane], (double)block->ny[lane])) {
        return;
    }
    int points = td_form_points(w->kinds[kind]->form);
    td_internal_edge_contact contact;
    if (!contact_of(&pair, &contact)) {
        if (block->constraint[lane] != TD_NONE &&
            td_contact_at(w, block->constraint[lane])->state == TD_TOUCHING) {
            hand_over(w, block, kind, lane);
        }
        drop(block, points, lane);
        return;
    }
    if (points == 1) {
        join_points(&contact);
    }
    write_lane(w, block, kind, lane, &contact);
}

static void amend(thud_world *w, td_block *block, int kind) {
    td_lane_marks edged = {.internal_edges = UINT8_MAX};
    if (td_pair_is_on_line(kind) || !td_any_lane_marked(block, edged)) {
        return; /* a line's sealed ends are known to its manifolds */
    }
    for (int lane = 0; lane < block->used; lane++) {
        if (block->mark[lane].internal_edges && (block->touching >> lane & 1) &&
            !is_plain(w, block, lane)) {
            amend_lane(w, block, kind, lane);
        }
    }
}

/* Of the blocks that move only those with shapes off their bodies' centres may have internal edges.
 */
static void amend_all(thud_world *w) {
    td_block *const *blocks = w->scratch.blocks.data;
    td_block **parted = w->scratch.parted.data;
    for (int r = 0; r < w->scratch.runs.count; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        int count = run->fixed || run->armed ? run->count : 0;
        for (int i = run->first; i < run->first + count; i++) {
            td_block *block = blocks[i];
            bool whole = block->touching == (1u << block->used) - 1u;
            amend(w, block, run->kind);
            if (whole && block->touching != (1u << block->used) - 1u) {
                parted[w->scratch.parted.count++] = block;
            }
        }
    }
}

const td_internal_edge_ops td_internal_edges = {td_internal_edges_find,
                                                td_internal_edges_see,
                                                td_internal_edges_lose,
                                                td_internal_edges_join,
                                                amend,
                                                amend_all,
                                                is_ghost_of,
                                                contact_of};
