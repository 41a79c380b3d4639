/* options.h: reads the command line of thud-matrix. */
#ifndef THUD_TESTS_MATRIX_OPTIONS_H
#define THUD_TESTS_MATRIX_OPTIONS_H

#include <stdbool.h>

typedef struct matrix_options {
    int steps;         /* of each run; an even number, because snapshots are taken in the
                          middle; default 120 */
    int bodies;        /* scenes with more bodies are made smaller; default 10^6 */
    bool baseline;     /* uses the baseline instruction set, never AVX2 */
    bool no_scenes;    /* leaves out the built-in scenes */
    const char *plain; /* a file of scenes in plain form (plain.h) that are run too; may be
                          null */
    const char *keep;  /* the file to which all scenes of the run are written in plain form;
                          may be null */
    const char *take;  /* the file to which snapshots are written; may be null */
    const char *go_on; /* continues from the snapshots of this file; may be null */
    const char
        *make_plain;      /* writes the named levels to this file, and runs nothing; may be null */
    char *const *sources; /* paths of these levels */
    int source_count;
} matrix_options;

/* False, after a message, if the command line is wrong. */
bool matrix_options_parse(int count, char **words, matrix_options *out);

#endif
