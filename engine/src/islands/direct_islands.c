/* direct_islands.c: finds the islands that are to be solved at once.
 *
 * An island is what constraints that act between dynamic bodies connect. It is direct when a body
 * of it is: for TD_DIRECT_STEPS after a constraint of it was last found to give way too much. That
 * is looked for in an eighth of the blocks a step, and must be found twice in succession, and where
 * the two bodies are calm: an impact is as heavy but passes, and of a heap in motion the soft
 * solver makes as much for less. Where a heavy body lies on a light one, which sinks in at once,
 * half the load found once will do. A joint is found once, and its island is solved directly in
 * that very step (linkages/late_islands.c). Where the limit is 0 every island is direct. */
#include "islands/direct_islands.h"

#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "islands/island_order.h"

#include <string.h>

#define ARRAY(name, element) TD_ARRAY_PLACE(td_islands, name, element)

static const td_array_place ARRAYS[] = {
    ARRAY(island, td_island),
    ARRAY(slots, td_awake_slot),
    ARRAY(constraints, int),
    ARRAY(local, int),
    ARRAY(before, float[4]),
    ARRAY(impulses, float[TD_DIRECT_ROWS + 1]),
    ARRAY(rows, td_direct_constraint),
    ARRAY(bodies, td_direct_body),
    ARRAY(step, double[4]),
    ARRAY(work, double[4]),
    ARRAY(shape, int),
    ARRAY(shape_before, int),
    ARRAY(systems, td_system),
    ARRAY(start, float[4]),
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

/* Room in each list for all bodies and constraints that there are, where that takes little. */
static bool room_for_all(thud_world *w) {
    td_islands *s = &w->islands;
    int bodies = w->body_of.count, constraints = w->touching + TD_JOINT_PARTS * w->joints.live;
    return td_islands_room(w, &s->local, bodies) && td_islands_room(w, &s->island, bodies) &&
           td_islands_room(w, &s->slots, bodies) && td_islands_room(w, &s->before, bodies) &&
           td_islands_room(w, &s->constraints, constraints) &&
           td_islands_room(w, &s->impulses, constraints) &&
           td_sparse_reserve(&w->memory, &s->matrix, bodies);
}

/* ---- which ---- */

/* The values of td_islands.local that are no numbers in an island. */
enum {
    TOO_MANY = -1, /* its island has more bodies than the limit */
    ALONE = -2,    /* nothing touches it */
    COOLING = -3   /* its island is left alone for now */
};

static bool is_seed(const thud_world *w, td_awake_slot slot) {
    int direct_steps = *td_direct_steps_at(w, slot);
    return direct_steps <= TD_DIRECT_COOLDOWN &&
           (direct_steps > 0 || w->quality.sag_limit == 0.0f) &&
           *td_island_local_at(w, slot) == 0 && td_row(&w->velocity, slot)[3] > 0.0f;
}

static bool any_direct(const thud_world *w) {
    const uint8_t *direct_steps = w->direct_steps.data;
    uint8_t any = 0;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        any |= direct_steps[slot.at];
    }
    return any > 0;
}

enum { MOST_TIMES = 5 }; /* left alone for half a minute then, at 60 steps a second */

static void cool_down(thud_world *w, td_awake_slot slot, int steps, int times) {
    *td_direct_steps_at(w, slot) = (uint8_t)(TD_DIRECT_COOLDOWN + steps);
    *td_slow_steps_at(w, slot) = (uint16_t)(td_min_int(times, MOST_TIMES) * TD_SLOW_ONCE);
}

/* What thud_world.direct_steps of a body is after this step. While it is left alone, a body counts
 * down; one that was left n times does so in one of 2^(n - 1) steps. */
static int direct_after_step(const thud_world *w, td_awake_slot slot) {
    int direct_steps = *td_direct_steps_at(w, slot);
    uint64_t halvings = TD_SLOW_LEFT(*td_slow_steps_at(w, slot));
    bool counts = halvings == 0 || w->steps % (1ull << (halvings - 1)) == 0;
    int left = direct_steps > TD_DIRECT_COOLDOWN && counts ? direct_steps - 1 : direct_steps;
    return left == TD_DIRECT_COOLDOWN ? 0 : left;
}

