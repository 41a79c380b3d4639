/* rollback_join.c: a game that another peer plays, as bytes, for those who join it. */
#include "sessions/rollback.h"

#include "api/snapshot.h"
#include "thud/thud_snapshot.h"

#include <string.h>

static const char MAGIC[8] = {'t', 'h', 'u', 'd', 'j', 'o', 'i', '1'};

/* The head of the bytes. A td_joined_player of each player follows, then the world's snapshot, and
 * the caller's state. */
typedef struct join_head {
    char magic[8];
    uint64_t checksum; /* td_snapshot_checksum of all bytes after this field */
    int64_t step;      /* the world and state are before this one */
    uint64_t players, world_bytes, state_bytes;
} join_head;

enum { SUMMED_FROM = offsetof(join_head, checksum) + sizeof(uint64_t) };

typedef struct joined_player {
    uint64_t input; /* in the step before */
    int64_t gone_from, back_at;
} joined_player;

/* Bytes of a game whose world has a snapshot of so many. */
static size_t bytes_of(const thud_rollback *r, size_t world_bytes) {
    return sizeof(join_head) + (size_t)r->options.players * sizeof(joined_player) + world_bytes +
           r->options.state_bytes;
}

/* The players before a step. */
static void write_players(const thud_rollback *r, int64_t step, char *to) {
    for (int i = 0; i < r->options.players; i++) {
        const td_player_inputs *k = &r->players[i];
        joined_player p = {td_rollback_saved(r, step - 1)->inputs[i], k->gone_from, k->back_at};
        memcpy(to + (size_t)i * sizeof p, &p, sizeof p);
    }
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
    char *out = buffer, *world = out + bytes - state_bytes - world_bytes;
    write_players(r, step, out + sizeof(join_head));
    if (m) {
        memcpy(world, m->image, world_bytes + state_bytes);
    } else {
        thud_world_snapshot(r->world, world, world_bytes, NULL);
        if (r->options.state) {
            memcpy(world + world_bytes, r->options.state, state_bytes);
        }
    }
    join_head head = {.step = step,
                      .players = (uint64_t)r->options.players,
                      .world_bytes = world_bytes,
                      .state_bytes = state_bytes};
    memcpy(head.magic, MAGIC, sizeof MAGIC);
    memcpy(out, &head, sizeof head);
    head.checksum = td_snapshot_checksum(out + SUMMED_FROM, bytes - SUMMED_FROM);
    memcpy(out, &head, sizeof head);
    return THUD_OK;
}

/* Why the bytes are no game that can be joined; null: they are one. */
static const char *fault_of(const thud_rollback *r, const char *from, size_t bytes,
                            join_head *head) {
    if (bytes < sizeof *head || memcmp(from, MAGIC, sizeof MAGIC) != 0) {
        return "rollback: these are no bytes of thud_rollback_snapshot";
    }
    memcpy(head, from, sizeof *head);
    if (head->checksum != td_snapshot_checksum(from + SUMMED_FROM, bytes - SUMMED_FROM)) {
        return "rollback: the bytes are damaged";
    }
    if (head->players != (uint64_t)r->options.players ||
        head->state_bytes != r->options.state_bytes) {
        return "rollback: the bytes are of a game with other players, or another state";
    }
    if (head->step < 0 || head->step >= TD_NO_STEP / 2 || head->world_bytes > bytes ||
        bytes_of(r, (size_t)head->world_bytes) != bytes) {
        return "rollback: the bytes are not as long as they say";
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
    const char *from = buffer;
    join_head head;
    const char *fault = fault_of(r, from, bytes, &head);
    if (fault) {
        return td_refuse(r->world, THUD_ERROR_INVALID, fault);
    }
    const char *players = from + sizeof head;
    const char *world = players + (size_t)r->options.players * sizeof(joined_player);
    result = thud_world_restore(r->world, world, (size_t)head.world_bytes);
    if (result != THUD_OK) {
        return result;
    }
    if (r->options.state) {
        memcpy(r->options.state, world + head.world_bytes, r->options.state_bytes);
    }
    uint64_t inputs[THUD_ROLLBACK_PLAYERS_MAX];
    for (int i = 0; i < r->options.players; i++) {
        joined_player p;
        memcpy(&p, players + (size_t)i * sizeof p, sizeof p);
        inputs[i] = p.input;
        r->players[i].gone_from = p.gone_from;
        r->players[i].back_at = p.back_at;
    }
    td_rollback_begin(r, head.step, inputs);
    return THUD_OK;
}
