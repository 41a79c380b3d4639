/* operations_sessions.c: worlds saved in files, and a rollback in a world of its own, which must
 * end as if every input had been known in time; pools of threads beside them. */
#include "operations.h"

#include <thud/thud_forces.h>
#include <thud/thud_make.h>
#include <thud/thud_recording.h>
#include <thud/thud_rollback.h>
#include <thud/thud_threads.h>

#include <stdatomic.h>
#include <stdio.h>
#include <unistd.h>

/* ---- files ---- */

/* Flips a bit of a byte of the file; a second call with the same `dice` flips it back. */
static void flip_byte(const char *path, unsigned dice) {
    FILE *file = fopen(path, "r+b");
    fseek(file, 0, SEEK_END);
    long at = (long)(dice * 2654435761u >> 8) % ftell(file);
    fseek(file, at, SEEK_SET);
    int byte = fgetc(file);
    fseek(file, at, SEEK_SET);
    fputc(byte ^ 1, file);
    fclose(file);
}

/* Saves the world. Loading is refused with too little room for the caller's own bytes and from a
 * damaged file, and gives the saved bytes back otherwise. */
void play_saved(fuzz_session *s) {
    char path[64];
    snprintf(path, sizeof path, "fuzz-save-%d", (int)getpid());
    uint64_t own[2] = {s->digest, next_byte(&s->bytes)}, back[2];
    unsigned at = next_byte(&s->bytes);
    TRY(s, thud_world_save(s->world, path, own, sizeof own));
    if (s->result != THUD_OK) {
        return;
    }
    memset(back, CALL_FILL, sizeof back);
    TRY(s, thud_world_load(s->world, path, back, sizeof back / 2));
    if (s->result != THUD_ERROR_INVALID) {
        fuzz_fail(s, "a file is loaded with half of its own bytes");
    }
    flip_byte(path, at);
    TRY(s, thud_world_load(s->world, path, back, sizeof back));
    if (s->result != THUD_ERROR_INVALID) {
        fuzz_fail(s, "a file that is damaged (%u) is loaded", at);
    }
    call_untouched(s, back, sizeof back);
    flip_byte(path, at);
    TRY(s, thud_world_load(s->world, path, back, sizeof back));
    if (s->result != THUD_OK || memcmp(own, back, sizeof own) != 0) {
        fuzz_fail(s, "what was saved is not loaded: %s", thud_result_text(s->result));
    }
    remove(path);
}

/* ---- rollback ---- */

enum { STEPS = 24, DEPTH = 6 };

static thud_result push_and_step(thud_world *world, const uint64_t *inputs, void *state) {
    thud_body_id *balls = state;
    for (int i = 0; i < 2; i++) {
        thud_vec2 push = {(float)inputs[i] - 3, 1};
        thud_body_apply_center_impulse(world, balls[i], push);
    }
    return thud_world_step(world);
}

static thud_world *make_balls(thud_body_id balls[2]) {
    thud_world *world = COUNTED(thud_world_make((thud_vec2){0, -10}, &thud_quality_default));
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC};
    thud_body_make(world, thud_aabb_at(0, -1, 20, 1), NULL);
    for (int i = 0; i < 2; i++) {
        balls[i] = thud_body_make(world, thud_circle_at(i, 2, 0.5), &ball);
    }
    return world;
}

/* Bytes of a rollback, of which the fuzzer may change one. */
typedef struct told_bytes {
    unsigned char data[8192];
    size_t count;
    bool is_whole;
} told_bytes;

static void tell_bytes(fuzz_session *s, told_bytes *t) {
    unsigned bit = next_byte(&s->bytes);
    size_t at = t->count * next_byte(&s->bytes) / 256;
    t->is_whole = bit >= 64;
    if (!t->is_whole) {
        t->data[at] ^= (unsigned char)(1u << bit % 8);
    }
}

/* Somebody joins the game of a rollback by bytes, which may be damaged, looks on until the other
 * player is gone, and finds the same game by its report. Clocks are compared on the way. */
