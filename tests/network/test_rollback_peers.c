/* test_rollback_peers.c: rollbacks of several peers (thud_rollback.h): a budget of steps, clocks
 * that differ, players who come and go, games that are joined, and reports that name the step, body
 * and player where peers differ; with each quality and detection, and without allocations. */
#include "cars.h"

#include "every_choice.h"
#include "hostile_memory.h"

#include "engine_support.h"

#include <thud/thud_rollback.h>

enum { PLAYERS = 3, DEPTH = 20, STEPS = 160, SEED = 5, DETECTIONS = 4 };

/* A peer of which messages are no concern: the test tells it what it knows. */
typedef struct seat {
    thud_world *world;
    thud_rollback *rollback;
    cars game;
    int64_t told[PLAYERS]; /* inputs given, by player */
} seat;

/* The steps at which player 2 is absent; where both are 0, it never is. */
static int64_t gone_from, back_at;

/* A fault of one peer, the `faulty` one: before this step it pushes a crate. */
static const seat *faulty;
static int64_t fault_at;

static int steps_played;

static thud_result play(thud_world *world, const uint64_t *inputs, void *state) {
    cars *game = state;
    steps_played++;
    if (faulty && game == &faulty->game && (int64_t)thud_stats_of(world).steps == fault_at) {
        thud_vec2 push = {0.25f, 0};
        OK(thud_body_apply_impulse(world, game->bodies[PLAYERS + 2], push, (thud_pos){0, 0}));
    }
    return cars_step(world, inputs, game);
}

static uint64_t input_of(int player, int64_t step) {
    bool absent = player == 2 && step >= gone_from && step < back_at;
    return absent ? CARS_IDLE : cars_input(SEED, player, step);
}

static thud_world_def def_of(int quality, int detection) {
    thud_world_def def = cars_def(qualities[quality]);
    def.detection = detections[detection];
    def.allocator = hostile_memory();
    return def;
}

static void sit_down(seat *s, const thud_world_def *def, int budget) {
    *s = (seat){.world = make_world(*def)};
    assert_true(cars_build(s->world, PLAYERS, &s->game));
    OK(thud_rollback_create(s->world,
                            &(thud_rollback_options){.players = PLAYERS,
                                                     .depth = DEPTH,
                                                     .budget = budget,
                                                     .idle = CARS_IDLE,
                                                     .step = play,
                                                     .state = &s->game,
                                                     .state_bytes = sizeof s->game},
                            &s->rollback));
}

static void stand_up(seat *s) {
    thud_rollback_destroy(s->rollback);
    thud_world_destroy(s->world);
}

static int64_t steps_of(const seat *s) {
    return thud_progress_of(s->rollback).steps;
}

/* Gives the inputs of a player before a step. */
static void tell(seat *s, int player, int64_t before) {
    for (; s->told[player] < before; s->told[player]++) {
        int64_t step = s->told[player];
        OK(thud_rollback_input(s->rollback, player, step, input_of(player, step)));
    }
}

static void tell_all(seat *s, int64_t before) {
    for (int i = 0; i < PLAYERS; i++) {
        tell(s, i, before);
    }
}

/* Runs a step, with the inputs of player 0 in time, of 1 two steps late, and of 2 nine. */
static void play_late(seat *s) {
    int64_t now = steps_of(s);
    bool made = false;
    tell(s, 0, now + 1);
    tell(s, 1, now - 1);
    tell(s, 2, now - 8);
    OK(thud_rollback_advance(s->rollback, &made));
    assert_true(made);
}

static uint64_t hash_at(seat *s, int64_t step) {
    uint64_t hash = 0;
    OK(thud_rollback_get_state(s->rollback, step, &hash, NULL));
    return hash;
}

/* The hash before each step, with every input in time. */
static void play_straight(const thud_world_def *def, uint64_t hashes[STEPS + 1]) {
    cars game;
    thud_world *world = make_world(*def);
    assert_true(cars_build(world, PLAYERS, &game));
    for (int64_t step = 0; step <= STEPS; step++) {
        hashes[step] = thud_hash_of(world);
        uint64_t inputs[PLAYERS];
        for (int i = 0; i < PLAYERS; i++) {
            inputs[i] = input_of(i, step);
        }
        OK(cars_step(world, inputs, &game));
    }
    thud_world_destroy(world);
}

static int start(void **state) {
    (void)state;
    gone_from = back_at = 0;
    faulty = NULL;
    return 0;
}

/* ---- budget ---- */

