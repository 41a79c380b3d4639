/* progress.c: see progress.h. The line is written to stderr, so that stdout has results only. */
#include "progress.h"

#include <stdio.h>
#include <unistd.h>

enum { WIDTH = 40 };

void progress_show(const char *what, double fraction) {
    if (!isatty(STDERR_FILENO))
        return;
    fprintf(stderr, "\r%-*.*s %3.0f %%", WIDTH - 6, WIDTH - 6, what, 100 * fraction);
    fflush(stderr);
}

void progress_clear(void) {
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%*s\r", WIDTH, "");
}
