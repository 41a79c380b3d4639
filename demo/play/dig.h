/* dig.h: changes the ground at the pointer. */
#ifndef THUD_PLAY_DIG_H
#define THUD_PLAY_DIG_H

#include "session.h"

/* Both act on every ground line with vertices; where the scene has none, the message says so. */
void dig_crater(session *s, thud_pos at);
void dig_mound(session *s, thud_pos at);

#endif
