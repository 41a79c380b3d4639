/* joint_tree.c: eliminates the bodies of a tree of joints one after the other. */
#include "direct/joint_tree.h"

/* If a pivot is below this share of the element that stood in its place before elimination, the row
 * follows from the rows before it, up to rounding, and cannot be solved for. Chosen. */
#define PIVOT_MIN 1e-10
/* Hysteresis of limits, as a share of the `tolerance` of speeds that td_joint_tree_solve is given:
 * a limit becomes active only if its speed is below its target speed by more than this share.
 * Chosen. */
#define HYSTERESIS 0.1
/* Maximum number of active sets of limits that are tried, each with one factorisation. Chosen. */
enum { FACTORINGS_MAX = 6 };

/* A problem while it is solved. */
typedef struct td_tree {
    td_direct *d;
    td_tree_body *bodies; /* by place */
    int count;            /* bodies */
    int limits;           /* number of unilateral rows, which may be active or not */
    int held; /* the place of the body that is joined to bodies outside of the problem; TD_NONE:
                 there is none */
} td_tree;

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Factors m = L D L' in place: L below the diagonal, 1 / D on it. False where a pivot is not
 * positive, too small or not finite. */
static bool factor(double m[6]) {
    double l10, l20, l21, d0 = m[0], d1, d2;
    m[0] = 1.0 / d0;
    l10 = m[1] * m[0];
    d1 = m[2] - l10 * m[1];
    bool sound = d0 > 0.0 && d1 > PIVOT_MIN * m[2];
    m[2] = 1.0 / d1;
    l20 = m[3] * m[0];
    double rest = m[4] - l20 * m[1];
    l21 = rest * m[2];
    d2 = m[5] - l20 * m[3] - l21 * rest;
    sound &= d2 > PIVOT_MIN * m[5] && td_finite(d0 + d1 + d2);
    m[5] = 1.0 / d2;
    m[1] = l10;
    m[3] = l20;
    m[4] = l21;
    return sound;
}

/* x = m^-1 b, by the factor of m. */
static void solve(const double m[6], const double *b, double *x) {
    double y0 = b[0], y1 = b[1] - m[1] * y0, y2 = b[2] - m[3] * y0 - m[4] * y1;
    x[2] = y2 * m[5];
    x[1] = y1 * m[2] - m[4] * x[2];
    x[0] = y0 * m[0] - m[1] * x[1] - m[3] * x[2];
}

/* ---- rows ---- */

/* Whether a row acts in the present solve: every lock and spring does, and a limit that is active.
 */
static bool acts(const td_direct_row *r) {
    return r->used && (r->kind != TD_ROW_UNILATERAL || r->active);
}

/* The speed along a row that the bodies of the problem have to reach: its target speed less the
 * part that comes from bodies outside of the problem. */
static double wanted(const td_direct_row *r) {
    return r->target_speed - r->known_speed;
}

static int place_of(const td_tree *tree, int body) {
    return body == TD_NONE ? TD_NONE : td_sparse_place(tree->d->matrix, body);
}

/* Warm-starts the active set of limits: active are those that had an impulse in the last step, and
 * those whose speed is below the target. Counts the limits, and finds the body that is joined to
 * bodies outside of the problem. False where a row has friction or a motor, or where two bodies are
 * joined to the outside, which closes a loop. */
static bool begin_rows(td_tree *tree) {
    bool solvable = true;
    for (int i = 0; i < tree->d->constraint_count; i++) {
        td_direct_constraint *c = &tree->d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            if (r->used) {
                bool limit = r->kind == TD_ROW_UNILATERAL;
                solvable &= r->kind != TD_ROW_FRICTION;
                r->active = !limit || r->impulse > 0.0 || r->speed < r->target_speed;
                tree->limits += limit;
            }
        }
        if (c->a == TD_NONE || c->b == TD_NONE) {
            int place = place_of(tree, c->a == TD_NONE ? c->b : c->a);
            solvable &= tree->held == TD_NONE || tree->held == place;
            tree->held = place;
        }
    }
    return solvable;
}

/* Finds the parents of all bodies as the matrix has them: the neighbour that is eliminated later.
 * False where the island's graph is no forest: its elimination would then fill in blocks, or a body
 * would have two such neighbours. */
static bool find_parents(const td_tree *tree) {
    const td_sparse *s = tree->d->matrix;
    const int *column = (const int *)s->column.data + s->current.place;
    const int *row = (const int *)s->row.data + s->current.row;
    bool forest = true;
    for (int p = 0; p < tree->count; p++) {
        tree->bodies[p].parent = column[p + 1] > column[p] ? row[column[p]] : TD_NONE;
        tree->bodies[p].turned_over = false;
        forest &= column[p + 1] <= column[p] + 1;
    }
    return forest;
}

