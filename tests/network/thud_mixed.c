/* thud_mixed.c: plays the game over the simulated network with players of another process: those
 * with odd numbers are played by whoever started this program, through its input and output. So a
 * native peer and one in WebAssembly can be compared without the chance of a real network.
 *
 *     thud-mixed PLAYERS STEPS SEED
 *
 * In each frame it writes how many datagrams have arrived for the others, 4 bytes, and of each one
 * its receiver, 1 byte, its length, 2 bytes, and its bytes; and reads whether the others have come
 * to the end, 1 byte, how many datagrams they send, 4 bytes, and of each one its sender and
 * receiver, a byte each, its length and its bytes. At the end it writes 0xffffffff in place of a
 * number, the hash of the last step, 8 bytes, the length of player 0's report of it, 4 bytes, the
 * report, the length of a text, 4 bytes, and the text, which says as JSON what has happened, and
 * the length of player 0's game for who joins, 4 bytes, and the game. Then it reads such a game of
 * one of the others, joins it, and writes the game that it has then. All numbers have their low
 * bytes first. */
#include "over_wire.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { DEPTH = 60, REPORT_MAX = 4096, TEXT_MAX = 512, GAME_MAX = 1 << 20 };

#define FRAME_MS (1000.0 / CARS_RATE)
/* The delay of the network grows with the players, ms each, as in test_play.c. */
#define DELAY_MS 30.0

typedef struct mixed {
    peer peers[CARS_MAX]; /* those with even numbers */
    int players;
    int64_t steps, frame;
    uint64_t seed;
    wire *wire;
    bool others_are_done;
} mixed;

static void write_number(uint64_t value, int bytes) {
    unsigned char out[8];
    message_put(out, value, bytes);
    fwrite(out, 1, (size_t)bytes, stdout);
}

/* False at the end of the input. */
static bool read_number(int bytes, uint64_t *out) {
    unsigned char in[8];
    bool is_read = fread(in, 1, (size_t)bytes, stdin) == (size_t)bytes;
    *out = is_read ? message_number(in, bytes) : 0;
    return is_read;
}

static bool open_peers(mixed *m) {
    thud_world_def def = cars_def(&thud_quality_default);
    wire_options options = worst_wire(DELAY_MS * m->players, m->seed);
    m->wire = wire_create(&options);
    bool is_open = m->wire;
    for (int i = 0; i < m->players && is_open; i += 2) {
        peer_options o = {.me = i,
                          .players = m->players,
                          .depth = DEPTH,
                          .is_mesh = true,
                          .end = m->steps,
                          .def = &def};
        is_open = peer_open(&m->peers[i], &o);
    }
    return is_open;
}

/* Writes what has arrived for the others. */
static void tell_others(mixed *m, double now) {
    static unsigned char bytes[1 << 16][3 + PEER_BYTES_MAX];
    int count = 0;
    for (int to = 1; to < m->players; to += 2) {
        int length;
        while (count < 1 << 16 &&
               (length = wire_receive(m->wire, to, now, bytes[count] + 3, NULL)) >= 0) {
            bytes[count][0] = (unsigned char)to;
            message_put(bytes[count++] + 1, (uint64_t)length, 2);
        }
    }
    write_number((uint64_t)count, 4);
    for (int i = 0; i < count; i++) {
        fwrite(bytes[i], 1, 3 + (size_t)message_number(bytes[i] + 1, 2), stdout);
    }
    fflush(stdout);
}

/* Reads what the others send. False where they have ended. */
static bool hear_others(mixed *m, double now) {
    uint64_t is_done, count;
    if (!read_number(1, &is_done) || !read_number(4, &count)) {
        return false;
    }
    m->others_are_done = is_done;
    for (; count > 0; count--) {
        unsigned char bytes[WIRE_BYTES_MAX];
        uint64_t from, to, length;
        if (!read_number(1, &from) || !read_number(1, &to) || !read_number(2, &length) ||
            length > sizeof bytes || fread(bytes, 1, (size_t)length, stdin) != length ||
            !wire_send(m->wire, (int)from, (int)to, now, bytes, (int)length)) {
            return false;
        }
    }
    return true;
}

