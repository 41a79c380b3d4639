/* quality_high.c: eight substeps, and every island solved directly that is not too dear. Beside
 * default a column of 30 takes 8 times as long a step, one of 100 1.06 times, a pyramid of 465 33
 * times, a slide twice; columns, pyramids and heavy on light then do not move by more than 15 um,
 * a slide is 1 mm off its path after 4 s. In motion what is too dear stays soft: rubble and pits
 * take 23 to 38 times as long, in their first seconds, and overlap 0.6 to 0.9 times as deep.
 * docs/tradeoff.md has all. */
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
