/* test_play.c: two to eight players with random inputs over a network that loses, doubles, delays
 * and reorders what they send, with clocks that differ, players who are killed and join again, and
 * bytes that are no messages: nobody has another game than that of all inputs in time. Who cheats
 * is named.
 *
 * THUD_NETWORK_STEPS=1000000 plays so many steps for each number of players. */
#include "over_wire.h"
#include "random.h"

#include "every_choice.h"

#include "engine_support.h"

enum { CHEAT = 2, HONEST = 0, CHEATED_AT = 150 };

enum { DEPTH = 60, SEED = 11, STEPS = 700, TRUTHS = 1024, DETECTIONS = 4 };

/* A player is killed every so many frames; the others wait for so many until it counts as gone, and
 * it joins again so many later, to play in so many steps. In the last CALM steps nobody is killed.
 */
enum { KILL_EVERY = 500, GONE_AFTER = 30, BACK_AFTER = 120, NOTICE = 10, CALM = 400 };

#define FRAME_MS (1000.0 / CARS_RATE)

typedef struct table {
    int players;
    thud_world_def def;
    peer peers[CARS_MAX];
    bool is_dead[CARS_MAX];
    double phase[CARS_MAX];     /* of its next frame */
    int64_t compared[CARS_MAX]; /* steps whose hashes have been compared with the truth */
    wire *wire;
    uint64_t random;
    int64_t frame;
    int liar; /* who tells HONEST another input of the step CHEATED_AT; -1: nobody */

    thud_world *truth;
    cars truth_game;
    uint64_t truths[TRUTHS]; /* the hash before a step */
    int64_t truth_steps;
    int64_t gone_from[CARS_MAX], back_at[CARS_MAX];

    int64_t replayed, waits, injected, kills, hashes;
} table;

static void begin(table *t, int players, uint64_t seed, double delay) {
    *t = (table){.players = players,
                 .random = seed,
                 .def = cars_def(qualities[seed % QUALITIES]),
                 .liar = -1};
    t->def.detection = detections[seed / QUALITIES % DETECTIONS];
    wire_options o = worst_wire(delay, seed);
    t->wire = wire_create(&o);
    assert_non_null(t->wire);
    t->truth = make_world(t->def);
    assert_true(cars_build(t->truth, players, &t->truth_game));
    t->truths[0] = thud_hash_of(t->truth);
    for (int i = 0; i < players; i++) {
        assert_true(open_player(&t->peers[i], i, players, DEPTH, &t->def));
    }
}

static void end(table *t) {
    for (int i = 0; i < t->players; i++) {
        peer_close(&t->peers[i]);
    }
    thud_world_destroy(t->truth);
    wire_destroy(t->wire);
}

/* ---- the truth ---- */

static uint64_t truth_at(table *t, int64_t step) {
    while (t->truth_steps < step) {
        uint64_t inputs[CARS_MAX];
        int64_t now = t->truth_steps++;
        for (int i = 0; i < t->players; i++) {
            bool is_gone = now >= t->gone_from[i] && now < t->back_at[i];
            inputs[i] = is_gone ? CARS_IDLE : cars_input(SEED, i, now);
        }
        OK(cars_step(t->truth, inputs, &t->truth_game));
        t->truths[t->truth_steps % TRUTHS] = thud_hash_of(t->truth);
    }
    assert_true(step > t->truth_steps - TRUTHS);
    return t->truths[step % TRUTHS];
}

/* The steps that all living players have confirmed. What one of them has confirmed alone may depend
 * on inputs that nobody hears of if it is killed now. */
static int64_t confirmed_by_all(const table *t) {
    int64_t least = INT64_MAX;
    for (int i = 0; i < t->players; i++) {
        int64_t own = t->is_dead[i] ? INT64_MAX : thud_progress_of(t->peers[i].rollback).confirmed;
        least = own < least ? own : least;
    }
    return least;
}

