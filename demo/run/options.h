/* options.h: the command line of thud-run, parsed. */
#ifndef THUD_RUN_OPTIONS_H
#define THUD_RUN_OPTIONS_H

#include <thud/thud.h>

/* Most that --heavier takes. */
#define RUN_HEAVIER_MAX 1e6

/* Most steps of a run whose times are kept one by one. */
enum { ADVISE_STEPS_MAX = 1000000 };

/* Most characters of what says why a run failed, its terminating 0 included. */
enum { RUN_FAILURE_MAX = 400 };

typedef struct run_options {
    const char *source; /* a built-in scene's name or a level's path */
    long steps;
    int size;                           /* of a built-in scene; 0: its default */
    int workers;                        /* threads, the calling one included; 0 means 1 */
    int substeps;                       /* of a step; 0: those of the quality */
    int quality, detection, broadphase; /* indices in the lists of choices.h */
    double rate;                        /* steps a second of the scene */
    double heavier;                     /* factor of the mass of the heaviest body; 1: as it is */
    unsigned without;                   /* bits of without.h */
    double cell_size;                   /* of the grid, length; 0: chosen by the engine */
    bool json, skip_unsupported, no_sleeping, list;
    bool uses;           /* also count what the run uses */
    bool advise;         /* advise instead of running once; what follows is for this alone */
    double max_error;    /* the largest error that the advised setting may have, length scales */
    double budget;       /* ms a step that it may take; infinite: any */
    int repeats;         /* timed runs of each setting that comes into question */
    double patience;     /* s that larger sizes may take to measure together */
    const char *picture; /* path of a picture to write; null: none */
    const char *record;  /* path of a recording to write; null: none */
    long keyframes; /* steps from one keyframe (snapshot of the world) of the recording to the next;
                       0: only the first; -1: the option was not given, and the default of the help
                       holds */
    const char *replay; /* path of a recording to play in place of a scene; null: none */
    const char *bisect; /* of --replay: path of another build's thud-run to compare with; or null */
    long hashes[3];     /* of --replay: print the hashes of steps [0] to [1], of every [2]-th one
                           (bisect.h); [2] is 0: print none */
    long hash_at;       /* of --replay: print the hashes of the bodies after a step; -1: no */
    char *failure; /* where a run writes why it failed, RUN_FAILURE_MAX characters; the run then
                      prints nothing. Null: it prints that, and its progress, on stderr */
} run_options;

/* What holds where the command line says nothing. */
void run_options_default(run_options *out);
/* Parses an option that takes a value, as "--steps". False after a message. */
bool run_options_set(const char *option, const char *value, run_options *out);
/* Parses the arguments. False, after a message on stderr, if one is unknown or has no valid value,
 * or if no scene is named. */
bool run_options_parse(int count, char **arguments, run_options *out);

/* Most characters of a command, its terminating 0 included: for a path of 4095 quotes, each of
 * which takes four, and all options. */
enum { RUN_COMMAND_MAX = 17408 };

/* Writes the command line that runs what the options say once, for a shell, into RUN_COMMAND_MAX
 * characters. */
void run_command(const run_options *options, char *out);

void run_print_help(void);
void run_print_list(void);

#endif
