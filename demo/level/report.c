/* report.c: collects what is amiss with a level. */
#include "reader.h"

#include <stdarg.h>
#include <stdio.h>

void level_problem_add(level_report *report, level_severity severity, uint32_t object,
                       const char *format, ...) {
    if (severity == LEVEL_NOTE)
        report->notes++;
    else if (severity == LEVEL_SKIP)
        report->skipped++;
    else
        report->fatal++;
    if (report->count == LEVEL_PROBLEMS)
        return;
    level_problem *problem = &report->problems[report->count++];
    problem->severity = severity;
    problem->object = object;
    int used = 0;
    if (object != 0)
        used = snprintf(problem->text, sizeof problem->text, "object %u: ", object);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text + used, sizeof problem->text - (size_t)used, format, arguments);
    va_end(arguments);
}
