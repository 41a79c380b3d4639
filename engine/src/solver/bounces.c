/* bounces.c: chooses the contacts that bounce in this step; see bounces.h. The soft solver would
 * change the energy of a bounce: it stops bodies that close at a distance (speculative contacts),
 * and pushes bodies apart that have just met. Resting contacts stay in the solver. */
#include "solver/bounces.h"

#include "constraint/tied_bodies.h"
#include "detection/trajectory.h"
#include "constraint/lanes.h"
#include "state/surface.h"

/* A pair of bodies in free flight that meets at less than this speed does not bounce here: the soft
 * solver stops it. In multiples of gravity times the time step. Chosen small, since the soft solver
 * changes the energy of the pairs that it takes. */
#define FLIGHT_REST 0.015625
/* A contact is loaded if its impulse in a substep is more than this share of the impulse that would
 * carry its effective mass against gravity. Smaller impulses may come from rounding. Chosen. */
#define LOAD_SHARE 0.01f
/* An unloaded contact that overlaps by less than this share of TD_IMPACT_DISTANCE is not pushed
 * apart: impacts.c leaves touching shapes with nearly as much overlap. */
#define OVERLAP_SHARE 0.25f

/* The component along the normal of the gravity that acts on the body of one side, length/s^2; 0
 * unless the body is dynamic. *max is raised to the magnitude of that gravity. */
static double gravity_of(const thud_world *w, uint32_t side, double nx, double ny, double *max) {
    td_awake_slot slot = td_slot_of_side(side);
    const td_body *body = slot.at ? td_body_at(w, td_body_of(w, slot)) : NULL;
    if (!body || body->kind != THUD_BODY_DYNAMIC) {
        return 0.0;
    }
    double x = (double)(w->def.gravity.x * body->gravity_scale);
    double y = (double)(w->def.gravity.y * body->gravity_scale);
    *max = td_max_double(*max, __builtin_sqrt(x * x + y * y));
    return x * nx + y * ny;
}

static td_trajectory *trajectory_of(const thud_world *w, uint32_t side) {
    td_awake_slot slot = td_slot_of_side(side);
    return slot.at ? td_trajectory_at(w, slot) : NULL;
}

typedef struct lane {
    td_block *block;
    int index, points;
    bool loaded; /* the warm-start impulse of a point is more than LOAD_SHARE of that which would
                    carry the point's effective mass against gravity for a substep */
} lane;

static lane lane_of(const thud_world *w, td_block *block, int index) {
    int kind = td_constraint_at(w, block->constraint[index])->kind;
    lane l = {block, index, td_form_points(w->kinds[kind]->form), false};
    float x = w->def.gravity.x, y = w->def.gravity.y;
    float speed_min =
        LOAD_SHARE * __builtin_sqrtf(x * x + y * y) * (float)(w->def.time_step / w->substeps);
    for (int k = 0; k < l.points; k++) {
        const td_point *p = &block->point[k];
        l.loaded |= p->normal_impulse[index] > p->normal_mass[index] * speed_min;
    }
    return l;
}

/* Whether contacts carry one of the bodies. */
static bool is_borne(const thud_world *w, const lane *l) {
    const td_trajectory *a = trajectory_of(w, l->block->a[l->index]);
    const td_trajectory *b = trajectory_of(w, l->block->b[l->index]);
    return (a && a->borne) || (b && b->borne);
}

/* Marks the bodies of all loaded lanes as carried. */
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

/* Whether detection has to resolve the bounce of a pair with restitution below 1: the shapes are
 * apart by more than TD_IMPACT_DISTANCE and close faster than the restitution threshold. Pairs that
 * touch already, as in a heap that is hit, stay with the soft solver, which solves all contacts of
 * the heap together. */
