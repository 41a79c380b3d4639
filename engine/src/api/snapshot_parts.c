/* snapshot_parts.c: lists the arrays of a world that go into a snapshot, and how much of each does.
 * Writing, checking and restoring a snapshot go through this one list. */
#include "api/snapshot.h"

#include "state/awake.h"

#define IS_STATE(name, element, is_state) is_state,
const bool td_awake_is_state[TD_AWAKE_ARRAY_COUNT] = {TD_AWAKE_ARRAYS(IS_STATE)};
#undef IS_STATE

/* `used` and `room` as in td_part. `used` is clamped to the capacity: an array that was never
 * filled has a capacity of 0, less than its count with padding. */
static td_part part_of(td_array *array, int used, int room) {
    return (td_part){.array = array, .used = td_min_int(used, array->capacity), .room = room};
}

/* An array whose `count` elements, and no padding, are state. */
static td_part list_of(td_array *array, int room) {
    return part_of(array, array->count, room);
}

/* The count rounded up to whole groups of TD_LANES: the wide kernels read and write whole groups.
 */
static int padded_count(int count) {
    return (count + TD_LANES - 1) / TD_LANES * TD_LANES;
}

/* Arrays by awake slot, of which w->body_of.count are in use. Those that each step computes anew
 * get room, but are not in the bytes. `live_bodies`: bodies of the snapshot, all of which may wake.
 */
static void list_awake(thud_world *w, int live_bodies, td_part *parts) {
    int used = padded_count(w->body_of.count), room = td_awake_capacity(live_bodies);
    for (int i = 0; i < TD_AWAKE_ARRAY_COUNT; i++) {
        parts[i] = part_of(&w->awake[i], td_awake_is_state[i] ? used : 0, room);
    }
}

/* The lists of one set of events. A step reserves room in them as it adds events. */
static void list_events(td_event_lists *e, td_part *parts) {
    td_array *lists[TD_EVENT_LIST_COUNT] = {
        &e->begin,           &e->end, &e->sensor_begin, &e->sensor_end, &e->sensor_begin_time,
        &e->sensor_end_time, &e->hit, &e->quarantined};
    for (int i = 0; i < TD_EVENT_LIST_COUNT; i++) {
        parts[i] = list_of(lists[i], 0);
    }
}

/* Elements of td_proxy_set.starts: for each grid level with cells its mask + 1 cells and an end.
 * The sum saturates, since a forged snapshot may have restored any mask. */
static int starts_count(const td_proxy_set *p) {
    int64_t sum = 0;
    for (int i = 0; i < TD_LEVELS; i++) {
        sum += p->levels[i].cell ? (int64_t)p->levels[i].mask + 2 : 0;
    }
    return sum < INT32_MAX ? (int)sum : INT32_MAX;
}

/* The arrays of a proxy set, the bounds that a broadphase sorts (proxy_set.h).
 *
 * The rows in the order of `ids` go on for TD_LANES elements, which kernels read and write past the
 * end (wide_proxy_set.c). Only the grid has cells and starts. Only a grid that was built so that
 * moved shapes can be updated in place (td_proxy_set.loose) has index_of and anchors. */
static void list_proxy_set(const thud_world *w, td_proxy_set *p, td_part *parts) {
    int count = p->ids.count, padded = count ? count + TD_LANES : 0;
    int anchor_count = p->loose ? count : 0, index_count = p->loose ? w->shapes.count : 0;
    parts[TD_SNAPSHOT_LIST] = list_of(&p->list, 0);
    td_array *rows[] = {&p->ids, &p->min_x, &p->min_y, &p->max_x, &p->max_y, &p->moved, &p->cells};
    static_assert(sizeof rows / sizeof *rows == TD_SNAPSHOT_CELLS - TD_SNAPSHOT_IDS + 1,
                  "TD_SNAPSHOT_IDS to TD_SNAPSHOT_CELLS are consecutive, in the order of `rows`");
    for (int i = 0; i <= TD_SNAPSHOT_CELLS - TD_SNAPSHOT_IDS; i++) {
        parts[TD_SNAPSHOT_IDS + i] = part_of(rows[i], padded, 0);
    }
    parts[TD_SNAPSHOT_STARTS] = part_of(&p->starts, count ? starts_count(p) : 0, 0);
    parts[TD_SNAPSHOT_INDEX_OF] = part_of(&p->index_of, index_count, 0);
    parts[TD_SNAPSHOT_ANCHOR_X] = part_of(&p->anchor_x, anchor_count, 0);
    parts[TD_SNAPSHOT_ANCHOR_Y] = part_of(&p->anchor_y, anchor_count, 0);
    parts[TD_SNAPSHOT_KEYS] = list_of(&p->keys, 0);
}

