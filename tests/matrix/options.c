/* options.c: the command line of thud-matrix. */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char USAGE[] =
    "usage: thud-matrix [OPTION...] [--take FILE | --continue FILE]\n"
    "       thud-matrix --make-plain FILE LEVEL...\n"
    "\n"
    "Runs every built-in scene, with the default systems (scene), with quality exact over all pairs\n"
    "(exact), and with quality high, detection swept and the plane sweep (swept), then what is in\n"
    "the file of --plain, and prints one line for each run: kind, name, hash.\n"
    "\n"
    "  --steps N       of each run, an even number; default 120\n"
    "  --bodies N      scenes of more bodies are made smaller; default 1000000\n"
    "  --baseline      without AVX2\n"
    "  --plain FILE    scenes in plain form to run as well, each as its kind in the file says\n"
    "  --no-scenes     leaves the built-in ones out\n"
    "  --keep FILE     writes all scenes that are run to FILE in plain form\n"
    "  --take FILE     keeps the snapshots of all worlds in the middle of their runs\n"
    "  --continue FILE restores those snapshots and makes the other half of the steps\n"
    "  --make-plain FILE LEVEL...  reads maps of Tiled and writes them in plain form; only where\n"
    "                  the program was built with the reader of levels\n";

static bool complain(const char *what, const char *word) {
    fprintf(stderr, "thud-matrix: %s '%s'\n%s", what, word, USAGE);
    return false;
}

static bool parse_number(const char *option, const char *text, int low, int *out) {
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end || value < low || value > 1000000)
        return complain(option, text);
    *out = (int)value;
    return true;
}

/* Reads an option with a value; false, with a line on stderr, if it is not one of them or invalid.
 */
static bool parse_valued(const char *option, const char *value, matrix_options *out) {
    const struct {
        const char *name, **file;
    } files[] = {{"--plain", &out->plain},
                 {"--keep", &out->keep},
                 {"--take", &out->take},
                 {"--continue", &out->go_on},
                 {"--make-plain", &out->make_plain}};
    if (strcmp(option, "--steps") == 0)
        return parse_number("--steps takes an even number from 2 on, not", value, 2, &out->steps) &&
               (out->steps % 2 == 0 || complain("--steps takes an even number, not", value));
    if (strcmp(option, "--bodies") == 0)
        return parse_number("--bodies takes a number from 1 on, not", value, 1, &out->bodies);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        if (strcmp(option, files[i].name) == 0) {
            *files[i].file = value;
            return true;
        }
    }
    return complain("there is no option", option);
}

/* Reads an option without a value; false if it is not one of them. */
static bool parse_plain(const char *option, matrix_options *out) {
    if (strcmp(option, "--baseline") == 0)
        out->baseline = true;
    else if (strcmp(option, "--no-scenes") == 0)
        out->no_scenes = true;
    else
        return false;
    return true;
}

bool matrix_options_parse(int count, char **words, matrix_options *out) {
    *out = (matrix_options){.steps = 120, .bodies = 1000000};
    int i = 1;
    while (i < count && words[i][0] == '-') {
        if (parse_plain(words[i], out)) {
            i++;
            continue;
        }
        if (i + 1 == count)
            return complain("there is no such option, or it needs a value:", words[i]);
        if (!parse_valued(words[i], words[i + 1], out))
            return false;
        i += 2;
    }
    out->sources = words + i;
    out->source_count = count - i;
    if (out->source_count > 0 && !out->make_plain)
        return complain("only --make-plain takes the name of a level:", words[i]);
    if (out->take && out->go_on)
        return complain("--take and --continue exclude each other:", out->take);
    return true;
}
