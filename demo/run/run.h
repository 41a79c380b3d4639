/* run.h: builds the world of a scene, steps it, and measures each step. */
#ifndef THUD_RUN_RUN_H
#define THUD_RUN_RUN_H

#include "options.h"
#include "outcome.h"
#include "scene.h"

/* What looks at a run; each call returns false, after a message, to end it. */
typedef struct run_watch {
    bool (*built)(thud_world *world, void *context); /* before the first step; may be null */
    bool (*stepped)(thud_world *world, const run_outcome *so_far, void *context);
    void *context;
} run_watch;

/* Builds the scene's world with the systems that the options choose, and makes their number of
 * steps. `watch` may be null. False after a message: the world cannot be built, or a step fails. */
bool run_scene(const run_options *options, const scene *s, const run_watch *watch,
               run_outcome *out);

#endif
