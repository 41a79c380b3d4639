/* project.h: what the solver left of motion into each other is taken out of the motion of the step,
 * so that contacts under load are no collisions.
 *
 * All touching pairs at once, by projected Gauss-Seidel passes with over-relaxation over their
 * blocks: a point ends no nearer than td_project_context.nearest, or where it began if that is
 * nearer, and where this pushes, velocities do not close either. */
#ifndef TD_PROJECT_H
#define TD_PROJECT_H

#include "constraint/block.h"

/* What the points of a block were given so far, along their normals. */
typedef struct td_pushes {
    f8 motion[2];   /* mass times length */
    f8 velocity[2]; /* impulse */
} td_pushes;

typedef struct td_project_context {
    float (*delta)[4];        /* by awake slot: motion of the step */
    float (*velocity)[4];     /* by awake slot: the fourth is the inverse mass */
    const float (*reach)[2];  /* by awake slot: the second is how far a body reaches */
    float over_relaxation;    /* over-relaxation: 1 is none */
    float skin;               /* separations are measured from here */
    float target_distance;    /* no point is to end nearer ... */
    float tolerance;          /* ... but by so much */
    float collision_distance; /* nearer is a collision, if the point came nearer by `pressed` */
    float closing_max;
    const int32_t *next_tied; /* by awake slot, where joints tie bodies: the next one; else null */
    float margin;             /* contacts begin here: points that are not there are further apart */
} td_project_context;

/* A pass over blocks of one number of points, with side a static or not. Leaves the separations
 * that it found; whether a point lacked more than `enough`. */
typedef bool td_project_fn(td_block *const *blocks, td_pushes *pushes, int count, int points,
                           bool fixed, const td_project_context *context);

/* Sets td_block.apart. Where no pair `turns`, the rows say all; or else turns take points off the
 * line that the rows take them for. */
typedef void td_find_open_fn(td_block *const *blocks, int count, int points, bool turns,
                             const td_project_context *context);

#endif
