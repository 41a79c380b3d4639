/* snapshot_parts.c: lists the arrays of a world that go into a snapshot, and how much of each does.
 */
#include "api/snapshot.h"

#include "state/awake.h"

#define IS_STATE(name, element, is_state) is_state,
const uint8_t td_awake_is_state[TD_AWAKE_ARRAY_COUNT] = {TD_AWAKE_ARRAYS(IS_STATE)};

/* `used` is held to the capacity, since arrays that were never filled are shorter than their
 * padding. */
static td_part part_of(td_array *array, int used, int room) {
    return (td_part){.array = array, .used = td_min_int(used, array->capacity), .room = room};
}

/* An array of which `count` elements are state. */
static td_part list_of(td_array *array, int room) {
    return part_of(array, array->count, room);
}

/* The count rounded up to whole groups of TD_LANES: the wide kernels read and write whole groups.
 */
static int padded_count(int count) {
    return (count + TD_LANES - 1) / TD_LANES * TD_LANES;
}

/* Arrays by awake slot. Those that each step computes anew get room, but are not in the bytes. */
static void list_awake(thud_world *w, int live, td_part *parts) {
    for (int i = 0; i < TD_AWAKE_ARRAY_COUNT; i++) {
        parts[i] = part_of(&w->awake[i], td_awake_is_state[i] * padded_count(w->body_of.count),
                           td_awake_capacity(live));
    }
}

static void list_events(td_event_lists *e, td_part *parts) {
    td_array *lists[TD_EVENT_LIST_COUNT] = {
        &e->begin,           &e->end, &e->sensor_begin, &e->sensor_end, &e->sensor_begin_time,
        &e->sensor_end_time, &e->hit, &e->quarantined};
    for (int i = 0; i < TD_EVENT_LIST_COUNT; i++) {
        parts[i] = list_of(lists[i], 0);
    }
}

/* Elements of td_proxy_set.starts: a table of mask + 2 for each grid level with shapes. */
static int starts_of(const td_proxy_set *p) {
    int64_t sum = 0;
    for (int i = 0; i < TD_LEVELS; i++) {
        sum += p->levels[i].count ? (int64_t)p->levels[i].mask + 2 : 0;
    }
    return sum < INT32_MAX ? (int)sum : INT32_MAX;
}

/* Only the grid has levels, and only a loose set (td_proxy_set.loose) has spots and anchors. */
static void list_proxy_set(const thud_world *w, td_proxy_set *p, td_part *parts) {
    int count = p->ids.count, padded = count ? count + TD_LANES : 0, loose = p->loose ? count : 0;
    parts[TD_SNAPSHOT_LIST] = list_of(&p->list, 0);
    td_array *rows[] = {&p->ids, &p->min_x, &p->min_y, &p->max_x, &p->max_y, &p->moved, &p->cells};
    static_assert(sizeof rows / sizeof *rows == TD_SNAPSHOT_CELLS - TD_SNAPSHOT_IDS + 1,
                  "rows by place stand side by side");
    for (int i = 0; i <= TD_SNAPSHOT_CELLS - TD_SNAPSHOT_IDS; i++) {
        parts[TD_SNAPSHOT_IDS + i] = part_of(rows[i], padded, 0);
    }
    parts[TD_SNAPSHOT_STARTS] = part_of(&p->starts, count ? starts_of(p) : 0, 0);
    parts[TD_SNAPSHOT_INDEX_OF] = part_of(&p->index_of, p->loose ? w->shapes.count : 0, 0);
    parts[TD_SNAPSHOT_ANCHOR_X] = part_of(&p->anchor_x, loose, 0);
    parts[TD_SNAPSHOT_ANCHOR_Y] = part_of(&p->anchor_y, loose, 0);
    parts[TD_SNAPSHOT_KEYS] = list_of(&p->keys, 0);
}

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
        /* The narrowphase may move every contact of the kind to this list. */
        parts[TD_SNAPSHOT_WAITING + kind] = list_of(&w->waiting[kind], head->constraints[kind]);
    }
    list_events(&w->events, parts + TD_SNAPSHOT_EVENTS);
    list_events(&w->published, parts + TD_SNAPSHOT_PUBLISHED);
    parts[TD_SNAPSHOT_BROKEN] = list_of(&w->broken, 0);
    list_events(&w->gathered.lists, parts + TD_SNAPSHOT_GATHERED);
    parts[TD_SNAPSHOT_GATHERED_BROKEN] = list_of(&w->gathered.broken, 0);
    parts[TD_SNAPSHOT_GATHERED_IMPULSES] = list_of(&w->gathered.impulses, 0);
    parts[TD_SNAPSHOT_FORCE_RECORDS] = list_of(&w->force_records, 0);
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
        slots[TD_SNAPSHOT_POOLS + form] = &w->pool[form];
    }
}

int td_snapshot_table_count(const td_snapshot_head *head) {
    int count = head->slots[TD_SNAPSHOT_TERRAINS].count;
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        count += head->slots[TD_SNAPSHOT_POOLS + form].count;
    }
    return count;
}
