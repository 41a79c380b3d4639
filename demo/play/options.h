/* options.h: the command line of thud-play, parsed. */
#ifndef THUD_PLAY_OPTIONS_H
#define THUD_PLAY_OPTIONS_H

#include "draw/draw_pairs.h"
#include "panel/overlays.h"

#include <thud/thud.h>

typedef struct options {
    const char *show;       /* a scene's name, or the path of a level or recording; null for the
                               first scene */
    const char *replay;     /* path of a recording, in place of `show`; or null */
    const char *screenshot; /* file to write, or null */
    int frames;             /* number of frames until the program ends; -1: it does not */
    int width, height;
    overlay_set overlays;
    int step_rate, top_speed;  /* as in session.h */
    int quality;               /* index in QUALITIES of choices.h */
    int detection, broadphase; /* indices in DETECTIONS and BROADPHASES of choices.h */
    int workers;               /* that step the world; 0: one */
    bool overlays_given;       /* false: those of the scene are used */
    pair_look pair_look;
    bool bare, paused, calls, list, help;
} options;

/* Parses the arguments. False, after a message on stderr, if one is wrong. */
bool options_parse(options *o, int argc, char **argv);
void options_print_help(void);

#endif
