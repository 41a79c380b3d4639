/* gaps.c: see gaps.h.
 *
 * With n the normal, d the displacements of the centres, phi the turns and c = r x n the crosses of
 * a point, its gap at the end of a motion is
 *   gap = start_separation + skin + n . (d_b - d_a) + c_b phi_b - c_a phi_a
 * where start_separation is that at the start of the step, measured from the skin at which contacts
 * rest. The rows neglect that normal and lever arms turn with the bodies; `row_error` bounds the
 * error that this causes in the gap. */
#include "detection/gaps.h"

#include "constraint/lanes.h"
#include "constraint/tied_bodies.h"
#include "detection/arrival_rows.h"
#include "detection/project.h"
#include "solver/error.h"
#include "state/body.h"
#include "state/kinds.h"

#include <string.h>

TD_DECLARE_WIDE(td_project_fn, td_project_points);
TD_DECLARE_WIDE(td_find_open_fn, td_find_open_points);

/* Passes of projected Gauss-Seidel. A point falls short if its gap ends below its target
 * (td_gaps_project) by more than SHORTFALL_TOLERANCE. The first PLAIN_PASSES passes are plain; they
 * finish single contacts and low stacks. If any point still falls short, contacts are stacked deep,
 * where a plain pass carries a correction one contact further: over-relaxed passes follow (SOR with
 * the factor OVER_RELAXATION, which must be below 2), and at last FINAL_PASSES plain ones, which
 * undo the overshoot of over-relaxation. Up to pass FINE_PASSES, passes go on while any point falls
 * short. From then up to PASSES_MAX they only serve to avoid collisions, each of which costs as
 * much as a pass over forty blocks. One more pass avoids few of them, so that passes go on only
 * while there are more collisions than blocks. Measured with 0.25 to 3 collisions a block as that
 * bound, in the scene circle_pit (2,000 circles, steps 100 to 150): 372, 379, 425, 520, 969, 3,729
 * impacts a step with 0.25, 0.5, 1, 1.5, 2, 3; with 1 the step took four fifths of the time with
 * 0.5, and half of it once the heap settled. */
enum { PLAIN_PASSES = 8, FINE_PASSES = 20, PASSES_MAX = 160, FINAL_PASSES = 2 };
#define OVER_RELAXATION 1.8f

/* In multiples of TD_IMPACT_DISTANCE. td_gaps_project lets no gap end below TARGET_DISTANCE, or
 * below the gap at the start of the step if that is smaller, except that bodies at rest may close
 * by YIELD_AT_REST. A gap that ends below COLLISION_DISTANCE, and has shrunk by more than
 * TD_LOAD_CLOSING_MAX, is a collision, for which a time of impact is computed. All chosen.
 * TARGET_DISTANCE is below 1, so that gaps that come from times of impact (1 TD_IMPACT_DISTANCE)
 * are not changed. */
#define TARGET_DISTANCE 0.8f
#define SHORTFALL_TOLERANCE 0.05f
#define COLLISION_DISTANCE 0.05f

/* How far a gap between two slow bodies may close in a step, in multiples of TD_IMPACT_DISTANCE. A
 * body is slow if it moves less in the step than it would at TD_SLEEP_SPEED. The projection has no
 * friction: if it held slow bodies apart too, it would push them along the normals, against the
 * friction that holds them, and a heap would creep without end and never fall asleep (circle_pit
 * with 2,000 circles moved at 0.03 length scales a second after 300 steps, and at 0.007 after
 * 1,200). The load of slow bodies is left to the soft solver, which has friction. Chosen; it must
 * be below TD_LOAD_CLOSING_MAX, since a gap that closes by more than that counts as a collision. In
 * a world with joints 0 is used instead, since a joint may pull a body with any force: with
 * YIELD_AT_REST, a ball that a rod reels into the floor sank in by 24 mm, with 0 by 2 mm. */
#define YIELD_AT_REST 0.1f

