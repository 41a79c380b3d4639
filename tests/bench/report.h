/* report.h: prints results of races as a table, and writes them as JSON. */
#ifndef THUD_BENCH_REPORT_H
#define THUD_BENCH_REPORT_H

#include "json.h"
#include "race.h"

#include <stdio.h>

void report_table_head(FILE *out);
/* A line for each engine that the first is compared with. */
void report_table_row(FILE *out, const race_result *result);
void report_table_foot(FILE *out, int repetitions);

/* Writes an object for the scene, with an array of its engines. */
void report_json(json *out, const race_result *result);

#endif
