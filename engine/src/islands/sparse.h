/* sparse.h: symmetric positive definite systems of 3 x 3 blocks, one block row a node, solved
 * directly.
 *
 * Holds the order of any number of systems, and the numbers of one at a time.
 * Nodes are put in an order in which eliminating them fills in little (minimum degree), and A = L
 * L' is worked out on the blocks that are not zero. In double, one operation after the other: the
 * same bits everywhere. */
#ifndef TD_SPARSE_H
#define TD_SPARSE_H

#include "base/memory.h"

typedef struct td_block3 {
    double at[3][4]; /* column by column; the fourth row is nothing, and makes a column a vector */
} td_block3;

/* Where the order of one system lies. */
typedef struct td_system {
    int size;     /* nodes */
    int place;    /* the first of its places, and of its columns */
    int row;      /* the first of its entries' rows */
    int64_t work; /* operations on blocks that factoring takes */
} td_system;

/* The present system, as its kernels are given it. */
typedef struct td_sparse_view {
    int size;
    const int *column, *row;
    td_block3 *diagonal, *entry;
    int *map, *walk, *chain, *next; /* room, while factoring */
} td_sparse_view;

typedef struct td_sparse {
    bool wide;     /* AVX2 kernels may run */
    td_system now; /* the system that all calls are about */
    int words;     /* of 64 bits each, in a row of `ties` */
    td_array ties; /* uint64_t: a bit for each pair of nodes; used up by ordering */
    td_array degree, next, prev, head; /* int: nodes by their degree, in lists */
    td_array place, node;              /* int: when a node is eliminated, and which one is then */
    td_array column;           /* int: where the entries of each place's column begin; one more */
    td_array row;              /* int: their places, rising within a column */
    td_array diagonal;         /* td_block3, by place */
    td_array entry;            /* td_block3, below the diagonal, as `row` */
    td_array map, walk, chain; /* int: while factoring */
} td_sparse;

void td_sparse_init(td_sparse *s, bool wide);
void td_sparse_free(td_memory *memory, td_sparse *s);

/* Room for the order of systems that have so many nodes together. */
bool td_sparse_reserve(td_memory *memory, td_sparse *s, int nodes);
void td_sparse_forget(td_sparse *s); /* all systems */
/* A further system, of so many nodes, which nothing ties together yet; false when memory is short.
 */
bool td_sparse_begin(td_memory *memory, td_sparse *s, int size);
/* There will be a block between the two nodes. */
void td_sparse_tie(td_sparse *s, int a, int b);
/* Order, and room for all blocks of L; false when memory is short, or when there would be more than
 * `most` of them below the diagonal. */
bool td_sparse_order(td_memory *memory, td_sparse *s, int most);

/* The block between two tied nodes: its index; its rows belong to the one that is eliminated later.
 */
int td_sparse_find(const td_sparse *s, int a, int b);

static inline int td_sparse_place(const td_sparse *s, int node) {
    return ((const int *)s->place.data)[s->now.place + node];
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

/* Blocks of L below its diagonal. */
static inline int td_sparse_entries(const td_sparse *s) {
    return ((const int *)s->column.data)[s->now.place + s->now.size];
}

void td_sparse_clear(td_sparse *s); /* all blocks are zero */
/* In place; of a diagonal block only the lower half is read. False, and the blocks mean nothing,
 * when the matrix is not positive definite, as far as its numbers can tell. */
bool td_sparse_factor(td_sparse *s);
/* Turns the right side into the solution: three numbers a node, and a fourth that is nothing.
 * `work` has room for as many. */
void td_sparse_solve(const td_sparse *s, double (*x)[4], double (*work)[4]);

#endif
