/* grab.h: pulls a body towards the pointer with a target joint, at the point where it was grabbed.
 */
#ifndef THUD_PLAY_GRAB_H
#define THUD_PLAY_GRAB_H

#include "session.h"

typedef struct grab {
    bool held;
    thud_body_id body;
    thud_body_id pin; /* static, at the point where the body was grabbed; the joint's frame in it is
                         the target */
    thud_joint_id joint;
    thud_vec2 local; /* the grabbed point in the body's frame */
    thud_pos from;   /* position of the pin */
    thud_pos target;
} grab;

/* Grabs the body at `at`. False if no dynamic body is within `margin`, or if the world refuses. */
bool grab_start(grab *g, session *s, thud_pos at, double margin);
/* Moves the target. Releases the body if its joint no longer exists. */
void grab_move(grab *g, session *s, thud_pos to);
/* Releases the body, if one is held. Has to be called before the world is destroyed. */
void grab_end(grab *g, session *s);
/* The grabbed point in the world after the last step. False if nothing is held. */
bool grab_anchor(const grab *g, const session *s, thud_pos *out);

#endif
