/* log.c: a log that is ready to use. Alone in its file: a program that does not name it does not
 * link the C library's output. */
#include "thud/thud_hooks.h"

#include <stdio.h>

void thud_log_to_stderr(thud_result result, const char *message, void *context) {
    (void)context;
    const char *refused = result == THUD_OK ? "" : "refused: ";
    fprintf(stderr, "thud: %s%s\n", refused, message);
}
