/* rollback.c: rollback for networked play (thud_rollback.h): steps are played with predicted
 * inputs, and played again from a snapshot when an input turns out to be different. */
#include "sessions/rollback.h"

#include "thud/thud.h"
#include "thud/thud_snapshot.h"

#include <string.h>

/* Values for options of 0, as the header promises; 60 steps are a second at 60 Hz. */
enum { PLAYERS_DEFAULT = 2, DEPTH_DEFAULT = 60 };

/* The lead of a player is by how many steps a peer is ahead of that player's inputs. Each value
 * that arrives moves the smoothed lead by this share of the difference. Chosen: a value has 2 % of
 * its weight left after a second of messages at 60 Hz, so that the jitter of a network averages
 * out. */
static const double LEAD_SHARE = 1.0 / 16;

/* The length of the ring `saved`: one more than the depth, since the prediction for the earliest
 * step that may be wrong needs the inputs of the step before. The snapshot of that step is not
 * needed. */
static int saved_count(const thud_rollback *r) {
    return r->options.depth + 1;
}

/* The length of the rings of inputs: depth + 1 steps back, the next step, and depth steps ahead. */
static int input_count(const thud_rollback *r) {
    return 2 * r->options.depth + 2;
}

td_saved_step *td_rollback_saved(const thud_rollback *r, int64_t step) {
    return &r->saved[(step + saved_count(r)) % saved_count(r)];
}

int64_t td_rollback_oldest(const thud_rollback *r) {
    int64_t oldest = r->steps - r->options.depth;
    return oldest < r->first ? r->first : oldest;
}

thud_result td_rollback_check(const thud_rollback *r) {
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
        !td_in(why, "rollback: depth", o->depth, 0.0, THUD_ROLLBACK_DEPTH_MAX) ||
        !td_in(why, "rollback: budget", o->budget, 0.0, THUD_ROLLBACK_DEPTH_MAX)) {
        return why->text;
    }
    if (!o->state != !o->state_bytes) {
        return "rollback: a state without bytes, or bytes without a state";
    }
    return NULL;
}

/* Returns the address *at bytes after the start of the block, and adds to *at the piece's size,
 * rounded up to a multiple of 16. Returns null for a null block: only the size is computed. */
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
    td_saved_step *saved = take_bytes(block, &at, (depth + 1) * sizeof *saved);
    td_player_inputs *players_at = take_bytes(block, &at, players * sizeof *players_at);
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
            players_at[i] = (td_player_inputs){.inputs = inputs_at,
                                               .is_known = is_known,
                                               .gone_from = TD_NO_STEP};
        }
    }
    if (block) {
        r->saved = saved;
        r->players = players_at;
    }
    return at;
}

/* Makes room for a snapshot of so many bytes and the state. New memory has room for half a snapshot
 * more, since the world may grow. False when memory is short. */
static bool reserve(thud_rollback *r, td_saved_step *m, size_t bytes) {
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
    if (!r || td_rollback_check(r) != THUD_OK) {
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
        *r = (thud_rollback){.world = w, .options = o, .bytes = bytes};
        lay_out(r, &o, (char *)r);
        td_rollback_begin(r, 0, NULL);
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

static bool is_absent(const td_player_inputs *k, int64_t step) {
    return step >= k->gone_from && step < k->back_at;
}

/* Stores an input. If its step was played with another one, the step is marked to be played again.
 */
static void know(thud_rollback *r, int player, int64_t step, uint64_t input) {
    td_player_inputs *k = &r->players[player];
    int at = (int)(step % input_count(r));
    k->is_known[at] = true;
    k->inputs[at] = input;
    while (k->known_before <= r->steps + r->options.depth &&
           k->is_known[k->known_before % input_count(r)]) {
        k->known_before++;
    }
    if (step < r->steps && step < r->first_wrong &&
        td_rollback_saved(r, step)->inputs[player] != input) {
        r->first_wrong = step;
    }
}

/* Stores the idle input of a player for the steps from this one on at which it is absent. */
static void know_absence(thud_rollback *r, int player, int64_t step) {
    for (; step <= r->steps + r->options.depth; step++) {
        if (is_absent(&r->players[player], step)) {
            know(r, player, step, r->options.idle);
        }
    }
}

void td_rollback_begin(thud_rollback *r, int64_t step, const uint64_t *inputs) {
    r->first = r->steps = r->at = step;
    r->first_wrong = TD_NO_STEP;
    for (int i = 0; i < r->options.players; i++) {
        td_player_inputs *k = &r->players[i];
        memset(k->is_known, 0, (size_t)input_count(r) * sizeof *k->is_known);
        k->known_before = k->told_before = step;
        k->is_timed = false;
        td_rollback_saved(r, step - 1)->inputs[i] = inputs ? inputs[i] : r->options.idle;
        know_absence(r, i, step);
    }
}

/* The step before which all inputs are known. */
static int64_t confirmed_of(const thud_rollback *r) {
    int64_t confirmed = r->steps;
    for (int i = 0; i < r->options.players; i++) {
        int64_t known_before = r->players[i].known_before;
        confirmed = known_before < confirmed ? known_before : confirmed;
    }
    return confirmed;
}

/* See thud_rollback_progress.ahead. */
static double ahead_of(const thud_rollback *r) {
    double sum = 0;
    int heard = 0;
    for (int i = 0; i < r->options.players; i++) {
        const td_player_inputs *k = &r->players[i];
        if (k->is_timed && !is_absent(k, r->steps)) {
            sum += (k->lead - k->their_lead) / 2;
            heard++;
        }
    }
    return heard ? sum / heard : 0;
}

thud_result thud_rollback_get_progress(const thud_rollback *r, thud_rollback_progress *out) {
    if (!r || !out) {
        return THUD_ERROR_NULL;
    }
    *out = (thud_rollback_progress){
        .steps = r->steps,
        .confirmed = confirmed_of(r),
        .replayed = r->replayed,
        .settled = r->first_wrong < r->steps ? r->first_wrong : r->steps,
        .ahead = ahead_of(r),
    };
    return THUD_OK;
}

/* Refuses calls that td_rollback_check refuses, and a number that is no player's. */
static thud_result check_player(const thud_rollback *r, int player) {
    thud_result result = td_rollback_check(r);
    return result == THUD_OK && (player < 0 || player >= r->options.players)
               ? td_refuse(r->world, THUD_ERROR_INVALID, "rollback: there is no such player")
               : result;
}

thud_result thud_rollback_input(thud_rollback *r, int player, int64_t step, uint64_t input) {
    thud_result result = check_player(r, player);
    if (result != THUD_OK) {
        return result;
    }
    if (step < 0 || step > r->steps + r->options.depth) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: no step, or too far ahead");
    }
    td_player_inputs *k = &r->players[player];
    int at = (int)(step % input_count(r));
    bool is_forgotten =
        step < r->steps - r->options.depth -
                   1; /* the step is so long ago that another one has taken its place in the ring */
    if (!is_forgotten && k->is_known[at] && k->inputs[at] != input) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: two inputs for one step");
    }
    if (step >= k->known_before) {
        k->told_before = step < k->told_before ? k->told_before : step + 1;
        know(r, player, step, input);
    }
    return THUD_OK;
}