/* The inputs of the wide kernels, with lengths in the caller's unit. */
static td_project_context context_of(const thud_world *w) {
    float impact_distance = TD_IMPACT_DISTANCE * w->length_scale;
    return (td_project_context){
        .delta = w->delta.data,
        .velocity = w->velocity.data,
        .reach = w->reach.data,
        .over_relaxation = 1.0f,
        .skin = w->skin,
        .target_distance = TARGET_DISTANCE * impact_distance,
        .rest_motion = TD_SLEEP_SPEED * w->length_scale * (float)w->def.time_step,
        .yield_at_rest = w->joints.live > 0 ? 0.0f : YIELD_AT_REST * impact_distance,
        .enough = (TARGET_DISTANCE - SHORTFALL_TOLERANCE) * impact_distance,
        .closing = SHORTFALL_TOLERANCE * impact_distance,
        .collision_distance = COLLISION_DISTANCE * impact_distance,
        .closing_max = (float)TD_LOAD_CLOSING_MAX * impact_distance,
        .margin = TD_SPECULATIVE * w->length_scale,
        .next_tied = w->scratch.next_tied.count > 0 ? w->scratch.next_tied.data : NULL};
}

/* The run at an index of scratch.runs if it is of contacts, or null if it is of joints. */
static const td_run *contact_run_at(const thud_world *w, int index) {
    const td_run *run = TD_AT(td_run, &w->scratch.runs, index);
    return run->kind < TD_PAIR_COUNT ? run : NULL;
}

/* The first block of a run. */
static td_block *const *blocks_of(const thud_world *w, const td_run *run) {
    return (td_block **)w->scratch.blocks.data + run->first;
}

/* One pass over all contacts and arrivals. Returns at how many points another pass is needed
 * (td_project_context.enough, .closing). */
static int project_once(thud_world *w, const td_project_context *context) {
    int unfinished = td_arrival_rows_project(w, context);
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = contact_run_at(w, i);
        if (run) {
            unfinished += TD_PICK_WIDE(w, td_project_points)(
                blocks_of(w, run), (td_pushes *)w->scratch.impacts.data + run->first, run->count,
                td_form_points(w->kinds[run->kind]->form), run->a_static, context);
        }
    }
    return unfinished;
}

/* The td_pushes of a step use the memory of scratch.impacts, which is filled later in the step. */
int td_gaps_room(const thud_world *w) {
    size_t bytes = (size_t)w->scratch.blocks.count * sizeof(td_pushes);
    return (int)(bytes / (size_t)w->scratch.impacts.stride) + 1;
}

/* Clamps motions to the bounds of td_motion_held: if a body in contact spins fast, the projection
 * may give it a motion of any size. */
static void clamp_motions(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        float *delta = td_row(&w->delta, slot);
        for (int k = 0; k < 3; k++) {
            delta[k] = (float)td_motion_held(w, k, (double)delta[k]);
        }
    }
}

void td_gaps_project(thud_world *w) {
    td_project_context context = context_of(w);
    int passes = 0, unfinished_max = 0;
    memset(w->scratch.impacts.data, 0, (size_t)w->scratch.blocks.count * sizeof(td_pushes));
    while (passes < PASSES_MAX && project_once(w, &context) > unfinished_max) {
        passes++;
        context.over_relaxation = passes < PLAIN_PASSES ? 1.0f : OVER_RELAXATION;
        if (passes == FINE_PASSES) {
            context.enough = context.collision_distance;
            context.closing = context.closing_max;
            unfinished_max = w->scratch.blocks.count;
        }
    }
    context.over_relaxation = 1.0f;
    for (int i = 0; i < FINAL_PASSES && passes > PLAIN_PASSES; i++) {
        project_once(w, &context);
    }
    if (passes > 0) {
        clamp_motions(w);
    }
    w->errors.projected = passes > 0;
}

