/* test_listeners.c: prologues and epilogues (thud_listeners.h) that are set, changed and removed
 * while a world runs, called for single contacts or for all at once. */
#include "every_choice.h"
#include "hostile_memory.h"
#include "listeners_support.h"
#include "share.h"

#include <thud/thud_testing.h>

enum { DETECTIONS = 4, STEPS = 150 };

static thud_world_def def_with(int detection) {
    thud_world_def def = thud_default_world_def();
    def.detection = detections[detection];
    return def;
}

/* Listeners of all four forms are given the same contacts in the same order and cause the same
 * motion; those for all contacts are called far less often. */
static void both_forms_hear_and_do_the_same(void **state) {
    (void)state;
    static uint64_t hashes[STEPS];
    static ear ears[FORMS];
    thud_body_id bodies[BODIES];
    for (int d = 0; d < DETECTIONS; d++) {
        for (int form = 0; form < FORMS; form++) {
            ear *e = &ears[form];
            thud_world_def def = def_with(d);
            thud_world_def_set_baseline_simd(
                &def, form == 3); /* blocks of eight lanes at once, or in two halves */
            thud_world *world = make_scene(def, bodies);
            thud_listeners listeners = of_form(form, e);
            *e = (ear){0};
            OK(thud_world_set_listeners(world, &listeners));
            for (int i = 0; i < STEPS; i++) {
                e->heard_count = 0;
                OK(thud_world_step(world));
                uint64_t hash = thud_hash_of(world);
                hashes[i] = form ? hashes[i] : hash;
                assert_true(hashes[i] == hash);
            }
            assert_true(e->digest == ears[0].digest);
            assert_true(e->asked > 20 * STEPS && e->told > 20 * STEPS);
            assert_true(e->vetoed > 3 * STEPS && e->changed > 5 * STEPS);
            thud_world_destroy(world);
        }
        assert_int_equal(ears[0].calls, ears[0].asked + ears[0].told);
        assert_true(ears[3].calls < ears[0].calls / 8);
    }
}

/* ---- removed and set again ---- */

/* Once the prologue is removed, the world behaves as one whose prologue accepts every contact as it
 * is. */
static void without_a_prologue_pairs_are_their_own_again(void **state) {
    (void)state;
    thud_body_id bodies[BODIES];
    for (int i = 0; i < 2 * DETECTIONS * FORMS; i += TEST_SHARE) {
        static ear here, twin;
        thud_world_def def = def_with(i % DETECTIONS);
        int form = i / DETECTIONS % FORMS, before = i < DETECTIONS * FORMS ? 40 : 130;
        thud_world *one = make_scene(def, bodies), *other = make_scene(def, bodies);
        thud_listeners listens = of_form(form, &here), listens_too = of_form(form, &twin);
        here = twin = (ear){0};
        OK(thud_world_set_listeners(one, &listens));
        OK(thud_world_set_listeners(other, &listens_too));
        run(one, before);
        run(other, before);
        assert_true(here.vetoed > 0 && here.changed > 0);
        twin.plain = true;
        int calls = here.calls;
        if (form & 1) { /* no listeners at all; else an epilogue alone */
            OK(thud_world_set_listeners(one, NULL));
        } else {
            here.plain = true;
            OK(thud_world_set_listeners(one,
                                        &(thud_listeners){.epilogue = tell, .context = &here}));
        }
        OK(thud_world_set_listeners(other, &listens_too));
        for (int k = 0; k < 60; k++) {
            run(one, 1);
            run(other, 1);
            if (thud_hash_of(one) != thud_hash_of(other)) {
                fail_msg("detection %d, form %d: differs %d steps later", i % DETECTIONS, form, k);
            }
        }
        assert_true(form & 1 ? here.calls == calls : here.told > calls / 9);
        here.plain = twin.plain = false;
        here.digest = twin.digest = 0;
        listens = of_form(FORMS - 1 - form, &here);
        OK(thud_world_set_listeners(one, &listens));
        /* setting listeners wakes all bodies there as well */
        OK(thud_world_set_listeners(other, &listens_too));
        here.told = twin.told = 0;
        run(one, 60);
        run(other, 60);
        assert_true(here.digest == twin.digest && thud_hash_of(one) == thud_hash_of(other));
        thud_world_destroy(one);
        thud_world_destroy(other);
    }
}

