/* sim.h: the state of the reference simulation (oracle.c), and the functions of its parts. */
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
    double *margins;     /* m, for each shape */
    contact_list found;  /* contacts at the places of the last call of sim_find_contacts */
    contact_list active; /* contacts of the last step, sorted by `contact_order` */
    contact_list chosen; /* scratch space for a part of `found` */
    double last_step;    /* s, length of the step that `active` was solved for */
    double slow, tiny;   /* m/s, thresholds of sim_least_impact */
    oracle_force *forces;
    oracle_report report;
};

/* A contact is closed if its gap is below this share of its size. */
#define SIM_CLOSED 1e-9

/* Finds all contacts of bodies that move for at most `time` seconds from their present places,
 * sorted for the solver. Contacts that existed in the last step keep their state. False if memory
 * runs out. */
bool sim_find_contacts(oracle *o, double time);

bool sim_list_add(contact_list *list, const contact *c); /* false if memory runs out */

/* m/s: slower approaches are not impacts, and a step absorbs them. The threshold of elastic
 * contacts is that of the settings; that of inelastic ones is the speed that gravity gives in a few
 * steps. */
double sim_least_impact(const oracle *o, const contact *c);

/* Seconds until the next impact among the contacts of `found` that are open; at most `limit`. */
double sim_time_to_impact(oracle *o, double limit);

/* Solves impacts without advancing the time: closed contacts that approach bounce, then those
 * without restitution are brought to rest. False if memory runs out. */
bool sim_impacts(oracle *o);

/* Removes overlaps of contacts in `found` by moving bodies, without changing velocities. *moved
 * tells whether there were any. */
bool sim_part_overlaps(oracle *o, bool *moved);

#endif
