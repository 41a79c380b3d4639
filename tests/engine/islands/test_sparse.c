/* test_sparse.c: the block-sparse factorisation against dense Cholesky in long double: solutions,
 * operations by the elimination order, several systems, and failures. */
#include <limits.h>
#include "dense_support.h"

#include "hostile_memory.h"
#include "direct/sparse.h"

/* Begins the system of the current graph and orders it; false where an allocation fails. */
static bool order(td_memory *memory, td_sparse *s) {
    if (!td_sparse_begin(memory, s, g.nodes)) {
        return false;
    }
    for (int e = 0; e < g.edges; e++) {
        td_sparse_tie(s, g.edge[e][0], g.edge[e][1]);
    }
    return td_sparse_order(memory, s, INT_MAX);
}

/* The upper half of diagonal blocks must not be read, so it is filled with NaN. */
static void fill_sparse(td_sparse *s) {
    td_sparse_clear(s);
    for (int i = 0; i < g.nodes; i++) {
        for (int k = 0; k < 9; k++) {
            td_sparse_diagonal(s, i)->at[k % 3][k / 3] =
                k % 3 > k / 3 ? (double)NAN : (double)full.at[3 * i + k / 3][3 * i + k % 3];
        }
    }
    for (int e = 0; e < g.edges; e++) {
        int a = g.edge[e][0], b = g.edge[e][1];
        int later = td_sparse_is_later(s, a, b) ? a : b, earlier = a + b - later;
        for (int k = 0; k < 9; k++) {
            td_sparse_entry(s, td_sparse_find(s, a, b))->at[k % 3][k / 3] =
                (double)full.at[3 * later + k / 3][3 * earlier + k % 3];
        }
    }
}

/* The kernels of every instruction set give the same bits. */
static void assert_wide_kernels_agree(td_sparse *s, double (*solved)[4]) {
#if defined(TD_HAS_AVX2)
    double x[NODES_MOST][4] = {{0}}, work[NODES_MOST][4];
    if (!__builtin_cpu_supports("avx2")) {
        return;
    }
    fill_sparse(s);
    for (int i = 0; i < full.size; i++) {
        x[i / 3][i % 3] = (double)full.right[i];
    }
    s->wide = true;
    assert_true(td_sparse_factor(s));
    td_sparse_solve(s, x, work);
    s->wide = false;
    for (int i = 0; i < full.size; i++) {
        assert_memory_equal(&x[i / 3][i % 3], &solved[i / 3][i % 3], sizeof(double));
    }
#else
    (void)s, (void)solved;
#endif
}

/* Asserts that the sparse and the dense system have the same solution. */
static void assert_solves(td_sparse *s, uint64_t *seed) {
    double x[NODES_MOST][4] = {{0}}, work[NODES_MOST][4], most = 0;
    fill_dense(seed);
    fill_sparse(s);
    for (int i = 0; i < full.size; i++) {
        x[i / 3][i % 3] = (double)full.right[i];
    }
    assert_true(td_sparse_factor(s));
    td_sparse_solve(s, x, work);
    assert_wide_kernels_agree(s, x);
    solve_dense();
    for (int i = 0; i < full.size; i++) {
        most = fmax(most, fabs((double)full.right[i]));
    }
    for (int i = 0; i < full.size; i++) {
        near_to(x[i / 3][i % 3], (double)full.right[i], 1e-12 * most);
    }
}

static void assert_order_is_permutation(const td_sparse *s) {
    bool taken[NODES_MOST] = {false};
    for (int i = 0; i < g.nodes; i++) {
        int place = td_sparse_place(s, i);
        assert_in_range(place, 0, g.nodes - 1);
        assert_false(taken[place]);
        taken[place] = true;
    }
}

/* A sparse solver with its memory. */
typedef struct fixture {
    td_memory memory;
    td_sparse s;
} fixture;

static fixture begin(int nodes) {
    memory_allowed = -1;
    fixture f = {.memory = td_memory_make(hostile_memory())};
    td_sparse_init(&f.s, false);
    assert_true(td_sparse_reserve(&f.memory, &f.s, nodes));
    td_sparse_forget(&f.s);
    return f;
}

