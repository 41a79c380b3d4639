/* test_rollback.c: rollback (thud_rollback.h): inputs that arrive late, in any order, end with the
 * same bits as inputs in time; impossible inputs are refused; failing steps and allocations do no
 * harm. */
#include "engine_support.h"

#include "hostile_memory.h"

#include <thud/thud_forces.h>
#include <thud/thud_make.h>
#include <thud/thud_reads.h>
#include <thud/thud_rollback.h>

/* Options of the rollback; IDLE is the input of a player before its first known one. */
enum { PLAYERS = 3, STEPS = 200, DEPTH = 8, IDLE = 4 };

/* The game's own state, which is rolled back with the world. The input makes new balls now and
 * then. */
typedef struct game {
    thud_body_id player[PLAYERS];
    int64_t steps;
    uint64_t sum; /* hash of all inputs */
} game;

/* fails_at: the step that fails once; played: how often `play` was called. */
static int fails_at = -1, played;

/* The step function of the rollback: applies the inputs, and steps. */
static thud_result play(thud_world *world, const uint64_t *inputs, void *state) {
    game *g = state;
    played++;
    for (int i = 0; i < PLAYERS; i++) {
        thud_vec2 push = {((int)inputs[i] % 3 - 1) * 0.5f, ((int)inputs[i] / 3 - 1) * 0.5f};
        OK(thud_body_apply_center_impulse(world, g->player[i], push));
        g->sum = g->sum * 31 + inputs[i];
    }
    if (g->sum % 5 == 0) {
        thud_body_options ball = {.kind = THUD_BODY_DYNAMIC};
        double x = (double)(g->steps % 9) - 4;
        if (!thud_body_make(world, thud_circle_at(x, 5, 0.25), &ball).index1) {
            return THUD_ERROR_MEMORY;
        }
    }
    if (g->steps++ == fails_at) {
        fails_at = -1;
        return THUD_ERROR_STALE;
    }
    return thud_world_step(world);
}

static thud_world_def hostile_def(void) {
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    return def;
}

static thud_world *make_game(game *g) {
    thud_world *world = make_world(hostile_def());
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC, .restitution = 0.5f};
    *g = (game){.sum = 1};
    thud_body_make(world, thud_aabb_at(0, -1, 30, 1), NULL);
    for (int i = 0; i < PLAYERS; i++) {
        g->player[i] = thud_body_make(world, thud_circle_at(2 * i - 2, 1, 0.5), &ball);
    }
    return world;
}

static thud_rollback *make_rollback(thud_world *world, game *g) {
    thud_rollback *made = NULL;
    thud_rollback_options options = {.players = PLAYERS,
                                     .depth = DEPTH,
                                     .idle = IDLE,
                                     .step = play,
                                     .state = g,
                                     .state_bytes = sizeof *g};
    OK(thud_rollback_create(world, &options, &made));
    return made;
}

/* The input of a player in a step: one of nine directions. */
static uint64_t input_of(int player, int64_t step) {
    return (uint64_t)(step / 7 * 5 + player * 3) % 9; /* each input is held for 7 steps */
}

/* Reference: the hash before each step, with every input in time. */
static void play_straight(uint64_t hashes[STEPS + 1], game *end) {
    game g;
    thud_world *world = make_game(&g);
    for (int i = 0; i < STEPS; i++) {
        uint64_t inputs[PLAYERS];
        hashes[i] = thud_hash_of(world);
        for (int p = 0; p < PLAYERS; p++) {
            inputs[p] = input_of(p, i);
        }
        OK(play(world, inputs, &g));
    }
    hashes[STEPS] = thud_hash_of(world);
    *end = g;
    thud_world_destroy(world);
}

/* Gives each player's inputs as late as allowed, in a random order, some of them twice. */
static void hear(thud_rollback *r, int64_t now, uint64_t *seed) {
    for (int p = 0; p < PLAYERS; p++) {
        for (int64_t step = now < DEPTH ? 0 : now - DEPTH + 1; step <= now; step++) {
            bool last = step == now - DEPTH + 1;
            if (last || random_in(seed, 0, 1) < 0.2) {
                OK(thud_rollback_input(r, p, step, input_of(p, step)));
            }
        }
    }
}

