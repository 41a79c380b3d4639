/* load.h: loading what the command line of thud-run names. */
#ifndef THUD_RUN_LOAD_H
#define THUD_RUN_LOAD_H

#include "options.h"
#include "scene.h"

/* Loads the built-in scene or the level that the command line names, without the
 * parts that it leaves out, and with the heaviest body as heavy as it says. False after a message.
 * A source with a dot or a slash is a level's path; names of scenes have neither. */
bool run_load(const run_options *options, scene *s);

#endif
