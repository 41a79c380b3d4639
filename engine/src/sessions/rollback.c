/* rollback.c: rollback for networked play (thud_rollback.h): steps are played with predicted
 * inputs, and played again from a snapshot when an input turns out to be different.
 *
 * Two ring buffers are indexed by the step's number: `saved` has the snapshot before each of the
 * last depth + 1 steps, and the inputs that the step was played with; and each player has the
 * inputs known of the steps from depth + 1 before the next one to depth after it. An input that is
 * not known yet is predicted to be that of the step before. */
#include "thud/thud_rollback.h"

#include "state/handles.h"
#include "thud/thud.h"
#include "thud/thud_snapshot.h"

#include <string.h>

/* Values for options of 0, as the header promises; 60 steps are a second at 60 Hz. */
enum { PLAYERS_DEFAULT = 2, DEPTH_DEFAULT = 60 };

/* first_wrong: no step has to be played again. */
static const int64_t NO_STEP = INT64_MAX;

/* The world and state before a step, and what the step was played with. */
typedef struct saved_step {
    char *image;        /* the world's snapshot, followed by the caller's state */
    size_t room, bytes; /* size of the memory at image; of the snapshot in it */
    uint64_t hash;      /* thud_hash_of before the step */
    uint64_t *inputs;   /* by player */
} saved_step;

/* The known inputs of a player. */
typedef struct player_inputs {
    uint64_t *inputs;     /* ring of input_count */
    bool *is_known;       /* likewise: the input of the step has been given */
    int64_t known_before; /* every input before this step is known */
} player_inputs;

struct thud_rollback {
    thud_world *world;
    thud_rollback_options options;
    size_t bytes;           /* of the memory block of this struct and its rings */
    saved_step *saved;      /* ring of saved_count */
    player_inputs *players; /* by player */
    int64_t steps;          /* made so far: the number of the next one */
    int64_t replayed;       /* steps that were played again, in all */
    int64_t first_wrong;    /* the first step that has to be played again, or NO_STEP */
    bool playing;           /* inside options.step */
};

/* The length of the ring `saved`: one more than the depth, since the prediction for the earliest
 * step that may be wrong needs the inputs of the step before. */
static int saved_count(const thud_rollback *r) {
    return r->options.depth + 1;
}

/* The length of the rings of inputs: depth + 1 steps back, the next step, and depth steps ahead. */
static int input_count(const thud_rollback *r) {
    return 2 * r->options.depth + 2;
}

/* The place of a step in the ring. */
static saved_step *saved_step_of(const thud_rollback *r, int64_t step) {
    return &r->saved[step % saved_count(r)];
}

/* Refuses calls from inside a step or callback. */
static thud_result check(const thud_rollback *r) {
    if (!r) {
        return THUD_ERROR_NULL;
    }
    return r->playing || r->world->locked
               ? td_refuse(r->world, THUD_ERROR_LOCKED, "rollback: not inside a callback or a step")
               : THUD_OK;
}

/* ---- making ---- */

/* The reason why options are refused; null: they are valid. */
static const char *error_of(const thud_rollback_options *o, td_reason *why) {
    if (!o->step) {
        return "rollback: step is null";
    }
    if (!td_in(why, "rollback: players", o->players, 0.0, THUD_ROLLBACK_PLAYERS_MAX) ||
        !td_in(why, "rollback: depth", o->depth, 0.0, THUD_ROLLBACK_DEPTH_MAX)) {
        return why->text;
    }
    if (!o->state != !o->state_bytes) {
        return "rollback: a state without bytes, or bytes without a state";
    }
    return NULL;
}

/* The next piece of a block, *at bytes from its start, which it advances to a multiple of 16; null
 * for a null block, of which only the size is computed. */
static void *take_bytes(char *block, size_t *at, size_t bytes) {
    void *piece = block ? block + *at : NULL;
    *at += (bytes + 15) & ~(size_t)15;
    return piece;
}

