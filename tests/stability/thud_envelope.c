/* thud_envelope.c: the program thud-envelope, which runs thud and Box2D in every extreme at full
 * length and writes the results as JSON. People call ./run envelope, which makes docs/stability.md
 * from them. */
#include "engine.h"
#include "machine.h"
#include "progress.h"
#include "record.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_EXTREMES = 32 };

typedef struct settings {
    bool wanted[MOST_EXTREMES];
    bool quick;
    unsigned entrants;
    const char *json; /* path; null: standard output */
} settings;

static void print_help(void) {
    printf(
        "usage: thud-envelope [option...]\n"
        "Drives thud, at each quality, and its rivals to the extremes, and tells what they reached, as "
        "JSON.\n\n"
        "  --only ROW     only this extreme; may be given several times\n"
        "  --quick        seconds of simulated time, as in the tests\n"
        "  --without-box2d  thud alone\n"
        "  --json FILE    writes to FILE instead of standard output\n"
        "  --help         this text\n\nExtremes:\n");
    for (int i = 0; i < EXTREME_COUNT; i++)
        printf("  %-14s %s\n", EXTREMES[i]->name, EXTREMES[i]->title);
}

static bool refuse(const char *what, const char *value) {
    fprintf(stderr, "thud-envelope: %s: %s (see --help)\n", what, value);
    return false;
}

/* Selects an extreme by its name. */
static bool want(settings *s, const char *name) {
    for (int i = 0; i < EXTREME_COUNT; i++)
        if (strcmp(EXTREMES[i]->name, name) == 0) {
            s->wanted[i] = true;
            return true;
        }
    return refuse("no such extreme", name);
}

static bool read_settings(settings *s, int argc, char **argv) {
    *s = (settings){.entrants = ON_THUD};
    s->entrants |= engine_find("box2d") ? ON_BOX2D : 0;
    s->entrants |= engine_find("chipmunk") ? ON_CHIPMUNK : 0;
    bool some = false;
    for (int i = 1; i < argc; i++) {
        const char *option = argv[i], *value = argv[i + 1];
        if (strcmp(option, "--quick") == 0) {
            s->quick = true;
        } else if (strcmp(option, "--without-box2d") == 0) {
            s->entrants = ON_THUD;
        } else if (strcmp(option, "--only") != 0 && strcmp(option, "--json") != 0) {
            return refuse("unknown option", option);
        } else if (!value) {
            return refuse("a value is missing after", option);
        } else {
            i++;
            if (strcmp(option, "--json") == 0)
                s->json = value;
            else if (!(some = want(s, value)))
                return false;
        }
    }
    for (int i = 0; !some && i < EXTREME_COUNT; i++)
        s->wanted[i] = true;
    return true;
}

/* The progress of the whole run; all extremes count the same. */
static struct {
    int done, all;
} bar;

/* Shows the progress of all extremes; `share` of the present one is done. */
static void show(const char *what, double share) {
    progress_show(what, (bar.done + share) / bar.all);
}

/* Whether the figures agree with the list of known misses; prints each difference. */
static bool check_known_misses(const extreme *x, const ledger *l) {
    bool ok = true;
    for (int i = 0; i < l->count; i++)
        for (entrant e = 0; e < ENTRANT_BOX2D; e++) {
            char why[KNOWN_MISS_TEXT];
            if (!(l->figures[i].measured & 1u << e) ||
                known_misses_judge(x, &l->figures[i], e, l->quick, why, sizeof why) !=
                    KNOWN_MISS_WRONG)
                continue;
            fprintf(stderr, "%s\n", why);
            ok = false;
        }
    return ok;
}

static bool measure(const settings *s, ledger *l, json *out) {
    bool ok = true;
    json_begin_object(out, NULL);
    machine_describe(out);
    json_bool(out, "quick", s->quick);
    json_begin_array(out, "extremes");
    for (int i = 0; i < EXTREME_COUNT; i++)
        bar.all += s->wanted[i];
    for (int i = 0; i < EXTREME_COUNT; i++) {
        if (!s->wanted[i])
            continue;
        *l = (ledger){.quick = s->quick,
                      .entrants = s->entrants & (ON_USUAL | EXTREMES[i]->also),
                      .progress = show};
        show(EXTREMES[i]->title, 0);
        EXTREMES[i]->run(l);
        bar.done++;
        progress_clear();
        record_write(out, EXTREMES[i], l);
        ok = !l->failed && check_known_misses(EXTREMES[i], l) && ok;
        fprintf(stderr, "%s: done, %d of %d\n", EXTREMES[i]->name, bar.done, bar.all);
    }
    json_end(out);
    json_end(out);
    return ok;
}

static bool run(const settings *s) {
    FILE *file = s->json ? fopen(s->json, "w") : stdout;
    if (!file)
        return refuse("cannot write", s->json);
    ledger *l = calloc(1, sizeof *l);
    json out = {.file = file};
    bool ok = l && measure(s, l, &out);
    free(l);
    bool written = fflush(file) == 0 && !ferror(file);
    if (s->json && fclose(file) != 0)
        written = false;
    return (written || refuse("could not write", s->json ? s->json : "standard output")) && ok;
}

int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help();
            return 0;
        }
    settings s;
    if (!read_settings(&s, argc, argv))
        return 2;
    return run(&s) ? 0 : 1;
}