/* No call plays more steps than the budget and the next one, and what is played is the same. */
static void a_budget_spreads_what_is_played_again(void **state) {
    (void)state;
    enum { BUDGET = 2 };
    static uint64_t hashes[STEPS + 1];
    thud_world_def def = def_of(1, 1);
    play_straight(&def, hashes);
    seat s;
    sit_down(&s, &def, BUDGET);
    int held_back = 0;
    while (steps_of(&s) < STEPS) {
        int64_t now = steps_of(&s);
        tell(&s, 0, now + 1);
        tell(&s, 1, now + 1);
        if (now % 12 == 11) {
            tell(&s, 2, now);
        }
        steps_played = 0;
        bool made;
        OK(thud_rollback_advance(s.rollback, &made));
        assert_true(steps_played <= BUDGET + made);
        thud_rollback_progress progress = thud_progress_of(s.rollback);
        assert_true(progress.steps == now + made);
        assert_true(made == (progress.settled == progress.steps));
        if (!made) {
            assert_true(progress.settled < now);
            assert_true((int64_t)thud_stats_of(s.world).steps == progress.settled);
            held_back++;
        }
        int64_t final =
            progress.confirmed < progress.settled ? progress.confirmed : progress.settled;
        steps_played = 0;
        assert_true(hash_at(&s, final) == hashes[final]);
        assert_int_equal(steps_played, 0);
    }
    tell_all(&s, STEPS);
    OK(thud_rollback_settle(s.rollback));
    assert_true(thud_hash_of(s.world) == hashes[STEPS]);
    print_message("%d frames were held back\n", held_back);
    assert_true(held_back >= 6);
    stand_up(&s);
}

/* ---- clocks ---- */

/* A peer is told by how much its clock is ahead, whatever the delay, and by how much behind. */
static void clocks_are_compared_through_any_delay(void **state) {
    (void)state;
    thud_world_def def = def_of(0, 0);
    for (int delay = 0; delay < 8; delay += 3) {
        seat s[2];
        sit_down(&s[0], &def, 0);
        sit_down(&s[1], &def, 0);
        for (int64_t now = 0; now < 120; now++) {
            for (int i = 0; i < 2; i++) {
                int64_t steps = now - 5 * i; /* the second begins five frames later */
                if (steps < 0) {
                    continue;
                }
                tell(&s[i], i, steps + 1);
                tell(&s[i], 2, steps + 1);
                tell(&s[i], 1 - i, i ? now - delay + 1 : now - 5 - delay + 1);
                OK(thud_rollback_advance(s[i].rollback, NULL));
            }
            int64_t lead;
            for (int i = 0; i < 2 && now > 20; i++) {
                OK(thud_rollback_get_lead(s[1 - i].rollback, i, &lead));
                OK(thud_rollback_set_lead(s[i].rollback, 1 - i, lead));
            }
        }
        near_to(thud_progress_of(s[0].rollback).ahead, 5, 0.5);
        near_to(thud_progress_of(s[1].rollback).ahead, -5, 0.5);
        stand_up(&s[0]);
        stand_up(&s[1]);
    }
}

/* ---- players who come and go ---- */

/* While a player is absent nobody waits for it, and all peers have the game in which it is idle. */
static void absent_players_are_idle(void **state) {
    (void)state;
    static uint64_t hashes[STEPS + 1];
    thud_world_def def = def_of(1, 1);
    gone_from = 30;
    back_at = 100;
    play_straight(&def, hashes);
    for (int late = 0; late < 12; late += 4) {
        seat s;
        sit_down(&s, &def, 0);
        for (int64_t now = 0; now < STEPS; now++) {
            tell(&s, 0, now + 1);
            tell(&s, 1, now + 1);
            tell(&s, 2, now < gone_from ? now - late : gone_from);
            if (now == gone_from + late) {
                OK(thud_rollback_leave(s.rollback, 2, gone_from));
                assert_int_equal(thud_rollback_leave(s.rollback, 2, now), THUD_ERROR_INVALID);
            }
            if (now == back_at - 12 + late) {
                OK(thud_rollback_enter(s.rollback, 2, back_at));
                assert_int_equal(thud_rollback_enter(s.rollback, 2, back_at), THUD_ERROR_INVALID);
            }
            if (now >= back_at + late) {
                s.told[2] = s.told[2] < back_at ? back_at : s.told[2];
                tell(&s, 2, now - late + 1);
            }
            bool made;
            OK(thud_rollback_advance(s.rollback, &made));
            assert_true(made);
            int64_t sure = thud_progress_of(s.rollback).confirmed;
            assert_true(now < gone_from + late || now >= back_at || sure == now + 1);
            assert_true(hash_at(&s, sure) == hashes[sure]);
        }
        tell_all(&s, STEPS);
        assert_true(hash_at(&s, STEPS) == hashes[STEPS]);
        stand_up(&s);
    }
}

