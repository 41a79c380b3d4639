/* json.h: writes JSON value by value, with commas, indents and escapes. A writer without a file
 * writes nothing, so that callers need no checks. */
#ifndef THUD_BENCH_JSON_H
#define THUD_BENCH_JSON_H

#include <stdbool.h>
#include <stdio.h>

enum { JSON_DEPTH = 8 };

typedef struct json {
    FILE *file; /* null: nothing is written */
    int depth;
    char closing[JSON_DEPTH]; /* closing bracket of each open object or array */
    bool empty[JSON_DEPTH];
} json;

/* `key` is null inside an array and for the outermost value. */
void json_begin_object(json *out, const char *key);
void json_begin_array(json *out, const char *key);
void json_end(json *out); /* ends the innermost open object or array */
void json_text(json *out, const char *key, const char *value);
/* Writes six significant digits; null if the value is not finite. */
void json_number(json *out, const char *key, double value);
void json_bool(json *out, const char *key, bool value);

#endif
