/* lanes.c: see lanes.h.
 *
 * A constraint gets the lowest colour that is free at both of its bodies (td_colours). Static and
 * kinematic bodies take no colour, since the solver does not change them. So several blocks of a
 * colour may contain the same kinematic body, and one worker alone solves their run
 * (td_block.shared). Their constraints get colours from TD_KINEMATIC_COLOUR on. Other constraints
 * rarely need colours that high, so that few of them are in runs that a single worker has to solve.
 */
#include "constraint/lanes.h"

#include "constraint/chunks.h"

#include <string.h>

/* The pool from which the kind's blocks are taken. */
static td_slots *pool_of(thud_world *w, int kind) {
    return &w->pool[w->kinds[kind]->form];
}

/* The bins with the number `bin` (td_bin_of_place: a colour, and a place), of all kinds of
 * constraints. */
static td_bins *bins_at(thud_world *w, int bin) {
    int placed = bin - TD_BINS_A_KIND;
    return placed < 0 ? &w->bins[bin] : TD_AT(td_bins, &w->placed_bins, placed);
}

static td_bin *bin_at(thud_world *w, int kind, int bin) {
    return &bins_at(w, bin)->of[kind];
}

/* The awake slot of a dynamic body, which the solver moves; 0 for other bodies. */
static td_awake_slot moving_slot(const td_body *body) {
    return body->kind == THUD_BODY_DYNAMIC && body->awake.at > 0 ? body->awake : (td_awake_slot){0};
}

/* Whether a bin is of the overflow colour. */
static bool is_overflow(int bin) {
    return bin < TD_SLEEPING && bin % TD_COLOURS == TD_OVERFLOW;
}

/* Sets or clears the colour of a bin at a body. Slot 0 and the bin of sleeping lanes have none. The
 * overflow colour, which several constraints of a body may have, stays marked until the body
 * sleeps. */
static void mark_colour(thud_world *w, td_awake_slot slot, int bin, bool taken) {
    if (slot.at > 0 && bin != TD_SLEEPING && (taken || !is_overflow(bin))) {
        td_colours *colours = td_colours_at(w, slot);
        int colour = td_colour_of_bin(bin);
        uint64_t *mask = colour < TD_COLOURS ? &colours->with_moving : &colours->with_static;
        uint64_t bit = 1ull << (colour % TD_COLOURS);
        *mask = taken ? *mask | bit : *mask & ~bit;
    }
}

/* Chooses the bin of a constraint, and takes its colour at both bodies. `place_slots`: awake slots
 * of a place. */
static int choose_bin(thud_world *w, const td_constraint *constraint, int place_slots) {
    const td_body *a = td_body_at(w, constraint->body[0]);
    const td_body *b = td_body_at(w, constraint->body[1]);
    bool a_static = a->kind == THUD_BODY_STATIC;
    td_awake_slot slot_a = moving_slot(a), slot_b = moving_slot(b);
    uint64_t taken = 1ull << TD_OVERFLOW;
    if (a->kind == THUD_BODY_KINEMATIC || b->kind == THUD_BODY_KINEMATIC) {
        taken |= (1ull << TD_KINEMATIC_COLOUR) - 1;
    }
    if (slot_a.at) {
        taken |= td_colours_at(w, slot_a)->with_moving;
    }
    if (slot_b.at) {
        taken |= a_static ? td_colours_at(w, slot_b)->with_static
                          : td_colours_at(w, slot_b)->with_moving;
    }
    int colour = ~taken ? __builtin_ctzll(~taken) : TD_OVERFLOW;
    int bin = colour + (a_static ? TD_COLOURS : 0);
    mark_colour(w, slot_a, bin, true);
    mark_colour(w, slot_b, bin, true);
    if (bin < TD_PLACED_COLOURS) {
        int slot = td_min_int(slot_a.at, slot_b.at);
        bin = td_bin_of_place(bin, slot / place_slots & (TD_PLACES_MAX - 1));
    }
    return bin;
}

/* Makes the colour of the constraint's bin free again at both bodies. */
static void release_bin(thud_world *w, const td_constraint *constraint, int bin) {
    mark_colour(w, moving_slot(td_body_at(w, constraint->body[0])), bin, false);
    mark_colour(w, moving_slot(td_body_at(w, constraint->body[1])), bin, false);
}

