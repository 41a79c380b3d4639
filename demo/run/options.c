/* options.c: parses the command line of thud-run, and prints its help and its list of scenes. */
#include "options.h"

#include "choices.h"
#include "scenes.h"
#include "without.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The largest error that is asked for where the command line names none, length scales: that from
 * which thud_step_error counts an overlap. */
static const double MAX_ERROR = 0.005;

/* Seconds that larger sizes may take to measure: where the command line names none, and the most.
 */
static const double PATIENCE = 20, PATIENCE_MAX = 1e6;

static const double RATE = 60, RATE_MAX = 1e5; /* steps a second */

/* Timed runs: where the command line names no number, and the largest number. */
enum { REPEATS = 3, REPEATS_MAX = 100 };

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

/* Parses a number from `low` to `high`. False after a message. */
static bool parse_amount(const char *option, const char *text, double low, double high,
                         double *out) {
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !(value >= low && value <= high)) {
        fprintf(stderr, "thud-run: %s takes a number from %g to %g, not '%s'\n", option, low, high,
                text);
        return false;
    }
    *out = value;
    return true;
}

/* Parses FROM,TO,EVERY. False after a message. */
static bool parse_hashes(const char *text, long *out) {
    int end = 0;
    if (sscanf(text, "%18ld,%18ld,%9ld%n", &out[0], &out[1], &out[2], &end) == 3 &&
        text[end] == '\0' && out[0] >= 0 && out[1] >= out[0] && out[2] >= 1)
        return true;
    fprintf(stderr, "thud-run: --hashes takes FROM,TO,EVERY, not '%s'\n", text);
    return false;
}

/* Stores `found`, the index of the name `text` in a list of choices. False, after a message, if it
 * is -1. */
static bool choose(const char *option, const char *names, const char *text, int found, int *out) {
    *out = found;
    if (found < 0)
        fprintf(stderr, "thud-run: %s takes %s, not '%s'\n", option, names, text);
    return found >= 0;
}

bool run_options_set(const char *option, const char *value, run_options *out) {
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
        return parse_amount(option, value, 0, THUD_SIZE_MAX, &out->cell_size);
    if (strcmp(option, "--without") == 0) {
        out->without |= without_find(value);
        if (without_find(value) == 0)
            fprintf(stderr,
                    "thud-run: --without takes names of parts with commas between them, "
                    "not '%s'; see thud-run --help\n",
                    value);
        return without_find(value) != 0;
    }
    if (strcmp(option, "--max-error") == 0)
        return parse_amount(option, value, 0, THUD_MAX_ERROR_MAX, &out->max_error);
    if (strcmp(option, "--rate") == 0)
        return parse_amount(option, value, 1 / THUD_TIME_STEP_MAX, RATE_MAX, &out->rate);
    if (strcmp(option, "--heavier") == 0)
        return parse_amount(option, value, 1 / RUN_HEAVIER_MAX, RUN_HEAVIER_MAX, &out->heavier);
    if (strcmp(option, "--patience") == 0)
        return parse_amount(option, value, 0, PATIENCE_MAX, &out->patience);
    if (strcmp(option, "--budget") == 0)
        return parse_amount(option, value, 0, 1000 * THUD_TIME_BUDGET_MAX, &out->budget);
    if (strcmp(option, "--picture") == 0) {
        out->picture = value;
        return true;
    }
    if (strcmp(option, "--keyframes") == 0)
        return parse_number(option, value, 0, THUD_RECORDING_STEPS_MAX, &out->keyframes);
    if (strcmp(option, "--bisect") == 0) {
        out->bisect = value;
        return true;
    }
    if (strcmp(option, "--hashes") == 0)
        return parse_hashes(value, out->hashes);
    if (strcmp(option, "--hash-at") == 0)
        return parse_number(option, value, 0, LONG_MAX, &out->hash_at);
    if (strcmp(option, "--record") == 0) {
        out->record = value;
        return true;
    }
    if (strcmp(option, "--replay") == 0) {
        out->replay = value;
        return true;
    }
    const struct {
        const char *name;
        long high;
        int *out;
    } counts[] = {{"--workers", THUD_WORKERS_MAX, &out->workers},
                  {"--substeps", THUD_SUBSTEPS_MAX, &out->substeps},
                  {"--repeat", REPEATS_MAX, &out->repeats},
                  {"--size", 1000000000, &out->size}};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++)
        if (strcmp(option, counts[i].name) == 0) {
            bool ok = parse_number(option, value, 1, counts[i].high, &number);
            *counts[i].out = ok ? (int)number : *counts[i].out;
            return ok;
        }
    return false;
}

