/* oracle.h: measures the accuracy of engines, and shares no code with any of them.
 *
 * It has two parts. A meter scores a state that an engine returns: overlap, approach at touching
 * points, energy, momentum. A reference simulation, slow and in double precision, computes where
 * bodies should be if the motion is not chaotic. README.md beside this file describes how both were
 * checked, and their own errors.
 *
 * Units are those of scenes: metres, seconds, kilograms, radians. Masses are computed from the
 * scene, never taken from an engine. Friction is combined as the geometric mean, restitution as the
 * maximum. */
#ifndef THUD_ORACLE_H
#define THUD_ORACLE_H

#include "engine.h"

/* ---- scoring a state ---- */

/* A contact point touches if its gap is below this share of the smaller shape's size. */
#define ORACLE_TOUCH 1e-3

/* The size of a shape is a circle's diameter or a box's shorter side. A pair has the size of the
 * smaller one; terrain and static shapes have none, so that the other shape's counts. */
typedef struct oracle_score {
    int touching;            /* pairs with a touching point */
    double penetration_max;  /* m, deepest overlap; 0 if nothing overlaps */
    double penetration_mean; /* m, mean over the touching pairs, with 0 for one that does not
                                overlap */
    double relative_max;     /* the same two, relative to the pairs' sizes */
    double relative_mean;
    double approach_max;     /* m/s, fastest approach at a touching point: the velocity residual. It
                                need not be 0 for a pair that began to touch within the last step */
    double approach_rms;     /* m/s, root mean square over the touching points; separating ones
                                count as 0 */
    double gap_max;          /* m, largest gap of a joint in directions that it locks */
    double gap_mean;         /* m, mean over all joints without lost bodies */
    double gap_angle;        /* rad, largest angle error, also beyond limits of angles */
    double kinetic_energy;   /* J, of dynamic bodies, as all values below */
    double potential_energy; /* J, 0 at the world's origin */
    double energy;           /* J, the sum of both */
    double momentum_x, momentum_y; /* kg m/s */
    double angular_momentum;       /* kg m^2/s, about the world's origin */
    double speed_max;              /* m/s, of a centre of mass */
    double height;                 /* m, highest centre of mass, measured against gravity; along y
                                      without gravity */
    int lost; /* bodies without a finite state; not counted in any other field */
} oracle_score;

typedef struct oracle_meter oracle_meter;

/* Null if memory runs out. The scene must outlive the meter, and its bodies and shapes must not
 * change. */
oracle_meter *oracle_meter_create(const scene *s);
void oracle_meter_destroy(oracle_meter *meter); /* may be null */

/* Scores a state, given as the scene's bodies in their order. False, with *score zero, if memory
 * runs out. Pairs that cannot collide are left out: two shapes of one body, two bodies of which
 * none is dynamic, sensors, and pairs that filters or joints exclude. */
bool oracle_measure(oracle_meter *meter, const engine_body *bodies, oracle_score *score);

/* The difference of two states, over the scene's dynamic bodies. If a body is lost in one of them,
 * all values are infinite. */
typedef struct oracle_deviation {
    double position_max, position_rms; /* m, of the centre of mass */
    double angle_max;                  /* rad, in [0, pi] */
    double velocity_max;               /* m/s */
} oracle_deviation;

oracle_deviation oracle_compare(const scene *s, const engine_body *expected,
                                const engine_body *actual);

/* ---- the reference simulation ---- */

typedef struct oracle_settings {
    double step; /* s, maximum length; default 1/1920. Impacts make steps shorter */
    double restitution_threshold; /* m/s: slower approaches do not bounce; default 0.01. The
                                     engines' default is 1 */
} oracle_settings;

oracle_settings oracle_default_settings(void);

/* Counts and errors of a run, since its creation. */
typedef struct oracle_report {
    double time;         /* s, simulated */
    long steps;          /* solved steps, including those that end at impacts */
    long impacts;        /* times at which impacts were solved */
    double residual_max; /* m/s, largest violation of the contact laws after a solve */
    long hard_solves;    /* solves for which the active set method alone did not converge */
} oracle_report;

/* The force at a contact point, averaged over the last step. */
typedef struct oracle_force {
    int body_a, body_b;        /* indices in the scene */
    double x, y;               /* the point, m */
    double normal_x, normal_y; /* from a to b */
    double normal, tangent;    /* N, on b, along the normal and (normal_y, -normal_x) */
} oracle_force;

typedef struct oracle oracle;

/* Null if memory runs out, the scene has failed, or a setting is not finite and positive (the
 * threshold may be 0); null settings are the defaults. Bodies that overlap at the start are first
 * moved apart, without changing velocities. The scene must outlive the oracle. */
oracle *oracle_create(const scene *s, const oracle_settings *settings);
void oracle_destroy(oracle *o); /* may be null */

/* Advances by `seconds`. False, without any change, if they are negative or not finite; also false
 * if memory runs out, after a part of the time. */
bool oracle_advance(oracle *o, double seconds);

/* Writes the present state in the scene's order, for oracle_measure and oracle_compare. */
void oracle_read(const oracle *o, engine_body *bodies);
oracle_report oracle_get_report(const oracle *o);
/* The forces at all contact points where they are not 0. The array belongs to the oracle and is
 * valid until its next call; null, with *count 0, if memory runs out. */
const oracle_force *oracle_forces(oracle *o, int *count);

/* Creates, advances, reads and destroys an oracle: writes the states at `count` increasing times
 * (s, >= 0) one after the other to `samples`, which must have room for count times body_count
 * bodies. `report` may be null. False for the same reasons as oracle_create and oracle_advance. */
bool oracle_run(const scene *s, const oracle_settings *settings, const double *times, int count,
                engine_body *samples, oracle_report *report);

#endif
