/* sparse.c: see sparse.h. */
#include "islands/sparse.h"

#include <string.h>

static int *ints(const td_array *array) {
    return array->data;
}

/* Of the present system. */
static int *places(const td_sparse *s) {
    return ints(&s->place) + s->now.place;
}

static int *nodes(const td_sparse *s) {
    return ints(&s->node) + s->now.place;
}

static int *columns(const td_sparse *s) {
    return ints(&s->column) + s->now.place;
}

static int *rows(const td_sparse *s) {
    return ints(&s->row) + s->now.row;
}

static uint64_t *ties_of(const td_sparse *s, int node) {
    return (uint64_t *)s->ties.data + (size_t)node * (size_t)s->words;
}

/* Room from the start for what is usual. */
static bool roomy(td_memory *memory, td_array *array, int count) {
    return td_array_reserve(memory, array, td_max_int(count, 128));
}

void td_sparse_init(td_sparse *s) {
    td_array *const lists[] = {&s->degree, &s->next, &s->prev, &s->head, &s->place, &s->node,
                               &s->column, &s->row,  &s->map,  &s->walk, &s->chain};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        lists[i]->stride = (int)sizeof(int);
    }
    s->ties.stride = (int)sizeof(uint64_t);
    s->diagonal.stride = s->entry.stride = (int)sizeof(td_block3);
}

void td_sparse_free(td_memory *memory, td_sparse *s) {
    td_array *const arrays[] = {&s->ties,  &s->degree, &s->next,   &s->prev, &s->head,
                                &s->place, &s->node,   &s->column, &s->row,  &s->diagonal,
                                &s->entry, &s->map,    &s->walk,   &s->chain};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        td_array_free(memory, arrays[i]);
    }
}

/* A column more than nodes in each system, which has a node at least. */
bool td_sparse_reserve(td_memory *memory, td_sparse *s, int nodes) {
    return roomy(memory, &s->place, 2 * nodes) && roomy(memory, &s->node, 2 * nodes) &&
           roomy(memory, &s->column, 2 * nodes);
}

void td_sparse_forget(td_sparse *s) {
    s->now = (td_system){0};
    s->row.count = 0;
}

