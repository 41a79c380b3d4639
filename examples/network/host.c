/* host.c: see host.h.
 *
 * A welcome, all numbers with their low bytes first:
 *     0  4  WELCOME
 *     4  1  the player's number
 *     5  1  number of players
 *     6  2  steps a second
 *     8  4  steps of the game
 *    12  4  depth of the rollback
 *    16  4  checksum, see peer_seal
 * That a player has left:
 *     0  4  LEAVE
 *     4  1  the player's number
 *     5  1  number of inputs, n
 *     6  4  the step before which it has left
 *    10  n  its inputs of the steps before that one
 *  10+n  4  checksum */
#include "host.h"

static const uint32_t WELCOME = 0x31574e54; /* "TNW1" */
static const uint32_t LEAVE = 0x314c4e54;   /* "TNL1" */

enum { WELCOME_BYTES = 20, LEAVE_HEAD = 10, LEAVE_INPUTS_MAX = 255 };

int host_write_welcome(const host_welcome *w, unsigned char *out) {
    peer_put_number(out, WELCOME, 4);
    out[4] = (unsigned char)w->player;
    out[5] = (unsigned char)w->players;
    peer_put_number(out + 6, (uint64_t)w->rate, 2);
    peer_put_number(out + 8, (uint64_t)w->steps, 4);
    peer_put_number(out + 12, (uint64_t)w->depth, 4);
    return peer_seal(out, WELCOME_BYTES - 4);
}

bool host_read_welcome(const unsigned char *bytes, int count, host_welcome *out) {
    if (count != WELCOME_BYTES || peer_number_at(bytes, 4) != WELCOME ||
        !peer_is_sealed(bytes, count)) {
        return false;
    }
    *out = (host_welcome){.player = bytes[4],
                          .players = bytes[5],
                          .rate = (int)peer_number_at(bytes + 6, 2),
                          .steps = (int64_t)peer_number_at(bytes + 8, 4),
                          .depth = (int)peer_number_at(bytes + 12, 4)};
    return out->players >= 2 && out->players <= CARS_MAX && out->player < out->players &&
           out->rate > 0 && out->steps > 0 && out->depth > 0 &&
           out->depth <= THUD_ROLLBACK_DEPTH_MAX;
}

int host_write_leave(const peer *p, int player, unsigned char *out) {
    const peer_other *other = &p->others[player];
    int64_t step = other->heard;
    int count = step < LEAVE_INPUTS_MAX ? (int)step : LEAVE_INPUTS_MAX;
    peer_put_number(out, LEAVE, 4);
    out[4] = (unsigned char)player;
    out[5] = (unsigned char)count;
    peer_put_number(out + 6, (uint64_t)step, 4);
    for (int i = 0; i < count; i++) {
        out[LEAVE_HEAD + i] = other->inputs[(step - count + i) % PEER_INPUTS];
    }
    return peer_seal(out, LEAVE_HEAD + count);
}