/* Makes the held body the root of its tree: reverses the parent links on the path from it to the
 * old root, and eliminates the bodies of that path after all others. */
static void set_order(const td_tree *tree) {
    td_tree_body *bodies = tree->bodies;
    int before = TD_NONE, n = 0;
    for (int p = tree->held, up; p != TD_NONE; p = up) {
        up = bodies[p].parent;
        bodies[p].parent = before;
        bodies[p].turned_over = true;
        before = p;
    }
    for (int p = 0; p < tree->count; p++) {
        if (!bodies[p].turned_over) {
            bodies[n++].order = p;
        }
    }
    for (int p = before; p != TD_NONE; p = bodies[p].parent) {
        bodies[n++].order = p;
    }
}

/* Sets the bodies' masses and momenta without constraints. */
static void take_bodies(const td_tree *tree) {
    for (int i = 0; i < tree->count; i++) {
        const td_direct_body *b = &tree->d->bodies[i];
        td_tree_body *t = &tree->bodies[place_of(tree, i)];
        double mass = 1.0 / b->inverse_mass;
        /* The rows of a body that does not turn have lever arms of 0, so that any positive moment
         * of inertia is correct. */
        double inertia = b->inverse_inertia > 0.0 ? 1.0 / b->inverse_inertia : 1.0;
        t->mass[0] = t->mass[2] = mass;
        t->mass[1] = t->mass[3] = t->mass[4] = 0.0;
        t->mass[5] = inertia;
        t->push[0] = mass * b->free[0];
        t->push[1] = mass * b->free[1];
        t->push[2] = inertia * b->free[2];
        t->rows = 0;
    }
}

/* Lists the rows of the joint between every body and its parent. False where a joint has more than
 * three rows. */
static bool take_joints(const td_tree *tree) {
    for (int i = 0; i < tree->d->constraint_count; i++) {
        td_direct_constraint *c = &tree->d->constraints[i];
        int a = place_of(tree, c->a), b = place_of(tree, c->b);
        bool from_a = b == TD_NONE || (a != TD_NONE && tree->bodies[a].parent == b);
        td_tree_body *t = &tree->bodies[from_a ? a : b];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            if (!acts(r)) {
                continue;
            }
            if (t->rows == TD_DIRECT_ROWS) {
                return false;
            }
            t->row[t->rows] = r;
            t->own[t->rows] = from_a ? r->a : r->b;
            t->parents[t->rows] = from_a ? r->b : r->a;
            t->rows++;
        }
    }
    return true;
}

/* ---- elimination ---- */

/* Finds a body's response to the rows of its joint, and their compliance. False where the rows
 * depend on each other, so that S has no inverse. */
static bool respond(td_tree_body *t) {
    double *s = t->compliance;
    s[0] = s[2] = s[5] = 1.0; /* for rows that the joint does not have */
    s[1] = s[3] = s[4] = 0.0;
    for (int k = 0; k < t->rows; k++) {
        const td_direct_row *r = t->row[k];
        double *line = &s[k * (k + 1) / 2];
        solve(t->mass, t->own[k], t->response[k]);
        for (int n = 0; n <= k; n++) {
            line[n] = dot(t->own[n], t->response[k]);
        }
        line[k] += r->kind == TD_ROW_SOFT ? 1.0 / r->weight : 0.0;
    }
    return factor(s);
}

/* Adds the contribution of a body and its joint to the parent's equation of motion: A_p and g_p of
 * joint_tree.h. */
static void add_to_parent(td_tree_body *t, td_tree_body *parent) {
    for (int i = 0; i < 3; i++) {
        double column[3] = {0.0, 0.0, 0.0};
        for (int k = 0; k < t->rows; k++) {
            column[k] = t->parents[k][i];
        }
        solve(t->compliance, column, column);
        for (int k = 0; k < 3; k++) {
            t->coupling[k][i] = column[k];
        }
    }
    for (int k = 0; k < t->rows; k++) {
        const double *j = t->parents[k], *c = t->coupling[k];
        double *mass = parent->mass;
        mass[0] += j[0] * c[0];
        mass[1] += j[1] * c[0];
        mass[2] += j[1] * c[1];
        mass[3] += j[2] * c[0];
        mass[4] += j[2] * c[1];
        mass[5] += j[2] * c[2];
        for (int n = 0; n < 3; n++) {
            parent->push[n] += j[n] * t->impulse[k];
        }
    }
}

/* Eliminates all bodies, from the ends of the tree to its roots. */
static bool eliminate(const td_tree *tree) {
    for (int n = 0; n < tree->count; n++) {
        td_tree_body *t = &tree->bodies[tree->bodies[n].order];
        if (!factor(t->mass) || !respond(t)) {
            return false;
        }
        double missing[3] = {0.0, 0.0, 0.0};
        solve(t->mass, t->push, t->push);
        for (int k = 0; k < t->rows; k++) {
            missing[k] = wanted(t->row[k]) - dot(t->own[k], t->push);
        }
        solve(t->compliance, missing, t->impulse);
        if (t->parent != TD_NONE) {
            add_to_parent(t, &tree->bodies[t->parent]);
        }
    }
    return true;
}

