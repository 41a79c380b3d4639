/* solve.h: the contact problem of all bodies: find impulses for which all contacts obey the laws of
 * Signorini and Coulomb.
 *
 * For the velocities v after the impulses, with normal and tangent parts n and t at contact i:
 *     v_n + bias >= 0,  n >= 0,  n (v_n + bias) = 0
 *     |t| <= friction n,  t = -friction n sign(v_t) where v_t != 0 */
#ifndef THUD_ORACLE_SOLVE_H
#define THUD_ORACLE_SOLVE_H

#include "sim/skyline.h"

/* Velocity of a centre of mass; also used for impulses times inverse mass, and for displacements.
 */
typedef struct motion {
    double x, y, turn;
} motion;

typedef struct inverse_mass {
    double linear, angular; /* 1/kg, 1/(kg m^2); 0 for bodies that impulses do not move */
} inverse_mass;

typedef enum contact_state {
    CONTACT_OPEN = 0,
    CONTACT_STICK,
    CONTACT_SLIP_FORWARD, /* t = +friction n: b slips over a against the tangent direction */
    CONTACT_SLIP_BACK
} contact_state;

typedef struct contact {
    int body_a, body_b;
    int shape_a, shape_b, feature;         /* identify the contact */
    double x, y;                           /* the point */
    double normal_x, normal_y;             /* from a to b; the tangent is (normal_y, -normal_x) */
    double arm_ax, arm_ay, arm_bx, arm_by; /* from the centres of mass to the point */
    double gap, size;                      /* m; size of the smaller shape */
    double friction, restitution;
    double bias;            /* m/s */
    contact_state state;    /* in: guess, out: result */
    double normal, tangent; /* impulses on b, kg m/s; in: guess, out: result */
} contact;

/* The velocity of b relative to a at the contact, along the normal or the tangent, m/s. */
double contact_normal_speed(const contact *c, const motion *velocities);
double contact_tangent_speed(const contact *c, const motion *velocities);

typedef struct contact_solver contact_solver;

contact_solver *contact_solver_create(int body_count); /* null if memory runs out */
void contact_solver_destroy(contact_solver *s);        /* may be null */

typedef struct contact_solution {
    bool ok;         /* false: memory ran out, and nothing has changed */
    bool hard;       /* the active set method alone did not converge */
    double residual; /* m/s, largest violation of the laws in the result */
} contact_solution;

/* Solves, and adds the impulses to the velocities. Contacts should be sorted by body, for speed. */
contact_solution contact_solve(contact_solver *s, contact *contacts, int count,
                               const inverse_mass *masses, motion *velocities);

#endif
