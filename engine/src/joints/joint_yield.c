/* joint_yield.c: joints lose against static shapes.
 *
 * A joint that pulls a body against what cannot move (a rope that is reeled in, a motor without a
 * greatest force) makes a problem that has no solution. The solver's impulses of both sides grow
 * from substep to substep then; a contact is soft, gives way in proportion to its impulse, and is
 * pressed in by as much in each step. So what the solver has made of a step is looked at
 * afterwards. Where a body that joints act on ends it deeper in a static shape than it began, by
 * more than LOST_SHARE, it is put back, and with it all that locked joints tie to it; so is a ring
 * that touches something static where a motor with force left misses its speed and a lock has
 * opened. By projected Gauss-Seidel on the motions of the step, and then on the velocities, locks
 * are closed again and contacts are opened; contacts come last and have the last word. Drives give
 * way: a motor stalls, a rope stays open. None of it leaves with more energy than it came with.
 *
 * The next step begins without the impulses of those joints and contacts, which would grow without
 * end. */
#include "constraint/joint_hooks.h"
#include "constraint/tied_bodies.h"
#include "detection/trajectory.h"
#include "direct/elimination_order.h"
#include "joints/joint.h"
#include "solver/error.h"
#include "state/kinds.h"
#include "state/shape.h"

/* A contact may be pressed in to this share of the smallest half extent of the body, or of half the
 * thickness of the static shape where that is less. Chosen. */
#define SINK_SHARE 0.1f
/* A joint is taken to press without end once a contact sinks further than this share; from then on
 * SINK_SHARE counts. Impacts press limbs of ragdolls in as far as the first for a few steps.
 * Chosen.
 */
#define LOST_SHARE 0.4f
/* What is deeper already, as bodies are that were made there, comes out at this share of the
 * world's push_speed. Chosen. */
#define PUSH_SHARE 0.2

enum {
    PASSES = 24, /* Gauss-Seidel passes over a ring, each for motions and for velocities */
    LAST = 8     /* of contacts alone, behind them */
};

struct finding;

/* A ring of bodies (constraint/tied_bodies.h), or one body alone. */
typedef struct ring {
    thud_world *w;
    td_awake_slot first;
    bool velocities; /* velocities are being mended; motions are before */
    struct finding *found;
    float core;  /* smallest half extent of its bodies */
    float share; /* of that, from which on a joint has lost */
} ring;

/* Calls `visit` for each acting constraint of the ring's bodies, once. */
static void walk(const ring *r, void (*visit)(const ring *r, const td_constraint *constraint)) {
    const thud_world *w = r->w;
    td_awake_slot slot = r->first;
    do {
        int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, e / 2);
            bool first = !(e & 1) || !td_island_neighbour(w, constraint, e & 1).at;
            if (constraint->state == TD_TOUCHING && first) {
                visit(r, constraint);
            }
        }
        slot = td_next_tied(w, slot);
    } while (slot.at != r->first.at);
}

/* ---- rows ---- */

/* The motion or the velocity that a pass mends, of a side. */
static float *record_of(const ring *r, uint32_t side) {
    td_awake_slot slot = td_slot_of_side(side);
    return r->velocities ? td_row(&r->w->velocity, slot) : td_row(&r->w->delta, slot);
}

/* A direction of a lane: from side a to side b, and the crosses of the arms with it. */
typedef struct direction {
    double x, y, cross_a, cross_b;
} direction;

static double along(const ring *r, const td_lane *at, const direction *n) {
    const float *a = record_of(r, at->block->a[at->lane]),
                *b = record_of(r, at->block->b[at->lane]);
    return n->x * ((double)b[0] - (double)a[0]) + n->y * ((double)b[1] - (double)a[1]) +
           n->cross_b * (double)b[2] - n->cross_a * (double)a[2];
}

static void add(float *record, double mass, double inertia, const direction *n, double cross,
                double impulse) {
    record[0] += (float)(mass * n->x * impulse);
    record[1] += (float)(mass * n->y * impulse);
    record[2] += (float)(inertia * cross * impulse);
}

