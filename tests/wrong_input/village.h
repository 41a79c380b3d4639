/* village.h: a small world with an object of every kind, of which some always move, and a text of
 * everything that the public API shows of it: equal texts mean equal worlds. */
#ifndef VILLAGE_H
#define VILLAGE_H

#include "engine_support.h"

#include <thud/thud_mover.h>

typedef struct village {
    thud_world *world;
    thud_body_id floor, ball, box, plank, lift, switched_off, bare;
    thud_shape_id ball_shape, box_shape, plank_shape, hill, dunes, plain;
    thud_body_id gone; /* destroyed; its slot has a new body */
    thud_shape_id gone_shape;
    thud_mover mover;
    int told; /* number of log messages */
} village;

/* Two villages with the same def are equal bit for bit. The village replaces the def's log hook. */
void village_make(village *v, thud_world_def def);
void village_step(village *v);
void village_free(village *v);

/* Statistics (without times), energies, every body, shape and line, and the mover, as text that the
 * caller frees. Pending edits are applied, as by every query. */
char *village_text(const village *v);

/* The text of one body. */
void village_body_text(const thud_world *world, thud_body_id body, char *out, size_t size);

#endif
