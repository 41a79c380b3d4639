/* quality.h: checks qualities and applies them to a world. */
#ifndef TD_QUALITY_H
#define TD_QUALITY_H

#include "base/reason.h"
#include "state/world.h"

/* The reason why a quality is invalid, or null; the text may be in `why`. */
const char *td_quality_error(const thud_quality *quality, td_reason *why);

/* The reason why a max_error (thud_world_def: a depth, 0: none) is invalid at this quality, or
 * null; the text may be in `why`. Only an island solver can keep to one. */
const char *td_check_max_error(double max_error, const thud_quality *quality, td_reason *why);

/* Gives a new world, which is empty, the quality of its def. */
void td_quality_begin(thud_world *w);

/* The number of substeps that the def sets, or else the quality. */
int td_substeps_asked(const thud_world *w);

/* Changes the number of substeps, and scales the warm-start impulses, which are those of one
 * substep. */
void td_substeps_set(thud_world *w, int substeps);

#endif
