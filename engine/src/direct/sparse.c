/* sparse.c: the symbolic part of sparse.h: minimum-degree ordering and the structure of L, for A =
 * L L'.
 *
 * Ordering simulates the elimination on the graph of the nodes, which are block rows of A: bodies,
 * joined where a constraint acts between them (Tinney and Walker, "Direct solutions of sparse
 * network equations by optimally ordered triangular factorization", 1967). The node of minimum
 * degree is eliminated next, and its neighbours become neighbours of each other: these new edges
 * are the fill-in. The graph is a matrix of bits, so that an elimination is an OR of rows; of nodes
 * of equal degree, the one that reached it last is taken first, so that the order is the same on
 * every platform. */
#include "direct/sparse.h"

#include <string.h>

static int *ints(const td_array *array) {
    return array->data;
}

/* The arrays of the present system. */
static int *places(const td_sparse *s) {
    return ints(&s->place) + s->current.place;
}

static int *nodes(const td_sparse *s) {
    return ints(&s->node) + s->current.place;
}

static int *columns(const td_sparse *s) {
    return ints(&s->column) + s->current.place;
}

static int *rows(const td_sparse *s) {
    return ints(&s->row) + s->current.row;
}

static uint64_t *ties_of(const td_sparse *s, int node) {
    return (uint64_t *)s->ties.data + (size_t)node * (size_t)s->words;
}

/* Reserves at least 128 elements, so that arrays of small systems do not grow step by step. */
static bool reserve(td_memory *memory, td_array *array, int count) {
    return td_array_reserve(memory, array, td_max_int(count, 128));
}

#define ARRAY(name, element) TD_ARRAY_PLACE(td_sparse, name, element)

static const td_array_place ARRAYS[] = {
    ARRAY(ties, uint64_t), ARRAY(degree, int),         ARRAY(next, int),        ARRAY(prev, int),
    ARRAY(head, int),      ARRAY(place, int),          ARRAY(node, int),        ARRAY(column, int),
    ARRAY(row, int),       ARRAY(diagonal, td_block3), ARRAY(entry, td_block3), ARRAY(map, int),
    ARRAY(walk, int),      ARRAY(chain, int),
};
enum { ARRAY_COUNT = sizeof ARRAYS / sizeof *ARRAYS };

void td_sparse_init(td_sparse *s, bool wide) {
    s->wide = wide;
    td_arrays_init(s, ARRAYS, ARRAY_COUNT);
}

void td_sparse_free(td_memory *memory, td_sparse *s) {
    td_arrays_free(memory, s, ARRAYS, ARRAY_COUNT);
}

/* `column` has one more element than nodes in each system, and a system has at least one node:
 * twice the number of nodes is enough. */
bool td_sparse_reserve(td_memory *memory, td_sparse *s, int nodes) {
    return reserve(memory, &s->place, 2 * nodes) && reserve(memory, &s->node, 2 * nodes) &&
           reserve(memory, &s->column, 2 * nodes);
}

void td_sparse_forget(td_sparse *s) {
    s->current = (td_system){0};
    s->row.count = 0;
}

bool td_sparse_begin(td_memory *memory, td_sparse *s, int size) {
    td_array *const lists[] = {&s->degree, &s->next, &s->prev,  &s->head,
                               &s->map,    &s->walk, &s->chain, &s->diagonal};
    int place = s->current.size ? s->current.place + s->current.size + 1 : 0;
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        if (!reserve(memory, lists[i], size + 1)) {
            return false;
        }
    }
    assert(place + size < s->column.capacity);
    s->current = (td_system){.size = size, .place = place, .row = s->row.count};
    s->words = (size + 63) / 64;
    if (!reserve(memory, &s->ties, size * s->words)) {
        return false;
    }
    memset(s->ties.data, 0, (size_t)(size * s->words) * sizeof(uint64_t));
    return true;
}

void td_sparse_tie(td_sparse *s, int a, int b) {
    assert(a != b);
    ties_of(s, a)[b / 64] |= 1ull << (b % 64);
    ties_of(s, b)[a / 64] |= 1ull << (a % 64);
}

/* ---- order ---- */

