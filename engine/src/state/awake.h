/* awake.h: the dense arrays of bodies that move. Slot 0 is a dummy at rest. */
#ifndef TD_AWAKE_H
#define TD_AWAKE_H

#include "state/world.h"

/* Room for every live body and `more`, so that waking never needs memory. */
bool td_awake_reserve(thud_world *w, int more);
void td_awake_add(thud_world *w, int body);    /* velocity comes from the body's record */
void td_awake_remove(thud_world *w, int body); /* ... and goes back there */
/* Copies mass, damping and reach of the body's record to its slot, if it has one. */
void td_awake_refresh(thud_world *w, int body);

#endif
