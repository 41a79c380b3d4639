/* oracles.h: what must hold of a session's world after a step, and in the end. */
#ifndef FUZZ_ORACLES_H
#define FUZZ_ORACLES_H

#include "session.h"

/* Books the step's events, asks every body and figure whether it is finite, every count whether it
 * can be, and notes all of it for the twin. */
void oracle_step(fuzz_session *s);

/* Destroys every body and steps: no pair may be left open. */
void oracle_end(fuzz_session *s);

#endif