/* Velocities and impulses, from the roots to the ends of the tree. The impulses go into the rows'
 * `force`. Whether all velocities are finite, and all springs below their maximum forces. */
static bool substitute(const td_tree *tree) {
    double sum = 0.0;
    bool in_range = true;
    for (int n = tree->count - 1; n >= 0; n--) {
        td_tree_body *t = &tree->bodies[tree->bodies[n].order];
        const double none[3] = {0.0, 0.0, 0.0};
        bool root = t->parent == TD_NONE;
        const double *parent = root ? none : tree->bodies[t->parent].push;
        double *v = t->push;
        for (int k = 0; k < t->rows; k++) {
            double impulse = t->impulse[k] - (root ? 0.0 : dot(t->coupling[k], parent));
            for (int i = 0; i < 3; i++) {
                v[i] += t->response[k][i] * impulse;
            }
            t->row[k]->force = impulse;
        }
        for (int k = 0; k < t->rows; k++) {
            td_direct_row *r = t->row[k];
            r->speed = r->known_speed + dot(t->own[k], v);
            r->speed += root ? 0.0 : dot(t->parents[k], parent);
            in_range &= r->kind != TD_ROW_SOFT || td_abs(r->force) <= r->max_impulse;
        }
        sum += v[0] + v[1] + v[2];
    }
    return in_range && td_finite(sum);
}

/* ---- the solution ---- */

/* The speed along a limit's row for the new velocities; rows that are not active get none from
 * substitute. */
static double free_speed(const td_tree *tree, const td_direct_constraint *c,
                         const td_direct_row *r) {
    int a = place_of(tree, c->a), b = place_of(tree, c->b);
    return r->known_speed + (a == TD_NONE ? 0.0 : dot(r->a, tree->bodies[a].push)) +
           (b == TD_NONE ? 0.0 : dot(r->b, tree->bodies[b].push));
}

/* Updates the active set: removes limits whose impulse is negative, and adds those that are
 * violated. Returns how many rows have changed. */
static int change_limits(const td_tree *tree, double tolerance) {
    int changed = 0;
    for (int i = 0; i < tree->d->constraint_count && tree->limits; i++) {
        td_direct_constraint *c = &tree->d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            if (!r->used || r->kind != TD_ROW_UNILATERAL) {
                continue;
            }
            bool before = r->active;
            if (before) {
                r->active = r->force >= 0.0;
            } else {
                r->force = 0.0;
                r->speed = free_speed(tree, c, r);
                r->active = r->speed < r->target_speed - HYSTERESIS * tolerance;
            }
            changed += r->active != before;
        }
    }
    return changed;
}

/* Writes the solution, and returns the residual. */
static double write_solution(const td_tree *tree) {
    td_direct *d = tree->d;
    double worst = 0.0;
    for (int i = 0; i < tree->count; i++) {
        const double *v = tree->bodies[place_of(tree, i)].push;
        for (int k = 0; k < 3; k++) {
            d->bodies[i].velocity[k] = v[k];
        }
    }
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            if (r->used) {
                double missing = r->target_speed - r->speed;
                r->impulse = r->force;
                missing = r->kind == TD_ROW_EQUALITY ? td_abs(missing) : missing;
                worst = r->kind == TD_ROW_SOFT ? worst : td_max_double(worst, missing);
            }
        }
    }
    return worst;
}

/* Solves the problem for the present active set of limits. */
static bool solve_rows(const td_tree *tree) {
    td_direct *d = tree->d;
    if (!td_direct_take_effort(d, d->matrix->current.work)) {
        return false;
    }
    d->factorings++;
    take_bodies(tree);
    return take_joints(tree) && eliminate(tree) && substitute(tree);
}

bool td_joint_tree_solve(td_direct *d, td_tree_body *bodies, double tolerance, double *residual) {
    td_tree tree = {.d = d, .bodies = bodies, .count = d->body_count, .held = TD_NONE};
    if (!begin_rows(&tree) || !find_parents(&tree)) {
        return false;
    }
    set_order(&tree);
    d->measured = false; /* the rows' speeds are overwritten by those of each try */
    int changed = 1;
    for (int n = 0; changed && n < FACTORINGS_MAX && d->factorings < d->factoring_budget; n++) {
        if (!solve_rows(&tree)) {
            return false;
        }
        changed = change_limits(&tree, tolerance);
    }
    if (!changed) {
        *residual = write_solution(&tree);
    }
    return !changed;
}
