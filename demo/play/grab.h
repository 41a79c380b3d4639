/* grab.h: pulls a body towards the pointer by the point where it was taken, with a target joint. */
#ifndef THUD_PLAY_GRAB_H
#define THUD_PLAY_GRAB_H

#include "session.h"

typedef struct grab {
    bool held;
    thud_body_id body;
    thud_body_id pin; /* stands where the body was taken; the joint's frame in it is the target */
    thud_joint_id joint;
    thud_vec2 local; /* the point taken, in the body's frame */
    thud_pos from;   /* where the pin stands */
    thud_pos target;
} grab;

/* False where no moving body is there, or where the world refuses. */
bool grab_start(grab *g, session *s, thud_pos at, double margin);
/* Lets go when the body is gone. */
void grab_move(grab *g, session *s, thud_pos to);
/* Call before the world goes; fine where nothing is held. */
void grab_end(grab *g, session *s);
/* Where the point taken is after the last step. False if nothing is held. */
bool grab_anchor(const grab *g, const session *s, thud_pos *out);

#endif
