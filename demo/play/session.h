/* session.h: the world on show: what it was made of, its bodies, its clock. */
#ifndef THUD_PLAY_SESSION_H
#define THUD_PLAY_SESSION_H

#include "panel/catalog.h"

#include <choices.h>
#include <thud/thud_joint.h>

/* What drawing needs of a shape, read once: shapes of thud do not change in their body. */
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
    int look;    /* as scene_body has it */
    float reach; /* no shape goes farther from the body's origin; infinite for terrain */
    int first_shape, shape_count;
} session_body;

/* What detection could not do, over all steps of a world. */
typedef struct session_missed {
    long held;      /* times that a body was held back before a step's end ... */
    double seconds; /* ... and what those lost, together */
    long fast;      /* times that a body was too fast for bisection */
} session_missed;

/* What a user set off, as long as it is to be seen. */
typedef struct session_blast {
    thud_pos at;
    double step; /* of the world, after which; below 0 once it is over */
} session_blast;

enum { SESSION_BLASTS = 8 };

typedef struct session session;

/* Called after every step. */
typedef void session_stepped_fn(session *s, void *context);

struct session {
    thud_world *world; /* null until something was loaded */
    scene scene;
    session_body *bodies;
    session_shape *shapes;
    int body_count, body_capacity, shape_count, shape_capacity;
    thud_joint_id *joints; /* of scene.joints */
    int joint_count;
    int quality;               /* of QUALITIES in choices.h */
    int detection, broadphase; /* of DETECTIONS and BROADPHASES; the next load heeds them */
    bool paused;
    double speed;     /* seconds of the world per second */
    double time_step; /* seconds */
    double alpha;     /* for thud_world_poses */
    session_missed missed;
    session_blast blasts[SESSION_BLASTS];
    int next_blast;              /* the place of the oldest one */
    session_stepped_fn *stepped; /* null: nobody asks */
    void *stepped_context;
    int pair[2];       /* of kinds, the first one not after the second */
    char message[256]; /* the last thing that went wrong; empty if nothing did */
};

void session_init(session *s);
void session_free(session *s);

/* Builds the entry's world anew. When that fails the old one stays, and the message says why. */
bool session_load(session *s, const catalog_entry *entry);

/* Runs as many steps as `elapsed` seconds ask for at the session's speed; none while paused. */
void session_advance(session *s, double elapsed);
void session_step(session *s); /* exactly one */
void session_set_quality(session *s, int quality);

/* Drops a new body of `size` times the scene's typical size at a place. */
void session_spawn(session *s, thud_shape_kind kind, thud_pos at, float size);

/* The next pair of kinds is chosen, of those whose rules a user sets, or what the chosen two are to
 * each other changes; the message tells. */
void session_next_pair(session *s);
void session_next_meeting(session *s);

/* An explosion at a place; what stands in between gives cover. */
void session_explode(session *s, thud_pos at);

/* The body whose shape lies under a place, within `margin`. False if there is none. */
bool session_pick(session *s, thud_pos at, double margin, thud_body_kind kind, thud_body_id *out);
void session_remove(session *s, thud_body_id body);

#endif
