/* options.h: the command line of thud-matrix. */
#ifndef THUD_TESTS_MATRIX_OPTIONS_H
#define THUD_TESTS_MATRIX_OPTIONS_H

#include <stdbool.h>

typedef struct matrix_options {
    int steps;              /* of every run, even: a snapshot is of its middle; default 120 */
    int bodies;             /* scenes of more are made smaller; default 10^6 */
    bool baseline;          /* never AVX2 */
    bool no_scenes;         /* the built-in ones are left out */
    const char *plain;      /* a file of scenes in plain form to run as well; or null */
    const char *keep;       /* the file for all scenes that are run, in plain form; or null */
    const char *take;       /* the file for the snapshots; or null */
    const char *go_on;      /* run on from this file's snapshots instead; or null */
    const char *make_plain; /* write the levels that are named to this file instead; or null */
    char *const *sources;   /* those levels */
    int source_count;
} matrix_options;

/* False after a message: the command line is wrong. */
bool matrix_options_parse(int count, char **words, matrix_options *out);

#endif
