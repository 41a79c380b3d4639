/* crash.h: saves the last seconds when the viewer crashes, to be attached to a report. */
#ifndef THUD_PLAY_CRASH_H
#define THUD_PLAY_CRASH_H

#include "session.h"

/* From now on a crash saves what led to it (last_seconds_salvage), says where on standard error,
 * and then ends the program as it would have ended. Null ends that: to be called before the session
 * is gone. */
void crash_watch(session *s);

#endif