static void end(fixture *f) {
    td_sparse_free(&f->memory, &f->s);
    assert_int_equal(memory_held, 0);
}

/* Operations of one factorisation of the current graph, whose system is solved and checked. */
static int64_t work_of_graph(uint64_t *seed) {
    fixture f = begin(g.nodes);
    assert_true(order(&f.memory, &f.s));
    assert_order_is_permutation(&f.s);
    assert_solves(&f.s, seed);
    int64_t work = f.s.current.work;
    end(&f);
    return work;
}

/* ---- tests ---- */

static void sparse_single_node_is_solved(void **state) {
    (void)state;
    uint64_t seed = 1;
    make_chain(1);
    assert_int_equal(work_of_graph(&seed), 1);
}

/* Without fill-in each column has one block, except the last. An operation is counted for each
 * diagonal, each entry and each pair of entries. */
static void sparse_chain_takes_three_operations_a_node(void **state) {
    (void)state;
    uint64_t seed = 2;
    for (int nodes = 2; nodes <= NODES_MOST; nodes += 13) {
        make_chain(nodes);
        assert_int_equal(work_of_graph(&seed), 3 * nodes - 2);
    }
}

/* The elimination order begins at the leaves of a star, which causes no fill-in. */
static void sparse_star_begins_at_its_points(void **state) {
    (void)state;
    uint64_t seed = 3;
    make_star(70);
    assert_int_equal(work_of_graph(&seed), 3 * 70 - 2);
}

/* Each column has two entries, until two nodes are left. */
static void sparse_ring_fills_in_one_block_a_node(void **state) {
    (void)state;
    uint64_t seed = 4;
    make_ring(66);
    assert_int_equal(work_of_graph(&seed), 6 * 64 + 4);
}

static void sparse_full_matrix_is_solved(void **state) {
    (void)state;
    uint64_t seed = 5;
    int64_t work = 0;
    make_all(20);
    for (int entries = 0; entries < 20; entries++) {
        work += 1 + entries + entries * (entries + 1) / 2;
    }
    assert_int_equal(work_of_graph(&seed), work);
}

/* In the order of rows, each column would have as many entries as a row of the grid has nodes. */
static void sparse_grid_takes_less_than_row_by_row(void **state) {
    (void)state;
    uint64_t seed = 6;
    enum { SIDE = 8 };
    int64_t by_rows = SIDE * SIDE * (1 + SIDE + SIDE * (SIDE + 1) / 2);
    make_grid(SIDE);
    assert_true(work_of_graph(&seed) < by_rows / 2);
}

static void sparse_random_graphs_are_solved(void **state) {
    (void)state;
    uint64_t seed = 7;
    for (int i = 0; i < 200; i++) {
        int nodes = (int)random_in(&seed, 1, 30);
        make_random(nodes, random_in(&seed, 0, 0.6), &seed);
        work_of_graph(&seed);
    }
    make_random(NODES_MOST, 0.05, &seed);
    work_of_graph(&seed);
}

/* The numbers of one system at a time are kept, in any order of systems. */
static void sparse_several_systems_are_kept_at_once(void **state) {
    (void)state;
    enum { SYSTEMS = 6 };
    static graph graphs[SYSTEMS];
    td_system systems[SYSTEMS];
    uint64_t seed = 8;
    int nodes = 0;
    for (int i = 0; i < SYSTEMS; i++) {
        make_random(1 + 13 * i, 0.2, &seed);
        graphs[i] = g;
        nodes += g.nodes;
    }
    fixture f = begin(nodes);
    for (int i = 0; i < SYSTEMS; i++) {
        g = graphs[i];
        assert_true(order(&f.memory, &f.s));
        systems[i] = f.s.current;
    }
    const int turns[] = {5, 0, 3, 3, 1, 4, 2, 0};
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        g = graphs[turns[i]];
        f.s.current = systems[turns[i]];
        assert_order_is_permutation(&f.s);
        assert_solves(&f.s, &seed);
    }
    end(&f);
}

