/* quality_default.c: the quality that a world has unless it names another one. Four substeps;
 * islands in which a contact gives way by more than 1 % of a body are solved directly. It is what
 * the others' heads compare with: a step of a column of 30 takes 1.7 us and sinks it by 0.2 of a
 * box in 20 s, of a pyramid of 465 37 us (51 mm at its top), of a pit of 1,000 74 us (50 mm deep);
 * 10^3 on 1 sinks in by 0.6 %, a column of 100 loses 0.1 mm for good, after half a box in its
 * first half second. docs/tradeoff.md has all. */
#include "thud/thud_quality.h"

const thud_quality thud_quality_default = {
    .name = "default",
    .substeps = 4,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_continuous,
    .islands = &thud_islands_direct,
    .overlap_limit = 0.01f,
    .island_limit = 512,
    .island_work = 15000,
    .island_slow_steps = 5,
};
