/* quality_exact.c: every island solved directly, whatever it takes, and bodies swept from impact
 * to impact. Beside high columns and pyramids take 1.1 to 1.6 times as long a step, a gas 1.5
 * times, rubble 4 times, a pit 26 times; nothing overlaps that flies free, a pit by 0.6 mm (high
 * 31), a slide is exact, a gas and a cradle keep their energy and momentum to 10^-6.
 * docs/tradeoff.md has all. */
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
