/* series.c: see series.h. */
#include "series.h"

#include <math.h>
#include <stdlib.h>

static int ascending(const void *left, const void *right) {
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

bool series_init(series *s, int steps, int repetitions) {
    /* One more row, as scratch space for sorting. */
    double *ms = calloc((size_t)steps * (size_t)(repetitions + 1), sizeof *ms);
    *s = (series){steps, repetitions, ms};
    return ms != NULL;
}

void series_free(series *s) {
    free(s->ms);
    *s = (series){0};
}

static double *scratch_row(const series *s) {
    return s->ms + (size_t)s->repetitions * (size_t)s->steps;
}

static double median_of_sorted(const double *sorted, int count) {
    return 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
}

double series_median(double *values, int count) {
    qsort(values, (size_t)count, sizeof *values, ascending);
    return median_of_sorted(values, count);
}

double series_quantile(const double *sorted, int count, double part) {
    int rank = (int)ceil(part * count);
    return sorted[rank < 1 ? 0 : rank - 1];
}

double series_span(const double *values, int count) {
    double least = values[0], most = values[0];
    for (int i = 1; i < count; i++) {
        least = fmin(least, values[i]);
        most = fmax(most, values[i]);
    }
    return most / least;
}

series_summary series_summarize(const series *s) {
    double *least = scratch_row(s);
    for (int step = 0; step < s->steps; step++) {
        least[step] = s->ms[step];
        for (int i = 1; i < s->repetitions; i++)
            least[step] = fmin(least[step], s->ms[i * s->steps + step]);
    }
    qsort(least, (size_t)s->steps, sizeof *least, ascending);
    return (series_summary){median_of_sorted(least, s->steps),
                            series_quantile(least, s->steps, 0.99), least[s->steps - 1]};
}

double series_median_of(const series *s, int repetition) {
    double *row = scratch_row(s);
    for (int step = 0; step < s->steps; step++)
        row[step] = s->ms[repetition * s->steps + step];
    return series_median(row, s->steps);
}
