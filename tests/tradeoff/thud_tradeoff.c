/* thud_tradeoff.c: the program thud-tradeoff, which measures cases and writes them as JSON to
 * stdout. People call ./run tradeoff, which runs it case by case and writes docs/tradeoff.md and
 * its pictures. */
#include "json.h"
#include "machine.h"
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPETITIONS_MAX = 100, CASES_MAX = 64 };

typedef struct options {
    bool help, list, progress;
    const tradeoff_case *cases[CASES_MAX];
    int case_count;
    measure_plan plan;
} options;

static const char USAGE[] =
    "usage: thud-tradeoff [OPTION...]\n"
    "\n"
    "Runs every case, or the named ones, in thud at each quality and, where this build has it, in\n"
    "Box2D v3.2 and, for joints, Chipmunk 7, and writes cost and error as JSON to stdout.\n"
    "\n"
    "  --case NAME    only this case; may be given several times\n"
    "  --repeat N     timed repetitions, 1 to 100 (default 3, with --quick 1)\n"
    "  --quick        small scenes and short runs, which show that it works\n"
    "  --progress     tells on stderr how far it is: lines of a case and a fraction\n"
    "  --list         names the cases, and how many bodies and steps each has\n"
    "  --help         this\n";

static bool refuse(const char *what, const char *which) {
    fprintf(stderr, "thud-tradeoff: %s%s%s (--help shows the options)\n", what, which ? " " : "",
            which ? which : "");
    return false;
}

static void tell_progress(const char *case_name, double fraction) {
    static int last = -1;
    int permille = (int)(1000 * fraction);
    if (permille != last)
        fprintf(stderr, "%s %.3f\n", case_name, fraction);
    last = permille;
}

static bool read_value(options *o, const char *name, const char *value) {
    if (strcmp(name, "--case") != 0 && strcmp(name, "--repeat") != 0)
        return refuse("unknown option", name);
    if (!value)
        return refuse("a value is missing after", name);
    if (strcmp(name, "--case") == 0) {
        const tradeoff_case *c = cases_find(value);
        if (!c || o->case_count == CASES_MAX)
            return refuse("there is no case", value);
        o->cases[o->case_count++] = c;
        return true;
    }
    char *end;
    long n = strtol(value, &end, 10);
    if (end == value || *end || n < 1 || n > REPETITIONS_MAX)
        return refuse("--repeat wants a number from 1 to 100, not", value);
    o->plan.repetitions = (int)n;
    return true;
}

static bool read_options(options *o, int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0)
            o->help = true;
        else if (strcmp(argv[i], "--list") == 0)
            o->list = true;
        else if (strcmp(argv[i], "--quick") == 0)
            o->plan.quick = true;
        else if (strcmp(argv[i], "--progress") == 0)
            o->plan.progress = tell_progress;
        else if (read_value(o, argv[i], i + 1 < argc ? argv[i + 1] : NULL))
            i++;
        else
            return false;
    }
    if (o->case_count == 0)
        for (int i = 0; i < cases_count(); i++)
            o->cases[o->case_count++] = cases_at(i);
    if (o->plan.repetitions == 0)
        o->plan.repetitions = o->plan.quick ? 1 : 3;
    return true;
}

static void write_point(json *out, const point *p) {
    const engine_settings *with = &p->how->with;
    json_begin_object(out, NULL);
    json_text(out, "engine", p->how->engine->name);
    json_text(out, "curve", p->how->curve);
    json_text(out, "setting", p->how->name);
    json_number(out, "substeps", with->quality ? with->quality->substeps : with->substeps);
    if (with->iterations > 0)
        json_number(out, "iterations", with->iterations);
    json_number(out, "contact_hertz",
                with->quality
                    ? with->quality->contact_stiffness * with->quality->substeps / ENGINE_TIME_STEP
                    : with->contact_hertz);
    json_number(out, "error", p->errors.error);
    json_number(out, "ms_median", p->cost.median);
    json_number(out, "ms_mean", p->cost.mean);
    json_number(out, "ms_total", p->cost.total);
    json_number(out, "penetration_worst", p->errors.penetration_worst);
    json_number(out, "penetration_mean", p->errors.penetration_mean);
    json_number(out, "energy_gained", p->errors.energy_gained);
    json_number(out, "lost", p->errors.lost);
    json_end(out);
}

static void write_case(json *out, const measurement *m) {
    json_begin_object(out, NULL);
    json_text(out, "case", m->c->name);
    json_text(out, "title", m->c->title);
    json_text(out, "about", m->c->about);
    json_text(out, "error", m->c->error);
    json_text(out, "unit", m->c->unit);
    json_number(out, "floor", m->c->floor);
    json_number(out, "chance", m->c->chance);
    json_number(out, "bodies", m->bodies);
    json_number(out, "steps", m->steps);
    json_number(out, "repetitions", m->repetitions);
    json_begin_array(out, "points");
    for (int i = 0; i < m->point_count; i++)
        write_point(out, &m->points[i]);
    json_end(out);
    json_end(out);
}

static bool run_cases(const options *o) {
    json out = {.file = stdout};
    json_begin_object(&out, NULL);
    machine_describe(&out);
    json_bool(&out, "quick", o->plan.quick);
    json_begin_array(&out, "cases");
    for (int i = 0; i < o->case_count; i++) {
        measurement m;
        if (!measure_case(o->cases[i], &o->plan, &m))
            return false;
        write_case(&out, &m);
        fflush(stdout);
    }
    json_end(&out);
    json_end(&out);
    if (fflush(stdout) != 0 || ferror(stdout))
        return refuse("cannot write to stdout", NULL);
    return true;
}

static bool list_cases(bool quick) {
    for (int i = 0; i < cases_count(); i++) {
        const tradeoff_case *c = cases_at(i);
        scene s;
        if (!case_fill(c, quick, &s))
            return false;
        printf("%-16s %5d %5d  %s\n", c->name, s.body_count, quick ? c->quick_steps : c->steps,
               c->about);
        scene_free(&s);
    }
    return true;
}

int main(int argc, char **argv) {
    options o = {0};
    if (!read_options(&o, argc, argv))
        return 2;
    if (o.help) {
        fputs(USAGE, stdout);
        return 0;
    }
    if (o.list)
        return list_cases(o.plan.quick) ? 0 : 1;
    return run_cases(&o) ? 0 : 1;
}
