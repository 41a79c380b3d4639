/* choices.h: the qualities, detections and broadphases that a user chooses for a world, with their
 * names on command lines and in menus. */
#ifndef THUD_DEMO_CHOICES_H
#define THUD_DEMO_CHOICES_H

#include <thud/thud.h>

/* Lengths of the lists below. */
enum { QUALITY_CHOICES = 4, DETECTION_CHOICES = 5, BROADPHASE_CHOICES = 6 };

typedef struct detection_choice {
    const char *name;
    const thud_detection *detection;
} detection_choice;

typedef struct broadphase_choice {
    const char *name;
    const thud_broadphase *broadphase;
} broadphase_choice;

/* From the cheapest to the most expensive. */
extern const thud_quality *const QUALITIES[QUALITY_CHOICES];
/* The first is "auto", the quality's own; the others follow from the cheapest to the most
 * expensive. */
extern const detection_choice DETECTIONS[DETECTION_CHOICES];
extern const broadphase_choice BROADPHASES[BROADPHASE_CHOICES]; /* the first is the default */

/* Indices of the default choices. */
enum { QUALITY_DEFAULT = 1, DETECTION_DEFAULT = 0, BROADPHASE_DEFAULT = 0 };

/* The index of a name in its list, or -1. */
int quality_find(const char *name);
int detection_find(const char *name);
int broadphase_find(const char *name);

#endif