/* Parses an option without a value. False after a message. */
static bool parse_plain(const char *option, run_options *out) {
    if (strcmp(option, "--json") == 0)
        out->json = true;
    else if (strcmp(option, "--skip-unsupported") == 0)
        out->skip_unsupported = true;
    else if (strcmp(option, "--no-sleeping") == 0)
        out->no_sleeping = true;
    else if (strcmp(option, "--uses") == 0)
        out->uses = true;
    else if (strcmp(option, "--advise") == 0)
        out->advise = true;
    else if (strcmp(option, "--list") == 0)
        out->list = true;
    else
        return complain("unknown option", option);
    return true;
}

/* Whether the options go together. False after a message. */
static bool check(const run_options *options, bool only_for_advice) {
    if (options->list)
        return true;
    if (options->replay && (options->source || options->record))
        fprintf(stderr, "thud-run: --replay plays a recording, and no scene\n");
    else if (options->record && (options->advise || options->uses))
        fprintf(stderr, "thud-run: --record is for one run, without --advise or --uses\n");
    else if (options->keyframes >= 0 && !options->record)
        fprintf(stderr, "thud-run: --keyframes is for --record\n");
    else if ((options->bisect || options->hashes[2] > 0 || options->hash_at >= 0) &&
             !options->replay)
        fprintf(stderr, "thud-run: --bisect, --hashes and --hash-at are for --replay\n");
    else if (options->replay && (options->advise || options->uses || only_for_advice))
        fprintf(stderr, "thud-run: --replay plays a recording, without --advise and --uses\n");
    else if (options->replay)
        return true;
    else if (!options->source)
        fprintf(stderr, "thud-run: which scene or level? See thud-run --help and --list\n");
    else if (only_for_advice && !options->advise)
        fprintf(stderr, "thud-run: --max-error, --budget, --repeat, --patience and "
                        "--picture are for "
                        "--advise\n");
    else if (options->advise && options->uses)
        fprintf(stderr, "thud-run: --advise tells what --uses does; give one of them\n");
    else if (options->advise && options->steps > ADVISE_STEPS_MAX)
        fprintf(stderr, "thud-run: --advise takes at most %d steps, not %ld\n", ADVISE_STEPS_MAX,
                options->steps);
    else
        return true;
    return false;
}

void run_options_default(run_options *out) {
    *out = (run_options){.steps = 600,
                         .quality = QUALITY_DEFAULT,
                         .detection = DETECTION_DEFAULT,
                         .broadphase = BROADPHASE_DEFAULT,
                         .max_error = MAX_ERROR,
                         .budget = INFINITY,
                         .repeats = REPEATS,
                         .patience = PATIENCE,
                         .rate = RATE,
                         .keyframes = -1,
                         .hash_at = -1,
                         .heavier = 1};
}

