/* test_lists_random.c: random worlds whose bodies and shapes are created, destroyed, moved, put to
 * sleep, disabled and restored. After every edit and step each list equals a reference that the
 * test keeps: from what it created and destroyed, from thud_body_get_state, and from sensor events.
 */
#include "every_choice.h"
#include "lists_support.h"
#include "snapshot_support.h"

/* MOST: slots of the reference and length of every list. */
enum { BODIES = 24, SHAPES = 4 * BODIES, MOST = 512, ROUNDS = 8, EDITS = 400 };

/* The reference, by slots, as a slot holds one body or shape at a time; index1 is 0 where it holds
 * none. */
typedef struct model {
    thud_body_id body[MOST];
    thud_shape_id shape[MOST];
    thud_body_id owner[MOST];
    bool sensor[MOST];
    int bodies, shapes;
    bool open[MOST][MOST]; /* by shape slots: the sensor of the first sees the second */
} model;

/* A random world with its reference (`now`), and that of the last snapshot (`kept`). */
typedef struct chaos {
    thud_world *world;
    uint64_t seed;
    model now, kept;
    saved snapshot;
    thud_body_seen seen[MOST]; /* state of thud_world_get_moved_bodies */
    bool known[MOST];          /* the test's own record of the same */
    thud_body_id last[MOST];
    thud_body_state was[MOST];
    int sensed; /* overlaps, over all rounds and comparisons */
    int asleep;
} chaos;

static int pick(chaos *c, int count) {
    return (int)random_in(&c->seed, 0, (double)count);
}

/* ---- edits ---- */

/* A random slot with a body, or -1. */
static int some_body(chaos *c) {
    int slots = 0, slot = -1;
    for (int i = 0; i < MOST; i++) {
        slots += c->now.body[i].index1 != 0;
    }
    for (int n = slots ? pick(c, slots) : -1; n >= 0; n--) {
        do {
            slot++;
        } while (!c->now.body[slot].index1);
    }
    return slot;
}

static void add_some_shape(chaos *c, thud_body_id body) {
    thud_shape_def def = thud_default_shape_def();
    float size = (float)random_in(&c->seed, 0.2, 0.8);
    def.sensor = pick(c, 3) == 0;
    thud_vec2 offset = {(float)random_in(&c->seed, -0.5, 0.5), 0}, half = {size, size};
    thud_shape_id id;
    if (pick(c, 2)) {
        OK(thud_shape_create_circle(c->world, body, &def, offset, size, &id));
    } else {
        OK(thud_shape_create_obb(c->world, body, &def, offset, half, 0.3, &id));
    }
    assert_true(id.index1 > 0 && id.index1 <= MOST);
    c->now.shape[id.index1 - 1] = id;
    c->now.owner[id.index1 - 1] = body;
    c->now.sensor[id.index1 - 1] = def.sensor;
    c->now.shapes++;
}

static void add_some_body(chaos *c) {
    thud_body_kind kind = (thud_body_kind)(pick(c, 5) ? THUD_BODY_DYNAMIC : pick(c, 2));
    thud_body_id id = add_body(c->world, kind, random_in(&c->seed, -4, 4),
                               random_in(&c->seed, 0.5, 6), random_in(&c->seed, -3, 3));
    assert_true(id.index1 > 0 && id.index1 <= MOST);
    c->now.body[id.index1 - 1] = id;
    c->now.bodies++;
    for (int n = pick(c, 4); n > 0; n--) {
        add_some_shape(c, id);
    }
}

/* Removes the shape of a slot from the reference. */
static void forget_shape(chaos *c, int slot) {
    c->now.shape[slot].index1 = 0;
    c->now.shapes--;
}

static void destroy_body(chaos *c, int slot) {
    OK(thud_body_destroy(c->world, c->now.body[slot]));
    for (int i = 0; i < MOST; i++) {
        if (c->now.shape[i].index1 && same_body(c->now.owner[i], c->now.body[slot])) {
            forget_shape(c, i);
        }
    }
    c->now.body[slot].index1 = 0;
    c->now.bodies--;
}

static void destroy_some_shape(chaos *c) {
    int slot = pick(c, MOST);
    for (int i = 0; i < MOST && !c->now.shape[slot].index1; i++) {
        slot = (slot + 1) % MOST;
    }
    if (c->now.shape[slot].index1) {
        OK(thud_shape_destroy(c->world, c->now.shape[slot]));
        forget_shape(c, slot);
    }
}

/* Makes a step, and updates the sensor overlaps of the reference by its events. */
static void step(chaos *c) {
    OK(thud_world_step(c->world));
    thud_events e = thud_events_of(c->world);
    for (int i = 0; i < e.sensor_end_count + e.sensor_begin_count; i++) {
        bool ends = i < e.sensor_end_count;
        const thud_contact_event *at =
            ends ? &e.sensor_end[i] : &e.sensor_begin[i - e.sensor_end_count];
        bool *open = &c->now.open[at->shape_a.index1 - 1][at->shape_b.index1 - 1];
        *open = !*open; /* a pair in both lists is as it was before the step */
    }
}

