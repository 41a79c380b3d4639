/* main.c: the program thud-run, which loads a scene or a level, runs a number of steps without a
 * display, and prints what it measured, or what it advises. */
#include "advise.h"
#include "jobs.h"
#include "load.h"
#include "options.h"
#include "outcome.h"
#include "recordings.h"
#include "run.h"
#include "uses.h"

#include <stdio.h>
#include <string.h>

static bool run_plainly(const run_options *options, const scene *s, run_outcome *out) {
    return run_scene(options, s, NULL, out);
}

/* Runs the scene once and prints what was measured. */
static bool run_and_print(const run_options *options, const scene *s) {
    run_outcome outcome;
    if (!(options->record ? record_scene : run_plainly)(options, s, &outcome))
        return false;
    if (options->json)
        return run_print_json(&outcome, s, options);
    run_print_text(&outcome, s, options);
    return true;
}

/* Runs the scene once and prints what it has and what of it the run used. */
static bool count_and_print(const run_options *options, const scene *s) {
    uses counted;
    run_outcome outcome;
    if (!uses_count(options, s, &outcome, &counted))
        return false;
    if (options->json)
        return run_print_and_free(uses_json(&counted, outcome.hash));
    uses_print_text(&counted);
    return true;
}

/* Returns the exit status. */
static int load_and_run(const run_options *options) {
    scene s;
    if (!run_load(options, &s))
        return 1;
    bool done = options->advise ? advise(options, &s)
                : options->uses ? count_and_print(options, &s)
                                : run_and_print(options, &s);
    scene_free(&s);
    return done ? 0 : 1;
}

/* Whether an argument is this option, also where another option would take it as its value. */
static bool has(int count, char **arguments, const char *option) {
    for (int i = 1; i < count; i++)
        if (strcmp(arguments[i], option) == 0)
            return true;
    return false;
}

int main(int count, char **arguments) {
    run_options options;
    jobs_options jobs;
    int status = 0;
    bool help = has(count, arguments, "--help") || has(count, arguments, "-h");
    if (!help && has(count, arguments, "--jobs"))
        return jobs_options_parse(count, arguments, &jobs) ? jobs_run(&jobs) : 2;
    if (!help && !run_options_parse(count, arguments, &options))
        return 2;
    if (help)
        run_print_help();
    else if (options.list)
        run_print_list();
    else if (options.replay)
        status = replay_file(&options) ? 0 : 1;
    else
        status = load_and_run(&options);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "thud-run: the output cannot be written\n");
        return 1;
    }
    return status;
}
