/* proxy_set.c: memory of a proxy set. */
#include "broadphase/proxy_set.h"

#include "state/world.h"

void td_proxy_set_init(td_proxy_set *p) {
    td_array *ints[] = {&p->list,  &p->ids,   &p->min_x,  &p->min_y, &p->max_x,    &p->max_y,
                        &p->moved, &p->cells, &p->starts, &p->spot,  &p->anchor_x, &p->anchor_y};
    for (size_t i = 0; i < sizeof ints / sizeof *ints; i++) {
        ints[i]->stride = (int)sizeof(int32_t);
    }
    p->keys.stride = (int)sizeof(td_sweep_key);
}

bool td_proxy_set_reserve(thud_world *w, td_proxy_set *p) {
    td_array *arrays[] = {&p->ids, &p->min_x, &p->min_y, &p->max_x, &p->max_y, &p->moved};
    int count = p->list.count;
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        if (!td_array_reserve(&w->memory, arrays[i], count + TD_LANES)) {
            return false;
        }
        arrays[i]->count = count;
    }
    return true;
}

void td_proxy_set_free(td_memory *memory, td_proxy_set *p) {
    td_array *arrays[] = {&p->list,     &p->ids,      &p->min_x, &p->min_y, &p->max_x,
                          &p->max_y,    &p->moved,    &p->cells, &p->spot,  &p->keys,
                          &p->anchor_x, &p->anchor_y, &p->starts};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        td_array_free(memory, arrays[i]);
    }
}

const char *thud_broadphase_name(const thud_broadphase *broadphase) {
    return broadphase ? broadphase->name : "";
}
