/* peer.c: see peer.h.
 *
 * A message, all numbers with their low bytes first:
 *     0  4  MARK
 *     4  1  the sender
 *     5  1  number of inputs, n
 *     6  4  the step of the first of them
 *    10  4  how many inputs of the receiver the sender has
 *    14  4  the sender's lead, of 32 bits with a sign
 *    18  4  a step of which the sender has the hash, plus 1; 0: none
 *    22  8  the hash
 *    30  n  inputs
 *  30+n  4  checksum of all before it (FNV-1a) */
#include "peer.h"

#include <stdlib.h>
#include <string.h>

static const uint32_t MARK = 0x32504e54; /* "TNP2" */

enum { HEAD = 30, SUM = 4, INPUTS_MAX = 255 };

static thud_result play(thud_world *world, const uint64_t *inputs, void *state) {
    peer *p = state; /* the game is its first member */
    if (p->pushes_at >= 0 && (int64_t)thud_stats_of(world).steps == p->pushes_at) {
        thud_body_apply_torque(world, p->game.bodies[p->me], 50);
    }
    return cars_step(world, inputs, &p->game);
}

bool peer_open(peer *p, int me, int players, int depth, uint64_t seed, const thud_world_def *def) {
    *p = (peer){.me = me, .players = players, .seed = seed, .pushes_at = -1, .lies_at = -1};
    for (int i = 0; i < CARS_MAX; i++) {
        p->others[i].told.step = p->others[i].differs_from = -1;
    }
    thud_rollback_options options = {.players = players,
                                     .depth = depth,
                                     .idle = CARS_IDLE,
                                     .step = play,
                                     .state = p,
                                     .state_bytes = sizeof p->game};
    return thud_world_create(def, &p->world) == THUD_OK &&
           cars_build(p->world, players, &p->game) &&
           thud_rollback_create(p->world, &options, &p->rollback) == THUD_OK;
}

void peer_close(peer *p) {
    thud_rollback_destroy(p->rollback);
    thud_world_destroy(p->world);
    *p = (peer){.me = p->me};
}

thud_result peer_press(peer *p) {
    int64_t step = thud_progress_of(p->rollback).steps;
    if (p->told > step) {
        return THUD_OK;
    }
    uint64_t input = cars_input(p->seed, p->me, step);
    thud_result result = thud_rollback_input(p->rollback, p->me, step, input);
    if (result == THUD_OK) {
        p->inputs[step % PEER_INPUTS] = (unsigned char)input;
        p->told = step + 1;
    }
    return result;
}

/* ---- messages ---- */

static void put_number(unsigned char *at, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) {
        at[i] = (unsigned char)(value >> (8 * i));
    }
}

static uint64_t number_at(const unsigned char *at, int bytes) {
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++) {
        value |= (uint64_t)at[i] << (8 * i);
    }
    return value;
}

static uint32_t checksum(const unsigned char *bytes, int count) {
    uint32_t sum = 2166136261u;
    for (int i = 0; i < count; i++) {
        sum = (sum ^ bytes[i]) * 16777619u;
    }
    return sum;
}

/* The newest own hash. */
static peer_hash newest_hash(const peer *p) {
    int64_t step = p->hashed - PEER_HASH_STEPS;
    const peer_hash *h = &p->hashes[(step < 0 ? 0 : step) / PEER_HASH_STEPS % PEER_HASHES];
    return step >= 0 && h->step == step ? *h : (peer_hash){.step = -1};
}

/* The message to a player; returns its length. */
static int write_message(const peer *p, int other, unsigned char *out) {
    int64_t first = p->others[other].confirmed, wanted = p->told - first, lead = 0;
    int count = (int)(wanted < INPUTS_MAX ? wanted : INPUTS_MAX);
    peer_hash hash = newest_hash(p);
    thud_rollback_get_lead(p->rollback, other, &lead);
    put_number(out, MARK, 4);
    out[4] = (unsigned char)p->me;
    out[5] = (unsigned char)count;
    put_number(out + 6, (uint64_t)first, 4);
    put_number(out + 10, (uint64_t)p->others[other].heard, 4);
    put_number(out + 14, (uint64_t)lead, 4);
    put_number(out + 18, (uint64_t)(hash.step + 1), 4);
    put_number(out + 22, hash.hash, 8);
    for (int i = 0; i < count; i++) {
        bool lies = first + i == p->lies_at && other == p->lies_to;
        unsigned char input = p->inputs[(first + i) % PEER_INPUTS];
        out[HEAD + i] = lies ? (unsigned char)((input + 1) % CARS_INPUTS) : input;
    }
    put_number(out + HEAD + count, checksum(out, HEAD + count), SUM);
    return HEAD + count + SUM;
}

bool peer_send(peer *p, wire *w, double now) {
    for (int other = 0; other < p->players; other++) {
        if (other == p->me || p->others[other].is_gone) {
            continue;
        }
        unsigned char message[HEAD + INPUTS_MAX + SUM];
        int bytes = write_message(p, other, message);
        if (!wire_send(w, p->me, other, now, message, bytes)) {
            return false;
        }
        p->bytes += bytes;
        p->messages++;
    }
    return true;
}

static int64_t lead_in(const unsigned char *bytes) {
    return (int32_t)(uint32_t)number_at(bytes + 14, 4);
}

