/* wide_sparse.c: L L' of the blocks of sparse.h, and solving by it. A block's columns are taken
 * whole, each element by the operations of plain code, in its order. */
#include "islands/sparse.h"

#include "base/simd.h"

TD_INLINE d4 load(const double *from) {
    d4 to;
    __builtin_memcpy(&to, from, sizeof to);
    return to;
}

TD_INLINE void store(double *to, d4 from) {
    __builtin_memcpy(to, &from, sizeof from);
}

/* One block of a product, spread out to be taken many times: of b, column and row. */
typedef struct factor3 {
    d4 at[3][3];
} factor3;

TD_INLINE factor3 spread_out(const td_block3 *b) {
    factor3 f;
    for (int column = 0; column < 3; column++) {
        for (int row = 0; row < 3; row++) {
            double x = b->at[column][row];
            f.at[column][row] = (d4){x, x, x, x};
        }
    }
    return f;
}

/* c -= a b' */
TD_INLINE void subtract_product(td_block3 *c, const td_block3 *a, const factor3 *b) {
    d4 a0 = load(a->at[0]), a1 = load(a->at[1]), a2 = load(a->at[2]);
    for (int k = 0; k < 3; k++) {
        store(c->at[k], load(c->at[k]) - (a0 * b->at[0][k] + a1 * b->at[1][k] + a2 * b->at[2][k]));
    }
}

/* Cholesky's of a single block; the upper half is left alone. A pivot that cancellation has used
 * up, down to rounding, is none. */
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

/* a becomes a l'^-1, for the factor of a diagonal block. */
TD_INLINE void divide_by_factor(td_block3 *a, const td_block3 *l) {
    double i0 = 1.0 / l->at[0][0], i1 = 1.0 / l->at[1][1], i2 = 1.0 / l->at[2][2];
    d4 a0 = load(a->at[0]) * i0;
    d4 a1 = (load(a->at[1]) - a0 * l->at[0][1]) * i1;
    d4 a2 = (load(a->at[2]) - a0 * l->at[0][2] - a1 * l->at[1][2]) * i2;
    store(a->at[0], a0);
    store(a->at[1], a1);
    store(a->at[2], a2);
}

/* The columns that reach a row are chained: chain[row] is the first, next[column] the one after it;
 * walk[column] is the entry that it has in that row. */
TD_INLINE void chain_up(const td_sparse_view *s, int column) {
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
            factor3 mine = spread_out(&entry[i]);
            subtract_product(&diagonal[place], &entry[i], &mine);
            for (i++; i < column_end; i++) {
                subtract_product(&entry[map[row[i]]], &entry[i], &mine);
            }
            chain_up(s, c);
        }
        if (!factor_block(&diagonal[place])) {
            return false;
        }
        for (int i = first; i < end; i++) {
            divide_by_factor(&entry[i], &diagonal[place]);
        }
        walk[place] = first;
        chain_up(s, place);
    }
    return true;
}

/* L y = y, place by place. */
static void solve_down(const td_sparse_view *s, double (*y)[4]) {
    for (int p = 0; p < s->size; p++) {
        const td_block3 *l = &s->diagonal[p];
        y[p][0] /= l->at[0][0];
        y[p][1] = (y[p][1] - l->at[0][1] * y[p][0]) / l->at[1][1];
        y[p][2] = (y[p][2] - l->at[0][2] * y[p][0] - l->at[1][2] * y[p][1]) / l->at[2][2];
        for (int i = s->column[p]; i < s->column[p + 1]; i++) {
            const td_block3 *e = &s->entry[i];
            double *z = y[s->row[i]];
            store(z, load(z) - (load(e->at[0]) * y[p][0] + load(e->at[1]) * y[p][1] +
                                load(e->at[2]) * y[p][2]));
        }
    }
}

/* L' y = y */
static void solve_up(const td_sparse_view *s, double (*y)[4]) {
    for (int p = s->size - 1; p >= 0; p--) {
        const td_block3 *l = &s->diagonal[p];
        d4 sum = load(y[p]);
        for (int i = s->column[p]; i < s->column[p + 1]; i++) {
            const td_block3 *e = &s->entry[i];
            d4 z = load(y[s->row[i]]);
            d4 a = load(e->at[0]) * z, b = load(e->at[1]) * z, c = load(e->at[2]) * z;
            d4 ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
            d4 first = __builtin_shufflevector(ab_low, c, 0, 1, 4, 4);
            d4 second = __builtin_shufflevector(ab_low, c, 2, 3, 5, 5);
            d4 third =
                __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 2, 6), c, 0, 1, 6, 6);
            sum -= first + second + third;
        }
        store(y[p], sum);
        y[p][2] /= l->at[2][2];
        y[p][1] = (y[p][1] - l->at[1][2] * y[p][2]) / l->at[1][1];
        y[p][0] = (y[p][0] - l->at[0][1] * y[p][1] - l->at[0][2] * y[p][2]) / l->at[0][0];
    }
}

void TD_WIDE(td_sparse_solve)(const td_sparse_view *s, double (*y)[4]) {
    solve_down(s, y);
    solve_up(s, y);
}