/* Restores the last snapshot, or takes a new one, with the reference as of then. */
static void restore(chaos *c) {
    if (c->snapshot.bytes && pick(c, 2)) {
        back_to(c->world, c->snapshot);
        c->now = c->kept;
    } else {
        free(c->snapshot.bytes);
        c->snapshot = save(c->world);
        c->kept = c->now;
    }
}

/* Makes a random edit of an existing body. */
static void edit(chaos *c, thud_body_id body) {
    switch (pick(c, 5)) {
    case 0:
        OK(thud_body_set_transform(c->world, body,
                                   (thud_pos){random_in(&c->seed, -4, 4), pick(c, 6)}, 0));
        break;
    case 1:
        OK(thud_body_set_enabled(c->world, body, pick(c, 2)));
        break;
    case 2:
        if (state_of(c->world, body).kind == THUD_BODY_DYNAMIC) {
            OK(thud_body_set_awake(c->world, body, pick(c, 2)));
        }
        break;
    case 3:
        if (state_of(c->world, body).kind != THUD_BODY_STATIC) {
            OK(thud_body_set_velocity(c->world, body, (thud_vec2){1, 2}, 3));
        }
        break;
    default:
        if (c->now.shapes < SHAPES) {
            add_some_shape(c, body);
        }
    }
}

/* Makes one random action: creating, destroying, editing, stepping or restoring. */
static void act(chaos *c) {
    int what = pick(c, 20), slot = some_body(c);
    if (what < 2 || slot < 0) {
        if (c->now.bodies < BODIES) {
            add_some_body(c);
        }
    } else if (what == 2) {
        destroy_body(c, slot);
    } else if (what == 3) {
        destroy_some_shape(c);
    } else if (what == 4) {
        restore(c);
    } else if (what < 9) {
        edit(c, c->now.body[slot]);
    } else {
        for (int n = pick(c, 8) ? 1 : 60; n > 0; n--) { /* long enough to fall asleep */
            step(c);
        }
    }
}

/* ---- comparison ---- */

/* Asserts that the first `capacity` entries of a list are those of the reference with `wanted`
 * entries, and the rest is 0. */
static void compare(const uint64_t *list, int count, int capacity, const uint64_t *naive,
                    int wanted) {
    assert_int_equal(count, wanted);
    for (int i = 0; i < MOST; i++) {
        assert_true(list[i] == (i < wanted && i < capacity ? naive[i] : 0));
    }
}

static uint64_t bits_of_body(thud_body_id id) {
    return (uint64_t)id.generation << 32 | id.index1;
}

static uint64_t bits_of_shape(thud_shape_id id) {
    return (uint64_t)id.generation << 32 | id.index1;
}

/* The capacity of the array for a list: mostly enough, else too small. */
static int pick_capacity(chaos *c) {
    return pick(c, 3) ? MOST : pick(c, 12);
}

typedef thud_result list_bodies_fn(const thud_world *world, thud_body_id *out, int capacity,
                                   int *count);

/* Asserts that a list of bodies has the reference's entries. */
static void bodies_are(chaos *c, list_bodies_fn *ask, const uint64_t *naive, int wanted) {
    thud_body_id list[MOST] = {0};
    uint64_t bits[MOST];
    int count, capacity = pick_capacity(c);
    OK(ask(c->world, capacity ? list : NULL, capacity, &count));
    for (int i = 0; i < MOST; i++) {
        bits[i] = bits_of_body(list[i]);
    }
    compare(bits, count, capacity, naive, wanted);
}

/* Compares the lists of all bodies, of awake bodies, and the body of each slot. */
static void compare_bodies(chaos *c) {
    uint64_t all[MOST], awake[MOST];
    int count = 0, woken = 0, slots;
    OK(thud_world_get_slot_counts(c->world, &slots, NULL));
    for (int i = 0; i < MOST; i++) {
        thud_body_id id = c->now.body[i], there = {0};
        assert_true(i < slots || !id.index1);
        if (i < slots) {
            OK(thud_world_get_body_at(c->world, i, &there));
            assert_true(id.index1 ? same_body(there, id) : !there.index1 && !there.generation);
        }
        if (id.index1) {
            all[count++] = bits_of_body(id);
            if (state_of(c->world, id).awake) {
                awake[woken++] = bits_of_body(id);
            }
        }
    }
    c->asleep += count > woken;
    bodies_are(c, thud_world_get_bodies, all, count);
    bodies_are(c, thud_world_get_awake_bodies, awake, woken);
}

