/* options.h: thud-play's command line. */
#ifndef THUD_PLAY_OPTIONS_H
#define THUD_PLAY_OPTIONS_H

#include "draw/draw_pairs.h"
#include "panel/overlays.h"

#include <thud/thud.h>

typedef struct options {
    const char *show;       /* scene or level, null for the first */
    const char *screenshot; /* file, or null */
    int frames;             /* to run before the end; -1 for no end */
    int width, height;
    overlay_set overlays;
    int quality;               /* of QUALITIES in choices.h */
    int detection, broadphase; /* as in session.h */
    bool overlays_given;       /* else those of the scene */
    pair_look pair_look;
    bool bare, paused, list, help;
} options;

/* False, and stderr has heard why, if the arguments make no sense. */
bool options_parse(options *o, int argc, char **argv);
void options_print_help(void);

#endif