void td_islands_leave(thud_world *w, const td_island *island, int steps, bool for_long) {
    for (int i = 0; i < island->bodies; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + i);
        int times = TD_SLOW_LEFT(*td_slow_steps_at(w, slot)) + 1;
        cool_down(w, slot, steps, for_long ? MOST_TIMES : times);
    }
}

void td_islands_settle(thud_world *w) {
    uint8_t *direct_steps = w->direct_steps.data;
    for (td_awake_slot slot = {1}; slot.at < w->islands.local.count; slot.at++) {
        int after = direct_after_step(w, slot);
        if (direct_steps[slot.at] > TD_DIRECT_COOLDOWN && after == 0) {
            int times = TD_SLOW_LEFT(*td_slow_steps_at(w, slot));
            *td_slow_steps_at(w, slot) = (uint16_t)(times * TD_SLOW_ONCE);
        }
        direct_steps[slot.at] = (uint8_t)after;
        if (*td_island_local_at(w, slot) == TOO_MANY) {
            cool_down(w, slot, TD_COOLDOWN_STEPS, 1);
        } else if (*td_island_local_at(w, slot) == ALONE) {
            direct_steps[slot.at] = 0;
        }
    }
}

/* Adds the contacts of a body, and whom they bring; each contact once, by its first side that is a
 * body of an island. False: the island has too many bodies. */
static bool spread(thud_world *w, td_island *island, td_awake_slot slot) {
    td_body_index body = td_body_of(w, slot);
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        if (constraint->state != TD_TOUCHING) {
            continue;
        }
        td_awake_slot other = td_island_neighbour(w, constraint, e & 1);
        bool is_new = other.at && *td_island_local_at(w, other) == 0;
        if (other.at && (*td_island_local_at(w, other) == TOO_MANY ||
                         (is_new && island->bodies == w->quality.island_limit))) {
            return false;
        }
        if (!other.at || !(e & 1)) {
            td_push_int(&w->islands.constraints, e / 2);
        }
        if (is_new) {
            td_island_add(w, island, other);
        }
    }
    return true;
}

float td_calm_speed(const thud_world *w) {
    float x = w->def.gravity.x, y = w->def.gravity.y;
    return td_max_float(4.0f * __builtin_sqrtf(x * x + y * y) * (float)w->def.time_step,
                        4.0f * TD_SLEEP_SPEED * w->unit);
}

int64_t td_island_cost(const td_island *island) {
    return island->system.work + island->bodies + 2 * (int64_t)island->constraints;
}

/* One newcomer does not rouse a whole heap that was left alone. */
static bool cools_down(const thud_world *w, const td_island *island) {
    int cooling = 0;
    for (int i = 0; i < island->bodies; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + i);
        cooling += *td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN;
    }
    return 2 * cooling > island->bodies;
}

void td_islands_follow(thud_world *w, td_awake_slot seed) {
    td_islands *s = &w->islands;
    td_island island = {.first_body = s->slots.count, .first_constraint = s->constraints.count};
    bool whole = true;
    td_island_add(w, &island, seed);
    for (int i = island.first_body; whole && i < s->slots.count; i++) {
        whole = spread(w, &island, td_slot_in(&s->slots, i));
    }
    island.constraints = s->constraints.count - island.first_constraint;
    bool cooling = cools_down(w, &island);
    if (whole && island.constraints && !cooling) {
        TD_PUSH(td_island, &s->island) = island;
        return;
    }
    for (int i = island.first_body; i < s->slots.count; i++) {
        *td_island_local_at(w, td_slot_in(&s->slots, i)) = !whole    ? TOO_MANY
                                                           : cooling ? COOLING
                                                                     : ALONE;
    }
    s->slots.count = island.first_body;
    s->constraints.count = island.first_constraint;
}

bool td_islands_find(thud_world *w) {
    td_islands *s = &w->islands;
    int slots = w->body_of.count;
    s->island.count = s->slots.count = s->constraints.count = 0;
    s->local.count = 0;
    if (w->quality.sag_limit > 0.0f && !any_direct(w) && !w->joints.live) {
        return true;
    }
    if (!room_for_all(w)) {
        return false;
    }
    s->local.count = slots;
    memset(s->local.data, 0, (size_t)slots * sizeof(int));
    for (td_awake_slot slot = {1}; slot.at < slots; slot.at++) {
        if (is_seed(w, slot)) {
            td_islands_follow(w, slot);
        }
    }
    return td_islands_order(w);
}

