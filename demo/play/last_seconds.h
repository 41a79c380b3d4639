/* last_seconds.h: the last seconds of a scene, which are recorded all the time, so that a user who
 * has seen a fault can save what led to it. */
#ifndef THUD_PLAY_LAST_SECONDS_H
#define THUD_PLAY_LAST_SECONDS_H

#include <scene.h>
#include <thud/thud_recording.h>

enum {
    LAST_SECONDS = 30,
    LAST_SECONDS_PATH = 200 /* characters of a file's path, its terminating 0 included */
};

typedef struct last_seconds {
    thud_recorder *recorder; /* null: nothing is recorded, because memory was short */
    int keyframe_steps;      /* from one keyframe to the next */
    int steps;               /* since the last one */
} last_seconds;

/* Begins to record a world. */
void last_seconds_begin(last_seconds *l, thud_world *world, double time_step, const scene *s);
/* Has to be called after each step. */
void last_seconds_stepped(last_seconds *l, const scene *s);
/* Has to be called before the world is destroyed. */
void last_seconds_end(last_seconds *l);

/* Saves the last seconds as a file in the present folder, NAME-1.rec or the next number that is
 * free, where NAME is the scene's. False if that fails. Either way `message` says so. */
bool last_seconds_save(last_seconds *l, const scene *s, char *message, size_t message_size);
/* The same in a crash, with the step under way as the last one (thud_recorder_salvage). False if
 * nothing was recorded or written; else its file is at `path`. Afterwards nothing is recorded. */
bool last_seconds_salvage(last_seconds *l, const scene *s, char path[LAST_SECONDS_PATH]);

#endif