static void join_game(fuzz_session *s, thud_rollback *r, const thud_rollback_options *options) {
    thud_body_id balls[2];
    thud_world *world = make_balls(balls);
    thud_rollback *guest = NULL;
    thud_rollback_options own = *options;
    thud_rollback_difference found = {0};
    told_bytes t;
    own.state = balls;
    int64_t lead = 0;
    bool ok = COUNTED(thud_rollback_create(world, &own, &guest)) == THUD_OK &&
              COUNTED(thud_rollback_get_lead(r, 1, &lead)) == THUD_OK &&
              COUNTED(thud_rollback_set_lead(guest, 1, -lead)) == THUD_OK &&
              COUNTED(thud_rollback_snapshot(r, t.data, sizeof t.data, &t.count)) == THUD_OK;
    int64_t sure = COUNTED(thud_progress_of(r)).confirmed;
    tell_bytes(s, &t);
    thud_result result = COUNTED(thud_rollback_restore(guest, t.data, t.count));
    ok = ok && (result == THUD_OK) == t.is_whole;
    if (ok && t.is_whole) {
        ok = thud_progress_of(guest).steps == sure &&
             COUNTED(thud_rollback_leave(guest, 1, sure)) == THUD_OK &&
             COUNTED(thud_rollback_enter(guest, 1, sure + DEPTH / 2)) == THUD_OK;
        ok = ok &&
             COUNTED(thud_rollback_report(guest, sure, t.data, sizeof t.data, &t.count)) == THUD_OK;
        tell_bytes(s, &t);
        result = COUNTED(thud_rollback_compare(r, t.data, t.count, &found));
        ok = ok && (result == THUD_OK ? t.is_whole && found.step == -1 : !t.is_whole);
    }
    if (!ok) {
        fuzz_fail(s, "who joins a game has another");
    }
    COUNTED(thud_rollback_destroy(guest));
    thud_world_destroy(world);
}

/* Inputs of two players arrive at random times, each player's in order and at most DEPTH steps
 * late. */
static void play_inputs(fuzz_session *s) {
    thud_body_id balls[2], plain[2], copy[2];
    thud_world *world = make_balls(balls), *straight = make_balls(plain);
    thud_rollback_options options = {.step = push_and_step, .idle = 3, .depth = DEPTH};
    thud_rollback *r = NULL;
    uint64_t inputs[STEPS][2], hash = 0;
    int64_t told[2] = {0, 0};
    options.state = balls;
    options.state_bytes = sizeof balls;
    if (COUNTED(thud_rollback_create(world, &options, &r)) != THUD_OK) {
        fuzz_fail(s, "no rollback is made");
    }
    for (int i = 0; i < STEPS; i++) {
        inputs[i][0] = next_byte(&s->bytes) % 7;
        inputs[i][1] = next_byte(&s->bytes) % 7;
    }
    while (COUNTED(thud_progress_of(r)).steps < STEPS) {
        unsigned byte = next_byte(&s->bytes);
        bool made = false;
        int64_t now = COUNTED(thud_progress_of(r)).steps;
        for (int player = 0; player < 2; player++) {
            int64_t lag = byte >> 4 * player & 7, until = lag < DEPTH ? now - lag : now;
            for (; told[player] <= until; told[player]++) {
                uint64_t held = inputs[told[player]][player];
                if (COUNTED(thud_rollback_input(r, player, told[player], held)) != THUD_OK) {
                    fuzz_fail(s, "input %d is refused", (int)told[player]);
                }
            }
        }
        if (COUNTED(thud_rollback_advance(r, &made)) != THUD_OK || !made) {
            fuzz_fail(s, "step %d is not made", (int)now);
        }
    }
    join_game(s, r, &options);
    for (int player = 0; player < 2; player++) {
        for (; told[player] < STEPS; told[player]++) {
            thud_rollback_input(r, player, told[player], inputs[told[player]][player]);
        }
    }
    for (int i = 0; i < STEPS; i++) {
        push_and_step(straight, inputs[i], plain);
    }
    if (COUNTED(thud_rollback_settle(r)) != THUD_OK ||
        COUNTED(thud_rollback_get_state(r, STEPS, &hash, copy)) != THUD_OK ||
        hash != thud_hash_of(straight) || hash != thud_hash_of(world)) {
        fuzz_fail(s, "late inputs end elsewhere");
    }
    note_bits(s, hash);
    COUNTED(thud_rollback_destroy(r));
    thud_world_destroy(world);
    thud_world_destroy(straight);
}

