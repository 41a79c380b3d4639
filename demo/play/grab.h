/* grab.h: pulls a body towards the pointer, by impulses at the point where it was taken. */
#ifndef THUD_PLAY_GRAB_H
#define THUD_PLAY_GRAB_H

#include "session.h"

typedef struct grab {
    bool held;
    thud_body_id body;
    thud_vec2 local;      /* the point taken, in the body's frame */
    thud_pos target;      /* where it is pulled to */
    uint64_t pulled_step; /* number of the last step that was given an impulse, plus one */
} grab;

bool grab_start(grab *g, session *s, thud_pos at, double margin);
void grab_move(grab *g, thud_pos to);
void grab_end(grab *g);
/* Call before every advance. Lets go when the body is gone. */
void grab_pull(grab *g, session *s);
/* Where the point taken is now, at the session's alpha-less present. False if nothing is held. */
bool grab_anchor(const grab *g, const session *s, thud_pos *out);

#endif
