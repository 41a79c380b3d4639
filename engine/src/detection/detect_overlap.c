/* detect_overlap.c: shapes are tested at their poses at the start of each step only, by the
 * narrowphase; there is no stage. */
#include "detection/detection.h"

#include "thud/thud_detection.h"

const thud_detection thud_detection_overlap = {.name = "overlap", .rank = TD_RANK_OVERLAP};