/* Compares the hashes of the steps that all have confirmed with the truth. */
static void compare_with_truth(table *t) {
    int64_t sure = confirmed_by_all(t);
    for (int i = 0; i < t->players; i++) {
        const peer *p = &t->peers[i];
        for (; !t->is_dead[i] && t->compared[i] <= sure && t->compared[i] < p->hashed;
             t->compared[i] += PEER_HASH_STEPS) {
            const peer_hash *own = &p->hashes[t->compared[i] / PEER_HASH_STEPS % PEER_HASHES];
            assert_true(own->step == t->compared[i]);
            if (own->hash != truth_at(t, own->step)) {
                fail_msg("player %d of %d has another game at step %d", i, t->players,
                         (int)own->step);
            }
            t->hashes++;
        }
    }
}

/* ---- frames ---- */

/* Bytes that are no message, or a message with a bit that is another, are read by a player. */
static void inject(table *t, int player) {
    unsigned char bytes[WIRE_BYTES_MAX];
    peer *p = &t->peers[player];
    int count = (int)(random_next(&t->random) % 100), from = (player + 1) % t->players;
    for (int i = 0; i < count; i++) {
        bytes[i] = (unsigned char)random_next(&t->random);
    }
    wire *tap = wire_create(&(wire_options){0});
    peer sender = t->peers[from]; /* what it sends is not counted */
    if (!t->is_dead[from] && random_chance(&t->random) < 0.7) {
        assert_true(send_over(&sender, tap, 0));
        int received = wire_receive(tap, player, 0, bytes, NULL);
        count = received < 0 ? count : received;
        int at = (int)(random_next(&t->random) % (unsigned)(count + 1));
        if (at == count) {
            count = (int)(random_next(&t->random) % (unsigned)(count + 1)) - 1;
        } else {
            bytes[at] ^= (unsigned char)(1u << random_next(&t->random) % 8);
        }
    }
    wire_destroy(tap);
    int64_t refused = p->refused;
    OK(peer_read(p, -1, bytes, count < 0 ? 0 : count));
    assert_true(p->refused == refused + 1);
    t->injected++;
}

/* As send_over, with a lie in the message to HONEST. */
static bool send_with_lie(table *t, peer *p, double now) {
    bool is_sent = true;
    for (int other = 0; other < p->players; other++) {
        unsigned char message[PEER_BYTES_MAX];
        if (!peer_tells(p, other)) {
            continue;
        }
        int count = peer_write(p, other, message);
        message_packet packet;
        assert_true(message_read_packet(message, count, p->players, CARS_INPUTS, &packet));
        int64_t at = packet.runs ? CHEATED_AT - packet.run[0].first : -1;
        if (other == HONEST && at >= 0 && at < packet.run[0].count) {
            /* The inputs stand in the message. */
            unsigned char *input = message + (packet.run[0].inputs - message) + at;
            *input = (unsigned char)((*input + 1) % CARS_INPUTS);
            count = message_seal(message, count - MESSAGE_SUM);
        }
        is_sent &= wire_send(t->wire, p->me, other, now, message, count);
    }
    return is_sent;
}

/* A player's frame. */
static void play_player(table *t, int player) {
    peer *p = &t->peers[player];
    double now = (double)t->frame * FRAME_MS;
    OK(receive_over(p, t->wire, now));
    OK(press_at_random(p, SEED));
    assert_true(player == t->liar ? send_with_lie(t, p, now) : send_over(p, t->wire, now));
    OK(peer_advance(p));
}

/* All players' clocks go on by a frame, each by another rate, which it corrects by how far it is
 * ahead of the others. */
static void play_frame(table *t) {
    for (int i = 0; i < t->players; i++) {
        double skew = 0.01 * (2.0 * i / (t->players - 1) - 1);
        if (t->is_dead[i]) {
            continue;
        }
        double ahead = thud_progress_of(t->peers[i].rollback).ahead;
        t->phase[i] += 1 + skew - fmax(-0.2, fmin(0.2, 0.02 * ahead));
        for (; t->phase[i] >= 1; t->phase[i] -= 1) {
            play_player(t, i);
        }
        if (random_chance(&t->random) < 0.02) {
            inject(t, i);
        }
    }
    compare_with_truth(t);
    t->frame++;
}

/* ---- dying and joining again ---- */

static void count_up(table *t, const peer *p) {
    t->replayed += thud_progress_of(p->rollback).replayed;
    t->waits += p->waits;
}

