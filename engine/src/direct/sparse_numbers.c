/* sparse_numbers.c: the numeric part of sparse.h: passes the present system to the kernels of
 * wide_sparse.c, and permutes right-hand sides into the order of elimination and back. */
#include "direct/sparse.h"

#include "base/simd.h"

#include <string.h>

typedef bool factor_fn(const td_sparse_view *s);
typedef void solve_fn(const td_sparse_view *s, double (*y)[4]);
TD_DECLARE_WIDE(factor_fn, td_sparse_factor);
TD_DECLARE_WIDE(solve_fn, td_sparse_solve);

static td_sparse_view view_of(const td_sparse *s) {
    return (td_sparse_view){.size = s->current.size,
                            .column = (const int *)s->column.data + s->current.place,
                            .row = (const int *)s->row.data + s->current.row,
                            .diagonal = s->diagonal.data,
                            .entry = s->entry.data,
                            .map = s->map.data,
                            .walk = s->walk.data,
                            .chain = s->chain.data,
                            .next = s->next.data};
}

void td_sparse_clear(td_sparse *s) {
    td_sparse_view v = view_of(s);
    size_t entries = (size_t)v.column[v.size];
    memset(v.diagonal, 0, (size_t)v.size * sizeof *v.diagonal);
    if (entries) {
        memset(v.entry, 0, entries * sizeof *v.entry);
    }
}

bool td_sparse_factor(td_sparse *s) {
    td_sparse_view v = view_of(s);
    return TD_PICK_WIDE(s, td_sparse_factor)(&v);
}

void td_sparse_solve(const td_sparse *s, double (*x)[4], double (*work)[4]) {
    const int *node = (const int *)s->node.data + s->current.place;
    td_sparse_view v = view_of(s);
    for (int p = 0; p < s->current.size; p++) {
        memcpy(work[p], x[node[p]], sizeof *work);
    }
    TD_PICK_WIDE(s, td_sparse_solve)(&v, work);
    for (int p = 0; p < s->current.size; p++) {
        memcpy(x[node[p]], work[p], sizeof *x);
    }
}