/* Gives all inputs of the last steps. */
static void tell_all(thud_rollback *r) {
    for (int p = 0; p < PLAYERS; p++) {
        for (int64_t step = STEPS - DEPTH; step < STEPS; step++) {
            OK(thud_rollback_input(r, p, step, input_of(p, step)));
        }
    }
}

/* At each time the confirmed step has the hash of the reference, and so has the end, with ten
 * random orders of inputs. */
static void late_inputs_end_as_if_all_had_come_in_time(void **state) {
    (void)state;
    static uint64_t hashes[STEPS + 1];
    game straight, g, before;
    play_straight(hashes, &straight);
    for (uint64_t round = 1; round <= 10; round++) {
        uint64_t seed = round, hash;
        thud_world *world = make_game(&g);
        thud_rollback *r = make_rollback(world, &g);
        played = 0;
        for (int64_t now = 0; now < STEPS; now++) {
            bool made = false;
            hear(r, now, &seed);
            OK(thud_rollback_advance(r, &made));
            assert_true(made);
            int64_t sure = thud_progress_of(r).confirmed;
            assert_true(sure >= now - DEPTH + 2 && sure <= now + 1);
            OK(thud_rollback_get_state(r, sure, &hash, &before));
            assert_true(hash == hashes[sure] && before.steps == sure);
        }
        tell_all(r);
        OK(thud_rollback_settle(r));
        thud_rollback_progress progress = thud_progress_of(r);
        assert_true(progress.steps == STEPS && progress.confirmed == STEPS);
        assert_true(progress.replayed > 0 && progress.replayed == played - STEPS);
        assert_true(thud_hash_of(world) == hashes[STEPS]);
        assert_true(g.sum == straight.sum && g.steps == STEPS);
        thud_rollback_destroy(r);
        thud_world_destroy(world);
        assert_int_equal(memory_held, 0);
    }
}

/* Where all inputs are in time, each step is played once. */
static void inputs_in_time_are_played_once(void **state) {
    (void)state;
    game g;
    thud_world *world = make_game(&g);
    thud_rollback *r = make_rollback(world, &g);
    played = 0;
    for (int64_t now = 0; now < 30; now++) {
        for (int p = 0; p < PLAYERS; p++) {
            OK(thud_rollback_input(r, p, now + p, 7)); /* some inputs are for later steps */
        }
        for (int64_t ahead = 0; now == 0 && ahead < PLAYERS; ahead++) {
            for (int p = 0; p < PLAYERS; p++) {
                OK(thud_rollback_input(r, p, ahead, 7));
            }
        }
        OK(thud_rollback_advance(r, NULL));
    }
    assert_int_equal(played, 30);
    assert_true(thud_progress_of(r).replayed == 0);
    thud_rollback_destroy(r);
    thud_world_destroy(world);
}

/* Where a player's input is missing for more than `depth` steps, thud_rollback_advance makes no
 * step until all inputs of the oldest step are there. */
static void who_is_not_heard_of_is_waited_for(void **state) {
    (void)state;
    game g;
    thud_world *world = make_game(&g);
    thud_rollback *r = make_rollback(world, &g);
    bool made = true;
    int steps = 0;
    for (; made; steps++) {
        OK(thud_rollback_input(r, 0, steps, 1));
        OK(thud_rollback_advance(r, &made));
    }
    assert_int_equal(steps - 1, DEPTH);
    OK(thud_rollback_input(r, 1, 0, 1));
    OK(thud_rollback_advance(r, &made));
    assert_false(made);
    OK(thud_rollback_input(r, 2, 0, 1));
    OK(thud_rollback_advance(r, &made));
    assert_true(made);
    thud_rollback_destroy(r);
    thud_world_destroy(world);
}

