/* thud_envelope.c: thud-envelope, drives thud and Box2D to every extreme at full length and writes
 * what they reached. */
#include "engine.h"
#include "page.h"
#include "progress.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_EXTREMES = 32 };

typedef struct settings {
    bool wanted[MOST_EXTREMES];
    bool quick;
    unsigned entrants;
    const char *out, *notes; /* null: standard output; no notes */
} settings;

static void print_help(void) {
    printf(
        "usage: thud-envelope [option...]\n"
        "Drives thud, at each quality, and Box2D to the extremes, and tells what they reached.\n\n"
        "  --only ROW     only this extreme; may be given several times\n"
        "  --quick        seconds of simulated time, as in the tests\n"
        "  --without-box2d  thud alone\n"
        "  --out FILE     writes the page to FILE instead of standard output\n"
        "  --notes FILE   the text that goes between the tables\n"
        "  --help         this text\n\nExtremes:\n");
    for (int i = 0; i < EXTREME_COUNT; i++)
        printf("  %-14s %s\n", EXTREMES[i]->name, EXTREMES[i]->title);
}

static bool refuse(const char *what, const char *value) {
    fprintf(stderr, "thud-envelope: %s: %s (see --help)\n", what, value);
    return false;
}

static bool want(settings *s, const char *name) {
    for (int i = 0; i < EXTREME_COUNT; i++)
        if (strcmp(EXTREMES[i]->name, name) == 0) {
            s->wanted[i] = true;
            return true;
        }
    return refuse("no such extreme", name);
}

static bool read_settings(settings *s, int argc, char **argv) {
    *s = (settings){.entrants = engine_find("box2d") ? ON_ALL : ON_THUD};
    bool some = false;
    for (int i = 1; i < argc; i++) {
        const char *option = argv[i], *value = argv[i + 1];
        if (strcmp(option, "--quick") == 0) {
            s->quick = true;
        } else if (strcmp(option, "--without-box2d") == 0) {
            s->entrants = ON_THUD;
        } else if (strcmp(option, "--only") != 0 && strcmp(option, "--out") != 0 &&
                   strcmp(option, "--notes") != 0) {
            return refuse("unknown option", option);
        } else if (!value) {
            return refuse("a value is missing after", option);
        } else {
            i++;
            if (strcmp(option, "--out") == 0)
                s->out = value;
            else if (strcmp(option, "--notes") == 0)
                s->notes = value;
            else if (!(some = want(s, value)))
                return false;
        }
    }
    for (int i = 0; !some && i < EXTREME_COUNT; i++)
        s->wanted[i] = true;
    return true;
}

/* The whole file as text; null, and a line on stderr, when it cannot be read. */
static char *read_text(const char *path) {
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    long size = -1;
    if (file && fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0)
        text = calloc((size_t)size + 1, 1);
    if (text) {
        rewind(file);
        if (fread(text, 1, (size_t)size, file) != (size_t)size) {
            free(text);
            text = NULL;
        }
    }
    if (file)
        fclose(file);
    if (!text)
        refuse("cannot read", path);
    return text;
}

/* The bar is of the whole run, as if every extreme took as long. */
static struct {
    int done, all;
} bar;

static void show(const char *what, double share) {
    progress_show(what, (bar.done + share) / bar.all);
}

/* Says where the list of known misses is no longer true. A short run keeps more bounds. */
static void check_known_misses(const extreme *x, const ledger *l) {
    for (int i = 0; i < l->count; i++)
        for (entrant e = 0; e < ENTRANT_BOX2D; e++) {
            const figure *f = &l->figures[i];
            bool known = (known_misses(x, f) & 1u << e) != 0, kept = figure_holds(f, e);
            if (!known && !kept)
                fprintf(stderr, "%s: %s: missed by %s, and not in known_misses.c\n", x->name,
                        f->what, entrant_name(e));
            else if (known && kept && !l->quick)
                fprintf(stderr, "%s: %s: kept by %s, and still in known_misses.c\n", x->name,
                        f->what, entrant_name(e));
        }
}

static bool measure(const settings *s, ledger *ledgers, page_part *parts) {
    bool ok = true;
    for (int i = 0; i < EXTREME_COUNT; i++)
        bar.all += s->wanted[i];
    for (int i = 0; i < EXTREME_COUNT; i++) {
        if (!s->wanted[i])
            continue;
        ledger *l = &ledgers[bar.done];
        *l = (ledger){.quick = s->quick, .entrants = s->entrants, .progress = show};
        show(EXTREMES[i]->title, 0);
        EXTREMES[i]->run(l);
        parts[bar.done++] = (page_part){EXTREMES[i], l};
        progress_clear();
        check_known_misses(EXTREMES[i], l);
        fprintf(stderr, "%s: done, %d of %d\n", EXTREMES[i]->name, bar.done, bar.all);
        ok = ok && !l->failed;
    }
    return ok;
}

static bool write_page(const settings *s, const page_part *parts, const char *notes) {
    FILE *file = s->out ? fopen(s->out, "w") : stdout;
    if (!file)
        return refuse("cannot write", s->out);
    page_write(file, parts, bar.done, notes);
    bool written = fflush(file) == 0 && !ferror(file);
    if (s->out && fclose(file) != 0)
        written = false;
    return written || refuse("could not write", s->out ? s->out : "standard output");
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
    char *notes = s.notes ? read_text(s.notes) : calloc(1, 1);
    const char *stray;
    if (!notes)
        return 2;
    if (page_notes_stray(notes, &stray)) {
        fprintf(stderr, "thud-envelope: the notes name no extreme: %.*s\n",
                (int)strcspn(stray, "\n"), stray);
        free(notes);
        return 2;
    }
    ledger *ledgers = calloc((size_t)EXTREME_COUNT, sizeof *ledgers);
    page_part *parts = calloc((size_t)EXTREME_COUNT, sizeof *parts);
    bool ok = ledgers && parts && EXTREME_COUNT <= MOST_EXTREMES && measure(&s, ledgers, parts);
    ok = write_page(&s, parts, notes) && ok;
    free(parts);
    free(ledgers);
    free(notes);
    return ok ? 0 : 1;
}