/* The bytes of a game that can be joined; the caller frees them. */
static void *bytes_of(seat *s, size_t *bytes) {
    OK(thud_rollback_snapshot(s->rollback, NULL, 0, bytes));
    void *out = malloc(*bytes);
    assert_non_null(out);
    OK(thud_rollback_snapshot(s->rollback, out, *bytes, bytes));
    return out;
}

/* Plays to the end, with player 2 back at `back_at`. */
static void play_to_end(seat *s, const uint64_t hashes[STEPS + 1]) {
    s->told[2] = back_at;
    while (steps_of(s) < STEPS) {
        if (steps_of(s) == back_at - 10) {
            OK(thud_rollback_enter(s->rollback, 2, back_at));
        }
        play_late(s);
        int64_t sure = thud_progress_of(s->rollback).confirmed;
        assert_true(hash_at(s, sure) == hashes[sure]);
    }
    tell_all(s, STEPS);
    assert_true(hash_at(s, STEPS) == hashes[STEPS]);
}

/* Whoever joins a game has it from then on, with every quality and detection, while inputs are late
 * and a player is absent. A world that has run the game before, and so has room for it, allocates
 * nothing. */
static void who_joins_has_the_same_game(void **state) {
    (void)state;
    static uint64_t hashes[STEPS + 1];
    gone_from = 50;
    back_at = 90;
    for (int choice = 0; choice < QUALITIES * DETECTIONS; choice++) {
        thud_world_def def = def_of(choice / DETECTIONS, choice % DETECTIONS);
        play_straight(&def, hashes);
        seat host, guest;
        sit_down(&host, &def, 0);
        while (steps_of(&host) < 40) {
            play_late(&host);
        }
        tell(&host, 2, gone_from);
        OK(thud_rollback_leave(host.rollback, 2, gone_from));
        host.told[2] = back_at;
        while (steps_of(&host) < 60) {
            play_late(&host);
        }
        sit_down(&guest, &def, 0);
        size_t bytes;
        void *game = bytes_of(&host, &bytes);
        int64_t sure = thud_progress_of(host.rollback).confirmed;
        assert_true(sure > gone_from && sure < 60);
        for (int round = 0; round < 2; round++) {
            OK(thud_rollback_restore(guest.rollback, game, bytes));
            assert_true(steps_of(&guest) == sure);
            guest.told[0] = guest.told[1] = sure;
            memory_allowed = round == 0 ? -1 : 0;
            play_to_end(&guest, hashes);
            memory_allowed = -1;
        }
        play_to_end(&host, hashes);
        free(game);
        stand_up(&host);
        stand_up(&guest);
    }
    assert_int_equal(memory_held, 0);
}

/* ---- reports ---- */

/* Both have run some steps, all confirmed. */
static void play_both(seat s[2], int64_t steps) {
    for (int i = 0; i < 2; i++) {
        while (steps_of(&s[i]) < steps) {
            play_late(&s[i]);
        }
        tell_all(&s[i], steps);
        OK(thud_rollback_settle(s[i].rollback));
    }
}

static void *report_of(seat *s, int64_t step, size_t *bytes) {
    OK(thud_rollback_report(s->rollback, step, NULL, 0, bytes));
    void *out = malloc(*bytes);
    assert_non_null(out);
    OK(thud_rollback_report(s->rollback, step, out, *bytes, bytes));
    return out;
}

/* How the second differs from the first by their reports. */
static thud_rollback_difference difference_of(seat s[2]) {
    thud_rollback_difference found;
    size_t bytes;
    uint64_t before = thud_hash_of(s[0].world);
    void *report = report_of(&s[1], -1, &bytes);
    OK(thud_rollback_compare(s[0].rollback, report, bytes, &found));
    free(report);
    if (found.step >= 0) {
        int64_t step = found.step;
        assert_false(found.is_detailed);
        report = report_of(&s[1], step, &bytes);
        OK(thud_rollback_compare(s[0].rollback, report, bytes, &found));
        assert_true(found.is_detailed && found.step == step);
        free(report);
    }
    assert_true(thud_hash_of(s[0].world) == before);
    return found;
}

