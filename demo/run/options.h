/* options.h: the command line of thud-run, parsed. */
#ifndef THUD_RUN_OPTIONS_H
#define THUD_RUN_OPTIONS_H

#include <thud/thud.h>

typedef struct run_options {
    const char *source; /* a built-in scene's name or a level's path */
    long steps;
    int size;                           /* of a built-in scene; 0: its default */
    int workers;                        /* threads, the calling one included; 0 means 1 */
    int quality, detection, broadphase; /* indices in the lists of choices.h */
    float cell_size;                    /* of the grid, length; 0: chosen by the engine */
    bool json, skip_unsupported, no_sleeping, list, help;
} run_options;

/* Parses the arguments. False, after a message on stderr, if one is unknown or has no valid value,
 * or if no scene is named. */
bool run_options_parse(int count, char **arguments, run_options *out);

void run_print_help(void);
void run_print_list(void);

#endif
