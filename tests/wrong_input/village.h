/* village.h: a small world with something of every kind in it, some of it always in motion, and all
 * that the public API tells of it as text: two texts that are equal are two worlds that are. */
#ifndef VILLAGE_H
#define VILLAGE_H

#include "engine_support.h"

#include <thud/thud_mover.h>

typedef struct village {
    thud_world *world;
    thud_body_id floor, ball, box, plank, lift, switched_off, bare;
    thud_shape_id ball_shape, box_shape, plank_shape, hill, dunes, plain;
    thud_body_id gone; /* destroyed, and its slot lives again */
    thud_shape_id gone_shape;
    thud_mover mover;
    int told; /* messages of the log */
} village;

/* Made anew from the same def, two villages are alike to the bit. The log is the village's own. */
void village_make(village *v, thud_world_def def);
void village_step(village *v);
void village_free(village *v);

/* Statistics (without times), energies, every body and shape, every line, the mover. Owned by the
 * caller, who frees it. Applies edits, as every query does. */
char *village_text(const village *v);

/* As above, of one body. */
void village_body_text(const thud_world *world, thud_body_id body, char *out, size_t size);

#endif
