/* crowd.h: a scene of circles that fly through each other in a closed box, with a given number,
 * range of sizes, density, speed and share of moving circles. They do not collide, so these do not
 * change. */
#ifndef THUD_BENCH_CROWD_H
#define THUD_BENCH_CROWD_H

#include "scenes.h"

#include <thud/thud.h>

typedef struct crowd {
    int bodies;
    double area;        /* m^2 of the box for each circle */
    double least, most; /* m, range of the radii; each octave has half as many circles as the one
                           below it */
    double moving;      /* share of the bodies that move */
    double speed;       /* m/s, of the bodies that move */
} crowd;

/* Fills an initialised scene. The four walls come first. */
void crowd_fill(const crowd *c, scene *s);

/* The `area` at which the circles cover the share `part` of the box. */
double crowd_area_filled(const crowd *c, double part);

/* Sets a prologue that vetoes contacts between circles: pairs are found, tested and reported as
 * usual, but only walls make circles bounce. */
void crowd_passes_through(thud_world *world);

/* The number of pairs of circles that overlap in the scene, by a test of all pairs. */
long crowd_overlaps(const scene *s);

#endif