/* ---- load ---- */

#define UNEQUAL 30.0f /* masses */

enum {
    FEW = 32, /* blocks, that are all looked at */
    OFTEN = 2
};

static void mark_direct(thud_world *w, uint32_t record) {
    td_awake_slot slot = td_slot_of_side(record);
    uint8_t *direct_steps = td_direct_steps_at(w, slot);
    if (td_row(&w->velocity, slot)[3] > 0.0f && *direct_steps <= TD_DIRECT_COOLDOWN) {
        *direct_steps = TD_DIRECT_STEPS;
    }
}

/* A spring of frequency f gives way by (impulse / mass / h) / (2 pi f)^2 under an impulse a
 * substep. */
float td_islands_most(const thud_world *w, float size) {
    float steps = (float)w->substeps, own = td_max_float(steps, (float)w->quality.substeps);
    float sag = w->quality.sag_limit * size * (own * own);
    float omega = 2.0f * (float)TD_PI * w->quality.contact_stiffness; /* a substep */
    if (w->def.max_error > 0.0) {
        sag = td_min_float(sag, (float)w->def.max_error * (steps * steps));
    }
    return sag * omega * omega / (steps * (float)w->def.time_step);
}

static float size_of(const thud_world *w, td_awake_slot slot) {
    return slot.at ? 2.0f * td_row(&w->reach, slot)[0] : 3.0e38f;
}

float td_islands_size(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    return td_min_float(size_of(w, a), size_of(w, b));
}

static bool is_calm(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    const float *v = td_row(&w->velocity, a), *u = td_row(&w->velocity, b);
    float x = u[0] - v[0], y = u[1] - v[1], most = td_calm_speed(w);
    return x * x + y * y < most * most;
}

static bool watch_block(thud_world *w, td_block *block, int kind) {
    float deep = w->def.max_error > 0.0 ? (float)w->def.max_error : 3.0e38f;
    int points = td_form_points(w->kinds[kind]->form);
    bool contact = kind < TD_PAIR_COUNT, late = false;
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
        float inverse_a = td_row(&w->velocity, a)[3], inverse_b = td_row(&w->velocity, b)[3];
        float light = td_max_float(inverse_a, inverse_b),
              other = td_min_float(inverse_a, inverse_b);
        float size = td_islands_size(w, a, b), most = td_islands_most(w, size);
        float load = 0.0f, off = 0.0f;
        for (int k = 0; contact && k < points; k++) {
            load += block->point[k].normal_impulse[lane];
            off = td_max_float(off, -(block->point[k].separation[lane] + w->skin));
        }
        load = contact ? load * light : w->kinds[kind]->lanes->load(w, block, lane, size, &off);
        bool sinks = 2.0f * load > most && other > 0.0f && light > UNEQUAL * other;
        int direct = block->mark[lane].loaded & TD_DIRECT,
            before = block->mark[lane].loaded - direct;
        /* Joints stay: their load is none of an impact that passes. */
        bool passes = contact && !is_calm(w, a, b);
        bool gives_way = (load > most && !passes) || off > deep;
        int seen = gives_way ? td_min_int(before + 1, OFTEN) : 0;
        if (sinks || seen >= (contact ? OFTEN : 1)) {
            mark_direct(w, block->a[lane]);
            mark_direct(w, block->b[lane]);
            late |= !contact;
        }
        block->mark[lane].loaded = (uint8_t)(seen | direct);
    }
    return late;
}

bool td_islands_watch(thud_world *w) {
    bool late = false;
    if (w->quality.sag_limit == 0.0f) {
        return late;
    }
    int stride = w->scratch.blocks.count < FEW ? 1 : 8;
    for (int i = (int)(w->steps % (uint64_t)stride); i < w->scratch.blocks.count; i += stride) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        if (block->used) {
            int kind = td_constraint_at(w, block->constraint[0])->kind;
            late |= watch_block(w, block, kind);
        }
    }
    return late;
}