/* Steps whose predicted inputs prove right are not played again. */
static void prediction_holds_what_was_held(void **state) {
    (void)state;
    game g;
    thud_world *world = make_game(&g);
    thud_rollback *r = make_rollback(world, &g);
    for (int p = 0; p < PLAYERS; p++) {
        OK(thud_rollback_input(r, p, 0, 2));
    }
    for (int i = 0; i < 5; i++) {
        OK(thud_rollback_advance(r, NULL));
    }
    played = 0;
    for (int step = 1; step < 4; step++) {
        for (int p = 0; p < PLAYERS; p++) {
            OK(thud_rollback_input(r, p, step, 2));
        }
    }
    OK(thud_rollback_settle(r));
    assert_int_equal(played, 0);
    OK(thud_rollback_input(r, 1, 4, 3));
    OK(thud_rollback_settle(r));
    assert_int_equal(played, 1);
    thud_rollback_destroy(r);
    thud_world_destroy(world);
}

/* ---- failures and wrong calls ---- */

/* A step function that fails is called again by the next call, from the same state; the end is the
 * reference's. */
static void failed_step_is_made_again(void **state) {
    (void)state;
    static uint64_t hashes[STEPS + 1];
    game straight, g;
    play_straight(hashes, &straight);
    thud_world *world = make_game(&g);
    thud_rollback *r = make_rollback(world, &g);
    uint64_t seed = 3;
    int failures = 0;
    for (int64_t now = 0; now < STEPS; now++) {
        hear(r, now, &seed);
        fails_at = now % 9 == 0 ? (int)(now < 3 ? now : now - 3) : now % 7 == 0 ? (int)now : -1;
        thud_result result = thud_rollback_advance(r, NULL);
        if (result != THUD_OK) {
            assert_int_equal(result, THUD_ERROR_STALE);
            assert_true(thud_progress_of(r).steps == now);
            failures++;
            OK(thud_rollback_advance(r, NULL));
        }
        fails_at = -1;
    }
    tell_all(r);
    OK(thud_rollback_settle(r));
    assert_true(failures > 20 && thud_hash_of(world) == hashes[STEPS]);
    thud_rollback_destroy(r);
    thud_world_destroy(world);
}

/* Creating and advancing with failing allocations has an effect only where it succeeds; the end is
 * the reference's. */
