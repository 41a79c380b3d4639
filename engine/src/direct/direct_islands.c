/* direct_islands.c: finds the islands that are solved directly in this step.
 *
 * An island is a connected component of dynamic bodies and the constraints that act between them.
 * It is direct if one of its bodies is marked (direct_steps). td_islands_mark_loaded marks the
 * bodies of a contact whose load is above a threshold (td_islands_load_max) in two successive
 * checks, while the two bodies hardly move against each other: an impact causes as high a load, but
 * for one step only; and the soft solver solves a moving heap equally well at lower cost. A step
 * checks an eighth of the blocks (in small worlds all), so that two checks are eight steps apart.
 * Where a heavy body lies on a light one, the contact sinks in at once, so that half the threshold,
 * exceeded once, is enough. A joint is marked as soon as its load exceeds the threshold once, and
 * its island is solved directly in the same step (direct/overloaded_joints.c). With overlap_limit 0
 * every island is direct. */
#include "direct/direct_islands.h"

#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "detection/detection.h"
#include "direct/elimination_order.h"
#include "direct/joint_tree.h"
#include "direct/lock_tree.h"

#include <string.h>

#define ARRAY(name, element) TD_ARRAY_PLACE(td_islands, name, element)

static const td_array_place ARRAYS[] = {
    ARRAY(island, td_island),
    ARRAY(slots, td_awake_slot),
    ARRAY(constraints, int),
    ARRAY(local, int),
    ARRAY(island_start_velocity, float[4]),
    ARRAY(impulses, float[TD_DIRECT_ROWS + 1]),
    ARRAY(rows, td_direct_constraint),
    ARRAY(bodies, td_direct_body),
    ARRAY(step, double[4]),
    ARRAY(work, double[4]),
    ARRAY(tree, td_tree_body),
    ARRAY(locks, td_lock_body),
    ARRAY(listed, td_listed_body),
    ARRAY(results, td_lock_result),
    ARRAY(topology, int),
    ARRAY(topology_before, int),
    ARRAY(systems, td_system),
    ARRAY(start_velocity, float[4]),
};
enum { ARRAY_COUNT = sizeof ARRAYS / sizeof *ARRAYS };

void td_islands_init(td_islands *s, bool wide) {
    td_arrays_init(s, ARRAYS, ARRAY_COUNT);
    td_sparse_init(&s->matrix, wide);
}

void td_islands_free(td_memory *memory, td_islands *s) {
    td_arrays_free(memory, s, ARRAYS, ARRAY_COUNT);
    td_sparse_free(memory, &s->matrix);
}

/* Reserves room in each list for all bodies and constraints. False when memory is short. */
static bool reserve_lists(thud_world *w) {
    td_islands *s = &w->islands;
    int bodies = w->body_of.count, constraints = w->touching + TD_JOINT_PARTS * w->joints.live;
    return td_islands_reserve(w, &s->local, bodies) && td_islands_reserve(w, &s->island, bodies) &&
           td_islands_reserve(w, &s->slots, bodies) &&
           td_islands_reserve(w, &s->island_start_velocity, bodies) &&
           td_islands_reserve(w, &s->constraints, constraints) &&
           td_islands_reserve(w, &s->impulses, constraints) &&
           td_sparse_reserve(&w->memory, &s->matrix, bodies);
}

/* ---- which islands are direct ---- */

/* Whether every island without joints is direct: so under `bisect` and `swept`, whose contacts must
 * not give way under a load (take_island_solver, solver/quality.c). */
static bool contact_islands_are_direct(const thud_world *w) {
    return w->quality.detection->islands != NULL;
}

static bool any_direct(const thud_world *w) {
    const uint8_t *direct_steps = w->direct_steps.data;
    uint8_t any = 0;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        any |= direct_steps[slot.at];
    }
    return any > 0;
}

enum {
    COOLDOWNS_MAX = 5
}; /* cooldowns after which the time no longer doubles: 2^4 times TD_COOLDOWN_STEPS, half a minute
      at 60 steps a second. Chosen. */

/* Begins the cooldown of a body, which is its `times`th cooldown in succession. */
static void cool_down(thud_world *w, td_awake_slot slot, int steps, int times) {
    *td_direct_steps_at(w, slot) = (uint8_t)(TD_DIRECT_COOLDOWN + steps);
    *td_slow_steps_at(w, slot) = (uint16_t)(td_min_int(times, COOLDOWNS_MAX) * TD_SLOW_ONCE);
}

/* direct_steps of a body after this step. In the nth cooldown in succession it counts down once in
 * 2^(n - 1) steps. */