static bool play_frame(mixed *m) {
    double now = (double)m->frame++ * FRAME_MS;
    for (int i = 0; i < m->players; i += 2) {
        peer *p = &m->peers[i];
        if (receive_over(p, m->wire, now) != THUD_OK || press_at_random(p, m->seed) != THUD_OK ||
            !send_over(p, m->wire, now) || peer_advance(p) != THUD_OK) {
            return false;
        }
    }
    tell_others(m, now);
    return hear_others(m, now);
}

static bool is_over(const mixed *m) {
    bool is_done = m->others_are_done;
    for (int i = 0; i < m->players; i += 2) {
        is_done &= peer_is_done(&m->peers[i]);
    }
    return is_done;
}

/* Writes how it ended. False where players have other games. */
static bool write_end(mixed *m) {
    unsigned char report[REPORT_MAX];
    char text[TEXT_MAX];
    size_t bytes;
    uint64_t hash, first = 0;
    int64_t replayed = 0, waits = 0, refused = 0, differ = 0;
    for (int i = 0; i < m->players; i += 2) {
        peer *p = &m->peers[i];
        replayed += thud_progress_of(p->rollback).replayed;
        waits += p->waits;
        refused += p->refused;
        bool is_known = peer_hash_of(p, &hash) == THUD_OK;
        first = i ? first : hash;
        differ += !is_known || hash != first;
        for (int other = 0; other < m->players; other++) {
            differ += p->links[other].differs_from >= 0;
        }
    }
    if (thud_rollback_report(m->peers[0].rollback, m->steps, report, sizeof report, &bytes) !=
        THUD_OK) {
        return false;
    }
    wire_counts w = wire_counts_of(m->wire);
    int length =
        snprintf(text, sizeof text,
                 "{\"replayed\": %" PRId64 ", \"waits\": %" PRId64 ", \"refused\": %" PRId64
                 ", \"differ\": %" PRId64 ", \"sent\": %" PRId64 ", \"lost\": %" PRId64
                 ", \"duplicated\": %" PRId64 ", \"overtaken\": %" PRId64 "}",
                 replayed, waits, refused, differ, w.sent, w.lost, w.duplicated, w.overtaken);
    write_number(UINT32_MAX, 4);
    write_number(first, 8);
    write_number(bytes, 4);
    fwrite(report, 1, bytes, stdout);
    write_number((uint64_t)length, 4);
    fwrite(text, 1, (size_t)length, stdout);
    return differ == 0 && fflush(stdout) == 0;
}

static bool write_game(peer *p) {
    static unsigned char game[GAME_MAX];
    size_t bytes;
    if (thud_rollback_snapshot(p->rollback, game, sizeof game, &bytes) != THUD_OK) {
        return false;
    }
    write_number(bytes, 4);
    fwrite(game, 1, bytes, stdout);
    return fflush(stdout) == 0;
}

/* Joins the game that the others have, and tells it back. */
static bool join_others(const mixed *m) {
    static unsigned char game[GAME_MAX];
    static peer joins;
    uint64_t bytes;
    thud_world_def def = cars_def(&thud_quality_default);
    peer_options o = {.players = m->players, .depth = DEPTH, .is_mesh = true, .def = &def};
    bool is_well = read_number(4, &bytes) && bytes <= sizeof game &&
                   fread(game, 1, (size_t)bytes, stdin) == bytes && peer_open(&joins, &o) &&
                   thud_rollback_restore(joins.rollback, game, (size_t)bytes) == THUD_OK &&
                   write_game(&joins);
    peer_close(&joins);
    return is_well;
}

int main(int argc, char **argv) {
    static mixed m;
    m.players = argc == 4 ? atoi(argv[1]) : 0;
    m.steps = argc == 4 ? atoll(argv[2]) : 0;
    m.seed = argc == 4 ? strtoull(argv[3], NULL, 10) : 0;
    if (m.players < 2 || m.players > CARS_MAX || m.steps < 1) {
        fprintf(stderr, "usage: thud-mixed PLAYERS STEPS SEED, 2 to %d players\n", CARS_MAX);
        return 2;
    }
    bool is_well = open_peers(&m);
    while (is_well && !is_over(&m)) {
        is_well = play_frame(&m);
    }
    is_well = is_well && write_end(&m) && write_game(&m.peers[0]) && join_others(&m);
    for (int i = 0; i < m.players; i += 2) {
        peer_close(&m.peers[i]);
    }
    wire_destroy(m.wire);
    return !is_well;
}
