/* proxy_set.c: reserves and frees the arrays of a proxy set. */
#include "broadphase/proxy_set.h"

#include "state/world.h"

#define ARRAY(name, element) TD_ARRAY_PLACE(td_proxy_set, name, element)

/* The arrays of a proxy set. The first FILLED have one element for each of `ids`, and every
 * broadphase fills them; the others belong to single broadphases. */
static const td_array_place ARRAYS[] = {
    ARRAY(ids, int32_t),       ARRAY(min_x, int32_t),    ARRAY(min_y, int32_t),
    ARRAY(max_x, int32_t),     ARRAY(max_y, int32_t),    ARRAY(moved, int32_t),
    ARRAY(list, int32_t),      ARRAY(cells, int32_t),    ARRAY(starts, int32_t),
    ARRAY(index_of, int32_t),  ARRAY(anchor_x, int32_t), ARRAY(anchor_y, int32_t),
    ARRAY(keys, td_sweep_key),
};
enum { FILLED = 6, ARRAY_COUNT = sizeof ARRAYS / sizeof *ARRAYS };

void td_proxy_set_init(td_proxy_set *p) {
    td_arrays_init(p, ARRAYS, ARRAY_COUNT);
}

/* Room for the shapes in p->list, and for the eight lanes that may be written beyond. */
bool td_proxy_set_reserve(thud_world *w, td_proxy_set *p) {
    int count = p->list.count;
    bool room = td_arrays_reserve(&w->memory, p, ARRAYS, FILLED, count + TD_LANES);
    p->ids.count = room ? count : 0;
    return room;
}

void td_proxy_set_free(td_memory *memory, td_proxy_set *p) {
    td_arrays_free(memory, p, ARRAYS, ARRAY_COUNT);
}

const char *thud_broadphase_name(const thud_broadphase *broadphase) {
    return broadphase ? broadphase->name : "";
}
