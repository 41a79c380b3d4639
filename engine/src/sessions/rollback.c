/* rollback.c: see thud_rollback.h. What was before each of the last steps is kept in a ring, by the
 * step's number; what is known of the inputs in another, which reaches as far ahead. */
#include "thud/thud_rollback.h"

#include "state/handles.h"
#include "thud/thud.h"
#include "thud/thud_snapshot.h"

#include <string.h>

enum { USUAL_PLAYERS = 2, USUAL_DEPTH = 60 };

static const int64_t NEVER = INT64_MAX;

/* What was before a step, and what it was played with. */
typedef struct moment {
    char *image; /* the world's snapshot, and behind it the state */
    size_t room, bytes;
    uint64_t hash;
    uint64_t *inputs; /* by player */
} moment;

/* What is known of a player. */
typedef struct known {
    uint64_t *inputs;
    bool *told;
    int64_t before; /* all of its inputs before this step */
} known;

struct thud_rollback {
    thud_world *world;
    thud_rollback_options options;
    size_t bytes; /* of this block, with all that follows */
    moment *moments;
    known *players;
    int64_t steps, replayed;
    int64_t wrong; /* the first step that is to be played again */
    bool playing;
};

/* The moment before the earliest that may be wrong is kept: who is not known holds what it held. */
static int kept(const thud_rollback *r) {
    return r->options.depth + 1;
}

static int heard(const thud_rollback *r) {
    return 2 * r->options.depth + 2;
}

static moment *moment_of(const thud_rollback *r, int64_t step) {
    return &r->moments[step % kept(r)];
}

static thud_result check(const thud_rollback *r) {
    if (!r) {
        return THUD_ERROR_NULL;
    }
    return r->playing || r->world->locked
               ? td_refuse(r->world, THUD_ERROR_LOCKED, "rollback: not inside a callback or a step")
               : THUD_OK;
}

/* ---- making ---- */

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

/* So many bytes behind what the block has so far; from null it is asked how many. */
static void *carve(char *block, size_t *at, size_t bytes) {
    void *piece = block ? block + *at : NULL;
    *at += (bytes + 15) & ~(size_t)15;
    return piece;
}

static size_t lay_out(thud_rollback *r, const thud_rollback_options *o, char *block) {
    size_t at = 0, players = (size_t)o->players, depth = (size_t)o->depth;
    size_t inputs = sizeof(uint64_t) * players;
    carve(block, &at, sizeof *r);
    moment *moments = carve(block, &at, (depth + 1) * sizeof *moments);
    known *people = carve(block, &at, players * sizeof *people);
    for (size_t i = 0; i < depth + 1; i++) {
        uint64_t *held = carve(block, &at, inputs);
        if (block) {
            moments[i].inputs = held;
        }
    }
    for (size_t i = 0; i < players; i++) {
        uint64_t *said = carve(block, &at, (2 * depth + 2) * sizeof *said);
        bool *told = carve(block, &at, (2 * depth + 2) * sizeof *told);
        if (block) {
            people[i] = (known){said, told, 0};
        }
    }
    if (block) {
        r->moments = moments;
        r->players = people;
    }
    return at;
}

