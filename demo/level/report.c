/* report.c: collects the problems of a level. */
#include "reader.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void level_report_free(level_report *report) {
    free(report->problems);
    *report = (level_report){0};
}

/* Room for one more problem; null if memory runs out or LEVEL_PROBLEMS are reached: then it is only
 * counted. */
static level_problem *next_problem(level_report *report) {
    if (report->count == LEVEL_PROBLEMS)
        return NULL;
    if (report->count == report->capacity) {
        int wanted = report->capacity ? 2 * report->capacity : 16;
        level_problem *grown = realloc(report->problems, (size_t)wanted * sizeof *grown);
        if (!grown)
            return NULL;
        report->problems = grown;
        report->capacity = wanted;
    }
    return &report->problems[report->count++];
}

/* Adds a problem. Its text begins with the object's id, or with `where`. */
static void add(level_report *report, level_severity severity, uint32_t object, const char *where,
                const char *format, va_list arguments) {
    if (severity == LEVEL_NOTE)
        report->notes++;
    else if (severity == LEVEL_SKIP)
        report->skipped++;
    else
        report->fatal++;
    level_problem *problem = next_problem(report);
    if (!problem)
        return;
    problem->severity = severity;
    problem->object = object;
    problem->text[0] = 0;
    int used = 0;
    if (object != 0)
        used = snprintf(problem->text, sizeof problem->text, "object %u: ", object);
    else if (where)
        used = snprintf(problem->text, sizeof problem->text, "%.80s: ", where);
    vsnprintf(problem->text + used, sizeof problem->text - (size_t)used, format, arguments);
}

void level_problem_add(level_report *report, level_severity severity, uint32_t object,
                       const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    add(report, severity, object, NULL, format, arguments);
    va_end(arguments);
}

void level_complain(const level_values *v, level_severity severity, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    add(v->report, severity, v->object, v->where, format, arguments);
    va_end(arguments);
}
