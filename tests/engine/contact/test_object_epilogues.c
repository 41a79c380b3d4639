/* test_object_epilogues.c: epilogues of single bodies and of categories of shapes
 * (thud_body_set_epilogue, thud_world_set_category_epilogue), beside those of the world. */
#include "every_choice.h"
#include "hostile_memory.h"
#include "listeners_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_snapshot.h>

enum { DETECTIONS = 4, CALLS_MAX = 4096 };

/* A call of an epilogue: whose (the world's 0, else what the object was given as `who`). */
typedef struct call {
    int who, side;
    thud_contact seen;
} call;

static call calls[CALLS_MAX];
static int call_count;

static void note(int who, int side, const thud_contact *contact) {
    assert_in_range(call_count, 0, CALLS_MAX - 1);
    calls[call_count++] = (call){who, side, *contact};
}

static void of_world(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    (void)context;
    note(0, 0, contact);
}

static void all_of_world(thud_world *world, const thud_contact *contacts, int count,
                         void *context) {
    for (int i = 0; i < count; i++) {
        of_world(world, &contacts[i], context);
    }
}

static void of_object(thud_world *world, const thud_contact *contact, int side, void *context) {
    (void)world;
    note(*(const int *)context, side, contact);
}

static bool same_contact(const thud_contact *a, const thud_contact *b) {
    return a->shape_a.index1 == b->shape_a.index1 && a->shape_b.index1 == b->shape_b.index1 &&
           a->body_a.index1 == b->body_a.index1 && a->point.x == b->point.x &&
           a->point.y == b->point.y && a->normal_impulse == b->normal_impulse &&
           a->tangent_impulse == b->tangent_impulse && a->separation == b->separation;
}

/* ---- who is told ---- */

enum { FIRST_BODY = 100, SOME = 3, ODD = 500, SQUARE = 600 };
static int numbers[BODIES + 1000];

/* The calls that the objects of a contact should get, in their order: the epilogues of every third
 * body, those of category 2 (odd bodies), and of categories 4 and 2 together (also all boxes). */
static int expected_calls(const thud_world *world, const thud_contact *c,
                          const thud_body_id bodies[BODIES], call *out) {
    int count = 0;
    for (int side = 0; side < 2; side++) {
        thud_body_id body = side ? c->body_b : c->body_a;
        thud_shape_state shape;
        OK(thud_shape_get_state(world, side ? c->shape_b : c->shape_a, &shape));
        for (int k = 0; k < BODIES; k += SOME) {
            if (bodies[k].index1 == body.index1) {
                out[count++] = (call){FIRST_BODY + k, side, *c};
            }
        }
        if (shape.filter.category & 2) {
            out[count++] = (call){ODD, side, *c};
        }
        if (shape.filter.category & 6) {
            out[count++] = (call){SQUARE, side, *c};
        }
    }
    return count;
}

/* Sets epilogues of objects of the scene as expected_calls has them, with categories. */
static void listen_to_objects(thud_world *world, const thud_body_id bodies[BODIES]) {
    for (int k = 0; k < BODIES; k++) {
        thud_shape_id shape;
        int count;
        OK(thud_body_get_shapes(world, bodies[k], &shape, 1, &count));
        thud_filter filter = {.category = k % 2 ? 3 : k % 3 ? 5 : 1, .mask = UINT32_MAX};
        OK(thud_shape_set_filter(world, shape, filter));
    }
    for (int k = 0; k < BODIES; k += SOME) {
        OK(thud_body_set_epilogue(world, bodies[k], of_object, &numbers[FIRST_BODY + k]));
    }
    OK(thud_world_set_category_epilogue(world, 2, of_object, &numbers[ODD]));
    OK(thud_world_set_category_epilogue(world, 6, of_object, &numbers[SQUARE]));
}

/* Each object is told of exactly the contacts of the world that it is part of, with the same
 * values, in the order a, b, directly after the world or after its list; and no motion changes. */
