/* quality_high.c: eight substeps, and every island of up to 2,048 bodies solved directly, as long
 * as that costs no more than island_work. A median step takes 7 times as long as one of default in
 * a column of 30 boxes, as long in one of 100 (which default solves directly, too), 15 times in a
 * pyramid of 465, 2.2 times where boxes slide. Columns, pyramids and heavy boxes on light ones then
 * give way by less than 0.01 mm; boxes that slide are 1 mm off their analytic path after 4 s.
 * Moving islands that exceed the budget stay with the soft solver: a mean step takes 26 times as
 * long in rubble and 3 times in a pit, and they overlap 0.9 and 0.6 times as deep
 * (docs/tradeoff.md, 2026-11-28). */
#include "thud/thud_quality.h"

const thud_quality thud_quality_high = {
    .name = "high",
    .substeps = 8,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_continuous,
    .islands = &thud_islands_direct,
    .overlap_limit = 0.0f,
    .island_limit = 2048,
    .island_work = 2000000,
    .island_slow_steps = 5,
};