static void memory_that_fails_is_asked_again(void **state) {
    (void)state;
    static uint64_t hashes[STEPS + 1];
    game straight, g;
    play_straight(hashes, &straight);
    thud_world *world = make_game(&g);
    thud_rollback *r = NULL;
    thud_rollback_options options = {.players = PLAYERS,
                                     .depth = DEPTH,
                                     .idle = IDLE,
                                     .step = play,
                                     .state = &g,
                                     .state_bytes = sizeof g};
    long held = memory_held, failures = 0;
    for (long allowed = 0; !r; allowed++) {
        memory_allowed = allowed;
        thud_result result = thud_rollback_create(world, &options, &r);
        memory_allowed = -1;
        assert_true(result == THUD_OK || (result == THUD_ERROR_MEMORY && !r));
        assert_true(r || memory_held == held);
        failures += !r;
    }
    assert_int_equal(failures, DEPTH + 2);
    uint64_t seed = 5;
    for (int64_t now = 0; now < STEPS; now++) {
        hear(r, now, &seed);
        for (long allowed = 0;; allowed++) {
            memory_allowed = allowed;
            thud_result result = thud_rollback_advance(r, NULL);
            memory_allowed = -1;
            if (result == THUD_OK) {
                break;
            }
            assert_int_equal(result, THUD_ERROR_MEMORY);
            failures++;
        }
    }
    tell_all(r);
    OK(thud_rollback_settle(r));
    print_message("%ld allocations failed\n", failures);
    assert_true(failures > DEPTH + 12);
    assert_true(thud_hash_of(world) == hashes[STEPS]);
    thud_rollback_destroy(r);
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

/* The rollback whose step function calls it. */
static thud_rollback *inner;

/* A step function inside of which calls of the rollback are refused. */
static thud_result ask_inside(thud_world *world, const uint64_t *inputs, void *state) {
    bool made;
    (void)inputs, (void)state;
    assert_int_equal(thud_rollback_input(inner, 0, 0, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_advance(inner, &made), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_settle(inner), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_get_state(inner, 0, NULL, NULL), THUD_ERROR_LOCKED);
    size_t bytes;
    int64_t lead;
    thud_rollback_difference found;
    assert_int_equal(thud_rollback_report(inner, -1, NULL, 0, &bytes), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_compare(inner, &bytes, 1, &found), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_snapshot(inner, NULL, 0, &bytes), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_restore(inner, &bytes, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_leave(inner, 0, 0), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_enter(inner, 0, 0), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_get_lead(inner, 0, &lead), THUD_ERROR_LOCKED);
    assert_int_equal(thud_rollback_set_lead(inner, 0, 0), THUD_ERROR_LOCKED);
    thud_rollback_destroy(inner);
    return thud_world_step(world);
}

static void wrong_calls_are_refused(void **state) {
    (void)state;
    game g;
    uint64_t hash = 7;
    thud_world *world = make_game(&g);
    thud_rollback *r = NULL;
    const thud_rollback_options wrong[] = {{.step = NULL},
                                           {.step = play, .players = -1},
                                           {.step = play, .players = THUD_ROLLBACK_PLAYERS_MAX + 1},
                                           {.step = play, .depth = -1},
                                           {.step = play, .depth = THUD_ROLLBACK_DEPTH_MAX + 1},
                                           {.step = play, .state = &g},
                                           {.step = play, .state_bytes = 8}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_equal(thud_rollback_create(world, &wrong[i], &r), THUD_ERROR_INVALID);
        assert_null(r);
    }
    thud_rollback_options endless = {.step = play, .state = &g, .state_bytes = SIZE_MAX};
    assert_int_equal(thud_rollback_create(world, &endless, &r), THUD_ERROR_MEMORY);
    assert_int_equal(thud_rollback_create(NULL, &endless, &r), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_create(world, NULL, &r), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_create(world, &endless, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_input(NULL, 0, 0, 0), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_advance(NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_settle(NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_get_state(NULL, 0, &hash, NULL), THUD_ERROR_NULL);
    assert_true(thud_progress_of(NULL).steps == 0);
    thud_rollback_destroy(NULL);

    r = make_rollback(world, &g);
    assert_int_equal(thud_rollback_input(r, -1, 0, 0), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_input(r, PLAYERS, 0, 0), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_input(r, 0, -1, 0), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_input(r, 0, DEPTH + 1, 0), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_input(r, 0, INT64_MAX, 0), THUD_ERROR_INVALID);
    OK(thud_rollback_input(r, 0, DEPTH, 5));
    OK(thud_rollback_input(r, 0, DEPTH, 5));
    assert_int_equal(thud_rollback_input(r, 0, DEPTH, 6), THUD_ERROR_INVALID);
    for (int64_t i = 0; i < 3 * DEPTH; i++) {
        for (int p = 0; p < PLAYERS; p++) {
            OK(thud_rollback_input(r, p, i, 5));
        }
        OK(thud_rollback_advance(r, NULL));
    }
    /* an input that was given long ago and is not kept any more */
    OK(thud_rollback_input(r, 0, 0, 6));
    OK(thud_rollback_get_state(r, 2 * DEPTH, &hash, NULL));
    OK(thud_rollback_get_state(r, 3 * DEPTH, &hash, NULL));
    assert_true(hash == thud_hash_of(world));
    hash = 7;
    assert_int_equal(thud_rollback_get_state(r, 2 * DEPTH - 1, &hash, &g), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_get_state(r, 3 * DEPTH + 1, &hash, &g), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_get_state(r, -1, &hash, &g), THUD_ERROR_INVALID);
    assert_true(hash == 7);
    thud_rollback_destroy(r);

    thud_rollback_options asking = {.step = ask_inside};
    OK(thud_rollback_create(world, &asking, &inner));
    OK(thud_rollback_advance(inner, NULL));
    thud_rollback_destroy(inner);
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(late_inputs_end_as_if_all_had_come_in_time),
        cmocka_unit_test(inputs_in_time_are_played_once),
        cmocka_unit_test(who_is_not_heard_of_is_waited_for),
        cmocka_unit_test(prediction_holds_what_was_held),
        cmocka_unit_test(failed_step_is_made_again),
        cmocka_unit_test(memory_that_fails_is_asked_again),
        cmocka_unit_test(wrong_calls_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
