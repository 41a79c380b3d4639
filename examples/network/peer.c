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

#include <thud/thud_snapshot.h>

#include <stdlib.h>
#include <string.h>

static const uint32_t MARK = 0x32504e54; /* "TNP2" */

enum { HEAD = PEER_INPUTS_AT, SUM = 4, INPUTS_MAX = PEER_BYTES_MAX - HEAD - SUM };

/* Plays before the game, so that the world has the memory that the game needs: from all bodies on
 * one heap in a corner, which makes more contacts than any game has, players drive at random for so
 * many steps; chosen. */
enum { WARM_STEPS = 600 };

static thud_result warm_up(peer *p) {
    thud_result result = THUD_OK;
    for (int i = 0; i < p->game.count && result == THUD_OK; i++) {
        thud_pos place = {11.5 - 0.4 * (i % 4), 7.5 - 0.4 * (i / 4)};
        result = thud_body_set_transform(p->world, p->game.bodies[i], place, 0.1 * i);
    }
    for (int step = 0; step < WARM_STEPS && result == THUD_OK; step++) {
        uint64_t inputs[CARS_MAX];
        for (int i = 0; i < p->players; i++) {
            inputs[i] = cars_input(1, i, step);
        }
        result = cars_step(p->world, inputs, &p->game);
    }
    return result;
}

/* Creates the rollback of a world whose game begins now. */
static bool open_rollback(peer *p, const thud_rollback_options *options) {
    size_t bytes;
    cars game = p->game;
    void *start = thud_world_get_snapshot_size(p->world, &bytes) == THUD_OK ? malloc(bytes) : NULL;
    bool is_open = start && thud_world_snapshot(p->world, start, bytes, NULL) == THUD_OK &&
                   warm_up(p) == THUD_OK &&
                   thud_rollback_create(p->world, options, &p->rollback) == THUD_OK &&
                   thud_world_restore(p->world, start, bytes) == THUD_OK;
    p->game = game;
    free(start);
    return is_open;
}

bool peer_open(peer *p, const peer_options *o) {
    *p = (peer){.me = o->me, .players = o->players, .depth = o->depth, .end = o->end};
    for (int i = 0; i < CARS_MAX; i++) {
        p->others[i].told.step = p->others[i].differs_from = -1;
    }
    thud_rollback_options options = {.players = o->players,
                                     .depth = o->depth,
                                     .idle = CARS_IDLE,
                                     .step = o->step ? o->step : cars_step,
                                     .state = &p->game,
                                     .state_bytes = sizeof p->game};
    return thud_world_create(o->def, &p->world) == THUD_OK &&
           cars_build(p->world, o->players, &p->game) && open_rollback(p, &options);
}

void peer_close(peer *p) {
    thud_rollback_destroy(p->rollback);
    thud_world_destroy(p->world);
    *p = (peer){.me = p->me};
}

thud_result peer_press(peer *p, uint64_t input) {
    int64_t step = thud_progress_of(p->rollback).steps;
    if (p->told > step || (p->end && step >= p->end)) {
        return THUD_OK;
    }
    thud_result result = thud_rollback_input(p->rollback, p->me, step, input);
    if (result == THUD_OK) {
        p->others[p->me].inputs[step % PEER_INPUTS] = (unsigned char)input;
        p->told = step + 1;
    }
    return result;
}

/* ---- bytes ---- */

void peer_put_number(unsigned char *at, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) {
        at[i] = (unsigned char)(value >> (8 * i));
    }
}