static void each_object_is_told_of_its_own_contacts(void **state) {
    (void)state;
    static call all[CALLS_MAX];
    for (int i = 0; i < DETECTIONS * QUALITIES * 2; i++) {
        thud_world_def def = thud_default_world_def_of(qualities[i / DETECTIONS % QUALITIES]);
        def.detection = detections[i % DETECTIONS];
        bool at_once = i / DETECTIONS / QUALITIES;
        thud_body_id bodies[BODIES], twins[BODIES];
        thud_world *world = make_scene(def, bodies), *twin = make_scene(def, twins);
        /* parts that the world's own do without are told to objects all the same */
        OK(thud_world_set_listeners(
            world, &(thud_listeners){.epilogue = at_once ? NULL : of_world,
                                     .epilogue_all = at_once ? all_of_world : NULL,
                                     .without = THUD_CONTACT_BODIES | THUD_CONTACT_POINT}));
        set_listeners(twin, NULL, of_world, NULL);
        listen_to_objects(world, bodies);
        listen_to_objects(twin, twins);
        int told = 0;
        for (int step = 0; step < 60; step++) {
            call_count = 0;
            run(world, 1);
            int count = call_count, at = 0, listed = 0;
            memcpy(all, calls, sizeof(call) * (size_t)count);
            while (at_once && listed < count &&
                   all[listed].who == 0) { /* the world's list comes first */
                listed++;
            }
            told += count - listed;
            for (int k = 0, next = listed; at_once && k < listed; k++) {
                call wanted[8];
                int n = expected_calls(world, &all[k].seen, bodies, wanted);
                for (int j = 0; j < n; j++, next++) {
                    assert_true(next < count && all[next].who == wanted[j].who);
                    assert_true(all[next].side == wanted[j].side);
                    assert_true(same_contact(&all[next].seen, &wanted[j].seen));
                }
                at = next;
            }
            while (!at_once && at < count) {
                assert_int_equal(all[at].who, 0);
                call wanted[8];
                int n = expected_calls(world, &all[at].seen, bodies, wanted);
                for (int j = 0; j < n; j++) {
                    const call *got = &all[++at];
                    assert_true(at < count && got->who == wanted[j].who);
                    assert_true(got->side == wanted[j].side);
                    assert_true(same_contact(&got->seen, &wanted[j].seen));
                }
                at++;
            }
            assert_int_equal(at, count);
            run(twin, 1);
            assert_true(thud_hash_of(world) == thud_hash_of(twin));
        }
        assert_true(told > 1000);
        thud_world_destroy(world);
        thud_world_destroy(twin);
    }
}

/* Without an epilogue of the world the objects are told the same. */
static void objects_need_no_epilogue_of_the_world(void **state) {
    (void)state;
    static call all[CALLS_MAX];
    for (int d = 0; d < DETECTIONS; d++) {
        thud_world_def def = thud_default_world_def();
        def.detection = detections[d];
        thud_body_id bodies[BODIES], twins[BODIES];
        thud_world *world = make_scene(def, bodies), *twin = make_scene(def, twins);
        set_listeners(twin, NULL, of_world, NULL);
        listen_to_objects(world, bodies);
        listen_to_objects(twin, twins);
        for (int step = 0; step < 40; step++) {
            call_count = 0;
            run(world, 1);
            int count = call_count, same = 0;
            memcpy(all, calls, sizeof(call) * (size_t)count);
            call_count = 0;
            run(twin, 1);
            for (int i = 0; i < call_count; i++) {
                if (calls[i].who) {
                    assert_true(same < count && all[same].who == calls[i].who);
                    assert_true(same_contact(&all[same++].seen, &calls[i].seen));
                }
            }
            assert_int_equal(same, count);
        }
        thud_world_destroy(world);
        thud_world_destroy(twin);
    }
}

/* ---- set, replaced, removed ---- */

static int one = 1, two = 2, three = 3;

/* A ball on the floor, which does not sleep. */
static thud_world *make_rest(thud_body_id *ball, thud_body_id *floor) {
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    thud_world *world = make_world(def);
    *floor = add_floor(world, NULL);
    *ball = add_ball(world, 0, 0.5, 0.5f);
    run(world, 2);
    return world;
}

/* Runs a step, and asserts that just these were told, one call each. */
static void told_are(thud_world *world, int count, const int who[]) {
    call_count = 0;
    run(world, 1);
    assert_int_equal(call_count, count);
    for (int i = 0; i < count; i++) {
        assert_int_equal(calls[i].who, who[i]);
    }
}

static void epilogues_are_replaced_and_removed(void **state) {
    (void)state;
    thud_body_id ball, floor;
    thud_world *world = make_rest(&ball, &floor);
    told_are(world, 0, NULL);
    OK(thud_body_set_epilogue(world, ball, of_object, &one));
    OK(thud_body_set_epilogue(world, floor, of_object, &two));
    told_are(world, 2, (int[]){2, 1}); /* the static one is a */
    OK(thud_body_set_epilogue(world, floor, of_object, &three));
    OK(thud_body_set_epilogue(world, ball, NULL, NULL));
    told_are(world, 1, (int[]){3});
    OK(thud_world_set_category_epilogue(world, 1 | 8, of_object, &one));
    OK(thud_world_set_category_epilogue(world, 1, of_object, &two));
    told_are(world, 5, (int[]){3, 1, 2, 1, 2});
    OK(thud_world_set_listeners(world, NULL)); /* those of objects stay */
    OK(thud_world_set_category_epilogue(world, 1 | 8, of_object, &three));
    told_are(world, 5, (int[]){3, 3, 2, 3, 2});
    OK(thud_world_set_category_epilogue(world, 1 | 8, NULL, NULL));
    OK(thud_body_set_epilogue(world, floor, NULL, NULL));
    told_are(world, 2, (int[]){2, 2});
    OK(thud_world_set_category_epilogue(world, 1, NULL, NULL));
    OK(thud_world_set_category_epilogue(world, 4, NULL, NULL)); /* there is none */
    OK(thud_body_set_epilogue(world, ball, NULL, NULL));
    told_are(world, 0, NULL);
    thud_world_destroy(world);
}