/* A peer whose world was changed by something else is found out with every quality and detection:
 * the first step after the change, and the body. The reports change nothing. */
static void a_changed_body_is_named(void **state) {
    (void)state;
    static uint64_t hashes[STEPS + 1];
    for (int choice = 0; choice < QUALITIES * DETECTIONS; choice++) {
        thud_world_def def = def_of(choice / DETECTIONS, choice % DETECTIONS);
        faulty = NULL;
        play_straight(&def, hashes);
        seat s[2];
        sit_down(&s[0], &def, 0);
        sit_down(&s[1], &def, 0);
        play_both(s, 50);
        assert_true(difference_of(s).step == -1);
        faulty = &s[1];
        fault_at = 52;
        play_both(s, 60);
        thud_rollback_difference found = difference_of(s);
        assert_true(found.step == 53);
        assert_true(found.body.index1 == s[0].game.bodies[PLAYERS + 2].index1 &&
                    found.body.generation == s[0].game.bodies[PLAYERS + 2].generation);
        assert_int_equal(found.body_slot, (int)found.body.index1 - 1);
        assert_true(found.bodies >= 1 && found.player == -1);
        while (steps_of(&s[0]) < STEPS) {
            play_late(&s[0]);
        }
        tell_all(&s[0], STEPS);
        assert_true(hash_at(&s[0], STEPS) == hashes[STEPS]);
        stand_up(&s[0]);
        stand_up(&s[1]);
    }
    assert_int_equal(memory_held, 0);
}

/* A player who tells others other inputs is named. */
static void a_player_who_tells_other_inputs_is_named(void **state) {
    (void)state;
    thud_world_def def = def_of(1, 1);
    seat s[2];
    sit_down(&s[0], &def, 0);
    sit_down(&s[1], &def, 0);
    play_both(s, 30);
    uint64_t told = input_of(1, 30);
    OK(thud_rollback_input(s[1].rollback, 1, 30, told == 8 ? 0 : 8));
    s[1].told[1] = 31;
    play_both(s, 36);
    thud_rollback_difference found = difference_of(s);
    assert_true(found.step == 31 && found.player == 1);
    assert_true(found.body.index1 == s[0].game.bodies[1].index1);
    stand_up(&s[0]);
    stand_up(&s[1]);
}

/* A body that one of both lacks is named by its slot. */
static void a_missing_body_is_named(void **state) {
    (void)state;
    thud_world_def def = def_of(1, 1);
    for (int i = 0; i < 2; i++) {
        seat s[2];
        sit_down(&s[0], &def, 0);
        sit_down(&s[1], &def, 0);
        thud_body_id last = s[i].game.bodies[s[i].game.count - 1];
        OK(thud_body_destroy(s[i].world, last));
        s[i].game.count--;
        play_both(s, 5);
        thud_rollback_difference found = difference_of(s);
        assert_true(found.step == 0 && found.bodies == 1 && found.player == -1);
        assert_int_equal(found.body_slot, (int)last.index1 - 1);
        assert_true((found.body.index1 == 0) == (i == 0));
        stand_up(&s[0]);
        stand_up(&s[1]);
    }
}

/* ---- wrong calls ---- */

/* Bytes that are cut short, or damaged in any place, are refused, and change nothing. */
static void damaged_bytes_are_refused(void **state) {
    (void)state;
    thud_world_def def = def_of(1, 1);
    seat s[2];
    sit_down(&s[0], &def, 0);
    sit_down(&s[1], &def, 0);
    play_both(s, 30);
    size_t report_bytes, game_bytes;
    unsigned char *report = report_of(&s[1], 25, &report_bytes);
    unsigned char *game = bytes_of(&s[1], &game_bytes);
    thud_rollback_difference found, untouched;
    memset(&untouched, 7, sizeof untouched);
    found = untouched;
    uint64_t hash = thud_hash_of(s[0].world);
    for (size_t i = 0; i < report_bytes; i++) {
        assert_int_equal(thud_rollback_compare(s[0].rollback, report, i, &found),
                         THUD_ERROR_INVALID);
        report[i] ^= 1u << i % 8;
        assert_int_equal(thud_rollback_compare(s[0].rollback, report, report_bytes, &found),
                         THUD_ERROR_INVALID);
        report[i] ^= 1u << i % 8;
    }
    for (size_t i = 0; i < game_bytes; i += 1 + i / 64) {
        assert_int_equal(thud_rollback_restore(s[0].rollback, game, i), THUD_ERROR_INVALID);
        game[i] ^= 1u << i % 8;
        assert_int_equal(thud_rollback_restore(s[0].rollback, game, game_bytes),
                         THUD_ERROR_INVALID);
        game[i] ^= 1u << i % 8;
    }
    assert_memory_equal(&found, &untouched, sizeof found);
    assert_true(thud_hash_of(s[0].world) == hash && steps_of(&s[0]) == 30);
    OK(thud_rollback_compare(s[0].rollback, report, report_bytes, &found));
    OK(thud_rollback_restore(s[0].rollback, game, game_bytes));
    assert_true(thud_hash_of(s[0].world) == hash);
    free(report);
    free(game);
    stand_up(&s[0]);
    stand_up(&s[1]);
}