static bool bounces_lossily(const thud_world *w, const lane *l) {
    float slow = w->def.restitution_threshold * w->length_scale;
    bool apart = true, closes = false;
    for (int k = 0; k < l->points; k++) {
        const td_point *p = &l->block->point[k];
        bool here = p->normal_mass[l->index] > 0.0f;
        apart &= !here || p->separation[l->index] + w->skin > TD_IMPACT_DISTANCE * w->length_scale;
        closes |= here && td_history_of(l->block, l->points)[k].normal_velocity[l->index] < -slow;
    }
    return apart && closes;
}

/* Whether a pair with restitution 1 or more bounces: the speed at which it meets is above the
 * threshold. From the closing speed now, conservation of energy gives it as speed^2 = closing^2 + 2
 * g d, where g is the relative gravity along the normal and d the distance until the pair meets. A
 * loaded pair counts as meeting at the distance TD_SKIN, at which soft contacts rest; any other
 * pair meets at TD_IMPACT_DISTANCE. */
static bool bounces_elastically(const thud_world *w, const lane *l) {
    double nx = (double)l->block->nx[l->index], ny = (double)l->block->ny[l->index], max = 0.0;
    double pull = gravity_of(w, l->block->a[l->index], nx, ny, &max);
    pull = td_max_double(pull - gravity_of(w, l->block->b[l->index], nx, ny, &max), 0.0);
    double rest = (is_borne(w, l) ? TD_BOUNCE_BORNE : FLIGHT_REST) * max * w->def.time_step;
    double slow = td_min_double(rest, (double)(w->def.restitution_threshold * w->length_scale));
    double meets_at = (double)((l->loaded ? TD_SKIN : TD_IMPACT_DISTANCE) * w->length_scale);
    bool apart = true, fast = false;
    for (int k = 0; k < l->points; k++) {
        const td_point *p = &l->block->point[k];
        double closing = (double)td_history_of(l->block, l->points)[k].normal_velocity[l->index];
        double distance = (double)(p->separation[l->index] + w->skin);
        double speed2 = closing * closing + 2.0 * pull * td_max_double(distance - meets_at, 0.0);
        bool here = p->normal_mass[l->index] > 0.0f;
        apart &= !here || distance > -(double)(TD_IMPACT_DISTANCE * w->length_scale);
        fast |= here && speed2 >= slow * slow;
    }
    return apart && fast;
}

/* Sets the separation of an unloaded contact that is nearer than the skin, and hardly overlaps, to
 * 0, so that the soft solver does not push it apart to the distance of the skin. */
static void clear_overlap(const thud_world *w, const lane *l) {
    for (int k = 0; k < l->points; k++) {
        td_point *p = &l->block->point[k];
        float distance = p->start_separation[l->index] + w->skin;
        if (p->start_separation[l->index] < 0.0f &&
            distance > -OVERLAP_SHARE * TD_IMPACT_DISTANCE * w->length_scale) {
            p->separation[l->index] = p->start_separation[l->index] = 0.0f;
        }
    }
}

/* Takes a contact out of the soft solver for this step (td_surface_mute) if its pair bounces. */
static void mute_if_bouncing(thud_world *w, td_block *block, int index) {
    const td_contact *contact = td_contact_at(w, block->constraint[index]);
    const thud_detection *detection = td_detection_of(w, contact->body[0], contact->body[1]);
    /* Bodies of joints are held back where they meet (detection/impacts.c), and bounce by the soft
     * solver. */
    if (!detection->time_of_impact || td_is_tied(w, td_body_at(w, contact->body[0])->awake) ||
        td_is_tied(w, td_body_at(w, contact->body[1])->awake)) {
        return;
    }
    lane l = lane_of(w, block, index);
    bool elastic = detection->rank == TD_RANK_SWEPT && block->restitution[index] >= 1.0f;
    if (elastic ? bounces_elastically(w, &l) : bounces_lossily(w, &l)) {
        td_surface_mute(block, l.points, index);
    } else if (elastic && !l.loaded) {
        clear_overlap(w, &l);
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
                mute_if_bouncing(w, blocks[i], k);
            }
        }
    }
}