/* Arrays by body and by shape, and the lists of moved shapes and changed bodies, have room for all
 * bodies and shapes from the creation of these on, so that a step fills them without reserving. The
 * lists with room 0 reserve as they grow. */
void td_snapshot_list_parts(thud_world *w, const td_snapshot_head *head,
                            td_part parts[TD_SNAPSHOT_PARTS]) {
    int bodies = td_slots_capacity(&w->bodies), shapes = td_slots_capacity(&w->shapes);
    parts[TD_SNAPSHOT_POSE] = part_of(&w->pose, w->bodies.count, bodies);
    parts[TD_SNAPSHOT_PROXY] = part_of(&w->proxy, w->shapes.count, shapes);
    parts[TD_SNAPSHOT_PREVIOUS_FAT] = part_of(&w->previous_fat, w->shapes.count, shapes);
    parts[TD_SNAPSHOT_MARKS] = part_of(&w->marks, w->shapes.count, shapes);
    list_awake(w, head->slots[TD_SNAPSHOT_BODIES].live, parts + TD_SNAPSHOT_AWAKE);
    parts[TD_SNAPSHOT_MOVED] = list_of(&w->moved, shapes);
    parts[TD_SNAPSHOT_CHANGED] = list_of(&w->changed, bodies);
    parts[TD_SNAPSHOT_DEFERRED] = list_of(&w->deferred, 0);
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        /* A step may move every constraint of the kind to this list without reserving. */
        parts[TD_SNAPSHOT_WAITING + kind] = list_of(&w->waiting[kind], head->constraints[kind]);
    }
    list_events(&w->events, parts + TD_SNAPSHOT_EVENTS);
    list_events(&w->published, parts + TD_SNAPSHOT_PUBLISHED);
    parts[TD_SNAPSHOT_BROKEN] = list_of(&w->broken, 0);
    list_events(&w->gathered.lists, parts + TD_SNAPSHOT_GATHERED);
    parts[TD_SNAPSHOT_GATHERED_BROKEN] = list_of(&w->gathered.broken, 0);
    parts[TD_SNAPSHOT_GATHERED_IMPULSES] = list_of(&w->gathered.impulses, 0);
    parts[TD_SNAPSHOT_FORCE_RECORDS] = list_of(&w->force_records, 0);
    parts[TD_SNAPSHOT_PLACED_BINS] = list_of(&w->placed_bins, 0);
    parts[TD_SNAPSHOT_BEGINS] = list_of(&w->scratch.begins, 0);
    /* Part 3 of the narrowphase adds to it without reserving (narrowphase.c). */
    parts[TD_SNAPSHOT_ENDS] = list_of(&w->scratch.ends, head->slots[TD_SNAPSHOT_CONSTRAINTS].live);
    list_proxy_set(w, &w->awake_shapes, parts + TD_SNAPSHOT_PROXY_SETS);
    list_proxy_set(w, &w->rest_shapes,
                   parts + TD_SNAPSHOT_PROXY_SETS + TD_SNAPSHOT_PROXY_SET_PARTS);
}

void td_snapshot_list_slots(thud_world *w, td_slots *slots[TD_SNAPSHOT_SLOTS]) {
    slots[TD_SNAPSHOT_BODIES] = &w->bodies;
    slots[TD_SNAPSHOT_SHAPES] = &w->shapes;
    slots[TD_SNAPSHOT_CONSTRAINTS] = &w->constraints;
    slots[TD_SNAPSHOT_JOINTS] = &w->joints;
    slots[TD_SNAPSHOT_TERRAINS] = &w->terrains;
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        slots[TD_SNAPSHOT_BLOCK_POOLS + form] = &w->pool[form];
    }
}

int td_snapshot_table_count(const td_snapshot_head *head) {
    int count = head->slots[TD_SNAPSHOT_TERRAINS].count;
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        count += head->slots[TD_SNAPSHOT_BLOCK_POOLS + form].count;
    }
    return count;
}
