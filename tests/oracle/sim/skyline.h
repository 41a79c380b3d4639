/* skyline.h: LU factorisation of a square matrix in skyline (profile) storage, without pivoting:
 * contact matrices are positive definite, or nearly. */
#ifndef THUD_ORACLE_SKYLINE_H
#define THUD_ORACLE_SKYLINE_H

#include <stdbool.h>
#include <stddef.h>

/* Row i of `lower` stores a[i][j], and row i of `upper` a[j][i], for first[i] <= j <= i, so that
 * both are read along rows. */
typedef struct skyline {
    double *lower, *upper; /* size * stride each; the diagonal is in `upper` once factored */
    int *first;            /* first column of each row, and first row of each column */
    int size, stride;
} skyline;

bool skyline_init(skyline *a, int stride); /* false if memory runs out */
void skyline_free(skyline *a);

/* Sets the matrix to zero; the caller has set `size` and `first`. */
void skyline_clear(skyline *a);

/* Adds `value` to a[row][column], which must be within the profile. */
void skyline_add(skyline *a, int row, int column, double value);

/* Factorises in place. False if a pivot is not positive: the matrix is singular, or not a contact
 * matrix. */
bool skyline_factor(skyline *a);

/* Solves for x in place, with the factors. */
void skyline_solve(const skyline *a, double *x);

#endif