/* ---- clocks ---- */

/* Steps by which this peer has played beyond the player's last input; negative if inputs are known
 * ahead. */
static int64_t lead_of(const thud_rollback *r, int player) {
    return r->steps - r->players[player].told_before;
}

thud_result thud_rollback_get_lead(const thud_rollback *r, int player, int64_t *out_lead) {
    if (!r || !out_lead) {
        return THUD_ERROR_NULL;
    }
    thud_result result = check_player(r, player);
    if (result == THUD_OK) {
        *out_lead = lead_of(r, player);
    }
    return result;
}

thud_result thud_rollback_set_lead(thud_rollback *r, int player, int64_t lead) {
    thud_result result = check_player(r, player);
    if (result != THUD_OK) {
        return result;
    }
    if (lead < -THUD_ROLLBACK_DEPTH_MAX || lead > THUD_ROLLBACK_DEPTH_MAX) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: no peer can have such a lead");
    }
    td_player_inputs *k = &r->players[player];
    double own = (double)lead_of(r, player), theirs = (double)lead;
    k->lead = k->is_timed ? k->lead + LEAD_SHARE * (own - k->lead) : own;
    k->their_lead = k->is_timed ? k->their_lead + LEAD_SHARE * (theirs - k->their_lead) : theirs;
    k->is_timed = true;
    return THUD_OK;
}

/* ---- players who come and go ---- */

thud_result thud_rollback_leave(thud_rollback *r, int player, int64_t step) {
    thud_result result = check_player(r, player);
    if (result != THUD_OK) {
        return result;
    }
    td_player_inputs *k = &r->players[player];
    if (k->gone_from != TD_NO_STEP && (k->back_at == TD_NO_STEP || step < k->back_at)) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: the player is absent");
    }
    if (step < td_rollback_oldest(r) || step > r->steps + r->options.depth ||
        step < k->told_before) {
        return td_refuse(r->world, THUD_ERROR_INVALID,
                         "rollback: an input of that step is known, or the step is too far away");
    }
    k->gone_from = step;
    k->back_at = TD_NO_STEP;
    know_absence(r, player, step);
    return THUD_OK;
}

thud_result thud_rollback_enter(thud_rollback *r, int player, int64_t step) {
    thud_result result = check_player(r, player);
    if (result != THUD_OK) {
        return result;
    }
    td_player_inputs *k = &r->players[player];
    if (k->gone_from == TD_NO_STEP || k->back_at != TD_NO_STEP) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: the player is not absent");
    }
    if (step < k->gone_from || step < confirmed_of(r) || step > r->steps + r->options.depth) {
        return td_refuse(r->world, THUD_ERROR_INVALID,
                         "rollback: that step is confirmed, or too far ahead");
    }
    k->back_at = k->told_before = step;
    k->known_before = step < k->known_before ? step : k->known_before;
    for (int64_t i = step; i <= r->steps + r->options.depth; i++) {
        k->is_known[i % input_count(r)] = false;
    }
    return THUD_OK;
}

