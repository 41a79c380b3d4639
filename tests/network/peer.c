/* peer.c: see peer.h.
 *
 * A message, all numbers with their low bytes first:
 *     0  4  MARK
 *     4  1  the sender
 *     5  1  number of inputs, n
 *     6  4  the step of the first of them
 *    10  4  how many inputs of the receiver the sender has
 *    14  n  inputs
 *  14+n  4  checksum of all before it (FNV-1a) */
#include "peer.h"

#include <string.h>

static const uint32_t MARK = 0x31504e54; /* "TNP1" */

enum { HEAD = 14, SUM = 4, INPUTS_MAX = 255 };

bool peer_open(peer *p, int me, int players, int depth, uint64_t seed, const thud_world_def *def) {
    *p = (peer){.me = me, .players = players, .seed = seed};
    thud_rollback_options options = {.players = players,
                                     .depth = depth,
                                     .idle = CARS_IDLE,
                                     .step = cars_step,
                                     .state = &p->game,
                                     .state_bytes = sizeof p->game};
    return thud_world_create(def, &p->world) == THUD_OK &&
           cars_build(p->world, players, &p->game) &&
           thud_rollback_create(p->world, &options, &p->rollback) == THUD_OK;
}

void peer_close(peer *p) {
    thud_rollback_destroy(p->rollback);
    thud_world_destroy(p->world);
    *p = (peer){0};
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

static void put_number(unsigned char *at, uint32_t value) {
    for (int i = 0; i < 4; i++) {
        at[i] = (unsigned char)(value >> (8 * i));
    }
}

static uint32_t number_at(const unsigned char *at) {
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static uint32_t checksum(const unsigned char *bytes, int count) {
    uint32_t sum = 2166136261u;
    for (int i = 0; i < count; i++) {
        sum = (sum ^ bytes[i]) * 16777619u;
    }
    return sum;
}

bool peer_send(peer *p, wire *w, double now) {
    for (int other = 0; other < p->players; other++) {
        if (other == p->me) {
            continue;
        }
        unsigned char message[HEAD + INPUTS_MAX + SUM];
        int64_t first = p->confirmed[other], wanted = p->told - first;
        int count = (int)(wanted < INPUTS_MAX ? wanted : INPUTS_MAX);
        put_number(message, MARK);
        message[4] = (unsigned char)p->me;
        message[5] = (unsigned char)count;
        put_number(message + 6, (uint32_t)first);
        put_number(message + 10, (uint32_t)p->heard[other]);
        for (int i = 0; i < count; i++) {
            message[HEAD + i] = p->inputs[(first + i) % PEER_INPUTS];
        }
        put_number(message + HEAD + count, checksum(message, HEAD + count));
        int bytes = HEAD + count + SUM;
        if (!wire_send(w, p->me, other, now, message, bytes)) {
            return false;
        }
        p->bytes += bytes;
        p->messages++;
    }
    return true;
}

/* Whether the bytes are a message of another player. */
static bool is_message(const peer *p, const unsigned char *bytes, int count) {
    if (count < HEAD + SUM || number_at(bytes) != MARK || count != HEAD + bytes[5] + SUM ||
        number_at(bytes + count - SUM) != checksum(bytes, count - SUM)) {
        return false;
    }
    for (int i = 0; i < bytes[5]; i++) {
        if (bytes[HEAD + i] >= CARS_INPUTS) {
            return false;
        }
    }
    int64_t first = number_at(bytes + 6), mine = number_at(bytes + 10);
    return bytes[4] < p->players && bytes[4] != p->me && mine <= p->told &&
           first <= p->heard[bytes[4]];
}

thud_result peer_read(peer *p, const unsigned char *bytes, int count) {
    if (!is_message(p, bytes, count)) {
        p->refused++;
        return THUD_OK;
    }
    int from = bytes[4];
    int64_t first = number_at(bytes + 6), mine = number_at(bytes + 10);
    p->confirmed[from] = mine > p->confirmed[from] ? mine : p->confirmed[from];
    for (int64_t step = p->heard[from]; step < first + bytes[5]; step++) {
        thud_result result =
            thud_rollback_input(p->rollback, from, step, bytes[HEAD + (step - first)]);
        if (result != THUD_OK) {
            return result;
        }
        p->heard[from] = step + 1;
    }
    return THUD_OK;
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
