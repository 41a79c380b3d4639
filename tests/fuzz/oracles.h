/* oracles.h: checks of what must hold for a session's world after each step, and at the end. */
#ifndef FUZZ_ORACLES_H
#define FUZZ_ORACLES_H

#include "session.h"

/* Enters the step's events into the ledger, checks that all values of bodies and reports are finite
 * and all counts possible, and adds them to the digest. */
void oracle_step(fuzz_session *s);

/* Destroys every body and makes a step: no pair may stay open. */
void oracle_end(fuzz_session *s);

#endif