/* ---- threads ---- */

static void count_call(void *calls) {
    atomic_fetch_add((atomic_int *)calls, 1);
}

/* A pool of a number of workers that may be out of range: it calls a task as often as it is asked
 * to, by its own threads or with more workers than it has. */
static void play_pool(fuzz_session *s) {
    int workers = (int)next_choice(&s->bytes, 8) - 2, asked = 1 + (int)next_choice(&s->bytes, 8);
    thud_threads *threads = NULL;
    thud_job_system jobs;
    if (workers == 5) {
        workers = THUD_WORKERS_MAX + 1;
    }
    PURE(s, threads, thud_threads_create(workers, NULL, &threads));
    if ((s->result == THUD_OK) != (workers >= 1 && workers <= THUD_WORKERS_MAX)) {
        fuzz_fail(s, "a pool of %d workers: %s", workers, thud_result_text(s->result));
    }
    threads = s->result == THUD_OK ? threads : NULL;
    PURE(s, jobs, thud_threads_get_job_system(threads, &jobs));
    if (s->result == THUD_OK) {
        atomic_int calls = 0;
        jobs.run(count_call, &calls, asked, jobs.context);
        if (jobs.workers != workers || calls != asked) {
            fuzz_fail(s, "a pool of %d calls a task %d times, not %d", workers, calls, asked);
        }
    }
    COUNTED(thud_threads_destroy(threads));
}

/* ---- recordings ---- */

static void count_chunk(const char *name, thud_bytes bytes, void *context) {
    *(int *)context += bytes.count == 1 && name[0] == 'n';
}

static void count_played(const thud_played_call *call, void *context) {
    *(int *)context += call->result == THUD_OK && call->value_count == 0 && call->returned == 0;
}

/* A world that is recorded, and played to the same hash, with a chunk, by steps and by seeking; its
 * calls are told. */
static void play_recorded(fuzz_session *s) {
    enum { RECORDED = 5 };
    thud_world *world = COUNTED(thud_world_make((thud_vec2){0, -10}, &thud_quality_draft)), *played;
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC};
    thud_body_make(world, thud_circle_at(0, 2, 0.5), &ball);
    thud_recorder *recorder = NULL;
    thud_player *player = NULL;
    thud_player_progress progress = {0};
    thud_bytes bytes;
    int told = 0;
    int64_t keyframe = -1;
    thud_player_options options = {.chunk = count_chunk, .call = count_played, .context = &told};
    bool ok = COUNTED(thud_recorder_begin(world, NULL, &recorder)) == THUD_OK &&
              COUNTED(thud_recorder_add_chunk(recorder, "n", (thud_bytes){"1", 1})) == THUD_OK;
    for (int i = 0; i < RECORDED && ok; i++) {
        ok = thud_world_step(world) == THUD_OK;
    }
    ok = ok && COUNTED(thud_recorder_get_bytes(recorder, &bytes)) == THUD_OK &&
         COUNTED(thud_player_create(bytes, &options, &player)) == THUD_OK;
    for (bool stepped = true; ok && stepped;) {
        ok = COUNTED(thud_player_step(player, &stepped)) == THUD_OK;
    }
    ok = ok && COUNTED(thud_player_get_progress(player, &progress)) == THUD_OK &&
         told > 1 && /* the chunk, and steps, or the state after steps that are not recorded */
         COUNTED(thud_player_get_keyframe(player, progress.end, &keyframe)) == THUD_OK &&
         keyframe == progress.first && COUNTED(thud_player_get_world(player, &played)) == THUD_OK &&
         thud_hash_of(played) == thud_hash_of(world) &&
         COUNTED(thud_player_seek(player, progress.first)) == THUD_OK &&
         COUNTED(thud_recorder_salvage(recorder, &bytes)) == THUD_OK;
    if (!ok) {
        fuzz_fail(s, "a recording of a ball is not played");
    }
    COUNTED(thud_player_destroy(player));
    COUNTED(thud_recorder_end(recorder));
    thud_world_destroy(world);
}

/* The three share a byte. */
void play_rollback(fuzz_session *s) {
    if (next_chance(&s->bytes, 8)) {
        play_pool(s);
        play_recorded(s);
    } else {
        play_inputs(s);
    }
}
