/* label.c: see label.h. */
#include "islands/label.h"

#include "constraint/lanes.h"

static int find_root(int *parents, int i) {
    while (parents[i] != i) {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    return i;
}

static void join(int *parents, int a, int b) {
    a = find_root(parents, a);
    b = find_root(parents, b);
    /* The lower slot leads, so that roots do not depend on the order of contacts. */
    if (a < b) {
        parents[b] = a;
    } else {
        parents[a] = b;
    }
}

static bool is_dynamic(const thud_world *w, int slot) {
    return td_body_at(w, td_body_of(w, slot))->kind == THUD_DYNAMIC;
}

static bool moves(const thud_world *w, int slot) {
    const float *v = td_row(&w->velocity, slot);
    return v[0] != 0.0f || v[1] != 0.0f || v[2] != 0.0f;
}

/* A lane ties two dynamic bodies together; a moving kinematic body keeps its neighbour awake. */
static void tie(thud_world *w, int *parents, int a, int b) {
    if (a == 0 || b == 0) {
        return;
    }
    bool dynamic_a = is_dynamic(w, a), dynamic_b = is_dynamic(w, b);
    if (dynamic_a && dynamic_b) {
        join(parents, a, b);
    } else if (moves(w, dynamic_a ? b : a)) {
        *td_row(&w->idle, dynamic_a ? a : b) = 0.0f;
    }
}

bool td_islands_label(thud_world *w) {
    td_array *parents = &w->scratch.parents;
    if (!td_array_reserve(&w->memory, parents, w->body_of.count)) {
        return false;
    }
    int *parent = parents->data;
    for (int i = 0; i < w->body_of.count; i++) {
        parent[i] = i;
    }
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, i);
        if (constraint->state == TD_TOUCHING && constraint->bin != TD_SLEEPING &&
            constraint->live) {
            td_lane at = td_lane_of(w, constraint);
            tie(w, parent, (int)(at.block->a[at.lane] / TD_AWAKE_BYTES),
                (int)(at.block->b[at.lane] / TD_AWAKE_BYTES));
        }
    }
    for (int i = 1; i < w->body_of.count; i++) {
        parent[i] = find_root(parent, i);
    }
    return true;
}
