/* json.h: writes JSON piece by piece, with commas, indents and escapes in the right places. A
 * writer without a file writes nothing, so that callers need not ask. */
#ifndef THUD_BENCH_JSON_H
#define THUD_BENCH_JSON_H

#include <stdbool.h>
#include <stdio.h>

enum { JSON_DEPTH = 8 };

typedef struct json {
    FILE *file; /* null: nothing is written */
    int depth;
    char closing[JSON_DEPTH]; /* of each open object or array */
    bool empty[JSON_DEPTH];
} json;

/* `key` is null inside an array and for the outermost value. */
void json_begin_object(json *out, const char *key);
void json_begin_array(json *out, const char *key);
void json_end(json *out); /* the innermost of what is open */
void json_text(json *out, const char *key, const char *value);
/* Six digits; null for what is not finite. */
void json_number(json *out, const char *key, double value);
void json_bool(json *out, const char *key, bool value);

#endif
