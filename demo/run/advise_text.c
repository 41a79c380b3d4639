/* advise_text.c: prints an advice as text; each sentence is followed by the command that repeats
 * its run. */
#include "advise.h"

#include <math.h>
#include <stdio.h>

static void print_command(const run_options *how) {
    char command[RUN_COMMAND_MAX];
    run_command(how, command);
    printf("    %s\n", command);
}

/* Prints an error in length scales, or why there is none. */
static void print_error(const advise_setting *setting) {
    if (setting->outcome.quarantined > 0)
        printf("bodies become non-finite");
    else if (setting->outcome.passed > 0)
        printf("bodies pass through what stands %ld times", setting->outcome.passed);
    else
        printf("error %.3g", setting->error);
}

/* A setting as a sentence with its command. */
static void print_setting(const char *lead, const advise_setting *setting) {
    char name[ADVISE_NAME_MAX];
    advise_name(&setting->how, name);
    printf("%s%s: ", lead, name);
    print_error(setting);
    printf(", %.4f ms a step (slowest %.4f).\n", setting->ms, setting->ms_max);
    print_command(&setting->how);
}

static void print_table(const advise_series *series) {
    printf("\nAll settings that were tried (error in length scales, ms of a step, runs):\n");
    for (int i = 0; i < series->count; i++) {
        const advise_setting *setting = &series->settings[i];
        char name[ADVISE_NAME_MAX], error[32];
        advise_name(&setting->how, name);
        if (isinf(setting->error))
            snprintf(error, sizeof error, "passed %ld", setting->outcome.passed);
        else
            snprintf(error, sizeof error, "%.3g", setting->error);
        printf("  %-30s %-12s %9.4f %3d%s\n", name, error, setting->ms, setting->runs,
               i == series->advised    ? "  advised"
               : advise_meets(setting) ? "  meets it"
                                       : "");
    }
}

void advise_print_text(const advice *a) {
    const advise_series *series = &a->series;
    const run_options *o = a->options;
    printf("%s, %ld steps, %d bodies. Largest error: %g length scales of %g m", a->scene->name,
           o->steps, a->scene->body_count, o->max_error, a->scene->length_scale);
    if (isfinite(o->budget))
        printf("; budget: %g ms a step", o->budget);
    printf(".\n\n");
    if (series->advised >= 0) {
        print_setting("Advised: ", &series->settings[series->advised]);
    } else {
        printf("No setting that was tried meets the error%s.\n",
               isfinite(o->budget) ? " within the budget" : "");
        print_setting("Nearest: ", &series->settings[series->nearest]);
    }
    if (series->now != series->advised)
        print_setting("Named on the command line: ", &series->settings[series->now]);
    printf("\nWhat the scene has, and what it used at the setting of the command line:\n");
    uses_print_text(&a->uses);
    run_options count = series->settings[series->now].how;
    count.uses = true;
    print_command(&count);
    print_table(series);
}