/* Places the rings behind the struct in one block, and returns the size; null: only the size. */
static size_t lay_out(thud_rollback *r, const thud_rollback_options *o, char *block) {
    size_t at = 0, players = (size_t)o->players, depth = (size_t)o->depth;
    size_t inputs = sizeof(uint64_t) * players;
    take_bytes(block, &at, sizeof *r);
    saved_step *saved = take_bytes(block, &at, (depth + 1) * sizeof *saved);
    player_inputs *players_at = take_bytes(block, &at, players * sizeof *players_at);
    for (size_t i = 0; i < depth + 1; i++) {
        uint64_t *inputs_at = take_bytes(block, &at, inputs);
        if (block) {
            saved[i].inputs = inputs_at;
        }
    }
    for (size_t i = 0; i < players; i++) {
        uint64_t *inputs_at = take_bytes(block, &at, (2 * depth + 2) * sizeof *inputs_at);
        bool *is_known = take_bytes(block, &at, (2 * depth + 2) * sizeof *is_known);
        if (block) {
            players_at[i] = (player_inputs){inputs_at, is_known, 0};
        }
    }
    if (block) {
        r->saved = saved;
        r->players = players_at;
    }
    return at;
}

/* Makes room for a snapshot of so many bytes and the state, and for half as much again as the world
 * grows. False when memory is short. */
static bool reserve(thud_rollback *r, saved_step *m, size_t bytes) {
    size_t state = r->options.state_bytes, room = bytes + bytes / 2 + state;
    if (m->room < bytes + state || state > SIZE_MAX / 4) {
        char *image = state > SIZE_MAX / 4 ? NULL : td_memory_get(&r->world->memory, room);
        if (!image) {
            return false;
        }
        td_memory_put(&r->world->memory, m->image, m->room);
        m->image = image;
        m->room = room;
    }
    return true;
}

void thud_rollback_destroy(thud_rollback *r) {
    if (!r || check(r) != THUD_OK) {
        return;
    }
    for (int i = 0; i < saved_count(r); i++) {
        td_memory_put(&r->world->memory, r->saved[i].image, r->saved[i].room);
    }
    td_memory_put(&r->world->memory, r, r->bytes);
}

thud_result thud_rollback_create(thud_world *w, const thud_rollback_options *options,
                                 thud_rollback **out) {
    if (!w || !options || !out) {
        return td_refuse(w, THUD_ERROR_NULL, "rollback: world, options or out is null");
    }
    thud_rollback_options o = *options;
    td_reason why;
    const char *error = error_of(&o, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    size_t image;
    thud_result result = thud_world_get_snapshot_size(w, &image);
    if (result != THUD_OK) {
        return result;
    }
    o.players = o.players ? o.players : PLAYERS_DEFAULT;
    o.depth = o.depth ? o.depth : DEPTH_DEFAULT;
    size_t bytes = lay_out(NULL, &o, NULL);
    thud_rollback *r = td_memory_get(&w->memory, bytes);
    bool room = r;
    if (r) {
        *r = (thud_rollback){.world = w, .options = o, .bytes = bytes, .first_wrong = NO_STEP};
        lay_out(r, &o, (char *)r);
        for (int i = 0; i < saved_count(r) && room; i++) {
            room = reserve(r, &r->saved[i], image);
        }
    }
    if (!room) {
        thud_rollback_destroy(r);
        return td_refuse(w, THUD_ERROR_MEMORY, "rollback: out of memory");
    }
    *out = r;
    return THUD_OK;
}

/* ---- inputs ---- */

thud_result thud_rollback_get_progress(const thud_rollback *r, thud_rollback_progress *out) {
    if (!r || !out) {
        return THUD_ERROR_NULL;
    }
    int64_t confirmed = r->steps;
    for (int i = 0; i < r->options.players; i++) {
        int64_t known_before = r->players[i].known_before;
        confirmed = known_before < confirmed ? known_before : confirmed;
    }
    *out = (thud_rollback_progress){r->steps, confirmed, r->replayed};
    return THUD_OK;
}

thud_result thud_rollback_input(thud_rollback *r, int player, int64_t step, uint64_t input) {
    thud_result result = check(r);
    if (result != THUD_OK) {
        return result;
    }
    if (player < 0 || player >= r->options.players) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: there is no such player");
    }
    if (step < 0 || step > r->steps + r->options.depth) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: no step, or too far ahead");
    }
    player_inputs *k = &r->players[player];
    int at = (int)(step % input_count(r));
    bool is_forgotten =
        step < r->steps - r->options.depth - 1; /* its place in the ring has been used again */
    if (!is_forgotten && k->is_known[at] && k->inputs[at] != input) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: two inputs for one step");
    }
    if (step < k->known_before) {
        return THUD_OK;
    }
    k->is_known[at] = true;
    k->inputs[at] = input;
    while (k->known_before <= r->steps + r->options.depth &&
           k->is_known[k->known_before % input_count(r)]) {
        k->known_before++;
    }
    if (step < r->steps && step < r->first_wrong &&
        saved_step_of(r, step)->inputs[player] != input) {
        r->first_wrong = step;
    }
    return THUD_OK;
}

