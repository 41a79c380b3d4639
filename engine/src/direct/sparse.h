/* sparse.h: direct solution of symmetric positive definite systems of 3 x 3 blocks, by sparse
 * Cholesky factorisation A = L L' (George and Liu, Computer Solution of Large Sparse Positive
 * Definite Systems, 1981).
 *
 * A node is a block row, here a body. The symbolic part orders the nodes by minimum degree, so that
 * elimination fills in few blocks, and lists the blocks of L that are not zero; it is kept for any
 * number of systems. The numeric part has the blocks of one system at a time. A *place* is the
 * position of a node in the order of elimination; a column of L is that of a place. All arithmetic
 * is in double precision in a fixed order, so that it gives the same bits on every platform. */
#ifndef TD_SPARSE_H
#define TD_SPARSE_H

#include "base/memory.h"

typedef struct td_block3 {
    double at[3][4]; /* column by column; the fourth row is padding, so that a column is a vector */
} td_block3;

/* Where the symbolic part of one system is in the arrays of td_sparse. */
typedef struct td_system {
    int size;     /* nodes */
    int place;    /* index of its first element in `place`, `node` and `column` */
    int row;      /* index of its first element in `row` */
    int64_t work; /* operations on 3 x 3 blocks that a factorisation takes */
} td_system;

/* The present system as the kernels of wide_sparse.c see it. */
typedef struct td_sparse_view {
    int size;
    const int *column, *row;
    td_block3 *diagonal, *entry;
    int *map, *walk, *chain, *next; /* scratch memory of a factorisation */
} td_sparse_view;

typedef struct td_sparse {
    bool wide;         /* AVX2 kernels may run */
    td_system current; /* the present system, on which all functions below work */
    int words;         /* words of 64 bits in a row of `ties` */
    td_array ties; /* uint64_t: adjacency matrix of the nodes, a bit a pair; ordering destroys it */
    td_array degree, next, prev, head; /* int: doubly linked lists of the nodes of each degree, for
                                          ordering; `next` is also scratch memory of a
                                          factorisation */
    td_array place, node;              /* int: the place of each node, and the node at each place */
    td_array column;   /* int: first entry of each place's column, and the end of the last column */
    td_array row;      /* int: place of each entry's block row, rising within a column */
    td_array diagonal; /* td_block3, by place */
    td_array entry;    /* td_block3 below the diagonal, parallel to `row` */
    td_array map, walk, chain; /* int: scratch memory of a factorisation */
} td_sparse;

void td_sparse_init(td_sparse *s, bool wide);
void td_sparse_free(td_memory *memory, td_sparse *s);

/* Reserves memory for systems with `nodes` nodes in total. False when memory is short. */
bool td_sparse_reserve(td_memory *memory, td_sparse *s, int nodes);
void td_sparse_forget(td_sparse *s); /* removes all systems */
/* Begins a further system of `size` nodes without blocks off the diagonal. False when memory is
 * short. */
bool td_sparse_begin(td_memory *memory, td_sparse *s, int size);
/* Declares that the block between the two nodes may be nonzero. */
void td_sparse_tie(td_sparse *s, int a, int b);
/* Orders the nodes and reserves memory for all blocks of L. False when memory is short, or when L
 * would have more than `entries_max` blocks below its diagonal. */
bool td_sparse_order(td_memory *memory, td_sparse *s, int entries_max);

/* Index of the block between two nodes (declared by td_sparse_tie); its rows belong to the node
 * that is eliminated later. */
int td_sparse_find(const td_sparse *s, int a, int b);

static inline int td_sparse_place(const td_sparse *s, int node) {
    return ((const int *)s->place.data)[s->current.place + node];
}

static inline bool td_sparse_is_later(const td_sparse *s, int a, int b) {
    return td_sparse_place(s, a) > td_sparse_place(s, b);
}

static inline td_block3 *td_sparse_diagonal(td_sparse *s, int node) {
    return (td_block3 *)s->diagonal.data + td_sparse_place(s, node);
}

static inline td_block3 *td_sparse_entry(td_sparse *s, int index) {
    return (td_block3 *)s->entry.data + index;
}

/* Number of blocks of L below its diagonal. */
static inline int td_sparse_entries(const td_sparse *s) {
    return ((const int *)s->column.data)[s->current.place + s->current.size];
}

void td_sparse_clear(td_sparse *s); /* sets all blocks to zero */
/* Factors the blocks in place; only the lower half of diagonal blocks is read. False when the
 * matrix is not positive definite to rounding; the blocks are then invalid. */
bool td_sparse_factor(td_sparse *s);
/* Solves L L' y = x in place of x: three numbers a node, and a fourth that is not used. `work` is
 * scratch memory of the same size. */
void td_sparse_solve(const td_sparse *s, double (*x)[4], double (*work)[4]);

#endif
