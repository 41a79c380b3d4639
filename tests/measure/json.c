/* json.c: see json.h. The two outermost levels are indented with a line for each member; deeper
 * objects are on one line, which keeps files with many results readable. */
#include "json.h"

#include <assert.h>
#include <math.h>

enum { INDENTED = 2 };

static void write_escaped(FILE *file, const char *text) {
    fputc('"', file);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(file, "\\u%04x", *c);
        else
            fputc(*c, file);
    }
    fputc('"', file);
}

/* Writes what precedes a value: the comma after the previous one, a line break, and the key. */
static void lead_in(json *out, const char *key) {
    if (out->depth > 0) {
        bool first = out->empty[out->depth - 1];
        out->empty[out->depth - 1] = false;
        if (!first)
            fputc(',', out->file);
        if (out->depth <= INDENTED)
            fprintf(out->file, "\n%*s", 2 * out->depth, "");
        else if (!first)
            fputc(' ', out->file);
    }
    if (key) {
        write_escaped(out->file, key);
        fputs(": ", out->file);
    }
}

static void begin(json *out, const char *key, char opening, char closing) {
    if (!out->file)
        return;
    assert(out->depth < JSON_DEPTH);
    lead_in(out, key);
    fputc(opening, out->file);
    out->closing[out->depth] = closing;
    out->empty[out->depth] = true;
    out->depth++;
}

void json_begin_object(json *out, const char *key) {
    begin(out, key, '{', '}');
}

void json_begin_array(json *out, const char *key) {
    begin(out, key, '[', ']');
}

void json_end(json *out) {
    if (!out->file)
        return;
    assert(out->depth > 0);
    out->depth--;
    if (out->depth < INDENTED && !out->empty[out->depth])
        fprintf(out->file, "\n%*s", 2 * out->depth, "");
    fputc(out->closing[out->depth], out->file);
    if (out->depth == 0)
        fputc('\n', out->file);
}

void json_text(json *out, const char *key, const char *value) {
    if (!out->file)
        return;
    lead_in(out, key);
    write_escaped(out->file, value);
}

void json_number(json *out, const char *key, double value) {
    if (!out->file)
        return;
    lead_in(out, key);
    if (isfinite(value))
        fprintf(out->file, fabs(value) < 1e15 && value == floor(value) ? "%.0f" : "%.6g", value);
    else
        fputs("null", out->file);
}

void json_bool(json *out, const char *key, bool value) {
    if (!out->file)
        return;
    lead_in(out, key);
    fputs(value ? "true" : "false", out->file);
}
