/* skyline.c: see skyline.h. Doolittle's LU factorisation within the profile; each inner loop is a
 * dot product of two rows. */
#include "sim/skyline.h"

#include <stdlib.h>
#include <string.h>

bool skyline_init(skyline *a, int stride) {
    size_t places = (size_t)stride * (size_t)stride + 1;
    *a = (skyline){
        .lower = malloc(places * sizeof(double)),
        .upper = malloc(places * sizeof(double)),
        .first = malloc(((size_t)stride + 1) * sizeof(int)),
        .stride = stride,
    };
    if (a->lower && a->upper && a->first)
        return true;
    skyline_free(a);
    return false;
}

void skyline_free(skyline *a) {
    free(a->lower);
    free(a->upper);
    free(a->first);
    *a = (skyline){0};
}

static double *row_of(double *rows, const skyline *a, int row) {
    return rows + (size_t)row * (size_t)a->stride;
}

void skyline_clear(skyline *a) {
    for (int i = 0; i < a->size; i++) {
        size_t bytes = (size_t)(i + 1 - a->first[i]) * sizeof(double);
        memset(row_of(a->lower, a, i) + a->first[i], 0, bytes);
        memset(row_of(a->upper, a, i) + a->first[i], 0, bytes);
    }
}

void skyline_add(skyline *a, int row, int column, double value) {
    if (column < row)
        row_of(a->lower, a, row)[column] += value;
    else
        row_of(a->upper, a, column)[row] += value;
}

static double dot(const double *x, const double *y, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; i++)
        sum += x[i] * y[i];
    return sum;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

bool skyline_factor(skyline *a) {
    for (int i = 0; i < a->size; i++) {
        double *l = row_of(a->lower, a, i), *u = row_of(a->upper, a, i);
        for (int j = a->first[i]; j < i; j++) {
            const double *lj = row_of(a->lower, a, j), *uj = row_of(a->upper, a, j);
            int from = larger(a->first[i], a->first[j]);
            u[j] -= dot(lj, u, from, j);
            l[j] = (l[j] - dot(l, uj, from, j)) / uj[j];
        }
        u[i] -= dot(l, u, a->first[i], i);
        if (!(u[i] > 0))
            return false;
    }
    return true;
}

void skyline_solve(const skyline *a, double *x) {
    for (int i = 0; i < a->size; i++)
        x[i] -= dot(row_of(a->lower, a, i), x, a->first[i], i);
    for (int i = a->size - 1; i >= 0; i--) {
        const double *u = row_of(a->upper, a, i);
        x[i] /= u[i];
        for (int j = a->first[i]; j < i; j++)
            x[j] -= u[j] * x[i];
    }
}
