/* quality_default.c: see thud_quality.h. */
#include "thud/thud_quality.h"

const thud_quality thud_quality_default = {
    .name = "default",
    .substeps = 4,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_continuous,
    .islands = &thud_islands_direct,
    .sag_limit = 0.01f,
    .island_limit = 512,
    .island_work = 15000,
    .island_patience = 5,
};