/* Changes what a lane has along a direction by so much. Sides that nothing moves have no mass. */
static void correct(const ring *r, const td_lane *at, const direction *n, double by) {
    const td_block *block = at->block;
    uint32_t a = block->a[at->lane], b = block->b[at->lane];
    double mass_a = (double)td_row(&r->w->velocity, td_slot_of_side(a))[3];
    double mass_b = (double)td_row(&r->w->velocity, td_slot_of_side(b))[3];
    double inertia_a = (double)block->inv_inertia_a[at->lane];
    double inertia_b = (double)block->inv_inertia_b[at->lane];
    double k = (mass_a + mass_b) * (n->x * n->x + n->y * n->y) +
               inertia_a * n->cross_a * n->cross_a + inertia_b * n->cross_b * n->cross_b;
    if (k > 0.0 && by != 0.0) {
        add(record_of(r, b), mass_b, inertia_b, n, n->cross_b, by / k);
        if (mass_a + inertia_a > 0.0) {
            add(record_of(r, a), mass_a, inertia_a, n, n->cross_a, -by / k);
        }
    }
}

/* ---- contacts with what is static ---- */

static bool is_static_contact(const td_constraint *constraint, const td_lane *at) {
    return td_is_contact(constraint) && constraint->kind != TD_PAIR_SENSOR &&
           at->block->a[at->lane] == 0;
}

static direction normal_of(const td_lane *at, int k) {
    const td_point *p = &at->block->point[k];
    return (direction){(double)at->block->nx[at->lane], (double)at->block->ny[at->lane],
                       (double)p->cross_a[at->lane], (double)p->cross_b[at->lane]};
}

/* The separation that a point may have at least as the step ends, by a share of what is thinner. */
static double least_of(const thud_world *w, const td_lane *at, int k, float share) {
    const td_block *block = at->block;
    float core = td_row(&w->reach, td_slot_of_side(block->b[at->lane]))[0];
    const td_shape *shape = td_shape_at(w, block->shape_a[at->lane]);
    float thin = td_kind_is_line(shape->kind) ? core : td_half_thickness(shape);
    double least = -(double)(share * td_min_float(core, thin));
    double out = PUSH_SHARE * (double)(w->def.push_speed * w->unit) * w->def.time_step;
    return td_min_double(least, (double)block->point[k].base[at->lane] + out);
}

/* Whether a point has gone deeper in the step than it may. */
static bool sinks(const thud_world *w, const td_lane *at, int k, float share) {
    const td_point *p = &at->block->point[k];
    double now = (double)p->separation[at->lane];
    return p->normal_mass[at->lane] > 0.0f && now < (double)p->base[at->lane] &&
           now < least_of(w, at, k, share);
}

static void mend_contact(const ring *r, const td_constraint *constraint) {
    if (!td_is_contact(constraint)) {
        return;
    }
    td_lane at = td_lane_of(r->w, constraint);
    int points = td_form_points(r->w->kinds[constraint->kind]->form);
    for (int k = 0; k < points && is_static_contact(constraint, &at); k++) {
        td_point *p = &at.block->point[k];
        direction n = normal_of(&at, k);
        double speed = along(r, &at, &n);
        if (p->normal_mass[at.lane] == 0.0f) {
            continue;
        }
        if (!r->velocities) {
            double now = (double)p->base[at.lane] + speed;
            correct(r, &at, &n, td_max_double(least_of(r->w, &at, k, SINK_SHARE) - now, 0.0));
        } else if (p->separation[at.lane] <= 0.0f) {
            correct(r, &at, &n, td_max_double(-speed, 0.0));
        }
    }
}

/* ---- what joints lock ---- */

/* A gap that was there as the step began may stay as far as it does not close at
 * TD_JOINT_CLOSING. */
static double excess_of(const thud_world *w, double before, double now) {
    double left =
        td_max_double(td_abs(before) - (double)(TD_JOINT_CLOSING * w->unit) * w->def.time_step,
                      0.0);
    return now > left ? now - left : now < -left ? now + left : 0.0;
}

