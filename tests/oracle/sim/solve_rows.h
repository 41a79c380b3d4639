/* solve_rows.h: functions shared by the two methods for the contact problem of solve.h: the active
 * set method and the sweeps. */
#ifndef THUD_ORACLE_SOLVE_ROWS_H
#define THUD_ORACLE_SOLVE_ROWS_H

#include "sim/solve.h"

/* A contact's own 2x2 block of W = J M^-1 J^T. */
typedef struct contact_block {
    double nn, nt, tt;
} contact_block;

/* The direction of an impulse on b, and its lever arms on both bodies. */
typedef struct contact_row {
    double x, y, turn_a, turn_b;
} contact_row;

/* Coulomb's law, in the oracle's own implementation. */

/* Tangent impulse over normal impulse of a contact that slips. */
double contact_slip_ratio(const contact *c);

/* The tangent impulse clamped to the law's bound for this normal impulse. */
double contact_lawful_tangent(const contact *c, double normal, double tangent);

contact_row contact_normal_row(const contact *c);
contact_row contact_tangent_row(const contact *c);

/* The part of J M^-1 J^T of two rows through one body; `sign` is +1 if it is on the same side of
 * both contacts, otherwise -1. */
double contact_coupling(contact_row one, double turn_one, contact_row other, double turn_other,
                        inverse_mass mass, double sign);

contact_block contact_own_block(const contact *c, const inverse_mass *masses);
/* Adds a normal and a tangent impulse to the velocities of both bodies. */
void contact_push(const contact *c, double normal, double tangent, const inverse_mass *masses,
                  motion *velocities);

/* The violation of the laws in m/s: the distance of the impulses from their projection after one
 * more step of the projected gradient method, over the length of that step. */
double contact_breach(const contact *c, contact_block block, const motion *velocities);

/* Block projected Gauss-Seidel: solves each contact exactly, one after the other, in each of
 * `sweeps` passes. Slow, but it always converges. The velocities include the contacts' impulses. */
void contact_sweep(contact *contacts, const contact_block *blocks, int count, int sweeps,
                   const inverse_mass *masses, motion *velocities);

#endif
