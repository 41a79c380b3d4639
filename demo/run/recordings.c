/* recordings.c: see recordings.h. */
#include "recordings.h"

#include "bisect.h"
#include "run.h"

#include <thud/thud_recording.h>
#include <thud/thud_threads.h>
#include <whole_file.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- recording ---- */

/* Steps from one keyframe to the next where the command line names none. Measured over six scenes
 * of 600 steps: with twice as many keyframes files are up to twice as large, with half as many
 * going back takes up to twice as long, and the time to record is the same. */
enum { KEYFRAMES = 120 };

/* A recording under way. */
typedef struct tape {
    FILE *file;
    int keyframes; /* steps from one to the next */
    const scene *scene;
    thud_recorder *recorder;
    bool failed;
} tape;

static bool write_bytes(const void *bytes, size_t count, void *context) {
    tape *t = context;
    t->failed |= fwrite(bytes, 1, count, t->file) != count;
    return !t->failed;
}

/* Notes how the recording is to be shown. */
static thud_result note_view(const tape *t) {
    char json[SCENE_SHOWN_MAX];
    size_t length = scene_shown(t->scene, json);
    return thud_recorder_add_chunk(t->recorder, SCENE_SHOWN, (thud_bytes){json, length});
}

/* Every step has a hash of each body, so that the first that differs is named. */
static bool begin(thud_world *world, void *context) {
    tape *t = context;
    thud_recorder_options options = {.hash_steps = 1,
                                     .body_hashes = true,
                                     .keyframe_steps = t->keyframes,
                                     .sink = write_bytes,
                                     .context = t};
    thud_result result = thud_recorder_begin(world, &options, &t->recorder);
    result = result == THUD_OK ? note_view(t) : result;
    t->failed |= result != THUD_OK;
    return result == THUD_OK;
}

static bool go_on(thud_world *world, const run_outcome *so_far, void *context) {
    (void)world;
    (void)so_far;
    return !((const tape *)context)->failed;
}

bool record_scene(const run_options *options, const scene *s, run_outcome *out) {
    tape t = {.file = fopen(options->record, "wb"),
              .keyframes = options->keyframes < 0 ? KEYFRAMES : (int)options->keyframes,
              .scene = s};
    if (!t.file) {
        fprintf(stderr, "thud-run: cannot write %s\n", options->record);
        return false;
    }
    run_watch watch = {.built = begin, .stepped = go_on, .context = &t};
    bool done = run_scene(options, s, &watch, out);
    /* The run has destroyed its world, with which the recording ended. */
    thud_recorder_end(t.recorder);
    t.failed |= fclose(t.file) != 0;
    if (t.failed)
        fprintf(stderr, "thud-run: %s cannot be written\n", options->record);
    return done && !t.failed;
}

/* ---- playing ---- */

/* Reads a file whole. Null after a message. */
static char *read_file(const char *path, size_t *bytes) {
    char *text = whole_file_read(path, SIZE_MAX - 1, bytes);
    if (!text)
        fprintf(stderr, "thud-run: cannot read %s\n", path);
    return text;
}

/* The context is whether there is something to tell. */
static void log_to_stderr(thud_result result, const char *message, void *context) {
    (void)result;
    if (*(const bool *)context)
        fprintf(stderr, "thud: %s\n", message);
}

/* Says where a recording differs. */
static void tell_difference(const thud_player_progress *p) {
    fprintf(stderr, "thud-run: the state differs after step %" PRId64 ", at step %" PRId64,
            p->differs_after, p->differs_at);
    if (p->body.index1)
        fprintf(stderr, ", first in the body of slot %" PRIu32, p->body.index1 - 1);
    fprintf(stderr, "\n");
}

/* Plays all steps, and prints how that ended. */
static bool play(const run_options *options, thud_player *player) {
    thud_player_progress p;
    thud_world *world = NULL;
    thud_result result = THUD_OK;
    for (bool stepped = true; stepped && result == THUD_OK;)
        result = thud_player_step(player, &stepped);
    thud_player_get_progress(player, &p);
    thud_player_get_world(player, &world);
    if (p.differs)
        tell_difference(&p);
    if (result != THUD_OK)
        return false;
    uint64_t hash = thud_hash_of(world);
    const char *text = options->json ? "{\"steps\": %" PRId64 ", \"hashes\": %" PRId64
                                       ", \"hash\": \"%016" PRIx64 "\"}\n"
                                     : "%" PRId64 " steps, %" PRId64
                                       " hashes are the same, hash %016" PRIx64 "\n";
    printf(text, p.steps - p.first, p.hashes, hash);
    return true;
}

bool replay_file(const run_options *options) {
    size_t count;
    char *bytes = read_file(options->replay, &count);
    if (!bytes)
        return false;
    thud_threads *threads = NULL;
    if (options->workers > 1 && thud_threads_create(options->workers, NULL, &threads) != THUD_OK)
        fprintf(stderr, "thud-run: threads cannot be created; playing on one thread\n");
    bool tells = true;
    thud_player_options how = {.log = log_to_stderr,
                               .log_context = &tells,
                               .job_system = thud_job_system_of(threads)};
    thud_player *player = NULL;
    bool (*act)(const run_options *options, thud_player *player) = play;
    if (options->bisect)
        act = bisect_builds;
    else if (options->hashes[2] > 0)
        act = bisect_print_hashes;
    else if (options->hash_at >= 0)
        act = bisect_print_bodies;
    bool done = thud_player_create((thud_bytes){bytes, count}, &how, &player) == THUD_OK;
    tells = act == play; /* that builds differ is told by what they print */
    done = done && act(options, player);
    thud_player_destroy(player);
    thud_threads_destroy(threads);
    free(bytes);
    return done;
}
