/* advise_text.c: prints an advice as text; each sentence is followed by the command that repeats
 * its run. */
#include "advise.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

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

static void print_link(advise_link link) {
    if (link.program)
        printf("at most %g kB linked (%s)", link.kilobytes, link.program);
    else
        printf("what is linked is not measured");
}

/* A part that was left out: what it saves, and what changes. */
static void print_off(const advise_off *off, const advise_setting *base, const advise_link *link) {
    const advise_setting *setting = &off->setting;
    double saved = base->ms - setting->ms;
    long long bytes =
        (long long)base->outcome.stats.bytes - (long long)setting->outcome.stats.bytes;
    printf("  %s: %s %.4f ms a step (%.0f %%)", off->name, saved >= 0 ? "saves" : "adds",
           fabs(saved), base->ms > 0 ? 100 * fabs(saved) / base->ms : 0);
    printf(", %s %lld bytes; ", bytes >= 0 ? "saves" : "adds", bytes >= 0 ? bytes : -bytes);
    if (off->link.program && (!link->program || off->link.kilobytes != link->kilobytes)) {
        print_link(off->link);
        printf("; ");
    }
    print_error(setting);
    if (off->same)
        printf(", no bit changes.\n");
    else if (isinf(off->moved))
        printf(", some bodies are there in one run only.\n");
    else
        printf(", bodies end up to %.3g length scales away.\n", off->moved);
    print_command(&setting->how);
}

/* The parts that can be left out, or those that cannot; of the former those that save something, or
 * those that do not. */
static void print_group(const advice *a, const char *title, bool needless, bool saves) {
    const advise_offs *offs = &a->offs;
    bool any = false;
    for (int i = 0; i < offs->count; i++) {
        const advise_off *off = &offs->offs[i];
        if (off->needless != needless || (needless && off->saves != saves))
            continue;
        if (!any)
            printf("%s\n", title);
        print_off(off, &a->series.settings[offs->base], &offs->link);
        any = true;
    }
}

static void print_offs(const advice *a) {
    char name[ADVISE_NAME_MAX];
    advise_name(&a->series.settings[a->offs.base].how, name);
    printf("\nParts left out, one at a time, at %s (", name);
    print_link(a->offs.link);
    printf("). A part is not required\nif the error is as asked for without it, and no body ends "
           "further away than that.\n");
    print_group(a, "Switch off:", true, true);
    print_group(a, "Not required, but off it saves nothing:", true, false);
    print_group(a, "Required:", false, false);
}

static void print_size(const char *lead, const advise_size *size) {
    printf("%ssize %d, %d bodies: ", lead, size->size, size->bodies);
    print_error(&size->setting);
    printf(", %.4f ms a step; stack of %d, masses %.3g times, speed %.3g of the thinnest shape a "
           "step.\n",
           size->setting.ms, size->uses.stack, size->uses.mass_ratio, size->uses.speed);
    print_command(&size->setting.how);
}

/* A series with one value times larger and larger factors. */
static void print_strain(const char *what, const char *unit, const advise_strain *strain) {
    if (strain->count == 0) {
        printf("  %s: not measured, as no larger value is valid.\n", what);
        return;
    }
    const advise_setting *last = &strain->tried[strain->count - 1];
    printf("  %s: %s at %g times %s: ", what, strain->broke ? "breaks" : "still holds",
           strain->factors[strain->count - 1], unit);
    print_error(last);
    printf(".\n");
    print_command(&last->how);
}

static void print_sizes(const advise_growth *g) {
    if (g->why_not) {
        printf("  Size: not measured, as %s.\n", g->why_not);
        return;
    }
    if (g->missed < 0)
        printf("  Size: %s.\n",
               g->gave_up ? "larger ones take too long to measure here" : "the largest holds");
    else if (g->gave_up)
        printf("  Size: between the two, sizes take too long to measure here.\n");
    if (g->held >= 0)
        print_size("  Holds: ", &g->sizes[g->held]);
    if (g->missed >= 0)
        print_size(g->sizes[g->missed].broken == ADVISE_TOO_SLOW ? "  Breaks in time: "
                                                                 : "  Breaks in accuracy: ",
                   &g->sizes[g->missed]);
}

static void print_growth(const advice *a) {
    const advise_growth *g = &a->growth;
    advise_first first = advise_first_of(g);
    printf("\nWhere it breaks first as it grows (a step takes more than %.4g ms, or the error is "
           "larger than asked for):\n",
           g->budget_ms);
    if (!*first.what)
        printf("nothing that was tried breaks it.\n");
    else if (first.factor <= 1)
        printf("it does not hold as it is.\n");
    else
        printf("in %s, at %.3g times what it has.\n",
               strcmp(first.what, "time") == 0 ? "time as its size grows" : first.what,
               first.factor);
    print_sizes(g);
    if (g->no_speeds)
        printf("  Speed: not measured, as %s.\n", g->no_speeds);
    else
        print_strain("Speed", "the speed of all that moves, by so many times fewer steps a second",
                     &g->faster);
    print_strain("Mass", "the mass of the heaviest body, the highest of equal ones", &g->heavier);
}

static void print_table(const advise_series *series) {
    printf("\nAll settings that were tried (error in length scales, ms of a step, runs):\n");
    for (int i = 0; i < series->count; i++) {
        const advise_setting *setting = &series->settings[i];
        char name[ADVISE_NAME_MAX], error[32];
        advise_name(&setting->how, name);
        if (setting->outcome.quarantined > 0)
            snprintf(error, sizeof error, "not finite");
        else if (isinf(setting->error))
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
    print_offs(a);
    print_growth(a);
    print_table(series);
}