static void mend_row(const ring *r, const td_lane *at, const direction *n, double before,
                     double now) {
    correct(r, at, n, r->velocities ? -along(r, at, n) : -excess_of(r->w, before, now));
}

static void mend_rod(const ring *r, const td_lane *at) {
    double a[3], b[3], wanted = (double)td_lock_rows_at(at->block)->turn_base[at->lane];
    double before = (double)at->block->point[0].base[at->lane];
    td_joint_motion(r->w, at->block, at->lane, a, b);
    td_joint_frame f = td_joint_line_after(at->block, at->lane, before + wanted, 0.0, a, b);
    mend_row(r, at, &(direction){f.x, f.y, f.a_u, f.b_u}, before, f.gap_u - wanted);
}

static td_joint_frame frame_of(const ring *r, const td_lane *at) {
    double a[3], b[3];
    const td_point *p = at->block->point;
    td_joint_motion(r->w, at->block, at->lane, a, b);
    return td_joint_frame_after(at->block, at->lane, (double)p[0].base[at->lane],
                                (double)p[1].base[at->lane],
                                td_lock_rows_at(at->block)->frame[at->lane] > 0.0f, a, b);
}

static void mend_hold(const ring *r, const td_lane *at) {
    const td_block *block = at->block;
    const td_point *p = block->point;
    const td_lock_rows *rows = td_lock_rows_at(block);
    if (block->tangent_mass[at->lane] > 0.0f) {
        double a[3], b[3], sign = (double)rows->turn_sign[at->lane];
        double before = (double)rows->turn_base[at->lane];
        td_joint_motion(r->w, block, at->lane, a, b);
        mend_row(r, at, &(direction){0.0, 0.0, sign, sign}, before, before + sign * (b[2] - a[2]));
    }
    if (p[0].normal_mass[at->lane] > 0.0f) {
        td_joint_frame f = frame_of(r, at);
        mend_row(r, at, &(direction){f.x, f.y, f.a_u, f.b_u}, (double)p[0].base[at->lane], f.gap_u);
    }
    if (p[1].normal_mass[at->lane] > 0.0f) {
        td_joint_frame f = frame_of(r, at);
        mend_row(r, at, &(direction){-f.y, f.x, f.a_v, f.b_v}, (double)p[1].base[at->lane],
                 f.gap_v);
    }
}

static void mend_lock(const ring *r, const td_constraint *constraint) {
    if (constraint->kind == TD_CONSTRAINT_ROD || constraint->kind == TD_CONSTRAINT_LOCK) {
        td_lane at = td_lane_of(r->w, constraint);
        if (constraint->kind == TD_CONSTRAINT_ROD) {
            mend_rod(r, &at);
        } else {
            mend_hold(r, &at);
        }
    }
}

/* ---- what drives ---- */

static bool is_drive(int kind) {
    return kind >= TD_CONSTRAINT_DRIVE_LINE && kind <= TD_CONSTRAINT_DRIVE_TURN;
}

/* As it was at the start of the step. */
static direction drive_of(const td_lane *at, int kind) {
    const td_block *block = at->block;
    const td_point *p = &block->point[0];
    const td_drive_rows *rows = td_drive_rows_at(block);
    double sign = (double)rows->turn_sign[at->lane];
    if (kind == TD_CONSTRAINT_DRIVE_TURN) {
        return (direction){0.0, 0.0, sign, sign};
    }
    double lever = kind == TD_CONSTRAINT_DRIVE_AXIS ? (double)rows->gap_v[at->lane] : 0.0;
    return (direction){(double)block->nx[at->lane], (double)block->ny[at->lane],
                       (double)p->cross_a[at->lane] - lever, (double)p->cross_b[at->lane]};
}

