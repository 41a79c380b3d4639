/* report.h: results as a table for people and as JSON for programs. */
#ifndef THUD_BENCH_REPORT_H
#define THUD_BENCH_REPORT_H

#include "race.h"

#include <stdio.h>

void report_table_head(FILE *out);
/* One line for every engine that the first is compared with. */
void report_table_row(FILE *out, const race_result *result);
void report_table_foot(FILE *out, int repetitions);

/* An array with one object per scene and engine; false when writing fails. */
bool report_json(FILE *out, const race_result *results, int count);

#endif
