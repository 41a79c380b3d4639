/* series.h: the times of a scene's steps over several repetitions, and their median, percentile and
 * maximum. */
#ifndef THUD_BENCH_SERIES_H
#define THUD_BENCH_SERIES_H

#include <stdbool.h>

typedef struct series {
    int steps, repetitions;
    double *ms; /* [repetition * steps + step] */
} series;

typedef struct series_summary {
    double median, p99, max;
} series_summary;

bool series_init(series *s, int steps, int repetitions); /* false if memory runs out */
void series_free(series *s);

/* Statistics of each step's minimum over the repetitions. Engines are deterministic, so that a step
 * is the same work in each repetition, and differences are load of other processes. */
series_summary series_summarize(const series *s);

/* The median of one repetition's times. */
double series_median_of(const series *s, int repetition);

/* The median (the mean of the two middle values of an even count). Sorts the values. */
double series_median(double *values, int count);

/* The smallest value such that at least the share `part` of the values are not above it. The values
 * must be sorted. */
double series_quantile(const double *sorted, int count, double part);

/* The largest of positive values over the smallest. */
double series_span(const double *values, int count);

#endif
