/* detect_overlap.c: shapes are tested where they stand at the start of a step, and nowhere else. */
#include "detection/detection.h"

#include "thud/thud_detection.h"

const thud_detection thud_detection_overlap = {.name = "overlap", .rank = TD_RANK_OVERLAP};