/* ---- what listeners are given ---- */

/* The manifold of a contact that a listener was given; null where there is none. */
static const thud_manifold *manifold_of(const thud_manifold *all, int count,
                                        const thud_contact *heard) {
    for (int i = 0; i < count; i++) {
        if (all[i].shape_a.index1 == heard->shape_a.index1 &&
            all[i].shape_b.index1 == heard->shape_b.index1 &&
            (double)fabsf(all[i].normal.x - heard->normal.x) == 0 &&
            all[i].normal.y == heard->normal.y &&
            /* a terrain has one pair for each segment */
            fabs(all[i].point[0].x - heard->point.x) < 2) {
            const thud_manifold *m = &all[i];
            double x = m->point_count == 2 ? 0.5 * (m->point[0].x + m->point[1].x) : m->point[0].x;
            double y = m->point_count == 2 ? 0.5 * (m->point[0].y + m->point[1].y) : m->point[0].y;
            float separation = m->point_count == 2 && m->separation[1] < m->separation[0]
                                   ? m->separation[1]
                                   : m->separation[0];
            if (m->point_count == heard->point_count && fabs(x - heard->point.x) < 1e-5 &&
                fabs(y - heard->point.y) < 1e-5 && separation == heard->separation) {
                return m;
            }
        }
    }
    return NULL;
}

/* The epilogue is given the manifolds as they are after the step and no others; and the impulses
 * that it is given explain, with gravity, all changes of velocity. */
static void epilogues_hear_manifolds_and_all_impulses(void **state) {
    (void)state;
    for (int i = 0; i < 2 * QUALITIES; i++) {
        static ear e;
        static thud_manifold all[64];
        thud_body_id bodies[BODIES];
        thud_body_state before[BODIES];
        thud_world_def def = thud_default_world_def_of(qualities[i / 2]);
        def.detection = &thud_detection_overlap;
        def.sleeping = false;
        thud_world *world = make_scene(def, bodies);
        thud_listeners listeners = of_form(i % 2 ? 3 : 0, &e);
        e = (ear){.plain = true};
        OK(thud_world_set_listeners(world, &listeners));
        run(world, 30);
        for (int step = 0; step < 30; step++) {
            int ends = 0, moving_ends = 0;
            for (int k = 0; k < BODIES; k++) {
                before[k] = state_of(world, bodies[k]);
            }
            e.heard_count = 0;
            run(world, 1);
            assert_in_range(e.heard_count, 30, HEARD_MOST - 1);
            for (int k = 0; k < BODIES; k++) {
                thud_body_state after = state_of(world, bodies[k]);
                double mass = (double)after.mass, x = 0, y = -10.0 / 60 * mass;
                int count;
                OK(thud_body_get_contacts(world, bodies[k], all, 64, &count));
                for (int c = 0; c < e.heard_count; c++) {
                    const thud_contact *heard = &e.heard[c];
                    bool is_b = heard->body_b.index1 == bodies[k].index1;
                    if (!is_b && heard->body_a.index1 != bodies[k].index1) {
                        continue;
                    }
                    moving_ends++;
                    assert_non_null(manifold_of(all, count, heard));
                    double n = (double)heard->normal_impulse, t = (double)heard->tangent_impulse;
                    double nx = (double)heard->normal.x, ny = (double)heard->normal.y;
                    x += (is_b ? 1 : -1) * (n * nx + t * ny);
                    y += (is_b ? 1 : -1) * (n * ny - t * nx);
                }
                for (int c = 0; c < count; c++) {
                    ends += all[c].point_count > 0;
                }
                if (after.kind == THUD_BODY_DYNAMIC) {
                    near_to((double)(after.velocity.x - before[k].velocity.x) * mass, x, 2e-3);
                    near_to((double)(after.velocity.y - before[k].velocity.y) * mass, y, 2e-3);
                }
            }
            assert_int_equal(ends, moving_ends);
        }
        thud_world_destroy(world);
    }
}