/* Of a motor, by what it gave in the last substep. */
static bool has_force_left(const thud_world *w, const td_lane *at) {
    float most = td_drive_rows_at(at->block)->motor_most[at->lane];
    return td_joint_size(at->block->tangent_impulse[at->lane]) <
           most * (float)(w->def.time_step / w->substeps);
}

/* A motor that has force left lets nothing go back against it, but for what locks and contacts ask
 * of a motion. */
static void mend_drive(const ring *r, const td_constraint *constraint) {
    if (!is_drive(constraint->kind)) {
        return;
    }
    td_lane at = td_lane_of(r->w, constraint);
    direction n = drive_of(&at, constraint->kind);
    double wanted = (double)td_drive_rows_at(at.block)->motor_speed[at.lane];
    double speed = along(r, &at, &n);
    if (has_force_left(r->w, &at) && speed * wanted <= 0.0) {
        correct(r, &at, &n, -speed);
    }
}

/* ---- after the step ---- */

static void note_contact(const ring *r, const td_constraint *constraint) {
    td_lane at = td_lane_of(r->w, constraint);
    int points = td_form_points(r->w->kinds[constraint->kind]->form);
    for (int k = 0; k < points && is_static_contact(constraint, &at); k++) {
        direction n = normal_of(&at, k);
        at.block->point[k].separation[at.lane] =
            at.block->point[k].base[at.lane] + (float)along(r, &at, &n);
    }
}

static void forget_impulses(const thud_world *w, const td_constraint *constraint) {
    td_lane at = td_lane_of(w, constraint);
    int points = td_form_points(w->kinds[constraint->kind]->form);
    for (int k = 0; k < points; k++) {
        at.block->point[k].normal_impulse[at.lane] = 0.0f;
    }
    at.block->tangent_impulse[at.lane] = 0.0f;
}

/* The impulses stay for whoever asks for them after the step, and for joints that break. */
static void note_loss(const ring *r, const td_constraint *constraint) {
    if (!td_is_contact(constraint)) {
        td_lane at = td_lane_of(r->w, constraint);
        at.block->mark[at.lane].rule = TD_LANE_LOST;
    }
}

static void forget_body(const thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        if (constraint->state == TD_TOUCHING && td_is_contact(constraint)) {
            td_lane at = td_lane_of(w, constraint);
            if (is_static_contact(constraint, &at)) {
                forget_impulses(w, constraint);
            }
        }
    }
}

static void forget_block(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        bool lost = block->mark[lane].rule & TD_LANE_LOST;
        block->mark[lane].rule = lost ? TD_LANE_WAS_LOST : 0;
        if (lost) {
            const td_constraint *constraint = td_constraint_at(w, block->constraint[lane]);
            forget_impulses(w, constraint);
            forget_body(w, constraint->body[0]);
            forget_body(w, constraint->body[1]);
        }
    }
}

void td_joints_forget(thud_world *w) {
    memcpy(w->scratch.before.data, w->velocity.data, (size_t)w->body_of.count * sizeof(float[4]));
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        for (int k = 0; k < run->count && run->kind >= TD_PAIR_COUNT; k++) {
            td_block *block = *TD_AT(td_block *, &w->scratch.blocks, run->first + k);
            if (td_any_lane_marked(block,
                                   (td_lane_marks){.rule = TD_LANE_LOST | TD_LANE_WAS_LOST})) {
                forget_block(w, block);
            }
        }
    }
}

static void mend_records(const ring *r) {
    for (int pass = 0; pass < PASSES; pass++) {
        if (r->velocities || pass < PASSES / 2) {
            walk(r, mend_drive);
        }
        walk(r, mend_lock);
        walk(r, mend_contact);
    }
    for (int pass = 0; pass < LAST; pass++) {
        walk(r, mend_contact);
    }
}

/* Twice the kinetic energy of a body, at a velocity and `more` on top of its parts. */
static double energy_of(const thud_world *w, td_awake_slot slot, const float *velocity,
                        const float *more, float times) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    double v[3];
    for (int k = 0; k < 3; k++) {
        v[k] = td_abs((double)velocity[k]) + td_abs((double)(more[k] * times));
    }
    double turning = body->inv_inertia > 0.0f ? v[2] * v[2] / (double)body->inv_inertia : 0.0;
    return (v[0] * v[0] + v[1] * v[1]) / (double)body->inv_mass + turning;
}

