/* solve.h: the contact problem of all bodies at once: which impulses make every contact obey
 * Signorini's and Coulomb's laws.
 *
 * For the velocities v after the impulses, with normal and tangent parts n and t of contact i:
 *     v_n + bias >= 0,  n >= 0,  n (v_n + bias) = 0
 *     |t| <= friction n,  t = -friction n sign(v_t) where v_t != 0 */
#ifndef THUD_ORACLE_SOLVE_H
#define THUD_ORACLE_SOLVE_H

#include "sim/skyline.h"

/* Of a centre of mass; impulses over it, or pushes without time. */
typedef struct motion {
    double x, y, turn;
} motion;

typedef struct inverse_mass {
    double linear, angular; /* 1/kg, 1/(kg m^2); 0 for what does not give way */
} inverse_mass;

typedef enum contact_state {
    CONTACT_OPEN = 0,
    CONTACT_STICK,
    CONTACT_SLIP_FORWARD, /* t = +friction n: b slips over a against the tangent */
    CONTACT_SLIP_BACK
} contact_state;

typedef struct contact {
    int body_a, body_b;
    int shape_a, shape_b, feature;         /* tell it from others */
    double x, y;                           /* the point */
    double normal_x, normal_y;             /* from a to b; the tangent is (normal_y, -normal_x) */
    double arm_ax, arm_ay, arm_bx, arm_by; /* from the centres of mass to the point */
    double gap, size;                      /* m, of the smaller shape */
    double friction, restitution;
    double bias;            /* m/s */
    contact_state state;    /* guess, and then the answer */
    double normal, tangent; /* the same of the impulses on b, kg m/s */
} contact;

/* Relative velocity of b at the contact, along the normal or the tangent. */
double contact_normal_speed(const contact *c, const motion *velocities);
double contact_tangent_speed(const contact *c, const motion *velocities);

typedef struct contact_solver contact_solver;

contact_solver *contact_solver_create(int body_count); /* null without memory */
void contact_solver_destroy(contact_solver *s);        /* null is fine */

typedef struct contact_solution {
    bool ok;         /* false: memory ran out and nothing has changed */
    bool hard;       /* the active set alone was not enough */
    double residual; /* m/s, the worst breach of the laws above that is left */
} contact_solution;

/* Adds the impulses to the velocities. Contacts of low bodies first make it fast. */
contact_solution contact_solve(contact_solver *s, contact *contacts, int count,
                               const inverse_mass *masses, motion *velocities);

#endif
