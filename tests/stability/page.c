/* page.c: writes Markdown. */
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void write_value(FILE *out, double value) {
    if (isnan(value))
        fprintf(out, "not a number");
    else if (isinf(value))
        fprintf(out, "fails");
    else
        fprintf(out, "%.4g", value);
}

/* Whom a bound binds, in a word or two. */
static void write_bound(FILE *out, const bound *b) {
    if (b->kind == BOUND_NONE) {
        fprintf(out, "–");
        return;
    }
    fprintf(out, b->kind == BOUND_AT_MOST ? "≤ %.4g" : "≥ %.4g", b->value);
    if ((b->on & ON_THUD) == ON_THUD) {
        fprintf(out, " at all");
        return;
    }
    const char *separator = " at ";
    for (entrant e = 0; e < ENTRANTS; e++)
        if (b->on & 1u << e) {
            fprintf(out, "%s%s", separator, entrant_name(e));
            separator = ", ";
        }
}

static bool holds_for_all(const figure *f) {
    for (entrant e = 0; e < ENTRANTS; e++)
        if (!figure_holds(f, e))
            return false;
    return true;
}

static void write_verdict(FILE *out, const figure *f) {
    if (f->bound.kind == BOUND_NONE) {
        fprintf(out, "–");
        return;
    }
    if (holds_for_all(f)) {
        fprintf(out, "yes");
        return;
    }
    const char *separator = "**no**: ";
    for (entrant e = 0; e < ENTRANTS; e++)
        if (!figure_holds(f, e)) {
            fprintf(out, "%s%s reached ", separator, entrant_name(e));
            write_value(out, f->reached[e]);
            separator = ", ";
        }
}

void page_write_table(FILE *out, const ledger *l) {
    fprintf(out, "| extreme | bound |");
    for (entrant e = 0; e < ENTRANTS; e++)
        fprintf(out, " %s |", entrant_name(e));
    fprintf(out, " holds? |\n|---|---|");
    for (int i = 0; i < ENTRANTS; i++)
        fprintf(out, "---|");
    fprintf(out, "---|\n");
    for (int i = 0; i < l->count; i++) {
        const figure *f = &l->figures[i];
        fprintf(out, "| %s | ", f->what);
        write_bound(out, &f->bound);
        fprintf(out, " |");
        for (entrant e = 0; e < ENTRANTS; e++) {
            fprintf(out, " ");
            if (f->measured & 1u << e)
                write_value(out, f->reached[e]);
            else
                fprintf(out, "–");
            fprintf(out, " |");
        }
        fprintf(out, " ");
        write_verdict(out, f);
        fprintf(out, " |\n");
    }
}

/* How many of the extreme's bounds are kept, by thud where e is ENTRANTS, else by that entrant as
 * if they bound him. */
static int count_kept(const ledger *l, entrant as) {
    int kept = 0;
    for (int i = 0; i < l->count; i++) {
        figure f = l->figures[i];
        if (f.bound.kind == BOUND_NONE)
            continue;
        if (as != ENTRANTS)
            f.bound.on = 1u << as;
        kept += as == ENTRANTS ? holds_for_all(&f)
                               : (f.measured & 1u << as) != 0 && figure_holds(&f, as);
    }
    return kept;
}

static int count_bounds(const ledger *l, entrant as) {
    int bounds = 0;
    for (int i = 0; i < l->count; i++)
        bounds += l->figures[i].bound.kind != BOUND_NONE &&
                  (as == ENTRANTS || l->figures[i].measured & 1u << as);
    return bounds;
}

static void write_summary(FILE *out, const page_part *parts, int count) {
    fprintf(out, "| extreme | bounds that thud keeps | that Box2D would keep |\n|---|---|---|\n");
    for (int i = 0; i < count; i++) {
        const ledger *l = parts[i].ledger;
        int box2d = count_bounds(l, ENTRANT_BOX2D);
        fprintf(out, "| [%s](#%s) | %d of %d |", parts[i].extreme->title, parts[i].extreme->name,
                count_kept(l, ENTRANTS), count_bounds(l, ENTRANTS));
        if (box2d > 0)
            fprintf(out, " %d of %d |\n", count_kept(l, ENTRANT_BOX2D), box2d);
        else
            fprintf(out, " – |\n");
    }
}

/* The line after `from` that starts with "## ", or the end of the text. */
static const char *next_heading(const char *from) {
    const char *at = strncmp(from, "## ", 3) == 0 ? from : strstr(from, "\n## ");
    return !at ? from + strlen(from) : *at == '\n' ? at + 1 : at;
}

static const char *line_end(const char *from) {
    return from + strcspn(from, "\n");
}

static void write_note(FILE *out, const char *notes, const char *name) {
    for (const char *at = next_heading(notes); *at; at = next_heading(line_end(at))) {
        const char *title = at + 3, *end = line_end(at);
        if ((size_t)(end - title) != strlen(name) || strncmp(title, name, strlen(name)) != 0)
            continue;
        const char *stop = next_heading(end), *text = *end == '\n' ? end + 1 : end;
        while (stop > text && stop[-1] == '\n')
            stop--;
        fprintf(out, "%.*s\n", (int)(stop - text), text);
    }
}

bool page_notes_stray(const char *notes, const char **line) {
    for (const char *at = next_heading(notes); *at; at = next_heading(line_end(at))) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)(line_end(at) - at - 3), at + 3);
        if (!extreme_find(name)) {
            *line = at;
            return true;
        }
    }
    return false;
}

void page_write(FILE *out, const page_part *parts, int count, const char *notes) {
    fwrite(notes, 1, (size_t)(next_heading(notes) - notes), out);
    write_summary(out, parts, count);
    for (int i = 0; i < count; i++) {
        const extreme *x = parts[i].extreme;
        fprintf(out, "\n<a id=\"%s\"></a>\n\n## %s\n\n%s\n\n", x->name, x->title, x->about);
        page_write_table(out, parts[i].ledger);
        write_note(out, notes, x->name);
    }
}