/* What lost has not gained speed by pulling: rows that are nearly opposite to each other leave much
 * of the speed at which they close. Gravity and forces may have given some. */
static void calm(const ring *r) {
    const thud_world *w = r->w;
    double before = 0.0, after = 0.0;
    td_awake_slot slot = r->first;
    do {
        const float *push = td_row(&w->push, slot);
        before += energy_of(w, slot, td_row(&w->scratch.before, slot), push, (float)w->substeps);
        after += energy_of(w, slot, td_row(&w->velocity, slot), push, 0.0f);
        slot = td_next_tied(w, slot);
    } while (slot.at != r->first.at);
    float share = after > before ? (float)__builtin_sqrt(before / after) : 1.0f;
    do {
        float *velocity = td_row(&w->velocity, slot);
        for (int k = 0; k < 3; k++) {
            velocity[k] *= share;
        }
        slot = td_next_tied(w, slot);
    } while (slot.at != r->first.at);
}

/* Long arms may have made motions that positions cannot follow. */
static void clamp_motions(const ring *r) {
    td_awake_slot slot = r->first;
    do {
        float *delta = td_row(&r->w->delta, slot);
        for (int k = 0; k < 3; k++) {
            delta[k] = (float)td_motion_held(r->w, k, (double)delta[k]);
        }
        slot = td_next_tied(r->w, slot);
    } while (slot.at != r->first.at);
}

static void mend(thud_world *w, td_awake_slot slot) {
    ring r = {.w = w, .first = slot};
    mend_records(&r);
    clamp_motions(&r);
    walk(&r, note_contact);
    r.velocities = true;
    mend_records(&r);
    calm(&r);
    walk(&r, note_loss);
}

/* ---- which ---- */

/* Of a slot in scratch.parents. */
enum {
    PRESSED = 1, /* a contact of it with what is static sinks */
    DRIVEN = 2   /* a motor of it has force left, and does not reach its speed */
};

static void mark(thud_world *w, td_awake_slot slot, int as) {
    td_awake_slot *marks = w->scratch.parents.data;
    marks[slot.at].at |= slot.at > 0 ? as : 0;
}

/* Whether joints act on a body; and whether one of them lost in the step before. */
static bool has_joints(const thud_world *w, td_awake_slot slot, bool *lost) {
    bool any = false;
    *lost = false;
    int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        if (constraint->state == TD_TOUCHING && !td_is_contact(constraint)) {
            td_lane at = td_lane_of(w, constraint);
            any = true;
            *lost |= (at.block->mark[at.lane].rule & TD_LANE_WAS_LOST) != 0;
        }
    }
    return any;
}

/* Motors that miss their speed by no more than this share of it are taken to have reached it. */
#define SHORT 0.05f

static bool stalls(const thud_world *w, const td_lane *at, int kind) {
    const ring r = {.w = (thud_world *)w, .velocities = true};
    direction n = drive_of(at, kind);
    float wanted = td_drive_rows_at(at->block)->motor_speed[at->lane];
    return has_force_left(w, at) &&
           td_joint_size((float)along(&r, at, &n) - wanted) > SHORT * td_joint_size(wanted);
}

/* What a lane of a drive or of a contact with something static says of its bodies. */
static int judge(const thud_world *w, const td_lane *at, const td_run *run) {
    if (run->kind >= TD_PAIR_COUNT) {
        return stalls(w, at, run->kind) ? DRIVEN : 0;
    }
    bool any = false, far = false, lost = false;
    for (int k = 0; k < td_form_points(w->kinds[run->kind]->form); k++) {
        any |= sinks(w, at, k, SINK_SHARE);
        far |= sinks(w, at, k, LOST_SHARE);
    }
    any = any && has_joints(w, td_slot_of_side(at->block->b[at->lane]), &lost);
    return any && (far || lost) ? PRESSED : 0;
}

