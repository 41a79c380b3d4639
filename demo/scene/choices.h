/* choices.h: the systems that a user picks for a world, by the names that command lines and menus
 * give them. */
#ifndef THUD_DEMO_CHOICES_H
#define THUD_DEMO_CHOICES_H

#include <thud/thud.h>

enum { QUALITY_CHOICES = 4, DETECTION_CHOICES = 5, BROADPHASE_CHOICES = 3 };

typedef struct detection_choice {
    const char *name;
    const thud_detection *detection;
} detection_choice;

typedef struct broadphase_choice {
    const char *name;
    const thud_broadphase *broadphase;
} broadphase_choice;

extern const thud_quality *const QUALITIES[QUALITY_CHOICES]; /* in the order of their price */
extern const detection_choice
    DETECTIONS[DETECTION_CHOICES]; /* the quality's own; the others by price */
extern const broadphase_choice BROADPHASES[BROADPHASE_CHOICES]; /* the default first */

enum { QUALITY_DEFAULT = 1, DETECTION_DEFAULT = 0, BROADPHASE_DEFAULT = 0 };

/* The index of a name, or -1. */
int quality_find(const char *name);
int detection_find(const char *name);
int broadphase_find(const char *name);

#endif