static int direct_after_step(const thud_world *w, td_awake_slot slot) {
    int direct_steps = *td_direct_steps_at(w, slot);
    uint64_t halvings = TD_SLOW_LEFT(*td_slow_steps_at(w, slot));
    bool counts = halvings == 0 || (w->steps & ((1ull << (halvings - 1)) - 1)) == 0;
    int left = direct_steps > TD_DIRECT_COOLDOWN && counts ? direct_steps - 1 : direct_steps;
    return left == TD_DIRECT_COOLDOWN ? 0 : left;
}

void td_islands_begin_cooldown(thud_world *w, const td_island *island, int steps, bool for_long) {
    for (int i = 0; i < island->bodies; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + i);
        int times = TD_SLOW_LEFT(*td_slow_steps_at(w, slot)) + 1;
        cool_down(w, slot, steps, for_long ? COOLDOWNS_MAX : times);
    }
}

void td_islands_count_down(thud_world *w) {
    uint8_t *direct_steps = w->direct_steps.data;
    for (td_awake_slot slot = {1}; slot.at < w->islands.local.count; slot.at++) {
        if (direct_steps[slot.at] == 0 && *td_island_local_at(w, slot) >= 0) {
            continue;
        }
        int after = direct_after_step(w, slot);
        if (direct_steps[slot.at] > TD_DIRECT_COOLDOWN && after == 0) {
            int times = TD_SLOW_LEFT(*td_slow_steps_at(w, slot));
            *td_slow_steps_at(w, slot) = (uint16_t)(times * TD_SLOW_ONCE);
        }
        direct_steps[slot.at] = (uint8_t)after;
        int local = *td_island_local_at(w, slot);
        if (local == TD_ISLAND_COOLING && after > 0 && after <= TD_DIRECT_COOLDOWN) {
            direct_steps[slot.at] = TD_DIRECT_COOLDOWN + TD_MOTION_PAUSE_STEPS;
        } else if (local == TD_ISLAND_TOO_MANY) {
            cool_down(w, slot, TD_COOLDOWN_STEPS, 1);
        } else if (local == TD_ISLAND_ALONE) {
            direct_steps[slot.at] = 0;
        }
    }
}

/* Adds the constraints of a body to its island, each once, and the bodies at their other sides.
 * False where the island has too many bodies. */
static bool add_constraints_of(thud_world *w, td_island *island, td_awake_slot slot) {
    td_body_index body = td_body_of(w, slot);
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->state != TD_TOUCHING) {
            continue;
        }
        td_awake_slot other = td_island_neighbour(w, constraint, td_edge_side(e));
        bool is_new = other.at && *td_island_local_at(w, other) == 0;
        if (other.at && (*td_island_local_at(w, other) == TD_ISLAND_TOO_MANY ||
                         (is_new && island->bodies == w->quality.island_limit))) {
            return false;
        }
        if (!other.at || !td_edge_side(e)) {
            td_push_int(&w->islands.constraints, td_edge_constraint(e));
        }
        if (is_new) {
            td_island_add(w, island, other);
        }
    }
    return true;
}

bool td_nearly_at_rest(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    float gx = w->def.gravity.x, gy = w->def.gravity.y;
    float max = td_max_float(4.0f * __builtin_sqrtf(gx * gx + gy * gy) * (float)w->def.time_step,
                             4.0f * TD_SLEEP_SPEED * w->length_scale);
    const float *v = td_row(&w->velocity, a), *u = td_row(&w->velocity, b);
    float x = u[0] - v[0], y = u[1] - v[1];
    return x * x + y * y < max * max;
}

int64_t td_island_cost(const td_island *island) {
    return island->system.work + island->bodies + 2 * (int64_t)island->constraints;
}

/* Whether an island is in its cooldown: more than half of its bodies are. So a heap stays in its
 * cooldown when a few bodies that are in none join it. */
static bool cools_down(const thud_world *w, const td_island *island) {
    int cooling = 0;
    for (int i = 0; i < island->bodies; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + i);
        cooling += *td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN;
    }
    return 2 * cooling > island->bodies;
}

/* Whether a body has joints, including those that do not act now (a limit that is not reached). */
static bool has_joints(const thud_world *w, td_awake_slot slot) {
    int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
    while (e != TD_NONE && td_constraint_at(w, td_edge_constraint(e))->kind < TD_PAIR_COUNT) {
        e = td_next_edge(w, e);
    }
    return e != TD_NONE;
}

