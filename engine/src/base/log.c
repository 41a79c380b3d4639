/* log.c: a log function for callers, which writes to stderr. It has a file of its own, so that a
 * program that does not name it does not link the C library's output functions. */
#include "thud/thud_hooks.h"

#include <stdio.h>

void thud_log_to_stderr(thud_result result, const char *message, void *context) {
    (void)context;
    const char *refused = result == THUD_OK ? "" : "refused: ";
    fprintf(stderr, "thud: %s%s\n", refused, message);
}
