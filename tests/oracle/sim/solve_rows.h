/* solve_rows.h: what the two ways of solving the contact problem share: see solve.h. */
#ifndef THUD_ORACLE_SOLVE_ROWS_H
#define THUD_ORACLE_SOLVE_ROWS_H

#include "sim/solve.h"

/* A contact's own 2x2 block of W = J M^-1 J^T, its inverse masses. */
typedef struct contact_block {
    double nn, nt, tt;
} contact_block;

/* Direction of the impulse on b, and its lever arms. */
typedef struct contact_row {
    double x, y, turn_a, turn_b;
} contact_row;

/* Coulomb's law, which the oracle has from here alone and not from the engine. */

/* Tangent impulse per normal impulse of a contact that slips. */
double contact_slip_ratio(const contact *c);

/* The tangent impulse of a contact with that normal impulse, of which the law leaves so much. */
double contact_lawful_tangent(const contact *c, double normal, double tangent);

contact_row contact_normal_row(const contact *c);
contact_row contact_tangent_row(const contact *c);

/* J M^-1 J^T of two rows through one body: `sign` is +1 if it is on the same side of both. */
double contact_coupling(contact_row one, double turn_one, contact_row other, double turn_other,
                        inverse_mass mass, double sign);

contact_block contact_own_block(const contact *c, const inverse_mass *masses);
void contact_push(const contact *c, double normal, double tangent, const inverse_mass *masses,
                  motion *velocities);

/* The breach of the laws, in m/s: how far the impulses are from the projection of what they would
 * be after one more step of the projected gradient, over its length. */
double contact_breach(const contact *c, contact_block block, const motion *velocities);

/* Sweeps over the contacts one by one, each solved exactly (projected Gauss-Seidel in blocks):
 * slow, but gets nearer always. Velocities include the contacts' impulses. */
void contact_sweep(contact *contacts, const contact_block *blocks, int count, int sweeps,
                   const inverse_mass *masses, motion *velocities);

#endif