/* Whether an island is direct: one of its bodies is marked, overlap_limit is 0, or, under `bisect`
 * and `swept`, it has no joints. */
static bool is_wanted(const thud_world *w, const td_island *island) {
    bool marked = w->quality.overlap_limit == 0.0f, jointed = false;
    for (int i = 0; i < island->bodies && !marked; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + i);
        marked = *td_direct_steps_at(w, slot) > 0;
        jointed |= w->joints.live > 0 && has_joints(w, slot);
    }
    return marked || !jointed;
}

void td_islands_list_from(thud_world *w, td_awake_slot seed) {
    td_islands *s = &w->islands;
    td_island island = {.first_body = s->slots.count, .first_constraint = s->constraints.count};
    bool whole = true;
    td_island_add(w, &island, seed);
    for (int i = island.first_body; whole && i < s->slots.count; i++) {
        whole = add_constraints_of(w, &island, td_slot_in(&s->slots, i));
    }
    island.constraints = s->constraints.count - island.first_constraint;
    bool cooling = cools_down(w, &island);
    bool wanted = whole && is_wanted(w, &island);
    if (wanted && island.constraints && !cooling) {
        TD_PUSH(td_island, &s->island) = island;
        return;
    }
    for (int i = island.first_body; i < s->slots.count; i++) {
        *td_island_local_at(w, td_slot_in(&s->slots, i)) = !whole    ? TD_ISLAND_TOO_MANY
                                                           : cooling ? TD_ISLAND_COOLING
                                                           : wanted  ? TD_ISLAND_ALONE
                                                                     : TD_ISLAND_SOFT;
    }
    s->slots.count = island.first_body;
    s->constraints.count = island.first_constraint;
}

/* Sets `local` of bodies in soft islands back to 0, so that a joint that becomes overloaded in this
 * step can still make their island direct (overloaded_joints.c). */
static void forget_soft(thud_world *w) {
    for (td_awake_slot slot = {1};
         slot.at < w->islands.local.count && contact_islands_are_direct(w); slot.at++) {
        int *local = td_island_local_at(w, slot);
        *local = *local == TD_ISLAND_SOFT ? 0 : *local;
    }
}

/* The soft contact is a spring of angular frequency omega = 2 pi f, so that under a given impulse
 * in each substep of length h it sinks in by s = (impulse / mass / h) / omega^2. contact_stiffness
 * is f h, and h is time_step / substeps, so that impulse / mass = s (2 pi contact_stiffness)^2
 * substeps / time_step. The number of substeps may be below the quality's own. overlap_limit is a
 * depth s at the quality's own number, max_error at the present one. Under a given force s is
 * proportional to h^2, so that the code multiplies each s by the square of its own number. Contacts
 * with static bodies have twice this frequency (solve_context, solver/solve.c), and sink in by
 * about a quarter of s; the threshold does not count that. */
static void set_load_max(thud_world *w) {
    float steps = (float)w->substeps, own = td_max_float(steps, (float)w->quality.substeps);
    float omega = 2.0f * (float)TD_PI * w->quality.contact_stiffness; /* rad a substep */
    float load_per_depth = omega * omega / (steps * (float)w->def.time_step);
    float depth_max = w->def.max_error > 0.0 ? (float)w->def.max_error : 3.0e38f;
    w->islands.load_max_per_size = w->quality.overlap_limit * (own * own) * load_per_depth;
    w->islands.load_max = depth_max * (steps * steps) * load_per_depth;
}

/* Whether a body is dynamic, and in no island that the search has found yet. */
static bool is_unlisted(const thud_world *w, td_awake_slot slot) {
    return *td_island_local_at(w, slot) == 0 && td_inv_mass_of(w, slot) > 0.0f;
}

bool td_islands_find(thud_world *w) {
    td_islands *s = &w->islands;
    int slots = w->body_of.count;
    s->island.count = s->slots.count = s->constraints.count = 0;
    s->local.count = 0;
    set_load_max(w);
    bool everywhere = w->quality.overlap_limit == 0.0f || contact_islands_are_direct(w);
    if (!everywhere && !any_direct(w) && !w->joints.live) {
        return true;
    }
    if (!reserve_lists(w)) {
        return false;
    }
    s->local.count = slots;
    memset(s->local.data, 0, (size_t)slots * sizeof(int));
    const uint8_t *direct_steps = w->direct_steps.data;
    for (td_awake_slot slot = {1}; slot.at < slots; slot.at++) {
        bool wanted = direct_steps[slot.at] > 0 || everywhere;
        if (wanted && direct_steps[slot.at] <= TD_DIRECT_COOLDOWN && is_unlisted(w, slot)) {
            td_islands_list_from(w, slot);
        }
    }
    forget_soft(w);
    return td_islands_order(w);
}

