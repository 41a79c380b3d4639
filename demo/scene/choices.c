/* choices.c: see choices.h. */
#include "choices.h"

#include <string.h>

const thud_quality *const QUALITIES[QUALITY_CHOICES] = {&thud_quality_draft, &thud_quality_default,
                                                        &thud_quality_high, &thud_quality_exact};

const detection_choice DETECTIONS[DETECTION_CHOICES] = {
    {"auto", NULL},
    {"overlap", &thud_detection_overlap},
    {"continuous", &thud_detection_continuous},
    {"bisect", &thud_detection_bisect},
    {"swept", &thud_detection_swept},
};

const broadphase_choice BROADPHASES[BROADPHASE_CHOICES] = {
    {"grid", &thud_broadphase_grid},
    {"sweep", &thud_broadphase_sweep},
    {"all", &thud_broadphase_all},
    {"sweep_y", &thud_broadphase_sweep_y},
    {"sweep_widest", &thud_broadphase_sweep_widest},
    {"sweep_both", &thud_broadphase_sweep_both},
};

int quality_find(const char *name) {
    for (int i = 0; i < QUALITY_CHOICES; i++)
        if (strcmp(QUALITIES[i]->name, name) == 0)
            return i;
    return -1;
}

int detection_find(const char *name) {
    for (int i = 0; i < DETECTION_CHOICES; i++)
        if (strcmp(DETECTIONS[i].name, name) == 0)
            return i;
    return -1;
}

int broadphase_find(const char *name) {
    for (int i = 0; i < BROADPHASE_CHOICES; i++)
        if (strcmp(BROADPHASES[i].name, name) == 0)
            return i;
    return -1;
}
