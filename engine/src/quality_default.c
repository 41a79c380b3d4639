/* quality_default.c: the quality that a world has unless it names another one. */
#include "thud/thud.h"

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

thud_world_def thud_default_world_def(void)
{
    return thud_world_def_of(&thud_quality_default);
}