/* The number of lanes that blocks of the bin use. */
static int lanes_a_block(int bin) {
    return is_overflow(bin) ? 1 : TD_LANES;
}

/* Takes an empty block from the pool, where one must be reserved. Returns its index. */
static int take_block(thud_world *w, int kind) {
    td_slots *pool = pool_of(w, kind);
    int index = td_slots_take(pool);
    td_block *block = td_slot_at(pool, index);
    memset(block, 0, (size_t)pool->stride);
    for (int i = 0; i < TD_LANES; i++) {
        block->constraint[i] = TD_NONE;
    }
    return index;
}

/* Bytes of a row of eight words, one a lane; and the index of the one row that belongs to the block
 * as a whole (td_block.next and the fields after it). */
enum { ROW = (int)sizeof(f8), OWN_ROW = (int)offsetof(td_block, next) / ROW };

/* Copies one lane of the first `bytes` bytes of a block. The block's own row is copied like the
 * others and then restored, which saves a test in each row. */
static void copy_lane(td_block *to, int to_lane, const td_block *from, int from_lane, int bytes) {
    uint32_t *t = (uint32_t *)to + to_lane;
    const uint32_t *f = (const uint32_t *)from + from_lane;
    uint32_t own = t[OWN_ROW * TD_LANES];
    for (int row = 0; row < bytes / ROW; row++) {
        t[row * TD_LANES] = f[row * TD_LANES];
    }
    t[OWN_ROW * TD_LANES] = own;
    to->bouncy |= to->restitution[to_lane] > 0.0f;
    to->has_offsets |= from->has_offsets; /* for joints the same bits are anchors_stale */
    to->shared |= from->shared;
    to->touching =
        (to->touching & ~(1u << to_lane)) | ((from->touching >> from_lane & 1u) << to_lane);
}

/* Makes a lane empty: all zeros, so that it has no mass and both sides are the dummy. */
static void clear_lane(td_block *block, int lane, int bytes) {
    uint32_t *t = (uint32_t *)block + lane, own = t[OWN_ROW * TD_LANES];
    for (int row = 0; row < bytes / ROW; row++) {
        t[row * TD_LANES] = 0;
    }
    t[OWN_ROW * TD_LANES] = own;
    block->constraint[lane] = TD_NONE;
    block->touching &= ~(1u << lane);
}

/* Adds a lane to the end of a bin. Returns the index of its block; *lane is its number there. */
static int bin_grow(thud_world *w, int kind, int index, int *lane) {
    td_bin *bin = bin_at(w, kind, index);
    if (bin->lanes % lanes_a_block(index) == 0) { /* all blocks of the bin are full */
        w->scratch.sequenced = false;
        int colour = td_colour_of_bin(index);
        int *bin_end = &w->scratch.bin_end[colour / TD_COLOURS];
        *bin_end = td_max_int(*bin_end, colour + 1);
        w->scratch.placed_end = td_max_int(w->scratch.placed_end, index + 1);
        int block = take_block(w, kind);
        td_block *new_block = td_block_at(w, kind, block);
        new_block->next = TD_NONE;
        new_block->prev = bin->lanes ? bin->tail : TD_NONE;
        if (bin->lanes) {
            td_block_at(w, kind, bin->tail)->next = block;
        } else {
            bin->head = block;
        }
        bin->tail = block;
    }
    bin->lanes++;
    *lane = td_block_at(w, kind, bin->tail)->used++;
    return bin->tail;
}

/* Takes a lane out of its bin; the last lane of the bin moves into its place. */
static void bin_shrink(thud_world *w, int kind, int index, int slot) {
    td_bin *bin = bin_at(w, kind, index);
    td_slots *pool = pool_of(w, kind);
    int bytes = pool->stride;
    td_block *tail = td_block_at(w, kind, bin->tail);
    int last = tail->used - 1;
    if (slot != bin->tail * TD_LANES + last) {
        td_block *hole = td_block_at(w, kind, slot / TD_LANES);
        copy_lane(hole, slot % TD_LANES, tail, last, bytes);
        td_constraint_at(w, hole->constraint[slot % TD_LANES])->slot = slot;
    }
    clear_lane(tail, last, bytes);
    tail->used--;
    bin->lanes--;
    if (tail->used == 0) {
        w->scratch.sequenced = false;
        int block = bin->tail;
        bin->tail = tail->prev;
        if (bin->lanes) {
            td_block_at(w, kind, bin->tail)->next = TD_NONE;
        }
        td_slots_give(pool, block);
    }
}

