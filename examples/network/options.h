/* options.h: reads a program's options, and reports errors in them. */
#ifndef THUD_NETWORK_OPTIONS_H
#define THUD_NETWORK_OPTIONS_H

#include <stdint.h>

/* An option with a value: a whole number where `number` is set, else a text. */
typedef struct option {
    const char *name, *value, *help; /* as in --name VALUE */
    int64_t *number, least, most;
    const char **text;
} option;

typedef enum options_result { OPTIONS_READ, OPTIONS_HELP, OPTIONS_WRONG } options_result;

/* Reads the arguments into the variables of the options. --help prints `about` and the options with
 * their default values, which the variables have before, to stdout. Errors are reported on stderr.
 */
options_result options_read(int argc, char **argv, const char *about, const option *options,
                            int count);

#endif
