/* series.h: the times of one scene's steps over several repetitions, and what they amount to. */
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

bool series_init(series *s, int steps, int repetitions); /* false without memory */
void series_free(series *s);

/* Of the steps' least times over the repetitions. Engines are deterministic, so that a step is
 * the same work in every repetition; what differs is what else the machine did meanwhile. */
series_summary series_summarize(const series *s);

/* Median of one repetition's times as they were. */
double series_median_of(const series *s, int repetition);

/* The middle value, or the mean of the two in the middle. Sorts the values. */
double series_median(double *values, int count);

/* The smallest value that at least the given part of the values do not exceed. Of sorted values. */
double series_quantile(const double *sorted, int count, double part);

/* The largest over the smallest of positive values. */
double series_span(const double *values, int count);

#endif
