/* test_event_ledger.c: ledgers of events in random worlds whose bodies are created, destroyed,
 * moved and put to sleep at any time, also inside callbacks: each begin has exactly one end, and no
 * pair begins twice. */
#include "event_chaos.h"
#include "every_choice.h"
#include "share.h"

static int slept_in_all; /* sum over steps of the sleeping bodies */

/* How many dynamic bodies sleep. */
static int sleepers(const chaos *c) {
    int count = 0;
    for (int i = 0; i < BODIES; i++) {
        thud_body_state state = {.awake = true};
        thud_body_get_state(c->world, c->bodies[i], &state);
        count += state.kind == THUD_BODY_DYNAMIC && !state.awake;
    }
    return count;
}

/* Runs a random world and books its events. */
static void run_chaos(const thud_detection *detection, const thud_broadphase *broadphase,
                      uint64_t seed) {
    chaos *c = calloc(1, sizeof *c);
    thud_world_def def = thud_default_world_def();
    def.detection = detection;
    def.broadphase = broadphase;
    c->seed = seed;
    c->world = make_world(def);
    set_listeners(c->world, ask, tell, c);
    add_pit(c);
    add_ground(c);
    for (int i = 0; i < BODIES; i++) {
        add_random_body(c, i);
    }
    for (int i = 0; i < STEPS; i++) {
        c->quiet = i % 120 > 40; /* long enough for islands to fall asleep */
        for (int edits = c->quiet ? 0 : pick(c, 3); edits > 0; edits--) {
            edit(c);
        }
        if (!c->quiet && pick(c, 8) == 0) {
            edit_ground(c);
        }
        if (pick(c, 2)) {
            query(c);
        }
        step(c);
        slept_in_all += sleepers(c);
    }
    assert_true(c->edits_inside > 20);
    assert_true(c->touches.begun > 100);
    assert_true(c->sensed.begun > 20);
    c->quiet = true;
    OK(thud_body_destroy(c->world, c->ground));
    for (int i = 0; i < BODIES; i++) {
        fine_or_gone(thud_body_destroy(c->world, c->bodies[i]));
    }
    query(c);
    step(c);
    assert_int_equal(c->touches.count, 0);
    assert_int_equal(c->sensed.count, 0);
    thud_world_destroy(c->world);
    free(c);
}

static void every_begin_has_its_end_whatever_is_edited_and_where(void **state) {
    (void)state;
    for (int d = 0; d < 4; d++) {
        for (int b = 0; b < 3; b++) {
            for (uint64_t seed = 1; seed <= (uint64_t)share_of(4); seed++) {
                run_chaos(detections[d], broadphases[b], seed * 7919);
            }
        }
    }
    assert_true(slept_in_all > share_of(1000));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_begin_has_its_end_whatever_is_edited_and_where),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
