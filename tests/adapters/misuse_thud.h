/* misuse_thud.h: see misuse_thud.c. */
#ifndef THUD_ADAPTERS_MISUSE_THUD_H
#define THUD_ADAPTERS_MISUSE_THUD_H

#include "misuse.h"

#include <thud/thud.h>

/* True if the call was refused. */
bool misuse_thud(thud_world *w, thud_body_id body, misuse call, double x);

#endif