/* Sets the sides' awake slots and inverse inertias in a lane. */
static void set_slots(thud_world *w, td_block *block, int lane, const td_constraint *constraint) {
    const td_body *a = td_body_at(w, constraint->body[0]);
    const td_body *b = td_body_at(w, constraint->body[1]);
    block->a[lane] = td_side_of_slot(a->awake);
    block->b[lane] = td_side_of_slot(b->awake);
    block->inv_inertia_a[lane] = a->inv_inertia;
    block->inv_inertia_b[lane] = b->inv_inertia;
}

/* Gives a constraint a lane in a bin, with the contents of the lane that it has, which becomes
 * free, or, if it has none, those that td_lane_ops.fill of its kind writes. */
static void place(thud_world *w, int index, int bin) {
    td_constraint *constraint = td_constraint_at(w, index);
    int kind = constraint->kind, lane;
    int block = bin_grow(w, kind, bin, &lane);
    if (constraint->state == TD_TOUCHING) {
        td_lane from = td_lane_of(w, constraint);
        copy_lane(td_block_at(w, kind, block), lane, from.block, from.lane,
                  pool_of(w, kind)->stride);
        bin_shrink(w, kind, constraint->bin, constraint->slot);
    } else {
        td_block *own = td_block_at(w, kind, block);
        own->constraint[lane] = index;
        own->touching |= 1u << lane;
        td_lane_ops_of(w, kind)->fill(w, own, lane, index);
        w->touching += td_is_contact(constraint);
    }
    set_slots(w, td_block_at(w, kind, block), lane, constraint);
    /* A kinematic body takes no colour, so that other blocks may also contain it: a single worker
     * must solve the run. */
    if (td_body_at(w, constraint->body[0])->kind == THUD_BODY_KINEMATIC ||
        td_body_at(w, constraint->body[1])->kind == THUD_BODY_KINEMATIC) {
        td_block_at(w, kind, block)->shared = 1;
        w->scratch.sequenced = false;
    }
    constraint->state = TD_TOUCHING;
    constraint->bin = (uint16_t)bin;
    constraint->slot = block * TD_LANES + lane;
}

/* Reserves so many blocks of each form. False when memory is short. */
static bool reserve_blocks(thud_world *w, const int more[TD_FORM_COUNT]) {
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        if (!td_slots_reserve(&w->memory, &w->pool[form], more[form])) {
            return false;
        }
    }
    return true;
}

/* Each lane that moves to the bin of sleeping lanes becomes free in its own bin. So a kind needs
 * more blocks than it uses now only because blocks may be partly filled: the last block of each bin
 * that loses lanes, and the last one of the bin of sleeping lanes. */
bool td_lanes_reserve_sleeping(thud_world *w) {
    int more[TD_FORM_COUNT] = {0};
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        int used = 0;
        for (int bin = 0; bin < TD_BINS_A_KIND + w->placed_bins.count; bin++) {
            used += bin_at(w, kind, bin)->lanes > 0;
        }
        if (used > 0) {
            more[w->kinds[kind]->form] += used + 1;
        }
    }
    return reserve_blocks(w, more);
}

/* How many constraints ahead of the loop each record is prefetched: far enough that the record
 * which refers to it has arrived from memory. Chosen. */
enum { FETCH_RECORD = 24, FETCH_BODIES = 12, FETCH_EDGES = 6 };

/* Prefetches the bodies and shapes of a constraint: the cache lines of their records that are read
 * when contacts begin, take lanes and end. */
static void fetch_bodies(const thud_world *w, const td_constraint *constraint) {
    for (int side = 0; side < 2; side++) {
        const td_body *body = td_body_at(w, constraint->body[side]);
        __builtin_prefetch(body, 1);
        __builtin_prefetch(&body->inv_inertia);
        int shape = side ? constraint->shape_b : constraint->shape_a;
        if (shape != TD_NONE) {
            __builtin_prefetch(td_shape_at(w, shape));
            __builtin_prefetch(&td_shape_at(w, shape)->friction);
            __builtin_prefetch(td_shape_proxy_at(w, shape));
        }
    }
}

