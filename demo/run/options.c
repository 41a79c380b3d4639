/* options.c: parses the command line of thud-run, and prints its help and its list of scenes. */
#include "options.h"

#include "choices.h"
#include "scenes.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Prints an error message; returns false. */
static bool complain(const char *what, const char *argument) {
    fprintf(stderr, "thud-run: %s '%s'; see thud-run --help\n", what, argument);
    return false;
}

/* Parses a whole number from `low` to `high`. False after a message. */
static bool parse_number(const char *option, const char *text, long low, long high, long *out) {
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    if (end == text || *end != '\0' || errno == ERANGE || value < low || value > high) {
        fprintf(stderr, "thud-run: %s takes a whole number from %ld to %ld, not '%s'\n", option,
                low, high, text);
        return false;
    }
    *out = value;
    return true;
}

/* Parses a length of at least 0; the world refuses what is too large. False after a message. */
static bool parse_length(const char *option, const char *text, float *out) {
    char *end;
    float value = strtof(text, &end);
    if (end == text || *end != '\0' || !(value >= 0)) {
        fprintf(stderr, "thud-run: %s takes a length from 0, not '%s'\n", option, text);
        return false;
    }
    *out = value;
    return true;
}

/* Stores `found`, the index of the name `text` in a list of choices. False, after a message, if it
 * is -1. */
static bool choose(const char *option, const char *names, const char *text, int found, int *out) {
    *out = found;
    if (found < 0)
        fprintf(stderr, "thud-run: %s takes %s, not '%s'\n", option, names, text);
    return found >= 0;
}

/* Parses an option that takes a value. False after a message. */
static bool parse_valued(const char *option, const char *value, run_options *out) {
    long number;
    if (!value) {
        fprintf(stderr, "thud-run: %s needs a value; see thud-run --help\n", option);
        return false;
    }
    if (strcmp(option, "--steps") == 0)
        return parse_number(option, value, 1, 1000000000, &out->steps);
    if (strcmp(option, "--quality") == 0)
        return choose(option, "draft, default, high or exact", value, quality_find(value),
                      &out->quality);
    if (strcmp(option, "--detection") == 0)
        return choose(option, "overlap, continuous, bisect or swept", value, detection_find(value),
                      &out->detection);
    if (strcmp(option, "--broadphase") == 0)
        return choose(option, "grid, sweep, sweep_y, sweep_widest, sweep_both or all", value,
                      broadphase_find(value), &out->broadphase);
    if (strcmp(option, "--cell-size") == 0)
        return parse_length(option, value, &out->cell_size);
    bool workers = strcmp(option, "--workers") == 0;
    if (!parse_number(option, value, 1, workers ? THUD_WORKERS_MAX : 1000000000, &number))
        return false;
    *(workers ? &out->workers : &out->size) = (int)number;
    return true;
}

/* Parses an option without a value. False after a message. */
static bool parse_plain(const char *option, run_options *out) {
    if (strcmp(option, "--json") == 0)
        out->json = true;
    else if (strcmp(option, "--skip-unsupported") == 0)
        out->skip_unsupported = true;
    else if (strcmp(option, "--no-sleeping") == 0)
        out->no_sleeping = true;
    else if (strcmp(option, "--list") == 0)
        out->list = true;
    else if (strcmp(option, "--help") == 0 || strcmp(option, "-h") == 0)
        out->help = true;
    else
        return complain("unknown option", option);
    return true;
}

bool run_options_parse(int count, char **arguments, run_options *out) {
    static const char *const with_value[] = {"--steps",    "--size",      "--quality",
                                             "--workers",  "--detection", "--broadphase",
                                             "--cell-size"};
    *out = (run_options){.steps = 600,
                         .quality = QUALITY_DEFAULT,
                         .detection = DETECTION_DEFAULT,
                         .broadphase = BROADPHASE_DEFAULT};
    for (int i = 1; i < count; i++) {
        const char *argument = arguments[i];
        bool valued = false;
        for (size_t k = 0; k < sizeof with_value / sizeof with_value[0]; k++)
            valued |= strcmp(argument, with_value[k]) == 0;
        if (valued) {
            if (!parse_valued(argument, arguments[++i], out))
                return false;
        } else if (argument[0] == '-') {
            if (!parse_plain(argument, out))
                return false;
        } else if (out->source) {
            return complain("one scene at a time, not also", argument);
        } else {
            out->source = argument;
        }
    }
    if (!out->source && !out->help && !out->list) {
        fprintf(stderr, "thud-run: which scene or level? See thud-run --help and --list\n");
        return false;
    }
    return true;
}

void run_print_help(void) {
    puts("thud-run LEVEL|SCENE [options]: runs a scene or a level without a display.\n"
         "\n"
         "SCENE is the name of a built-in scene (--list shows them), LEVEL a map of the Tiled\n"
         "editor (.tmj or .tmx), with the tilesets and templates beside it; all that of it cannot\n"
         "be modelled is listed on standard error. Prints the time of a step by stage, the worst\n"
         "penetration and the worst errors that a step reported in the whole run, and at its end\n"
         "the contacts, the energy (against height 0) and the hash of the state, which is the\n"
         "same on every machine.\n"
         "\n"
         "  --steps N            steps of 1/60 s to run (600)\n"
         "  --size N             how big a built-in scene is, see --list\n"
         "  --quality Q          draft, default, high or exact\n"
         "  --detection D        overlap, continuous (the default), bisect or swept\n"
         "  --broadphase B       grid (the default), sweep, sweep_y, sweep_widest, sweep_both\n"
         "                       or all\n"
         "  --cell-size S        width of the grid's cells; 0: by the sizes of shapes (0)\n"
         "  --workers N          threads to work on (1); the state is the same with any number\n"
         "  --no-sleeping        resting bodies stay awake\n"
         "  --skip-unsupported   leave out what a level has that cannot be modelled\n"
         "  --json               print one JSON object instead\n"
         "  --list               list the built-in scenes\n"
         "  --help               this text\n"
         "\n"
         "Exit status: 0 done, 1 the scene cannot be loaded or run, 2 wrong arguments.");
}

void run_print_list(void) {
    for (int i = 0; i < scenes_count(); i++) {
        const scene_info *info = scenes_at(i);
        printf("%-15s %s\n%-15s size: %s, %d to %d (%d)\n", info->name, info->about, "",
               info->size_means, info->min_size, info->max_size, info->default_size);
    }
}
