/* jobs_options.c: parses the command line of thud-run --jobs. */
#define _POSIX_C_SOURCE 200809L

#include "jobs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Largest number of parts that --part takes. */
enum { PARTS_MAX = 1000000 };

/* The number of processors that this program may use, 1 where the system does not say it. */
static int processors(void) {
    long count = 1;
#ifdef _SC_NPROCESSORS_ONLN
    count = sysconf(_SC_NPROCESSORS_ONLN);
#endif
    return count < 1 ? 1 : count > THUD_WORKERS_MAX ? THUD_WORKERS_MAX : (int)count;
}

/* Parses a whole number in 1..high that ends at the character `end`; *text is moved behind it. */
static bool parse_count(const char **text, char end, long high, int *out) {
    char *stop;
    if (**text < '0' || **text > '9')
        return false;
    long value = strtol(*text, &stop, 10);
    if (*stop != end || value < 1 || value > high)
        return false;
    *out = (int)value;
    *text = stop + 1;
    return true;
}

static bool parse_part(const char *text, jobs_options *out) {
    if (parse_count(&text, '/', PARTS_MAX, &out->part) &&
        parse_count(&text, '\0', PARTS_MAX, &out->parts) && out->part <= out->parts)
        return true;
    fprintf(stderr, "thud-run: --part takes K/N with K from 1 to N, N at most %d\n", PARTS_MAX);
    return false;
}

static bool parse_workers(const char *text, jobs_options *out) {
    if (parse_count(&text, '\0', THUD_WORKERS_MAX, &out->workers))
        return true;
    fprintf(stderr, "thud-run: --workers takes a whole number from 1 to %d, not '%s'\n",
            THUD_WORKERS_MAX, text);
    return false;
}

/* Parses an option that takes a value. False after a message. */
static bool parse_valued(const char *option, const char *value, jobs_options *out) {
    if (!value) {
        fprintf(stderr, "thud-run: %s needs a value; see thud-run --help\n", option);
        return false;
    }
    if (strcmp(option, "--workers") == 0)
        return parse_workers(value, out);
    if (strcmp(option, "--part") == 0)
        return parse_part(value, out);
    *(strcmp(option, "--jobs") == 0 ? &out->file : &out->out) = value;
    return true;
}

bool jobs_options_parse(int count, char **arguments, jobs_options *out) {
    *out = (jobs_options){.workers = processors(), .part = 1, .parts = 1, .times = true};
    for (int i = 1; i < count; i++) {
        const char *argument = arguments[i];
        if (strcmp(argument, "--resume") == 0) {
            out->resume = true;
        } else if (strcmp(argument, "--no-times") == 0) {
            out->times = false;
        } else if (strcmp(argument, "--jobs") == 0 || strcmp(argument, "--out") == 0 ||
                   strcmp(argument, "--workers") == 0 || strcmp(argument, "--part") == 0) {
            if (!parse_valued(argument, arguments[++i], out))
                return false;
        } else {
            fprintf(stderr,
                    "thud-run: beside --jobs there are --out, --resume, --workers, --part and "
                    "--no-times; '%s' belongs into the jobs\n",
                    argument);
            return false;
        }
    }
    if (out->resume && !out->out) {
        fprintf(stderr, "thud-run: --resume needs --out, the file that it continues\n");
        return false;
    }
    return true;
}