/* Prefetches the colours of a constraint's bodies, and its neighbours in their lists of edges. */
static void fetch_edges(const thud_world *w, const td_constraint *constraint) {
    for (int side = 0; side < 2; side++) {
        int slot = td_body_at(w, constraint->body[side])->awake.at;
        __builtin_prefetch(td_colours_at(w, (td_awake_slot){slot > 0 ? slot : 0}), 1);
        int near_edges[] = {constraint->next[side], constraint->prev[side]};
        for (int k = 0; k < 2; k++) {
            if (near_edges[k] != TD_NONE) {
                __builtin_prefetch(td_constraint_at(w, td_edge_constraint(near_edges[k])), 1);
            }
        }
    }
}

void td_constraints_fetch_ahead(const thud_world *w, const int *constraints, int count, int i) {
    if (i + FETCH_RECORD < count) {
        __builtin_prefetch(td_constraint_at(w, constraints[i + FETCH_RECORD]), 1);
    }
    if (i + FETCH_BODIES < count) {
        fetch_bodies(w, td_constraint_at(w, constraints[i + FETCH_BODIES]));
    }
    if (i + FETCH_EDGES < count) {
        fetch_edges(w, td_constraint_at(w, constraints[i + FETCH_EDGES]));
    }
}

/* Makes the bins of the places of all awake slots; new elements of an array are zeroed, which are
 * empty bins. False when memory is short. */
static bool make_places(thud_world *w) {
    td_array *bins = &w->placed_bins;
    int places = w->body_of.count / TD_PLACE_SLOTS; /* but the first one */
    int count = td_max_int(bins->count, places * TD_PLACED_COLOURS);
    if (!td_array_reserve(&w->memory, bins, count)) {
        return false;
    }
    bins->count = count;
    return true;
}

/* While there is less than one touching contact for this many awake bodies, new lanes are taken in
 * bins of the first place alone, since blocks by place would mostly be empty. Chosen. */
enum { BODIES_A_CONTACT = 8 };

bool td_lanes_place(thud_world *w, const int *constraints, int count) {
    if (count == 0) {
        return true;
    }
    if (!td_array_reserve(&w->memory, &w->scratch.lane_bins, count) || !make_places(w)) {
        return false;
    }
    /* Gives each constraint a lane of its bin, to count the blocks that are needed, and takes the
     * lanes back. */
    int *bins = w->scratch.lane_bins.data, more[TD_FORM_COUNT] = {0};
    bool few = (w->touching + count) * BODIES_A_CONTACT < w->body_of.count;
    int place_slots = few ? INT32_MAX : TD_PLACE_SLOTS;
    for (int i = 0; i < count; i++) {
        const td_constraint *constraint = td_constraint_at(w, constraints[i]);
        int kind = constraint->kind, bin = bins[i] = choose_bin(w, constraint, place_slots);
        more[w->kinds[kind]->form] += bin_at(w, kind, bin)->lanes++ % lanes_a_block(bin) == 0;
    }
    bool reserved = reserve_blocks(w, more);
    for (int i = 0; i < count; i++) {
        const td_constraint *constraint = td_constraint_at(w, constraints[i]);
        bin_at(w, constraint->kind, bins[i])->lanes--;
        if (!reserved) {
            release_bin(w, constraint, bins[i]);
        }
    }
    if (!reserved) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        td_constraints_fetch(w, constraints, count, i);
        place(w, constraints[i], bins[i]);
    }
    return true;
}

void td_lanes_put_to_sleep(thud_world *w, const int *constraints, int count) {
    for (int i = 0; i < count; i++) {
        const td_constraint *constraint = td_constraint_at(w, constraints[i]);
        release_bin(w, constraint, constraint->bin);
        place(w, constraints[i], TD_SLEEPING);
    }
}

void td_lane_remove(thud_world *w, int index) {
    td_constraint *constraint = td_constraint_at(w, index);
    assert(constraint->state == TD_TOUCHING);
    release_bin(w, constraint, constraint->bin);
    td_lane at = td_lane_of(w, constraint);
    /* Removes the lane from the world's counts of contacts with restitution or a surface speed. */
    td_lane_ops_of(w, constraint->kind)->clear(w, at.block, at.lane, index);
    bin_shrink(w, constraint->kind, constraint->bin, constraint->slot);
    w->touching -= td_is_contact(constraint);
}

