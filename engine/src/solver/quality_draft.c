/* quality_draft.c: two substeps, and no island solver to link. Beside default it takes 0.6 to 0.7
 * times as long a step where contacts rest, and errs 2 to 4 times as much: a column of 30 sinks by
 * 0.8 of a box (default 0.2), a slide is 86 mm off its path after 4 s (43), a pit overlaps by 105
 * mm (50). A column of 100 falls, and 10^3 on 1 sinks through. docs/tradeoff.md has all. Under
 * bisect and swept, which bring an island solver and take four substeps, it has the limits of
 * default. */
#include "thud/thud_quality.h"

const thud_quality thud_quality_draft = {
    .name = "draft",
    .substeps = 2,
    .contact_stiffness = 0.16f,
    .contact_damping = 10.0f,
    .detection = &thud_detection_continuous,
    .overlap_limit = 0.01f,
    .island_limit = 512,
    .island_work = 15000,
    .island_slow_steps = 5,
};
