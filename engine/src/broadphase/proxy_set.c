/* proxy_set.c: reserves and frees the arrays of a proxy set; bodies that change from one of a
 * world's sets to the other. */
#include "broadphase/proxy_set.h"

#include "geometry/shape_kind.h"
#include "state/world.h"

#define ARRAY(name, element) TD_ARRAY_PLACE(td_proxy_set, name, element)

/* The arrays of a proxy set. The first FILLED have one element for each of `ids`; every broadphase
 * fills them, except for `cells`, which only the grid does. Each of the others belongs to one
 * broadphase. */
static const td_array_place ARRAYS[] = {
    ARRAY(ids, int32_t),       ARRAY(min_x, int32_t),    ARRAY(min_y, int32_t),
    ARRAY(max_x, int32_t),     ARRAY(max_y, int32_t),    ARRAY(moved, int32_t),
    ARRAY(cells, int32_t),     ARRAY(list, int32_t),     ARRAY(starts, int32_t),
    ARRAY(index_of, int32_t),  ARRAY(anchor_x, int32_t), ARRAY(anchor_y, int32_t),
    ARRAY(keys, td_sweep_key),
};
enum { FILLED = 7, ARRAY_COUNT = sizeof ARRAYS / sizeof *ARRAYS };

void td_proxy_set_init(td_proxy_set *p) {
    td_arrays_init(p, ARRAYS, ARRAY_COUNT);
}

/* Room for the shapes, and for eight elements more, since vector stores may write beyond the last
 * shape. */
bool td_proxy_set_reserve(thud_world *w, td_proxy_set *p, int count) {
    return td_arrays_reserve(&w->memory, p, ARRAYS, FILLED, count + TD_LANES);
}

/* Adds the shapes of the bodies to the set of resting shapes in place, if the broadphase can. If
 * the set still has shapes that woke (`woken`), it is built anew: these bodies may be among them,
 * and would be in the set twice. */
void td_proxy_sets_asleep(thud_world *w, const td_array *bodies) {
    td_proxy_set *rest = &w->rest_shapes;
    bool (*enter)(thud_world *w, td_proxy_set *set, int shape) = w->def.broadphase->enter;
    td_proxy_set_forget(&w->awake_shapes);
    rest->listed = false;
    rest->valid &= enter && !rest->woken;
    for (int i = 0; i < bodies->count && rest->valid; i++) {
        int shape = td_body_at(w, td_body_in(bodies, i))->first_shape;
        for (; shape != TD_NONE && rest->valid; shape = td_shape_at(w, shape)->next) {
            rest->valid = td_kind_is_line(td_shape_at(w, shape)->kind) || enter(w, rest, shape);
        }
    }
}

/* The shapes of woken bodies are removed in place later (td_proxy_set_drop_woken), unless the
 * bodies are more than a quarter of the shapes: then building the set anew takes no longer. Chosen.
 */
void td_proxy_sets_woken(thud_world *w, const td_array *bodies) {
    td_proxy_set *rest = &w->rest_shapes;
    td_proxy_set_forget(&w->awake_shapes);
    rest->listed = false;
    rest->valid &= w->def.broadphase->enter && bodies->count <= rest->ids.count / 4;
    rest->woken = rest->valid;
}

/* Replaces each shape of an awake body by TD_NONE, and its bounds by inverted ones (the minimum
 * above the maximum), which overlap no bounds nearer than a quarter of the range after which bounds
 * wrap around. */
void td_proxy_set_drop_woken(thud_world *w) {
    td_proxy_set *rest = &w->rest_shapes;
    int *ids = rest->ids.data;
    for (int i = 0; i < rest->ids.count; i++) {
        if (ids[i] == TD_NONE || td_body_at(w, td_shape_at(w, ids[i])->body)->awake.at <= 0) {
            continue;
        }
        const td_bounds *b = td_fat_at(w, ids[i]);
        td_bounds none = {td_wrap_add(b->min_x, INT32_MAX / 2),
                          td_wrap_add(b->min_y, INT32_MAX / 2),
                          td_wrap_sub(b->max_x, INT32_MAX / 2),
                          td_wrap_sub(b->max_y, INT32_MAX / 2)};
        td_proxy_set_put(rest, i, &none);
        ids[i] = TD_NONE;
    }
    rest->woken = false;
}

void td_proxy_set_free(td_memory *memory, td_proxy_set *p) {
    td_arrays_free(memory, p, ARRAYS, ARRAY_COUNT);
}

const char *thud_broadphase_name(const thud_broadphase *broadphase) {
    return broadphase ? broadphase->name : "";
}