/* A new system does not depend on earlier ones. */
static void sparse_forgotten_systems_make_room(void **state) {
    (void)state;
    uint64_t seed = 9;
    fixture f = begin(NODES_MOST);
    for (int i = 0; i < 20; i++) {
        td_sparse_forget(&f.s);
        make_random((int)random_in(&seed, 1, NODES_MOST / 2), 0.1, &seed);
        assert_true(order(&f.memory, &f.s));
        assert_solves(&f.s, &seed);
    }
    end(&f);
}

/* Whether a chain is factored whose blocks are `diagonal` times the identity on the diagonal, and
 * `beside` times it between neighbours. */
static bool chain_is_factored(int nodes, double diagonal, double beside) {
    make_chain(nodes);
    fixture f = begin(nodes);
    assert_true(order(&f.memory, &f.s));
    td_sparse_clear(&f.s);
    for (int i = 0; i < nodes; i++) {
        for (int k = 0; k < 3; k++) {
            td_sparse_diagonal(&f.s, i)->at[k][k] = diagonal;
            if (i > 0) {
                td_sparse_entry(&f.s, td_sparse_find(&f.s, i - 1, i))->at[k][k] = beside;
            }
        }
    }
    bool factored = td_sparse_factor(&f.s);
    end(&f);
    return factored;
}

/* The eigenvalues of a chain of n such blocks are diagonal + 2 beside cos(k pi / (n + 1)). */
static void sparse_matrix_that_is_not_positive_definite_is_refused(void **state) {
    (void)state;
    double limit = 2 * cos(3.14159265358979323846 / 11);
    assert_true(chain_is_factored(10, limit * (1 + 1e-9), 1));
    assert_false(chain_is_factored(10, limit * (1 - 1e-9), 1));
    assert_false(chain_is_factored(2, 1, 1));
    assert_false(chain_is_factored(1, 0, 0));
    assert_false(chain_is_factored(1, -1, 0));
}

static void sparse_matrix_that_is_not_finite_is_refused(void **state) {
    (void)state;
    assert_false(chain_is_factored(1, (double)NAN, 0));
    assert_false(chain_is_factored(1, (double)INFINITY, 0));
    assert_false(chain_is_factored(3, 1, (double)NAN));
    assert_false(chain_is_factored(3, 1, (double)INFINITY));
}

/* The first attempt may allocate nothing, each later one once more than the one before, whose
 * memory it keeps, until one succeeds. */
static void sparse_failing_memory_leaves_it_usable(void **state) {
    (void)state;
    uint64_t seed = 10;
    fixture f = begin(1);
    int failures = 0;
    for (bool done = false; !done; failures += !done) {
        make_random(NODES_MOST, 0.3, &seed); /* more than is reserved at first */
        td_sparse_forget(&f.s);
        memory_allowed = failures > 0;
        done = td_sparse_reserve(&f.memory, &f.s, g.nodes) && order(&f.memory, &f.s);
        memory_allowed = -1;
        if (!done) {
            make_random(12, 0.3, &seed);
            td_sparse_forget(&f.s);
            assert_true(td_sparse_reserve(&f.memory, &f.s, g.nodes) && order(&f.memory, &f.s));
        }
        assert_solves(&f.s, &seed);
    }
    assert_true(failures > 5);
    end(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sparse_single_node_is_solved),
        cmocka_unit_test(sparse_chain_takes_three_operations_a_node),
        cmocka_unit_test(sparse_star_begins_at_its_points),
        cmocka_unit_test(sparse_ring_fills_in_one_block_a_node),
        cmocka_unit_test(sparse_full_matrix_is_solved),
        cmocka_unit_test(sparse_grid_takes_less_than_row_by_row),
        cmocka_unit_test(sparse_random_graphs_are_solved),
        cmocka_unit_test(sparse_several_systems_are_kept_at_once),
        cmocka_unit_test(sparse_forgotten_systems_make_room),
        cmocka_unit_test(sparse_matrix_that_is_not_positive_definite_is_refused),
        cmocka_unit_test(sparse_matrix_that_is_not_finite_is_refused),
        cmocka_unit_test(sparse_failing_memory_leaves_it_usable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
