/* session.h: the world that is shown: its scene, its bodies for drawing, and its time. */
#ifndef THUD_PLAY_SESSION_H
#define THUD_PLAY_SESSION_H

#include "panel/catalog.h"
#include "last_seconds.h"
#include "playback.h"

#include <choices.h>
#include <thud/thud_joint.h>
#include <thud/thud_threads.h>

/* What drawing needs of a shape. It is read once, since a shape does not change within its body. */
typedef struct session_shape {
    thud_shape_id id;
    thud_shape_kind kind;
    thud_vec2 offset, half; /* in the body's frame */
    float c, s;
    bool sensor;
} session_shape;

typedef struct session_body {
    thud_body_id id;
    thud_body_kind kind;
    int look;    /* as in scene_body */
    float reach; /* max distance of its shapes from the body's origin; infinite for terrain */
    int first_shape, shape_count;
} session_body;

/* What collision detection could not do, summed over all steps of a world. */
typedef struct session_missed {
    long held;      /* times that a body was held before the end of a step */
    double seconds; /* the times that these bodies lost, s */
    long fast;      /* times that a body was too fast for bisection */
} session_missed;

/* An explosion that a user triggered, while its ring is drawn. */
typedef struct session_blast {
    thud_pos at;
    double step; /* number of the world's steps before it; negative: none */
} session_blast;

/* Max number of rings that are drawn at the same time. */
enum { SESSION_BLASTS = 8 };

typedef struct session session;

/* Called after every step. */
typedef void session_stepped_fn(session *s, void *context);

struct session {
    thud_world *world; /* null until a scene or a recording was loaded */
    playback *played;  /* the recording that is shown, to which the world belongs; or null */
    last_seconds last; /* recorded of a scene, not of a recording */
    scene scene;       /* of a recording: what drawing needs of one */
    session_body *bodies;
    session_shape *shapes;
    int body_count, body_capacity, shape_count, shape_capacity;
    thud_joint_id *joints; /* in the order of scene.joints */
    int joint_count, joint_capacity;
    int quality;               /* index in QUALITIES of choices.h */
    int detection, broadphase; /* indices in DETECTIONS and BROADPHASES; they take effect when a
                                  scene is loaded */
    int step_rate; /* steps a second; 0: the engine's default. It and the next take effect when a
                      scene is loaded */
    int top_speed; /* thud_world_def.maximum_speed, length scales a second; 0: the default */
    thud_threads *threads; /* of the world's steps, owned; or null. Set before a scene is loaded */
    bool paused;
    double speed;     /* world seconds per real second */
    double time_step; /* of the world, s */
    double alpha;     /* interpolation for thud_world_get_poses, [0, 1] */
    session_missed missed;
    session_blast blasts[SESSION_BLASTS];
    int next_blast;              /* index of the oldest in `blasts` */
    session_stepped_fn *stepped; /* or null */
    void *stepped_context;
    int pair[2]; /* the chosen kinds, whose rule a user sets; the first is not after the second */
    char message[256]; /* the last error or notice; else empty */
};

void session_init(session *s);
void session_free(session *s);

/* Builds the world of an entry. False, and `message` says why, if that fails; then the old world
 * stays. */
bool session_load(session *s, const catalog_entry *entry);

/* Opens a recording, at its first step. False, and `message` says why, if that fails; then the old
 * world stays. */
bool session_open_recording(session *s, const char *path);
/* Goes to a step of the recording, of those that there are, during the next frames; a fork ends. */
void session_seek(session *s, int64_t step);
/* From this step of the recording on the world goes on by hand; or, in a fork, back to that step of
 * the recording. */
void session_fork(session *s);
/* Saves the last seconds of a scene as a recording; `message` says where, or why not. */
void session_save_last(session *s);
/* Whether users may change the world. `message` says why not where a recording plays. */
bool session_yields(session *s);

/* Runs the steps that are due after `elapsed` real seconds at the session's speed; none while
 * paused. */
void session_advance(session *s, double elapsed);
void session_step(session *s); /* runs one step */
void session_set_quality(session *s, int quality);
/* The world's quality, as an index in QUALITIES; -1: it is none of them. */
int session_quality(const session *s);
/* The detection that is shown, as an index in DETECTIONS: of a recording its world's, which is
 * never "auto"; of a scene the choice. */
int session_detection(const session *s);

/* Adds a dynamic body of `size` length scales at a place. */
void session_spawn(session *s, thud_shape_kind kind, thud_pos at, float size);

/* The first chooses the next pair of kinds, of those whose rules a user may set; the second sets
 * the next rule of the chosen pair. `message` says which. */
void session_next_pair(session *s);
void session_next_meeting(session *s);

/* Triggers an explosion at a place. Bodies in between shield others from it. */
void session_explode(session *s, thud_pos at);

/* Finds the body of this kind with a shape within `margin` of a place. False if there is none. */
bool session_pick(session *s, thud_pos at, double margin, thud_body_kind kind, thud_body_id *out);
/* Destroys a body and removes it from the list. */
void session_remove(session *s, thud_body_id body);

#endif
