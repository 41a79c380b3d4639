/* bounces.c: see bounces.h. The solver would stop what closes in at a distance, and push apart what
 * has just bounced: both change its energy. It keeps what rests on each other. */
#include "solver/bounces.h"

#include "constraint/rings.h"
#include "detection/trajectory.h"
#include "constraint/lanes.h"
#include "state/surface.h"

/* Pairs in flight are left to the solver if they meet more slowly than this, in the unit of
 * TD_BOUNCE_REST. It is as little as can be, since the solver breaks their parabola. */
#define TOUCH 0.015625
/* A lane is loaded if it bears more than this share of a weight; less may be what rounding left. */
#define LOAD 0.01f
/* Shapes that overlap by less than this many times TD_MEET may be left where they are: impacts.c
 * lets what touches overlap by nearly as much. */
#define PRESSED 0.25f

/* One side's gravity along the normal, and how strong it is; lengths/s^2. */
static double gravity_of(const thud_world *w, uint32_t side, double nx, double ny, double *most) {
    td_awake_slot slot = td_slot_of_side(side);
    const td_body *body = slot.at ? td_body_at(w, td_body_of(w, slot)) : NULL;
    if (!body || body->kind != THUD_DYNAMIC) {
        return 0.0;
    }
    double x = (double)(w->def.gravity.x * body->gravity_scale);
    double y = (double)(w->def.gravity.y * body->gravity_scale);
    *most = td_max_double(*most, __builtin_sqrt(x * x + y * y));
    return x * nx + y * ny;
}

static td_trajectory *trajectory_of(const thud_world *w, uint32_t side) {
    td_awake_slot slot = td_slot_of_side(side);
    return slot.at ? td_trajectory_at(w, slot) : NULL;
}

typedef struct lane {
    td_block *block;
    int index, points;
    bool loaded; /* in the step before it bore more than a share of a weight */
} lane;

static lane lane_of(const thud_world *w, td_block *block, int index) {
    int kind = td_constraint_at(w, block->constraint[index])->kind;
    lane l = {block, index, td_form_points(w->kinds[kind]->form), false};
    float x = w->def.gravity.x, y = w->def.gravity.y;
    float least = LOAD * __builtin_sqrtf(x * x + y * y) * (float)(w->def.time_step / w->substeps);
    for (int k = 0; k < l.points; k++) {
        const td_point *p = &block->point[k];
        l.loaded |= p->normal_impulse[index] > p->normal_mass[index] * least;
    }
    return l;
}

static bool is_borne(const thud_world *w, const lane *l) {
    const td_trajectory *a = trajectory_of(w, l->block->a[l->index]);
    const td_trajectory *b = trajectory_of(w, l->block->b[l->index]);
    return (a && a->borne) || (b && b->borne);
}

static void note_borne(const thud_world *w, td_block *block) {
    for (int k = 0; k < block->used; k++) {
        if (lane_of(w, block, k).loaded) {
            td_trajectory *a = trajectory_of(w, block->a[k]), *b = trajectory_of(w, block->b[k]);
            if (a) {
                a->borne = true;
            }
            if (b) {
                b->borne = true;
            }
        }
    }
}

/* Restitution below 1: what is well apart and closes fast. Where it touches already, the solver is
 * the one that takes a heap apart. */
static bool bounces_lossily(const thud_world *w, const lane *l) {
    float slow = w->def.restitution_threshold * w->unit;
    bool apart = true, closes = false;
    for (int k = 0; k < l->points; k++) {
        const td_point *p = &l->block->point[k];
        bool here = p->normal_mass[l->index] > 0.0f;
        apart &= !here || p->separation[l->index] + w->skin > TD_MEET * w->unit;
        closes |= here && td_history_of(l->block, l->points)[k].approach[l->index] < -slow;
    }
    return apart && closes;
}

/* Elastic: what will meet faster than bodies at rest do, and what has; closing^2 + 2 * gravity *
 * height is the square of that speed. A pair that the solver bears stands a skin above where it
 * meets. */
static bool bounces_elastically(const thud_world *w, const lane *l) {
    double nx = (double)l->block->nx[l->index], ny = (double)l->block->ny[l->index], most = 0.0;
    double pull = gravity_of(w, l->block->a[l->index], nx, ny, &most);
    pull = td_max_double(pull - gravity_of(w, l->block->b[l->index], nx, ny, &most), 0.0);
    double rest = (is_borne(w, l) ? TD_BOUNCE_BORNE : TOUCH) * most * w->def.time_step;
    double slow = td_min_double(rest, (double)(w->def.restitution_threshold * w->unit));
    double meets_at = (double)((l->loaded ? TD_SKIN : TD_MEET) * w->unit);
    bool apart = true, fast = false;
    for (int k = 0; k < l->points; k++) {
        const td_point *p = &l->block->point[k];
        double closing = (double)td_history_of(l->block, l->points)[k].approach[l->index];
        double distance = (double)(p->separation[l->index] + w->skin);
        double speed2 = closing * closing + 2.0 * pull * td_max_double(distance - meets_at, 0.0);
        bool here = p->normal_mass[l->index] > 0.0f;
        apart &= !here || distance > -(double)(TD_MEET * w->unit);
        fast |= here && speed2 >= slow * slow;
    }
    return apart && fast;
}

/* What touches without load is not pushed apart to the distance at which contacts rest. */
static void stay(const thud_world *w, const lane *l) {
    for (int k = 0; k < l->points; k++) {
        td_point *p = &l->block->point[k];
        float distance = p->base[l->index] + w->skin;
        if (p->base[l->index] < 0.0f && distance > -PRESSED * TD_MEET * w->unit) {
            p->separation[l->index] = p->base[l->index] = 0.0f;
        }
    }
}

static void take(thud_world *w, td_block *block, int index) {
    const td_contact *contact = td_contact_at(w, block->constraint[index]);
    const thud_detection *detection = td_detection_of(w, contact->body[0], contact->body[1]);
    /* What joints tie is held where it meets, and bounces off as the solver has it. */
    if (!detection->meet || td_is_tied(w, td_body_at(w, contact->body[0])->awake) ||
        td_is_tied(w, td_body_at(w, contact->body[1])->awake)) {
        return;
    }
    lane l = lane_of(w, block, index);
    bool elastic = detection->rank == TD_RANK_SWEPT && block->restitution[index] >= 1.0f;
    if (elastic ? bounces_elastically(w, &l) : bounces_lossily(w, &l)) {
        td_surface_mute(block, l.points, index);
    } else if (elastic && !l.loaded) {
        stay(w, &l);
    }
}

void td_bounces_take(thud_world *w) {
    if (w->bouncy == 0 || w->skin == 0.0f) {
        return;
    }
    td_block **blocks = w->scratch.blocks.data;
    bool elastic = false;
    for (int i = 0; i < w->scratch.blocks.count && !elastic; i++) {
        for (int k = 0; k < blocks[i]->used && blocks[i]->bouncy; k++) {
            elastic |= blocks[i]->restitution[k] >= 1.0f;
        }
    }
    for (int i = 0; i < w->scratch.blocks.count && elastic; i++) {
        note_borne(w, blocks[i]);
    }
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        for (int k = 0; k < blocks[i]->used && blocks[i]->bouncy; k++) {
            if (blocks[i]->restitution[k] > 0.0f) {
                take(w, blocks[i], k);
            }
        }
    }
}
