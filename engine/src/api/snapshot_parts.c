/* snapshot_parts.c: the arrays of a world that are state, and how much of each. */
#include "api/snapshot.h"

typedef struct lister {
    td_part *parts;
    int count;
} lister;

static void add(lister *l, td_array *array, int used, int room) {
    l->parts[l->count++] =
        (td_part){.array = array, .used = td_min_int(used, array->capacity), .room = room};
}

/* As long as it says. */
static void add_list(lister *l, td_array *array, int room) {
    add(l, array, array->count, room);
}

/* The wide kernels read whole eights. */
static int eights(int count) {
    return (count + TD_LANES - 1) / TD_LANES * TD_LANES;
}

static void add_awake(lister *l, thud_world *w, int live) {
    td_array *rows[] = {&w->velocity, &w->delta,        &w->start,      &w->push,  &w->damping,
                        &w->idle,     &w->direct_steps, &w->slow_steps, &w->reach, &w->mass,
                        &w->inertia,  &w->weight,       &w->body_of,    &w->lone,  &w->colours};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        add(l, rows[i], eights(w->body_of.count), live + 1 + TD_LANES);
    }
}

static void add_events(lister *l, td_event_lists *e) {
    td_array *lists[] = {&e->begin,      &e->end, &e->sensor_begin,
                         &e->sensor_end, &e->hit, &e->quarantined};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        add_list(l, lists[i], 0);
    }
}

/* What the tables of all levels take. */
static int starts_of(const td_proxy_set *p) {
    int64_t sum = 0;
    for (int i = 0; i < TD_LEVELS; i++) {
        sum += p->levels[i].count ? (int64_t)p->levels[i].mask + 2 : 0;
    }
    return sum < INT32_MAX ? (int)sum : INT32_MAX;
}

static void add_proxy_set(lister *l, const thud_world *w, td_proxy_set *p) {
    td_array *rows[] = {&p->ids, &p->min_x, &p->min_y, &p->max_x, &p->max_y, &p->moved, &p->cells};
    int count = p->ids.count, padded = count ? count + TD_LANES : 0;
    add_list(l, &p->list, 0);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        add(l, rows[i], padded, 0);
    }
    add(l, &p->starts, count ? starts_of(p) : 0, 0);
    add(l, &p->spot, p->loose ? w->shapes.count : 0, 0);
    add(l, &p->anchor_x, p->loose ? count : 0, 0);
    add(l, &p->anchor_y, p->loose ? count : 0, 0);
    add_list(l, &p->keys, 0);
}

void td_snapshot_list_parts(thud_world *w, const td_snapshot_head *head,
                            td_part parts[TD_SNAPSHOT_PARTS]) {
    lister l = {parts, 0};
    int bodies = td_slots_capacity(&w->bodies), shapes = td_slots_capacity(&w->shapes);
    add(&l, &w->pose, w->bodies.count, bodies);
    add(&l, &w->proxy, w->shapes.count, shapes);
    add(&l, &w->was, w->shapes.count, shapes);
    add(&l, &w->marks, w->shapes.count, shapes);
    add_awake(&l, w, head->slots[TD_SNAPSHOT_BODIES].live);
    add_list(&l, &w->moved, shapes);
    add_list(&l, &w->changed, bodies);
    add_list(&l, &w->deferred, 0);
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        add_list(&l, &w->waiting[kind], head->contacts[kind]); /* any of them may come to wait */
    }
    add_events(&l, &w->events);
    add_events(&l, &w->published);
    add_proxy_set(&l, w, &w->awake_shapes);
    add_proxy_set(&l, w, &w->rest_shapes);
    assert(l.count == TD_SNAPSHOT_PARTS);
}

void td_snapshot_list_slots(thud_world *w, td_slots *slots[TD_SNAPSHOT_SLOTS]) {
    slots[TD_SNAPSHOT_BODIES] = &w->bodies;
    slots[TD_SNAPSHOT_SHAPES] = &w->shapes;
    slots[TD_SNAPSHOT_CONTACTS] = &w->contacts;
    slots[TD_SNAPSHOT_JOINTS] = &w->joints;
    slots[TD_SNAPSHOT_TERRAINS] = &w->terrains;
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        slots[TD_SNAPSHOT_POOLS + form] = &w->pool[form];
    }
}