/* A body takes its epilogue along when it is destroyed: the next body in its slot has none. */
static void a_destroyed_body_takes_its_epilogue_along(void **state) {
    (void)state;
    thud_body_id ball, floor;
    thud_world *world = make_rest(&ball, &floor);
    thud_body_id other = add_ball(world, 5, 0.5, 0.5f);
    OK(thud_body_set_epilogue(world, ball, of_object, &one));
    OK(thud_body_set_epilogue(world, other, of_object, &two));
    told_are(world, 2, (int[]){1, 2});
    OK(thud_body_destroy(world, ball));
    told_are(world, 1, (int[]){2});
    thud_body_id next = add_ball(world, 0, 0.5, 0.5f);
    assert_int_equal(next.index1, ball.index1);
    told_are(world, 1, (int[]){2});
    assert_int_equal(thud_body_set_epilogue(world, ball, of_object, &one), THUD_ERROR_STALE);
    OK(thud_body_set_epilogue(world, next, of_object, &three));
    told_are(world, 2, (int[]){2, 3});
    OK(thud_body_set_enabled(world, other, false)); /* it has no contacts then */
    told_are(world, 1, (int[]){3});
    OK(thud_body_set_enabled(world, other, true));
    told_are(world, 2, (int[]){3, 2});
    thud_world_destroy(world);
}

static thud_body_id to_destroy;

static void destroys(thud_world *world, const thud_contact *contact, int side, void *context) {
    of_object(world, contact, side, context);
    if (thud_body_is_valid(world, to_destroy)) {
        OK(thud_body_destroy(world, to_destroy));
    }
}

/* A body that a callback destroys is told no more in that step, and others are. */
static void a_body_destroyed_in_a_callback_is_not_told(void **state) {
    (void)state;
    thud_body_id ball, floor;
    thud_world *world = make_rest(&ball, &floor);
    OK(thud_body_set_epilogue(world, floor, destroys, &one));
    OK(thud_body_set_epilogue(world, ball, of_object, &two));
    to_destroy = (thud_body_id){0};
    told_are(world, 2, (int[]){1, 2});
    to_destroy = ball;
    told_are(world, 1, (int[]){1});
    told_are(world, 0, NULL);
    to_destroy = ball = add_ball(world, 0, 0.5, 0.5f);
    OK(thud_world_set_category_epilogue(world, 1, of_object, &three));
    told_are(world, 2, (int[]){1, 3}); /* the floor's two; nothing of the ball */
    thud_world_destroy(world);
}

static bool kicks(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)settings;
    (void)context;
    thud_velocities up = {{0, 5}, 0};
    OK(thud_contact_decide(world, contact, NULL, &up));
    return true;
}

/* Of a decided contact, too, an object is told all parts, also those that the world's listeners do
 * without. */
static void decided_contacts_are_told_with_all_parts(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        thud_world_def def = thud_default_world_def();
        def.detection = detections[d];
        thud_world *world = make_world(def);
        thud_body_id floor = add_floor(world, NULL), ball = add_ball(world, 0.25, 0.5, 0.5f);
        OK(thud_world_set_listeners(world, &(thud_listeners){.prologue = kicks,
                                                             .without = THUD_CONTACT_BODIES |
                                                                        THUD_CONTACT_POINT}));
        OK(thud_body_set_epilogue(world, ball, of_object, &one));
        told_are(world, 1, (int[]){1});
        assert_int_equal(calls[0].seen.body_a.index1, floor.index1);
        assert_true(thud_body_is_valid(world, calls[0].seen.body_b));
        near_to(calls[0].seen.point.x, 0.25, 0.01);
        assert_true(calls[0].seen.normal_impulse > 0);
        thud_world_destroy(world);
    }
}

/* A sensor has no contacts, a sleeping body is not told, and no body wakes by an epilogue. */
static void sensors_and_sleepers_are_not_told(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def def = thud_default_shape_def();
    def.sensor = true;
    thud_body_id zone = add_floor(world, &def), floor = add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    OK(thud_body_set_epilogue(world, zone, of_object, &one));
    OK(thud_body_set_epilogue(world, floor, of_object, &two));
    told_are(world, 1, (int[]){2});
    run(world, 120);
    assert_false(state_of(world, ball).awake);
    OK(thud_body_set_epilogue(world, ball, of_object, &three));
    told_are(world, 0, NULL);
    assert_false(state_of(world, ball).awake);
    OK(thud_body_set_awake(world, ball, true));
    told_are(world, 2, (int[]){2, 3});
    thud_world_destroy(world);
}

