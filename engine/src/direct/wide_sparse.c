/* wide_sparse.c: the numeric part of sparse.h: left-looking block Cholesky factorisation, and
 * forward and backward substitution. Loops run over all four numbers of a block's column, padding
 * included, so that compilers make vector instructions of them. */
#include "direct/sparse.h"

#include "base/simd.h"

enum { PADDED_ROWS = 4 }; /* rows of a block in memory, with the padding */

/* c -= a b' */
TD_INLINE void subtract_product(td_block3 *restrict c, const td_block3 *restrict a,
                                const td_block3 *b) {
    for (int k = 0; k < 3; k++) {
        double b0 = b->at[0][k], b1 = b->at[1][k], b2 = b->at[2][k];
        for (int i = 0; i < PADDED_ROWS; i++) {
            c->at[k][i] -= a->at[0][i] * b0 + a->at[1][i] * b1 + a->at[2][i] * b2;
        }
    }
}

/* Cholesky factor of a single block, in its lower half. False where a pivot is not positive, as
 * after cancellation down to rounding, or not finite. */
static bool factor_block(td_block3 *block) {
    double *c0 = block->at[0], *c1 = block->at[1], *c2 = block->at[2];
    if (!(c0[0] > 0.0)) {
        return false;
    }
    c0[0] = __builtin_sqrt(c0[0]);
    c0[1] /= c0[0];
    c0[2] /= c0[0];
    double p1 = c1[1] - c0[1] * c0[1];
    if (!(p1 > 0.0)) {
        return false;
    }
    c1[1] = __builtin_sqrt(p1);
    c1[2] = (c1[2] - c0[2] * c0[1]) / c1[1];
    double p2 = c2[2] - c0[2] * c0[2] - c1[2] * c1[2];
    if (!(p2 > 0.0)) {
        return false;
    }
    c2[2] = __builtin_sqrt(p2);
    return td_finite(c0[0] + c1[1] + c2[2]);
}

/* a = a (l')^-1, where l is the factor of a diagonal block. */
TD_INLINE void divide_by_factor(td_block3 *restrict a, const td_block3 *restrict l) {
    double i0 = 1.0 / l->at[0][0], i1 = 1.0 / l->at[1][1], i2 = 1.0 / l->at[2][2];
    for (int i = 0; i < PADDED_ROWS; i++) {
        a->at[0][i] *= i0;
        a->at[1][i] = (a->at[1][i] - a->at[0][i] * l->at[0][1]) * i1;
        a->at[2][i] = (a->at[2][i] - a->at[0][i] * l->at[0][2] - a->at[1][i] * l->at[1][2]) * i2;
    }
}

/* The left-looking update of a row needs the columns that have a block in it. They are in a linked
 * list: chain[row] is the first column, next[column] the column after it, and walk[column] the
 * column's entry in that row. This function moves a column to the list of its next row. map[row] is
 * the entry of the present column in that row. */
TD_INLINE void chain_next_row(const td_sparse_view *s, int column) {
    if (s->walk[column] < s->column[column + 1]) {
        int row = s->row[s->walk[column]];
        s->next[column] = s->chain[row];
        s->chain[row] = column;
    }
}

bool TD_WIDE(td_sparse_factor)(const td_sparse_view *s) {
    const int *row = s->row, *column = s->column;
    int *map = s->map, *walk = s->walk, *next = s->next;
    td_block3 *entry = s->entry, *diagonal = s->diagonal;
    for (int place = 0; place < s->size; place++) {
        s->chain[place] = TD_NONE;
    }
    for (int place = 0; place < s->size; place++) {
        int first = column[place], end = column[place + 1];
        for (int i = first; i < end; i++) {
            map[row[i]] = i;
        }
        for (int c = s->chain[place], after; c != TD_NONE; c = after) {
            after = next[c];
            int i = walk[c]++, column_end = column[c + 1];
            td_block3 mine = entry[i];
            subtract_product(&diagonal[place], &entry[i], &mine);
            for (i++; i < column_end; i++) {
                subtract_product(&entry[map[row[i]]], &entry[i], &mine);
            }
            chain_next_row(s, c);
        }
        if (!factor_block(&diagonal[place])) {
            return false;
        }
        for (int i = first; i < end; i++) {
            divide_by_factor(&entry[i], &diagonal[place]);
        }
        walk[place] = first;
        chain_next_row(s, place);
    }
    return true;
}

/* Solves L z = y in place of y. */
static void solve_down(const td_sparse_view *s, double (*y)[4]) {
    for (int p = 0; p < s->size; p++) {
        const td_block3 *l = &s->diagonal[p];
        y[p][0] /= l->at[0][0];
        y[p][1] = (y[p][1] - l->at[0][1] * y[p][0]) / l->at[1][1];
        y[p][2] = (y[p][2] - l->at[0][2] * y[p][0] - l->at[1][2] * y[p][1]) / l->at[2][2];
        for (int i = s->column[p]; i < s->column[p + 1]; i++) {
            const td_block3 *e = &s->entry[i];
            double *z = y[s->row[i]];
            double y0 = y[p][0], y1 = y[p][1], y2 = y[p][2];
            for (int k = 0; k < PADDED_ROWS; k++) {
                z[k] -= e->at[0][k] * y0 + e->at[1][k] * y1 + e->at[2][k] * y2;
            }
        }
    }
}

/* Solves L' z = y in place of y. */
static void solve_up(const td_sparse_view *s, double (*y)[4]) {
    for (int p = s->size - 1; p >= 0; p--) {
        const td_block3 *l = &s->diagonal[p];
        for (int i = s->column[p]; i < s->column[p + 1]; i++) {
            const td_block3 *e = &s->entry[i];
            const double *z = y[s->row[i]];
            for (int k = 0; k < 3; k++) {
                y[p][k] -= e->at[k][0] * z[0] + e->at[k][1] * z[1] + e->at[k][2] * z[2];
            }
        }
        y[p][2] /= l->at[2][2];
        y[p][1] = (y[p][1] - l->at[1][2] * y[p][2]) / l->at[1][1];
        y[p][0] = (y[p][0] - l->at[0][1] * y[p][1] - l->at[0][2] * y[p][2]) / l->at[0][0];
    }
}

void TD_WIDE(td_sparse_solve)(const td_sparse_view *s, double (*y)[4]) {
    solve_down(s, y);
    solve_up(s, y);
}
