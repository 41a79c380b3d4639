/* playback.h: a recording that is shown in place of a scene: it can be played, any step of it can
 * be sought, and from any step on the user can take over the world, which then no longer follows
 * the recording (a fork). */
#ifndef THUD_PLAY_PLAYBACK_H
#define THUD_PLAY_PLAYBACK_H

#include <thud/thud.h>
#include <thud/thud_recording.h>
#include <thud/thud_threads.h>

enum {
    PLAYBACK_TEXT_MAX = 160,    /* characters of a call, its terminating 0 included */
    PLAYBACK_CALLS_MAX = 100,   /* calls of a step that are kept; further ones are counted */
    PLAYBACK_QUERIES_MAX = 200, /* queries of a step that are kept, and hits of each */
    PLAYBACK_HITS_MAX = 16,
    PLAYBACK_WHY_MAX = 240 /* characters of the reason why there is nothing to play */
};

/* A query of a step: the shape with which it looked, how far it moved that, and what it found. */
typedef struct playback_query {
    bool ray;            /* it is a ray: only the centre of `shape` counts */
    thud_geometry shape; /* where it began, in the world */
    double dx, dy;       /* how far it moved; 0 for an overlap */
    bool points;         /* its hits have points */
    thud_ray_hit hits[PLAYBACK_HITS_MAX];
    int hit_count;
} playback_query;

/* How the recording says that it is to be shown: height and width 0: it does not. */
typedef struct playback_view {
    double x, y, height, width; /* centre and size of the first view */
    double length_scale;        /* of the scene that was recorded; 1 where that is not known */
} playback_view;

typedef struct playback {
    thud_player *player;
    thud_world *world;    /* the player's */
    thud_clock_fn *clock; /* seconds; its context is null */
    char *bytes;          /* the file */
    char *name;           /* its name, without folder and suffix */
    thud_player_progress progress;
    playback_view view;
    bool stopped; /* the next step cannot be played: the world differs from the recording, or memory
                     is short */
    bool forked;  /* the world no longer follows the recording; `progress` stays at the step where
                     that began */
    int64_t forked_steps; /* made by hand since */
    int64_t target;       /* the step that the present seek goes to; -1: there is no seek */
    /* A call may have made, changed or destroyed bodies, shapes or joints since this was last
     * false. */
    bool changed;
    /* The calls that led to the present step. */
    char calls[PLAYBACK_CALLS_MAX][PLAYBACK_TEXT_MAX];
    int call_count;
    playback_query queries[PLAYBACK_QUERIES_MAX]; /* the queries among them */
    int query_count;
    void (*log)(thud_result result, const char *text, void *context); /* of the world, once open */
    void *log_context;
    char why[PLAYBACK_WHY_MAX]; /* what the player has said last */
} playback;

/* Whether a file begins as recordings do. */
bool playback_is_recording(const char *path);

/* Opens a recording, at its first step; it is to be closed. Null, with the reason in `why`
 * (PLAYBACK_WHY_MAX characters), if the file cannot be read or played, or memory runs out. */
playback *playback_open(const char *path, thud_threads *threads, thud_clock_fn *clock, char *why);
/* Also destroys the world. Null does nothing. */
void playback_close(playback *p);

/* Whether a further step can be played: the end is not reached, and the world does not differ from
 * the recording. */
bool playback_goes_on(const playback *p);
/* Plays the next step of the recording; in a fork, steps the world instead. Does nothing at the
 * end. */
void playback_step(playback *p);
/* Begins to seek a step, the nearest that the recording has; a fork ends. Calls of playback_work do
 * the seeking. */
void playback_seek(playback *p, int64_t step);
/* Continues a seek for about `seconds` at most. True if it is not yet at its end. */
bool playback_work(playback *p, double seconds);
/* From now on the world no longer follows the recording (a fork). False at a step that differs. */
bool playback_fork(playback *p);

/* Says where the recording differs from what happens, into PLAYBACK_WHY_MAX characters. */
void playback_tell_difference(const playback *p, char *out);

#endif
