/* manifold.h: the public thud_manifold of a touching contact, for queries and drawing. */
#ifndef TD_MANIFOLD_H
#define TD_MANIFOLD_H

#include "state/world.h"

/* The contact must hold a lane. Impulses are those of the whole step. */
thud_manifold td_manifold_of(const thud_world *w, const td_contact *contact);

#endif
