/* crowd.h: circles that fly through each other in a closed box: as many, as large, as dense, as
 * fast and as many of them moving as wanted. As they do not collide, it all stays so. */
#ifndef THUD_BENCH_CROWD_H
#define THUD_BENCH_CROWD_H

#include "scenes.h"

#include <thud/thud.h>

typedef struct crowd {
    int bodies;
    double area;        /* square metres of the box for each */
    double least, most; /* radii; of every octave between them half as many as of the one below */
    double moving;      /* share of the bodies that move */
    double speed;       /* theirs */
} crowd;

/* An initialised scene's. The walls come first. */
void crowd_fill(const crowd *c, scene *s);

/* The box's area for each body so that the circles' own areas add up to `part` of it. */
double crowd_area_filled(const crowd *c, double part);

/* Pairs stay pairs and are found, tested and reported, but only walls throw anything back. */
void crowd_passes_through(thud_world *world);

/* How many pairs of circles overlap where the scene puts them: each against each. */
long crowd_overlaps(const scene *s);

#endif
