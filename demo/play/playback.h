/* playback.h: a recording that is shown in place of a scene: it is played, gone to any step of, and
 * from any step the world goes on by hand (a fork). */
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
    bool ray;            /* of `shape` the centre alone counts */
    thud_geometry shape; /* where it began, in the world */
    double dx, dy;       /* its way; 0 for an overlap */
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
    bool stopped;         /* what comes next cannot be played: it differs, or memory is short */
    bool forked;          /* the world goes on by hand; `progress` stays where that began */
    int64_t forked_steps; /* made by hand since */
    int64_t target;       /* the step that a seek under way goes to; -1: none is */
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

/* Whether steps can be played: the end is not reached, and nothing differs. */
bool playback_goes_on(const playback *p);
/* Plays the next step, or makes one by hand in a fork. Does nothing at the end. */
void playback_step(playback *p);
/* Begins to go to a step, of those that there are; a fork ends. playback_work goes there. */
void playback_seek(playback *p, int64_t step);
/* Goes on with a seek, for about so many seconds at most. True while it is under way. */
bool playback_work(playback *p, double seconds);
/* From now on the world goes on by hand. False at a step that differs. */
bool playback_fork(playback *p);

/* Says where the recording differs from what happens, into PLAYBACK_WHY_MAX characters. */
void playback_tell_difference(const playback *p, char *out);

#endif
