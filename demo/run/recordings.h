/* recordings.h: recordings of runs: --record and --replay. */
#ifndef THUD_RUN_RECORDINGS_H
#define THUD_RUN_RECORDINGS_H

#include "options.h"
#include "outcome.h"
#include "scene.h"

/* As run_scene, and writes a recording of the run to options->record. */
bool record_scene(const run_options *options, const scene *s, run_outcome *out);

/* Plays options->replay and prints how that ended, or what bisect.h says. False, after a message,
 * if it cannot be played, or differs. */
bool replay_file(const run_options *options);

#endif