bool run_options_parse(int count, char **arguments, run_options *out) {
    static const char *const with_value[] = {"--max-error", "--budget",    "--patience",
                                             "--repeat",    "--picture", /* for --advise alone */
                                             "--steps",     "--size",      "--quality",
                                             "--workers",   "--detection", "--broadphase",
                                             "--substeps",  "--without",   "--rate",
                                             "--heavier",   "--cell-size", "--record",
                                             "--replay",    "--keyframes", "--bisect",
                                             "--hashes",    "--hash-at"};
    enum { ONLY_FOR_ADVICE = 5 };
    run_options_default(out);
    bool only_for_advice = false;
    for (int i = 1; i < count; i++) {
        const char *argument = arguments[i];
        size_t valued = 0, options = sizeof with_value / sizeof with_value[0];
        while (valued < options && strcmp(argument, with_value[valued]) != 0)
            valued++;
        only_for_advice |= valued < ONLY_FOR_ADVICE;
        if (valued < options) {
            if (!run_options_set(argument, arguments[++i], out))
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
    return check(out, only_for_advice);
}

/* Whether a shell takes the text as it is. */
static bool is_plain(const char *text) {
    return text[strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                             "_-./+,:@%")] == '\0';
}

/* Appends `text` to a command of `used` characters as one word of a shell, and returns the new
 * number of characters. What does not fit is left out. */
static int put_word(char *out, int used, const char *text) {
#ifdef _WIN32
    const char *quote = "\"", *escaped = ""; /* a path has no quotes there */
#else
    const char *quote = "'", *escaped = "'\\''";
#endif
    if (is_plain(text))
        quote = "";
    used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), "%s", quote);
    for (; *text && used < RUN_COMMAND_MAX - 1024; text++)
        if (*text == *quote)
            used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), "%s", escaped);
        else
            out[used++] = *text;
    return used + snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), "%s", quote);
}

void run_command(const run_options *o, char *out) {
    int used = snprintf(out, RUN_COMMAND_MAX, "thud-run ");
    used = put_word(out, used, o->source);
    used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), " --steps %ld", o->steps);
    struct {
        const char *name, *value;
    } words[] = {{"--quality", QUALITIES[o->quality]->name},
                 {"--detection", o->detection ? DETECTIONS[o->detection].name : NULL},
                 {"--broadphase", o->broadphase ? BROADPHASES[o->broadphase].name : NULL},
                 {"--no-sleeping", o->no_sleeping ? "" : NULL},
                 {"--uses", o->uses ? "" : NULL},
                 {"--skip-unsupported", o->skip_unsupported ? "" : NULL}};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (words[i].value)
            used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), " %s%s%s", words[i].name,
                             *words[i].value ? " " : "", words[i].value);
    struct {
        const char *name;
        int value;
    } counts[] = {{"--size", o->size}, {"--substeps", o->substeps}, {"--workers", o->workers}};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++)
        if (counts[i].value > 0)
            used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), " %s %d", counts[i].name,
                             counts[i].value);
    if (o->rate != RATE)
        used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), " --rate %.17g", o->rate);
    if (o->heavier != 1)
        used +=
            snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), " --heavier %.17g", o->heavier);
    if (o->cell_size > 0)
        used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), " --cell-size %.17g",
                         o->cell_size);
    const char *between = " --without ";
    for (int i = 0; i < WITHOUT_PARTS; i++)
        if (o->without & 1u << i) {
            used += snprintf(out + used, (size_t)(RUN_COMMAND_MAX - used), "%s%s", between,
                             without_name(i));
            between = ",";
        }
}

