/* event_chaos.h: a random world that is edited in every step, also inside callbacks and queries,
 * and ledgers of its begin and end events. */
#ifndef EVENT_CHAOS_H
#define EVENT_CHAOS_H

#include "engine_support.h"

enum { BODIES = 48, STEPS = 240, OPEN_MAX = 4096 };

/* ---- ledger: pairs that have begun and not ended ---- */

/* Pairs that are open, and how many have begun so far. */
typedef struct ledger {
    thud_contact_event open[OPEN_MAX];
    int count, begun;
} ledger;

static inline bool same(const thud_contact_event *a, const thud_contact_event *b) {
    return memcmp(a, b, sizeof *a) == 0;
}

/* Index of an open pair, or `count` where it is not open. */
static inline int find(const ledger *l, const thud_contact_event *pair) {
    int i = 0;
    while (i < l->count && !same(&l->open[i], pair)) {
        i++;
    }
    return i;
}

/* Removes the pair from the open ones; false where it is not among them. */
static inline bool closes(ledger *l, const thud_contact_event *pair) {
    int i = find(l, pair);
    if (i == l->count) {
        return false;
    }
    l->open[i] = l->open[--l->count];
    return true;
}

/* Books the events of a step. First the ends of pairs that were open before it; any other end must
 * belong to a pair that began in this step. */
static inline void book(ledger *l, const thud_contact_event *begin, int begins,
                        const thud_contact_event *end, int ends) {
    bool *late = calloc((size_t)ends + 1, sizeof *late);
    for (int i = 0; i < ends; i++) {
        late[i] = !closes(l, &end[i]);
    }
    for (int i = 0; i < begins; i++) {
        if (find(l, &begin[i]) < l->count) {
            fail_msg("shapes %u and %u begin twice", begin[i].shape_a.index1,
                     begin[i].shape_b.index1);
        }
        assert_true(l->count < OPEN_MAX);
        l->open[l->count++] = begin[i];
        l->begun++;
    }
    for (int i = 0; i < ends; i++) {
        if (late[i] && !closes(l, &end[i])) {
            fail_msg("shapes %u and %u end and had not begun", end[i].shape_a.index1,
                     end[i].shape_b.index1);
        }
    }
    free(late);
}

/* ---- a world that is edited in every step ---- */

/* A random world with ledgers of its contact and sensor events. */
typedef struct chaos {
    thud_world *world;
    thud_body_id bodies[BODIES], ground;
    thud_shape_id line;
    uint64_t seed;
    ledger touches, sensed;
    int edits_inside; /* edits made by callbacks */
    bool quiet;       /* neither callbacks nor the test edit the world */
} chaos;

static inline int pick(chaos *c, int count) {
    return (int)random_in(&c->seed, 0, (double)count);
}

/* Asserts that an edit succeeded, or that its handle was stale because an earlier edit destroyed
 * the object. */
static inline void fine_or_gone(thud_result result) {
    assert_true(result == THUD_OK || result == THUD_ERROR_STALE);
}

static inline void add_random_shape(chaos *c, thud_body_id body) {
    thud_shape_def def = thud_default_shape_def();
    def.sensor = pick(c, 5) == 0;
    def.restitution = pick(c, 3) == 0 ? 0.8f : 0.0f;
    float x = (float)random_in(&c->seed, 0.1, 0.6), y = (float)random_in(&c->seed, 0.1, 0.6);
    add_shape(c->world, body, x, pick(c, 3) == 0 ? 0 : y, false, &def);
}

static inline void add_random_body(chaos *c, int i) {
    thud_body_kind kind = pick(c, 8) ? THUD_BODY_DYNAMIC : (thud_body_kind)pick(c, 2);
    c->bodies[i] = add_body(c->world, kind, random_in(&c->seed, -8, 8), random_in(&c->seed, 0, 6),
                            random_in(&c->seed, -1, 1));
    for (int shapes = pick(c, 3); shapes >= 0; shapes--) {
        add_random_shape(c, c->bodies[i]);
    }
    if (kind == THUD_BODY_KINEMATIC) {
        thud_vec2 v = {(float)random_in(&c->seed, -1, 1), 0};
        OK(thud_body_set_velocity(c->world, c->bodies[i], v, 0.5f));
    }
}

/* Adds a static pit below the ground, for bodies whose contact with the ground a prologue
 * vetoes. */