/* Not part of snapshots: a restored world has the epilogues that it had before. */
static void snapshots_leave_epilogues_alone(void **state) {
    (void)state;
    static char bytes[1 << 16];
    size_t size;
    thud_body_id ball, floor;
    thud_world *world = make_rest(&ball, &floor);
    OK(thud_body_set_epilogue(world, ball, of_object, &one));
    OK(thud_world_snapshot(world, bytes, sizeof bytes, &size));
    OK(thud_body_set_epilogue(world, ball, of_object, &two));
    OK(thud_world_restore(world, bytes, size));
    told_are(world, 1, (int[]){2});
    OK(thud_body_destroy(world, ball));
    run(world, 1);
    OK(thud_world_restore(world, bytes, size)); /* the ball is back, and its epilogue gone */
    told_are(world, 0, NULL);
    thud_body_id later = add_ball(world, 3, 0.5, 0.5f);
    OK(thud_body_set_epilogue(world, later, of_object, &three));
    OK(thud_world_restore(world, bytes, size)); /* that body never was */
    told_are(world, 0, NULL);
    thud_world_destroy(world);
}

/* ---- refused ---- */

static void tries(thud_world *world, const thud_contact *contact, int side, void *context) {
    thud_body_id body = side ? contact->body_b : contact->body_a;
    assert_int_equal(thud_body_set_epilogue(world, body, NULL, NULL), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_category_epilogue(world, 1, of_object, &one),
                     THUD_ERROR_LOCKED);
    of_object(world, contact, side, context);
}

static void refused_calls_change_nothing(void **state) {
    (void)state;
    thud_body_id ball, floor, none = {0};
    thud_world *world = make_rest(&ball, &floor);
    assert_int_equal(thud_body_set_epilogue(NULL, ball, of_object, &one), THUD_ERROR_NULL);
    assert_int_equal(thud_body_set_epilogue(world, none, of_object, &one), THUD_ERROR_STALE);
    assert_int_equal(thud_world_set_category_epilogue(NULL, 1, of_object, &one), THUD_ERROR_NULL);
    assert_int_equal(thud_world_set_category_epilogue(world, 0, of_object, &one),
                     THUD_ERROR_INVALID);
    told_are(world, 0, NULL);
    OK(thud_body_set_epilogue(world, ball, tries, &one));
    told_are(world, 1, (int[]){1});
    told_are(world, 1, (int[]){1});
    thud_world_destroy(world);
}

/* Every allocation that fails is told, and leaves what was set before. */
static void out_of_memory_nothing_changes(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    def.allocator = hostile_memory();
    thud_world *world = make_world(def);
    thud_body_id floor = add_floor(world, NULL), ball = add_ball(world, 0, 0.5, 0.5f);
    run(world, 2);
    int failed = 0;
    for (thud_result result = THUD_ERROR_MEMORY; result != THUD_OK; failed++) {
        memory_allowed = failed;
        result = thud_body_set_epilogue(world, ball, of_object, &one);
        memory_allowed = -1;
        told_are(world, result == THUD_OK, (int[]){1});
    }
    assert_int_equal(failed, 4); /* what was allocated before stays for the next call */
    memory_allowed = 0;
    assert_int_equal(thud_world_set_category_epilogue(world, 1, of_object, &two),
                     THUD_ERROR_MEMORY);
    memory_allowed = -1;
    told_are(world, 1, (int[]){1});
    OK(thud_body_set_epilogue(world, floor, of_object, &two));
    told_are(world, 2, (int[]){2, 1});
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

int main(void) {
    for (int i = 0; i < (int)(sizeof numbers / sizeof *numbers); i++) {
        numbers[i] = i;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_object_is_told_of_its_own_contacts),
        cmocka_unit_test(objects_need_no_epilogue_of_the_world),
        cmocka_unit_test(epilogues_are_replaced_and_removed),
        cmocka_unit_test(a_destroyed_body_takes_its_epilogue_along),
        cmocka_unit_test(a_body_destroyed_in_a_callback_is_not_told),
        cmocka_unit_test(decided_contacts_are_told_with_all_parts),
        cmocka_unit_test(sensors_and_sleepers_are_not_told),
        cmocka_unit_test(snapshots_leave_epilogues_alone),
        cmocka_unit_test(refused_calls_change_nothing),
        cmocka_unit_test(out_of_memory_nothing_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
