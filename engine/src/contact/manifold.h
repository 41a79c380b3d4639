/* manifold.h: touching pairs with all their points, for those who ask and draw. */
#ifndef TD_MANIFOLD_H
#define TD_MANIFOLD_H

#include "state/world.h"

/* The contact must have a lane. */
thud_manifold td_manifold_of(const thud_world *w, const td_contact *contact);

#endif
