/* quality_default.c: the quality that a world has unless it names another one: four substeps, and
 * islands are solved directly in which a contact gives way by more than 1 % of a body
 * (overlap_limit).
 *
 * Its errors in docs/tradeoff.md (2026-11-28; boxes of 1 m), with which the heads of the other
 * qualities compare theirs: a column of 30 boxes sinks by 0.21 m in 20 s; in a pyramid of 465 boxes
 * none moves by more than 51 mm in 10 s; a pit of 1,000 circles overlaps by 52 mm where it is
 * deepest, on average over the steps; boxes of up to 1,000 times the mass of those below them
 * overlap these by at most 9.4 mm; a column of 100 boxes sinks by 0.56 m at first. */
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