void td_lane_refresh(thud_world *w, int index) {
    const td_constraint *constraint = td_constraint_at(w, index);
    td_lane at = td_lane_of(w, constraint);
    set_slots(w, at.block, at.lane, constraint);
}

void td_lane_renew(thud_world *w, int index) {
    const td_constraint *constraint = td_constraint_at(w, index);
    td_lane at = td_lane_of(w, constraint);
    td_lane_refresh(w, index);
    td_lane_ops_of(w, constraint->kind)->renew(w, at.block, at.lane, index);
}

/* Prefetches the block that stood eight places further on when the list was last made: most likely
 * it will stand there again. To find it by the links between the blocks, which are scattered in
 * memory, the loop would have to wait for each block on the way. */
static void prefetch_listed(const td_array *blocks) {
    int ahead = blocks->count + 8;
    if (ahead < blocks->capacity) {
        uintptr_t block = (uintptr_t)*TD_AT(td_block *, blocks, ahead);
        __builtin_prefetch((const void *)(block + offsetof(td_block, next)));
    }
}

/* Appends the run of a bin to scratch.runs, and its blocks to scratch.blocks. `colour` as
 * td_run.bin. */
static void list_bin(thud_world *w, const td_bin *bin, int kind, int colour, int place) {
    td_array *runs = &w->scratch.runs, *blocks = &w->scratch.blocks;
    td_run *run = &TD_PUSH(td_run, runs);
    *run = (td_run){.kind = kind,
                    .a_static = colour >= TD_COLOURS,
                    .bin = colour,
                    .place = place,
                    .first = blocks->count};
    for (int i = bin->head; i != TD_NONE;) {
        td_block *block = td_block_at(w, kind, i);
        TD_PUSH(td_block *, blocks) = block;
        prefetch_listed(blocks);
        run->count++;
        run->has_offsets |= block->has_offsets;
        run->shared |= block->shared;
        i = block->next;
    }
    w->scratch.points += TD_HAS_THREADS ? run->count * td_form_points(w->kinds[kind]->form) : 0;
}

/* Lists the bins of a colour, place by place up to the last one that may have lanes. Of a place,
 * contacts come last, so that joints do not push bodies back into an overlap that contacts have
 * corrected. */
static void list_colour(thud_world *w, int colour, int placed_end) {
    int place = 0, bin = colour;
    do {
        const td_bins *bins = bins_at(w, bin);
        for (int i = 0; i < TD_CONSTRAINT_KINDS; i++) {
            int kind = (TD_PAIR_COUNT + i) % TD_CONSTRAINT_KINDS;
            if (bins->of[kind].lanes) {
                list_bin(w, &bins->of[kind], kind, colour, place);
                w->scratch.placed_end = td_max_int(w->scratch.placed_end, bin + 1);
            }
        }
        bin = td_bin_of_place(colour, ++place);
    } while (colour < TD_PLACED_COLOURS && bin < placed_end);
}

bool td_lanes_sequence(thud_world *w) {
    if (w->scratch.sequenced) {
        return true;
    }
    int blocks_max = 0;
    int runs_max = (2 * TD_COLOURS + w->placed_bins.count) * TD_CONSTRAINT_KINDS;
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        blocks_max += w->pool[form].live;
    }
    if (!td_array_reserve(&w->memory, &w->scratch.blocks, blocks_max) ||
        !td_array_reserve(&w->memory, &w->scratch.separated, 2 * blocks_max + 1) ||
        !td_array_reserve(&w->memory, &w->scratch.runs, runs_max)) {
        return false;
    }
    w->scratch.blocks.count = 0;
    w->scratch.runs.count = 0;
    w->scratch.points = 0;
    w->stats.colours = 0;
    int placed_end = w->scratch.placed_end;
    w->scratch.placed_end = 0;
    for (int half = 0; half < 2; half++) {
        for (int colour = half * TD_COLOURS; colour < w->scratch.bin_end[half]; colour++) {
            int before = w->scratch.blocks.count;
            list_colour(w, colour, placed_end);
            w->stats.colours += w->scratch.blocks.count > before;
        }
    }
    w->stats.blocks = w->scratch.blocks.count;
    if (!td_chunks_cut(w)) {
        return false;
    }
    w->scratch.sequenced = true;
    return true;
}
