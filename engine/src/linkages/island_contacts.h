/* island_contacts.h: whether what joints do to an island keeps its contacts. */
#ifndef TD_ISLAND_CONTACTS_H
#define TD_ISLAND_CONTACTS_H

#include "islands/island_solve.h"

/* A contact of one of its bodies, whether it is a row of the problem or not, ends the step deeper,
 * by more than `slack`, than it was and than the soft solver has it. Directions are those at the
 * start of the step. */
bool td_island_sinks(const td_island_work *work, double slack);

#endif
