/* joint_tree.h: the problem of direct.h where the joints of an island form a tree, solved exactly
 * in time that grows with the number of bodies.
 *
 * Bodies are eliminated from the ends of the tree towards its root. A body i hangs from one body p
 * that is eliminated later, its parent, by the locked rows
 *
 *     J_i v_i + J_p v_p = t.
 *
 * Its equation of motion, A_i v_i = g_i + J_i' y, already includes all bodies below it in the tree.
 * So the impulses y of the rows, with S = J_i A_i^-1 J_i', and the sums that are added to the
 * parent's equation, are
 *
 *     y = S^-1 (t - J_i A_i^-1 g_i - J_p v_p),
 *     A_p += J_p' S^-1 J_p,
 *     g_p += J_p' S^-1 (t - J_i A_i^-1 g_i).
 *
 * Then velocities and impulses follow from the root outwards. (D. Baraff, "Linear-time dynamics
 * using Lagrange multipliers", 1996.) No matrix of the whole island is built, and rows are
 * satisfied to rounding, where the active set of active_set.c needs penalties and conjugate
 * gradients.
 *
 * A spring between i and p is a row whose impulse is weight (target - speed): 1 / weight is added
 * to its element of S's diagonal. A limit is one of the rows while it is in the active set. The
 * body that is joined to bodies outside of the problem is the root, and these rows are those of its
 * own joint. */
#ifndef TD_JOINT_TREE_H
#define TD_JOINT_TREE_H

#include "direct/direct.h"

/* A body, by its place in the elimination order, with the joint to its parent. Symmetric matrices
 * are given by their lower halves, row by row. */
typedef struct td_tree_body {
    double mass[6];        /* A_i, then its factor */
    double push[3];        /* g_i, then A_i^-1 g_i, at last the velocity */
    double response[3][3]; /* A_i^-1 J_k' of each row k of the joint */
    double compliance[6];  /* S, then its factor */
    double coupling[3][3]; /* S^-1 J_p, row by row */
    double impulse[3];     /* S^-1 (t - J_i A_i^-1 g_i) */
    td_direct_row *row[3]; /* the joint's rows; own, parents: the parts of their Jacobians for i
                              (J_i) and for p (J_p) */
    const double *own[3], *parents[3];
    int rows;         /* of the joint */
    int parent;       /* place of p; TD_NONE: the body is the root of a tree */
    bool turned_over; /* the body is on the path whose links set_order reverses, so that its parent
                         p may come before it in the matrix's order */
    int order;        /* of element n: the place of the body that is eliminated as number n */
} td_tree_body;

/* Solves the problem as td_direct_solve does: the solution is in the bodies' velocities and the
 * rows' impulses, and *residual is the greatest speed by which a row misses its target speed.
 * `bodies` is scratch memory, one for each body of the problem. False, with velocities and impulses
 * unchanged, where the joints do not form a tree, more than one body is joined to the outside, two
 * bodies are joined by more than three rows or by rows that repeat each other, where a row has
 * friction, a motor, or a spring beyond its maximum force, where no active set of limits is found
 * that satisfies all of them to `tolerance`, and where the budget of work is too small. */
bool td_joint_tree_solve(td_direct *d, td_tree_body *bodies, double tolerance, double *residual);

#endif
