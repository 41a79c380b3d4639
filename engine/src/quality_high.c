/* quality_high.c: see thud_quality.h. */
#include "thud/thud_quality.h"

const thud_quality thud_quality_high = {
    .name = "high",
    .substeps = 8,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_continuous,
    .islands = &thud_islands_direct,
    .sag_limit = 0.0f,
    .island_limit = 2048,
    .island_work = 2000000,
    .island_patience = 5,
};