/* Puts a node at the front of the list of its degree. */
static void link_by_degree(td_sparse *s, int node) {
    int degree = ints(&s->degree)[node], first = ints(&s->head)[degree];
    ints(&s->next)[node] = first;
    ints(&s->prev)[node] = TD_NONE;
    if (first != TD_NONE) {
        ints(&s->prev)[first] = node;
    }
    ints(&s->head)[degree] = node;
}

/* Takes a node out of the list of its degree. */
static void unlink_by_degree(td_sparse *s, int node) {
    int next = ints(&s->next)[node], prev = ints(&s->prev)[node];
    if (next != TD_NONE) {
        ints(&s->prev)[next] = prev;
    }
    if (prev != TD_NONE) {
        ints(&s->next)[prev] = next;
    } else {
        ints(&s->head)[ints(&s->degree)[node]] = next;
    }
}

static void count_degree(td_sparse *s, int node) {
    int degree = 0;
    for (int i = 0; i < s->words; i++) {
        degree += __builtin_popcountll(ties_of(s, node)[i]);
    }
    ints(&s->degree)[node] = degree;
}

/* Eliminates a node: appends its neighbours to the rows of its column, and makes them neighbours of
 * each other. False when memory is short. */
static bool eliminate(td_memory *memory, td_sparse *s, int node) {
    int first = s->row.count, degree = ints(&s->degree)[node];
    if (!reserve(memory, &s->row, first + degree)) {
        return false;
    }
    const uint64_t *own = ties_of(s, node);
    for (int i = 0; i < s->words; i++) {
        for (uint64_t bits = own[i]; bits; bits &= bits - 1) {
            td_push_int(&s->row, i * 64 + __builtin_ctzll(bits));
        }
    }
    for (int i = first; i < s->row.count; i++) {
        int other = ints(&s->row)[i];
        uint64_t *ties = ties_of(s, other);
        for (int k = 0; k < s->words; k++) {
            ties[k] |= own[k];
        }
        ties[node / 64] &= ~(1ull << (node % 64));
        ties[other / 64] &= ~(1ull << (other % 64));
        unlink_by_degree(s, other);
        count_degree(s, other);
        link_by_degree(s, other);
    }
    return true;
}

/* Turns the rows of a column from nodes into places, sorted by insertion. */
static void sort_column(td_sparse *s, int first, int end) {
    int *row = rows(s);
    for (int i = first; i < end; i++) {
        int place = places(s)[row[i]], k = i;
        for (; k > first && row[k - 1] > place; k--) {
            row[k] = row[k - 1];
        }
        row[k] = place;
    }
}

bool td_sparse_order(td_memory *memory, td_sparse *s, int entries_max) {
    int size = s->current.size;
    for (int degree = 0; degree <= size; degree++) {
        ints(&s->head)[degree] = TD_NONE;
    }
    for (int node = size - 1; node >= 0; node--) {
        count_degree(s, node);
        link_by_degree(s, node);
    }
    int degree_min = 0;
    for (int place = 0; place < size; place++) {
        while (ints(&s->head)[degree_min] == TD_NONE) {
            degree_min++;
        }
        int node = ints(&s->head)[degree_min];
        unlink_by_degree(s, node);
        columns(s)[place] = s->row.count - s->current.row;
        nodes(s)[place] = node;
        places(s)[node] = place;
        int entries = columns(s)[place] + ints(&s->degree)[node];
        if (entries > entries_max || !eliminate(memory, s, node)) {
            return false;
        }
        degree_min = td_max_int(degree_min - 1, 0); /* neighbours lose at most one neighbour */
    }
    columns(s)[size] = s->row.count - s->current.row;
    for (int place = 0; place < size; place++) {
        int64_t entries = columns(s)[place + 1] - columns(s)[place];
        s->current.work += 1 + entries + entries * (entries + 1) / 2;
        sort_column(s, columns(s)[place], columns(s)[place + 1]);
    }
    return reserve(memory, &s->entry, columns(s)[size]);
}

int td_sparse_find(const td_sparse *s, int a, int b) {
    int pa = places(s)[a], pb = places(s)[b];
    int low = columns(s)[td_min_int(pa, pb)], row = td_max_int(pa, pb);
    int high = columns(s)[td_min_int(pa, pb) + 1] - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (rows(s)[middle] < row) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    assert(rows(s)[low] == row);
    return low;
}
