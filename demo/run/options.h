/* options.h: what the command line of thud-run asks for. */
#ifndef THUD_RUN_OPTIONS_H
#define THUD_RUN_OPTIONS_H

#include <thud/thud.h>

typedef struct run_options {
    const char *source; /* a scene's name or a level's path */
    long steps;
    int size;                           /* of a built-in scene; 0 is its default */
    int workers;                        /* threads; 0 as 1 */
    int quality, detection, broadphase; /* of QUALITIES, DETECTIONS and BROADPHASES in choices.h */
    bool json, skip_unsupported, no_sleeping, list, help;
} run_options;

/* False, after a message on stderr, when the arguments make no sense. */
bool run_options_parse(int count, char **arguments, run_options *out);

void run_print_help(void);
void run_print_list(void);

#endif
