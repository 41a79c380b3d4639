/* last_seconds.c: see last_seconds.h. */
#include "last_seconds.h"

#include <math.h>
#include <stdio.h>

/* Keyframes in what is kept: the recording begins at one, so that it has up to a part more. Few,
 * since packing a world takes as long as some of its steps, which a user might see. */
enum { PARTS = 2, FILES_MAX = 999 };

/* Notes how the recording is to be shown. A player reads that at its first step, and a ring begins
 * at a keyframe: it is noted after each. */
static void note_view(const last_seconds *l, const scene *s) {
    char json[SCENE_SHOWN_MAX];
    size_t length = scene_shown(s, json);
    thud_recorder_add_chunk(l->recorder, SCENE_SHOWN, (thud_bytes){json, length});
}

void last_seconds_begin(last_seconds *l, thud_world *world, double time_step, const scene *s) {
    int part = (int)fmax(1, ceil(LAST_SECONDS / time_step / PARTS));
    thud_recorder_options options = {.body_hashes = true,
                                     .keyframe_steps = part,
                                     .ring_steps = PARTS * part,
                                     .queries = true};
    *l = (last_seconds){.keyframe_steps = part};
    if (thud_recorder_begin(world, &options, &l->recorder) != THUD_OK)
        l->recorder = NULL;
    else
        note_view(l, s);
}

void last_seconds_stepped(last_seconds *l, const scene *s) {
    if (!l->recorder || ++l->steps < l->keyframe_steps)
        return;
    l->steps = 0;
    note_view(l, s);
}

void last_seconds_end(last_seconds *l) {
    thud_recorder_end(l->recorder);
    l->recorder = NULL;
}

/* Writes a recording to NAME-1.rec, or the next number that is free. False if that fails; `path`
 * says where. */
static bool write_file(thud_bytes bytes, const scene *s, char path[LAST_SECONDS_PATH]) {
    FILE *file = NULL;
    for (int i = 1; i <= FILES_MAX && !file; i++) {
        snprintf(path, LAST_SECONDS_PATH, "%.180s-%d.rec", s->name, i);
        file = fopen(path, "wbx"); /* x: not a file that is there */
    }
    bool written = file && fwrite(bytes.data, 1, bytes.count, file) == bytes.count;
    if (file)
        written &= fclose(file) == 0;
    return written;
}

bool last_seconds_save(last_seconds *l, const scene *s, char *message, size_t message_size) {
    char path[LAST_SECONDS_PATH];
    thud_bytes bytes;
    if (!l->recorder || thud_recorder_get_bytes(l->recorder, &bytes) != THUD_OK) {
        snprintf(message, message_size, "Nothing is recorded.");
        return false;
    }
    bool written = write_file(bytes, s, path);
    if (written)
        snprintf(message, message_size, "The last %d s are in %s, %.0f kB: thud-play shows it.",
                 LAST_SECONDS, path, ceil((double)bytes.count / 1000));
    else
        snprintf(message, message_size, "%s cannot be written here.", path);
    return written;
}

bool last_seconds_salvage(last_seconds *l, const scene *s, char path[LAST_SECONDS_PATH]) {
    thud_bytes bytes;
    thud_recorder *recorder = l->recorder;
    l->recorder = NULL; /* it cannot be used any more */
    return thud_recorder_salvage(recorder, &bytes) == THUD_OK && write_file(bytes, s, path);
}
