/* document.c: parses a file of the Tiled editor, in JSON or XML, into JSON. */
#include "reader.h"

#include <stdio.h>
#include <string.h>

static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* The line, counted from 1, in which parsing stopped. */
static int line_of(const char *text, const char *end) {
    int line = 1;
    for (const char *p = text; end && p < end; p++)
        line += *p == '\n';
    return line;
}

cJSON *level_document(const char *text, size_t length, char *trouble, size_t size) {
    /* The UTF-8 byte order mark, which some editors write first. */
    static const char MARK[] = "\xEF\xBB\xBF";
    size_t at = length >= 3 && memcmp(text, MARK, 3) == 0 ? 3 : 0;
    while (at < length && is_space(text[at]))
        at++;
    if (at < length && text[at] == '<')
        return level_tmx(text + at, length - at, trouble, size);
    const char *end = NULL;
    cJSON *json = cJSON_ParseWithLengthOpts(text, length, &end, false);
    while (json && end < text + length && is_space(*end))
        end++;
    if (json && end == text + length)
        return json;
    cJSON_Delete(json);
    snprintf(trouble, size, "this is neither JSON nor XML: not JSON from line %d on",
             line_of(text, end));
    return NULL;
}
