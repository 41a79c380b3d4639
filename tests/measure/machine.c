/* machine.c: see machine.h. A value that cannot be determined is written as "unknown". */
#include "machine.h"

#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#if defined(__clang__)
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

/* Reads the first processor's name; on Linux only. */
static void read_processor(char *out, size_t size) {
    snprintf(out, size, "unknown");
    FILE *file = fopen("/proc/cpuinfo", "r");
    char line[512];
    while (file && fgets(line, sizeof line, file)) {
        char *value = strchr(line, ':');
        if (strncmp(line, "model name", 10) == 0 && value) {
            value[strcspn(value, "\n")] = '\0';
            snprintf(out, size, "%s", value + 1 + strspn(value + 1, " "));
            break;
        }
    }
    if (file)
        fclose(file);
}

void machine_describe(json *out) {
    char processor[256], date[32] = "unknown", system[256] = "unknown";
    read_processor(processor, sizeof processor);
    time_t now = time(NULL);
    struct tm utc;
    if (gmtime_r(&now, &utc))
        strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    struct utsname name;
    if (uname(&name) == 0)
        snprintf(system, sizeof system, "%.60s %.60s", name.sysname, name.machine);
    const char *commit = getenv("THUD_COMMIT");
    json_begin_object(out, "about");
    json_text(out, "date", date);
    json_text(out, "commit", commit && *commit ? commit : "unknown");
    json_text(out, "processor", processor);
    json_number(out, "processors", (double)sysconf(_SC_NPROCESSORS_ONLN));
    json_text(out, "system", system);
    json_text(out, "compiler", COMPILER);
#ifdef THUD_BOX2D_BUILD
    json_text(out, "box2d", THUD_BOX2D_BUILD);
#else
    json_text(out, "box2d", "not built");
#endif
#ifdef THUD_RAPIER_BUILD
    json_text(out, "rapier", THUD_RAPIER_BUILD);
#endif
    json_end(out);
}