void run_print_help(void) {
    puts(
        "thud-run LEVEL|SCENE [options]: runs a scene or a level without a display.\n"
        "\n"
        "SCENE is the name of a built-in scene (--list shows them), LEVEL a map of the Tiled\n"
        "editor (.tmj or .tmx), with the tilesets and templates beside it; all that of it cannot\n"
        "be modelled is listed on standard error. Prints the time of a step by stage, the worst\n"
        "penetration and the worst errors that a step reported in the whole run, and at its end\n"
        "the contacts, the energy (against height 0) and the hash of the state, which is the\n"
        "same on every machine.\n"
        "\n"
        "  --steps N            steps to run (600)\n"
        "  --rate HZ            steps a second of the scene (60)\n"
        "  --heavier F          the heaviest body, of equal ones the highest, is F times as heavy\n"
        "  --size N             how big a built-in scene is, see --list\n"
        "  --quality Q          draft, default, high or exact\n"
        "  --detection D        overlap, continuous (the default), bisect or swept\n"
        "  --broadphase B       grid (the default), sweep, sweep_y, sweep_widest, sweep_both\n"
        "                       or all\n"
        "  --cell-size S        least width of the grid's cells; 0: by the sizes of shapes (0)\n"
        "  --substeps N         substeps of a step, 1 to 64 (those of the quality)\n"
        "  --workers N          threads to work on (1); the state is the same with any number\n"
        "  --no-sleeping        resting bodies stay awake\n"
        "  --skip-unsupported   leave out what a level has that cannot be modelled\n"
        "  --json               print one JSON object instead\n"
        "  --without PARTS      leave out parts, with commas between them: obbs (upright ones\n"
        "                       become AABBs, which never turn), turning, friction, bounce, sleep,\n"
        "                       direct (islands), joints, sensors, fields, rules, events\n"
        "  --uses               print instead what the scene has, and what the run used of it:\n"
        "                       bodies that turned, bounced, slid or slept, contacts solved\n"
        "                       directly, the height of stacks, ratios of masses, speeds\n"
        "  --advise             measure what the scene requires, and say which setting is the\n"
        "                       cheapest that meets --max-error within --budget; this makes\n"
        "                       dozens of runs\n"
        "  --max-error E        the largest error, in length scales (0.005): the deepest overlap\n"
        "                       or the widest gap of a joint in any step; bodies that pass\n"
        "                       through what stands meet no error\n"
        "  --budget MS          milliseconds that a step may take in the mean (any)\n"
        "  --repeat N           timed runs of the settings that come into question (3)\n"
        "  --patience S         seconds that larger sizes of the scene may take to measure (20)\n"
        "  --picture FILE.svg   also draw the error of each setting over its time\n"
        "  --record FILE        also write a recording of the run, with a hash of each body at\n"
        "                       each step\n"
        "  --keyframes N        steps from one keyframe of it to the next (120); 0: none but the\n"
        "                       first. To go back, a player plays on from the keyframe before, so\n"
        "                       N steps at most. At 120 they take less than a tenth more time, and\n"
        "                       make the file larger: by a quarter where bodies fly freely, to\n"
        "                       three times the size where each has many contacts and joints\n"
        "  --replay FILE        play a recording instead of a scene, on any number of --workers:\n"
        "                       the first step and the first body that differ are named\n"
        "  --bisect OTHER       of --replay: OTHER is another build's thud-run; say at which step\n"
        "                       both have another hash for the first time, and in which body\n"
        "  --hashes F,T,E       of --replay, what --bisect asks OTHER: the hashes after step F,\n"
        "                       each E-th after it, and T\n"
        "  --hash-at N          the same for step N alone, with a hash of each body\n"
        "  --list               list the built-in scenes\n"
        "  --jobs FILE          run the jobs of FILE over all cores instead, one JSON object a\n"
        "                       line: \"scene\" and any of the options above by their names, seed,\n"
        "                       inputs; a list or a range stands for several jobs; see\n"
        "                       docs/embedding.md. Beside it:\n"
        "    --workers N        jobs at a time (the number of processors)\n"
        "    --out FILE         the results, one JSON object a line (standard output)\n"
        "    --resume           continue FILE: jobs whose results it has are not run again\n"
        "    --part K/N         run the K-th of N parts of the jobs, for several machines\n"
        "    --no-times         results without times, which are the same on every machine\n"
        "  --help               this text\n"
        "\n"
        "Exit status: 0 done, 1 the scene cannot be loaded or run, or a recording is damaged or\n"
        "differs when it is played, or builds differ, 2 wrong arguments. With --jobs: 1 some\n"
        "jobs failed, and their results say so; 2 a job is wrong, and nothing was run.");
}

void run_print_list(void) {
    for (int i = 0; i < scenes_count(); i++) {
        const scene_info *info = scenes_at(i);
        printf("%-15s %s\n%-15s size: %s, %d to %d (%d)\n", info->name, info->about, "",
               info->size_means, info->min_size, info->max_size, info->default_size);
    }
}