bool td_sparse_begin(td_memory *memory, td_sparse *s, int size) {
    td_array *const lists[] = {&s->degree, &s->next, &s->prev,  &s->head,
                               &s->map,    &s->walk, &s->chain, &s->diagonal};
    int place = s->now.size ? s->now.place + s->now.size + 1 : 0;
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        if (!roomy(memory, lists[i], size + 1)) {
            return false;
        }
    }
    assert(place + size < s->column.capacity);
    s->now = (td_system){.size = size, .place = place, .row = s->row.count};
    s->words = (size + 63) / 64;
    if (!roomy(memory, &s->ties, size * s->words)) {
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

static void list(td_sparse *s, int node) {
    int degree = ints(&s->degree)[node], first = ints(&s->head)[degree];
    ints(&s->next)[node] = first;
    ints(&s->prev)[node] = TD_NONE;
    if (first != TD_NONE) {
        ints(&s->prev)[first] = node;
    }
    ints(&s->head)[degree] = node;
}

static void unlist(td_sparse *s, int node) {
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

/* Appends the node's neighbours to the rows of its column; they become each other's. */
static bool eliminate(td_memory *memory, td_sparse *s, int node) {
    int first = s->row.count, degree = ints(&s->degree)[node];
    if (!roomy(memory, &s->row, first + degree)) {
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
        unlist(s, other);
        count_degree(s, other);
        list(s, other);
    }
    return true;
}

/* The rows of a column are nodes yet: they become places, rising. */
static void settle_column(td_sparse *s, int first, int end) {
    int *row = rows(s);
    for (int i = first; i < end; i++) {
        int place = places(s)[row[i]], k = i;
        for (; k > first && row[k - 1] > place; k--) {
            row[k] = row[k - 1];
        }
        row[k] = place;
    }
}

bool td_sparse_order(td_memory *memory, td_sparse *s) {
    int size = s->now.size;
    for (int degree = 0; degree <= size; degree++) {
        ints(&s->head)[degree] = TD_NONE;
    }
    for (int node = size - 1; node >= 0; node--) {
        count_degree(s, node);
        list(s, node);
    }
    int least = 0;
    for (int place = 0; place < size; place++) {
        while (ints(&s->head)[least] == TD_NONE) {
            least++;
        }
        int node = ints(&s->head)[least];
        unlist(s, node);
        columns(s)[place] = s->row.count - s->now.row;
        nodes(s)[place] = node;
        places(s)[node] = place;
        if (!eliminate(memory, s, node)) {
            return false;
        }
        least = td_max_int(least - 1, 0); /* a neighbour has lost one at most */
    }
    columns(s)[size] = s->row.count - s->now.row;
    for (int place = 0; place < size; place++) {
        int64_t entries = columns(s)[place + 1] - columns(s)[place];
        s->now.work += 1 + entries + entries * (entries + 1) / 2;
        settle_column(s, columns(s)[place], columns(s)[place + 1]);
    }
    return roomy(memory, &s->entry, columns(s)[size]);
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

/* ---- numbers ---- */

void td_sparse_clear(td_sparse *s) {
    size_t entries = (size_t)columns(s)[s->now.size];
    memset(s->diagonal.data, 0, (size_t)s->now.size * sizeof(td_block3));
    if (entries) {
        memset(s->entry.data, 0, entries * sizeof(td_block3));
    }
}

/* c -= a b' */
static void subtract_product(double *c, const double *a, const double *b) {
    for (int i = 0; i < 9; i += 3) {
        for (int k = 0; k < 3; k++) {
            c[i + k] -= a[i] * b[3 * k] + a[i + 1] * b[3 * k + 1] + a[i + 2] * b[3 * k + 2];
        }
    }
}

/* Cholesky's of a single block; the upper half is left alone. A pivot that cancellation has used
 * up, down to rounding, is none. */
static bool factor_block(double *a) {
    double p0 = a[0];
    if (!(p0 > 0.0)) {
        return false;
    }
    a[0] = __builtin_sqrt(p0);
    a[3] /= a[0];
    a[6] /= a[0];
    double p1 = a[4] - a[3] * a[3];
    if (!(p1 > 0.0)) {
        return false;
    }
    a[4] = __builtin_sqrt(p1);
    a[7] = (a[7] - a[6] * a[3]) / a[4];
    double p2 = a[8] - a[6] * a[6] - a[7] * a[7];
    if (!(p2 > 0.0)) {
        return false;
    }
    a[8] = __builtin_sqrt(p2);
    return td_finite(a[0] + a[4] + a[8]);
}

/* a becomes a l'^-1, for the factor of a diagonal block. */
static void divide_by_factor(double *a, const double *l) {
    double i0 = 1.0 / l[0], i4 = 1.0 / l[4], i8 = 1.0 / l[8];
    for (int i = 0; i < 9; i += 3) {
        a[i] *= i0;
        a[i + 1] = (a[i + 1] - a[i] * l[3]) * i4;
        a[i + 2] = (a[i + 2] - a[i] * l[6] - a[i + 1] * l[7]) * i8;
    }
}

/* The columns that reach a row are chained: chain[row] is the first, next[column] the one after it;
 * walk[column] is the entry that it has in that row. */
static void chain_up(td_sparse *s, int column) {
    if (ints(&s->walk)[column] < columns(s)[column + 1]) {
        int row = rows(s)[ints(&s->walk)[column]];
        ints(&s->next)[column] = ints(&s->chain)[row];
        ints(&s->chain)[row] = column;
    }
}

bool td_sparse_factor(td_sparse *s) {
    const int *row = rows(s);
    td_block3 *diagonal = s->diagonal.data, *entry = s->entry.data;
    for (int place = 0; place < s->now.size; place++) {
        ints(&s->chain)[place] = TD_NONE;
    }
    for (int place = 0; place < s->now.size; place++) {
        int first = columns(s)[place], end = columns(s)[place + 1];
        for (int i = first; i < end; i++) {
            ints(&s->map)[row[i]] = i;
        }
        for (int c = ints(&s->chain)[place], after; c != TD_NONE; c = after) {
            after = ints(&s->next)[c];
            int i = ints(&s->walk)[c]++, column_end = columns(s)[c + 1];
            const double *mine = entry[i].at;
            subtract_product(diagonal[place].at, mine, mine);
            for (i++; i < column_end; i++) {
                subtract_product(entry[ints(&s->map)[row[i]]].at, entry[i].at, mine);
            }
            chain_up(s, c);
        }
        if (!factor_block(diagonal[place].at)) {
            return false;
        }
        for (int i = first; i < end; i++) {
            divide_by_factor(entry[i].at, diagonal[place].at);
        }
        ints(&s->walk)[place] = first;
        chain_up(s, place);
    }
    return true;
}

void td_sparse_solve(const td_sparse *s, double (*x)[3], double (*y)[3]) {
    const int *row = rows(s), *column = columns(s), *node = nodes(s);
    const td_block3 *diagonal = s->diagonal.data, *entry = s->entry.data;
    for (int p = 0; p < s->now.size; p++) {
        memcpy(y[p], x[node[p]], sizeof *y);
    }
    for (int p = 0; p < s->now.size; p++) {
        const double *l = diagonal[p].at;
        y[p][0] /= l[0];
        y[p][1] = (y[p][1] - l[3] * y[p][0]) / l[4];
        y[p][2] = (y[p][2] - l[6] * y[p][0] - l[7] * y[p][1]) / l[8];
        for (int i = column[p]; i < column[p + 1]; i++) {
            const double *e = entry[i].at;
            for (int k = 0; k < 3; k++) {
                y[row[i]][k] -=
                    e[3 * k] * y[p][0] + e[3 * k + 1] * y[p][1] + e[3 * k + 2] * y[p][2];
            }
        }
    }
    for (int p = s->now.size - 1; p >= 0; p--) {
        const double *l = diagonal[p].at;
        for (int i = column[p]; i < column[p + 1]; i++) {
            const double *e = entry[i].at, *z = y[row[i]];
            for (int k = 0; k < 3; k++) {
                y[p][k] -= e[k] * z[0] + e[3 + k] * z[1] + e[6 + k] * z[2];
            }
        }
        y[p][2] /= l[8];
        y[p][1] = (y[p][1] - l[7] * y[p][2]) / l[4];
        y[p][0] = (y[p][0] - l[3] * y[p][1] - l[6] * y[p][2]) / l[0];
    }
    for (int p = 0; p < s->now.size; p++) {
        memcpy(x[node[p]], y[p], sizeof *x);
    }
}