/* ---- load ---- */

/* Mass ratio of two bodies above which a load of half the threshold, found in one check, marks
 * them: under the soft solver a contact carries a ratio of up to some 30; above that it sinks in
 * before a second check. */
#define MASS_RATIO 30.0f

enum {
    ALL_BLOCKS = 32, /* worlds with fewer blocks have all of them checked in each step. Chosen. */
    TIMES_SEEN = 2   /* checks in succession in which a contact's load must be above the
                        threshold */
};

/* Marks a body as direct, unless it is not dynamic or is in its cooldown. `record`: td_block.a or
 * .b of a lane. */
static void mark_direct(thud_world *w, uint32_t record) {
    td_awake_slot slot = td_slot_of_side(record);
    uint8_t *direct_steps = td_direct_steps_at(w, slot);
    if (td_inv_mass_of(w, slot) > 0.0f && *direct_steps <= TD_DIRECT_COOLDOWN) {
        *direct_steps = TD_DIRECT_STEPS;
    }
}

/* Thickness of a body's thinnest shape, length; static bodies count as infinitely thick. */
static float size_of(const thud_world *w, td_awake_slot slot) {
    return slot.at ? 2.0f * td_row(&w->reach, slot)[0] : 3.0e38f;
}

float td_islands_size(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    return td_min_float(size_of(w, a), size_of(w, b));
}

/* Checks the loads of the lanes of one block, and marks the bodies of overloaded ones as direct. A
 * lane's `loaded` counts the checks in succession in which its load was above the threshold; the
 * flag TD_DIRECT in the same byte says that its impulses are the direct solver's. True if a joint
 * is marked. */
static bool watch_block(thud_world *w, td_block *block, int kind) {
    float deep = w->def.max_error > 0.0 ? (float)w->def.max_error : 3.0e38f;
    int points = td_form_points(w->kinds[kind]->form);
    bool contact = kind < TD_PAIR_COUNT, joint_marked = false;
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
        float inverse_a = td_inv_mass_of(w, a), inverse_b = td_inv_mass_of(w, b);
        float light = td_max_float(inverse_a, inverse_b),
              other = td_min_float(inverse_a, inverse_b);
        float size = td_islands_size(w, a, b), threshold = td_islands_load_max(&w->islands, size);
        float load = 0.0f, off = 0.0f;
        for (int k = 0; contact && k < points; k++) {
            load += block->point[k].normal_impulse[lane];
            off = td_max_float(off, -(block->point[k].separation[lane] + w->skin));
        }
        load = contact ? load * light : w->kinds[kind]->lanes->load(w, block, lane, size, &off);
        bool sinks = 2.0f * load > threshold && other > 0.0f && light > MASS_RATIO * other;
        int direct = block->mark[lane].loaded & TD_DIRECT,
            before = block->mark[lane].loaded - direct;
        /* A contact between moving bodies may be an impact, which lasts for one step; a joint's
         * load is taken to last. */
        bool overloaded =
            (load > threshold && (!contact || td_nearly_at_rest(w, a, b))) || off > deep;
        int seen = overloaded ? td_min_int(before + 1, TIMES_SEEN) : 0;
        if (sinks || seen >= (contact ? TIMES_SEEN : 1)) {
            mark_direct(w, block->a[lane]);
            mark_direct(w, block->b[lane]);
            joint_marked |= !contact;
        }
        block->mark[lane].loaded = (uint8_t)(seen | direct);
    }
    return joint_marked;
}

bool td_islands_mark_loaded(thud_world *w) {
    bool joint_marked = false;
    if (w->quality.overlap_limit == 0.0f) {
        return joint_marked;
    }
    int stride = w->scratch.blocks.count < ALL_BLOCKS ? 1 : 8;
    td_block *const *blocks = w->scratch.blocks.data;
    int i = (int)(w->steps % (uint64_t)stride);
    for (int r = 0; r < w->scratch.runs.count; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        for (; i < run->first + run->count; i += stride) {
            if (td_fetches(w) && i + 2 * stride < w->scratch.blocks.count) { /* chosen */
                __builtin_prefetch(&blocks[i + 2 * stride]->used);
                __builtin_prefetch(blocks[i + 2 * stride]->mark, 1);
            }
            if (blocks[i]->used) {
                joint_marked |= watch_block(w, blocks[i], run->kind);
            }
        }
    }
    return joint_marked;
}