static void wrong_calls_are_refused(void **state) {
    (void)state;
    thud_world_def def = def_of(1, 1);
    seat s;
    sit_down(&s, &def, 0);
    for (int i = 0; i < 30; i++) {
        play_late(&s);
    }
    thud_rollback *r = s.rollback;
    thud_rollback_difference found;
    unsigned char small[40];
    size_t bytes = 0;
    int64_t lead = 77, sure = thud_progress_of(r).confirmed;
    assert_true(sure == 21);
    assert_int_equal(thud_rollback_report(r, sure + 1, NULL, 0, &bytes), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_report(r, 30 - DEPTH - 1, NULL, 0, &bytes), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_report(r, -2, NULL, 0, &bytes), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_report(r, sure, small, sizeof small, &bytes),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_snapshot(r, small, sizeof small, &bytes), THUD_ERROR_INVALID);
    assert_int_equal(bytes, 0);
    assert_int_equal(thud_rollback_report(r, -1, NULL, 1, &bytes), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_report(r, -1, NULL, 0, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_report(NULL, -1, NULL, 0, &bytes), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_compare(r, NULL, 0, &found), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_compare(r, small, 1, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_snapshot(r, NULL, 1, &bytes), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_snapshot(r, NULL, 0, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_restore(r, NULL, 0), THUD_ERROR_NULL);
    for (int player = -1; player <= PLAYERS; player += PLAYERS + 1) {
        assert_int_equal(thud_rollback_get_lead(r, player, &lead), THUD_ERROR_INVALID);
        assert_int_equal(thud_rollback_set_lead(r, player, 0), THUD_ERROR_INVALID);
        assert_int_equal(thud_rollback_leave(r, player, 30), THUD_ERROR_INVALID);
        assert_int_equal(thud_rollback_enter(r, player, 30), THUD_ERROR_INVALID);
    }
    assert_true(lead == 77);
    assert_int_equal(thud_rollback_get_lead(r, 0, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_rollback_set_lead(r, 0, THUD_ROLLBACK_DEPTH_MAX + 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_set_lead(r, 0, INT64_MIN), THUD_ERROR_INVALID);
    assert_true(thud_progress_of(r).ahead == 0);
    /* Its inputs before 30 are known; the last 20 steps are kept. */
    assert_int_equal(thud_rollback_leave(r, 0, 29), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_leave(r, 0, 30 + DEPTH + 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_enter(r, 0, 40), THUD_ERROR_INVALID);
    OK(thud_rollback_leave(r, 2, 21));
    assert_int_equal(thud_rollback_enter(r, 2, 20), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_enter(r, 2, 30 + DEPTH + 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_rollback_input(r, 2, 25, CARS_IDLE + 1), THUD_ERROR_INVALID);
    /* Player 1 is known before 28, and so are all. */
    assert_int_equal(thud_rollback_enter(r, 2, 27), THUD_ERROR_INVALID);
    OK(thud_rollback_enter(r, 2, 28));
    OK(thud_rollback_input(r, 2, 28, CARS_IDLE + 1));
    stand_up(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_budget_spreads_what_is_played_again, start),
        cmocka_unit_test_setup(clocks_are_compared_through_any_delay, start),
        cmocka_unit_test_setup(absent_players_are_idle, start),
        cmocka_unit_test_setup(who_joins_has_the_same_game, start),
        cmocka_unit_test_setup(a_changed_body_is_named, start),
        cmocka_unit_test_setup(a_player_who_tells_other_inputs_is_named, start),
        cmocka_unit_test_setup(a_missing_body_is_named, start),
        cmocka_unit_test_setup(damaged_bytes_are_refused, start),
        cmocka_unit_test_setup(wrong_calls_are_refused, start),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
