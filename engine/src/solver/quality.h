/* quality.h: the settings that a world works with. */
#ifndef TD_QUALITY_H
#define TD_QUALITY_H

#include "base/reason.h"
#include "state/world.h"

/* Says what is wrong with a quality; null where nothing is. */
const char *td_quality_error(const thud_quality *quality, td_reason *why);

/* Says what is wrong with a world's max_error at this quality; null where nothing is. */
const char *td_max_error_error(double max_error, const thud_quality *quality, td_reason *why);

/* Puts the quality's settings to work, but for those that the world's def named itself. */
void td_quality_take(thud_world *w, const thud_quality *quality);

/* Substeps that the def or else the quality wants. */
int td_substeps_asked(const thud_world *w);

/* Impulses that carry over are scaled: they are those of one substep. */
void td_substeps_set(thud_world *w, int substeps);

#endif