void td_gaps_find_open(thud_world *w) {
    td_project_context context = context_of(w);
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = contact_run_at(w, i);
        if (run) {
            bool round = run->kind == TD_PAIR_CIRCLE_CIRCLE || run->kind == TD_PAIR_AABB_AABB;
            TD_PICK_WIDE(w, td_find_open_points)
            (blocks_of(w, run), run->count, td_form_points(w->kinds[run->kind]->form),
             !round || run->has_offsets, &context);
        }
    }
}

/* A component of the motion that the body's velocity would give in a whole step (`by_velocity`), or
 * of the motion of its trajectory, which the projection or an impact may have changed. k: 0 and 1
 * for x, y (lengths), 2 for the angle (radians). Slot 0 is at rest. */
static double motion_of(const thud_world *w, td_awake_slot slot, int k, bool by_velocity) {
    if (by_velocity) {
        return (double)td_row(&w->velocity, slot)[k] * w->def.time_step;
    }
    return slot.at > 0 ? td_trajectory_at(w, slot)->motion[k] : 0.0;
}

/* Whether two touching bodies rest on each other: no point of one moves relative to the other by as
 * much as the impact distance in a step, neither by their velocities nor by their motions in this
 * step. */
static bool rests(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    double motion_max = (double)(TD_IMPACT_DISTANCE * w->length_scale);
    bool rest = true;
    for (int i = 0; i < 2; i++) {
        double x = motion_of(w, b, 0, i) - motion_of(w, a, 0, i);
        double y = motion_of(w, b, 1, i) - motion_of(w, a, 1, i);
        double rims = td_abs(motion_of(w, a, 2, i)) * (double)td_row(&w->reach, a)[1] +
                      td_abs(motion_of(w, b, 2, i)) * (double)td_row(&w->reach, b)[1];
        rest &= __builtin_sqrt(x * x + y * y) + rims < motion_max;
    }
    return rest;
}

bool td_gap_is_left_to_solver(const thud_world *w, const td_constraint *contact) {
    td_awake_slot a = td_moving_slot(w, contact->body[0]), b = td_moving_slot(w, contact->body[1]);
    return td_is_tied(w, a) || td_is_tied(w, b) || rests(w, a, b);
}

bool td_gap_was_found_open(const thud_world *w, const td_constraint *contact) {
    td_lane at = td_lane_of(w, contact);
    return td_gap_is_left_to_solver(w, contact) || at.block->apart >> at.lane & 1;
}

/* The displacement of a body at `time` from the start of the step: x, y (lengths), angle
 * (radians). */
static void displacement_of(const thud_world *w, td_body_index body, double time,
                            double displacement[3]) {
    td_awake_slot slot = td_body_at(w, body)->awake;
    displacement[0] = displacement[1] = displacement[2] = 0.0;
    if (slot.at > 0) {
        td_trajectory_displacement(w, td_trajectory_at(w, slot), time, displacement);
    }
}

/* The relative displacement of a contact's bodies from the start of the step, in the directions of
 * its rows. Lengths. */
typedef struct relative_motion {
    double along;          /* displacement of b relative to a along the normal */
    double turn_a, turn_b; /* radians */
    double row_error;      /* bound on the error of the rows, whose normal and arms do not turn */
    double turn_reach;     /* bound on how far turns move any point along the normal */
    double slide;          /* displacement across the normal plus turn_reach */
} relative_motion;

/* The relative displacement at `time`. With T the sum of both turns, E that of both extents and D
 * the distance by which the centres moved, row_error = T (T E / 2 + D): an arm turns off its
 * tangent by T^2 E / 2 at most, and the normal turns by T at most. */
