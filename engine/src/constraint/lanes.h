/* lanes.h: assigns lanes of blocks (block.h) to the constraints that act, and lists the blocks for
 * the solver.
 *
 * The graph of constraints is coloured greedily, as in Box2D v3's src/constraint_graph.c:
 * constraints of one colour share no moving (awake and dynamic) body, so that they are solved in
 * parallel. A bin is the doubly linked list of the blocks of one kind of constraint and one colour;
 * constraints whose side a is static have bins of their own. One more bin of each kind has the
 * lanes of sleeping bodies. A constraint that finds no free colour goes to the overflow colour,
 * whose blocks have one lane each.
 *
 * A place is a range of TD_PLACE_SLOTS awake slots. Constraints of two moving bodies with one of
 * the first colours (TD_PLACED_COLOURS) have a bin for each place: that of the lower of both slots
 * when the lane is taken. Bodies that are near each other in the world mostly have near slots, too.
 * So the blocks of a place read and write the same few records, and workers that solve different
 * places seldom write the same cache lines.
 *
 * Invariants: all blocks of a bin but the last are full (when a lane becomes free, the bin's last
 * lane moves into it). Which lane a constraint has depends only on the history of the world, never
 * on addresses or workers. */
#ifndef TD_LANES_H
#define TD_LANES_H

#include "state/world.h"

/* A run of blocks of one bin, in the order of solving. */
typedef struct td_run {
    int32_t kind, a_static; /* kind of the constraints; `a_static` 1: side a is static */
    int32_t bin;   /* colour, + TD_COLOURS where a_static. Runs with equal `bin`, even of different
                      kinds or places, have no moving body in common, but in the overflow colour */
    int32_t place; /* number of its bin's place; 0 where the bins of the colour have none */
    int32_t first, count; /* blocks, in scratch.blocks */
    int32_t has_offsets;  /* 1: one of its blocks has offsets (td_block.has_offsets) */
    int32_t shared;       /* 1: one of its blocks is shared, so that only one worker may solve it */
} td_run;

/* Whether two blocks of the run may contain the same body, so that the run cannot be divided among
 * workers: in the overflow colour, and with kinematic bodies, which take no colours. */
static inline bool td_run_is_single(const td_run *run) {
    return run->shared || run->bin % TD_COLOURS == TD_OVERFLOW;
}

/* The number of the bin of a colour, below TD_PLACED_COLOURS, and a place. The bins of the first
 * place have the numbers of their colours, as have bins that are not by place. */
static inline int td_bin_of_place(int colour, int place) {
    return place == 0 ? colour : TD_BINS_A_KIND + (place - 1) * TD_PLACED_COLOURS + colour;
}

/* The colour (as td_run.bin) of a bin that is not TD_SLEEPING. */
static inline int td_colour_of_bin(int bin) {
    return bin < TD_BINS_A_KIND ? bin : (bin - TD_BINS_A_KIND) & (TD_PLACED_COLOURS - 1);
}

/* The block with this index in the pool of its kind's form. */
static inline td_block *td_block_at(const thud_world *w, int kind, int index) {
    return td_slot_at(&w->pool[w->kinds[kind]->form], index);
}

/* The lane operations of contacts, defined in contact/contact_lanes.c. */
extern const td_lane_ops td_contact_lanes;

static inline const td_lane_ops *td_lane_ops_of(const thud_world *w, int kind) {
    const td_lane_ops *own = w->kinds[kind]->lanes;
    return own ? own : &td_contact_lanes;
}

/* The lane of a constraint that acts. td_constraint.slot packs both into one number, and has
 * another meaning while the constraint waits. */
typedef struct td_lane {
    td_block *block;
    int lane;
} td_lane;

static inline td_lane td_lane_of(const thud_world *w, const td_constraint *constraint) {
    assert(constraint->state == TD_TOUCHING);
    return (td_lane){td_block_at(w, constraint->kind, constraint->slot / TD_LANES),
                     constraint->slot % TD_LANES};
}

/* See td_constraints_fetch. */
void td_constraints_fetch_ahead(const thud_world *w, const int *constraints, int count, int i);

/* For a loop over a list of constraints, whose records are scattered in memory like those of their
 * bodies and shapes: at index i it prefetches what the loop will read of later constraints. Does
 * nothing in a small world (td_fetches). */
static inline void td_constraints_fetch(const thud_world *w, const int *constraints, int count,
                                        int i) {
    if (td_fetches(w)) {
        td_constraints_fetch_ahead(w, constraints, count, i);
    }
}

/* Gives each of the constraints a lane in the bin of its graph colour. A constraint that wakes with
 * its bodies already has a lane, among the sleeping ones, whose contents are moved. False when
 * memory is short; nothing has changed then. */
bool td_lanes_place(thud_world *w, const int *constraints, int count);
/* Moves the lanes of these constraints, with all that they contain, from the bins of their colours
 * to the bin that each kind of constraint has for sleeping bodies, which the solver does not visit.
 * td_lanes_reserve_sleeping must have been called before: it reserves memory for any number of
 * lanes. */
void td_lanes_put_to_sleep(thud_world *w, const int *constraints, int count);
bool td_lanes_reserve_sleeping(thud_world *w);
/* Frees the constraint's lane. */
void td_lane_remove(thud_world *w, int constraint);

/* Lists blocks, runs and chunks in the order of solving, in scratch, unless they are listed
 * already. Bins of pairs of moving bodies come first and those with a static side last, so that
 * contacts with the ground are solved last and have the smallest remaining error. False when memory
 * is short. */
bool td_lanes_sequence(thud_world *w);

/* Updates the awake slots and inverse inertias of a lane, after those of a body have changed. */
void td_lane_refresh(thud_world *w, int constraint);
/* td_lane_refresh; and the next narrowphase computes manifold and effective masses of the lane
 * anew, in place of reusing those of earlier steps. */
void td_lane_renew(thud_world *w, int constraint);

#endif
