/* every_choice.h: all detections and all broadphases, for tests of what must hold with each. */
#ifndef EVERY_CHOICE_H
#define EVERY_CHOICE_H

#include <thud/thud.h>

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
static const thud_broadphase *const broadphases[] = {
    &thud_broadphase_grid,    &thud_broadphase_sweep,        &thud_broadphase_all,
    &thud_broadphase_sweep_y, &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both};
enum { BROADPHASES_IN_ALL = sizeof broadphases / sizeof *broadphases };

#endif