/* ---- playing ---- */

/* The input of a player in a step: the known one, or the one of the step before. */
static uint64_t input_of(const thud_rollback *r, int player, int64_t step) {
    const td_player_inputs *k = &r->players[player];
    return k->is_known[step % input_count(r)] ? k->inputs[step % input_count(r)]
                                              : td_rollback_saved(r, step - 1)->inputs[player];
}

thud_result td_rollback_restore_step(thud_rollback *r, int64_t step) {
    const td_saved_step *m = td_rollback_saved(r, step);
    thud_result result = thud_world_restore(r->world, m->image, m->bytes);
    if (result == THUD_OK) {
        r->at = step;
        if (r->options.state) {
            memcpy(r->options.state, m->image + m->bytes, r->options.state_bytes);
        }
    }
    return result;
}

thud_result td_rollback_save_step(thud_rollback *r, int64_t step) {
    td_saved_step *m = td_rollback_saved(r, step);
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

/* Saves world and state as they are before the step, and plays it. Sets first_wrong to the step, so
 * that it is played again if it fails; the caller resets it when all steps have succeeded. If the
 * step cannot be saved, first_wrong does not change. If options.step fails, world and state are
 * restored. */
static thud_result play_step(thud_rollback *r, int64_t step) {
    td_saved_step *m = td_rollback_saved(r, step);
    thud_result result = td_rollback_save_step(r, step);
    if (result != THUD_OK) {
        return result;
    }
    for (int i = 0; i < r->options.players; i++) {
        m->inputs[i] = input_of(r, i, step);
    }
    r->first_wrong = step;
    r->at = -1;
    r->playing = true;
    result = r->options.step(r->world, m->inputs, r->options.state);
    r->playing = false;
    if (result != THUD_OK) {
        td_rollback_restore_step(r, step);
        return result;
    }
    r->at = step + 1;
    return THUD_OK;
}

/* Plays again the steps that were played with wrong inputs, at most `steps_max` of them. */
static thud_result settle(thud_rollback *r, int64_t steps_max) {
    if (r->first_wrong == TD_NO_STEP) {
        return THUD_OK;
    }
    int64_t step = r->first_wrong;
    thud_result result = r->at == step ? THUD_OK : td_rollback_restore_step(r, step);
    for (; step < r->steps && steps_max > 0 && result == THUD_OK; steps_max--) {
        result = play_step(r, step);
        step += result == THUD_OK;
        r->replayed += result == THUD_OK;
    }
    if (result == THUD_OK) {
        r->first_wrong = step < r->steps ? step : TD_NO_STEP;
    }
    return result;
}

thud_result thud_rollback_settle(thud_rollback *r) {
    thud_result result = td_rollback_check(r);
    return result == THUD_OK ? settle(r, INT64_MAX) : result;
}

thud_result td_rollback_settle_for(thud_rollback *r, const void *buffer, size_t capacity,
                                   const size_t *out_bytes) {
    thud_result result = thud_rollback_settle(r);
    if (result == THUD_OK && (!out_bytes || (!buffer && capacity > 0))) {
        result = td_refuse(r->world, THUD_ERROR_NULL, "rollback: buffer or out_bytes is null");
    }
    return result;
}

thud_result thud_rollback_advance(thud_rollback *r, bool *out_made) {
    thud_result result = td_rollback_check(r);
    if (result == THUD_OK) {
        result = settle(r, r->options.budget ? r->options.budget : INT64_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    bool waits = r->first_wrong != TD_NO_STEP || r->steps - confirmed_of(r) >= r->options.depth;
    result = waits ? THUD_OK : play_step(r, r->steps);
    if (result != THUD_OK) {
        return result;
    }
    if (!waits) {
        r->first_wrong = TD_NO_STEP;
        r->steps++;
        for (int i = 0; i < r->options.players; i++) {
            int64_t last = r->steps + r->options.depth;
            r->players[i].is_known[last % input_count(r)] = false;
            know_absence(r, i, last);
        }
    }
    if (out_made) {
        *out_made = !waits;
    }
    return THUD_OK;
}

thud_result thud_rollback_get_state(thud_rollback *r, int64_t step, uint64_t *out_hash,
                                    void *out_state) {
    thud_result result = td_rollback_check(r);
    if (result == THUD_OK && (step > r->first_wrong || step == r->steps)) {
        result = settle(r, INT64_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    bool now = step == r->at; /* otherwise the step was played: hash and state are in its place of
                                 the ring */
    if (step < td_rollback_oldest(r) || step > r->steps) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: that step is not kept");
    }
    const td_saved_step *m = now ? NULL : td_rollback_saved(r, step);
    if (out_hash) {
        *out_hash = now ? thud_hash_of(r->world) : m->hash;
    }
    if (out_state && r->options.state) {
        memcpy(out_state, now ? r->options.state : m->image + m->bytes, r->options.state_bytes);
    }
    return THUD_OK;
}
