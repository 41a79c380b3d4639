/* sim.h: the state of the reference simulation, shared by the files that make it. */
#ifndef THUD_ORACLE_SIM_H
#define THUD_ORACLE_SIM_H

#include "oracle.h"

#include "model.h"
#include "pairs.h"
#include "sim/solve.h"

typedef struct contact_list {
    contact *contacts;
    int count, capacity;
} contact_list;

struct oracle {
    oracle_settings settings;
    model model;
    near_pairs near;
    contact_solver *solver;
    inverse_mass *masses;
    motion *places, *velocities; /* of the centres of mass */
    motion *scratch;
    double *margins;     /* m, a shape */
    contact_list found;  /* at the places last looked at */
    contact_list active; /* solved in the last step, in the order of `contact_order` */
    contact_list chosen; /* room for a part of `found` */
    double last_step;    /* s, which `active` acted for */
    double slow, tiny;   /* m/s, see sim_least_impact */
    oracle_force *forces;
    oracle_report report;
};

/* Contacts nearer than this share of a size are closed. */
#define SIM_CLOSED 1e-9

/* Finds all contacts, of bodies that move for `time` seconds at most from where they are now, in
 * the order that the solver likes, and in the states of the last step where they were
 * there then. False if memory runs out. */
bool sim_find_contacts(oracle *o, double time);

bool sim_list_add(contact_list *list, const contact *c); /* false without memory */

/* A slower approach, in m/s, is no impact: the step absorbs it. What does not bounce may be as fast
 * as gravity makes it within a few steps, what does bounce only as fast as the settings say. */
double sim_least_impact(const oracle *o, const contact *c);

/* Seconds until the next impact of the contacts of `found` that are open now; at most `limit`. */
double sim_time_to_impact(oracle *o, double limit);

/* At once: every closed contact that approaches bounces, then comes to rest what does not. */
bool sim_impacts(oracle *o);

/* At once: takes overlaps out of `found`, without a speed. *moved tells whether there were any. */
bool sim_part_overlaps(oracle *o, bool *moved);

#endif
