/* crash.h: saves the last seconds when the viewer crashes, to be attached to a report. */
#ifndef THUD_PLAY_CRASH_H
#define THUD_PLAY_CRASH_H

#include "session.h"

/* From now on a crash saves the last seconds of the session (last_seconds_salvage), writes the
 * file's path to standard error, and then ends the program as it would have ended without this. Has
 * to be called with null before the session is destroyed, which switches it off. */
void crash_watch(session *s);

#endif
