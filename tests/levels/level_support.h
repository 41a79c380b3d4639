/* level_support.h: reads the maps in tests/levels/maps, and searches the reader's report. */
#ifndef LEVEL_SUPPORT_H
#define LEVEL_SUPPORT_H

#include "level.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Reads a map, skipping everything that the reader cannot represent. */
static inline scene read_file(const char *name, level_report *report) {
    char path[64];
    snprintf(path, sizeof path, "tests/levels/maps/%s", name);
    scene s;
    if (!level_read_file(path, true, &s, report))
        fail_msg("%s: %s", path, report->problems[0].text);
    return s;
}

/* Whether the report has a problem of this severity with this text in it. */
static inline bool says(const level_report *report, level_severity severity, const char *text) {
    for (int i = 0; i < report->count; i++)
        if (report->problems[i].severity == severity && strstr(report->problems[i].text, text))
            return true;
    return false;
}

#endif