static void kill_player(table *t, int player) {
    count_up(t, &t->peers[player]);
    peer_close(&t->peers[player]);
    wire_cut(t->wire, player);
    t->is_dead[player] = true;
    t->kills++;
}

/* The others go on without a player, from where the last of its inputs was heard by anyone. */
static void part_with(table *t, int player) {
    int64_t step = 0;
    for (int i = 0; i < t->players; i++) {
        if (!t->is_dead[i] && t->peers[i].known[player].heard > step) {
            step = t->peers[i].known[player].heard;
        }
    }
    t->gone_from[player] = step;
    t->back_at[player] = INT64_MAX;
    for (int i = 0; i < t->players; i++) {
        if (!t->is_dead[i]) {
            peer *p = &t->peers[i];
            while (p->known[player].heard < step) {
                OK(peer_hear(p, player, cars_input(SEED, player, p->known[player].heard)));
            }
            OK(peer_part(p, player, step));
        }
    }
}

static void join_again(table *t, int player) {
    int host = (player + 1) % t->players;
    int64_t back = 0;
    for (int i = 0; i < t->players; i++) {
        int64_t steps = t->is_dead[i] ? 0 : thud_progress_of(t->peers[i].rollback).steps;
        back = steps > back ? steps : back;
    }
    back += NOTICE;
    peer *p = &t->peers[player];
    assert_true(open_player(p, player, t->players, DEPTH, &t->def));
    OK(peer_join(p, &t->peers[host], back));
    int64_t now = thud_progress_of(p->rollback).steps;
    t->compared[player] = p->hashed;
    for (int i = 0; i < t->players; i++) {
        if (!t->is_dead[i]) {
            OK(peer_meet(&t->peers[i], player, back, now));
        }
    }
    t->is_dead[player] = false;
    t->phase[player] = 0;
    t->back_at[player] = back;
}

/* ---- tests ---- */

static int64_t steps_wanted(void) {
    const char *text = getenv("THUD_NETWORK_STEPS");
    return text ? strtoll(text, NULL, 10) : STEPS;
}

/* Plays with so many players until all have made the steps. */
static void play_at_random(int players) {
    table *t = malloc(sizeof *t);
    assert_non_null(t);
    int64_t wanted = steps_wanted(), steps = 0;
    begin(t, players, (uint64_t)players, 30.0 * players);
    int victim = 0;
    while (steps < wanted) {
        play_frame(t);
        int64_t at = t->frame % KILL_EVERY;
        if (at == KILL_EVERY / 2 && steps < wanted - CALM) {
            victim = (int)(random_next(&t->random) % (unsigned)players);
            kill_player(t, victim);
        } else if (at == KILL_EVERY / 2 + GONE_AFTER && t->is_dead[victim]) {
            part_with(t, victim);
        } else if (at == KILL_EVERY / 2 + BACK_AFTER && t->is_dead[victim]) {
            join_again(t, victim);
        }
        steps = confirmed_by_all(t);
    }
    int64_t least = INT64_MAX, most = 0, told = 0;
    for (int i = 0; i < players; i++) {
        const peer *p = &t->peers[i];
        int64_t own = thud_progress_of(p->rollback).steps;
        least = own < least ? own : least;
        most = own > most ? own : most;
        count_up(t, p);
        for (int other = 0; other < players; other++) {
            assert_true(p->links[other].differs_from == -1);
            told += p->links[other].hash_step > 0;
        }
    }
    wire_counts counts = wire_counts_of(t->wire);
    print_message(
        "%d players, %lld steps of each: %lld run again, %lld waits, %lld hashes compared, "
        "%lld killed, %lld of %lld messages lost, %lld overtaken, %lld wrong ones refused; at the end "
        "%lld steps apart\n",
        players, (long long)steps, (long long)t->replayed, (long long)t->waits,
        (long long)t->hashes, (long long)t->kills, (long long)counts.lost, (long long)counts.sent,
        (long long)counts.overtaken, (long long)t->injected, (long long)(most - least));
    assert_true(t->kills > 0 && t->injected > 0 && t->replayed > 0);
    assert_true(t->hashes > steps / PEER_HASH_STEPS * players * 2 / 3);
    assert_int_equal(told, players * (players - 1));
    /* Clocks of 1 % more and less would be out of step by a tenth of the time without `ahead`. */
    assert_true(most - least <= 4);
    end(t);
    free(t);
}