/* Whether the bytes are a message of another player. */
static bool is_message(const peer *p, const unsigned char *bytes, int count) {
    if (count < HEAD + SUM || number_at(bytes, 4) != MARK || count != HEAD + bytes[5] + SUM ||
        number_at(bytes + count - SUM, SUM) != checksum(bytes, count - SUM)) {
        return false;
    }
    for (int i = 0; i < bytes[5]; i++) {
        if (bytes[HEAD + i] >= CARS_INPUTS) {
            return false;
        }
    }
    int from = bytes[4];
    int64_t first = (int64_t)number_at(bytes + 6, 4), mine = (int64_t)number_at(bytes + 10, 4);
    return from < p->players && from != p->me && !p->others[from].is_gone && mine <= p->told &&
           first <= p->others[from].heard && labs(lead_in(bytes)) <= THUD_ROLLBACK_DEPTH_MAX &&
           first + bytes[5] <= thud_progress_of(p->rollback).steps + THUD_ROLLBACK_DEPTH_MAX;
}

thud_result peer_read(peer *p, const unsigned char *bytes, int count) {
    if (!is_message(p, bytes, count)) {
        p->refused++;
        return THUD_OK;
    }
    int from = bytes[4];
    peer_other *other = &p->others[from];
    int64_t first = (int64_t)number_at(bytes + 6, 4), mine = (int64_t)number_at(bytes + 10, 4);
    other->confirmed = mine > other->confirmed ? mine : other->confirmed;
    for (int64_t step = other->heard; step < first + bytes[5]; step++) {
        thud_result result =
            thud_rollback_input(p->rollback, from, step, bytes[HEAD + (step - first)]);
        if (result != THUD_OK) {
            return result;
        }
        other->heard = step + 1;
    }
    int64_t step = (int64_t)number_at(bytes + 18, 4) - 1;
    if (step > other->told.step) {
        other->told = (peer_hash){step, number_at(bytes + 22, 8)};
    }
    return thud_rollback_set_lead(p->rollback, from, lead_in(bytes));
}

thud_result peer_receive(peer *p, wire *w, double now) {
    unsigned char bytes[WIRE_BYTES_MAX];
    int count;
    while ((count = wire_receive(w, p->me, now, bytes, NULL)) >= 0) {
        thud_result result = peer_read(p, bytes, count);
        if (result != THUD_OK) {
            return result;
        }
    }
    return THUD_OK;
}

/* ---- playing ---- */

/* Compares what another player told, where the step is confirmed and not forgotten. */
static void compare_hash(const peer *p, peer_other *other) {
    int64_t step = other->told.step;
    const peer_hash *own = &p->hashes[(step < 0 ? 0 : step) / PEER_HASH_STEPS % PEER_HASHES];
    if (step >= 0 && own->step == step && own->hash != other->told.hash &&
        other->differs_from < 0) {
        other->differs_from = step;
    }
}

thud_result peer_advance(peer *p) {
    bool made;
    thud_result result = thud_rollback_advance(p->rollback, &made);
    int64_t sure = thud_progress_of(p->rollback).confirmed;
    p->waits += result == THUD_OK && !made;
    for (; p->hashed <= sure && result == THUD_OK; p->hashed += PEER_HASH_STEPS) {
        peer_hash *h = &p->hashes[p->hashed / PEER_HASH_STEPS % PEER_HASHES];
        h->step = p->hashed;
        result = thud_rollback_get_state(p->rollback, p->hashed, &h->hash, NULL);
    }
    for (int i = 0; i < p->players; i++) {
        compare_hash(p, &p->others[i]);
    }
    return result;
}

/* ---- players who come and go ---- */

thud_result peer_part(peer *p, int player, int64_t step) {
    peer_other *other = &p->others[player];
    for (; other->heard < step; other->heard++) {
        uint64_t input = cars_input(p->seed, player, other->heard);
        thud_result result = thud_rollback_input(p->rollback, player, other->heard, input);
        if (result != THUD_OK) {
            return result;
        }
    }
    other->is_gone = true;
    return thud_rollback_leave(p->rollback, player, step);
}

thud_result peer_meet(peer *p, int player, int64_t step, int64_t has) {
    thud_result result = thud_rollback_enter(p->rollback, player, step);
    if (result == THUD_OK) {
        p->others[player] =
            (peer_other){.heard = step, .confirmed = has, .told.step = -1, .differs_from = -1};
    }
    return result;
}

thud_result peer_join(peer *p, peer *host, int64_t step) {
    size_t bytes;
    thud_result result = thud_rollback_snapshot(host->rollback, NULL, 0, &bytes);
    void *game = result == THUD_OK ? malloc(bytes) : NULL;
    if (!game) {
        return result != THUD_OK ? result : THUD_ERROR_MEMORY;
    }
    result = thud_rollback_snapshot(host->rollback, game, bytes, &bytes);
    result = result == THUD_OK ? thud_rollback_restore(p->rollback, game, bytes) : result;
    free(game);
    result = result == THUD_OK ? thud_rollback_enter(p->rollback, p->me, step) : result;
    if (result == THUD_OK) {
        int64_t now = thud_progress_of(p->rollback).steps;
        p->told = step;
        p->hashed = (now + PEER_HASH_STEPS - 1) / PEER_HASH_STEPS * PEER_HASH_STEPS;
        for (int i = 0; i < p->players; i++) {
            p->others[i].heard = now;
            p->others[i].confirmed = step;
        }
    }
    return result;
}
