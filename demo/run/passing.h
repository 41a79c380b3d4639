/* passing.h: counts the dynamic bodies that go through static shapes, independently of how a world
 * detects collisions.
 *
 * A body passed in a step if the straight line of its centre of mass from before the step to after
 * it enters a static shape with which it collides. A body that has gone through a wall within a
 * step overlaps nothing afterwards, so that a setting of the engine that lets this happen would
 * seem accurate if overlaps alone were measured. Pairs that a rule lets pass, or that collide on
 * one side only, do not count, nor do two moving bodies. */
#ifndef THUD_RUN_PASSING_H
#define THUD_RUN_PASSING_H

#include <thud/thud.h>

/* Where the body of a slot was before the step. */
typedef struct passing_place {
    thud_body_id body; /* null: none that moves */
    thud_pos center;
} passing_place;

/* All zero: empty. */
typedef struct passing {
    passing_place *places;
    int count, capacity;
} passing;

/* Keeps where all awake dynamic bodies are. */
thud_result passing_before(passing *p, thud_world *world);
/* Adds to *count the bodies that have passed since passing_before. */
thud_result passing_after(const passing *p, thud_world *world, long *count);
void passing_free(passing *p);

#endif