uint64_t peer_number_at(const unsigned char *at, int bytes) {
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

int peer_seal(unsigned char *bytes, int count) {
    peer_put_number(bytes + count, checksum(bytes, count), SUM);
    return count + SUM;
}

bool peer_is_sealed(const unsigned char *bytes, int count) {
    return count >= SUM && peer_number_at(bytes + count - SUM, SUM) == checksum(bytes, count - SUM);
}

/* ---- messages ---- */

/* The newest own hash. */
static peer_hash newest_hash(const peer *p) {
    int64_t step = p->hashed - PEER_HASH_STEPS;
    const peer_hash *h = &p->hashes[(step < 0 ? 0 : step) / PEER_HASH_STEPS % PEER_HASHES];
    return step >= 0 && h->step == step ? *h : (peer_hash){.step = -1};
}

bool peer_tells(const peer *p, int player) {
    return player != p->me && !p->others[player].is_gone;
}

int peer_write(peer *p, int player, unsigned char *out) {
    int64_t first = p->others[player].confirmed, wanted = p->told - first, lead = 0;
    int count = (int)(wanted < INPUTS_MAX ? wanted : INPUTS_MAX);
    peer_hash hash = newest_hash(p);
    thud_rollback_get_lead(p->rollback, player, &lead);
    peer_put_number(out, MARK, 4);
    out[PEER_SENDER_AT] = (unsigned char)p->me;
    out[5] = (unsigned char)count;
    peer_put_number(out + PEER_FIRST_AT, (uint64_t)first, 4);
    peer_put_number(out + 10, (uint64_t)p->others[player].heard, 4);
    peer_put_number(out + 14, (uint64_t)lead, 4);
    peer_put_number(out + 18, (uint64_t)(hash.step + 1), 4);
    peer_put_number(out + 22, hash.hash, 8);
    for (int i = 0; i < count; i++) {
        out[HEAD + i] = p->others[p->me].inputs[(first + i) % PEER_INPUTS];
    }
    int bytes = peer_seal(out, HEAD + count);
    p->bytes += bytes;
    p->messages++;
    return bytes;
}

static int64_t lead_in(const unsigned char *bytes) {
    return (int32_t)(uint32_t)peer_number_at(bytes + 14, 4);
}

/* Whether the bytes are a message of another player. */
static bool is_message(const peer *p, const unsigned char *bytes, int count) {
    if (count < HEAD + SUM || peer_number_at(bytes, 4) != MARK || count != HEAD + bytes[5] + SUM ||
        !peer_is_sealed(bytes, count)) {
        return false;
    }
    for (int i = 0; i < bytes[5]; i++) {
        if (bytes[HEAD + i] >= CARS_INPUTS) {
            return false;
        }
    }
    int from = bytes[PEER_SENDER_AT];
    int64_t first = (int64_t)peer_number_at(bytes + PEER_FIRST_AT, 4);
    int64_t mine = (int64_t)peer_number_at(bytes + 10, 4);
    return from < p->players && peer_tells(p, from) && mine <= p->told &&
           first <= p->others[from].heard && labs(lead_in(bytes)) <= THUD_ROLLBACK_DEPTH_MAX;
}

thud_result peer_hear(peer *p, int player, uint64_t input) {
    peer_other *other = &p->others[player];
    thud_result result = thud_rollback_input(p->rollback, player, other->heard, input);
    if (result == THUD_OK) {
        other->inputs[other->heard % PEER_INPUTS] = (unsigned char)input;
        other->heard++;
    }
    return result;
}

thud_result peer_read(peer *p, const unsigned char *bytes, int count) {
    if (!is_message(p, bytes, count)) {
        p->refused++;
        return THUD_OK;
    }
    int from = bytes[PEER_SENDER_AT];
    peer_other *other = &p->others[from];
    int64_t first = (int64_t)peer_number_at(bytes + PEER_FIRST_AT, 4);
    int64_t mine = (int64_t)peer_number_at(bytes + 10, 4);
    other->confirmed = mine > other->confirmed ? mine : other->confirmed;
    /* A player who waits may be sent inputs that it cannot store yet; they are sent again. */
    int64_t end = thud_progress_of(p->rollback).steps + p->depth;
    end = first + bytes[5] < end ? first + bytes[5] : end;
    while (other->heard < end) {
        thud_result result = peer_hear(p, from, bytes[HEAD + (other->heard - first)]);
        if (result != THUD_OK) {
            return result;
        }
    }
    int64_t step = (int64_t)peer_number_at(bytes + 18, 4) - 1;
    if (step > other->told.step) {
        other->told = (peer_hash){step, peer_number_at(bytes + 22, 8)};
    }
    return thud_rollback_set_lead(p->rollback, from, lead_in(bytes));
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
    bool made = true, is_over = p->end && thud_progress_of(p->rollback).steps >= p->end;
    thud_result result =
        is_over ? thud_rollback_settle(p->rollback) : thud_rollback_advance(p->rollback, &made);
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

bool peer_has_ended(const peer *p) {
    thud_rollback_progress now = thud_progress_of(p->rollback);
    return p->end && now.confirmed >= p->end && now.settled >= p->end;
}

bool peer_is_done(const peer *p) {
    bool is_done = peer_has_ended(p);
    for (int i = 0; i < p->players; i++) {
        is_done &= !peer_tells(p, i) || p->others[i].confirmed >= p->told;
    }
    return is_done;
}

thud_result peer_hash_of(peer *p, uint64_t *out) {
    int64_t sure = thud_progress_of(p->rollback).confirmed;
    return thud_rollback_get_state(p->rollback, sure, out, NULL);
}

/* ---- players who come and go ---- */

thud_result peer_part(peer *p, int player, int64_t step) {
    p->others[player].is_gone = true;
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
