/* dense_support.h: symmetric positive definite matrices on graphs of any form, and a dense Cholesky
 * solver in long double, as the reference for the sparse factorisation. */
#ifndef DENSE_SUPPORT_H
#define DENSE_SUPPORT_H

#include "engine_support.h"

enum { NODES_MOST = 80, EDGES_MOST = NODES_MOST * NODES_MOST };

/* Edges: which nodes are coupled. */
typedef struct graph {
    int nodes, edges;
    int edge[EDGES_MOST][2];
} graph;

/* The same matrix as a dense one, and a right-hand side. */
typedef struct dense {
    int size; /* rows */
    long double at[3 * NODES_MOST][3 * NODES_MOST], right[3 * NODES_MOST];
} dense;

/* The current graph, and its dense matrix. */
static graph g;
static dense full;

static inline void tie(int a, int b) {
    g.edge[g.edges][0] = a;
    g.edge[g.edges++][1] = b;
}

/* ---- graphs ---- */

static inline void make_chain(int nodes) {
    g = (graph){.nodes = nodes};
    for (int i = 1; i < nodes; i++) {
        tie(i - 1, i);
    }
}

static inline void make_ring(int nodes) {
    make_chain(nodes);
    tie(nodes - 1, 0);
}

/* A star whose hub is node 0: eliminating nodes in the order of their numbers would fill in
 * everything. */
static inline void make_star(int nodes) {
    g = (graph){.nodes = nodes};
    for (int i = 1; i < nodes; i++) {
        tie(i, 0);
    }
}

static inline void make_all(int nodes) {
    g = (graph){.nodes = nodes};
    for (int i = 0; i < nodes; i++) {
        for (int k = 0; k < i; k++) {
            tie(i, k);
        }
    }
}

static inline void make_grid(int side) {
    g = (graph){.nodes = side * side};
    for (int i = 0; i < side * side; i++) {
        if (i % side) {
            tie(i - 1, i);
        }
        if (i >= side) {
            tie(i - side, i);
        }
    }
}

/* Some nodes may have no edge. */
static inline void make_random(int nodes, double share, uint64_t *seed) {
    g = (graph){.nodes = nodes};
    for (int i = 0; i < nodes; i++) {
        for (int k = 0; k < i; k++) {
            if (random_in(seed, 0, 1) < share) {
                tie(i, k);
            }
        }
    }
}

/* ---- matrices ---- */

/* Fills a matrix with a dominant diagonal; nodes' scales differ by up to 10^4. */
static inline void fill_dense(uint64_t *seed) {
    full = (dense){.size = 3 * g.nodes};
    double scale[NODES_MOST];
    for (int i = 0; i < g.nodes; i++) {
        scale[i] = pow(10, random_in(seed, 0, 2));
        for (int k = 0; k < 3; k++) {
            full.at[3 * i + k][3 * i + k] = (long double)(scale[i] * scale[i]) * 3;
            full.right[3 * i + k] = (long double)random_in(seed, -1, 1);
        }
        for (int k = 1; k < 3; k++) {
            for (int j = 0; j < k; j++) {
                full.at[3 * i + k][3 * i + j] = full.at[3 * i + j][3 * i + k] =
                    (long double)(random_in(seed, -1, 1) * scale[i] * scale[i]);
            }
        }
    }
    for (int e = 0; e < g.edges; e++) {
        int a = g.edge[e][0], b = g.edge[e][1];
        for (int k = 0; k < 9; k++) {
            long double value =
                (long double)(random_in(seed, -1, 1) * scale[a] * scale[b]) / g.nodes;
            full.at[3 * a + k / 3][3 * b + k % 3] = value;
            full.at[3 * b + k % 3][3 * a + k / 3] = value;
        }
    }
}

/* Cholesky: the factor replaces `at`, and the solution replaces `right`. */
static inline void solve_dense(void) {
    for (int i = 0; i < full.size; i++) {
        for (int k = 0; k <= i; k++) {
            long double sum = full.at[i][k];
            for (int j = 0; j < k; j++) {
                sum -= full.at[i][j] * full.at[k][j];
            }
            assert_true(i != k || sum > 0);
            full.at[i][k] = i == k ? sqrtl(sum) : sum / full.at[k][k];
        }
    }
    for (int i = 0; i < full.size; i++) {
        for (int k = 0; k < i; k++) {
            full.right[i] -= full.at[i][k] * full.right[k];
        }
        full.right[i] /= full.at[i][i];
    }
    for (int i = full.size - 1; i >= 0; i--) {
        for (int k = i + 1; k < full.size; k++) {
            full.right[i] -= full.at[k][i] * full.right[k];
        }
        full.right[i] /= full.at[i][i];
    }
}

#endif