/* Marks bodies by their lanes; false where there are none to be marked. */
static bool look(thud_world *w) {
    bool any = false;
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        bool contacts = run->kind < TD_PAIR_COUNT && run->kind != TD_PAIR_SENSOR && run->fixed;
        for (int k = 0; k < run->count * TD_LANES && (contacts || is_drive(run->kind)); k++) {
            td_block *block = *TD_AT(td_block *, &w->scratch.blocks, run->first + k / TD_LANES);
            td_lane at = {block, k % TD_LANES};
            int as = at.lane < block->used ? judge(w, &at, run) : 0;
            if (as && !any) {
                any = true;
                td_joints_tie(w);
                memset(w->scratch.parents.data, 0,
                       (size_t)w->body_of.count * sizeof(td_awake_slot));
            }
            if (as) {
                mark(w, td_slot_of_side(block->a[at.lane]), as);
                mark(w, td_slot_of_side(block->b[at.lane]), as);
            }
        }
    }
    return any;
}

/* Of a ring: something of it touches what is static, and is deep in it; a lock of it is open by
 * more than a share of its bodies' smallest half extent, and than as the step began. */
typedef struct finding {
    bool touches, opened, deep;
} finding;

static bool is_wider(float now, float before, float most) {
    return td_joint_size(now) > td_max_float(most, td_joint_size(before));
}

static void find(const ring *r, const td_constraint *constraint) {
    finding *found = r->found;
    td_lane at = td_lane_of(r->w, constraint);
    const td_block *block = at.block;
    int lane = at.lane, points = td_form_points(r->w->kinds[constraint->kind]->form);
    bool fixed = is_static_contact(constraint, &at);
    bool locks = constraint->kind == TD_CONSTRAINT_ROD || constraint->kind == TD_CONSTRAINT_LOCK;
    for (int k = 0; k < points && fixed; k++) {
        const td_point *p = &block->point[k];
        found->touches |= p->normal_mass[lane] > 0.0f &&
                          (p->normal_impulse[lane] > 0.0f || p->separation[lane] < 0.0f);
        found->deep |= p->normal_mass[lane] > 0.0f &&
                       (double)p->separation[lane] < least_of(r->w, &at, k, r->share);
    }
    for (int k = 0; k < points && locks; k++) {
        const td_point *p = &block->point[k];
        found->opened |= p->normal_mass[lane] > 0.0f &&
                         is_wider(p->separation[lane], p->base[lane], r->share * r->core);
    }
}

/* Whether a marked body's ring is to be mended. */
static bool yields(thud_world *w, td_awake_slot slot) {
    const td_awake_slot *marks = w->scratch.parents.data;
    finding found = {false, false, false};
    ring r = {.w = w, .first = slot, .found = &found, .core = 3e38f, .share = LOST_SHARE};
    int as = 0;
    td_awake_slot i = slot;
    do {
        bool lost;
        as |= marks[i.at].at;
        r.core = td_min_float(r.core, td_row(&w->reach, i)[0]);
        r.share = has_joints(w, i, &lost) && lost ? SINK_SHARE : r.share;
        i = td_next_tied(w, i);
    } while (i.at != slot.at);
    if (!(as & PRESSED)) {
        walk(&r, find);
    }
    return as & PRESSED || (found.touches && (found.opened || found.deep));
}

void td_joints_yield(thud_world *w) {
    if (!look(w)) {
        return;
    }
    td_awake_slot *marks = w->scratch.parents.data;
    bool any = false;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (!marks[slot.at].at) {
            continue;
        }
        if (yields(w, slot)) {
            any = true;
            mend(w, slot);
        }
        td_awake_slot i = slot;
        do {
            marks[i.at].at = 0;
            i = td_next_tied(w, i);
        } while (i.at != slot.at);
    }
    if (any) {
        td_error_recount(w);
    }
}
