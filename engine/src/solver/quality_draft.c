/* quality_draft.c: two substeps, and no island solver, which a program then does not link. Where
 * contacts rest, a step takes 0.6 to 0.7 times as long as one of default, and errors are 2 to 4
 * times as large: a column of 30 boxes sinks by 0.82 m (default 0.21), sliding boxes are 86 mm off
 * their analytic path after 4 s (43), a pit overlaps by 110 mm (52). A column of 100 boxes falls,
 * and a box of 1,000 times the mass sinks through most of the box below it (docs/tradeoff.md,
 * 2026-11-28).
 *
 * The detections `bisect` and `swept` bring an island solver and at least four substeps
 * (take_island_solver in quality.c); for that case draft has the island limits of default. */
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
