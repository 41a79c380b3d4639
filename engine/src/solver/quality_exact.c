/* quality_exact.c: sixteen substeps, every island of up to 4,096 bodies solved directly with a
 * budget of 10^9 operations a step, and bodies swept from impact to impact. A median step takes 1.2
 * to 1.4 times as long as one of high in columns and pyramids, 2.1 times in a gas; a mean step 4.4
 * times in rubble and 180 times in a pit. Bodies that fly freely do not overlap; a pit overlaps by
 * 0.45 mm (high 30); boxes that slide stay within 0.1 mm of their analytic path; a gas keeps its
 * energy to 10^-6 (docs/tradeoff.md, 2026-11-28). */
#include "thud/thud_quality.h"

const thud_quality thud_quality_exact = {
    .name = "exact",
    .substeps = 16,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_swept,
    .islands = &thud_islands_direct,
    .overlap_limit = 0.0f,
    .island_limit = 4096,
    .island_work = 1000000000,
    .island_slow_steps = 0,
};
