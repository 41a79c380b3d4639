/* skyline.h: LU factors of a square matrix that is zero left of each row's, and above each
 * column's, first place. Without pivoting: contact matrices are positive definite, or nearly. */
#ifndef THUD_ORACLE_SKYLINE_H
#define THUD_ORACLE_SKYLINE_H

#include <stdbool.h>
#include <stddef.h>

/* Row i of `lower` holds a[i][j], row i of `upper` a[j][i], for first[i] <= j <= i: so both are
 * read along their rows. */
typedef struct skyline {
    double *lower, *upper; /* size * stride each; the diagonal is in `upper` once factored */
    int *first;            /* of each row and column */
    int size, stride;
} skyline;

bool skyline_init(skyline *a, int stride); /* false without memory */
void skyline_free(skyline *a);

/* Zeros, with `first` as set by the caller. */
void skyline_clear(skyline *a);

/* a[row][column] += value; column must not lie outside of the profile. */
void skyline_add(skyline *a, int row, int column, double value);

/* False if a pivot is not positive: the matrix is no contact matrix, or singular. */
bool skyline_factor(skyline *a);

/* Solves in place with the factors. */
void skyline_solve(const skyline *a, double *x);

#endif
