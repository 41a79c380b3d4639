/* misuse_box2d.h: see misuse_box2d.c. */
#ifndef THUD_ADAPTERS_MISUSE_BOX2D_H
#define THUD_ADAPTERS_MISUSE_BOX2D_H

#include "misuse.h"

#include <box2d/box2d.h>

void misuse_box2d(b2WorldId world, b2BodyId body, misuse call, double x);

#endif