static relative_motion relative_motion_at(const thud_world *w, const td_contact *contact,
                                          const td_block *block, int lane, double time) {
    double a[3], b[3];
    displacement_of(w, contact->body[0], time, a);
    displacement_of(w, contact->body[1], time, b);
    double x = b[0] - a[0], y = b[1] - a[1];
    double turn = td_abs(a[2]) + td_abs(b[2]);
    double max_extent = (double)(td_body_at(w, contact->body[0])->max_extent +
                                 td_body_at(w, contact->body[1])->max_extent);
    return (relative_motion){.along = x * (double)block->nx[lane] + y * (double)block->ny[lane],
                             .turn_a = a[2],
                             .turn_b = b[2],
                             .row_error =
                                 turn * (0.5 * turn * max_extent + __builtin_sqrt(x * x + y * y)),
                             .turn_reach = turn * max_extent,
                             .slide =
                                 td_abs(x * (double)block->ny[lane] - y * (double)block->nx[lane]) +
                                 turn * max_extent};
}

/* For a contact of two points on one face: the length by which the gap may shrink per length of
 * sliding. The two points are the ends of the other shape's edge. If that edge is inclined to the
 * face, sliding may bring a part of it that is nearer to the face to the place of a contact point.
 * 0 if both points are at one place. */
static double edge_slope(const td_block *block, int lane) {
    const td_point *p = block->point;
    double width = td_abs((double)p[0].cross_b[lane] - (double)p[1].cross_b[lane]);
    double rise = td_abs((double)p[0].start_separation[lane] - (double)p[1].start_separation[lane]);
    return width > 0.0 ? rise / width : 0.0;
}

/* Whether both shapes are circles about their centres of mass, so that turns do not change the
 * gap. */
static bool are_centred_circles(const thud_world *w, const td_contact *contact) {
    const td_shape *a = td_shape_at(w, contact->shape_a), *b = td_shape_at(w, contact->shape_b);
    return td_kind_is_round(a->kind) && td_kind_is_round(b->kind) && a->arm_x == 0.0f &&
           a->arm_y == 0.0f && b->arm_x == 0.0f && b->arm_y == 0.0f;
}

bool td_gap_stays_open(const thud_world *w, const td_contact *contact, double now) {
    td_lane at = td_lane_of(w, (const td_constraint *)contact);
    const td_block *block = at.block;
    double unit = (double)(TD_IMPACT_DISTANCE * w->length_scale), skin = (double)w->skin;
    relative_motion start = relative_motion_at(w, contact, block, at.lane, now);
    relative_motion end = relative_motion_at(w, contact, block, at.lane, 1.0);
    int points = td_form_points(w->kinds[contact->kind]->form), present = 0;
    /* Bound on how much smaller a gap may be than its row says: the error of the row, which centred
     * circles do not have, and what sliding along an inclined edge takes away. */
    double slack =
        are_centred_circles(w, contact) ? 0.0 : td_max_double(start.row_error, end.row_error);
    bool stays_open = block->restitution[at.lane] < 1.0f;
    slack += points == 2 ? edge_slope(block, at.lane) * td_max_double(start.slide, end.slide) : 0.0;
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        if (p->normal_mass[at.lane] == 0.0f) {
            continue;
        }
        double cross_a = (double)p->cross_a[at.lane], cross_b = (double)p->cross_b[at.lane];
        double at_start = (double)p->start_separation[at.lane] + skin;
        double from = at_start + start.along + start.turn_b * cross_b - start.turn_a * cross_a;
        double to = at_start + end.along + end.turn_b * cross_b - end.turn_a * cross_a;
        present++;
        /* A load closes a gap by at most TD_LOAD_CLOSING_MAX. If a gap seems to have shrunk by
         * more, the shapes have moved past each other, and the row is no longer valid. */
        stays_open &= from >= at_start - TD_LOAD_CLOSING_MAX * unit;
        stays_open &= to - slack >= td_min_double((double)COLLISION_DISTANCE * unit,
                                                  from - TD_LOAD_CLOSING_MAX * unit);
    }
    /* A missing point means that its gap was above TD_SPECULATIVE at the start of the step. */
    if (present < points) {
        stays_open &=
            (double)(TD_SPECULATIVE * w->length_scale) + end.along - end.turn_reach - slack >=
            (double)COLLISION_DISTANCE * unit;
    }
    return present > 0 && stays_open;
}
