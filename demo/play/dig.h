/* dig.h: changes the terrain at the pointer. */
#ifndef THUD_PLAY_DIG_H
#define THUD_PLAY_DIG_H

#include "session.h"

/* Both change every terrain line with vertices; if the scene has none, the message says so. */
void dig_crater(session *s, thud_pos at);
void dig_mound(session *s, thud_pos at);

#endif
