/* progress.c: see progress.h. */
#include "progress.h"

#include "session.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static const char *folder;

static void write_calls(void) {
    char path[512];
    snprintf(path, sizeof path, "%s.%d", folder, (int)getpid());
    FILE *file = fopen(path, "w");
    if (file) {
        fprintf(file, "%" PRIu64 "\n", fuzz_calls_made);
        fclose(file);
    }
}

void progress_tell(void) {
    static bool begun;
    static uint64_t told;
    if (!begun) {
        begun = true;
        folder = getenv("FUZZ_PROGRESS");
        if (folder) {
            atexit(write_calls);
        }
    }
    if (folder && fuzz_calls_made - told > 20000) {
        told = fuzz_calls_made;
        write_calls();
    }
}