/* ---- listeners that leave out parts of contacts ---- */

/* Contacts that listeners were given in a step. */
typedef struct heard_list {
    thud_contact all[2 * HEARD_MOST];
    int count;
} heard_list;

static bool list_asked(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *settings, void *context) {
    (void)world;
    (void)settings;
    heard_list *list = context;
    assert_in_range(list->count, 0, 2 * HEARD_MOST - 1);
    list->all[list->count++] = *contact;
    return true;
}

static void list_told(thud_world *world, const thud_contact *contact, void *context) {
    list_asked(world, contact, NULL, context);
}

/* The parts named in `without` are 0; the other parts, and the world, do not change. */
static void parts_that_listeners_do_without_are_not_told(void **state) {
    (void)state;
    static heard_list whole, lean;
    thud_body_id bodies[BODIES];
    for (uint32_t without = 0; without < 4; without++) {
        /* `overlap`: impacts within the step are always given whole */
        thud_world_def def = def_with(0);
        thud_world *one = make_scene(def, bodies), *other = make_scene(def, bodies);
        thud_listeners listens = {.prologue = list_asked, .epilogue = list_told};
        listens.context = &whole;
        OK(thud_world_set_listeners(one, &listens));
        listens.context = &lean;
        listens.without = without;
        OK(thud_world_set_listeners(other, &listens));
        for (int step = 0; step < 40; step++) {
            whole.count = lean.count = 0;
            run(one, 1);
            run(other, 1);
            assert_true(thud_hash_of(one) == thud_hash_of(other));
            assert_int_equal(whole.count, lean.count);
            for (int i = 0; i < whole.count; i++) {
                const thud_contact *a = &whole.all[i], *b = &lean.all[i];
                assert_int_equal(a->shape_a.index1, b->shape_a.index1);
                assert_int_equal(a->shape_b.index1, b->shape_b.index1);
                assert_true(thud_shape_is_valid(other, b->shape_a));
                assert_true(a->normal.x == b->normal.x && a->normal.y == b->normal.y);
                assert_true(a->separation == b->separation && a->point_count == b->point_count);
                assert_true(a->normal_impulse == b->normal_impulse);
                assert_true(a->tangent_impulse == b->tangent_impulse);
                assert_true(thud_body_is_valid(one, a->body_b));
                if (without & THUD_CONTACT_BODIES) {
                    assert_true(b->body_a.index1 == 0 && b->body_b.generation == 0);
                } else {
                    assert_int_equal(a->body_a.index1, b->body_a.index1);
                    assert_true(thud_body_is_valid(other, b->body_b));
                }
                assert_true(b->point.y == (without & THUD_CONTACT_POINT ? 0 : a->point.y));
            }
        }
        assert_true(whole.count > 60);
        thud_world_destroy(one);
        thud_world_destroy(other);
    }
}

/* ---- what is refused ---- */

/* A prologue inside of which setting listeners is refused. */
static bool tries_to_go(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)contact, (void)settings;
    assert_int_equal(thud_world_set_listeners(world, NULL), THUD_ERROR_LOCKED);
    ++*(int *)context;
    return true;
}

static bool overlap_tries(thud_shape_id shape, void *context) {
    (void)shape;
    assert_int_equal(thud_world_set_listeners(context, NULL), THUD_ERROR_LOCKED);
    return true;
}

static void count_message(thud_result result, const char *message, void *context) {
    assert_true(result != THUD_OK && message[0]);
    ++*(int *)context;
}

