/* quality_exact.c: see thud_quality.h. */
#include "thud/thud_quality.h"

const thud_quality thud_quality_exact = {
    .name = "exact",
    .substeps = 16,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_swept,
    .islands = &thud_islands_direct,
    .sag_limit = 0.0f,
    .island_limit = 4096,
    .island_work = 1000000000,
    .island_patience = 0,
};