static void no_player_has_another_game(void **state) {
    (void)state;
    for (int players = TEST_SHARE > 1 ? CARS_MAX / 2 : 2; players <= CARS_MAX;
         players += TEST_SHARE) {
        play_at_random(players);
    }
}

/* Plays until this player has noticed a difference from another. */
static void play_until_noticed(table *t, int player, int other) {
    while (t->peers[player].links[other].differs_from < 0) {
        play_frame(t);
        assert_true(t->frame < 4 * CHEATED_AT);
    }
}

/* How a player differs from another, by the reports that they send each other. */
static thud_rollback_difference difference_of(table *t, int player, int other) {
    unsigned char bytes[8192];
    size_t count;
    thud_rollback *own = t->peers[player].rollback, *its = t->peers[other].rollback;
    thud_rollback_difference found;
    OK(thud_rollback_report(its, -1, bytes, sizeof bytes, &count));
    OK(thud_rollback_compare(own, bytes, count, &found));
    assert_true(found.step > 0 && !found.is_detailed);
    OK(thud_rollback_report(its, found.step, bytes, sizeof bytes, &count));
    OK(thud_rollback_compare(own, bytes, count, &found));
    assert_true(found.is_detailed);
    return found;
}

/* The cheat's step: before CHEATED_AT it pushes its car. */
static thud_result step_with_push(thud_world *world, const uint64_t *inputs, void *state) {
    const cars *game = state;
    if (thud_stats_of(world).steps == CHEATED_AT) {
        thud_body_apply_torque(world, game->bodies[CHEAT], 50);
    }
    return cars_step(world, inputs, state);
}

/* The cheat's hash differs from those of all others, which agree; so nothing here is compared with
 * the truth. */
static void who_changes_the_world_is_named(void **state) {
    (void)state;
    table *t = malloc(sizeof *t);
    assert_non_null(t);
    begin(t, 4, 5, 60);
    peer_close(&t->peers[CHEAT]);
    peer_options pushing = {

        .me = CHEAT,
        .players = 4,
        .depth = DEPTH,
        .is_mesh = true,
        .def = &t->def,
        .step = step_with_push};
    assert_true(peer_open(&t->peers[CHEAT], &pushing));
    t->compared[CHEAT] = INT64_MAX;
    for (int i = 0; i < t->players; i++) {
        if (i != CHEAT) {
            play_until_noticed(t, i, CHEAT);
        }
    }
    for (int i = 0; i < t->players; i++) {
        for (int other = 0; other < t->players && i != CHEAT; other++) {
            int64_t from = t->peers[i].links[other].differs_from;
            assert_true((from > CHEATED_AT) == (other == CHEAT));
            assert_true(other == CHEAT || from == -1);
        }
    }
    thud_rollback_difference found = difference_of(t, HONEST, CHEAT);
    assert_true(found.step == CHEATED_AT + 1 && found.player == -1);
    assert_true(found.body.index1 == t->peers[HONEST].game.bodies[CHEAT].index1);
    end(t);
    free(t);
}

/* A player who tells one other player another input makes that one's game differ; their reports
 * name who told the input. */
static void who_tells_other_inputs_is_named(void **state) {
    (void)state;
    table *t = malloc(sizeof *t);
    assert_non_null(t);
    begin(t, 4, 6, 60);
    t->liar = CHEAT;
    t->compared[HONEST] = INT64_MAX;
    play_until_noticed(t, HONEST, 1);
    play_until_noticed(t, 1, HONEST);
    thud_rollback_difference found = difference_of(t, HONEST, 1);
    assert_true(found.step == CHEATED_AT + 1 && found.player == CHEAT);
    end(t);
    free(t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_player_has_another_game),
        cmocka_unit_test(who_changes_the_world_is_named),
        cmocka_unit_test(who_tells_other_inputs_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
