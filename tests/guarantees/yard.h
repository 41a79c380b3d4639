/* yard.h: a scene with many features for guarantees: a closed box whose floor is made of tiles and
 * a terrain line, balls and boxes, a plate that moves to and fro, sensors; joints, fields and rules
 * on request. A seed draws edits of it, the same ones for each yard of a trial. */
#ifndef YARD_H
#define YARD_H

#include "trial.h"

#include <thud/thud_terrain.h>

enum { YARD_BODIES = 12, YARD_JOINTS = 7 };

/* Optional features, as bits. */
typedef enum yard_feature {
    YARD_TIED = 1, /* joints of all kinds except gears, and locked axes that edits set and clear */
    YARD_FIELDS = 2, /* wind, water, rolling resistance and grip before each step; explosions */
    YARD_RULES = 4,  /* rules between categories of bodies, which edits change */
    YARD_ALL = 7
} yard_feature;

typedef struct yard {
    trial *t;
    thud_world *world;
    thud_body_id body[YARD_BODIES], plate, floor, ground;
    thud_shape_id line;
    source random; /* source of the edits' random numbers */
    double away;   /* shift of the whole yard to the right and upwards, in world units */
    int steps;
    unsigned features;
} yard;

/* Creates the world by this def; `features` are yard_feature bits. */
void yard_make_with(yard *y, trial *t, thud_world_def def, double away, unsigned features);
/* With YARD_TIED. */
void yard_make(yard *y, trial *t, thud_world_def def, double away);
/* Without joints, which pull bodies towards each other through shapes in between. */
void yard_make_loose(yard *y, trial *t, thud_world_def def, double away);
/* Makes a random edit, in most calls none. */
void yard_edit(yard *y);
/* Edits, followed by one step. */
void yard_step(yard *y);
/* The edits of yard_step alone, for callers that make the step themselves because it may be
 * refused. */
void yard_before_step(yard *y);

/* A digest of everything that a caller can read about the last step. It does not depend on the
 * yard's place and on the generations of handles. */
uint64_t yard_told(const yard *y);

/* The middle of the floor, from which the yard's positions are measured. */
thud_pos yard_origin(const yard *y);

/* Mixes bytes into a digest (FNV-1a). */
void yard_mix(uint64_t *digest, const void *bytes, size_t count);

#endif