/* Refused calls of thud_world_set_listeners (inside a callback, two forms at once, unknown flags,
 * null) leave the present listeners, and each is logged. */
static void refused_listeners_leave_those_that_there_are(void **state) {
    (void)state;
    int messages = 0, asked = 0;
    thud_world_def def = thud_default_world_def();
    def.log = count_message;
    def.log_context = &messages;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    add_ball(world, 0, 0.49, 0.5f);
    set_listeners(world, tries_to_go, NULL, &asked);
    run(world, 2);
    assert_int_equal(asked, 2);
    assert_int_equal(messages, 2);
    OK(thud_world_overlap_shape(world, (thud_pos){0, 0.5}, thud_circle_at(0, 0, 1), NULL,
                                overlap_tries, world));
    assert_int_equal(messages, 4);
    thud_listeners both = {.prologue = ask, .prologue_all = ask_all};
    assert_int_equal(thud_world_set_listeners(world, &both), THUD_ERROR_INVALID);
    both = (thud_listeners){.epilogue = tell, .epilogue_all = tell_all};
    assert_int_equal(thud_world_set_listeners(world, &both), THUD_ERROR_INVALID);
    thud_listeners unknown = {.prologue = ask, .without = 4};
    assert_int_equal(thud_world_set_listeners(world, &unknown), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_set_listeners(NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(messages, 7);
    run(world, 1);
    assert_int_equal(asked, 3);
    thud_world_destroy(world);
}

static void listeners_out_of_memory_change_nothing(void **state) {
    (void)state;
    static ear here, twin;
    thud_body_id bodies[BODIES];
    thud_world_def def = def_with(1);
    thud_world *other = make_scene(def, bodies);
    def.allocator = hostile_memory();
    memory_allowed = -1;
    thud_world *world = make_scene(def, bodies);
    thud_listeners listens = of_form(3, &here), listens_too = of_form(3, &twin);
    here = twin = (ear){0};
    run(world, 10);
    run(other, 10);
    memory_allowed = 0;
    assert_int_equal(thud_world_set_listeners(world, &listens), THUD_ERROR_MEMORY);
    memory_allowed = -1;
    assert_true(thud_hash_of(world) == thud_hash_of(other));
    run(world, 10);
    run(other, 10);
    assert_int_equal(here.calls, 0);
    assert_true(thud_hash_of(world) == thud_hash_of(other));
    OK(thud_world_set_listeners(world, &listens));
    OK(thud_world_set_listeners(other, &listens_too));
    int failures = 0; /* of the allocation for all contacts */
    for (int i = 0; i < 60; i++) {
        for (thud_result result = THUD_ERROR_MEMORY; result != THUD_OK;) {
            int calls = here.calls;
            memory_allowed = 0;
            result = thud_world_step(world);
            memory_allowed = -1;
            if (result != THUD_OK) {
                assert_int_equal(result, THUD_ERROR_MEMORY);
                assert_int_equal(here.calls, calls);
                failures++;
                result = thud_world_step(world);
                OK(result);
            }
        }
        OK(thud_world_step(other));
        assert_true(thud_hash_of(world) == thud_hash_of(other));
        assert_true(here.digest == twin.digest);
    }
    assert_true(failures >= 1);
    OK(thud_world_set_listeners(world, NULL));
    memory_allowed = 0;
    OK(thud_world_set_listeners(world, &listens)); /* the memory is reserved by now */
    memory_allowed = -1;
    thud_world_destroy(world);
    thud_world_destroy(other);
    assert_int_equal(memory_held, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_forms_hear_and_do_the_same),
        cmocka_unit_test(without_a_prologue_pairs_are_their_own_again),
        cmocka_unit_test(epilogues_hear_manifolds_and_all_impulses),
        cmocka_unit_test(parts_that_listeners_do_without_are_not_told),
        cmocka_unit_test(refused_listeners_leave_those_that_there_are),
        cmocka_unit_test(listeners_out_of_memory_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