/* ---- playing ---- */

/* The input of a player in a step: the known one, or the one it was last played with. */
static uint64_t input_of(const thud_rollback *r, int player, int64_t step) {
    const player_inputs *k = &r->players[player];
    if (k->is_known[step % input_count(r)]) {
        return k->inputs[step % input_count(r)];
    }
    return step == 0 ? r->options.idle : saved_step_of(r, step - 1)->inputs[player];
}

/* Restores world and state to what they were before a saved step. */
static thud_result restore_step(thud_rollback *r, int64_t step) {
    const saved_step *m = saved_step_of(r, step);
    thud_result result = thud_world_restore(r->world, m->image, m->bytes);
    if (result == THUD_OK && r->options.state) {
        memcpy(r->options.state, m->image + m->bytes, r->options.state_bytes);
    }
    return result;
}

/* Saves world and state, as they are before a step. */
static thud_result save_step(thud_rollback *r, saved_step *m) {
    size_t bytes;
    thud_result result = thud_world_get_snapshot_size(r->world, &bytes);
    if (result != THUD_OK) {
        return result;
    }
    if (!reserve(r, m, bytes)) {
        return td_refuse(r->world, THUD_ERROR_MEMORY, "rollback: out of memory");
    }
    result = thud_world_snapshot(r->world, m->image, bytes, &m->bytes);
    m->hash = thud_hash_of(r->world);
    if (r->options.state) {
        memcpy(m->image + m->bytes, r->options.state, r->options.state_bytes);
    }
    return result;
}

/* Saves what is before the step, and plays it. Leaves first_wrong at the step, so that a failure
 * has it played again; the caller resets it when all steps have succeeded. Where the step cannot be
 * saved, first_wrong stays at an earlier one. If `step` fails, world and state are restored. */
static thud_result play_step(thud_rollback *r, int64_t step) {
    saved_step *m = saved_step_of(r, step);
    thud_result result = save_step(r, m);
    if (result != THUD_OK) {
        return result;
    }
    for (int i = 0; i < r->options.players; i++) {
        m->inputs[i] = input_of(r, i, step);
    }
    r->first_wrong = step;
    r->playing = true;
    result = r->options.step(r->world, m->inputs, r->options.state);
    r->playing = false;
    if (result != THUD_OK) {
        restore_step(r, step);
    }
    return result;
}

thud_result thud_rollback_settle(thud_rollback *r) {
    thud_result result = check(r);
    if (result != THUD_OK || r->first_wrong == NO_STEP) {
        return result;
    }
    result = restore_step(r, r->first_wrong);
    for (int64_t step = r->first_wrong; step < r->steps && result == THUD_OK; step++) {
        result = play_step(r, step);
        r->replayed += result == THUD_OK;
    }
    r->first_wrong = result == THUD_OK ? NO_STEP : r->first_wrong;
    return result;
}

thud_result thud_rollback_advance(thud_rollback *r, bool *out_made) {
    thud_result result = thud_rollback_settle(r);
    if (result != THUD_OK) {
        return result;
    }
    bool waits = r->steps - thud_progress_of(r).confirmed >= r->options.depth;
    result = waits ? THUD_OK : play_step(r, r->steps);
    if (result != THUD_OK) {
        return result;
    }
    if (!waits) {
        r->first_wrong = NO_STEP;
        r->steps++;
        for (int i = 0; i < r->options.players; i++) {
            r->players[i].is_known[(r->steps + r->options.depth) % input_count(r)] = false;
        }
    }
    if (out_made) {
        *out_made = !waits;
    }
    return THUD_OK;
}

thud_result thud_rollback_get_state(thud_rollback *r, int64_t step, uint64_t *out_hash,
                                    void *out_state) {
    thud_result result = thud_rollback_settle(r);
    if (result != THUD_OK) {
        return result;
    }
    bool now = step == r->steps;
    if (step < 0 || step > r->steps || step < r->steps - r->options.depth) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: that step is not kept");
    }
    const saved_step *m = now ? NULL : saved_step_of(r, step);
    if (out_hash) {
        *out_hash = now ? thud_hash_of(r->world) : m->hash;
    }
    if (out_state && r->options.state) {
        memcpy(out_state, now ? r->options.state : m->image + m->bytes, r->options.state_bytes);
    }
    return THUD_OK;
}