/* Asserts that a list of shapes has the reference's entries. */
static void shapes_are(thud_result result, const thud_shape_id *list, int count, int capacity,
                       const uint64_t *naive, int wanted) {
    uint64_t bits[MOST];
    OK(result);
    for (int i = 0; i < MOST; i++) {
        bits[i] = bits_of_shape(list[i]);
    }
    compare(bits, count, capacity, naive, wanted);
}

/* Compares the list of shapes that a sensor overlaps. */
static void compare_sensed(chaos *c, int sensor) {
    uint64_t naive[MOST];
    int wanted = 0, count, capacity = pick_capacity(c);
    thud_shape_id list[MOST] = {0};
    bool enabled = state_of(c->world, c->now.owner[sensor]).enabled;
    for (int i = 0; i < MOST && enabled; i++) {
        if (c->now.open[sensor][i] && c->now.shape[i].index1 &&
            state_of(c->world, c->now.owner[i]).enabled) {
            naive[wanted++] = bits_of_shape(c->now.shape[i]);
        }
    }
    thud_result result =
        thud_shape_get_sensor_overlaps(c->world, c->now.shape[sensor], list, capacity, &count);
    shapes_are(result, list, count, capacity, naive, wanted);
    c->sensed += wanted;
}

/* Compares the list of all shapes, the shape of each slot, and the overlaps of each sensor. */
static void compare_shapes(chaos *c) {
    uint64_t all[MOST];
    thud_shape_id list[MOST] = {0};
    int wanted = 0, count, slots, capacity = pick_capacity(c);
    OK(thud_world_get_slot_counts(c->world, NULL, &slots));
    for (int i = 0; i < MOST; i++) {
        thud_shape_id id = c->now.shape[i], there = {0};
        assert_true(i < slots || !id.index1);
        if (i < slots) {
            OK(thud_world_get_shape_at(c->world, i, &there));
            assert_true(id.index1 ? same_shape(there, id) : !there.index1 && !there.generation);
        }
        if (id.index1) {
            all[wanted++] = bits_of_shape(id);
            if (c->now.sensor[i]) {
                compare_sensed(c, i);
            }
        }
    }
    thud_result result = thud_world_get_shapes(c->world, list, capacity, &count);
    shapes_are(result, list, count, capacity, all, wanted);
}

/* Whether the body in a slot is another one, or elsewhere, than when it was last listed. */
static bool moves(const chaos *c, int slot) {
    thud_body_state now = state_of(c->world, c->now.body[slot]);
    const thud_body_state *was = &c->was[slot];
    return !c->known[slot] || !same_body(c->last[slot], c->now.body[slot]) ||
           now.position.x != was->position.x || now.position.y != was->position.y ||
           now.angle != was->angle;
}

/* Compares the list of moved bodies. */
static void compare_moved(chaos *c) {
    thud_body_id list[MOST] = {0};
    uint64_t bits[MOST], naive[MOST];
    int wanted = 0, count, capacity = pick_capacity(c);
    for (int i = 0; i < MOST; i++) {
        c->known[i] = c->known[i] && c->now.body[i].index1;
        if (c->now.body[i].index1 && moves(c, i)) {
            naive[wanted++] = bits_of_body(c->now.body[i]);
            if (wanted <= capacity) {
                c->known[i] = true;
                c->last[i] = c->now.body[i];
                c->was[i] = state_of(c->world, c->now.body[i]);
            }
        }
    }
    OK(thud_world_get_moved_bodies(c->world, c->seen, MOST, list, capacity, &count));
    for (int i = 0; i < MOST; i++) {
        bits[i] = bits_of_body(list[i]);
    }
    compare(bits, count, capacity, naive, wanted);
}

static void lists_are_what_naive_ones_are(void **state) {
    (void)state;
    int sensed = 0, asleep = 0;
    for (int round = 0; round < ROUNDS; round++) {
        thud_world_def def = thud_default_world_def_of(qualities[round % QUALITIES]);
        def.detection = detections[round / QUALITIES % 2 + round % 3];
        def.broadphase = broadphases[round % 3];
        chaos *c = calloc(1, sizeof *c);
        assert_non_null(c);
        c->world = make_world(def);
        c->seed = 77 + (uint64_t)round * 1000003;
        thud_body_id floor = add_floor(c->world, NULL);
        thud_shape_id top;
        OK(thud_body_get_shapes(c->world, floor, &top, 1, NULL));
        c->now.body[floor.index1 - 1] = c->now.owner[top.index1 - 1] = floor;
        c->now.shape[top.index1 - 1] = top;
        c->now.bodies = c->now.shapes = 1;
        for (int i = 0; i < EDITS; i++) {
            act(c);
            compare_bodies(c);
            compare_shapes(c);
            compare_moved(c);
        }
        sensed += c->sensed;
        asleep += c->asleep;
        free(c->snapshot.bytes);
        thud_world_destroy(c->world);
        free(c);
    }
    assert_true(sensed > ROUNDS * EDITS / 4);
    assert_true(asleep > ROUNDS * EDITS / 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lists_are_what_naive_ones_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
