/* choices.h: the systems that a user picks for a world, by the names that command lines and menus
 * give them. */
#ifndef THUD_DEMO_CHOICES_H
#define THUD_DEMO_CHOICES_H

#include <thud/thud.h>

enum { DETECTION_CHOICES = 4, BROADPHASE_CHOICES = 3 };

typedef struct detection_choice {
    const char *name;
    const thud_detection *detection;
} detection_choice;

typedef struct broadphase_choice {
    const char *name;
    const thud_broadphase *broadphase;
} broadphase_choice;

extern const detection_choice DETECTIONS[DETECTION_CHOICES];    /* in the order of their price */
extern const broadphase_choice BROADPHASES[BROADPHASE_CHOICES]; /* the default first */

enum { DETECTION_DEFAULT = 1, BROADPHASE_DEFAULT = 0 };

/* The index of a name, or -1. */
int detection_find(const char *name);
int broadphase_find(const char *name);

#endif
