/* session_parts.h: what session.c and session_played.c have in common. */
#ifndef THUD_PLAY_SESSION_PARTS_H
#define THUD_PLAY_SESSION_PARTS_H

#include "session.h"

/* ---- session.c ---- */

/* Seconds of a clock that never goes back; a thud_clock_fn. */
double session_clock(void *context);
/* A world's log function: stores the text in the message of the session, its context. */
void session_log(thud_result result, const char *text, void *context);
/* Doubles *capacity until `wanted` elements of `size` bytes fit in *block. False if memory runs
 * out. */
bool session_grow(void **block, int *capacity, int wanted, size_t size);

/* Destroys the world, with the recording that it belongs to. */
void session_destroy_world(session *s);
/* Shows a new world, whose bodies and joints are to be listed. */
void session_show_world(session *s, thud_world *world, scene fresh, double time_step);
/* List all bodies of a new world, and its joints, which are in the order of the scene's. False
 * after a message, if memory runs out. */
bool session_list_bodies(session *s, const thud_body_id *ids, int count);
bool session_list_joints(session *s);

/* ---- session_played.c ---- */

/* Lists bodies and joints of a recording anew where a call may have changed them. False after a
 * message, if memory runs out. */
bool session_list_played(session *s);
/* Pauses at the end of the recording, or where it differs, which is told. */
void session_tell_end(session *s);
/* Goes on with a seek in a recording. True if there was one. */
bool session_go_on_seeking(session *s);

#endif
