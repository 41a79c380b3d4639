/* direct.h: velocities of an island of bodies, with all its constraints at once.
 *
 * A constraint brings one to three rows. Of all velocities v that keep the speed along every row
 * that pushes at least as `wanted`, and along every row that is an equality exactly so, those
 * nearest to the free ones v*, in the norm of the masses, are what rigid bodies do:
 *     minimise (v - v*)' M (v - v*) / 2   subject to   J v >= wanted, or =.
 * Friction is a force along the tangent of at most `most`, which is frozen while velocities are
 * sought and follows the normal impulses then. Two methods, both in Newton steps with one sparse
 * factorisation each: an active set (direct_active.c), which takes one or two where hardly anything
 * has changed since the step before; and an interior point (direct_interior.c), which takes ten to
 * twenty from anywhere. */
#ifndef TD_DIRECT_H
#define TD_DIRECT_H

#include "islands/sparse.h"

enum {
    TD_DIRECT_ROWS = 3, /* of a contact: two points and the tangent ... */
    TD_DIRECT_TANGENT = 2
};

/* Odd ones begin active. */
typedef enum td_row_kind {
    TD_ROW_PUSH, /* never the last row: impulse >= 0, speed >= wanted, and one of both with equality
                  */
    TD_ROW_EQUAL, /* speed = wanted, whatever impulse that takes */
    /* From here on a row may miss what is wanted. */
    TD_ROW_FRICTION, /* |impulse| <= most, and less only where speed = wanted */
    TD_ROW_SOFT /* impulse = weight * (wanted - speed), and |impulse| <= most, infinite where it
                   has no greatest force: a spring */
} td_row_kind;

typedef struct td_direct_body {
    double inverse_mass, inverse_inertia; /* inertia 0: does not turn */
    double free[3];                       /* velocity without contacts: x, y, turn */
    double velocity[3];                   /* in: a guess; out: the solution */
    double before[3];                     /* velocity at the start of this part of the step ... */
    double moved[3];                      /* ... and motion until then */
    double stiff, own_inverse_inertia, gain[3]; /* of joints: island_joints.c */
    bool sweeps, rubs; /* its turn moves what joints hold; and what others touch: not a wheel's */
} td_direct_body;

typedef struct td_direct_row {
    td_row_kind kind;
    double a[3], b[3]; /* J: of either side */
    double wanted;     /* speed along the row; of a tangent: at which friction would have it */
    double known;      /* speed that sides without a variable give it */
    double impulse;    /* in: as known; out: the solution's */
    double guess;      /* the impulse as it came in */
    double closing;    /* of a joint: speed at which the gap of the part's start closes in it; of a
                          contact: at which what overlaps at the start of the step is pushed apart */
    double given;      /* of a joint: what it gave on the way, while velocities at the end of a part
                          are mended: island_joints.c */
    bool used;         /* there is such a row */
    bool active;       /* stands in the matrix, with `weight` */
    double mass;       /* that it feels */
    double weight;     /* of a soft row: given */
    double base, most; /* of a tangent or a soft row: |impulse| <= most */
    double speed;      /* J v + known */
    double force;      /* impulse that goes to the right side */
    double change;     /* of the speed by a Newton step */
    double slack[2], push[3]; /* interior point: slacks; steps of the impulse and the slacks */
} td_direct_row;

typedef struct td_direct_constraint {
    int a, b;        /* bodies; TD_NONE: that side is no variable */
    int entry;       /* of the matrix, where both are */
    bool b_later;    /* it has b's rows */
    double friction; /* of the last row, where it is friction: times all that pushes */
    double bound;    /* ... and this on top, whatever pushes: a motor's */
    bool keeps;      /* a contact whose impulses are known, and which is only kept from closing */
    double stiff[2]; /* of a joint: moment that its impulses lose as a side turns */
    td_direct_row row[TD_DIRECT_ROWS];
} td_direct_constraint;

typedef struct td_direct {
    td_direct_body *bodies;
    td_direct_constraint *constraints;
    td_sparse *matrix;             /* ordered, of the bodies */
    double (*step)[4], (*work)[4]; /* room for as many as bodies */
    int body_count, constraint_count;
    double unit_speed; /* what a body gains by gravity in a step */
    int factorings;    /* so far ... */
    int patience;      /* ... and at most */
    int64_t effort;    /* operations that are left, of about a block of a matrix each ... */
    bool spent;        /* ... and too few, so that it failed */
    bool fresh;        /* the impulses are guesses of another solver, or none are known */
    bool factored;     /* the matrix of the active rows stands */
} td_direct;

/* Puts the solution into velocities and impulses. Returns the greatest speed by which a contact
 * misses what it wants, which is at most `tolerance` where all went well; infinite where numbers
 * failed. */
double td_direct_solve(td_direct *d, double tolerance);

/* ---- the two methods ---- */

/* True where the active rows were found in a few steps. */
bool td_direct_active(td_direct *d, double tolerance);
/* The same rows once more, for other free velocities and wanted speeds that leave them as they are,
 * without another matrix; impulses may be far off. False, with the impulses as they were, where
 * that will not do. */
bool td_direct_again(td_direct *d, double tolerance);
/* False where numbers failed, or steps ran out. */
bool td_direct_interior(td_direct *d, double tolerance);

/* ---- what they share ---- */

void td_direct_measure(td_direct *d); /* speeds of all rows */
/* The matrix of masses and active rows, factored; false where numbers failed, or it is too dear. */
bool td_direct_factor(td_direct *d);
/* Solves for what masses and the rows' forces leave unbalanced: the bodies' step, the rows' change.
 * False where it is too dear. */
bool td_direct_step(td_direct *d);
/* Goes a part of that step; false where numbers failed. */
bool td_direct_move(td_direct *d, double part);
/* Solves what the active rows still miss, of forces that balance the velocities, without another
 * matrix, down to `enough`, where it can; nobody changes his mind. Leaves the impulses in `force`.
 * False where numbers failed. */
bool td_direct_polish(td_direct *d, double enough);
/* The greatest speed by which a row misses what it wants. */
double td_direct_miss(const td_direct *d);
/* The sum of what a constraint's rows push. */
static inline double td_direct_load(const td_direct_constraint *c) {
    double load = 0.0;
    for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
        load += c->row[k].used && c->row[k].kind == TD_ROW_PUSH ? c->row[k].impulse : 0.0;
    }
    return load;
}
/* The bound of a contact's friction for the impulses along the normals and the speed at which it
 * slides, as both stand. */
double td_direct_friction(const td_direct_constraint *c);
/* Gives the tangents of all contacts that bound. */
void td_direct_bound(td_direct *d);
/* Impulses as they came in, with the bounds and speeds that they give: what a method has made of
 * them tells nothing where it has failed. */
void td_direct_forget(td_direct *d);

#endif
