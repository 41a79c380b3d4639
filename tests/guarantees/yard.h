/* yard.h: a lively world for guarantees: a closed box with tiles and a hill for its floor, balls
 * and boxes, a plate that moves to and fro, sensors; what more is asked for; and edits of it by a
 * seed, the same for each yard of a trial. */
#ifndef YARD_H
#define YARD_H

#include "trial.h"

#include <thud/thud_terrain.h>

enum { YARD_BODIES = 12, YARD_JOINTS = 7 };

/* What a yard may have besides. */
typedef enum yard_feature {
    YARD_TIED = 1,   /* of all kinds but gears, and locks that come and go */
    YARD_FIELDS = 2, /* wind, water, rolling resistance, grip before each step; explosions */
    YARD_RULES = 4,  /* between kinds of bodies; they change */
    YARD_ALL = 7
} yard_feature;

typedef struct yard {
    trial *t;
    thud_world *world;
    thud_body_id body[YARD_BODIES], plate, floor, ground;
    thud_shape_id line;
    source random; /* of the edits */
    double away;   /* by how many units all is shifted to the right, and up by as many */
    int steps;
    unsigned features;
} yard;

/* Its world made by this def, but for gravity, which stays; `features` are yard_feature bits. */
void yard_make_with(yard *y, trial *t, thud_world_def def, double away, unsigned features);
/* With joints. */
void yard_make(yard *y, trial *t, thud_world_def def, double away);
/* Without them, which pull bodies to each other through whatever is in the way. */
void yard_make_loose(yard *y, trial *t, thud_world_def def, double away);
/* A few random edits; most often none. */
void yard_edit(yard *y);
/* Edits, and then one step. */
void yard_step(yard *y);
/* The same, where the step may be refused: the edits alone. */
void yard_before_step(yard *y);

/* All that a caller can tell of the last step, wherever the yard stands and whatever its handles'
 * generations, in one number. */
uint64_t yard_told(const yard *y);

/* The corner from which everything is told. */
thud_pos yard_origin(const yard *y);

/* Mixes bytes into a number. */
void yard_mix(uint64_t *digest, const void *bytes, size_t count);

#endif
