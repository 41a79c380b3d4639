/* advise_link.h: how much of thud a program links that runs a scene at a setting, by the programs
 * that tests/web/package/size.test.mjs links and bounds. */
#ifndef THUD_RUN_ADVISE_LINK_H
#define THUD_RUN_ADVISE_LINK_H

#include "options.h"
#include "scene.h"

typedef struct advise_link {
    const char *program; /* null: none of the programs has all of it */
    double kilobytes;    /* the most that it may have, 1000 bytes of gzipped WebAssembly */
} advise_link;

/* The smallest of the programs that has all kinds of shapes, joints, the detection and the island
 * solver that the scene needs at this setting. */
advise_link advise_link_of(const run_options *how, const scene *s);

#endif
