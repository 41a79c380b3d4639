/* rollback_join.c: a game that another peer plays, as bytes, for those who join it.
 * rollback-bytes.ts of the package writes and reads the same bytes.
 *
 * All numbers have their low bytes first:
 *     uint32  MARK
 *     uint32  number of players
 *     int64   the step; world and state are before this one
 *     uint64  bytes of the world's snapshot
 *     uint64  bytes of the caller's state
 *             by player: uint64, its input in the step before; int64, the step from which it is
 *             absent; int64, the step at which it is back; TD_NO_STEP: never
 *             the world's snapshot
 *             the caller's state
 *     uint32  checksum of all before it: FNV-1a (Fowler, Noll, Vo), of 32 bits
 *
 * The snapshot has a checksum of its own, of 64 bits. */
#include "sessions/rollback.h"

#include "thud/thud_snapshot.h"

#include <string.h>

static const uint32_t MARK = 0x324a6474; /* "tdJ2" */

enum { HEAD_BYTES = 32, PLAYER_BYTES = 24, SUM_BYTES = 4 };

static uint32_t checksum(const uint8_t *bytes, size_t count) {
    uint32_t sum = 2166136261u;
    for (size_t i = 0; i < count; i++) {
        sum = (sum ^ bytes[i]) * 16777619u;
    }
    return sum;
}

/* Bytes before the world's snapshot. */
static size_t head_bytes(const thud_rollback *r) {
    return HEAD_BYTES + PLAYER_BYTES * (size_t)r->options.players;
}

/* Bytes of a game whose world has a snapshot of `world_bytes` bytes. */
static size_t bytes_of(const thud_rollback *r, size_t world_bytes) {
    return head_bytes(r) + world_bytes + r->options.state_bytes + SUM_BYTES;
}

/* Writes what stands before the world's snapshot. */
static uint8_t *write_head(const thud_rollback *r, int64_t step, size_t world_bytes, uint8_t *at) {
    at = td_put_number(at, MARK, 4);
    at = td_put_number(at, (uint64_t)r->options.players, 4);
    at = td_put_number(at, (uint64_t)step, 8);
    at = td_put_number(at, world_bytes, 8);
    at = td_put_number(at, r->options.state_bytes, 8);
    for (int i = 0; i < r->options.players; i++) {
        const td_player_inputs *k = &r->players[i];
        at = td_put_number(at, td_rollback_saved(r, step - 1)->inputs[i], 8);
        at = td_put_number(at, (uint64_t)k->gone_from, 8);
        at = td_put_number(at, (uint64_t)k->back_at, 8);
    }
    return at;
}

thud_result thud_rollback_snapshot(thud_rollback *r, void *buffer, size_t capacity,
                                   size_t *out_bytes) {
    thud_result result = td_rollback_settle_for(r, buffer, capacity, out_bytes);
    if (result != THUD_OK) {
        return result;
    }
    int64_t step = thud_progress_of(r).confirmed;
    const td_saved_step *m = step < r->steps ? td_rollback_saved(r, step) : NULL;
    size_t world_bytes;
    result = thud_world_get_snapshot_size(r->world, &world_bytes);
    if (result != THUD_OK) {
        return result;
    }
    world_bytes = m ? m->bytes : world_bytes;
    size_t bytes = bytes_of(r, world_bytes);
    if (buffer && capacity < bytes) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: the buffer is too small");
    }
    *out_bytes = bytes;
    if (!buffer) {
        return THUD_OK;
    }
    size_t state_bytes = r->options.state_bytes;
    uint8_t *out = buffer, *world = write_head(r, step, world_bytes, out);
    if (m) {
        memcpy(world, m->image, world_bytes + state_bytes);
    } else {
        thud_world_snapshot(r->world, world, world_bytes, NULL);
        if (r->options.state) {
            memcpy(world + world_bytes, r->options.state, state_bytes);
        }
    }
    td_put_number(out + bytes - SUM_BYTES, checksum(out, bytes - SUM_BYTES), SUM_BYTES);
    return THUD_OK;
}

/* Whether a number that was read is a possible step, or TD_NO_STEP. */
static bool is_step(uint64_t value) {
    return value < TD_NO_STEP / 2 || value == TD_NO_STEP;
}

/* Why the bytes are no game that can be joined; null: they are one. */
static const char *fault_of(const thud_rollback *r, const uint8_t *from, size_t bytes) {
    if (bytes < HEAD_BYTES + SUM_BYTES || td_number_at(from, 4) != MARK) {
        return "rollback: these are no bytes of thud_rollback_snapshot";
    }
    if (td_number_at(from + bytes - SUM_BYTES, SUM_BYTES) != checksum(from, bytes - SUM_BYTES)) {
        return "rollback: the bytes are damaged";
    }
    if (td_number_at(from + 4, 4) != (uint64_t)r->options.players ||
        td_number_at(from + 24, 8) != r->options.state_bytes) {
        return "rollback: the bytes are of a game with other players, or another state";
    }
    uint64_t world_bytes = td_number_at(from + 16, 8);
    if (td_number_at(from + 8, 8) >= TD_NO_STEP / 2 || world_bytes > bytes ||
        bytes_of(r, (size_t)world_bytes) != bytes) {
        return "rollback: the bytes are not as long as they say";
    }
    for (int i = 0; i < r->options.players; i++) {
        const uint8_t *player = from + HEAD_BYTES + PLAYER_BYTES * i;
        if (!is_step(td_number_at(player + 8, 8)) || !is_step(td_number_at(player + 16, 8))) {
            return "rollback: the bytes do not say who is absent";
        }
    }
    return NULL;
}

thud_result thud_rollback_restore(thud_rollback *r, const void *buffer, size_t bytes) {
    thud_result result = td_rollback_check(r);
    if (result != THUD_OK) {
        return result;
    }
    if (!buffer) {
        return td_refuse(r->world, THUD_ERROR_NULL, "rollback: buffer is null");
    }
    const uint8_t *from = buffer;
    const char *fault = fault_of(r, from, bytes);
    if (fault) {
        return td_refuse(r->world, THUD_ERROR_INVALID, fault);
    }
    const uint8_t *world = from + head_bytes(r);
    size_t world_bytes = (size_t)td_number_at(from + 16, 8);
    result = thud_world_restore(r->world, world, world_bytes);
    if (result != THUD_OK) {
        return result;
    }
    if (r->options.state) {
        memcpy(r->options.state, world + world_bytes, r->options.state_bytes);
    }
    uint64_t inputs[THUD_ROLLBACK_PLAYERS_MAX];
    for (int i = 0; i < r->options.players; i++) {
        const uint8_t *player = from + HEAD_BYTES + PLAYER_BYTES * i;
        inputs[i] = td_number_at(player, 8);
        r->players[i].gone_from = (int64_t)td_number_at(player + 8, 8);
        r->players[i].back_at = (int64_t)td_number_at(player + 16, 8);
    }
    td_rollback_begin(r, (int64_t)td_number_at(from + 8, 8), inputs);
    return THUD_OK;
}
