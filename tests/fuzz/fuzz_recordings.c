/* fuzz_recordings.c: a fuzz target that records a session of calls of the whole API (session.h),
 * and plays the recording: every hash must be the same, also after seeking to other steps; a
 * recording that is damaged or cut short must be refused. It is linked with operations that were
 * compiled with thud_recorded.h. */
#include "calls.h"
#include "progress.h"
#include "target.h"

#include <thud/thud_recorded.h>

#include <inttypes.h>
#include <stdlib.h>

/* The byte of an input, and its bit, that gives the world a time_budget (session.c): a world with
 * one cannot be recorded. */
enum { BUDGET_BYTE = 5, BUDGET_BIT = 128 };

/* Seeks and damages for each recording. */
enum { SEEKS = 3, DAMAGES = 8 };

static thud_player *open_player(const fuzz_session *s, thud_bytes bytes) {
    thud_player *player = NULL;
    thud_result result = COUNTED(thud_player_create(bytes, NULL, &player));
    if (result != THUD_OK) {
        fuzz_fail(s, "a recording is refused: %s", thud_result_text(result));
    }
    return player;
}

static thud_player_progress progress_of(const thud_player *player) {
    thud_player_progress progress;
    COUNTED(thud_player_get_progress(player, &progress));
    return progress;
}

static uint64_t hash_of(thud_player *player) {
    thud_world *world = NULL;
    COUNTED(thud_player_get_world(player, &world));
    return thud_hash_of(world);
}

static void expect_equal(const fuzz_session *s, const thud_player *player, thud_result result,
                         const char *how) {
    if (result != THUD_OK) {
        thud_player_progress p = progress_of(player);
        fuzz_fail(s,
                  "%s: %s; of %" PRId64 " steps from %" PRId64 ", at %" PRId64
                  "; %s, after %" PRId64 ", body %" PRIu32,
                  how, thud_result_text(result), p.end, p.first, p.steps,
                  p.differs ? "differs" : "contradicts itself", p.differs_after, p.body.index1);
    }
}

/* Plays all of it, and then again from other steps on. */
static void play_recording(const fuzz_session *s, thud_bytes bytes, fuzz_bytes *choices) {
    thud_player *player = open_player(s, bytes);
    thud_player_progress p = progress_of(player);
    size_t steps = (size_t)(p.end - p.first) + 1;
    uint64_t *hashes = calloc(steps, sizeof *hashes);
    for (bool stepped = true; stepped;) {
        expect_equal(s, player, COUNTED(thud_player_step(player, &stepped)), "playing");
        p = progress_of(player);
        /* Calls after the last step belong to no step. */
        hashes[p.steps - p.first] = stepped ? hash_of(player) : hashes[p.steps - p.first];
    }
    if (p.steps != p.end || hash_of(player) != thud_hash_of(s->world)) {
        fuzz_fail(s, "a recording ends in another state, at step %" PRId64 " of %" PRId64, p.steps,
                  p.end);
    }
    for (int i = 0; i < SEEKS && steps > 1; i++) {
        int64_t step = p.first + (next_byte(choices) * 256 + next_byte(choices)) % (int)steps;
        expect_equal(s, player, COUNTED(thud_player_seek(player, step)), "seeking");
        for (bool stepped = true; stepped;) {
            expect_equal(s, player, COUNTED(thud_player_step(player, &stepped)),
                         "playing after seeking");
            p = progress_of(player);
            if (stepped && hashes[p.steps - p.first] != hash_of(player)) {
                fuzz_fail(s, "seeking leads to another state at step %" PRId64, p.steps);
            }
        }
    }
    free(hashes);
    COUNTED(thud_player_destroy(player));
}

/* Changed bits and missing ends. */
static void damage_recording(const fuzz_session *s, thud_bytes bytes, fuzz_bytes *choices) {
    uint8_t *copy = malloc(bytes.count);
    for (int i = 0; i < DAMAGES; i++) {
        size_t count = bytes.count, place = 0;
        for (int k = 0; k < 4; k++) {
            place = place << 8 | next_byte(choices);
        }
        memcpy(copy, bytes.data, bytes.count);
        if (i % 2) {
            count = place % bytes.count;
        } else {
            copy[place % bytes.count] ^= (uint8_t)(1 << next_byte(choices) % 8);
        }
        thud_player *player = NULL;
        if (COUNTED(thud_player_create((thud_bytes){copy, count}, NULL, &player)) == THUD_OK) {
            fuzz_fail(s, "damage is not found at byte %zu of %zu", place % bytes.count,
                      bytes.count);
        }
    }
    free(copy);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static fuzz_session session;
    fuzz_session *s = &session;
    fuzz_bytes choices = {data, data + size, false};
    uint8_t *input = malloc(size + 1);
    memcpy(input, data, size);
    if (size > BUDGET_BYTE) {
        input[BUDGET_BYTE] &= (uint8_t)~BUDGET_BIT;
    }
    session_open(s, input, size, false);
    unsigned how = next_byte(&choices);
    thud_recorder_options options = {.hash_steps = how & 1 ? 1 : 7,
                                     .body_hashes = how & 2,
                                     .keyframe_steps = how & 4 ? 5 : 0,
                                     .ring_steps = how & 8 ? 20 : 0,
                                     .queries = how & 16};
    thud_recorder *recorder = NULL;
    bool recorded = COUNTED(thud_recorder_begin(s->world, &options, &recorder)) == THUD_OK;
    while (!session_over(s)) {
        session_play(s);
        s->operations++;
    }
    thud_bytes bytes;
    if (recorded && COUNTED(thud_recorder_get_bytes(recorder, &bytes)) == THUD_OK) {
        play_recording(s, bytes, &choices);
        damage_recording(s, bytes, &choices);
    }
    COUNTED(thud_recorder_end(recorder));
    session_close(s);
    free(input);
    progress_tell();
    return 0;
}