/* Room for the world as it is, and half as much again, so that it seldom outgrows it. */
static bool reserve(thud_rollback *r, moment *m, size_t bytes) {
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
    for (int i = 0; i < kept(r); i++) {
        td_memory_put(&r->world->memory, r->moments[i].image, r->moments[i].room);
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
    thud_result result = thud_world_snapshot_size(w, &image);
    if (result != THUD_OK) {
        return result;
    }
    o.players = o.players ? o.players : USUAL_PLAYERS;
    o.depth = o.depth ? o.depth : USUAL_DEPTH;
    size_t bytes = lay_out(NULL, &o, NULL);
    thud_rollback *r = td_memory_get(&w->memory, bytes);
    bool room = r;
    if (r) {
        *r = (thud_rollback){.world = w, .options = o, .bytes = bytes, .wrong = NEVER};
        lay_out(r, &o, (char *)r);
        for (int i = 0; i < kept(r) && room; i++) {
            room = reserve(r, &r->moments[i], image);
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

thud_rollback_progress thud_rollback_get(const thud_rollback *r) {
    if (!r) {
        return (thud_rollback_progress){0};
    }
    int64_t confirmed = r->steps;
    for (int i = 0; i < r->options.players; i++) {
        int64_t before = r->players[i].before;
        confirmed = before < confirmed ? before : confirmed;
    }
    return (thud_rollback_progress){r->steps, confirmed, r->replayed};
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
    known *k = &r->players[player];
    int at = (int)(step % heard(r));
    bool old = step < r->steps - r->options.depth - 1; /* known, and forgotten since */
    if (!old && k->told[at] && k->inputs[at] != input) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: two inputs for one step");
    }
    if (step < k->before) {
        return THUD_OK;
    }
    k->told[at] = true;
    k->inputs[at] = input;
    while (k->before <= r->steps + r->options.depth && k->told[k->before % heard(r)]) {
        k->before++;
    }
    if (step < r->steps && step < r->wrong && moment_of(r, step)->inputs[player] != input) {
        r->wrong = step;
    }
    return THUD_OK;
}

/* ---- playing ---- */

static uint64_t input_of(const thud_rollback *r, int player, int64_t step) {
    const known *k = &r->players[player];
    if (k->told[step % heard(r)]) {
        return k->inputs[step % heard(r)];
    }
    return step == 0 ? r->options.idle : moment_of(r, step - 1)->inputs[player];
}

static thud_result go_back(thud_rollback *r, int64_t step) {
    const moment *m = moment_of(r, step);
    thud_result result = thud_world_restore(r->world, m->image, m->bytes);
    if (result == THUD_OK && r->options.state) {
        memcpy(r->options.state, m->image + m->bytes, r->options.state_bytes);
    }
    return result;
}

/* Keeps what is before the step. */
static thud_result keep(thud_rollback *r, moment *m) {
    size_t bytes;
    thud_result result = thud_world_snapshot_size(r->world, &bytes);
    if (result != THUD_OK) {
        return result;
    }
    if (!reserve(r, m, bytes)) {
        return td_refuse(r->world, THUD_ERROR_MEMORY, "rollback: out of memory");
    }
    result = thud_world_snapshot(r->world, m->image, bytes, &m->bytes);
    m->hash = thud_world_hash(r->world);
    if (r->options.state) {
        memcpy(m->image + m->bytes, r->options.state, r->options.state_bytes);
    }
    return result;
}

/* From here on it is to be played again, until whoever asked says that all is well. Where what is
 * before it cannot be kept, an earlier one is. */
static thud_result play(thud_rollback *r, int64_t step) {
    moment *m = moment_of(r, step);
    thud_result result = keep(r, m);
    if (result != THUD_OK) {
        return result;
    }
    for (int i = 0; i < r->options.players; i++) {
        m->inputs[i] = input_of(r, i, step);
    }
    r->wrong = step;
    r->playing = true;
    result = r->options.step(r->world, m->inputs, r->options.state);
    r->playing = false;
    if (result != THUD_OK) {
        go_back(r, step);
    }
    return result;
}

thud_result thud_rollback_settle(thud_rollback *r) {
    thud_result result = check(r);
    if (result != THUD_OK || r->wrong == NEVER) {
        return result;
    }
    result = go_back(r, r->wrong);
    for (int64_t step = r->wrong; step < r->steps && result == THUD_OK; step++) {
        result = play(r, step);
        r->replayed += result == THUD_OK;
    }
    r->wrong = result == THUD_OK ? NEVER : r->wrong;
    return result;
}

thud_result thud_rollback_advance(thud_rollback *r, bool *made) {
    thud_result result = thud_rollback_settle(r);
    if (result != THUD_OK) {
        return result;
    }
    bool waits = r->steps - thud_rollback_get(r).confirmed >= r->options.depth;
    result = waits ? THUD_OK : play(r, r->steps);
    if (result != THUD_OK) {
        return result;
    }
    if (!waits) {
        r->wrong = NEVER;
        r->steps++;
        for (int i = 0; i < r->options.players; i++) {
            r->players[i].told[(r->steps + r->options.depth) % heard(r)] = false;
        }
    }
    if (made) {
        *made = !waits;
    }
    return THUD_OK;
}

thud_result thud_rollback_at(thud_rollback *r, int64_t step, uint64_t *hash, void *state) {
    thud_result result = thud_rollback_settle(r);
    if (result != THUD_OK) {
        return result;
    }
    bool now = step == r->steps;
    if (step < 0 || step > r->steps || step < r->steps - r->options.depth) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: that step is not kept");
    }
    const moment *m = now ? NULL : moment_of(r, step);
    if (hash) {
        *hash = now ? thud_world_hash(r->world) : m->hash;
    }
    if (state && r->options.state) {
        memcpy(state, now ? r->options.state : m->image + m->bytes, r->options.state_bytes);
    }
    return THUD_OK;
}
