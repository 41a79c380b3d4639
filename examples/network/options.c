/* options.c: see options.h. */
#include "options.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_help(const char *program, const char *about, const option *options, int count) {
    printf("usage: %s [OPTION...]\n\n%s\n\n", program, about);
    for (int i = 0; i < count; i++) {
        const option *o = &options[i];
        printf("  --%-8s %-10s %s", o->name, o->value, o->help);
        if (o->number) {
            printf(", %lld to %lld", (long long)o->least, (long long)o->most);
        }
        if (o->number && *o->number >= o->least) {
            printf("; default %lld", (long long)*o->number);
        }
        printf("\n");
    }
    printf("  --%-8s %-10s this\n", "help", "");
}

/* Sets the variable of an option. False if the text is not a valid value. */
static int set(const option *o, const char *text) {
    if (!o->number) {
        *o->text = text;
        return *text != 0;
    }
    char *end;
    errno = 0;
    long long number = strtoll(text, &end, 10);
    *o->number = number;
    return *text && !*end && !errno && number >= o->least && number <= o->most;
}

options_result options_read(int argc, char **argv, const char *about, const option *options,
                            int count) {
    for (int at = 1; at < argc; at++) {
        const option *found = NULL;
        if (!strcmp(argv[at], "--help") || !strcmp(argv[at], "-h")) {
            print_help(argv[0], about, options, count);
            return OPTIONS_HELP;
        }
        for (int i = 0; i < count; i++) {
            found = !strncmp(argv[at], "--", 2) && !strcmp(argv[at] + 2, options[i].name)
                        ? &options[i]
                        : found;
        }
        if (!found) {
            fprintf(stderr, "%s: there is no option '%s'; --help lists them\n", argv[0], argv[at]);
            return OPTIONS_WRONG;
        }
        const char *value = at + 1 < argc ? argv[++at] : "";
        if (!set(found, value)) {
            fprintf(stderr, "%s: --%s needs %s", argv[0], found->name, found->value);
            if (found->number) {
                fprintf(stderr, ", a whole number from %lld to %lld", (long long)found->least,
                        (long long)found->most);
            }
            fprintf(stderr, ", not '%s'\n", value);
            return OPTIONS_WRONG;
        }
    }
    return OPTIONS_READ;
}
