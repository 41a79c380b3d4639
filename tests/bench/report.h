/* report.h: results as a table for people and as JSON for programs. */
#ifndef THUD_BENCH_REPORT_H
#define THUD_BENCH_REPORT_H

#include "json.h"
#include "race.h"

#include <stdio.h>

void report_table_head(FILE *out);
/* One line for every engine that the first is compared with. */
void report_table_row(FILE *out, const race_result *result);
void report_table_foot(FILE *out, int repetitions);

/* An object for one scene, with an array of its engines. */
void report_json(json *out, const race_result *result);

#endif
