/* record.c: see record.h. */
#include "record.h"

#include <math.h>

static void write_bound(json *out, const bound *b) {
    if (b->kind == BOUND_NONE)
        return;
    json_begin_object(out, "bound");
    json_text(out, "kind", b->kind == BOUND_AT_MOST ? "at most" : "at least");
    json_number(out, "value", b->value);
    json_begin_array(out, "on");
    for (entrant e = 0; e < ENTRANTS; e++)
        if (b->on & 1u << e)
            json_text(out, NULL, entrant_name(e));
    json_end(out);
    json_end(out);
}

static void write_figure(json *out, const figure *f) {
    json_begin_object(out, NULL);
    json_text(out, "what", f->what);
    write_bound(out, &f->bound);
    json_begin_object(out, "reached");
    for (entrant e = 0; e < ENTRANTS; e++) {
        if (!(f->measured & 1u << e))
            continue;
        if (isnan(f->reached[e]))
            json_text(out, entrant_name(e), "not a number");
        else
            json_number(out, entrant_name(e), f->reached[e]);
    }
    json_end(out);
    json_end(out);
}

void record_write(json *out, const extreme *x, const ledger *l) {
    json_begin_object(out, NULL);
    json_text(out, "name", x->name);
    json_text(out, "title", x->title);
    json_text(out, "about", x->about);
    json_begin_array(out, "figures");
    for (int i = 0; i < l->count; i++)
        write_figure(out, &l->figures[i]);
    json_end(out);
    json_end(out);
}