static inline void add_pit(chaos *c) {
    thud_body_id pit = add_body(c->world, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_def def = thud_default_shape_def();
    OK(thud_shape_create_aabb(c->world, pit, &def, (thud_vec2){0, -4}, (thud_vec2){12, 1}, NULL));
    OK(thud_shape_create_aabb(c->world, pit, &def, (thud_vec2){-11, 5}, (thud_vec2){1, 9}, NULL));
    OK(thud_shape_create_aabb(c->world, pit, &def, (thud_vec2){11, 5}, (thud_vec2){1, 9}, NULL));
}

static inline void add_ground(chaos *c) {
    thud_pos points[21];
    for (int i = 0; i < 21; i++) {
        points[i] = (thud_pos){i - 10.0, random_in(&c->seed, -0.3, 0.3)};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 21};
    thud_shape_def def = thud_default_shape_def();
    c->ground = add_body(c->world, THUD_BODY_STATIC, 0, 0, 0);
    OK(thud_shape_create_terrain(c->world, c->ground, &def, &line, &c->line));
}

/* Makes one random edit of a body or its shapes. */
static inline void edit(chaos *c) {
    thud_world *w = c->world;
    int i = pick(c, BODIES), shapes;
    thud_body_id body = c->bodies[i];
    thud_shape_id shape;
    thud_vec2 v = {(float)random_in(&c->seed, -30, 30), (float)random_in(&c->seed, -5, 15)};
    thud_pos at = {random_in(&c->seed, -8, 8), random_in(&c->seed, 0, 6)};
    switch (pick(c, 9)) {
    case 0:
        fine_or_gone(thud_body_destroy(w, body));
        break;
    case 1:
        if (!thud_body_is_valid(w, body)) {
            add_random_body(c, i);
        }
        break;
    case 2:
        fine_or_gone(thud_body_set_transform(w, body, at, 0));
        break;
    case 3:
        if (thud_body_is_valid(w, body) && state_of(w, body).kind == THUD_BODY_DYNAMIC) {
            OK(thud_body_set_velocity(w, body, v, 1));
        }
        break;
    case 4:
    case 5:
        if (thud_body_is_valid(w, body) && state_of(w, body).kind == THUD_BODY_DYNAMIC) {
            OK(thud_body_set_awake(w, body, pick(c, 4) == 0));
        }
        break;
    case 6:
        if (thud_body_is_valid(w, body) && state_of(w, body).shape_count < 4) {
            add_random_shape(c, body);
        }
        break;
    case 7:
        fine_or_gone(thud_body_set_enabled(w, body, pick(c, 3) != 0));
        break;
    default:
        if (thud_body_is_valid(w, body)) {
            OK(thud_body_get_shapes(w, body, &shape, 1, &shapes));
            if (shapes > 1) {
                OK(thud_shape_destroy(w, shape));
            }
        }
    }
}

/* Makes one random edit of the terrain. */
static inline void edit_ground(chaos *c) {
    double x = random_in(&c->seed, -8, 8);
    if (pick(c, 6) == 0) {
        OK(thud_body_destroy(c->world, c->ground));
        add_ground(c);
    } else if (pick(c, 2)) {
        OK(thud_shape_dig(c->world, c->line, (thud_pos){x, 0.3}, 0.5));
    } else {
        OK(thud_shape_raise(c->world, c->line, x, 1.0, 0.3));
    }
}

/* Makes an edit and a query in one of `one_in` calls, from inside a callback. */
static inline void edit_inside(chaos *c, int one_in) {
    bool hit;
    if (!c->quiet && pick(c, one_in) == 0) {
        c->edits_inside++;
        edit(c);
        OK(thud_world_cast_ray(c->world, &(thud_ray){(thud_pos){-9, 0.5}, 18, 0, NULL}, &hit,
                               NULL));
    }
}

/* A prologue that edits now and then, and vetoes a tenth of the contacts while not `quiet`. */
static inline bool ask(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *settings, void *context) {
    (void)settings;
    (void)world;
    (void)contact;
    edit_inside(context, 20);
    return ((const chaos *)context)->quiet || pick(context, 10) != 0;
}

static inline void tell(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    (void)contact;
    edit_inside(context, 20);
}

static inline bool look(thud_shape_id shape, void *context) {
    (void)shape;
    edit_inside(context, 5);
    return true;
}

/* A query applies the edits made so far, before the step that reports their events. */
static inline void query(chaos *c) {
    bool hit;
    OK(thud_world_cast_ray(c->world, &(thud_ray){(thud_pos){-9, 1}, 18, 0, NULL}, &hit, NULL));
    OK(thud_world_overlap_shape(c->world, (thud_pos){0, 1}, thud_circle_at(0, 0, 3), NULL, look,
                                c));
}

/* Steps the world and books its events. */
static inline void step(chaos *c) {
    run(c->world, 1);
    thud_events e = thud_events_of(c->world);
    book(&c->touches, e.begin, e.begin_count, e.end, e.end_count);
    book(&c->sensed, e.sensor_begin, e.sensor_begin_count, e.sensor_end, e.sensor_end_count);
}

#endif
