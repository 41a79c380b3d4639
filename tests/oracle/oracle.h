/* oracle.h: the judge of every engine's accuracy. It shares no code with any of them.
 *
 * Two uses. A meter scores the state that any engine gives back: overlap, approach at touching
 * points, energy, momentum. And a reference simulation, slow and in double precision, says where
 * bodies ought to be, wherever that is not chaotic. README.md beside this file tells how both were
 * checked and how wrong they are themselves.
 *
 * Units are the scene's: metres, seconds, kilograms, radians. Masses follow from the scene, never
 * from an engine. Friction mixes as the geometric mean and restitution as the larger. */
#ifndef THUD_ORACLE_H
#define THUD_ORACLE_H

#include "engine.h"

/* ---- scoring a state ---- */

/* A point touches if its gap is below this share of the smaller shape's size. */
#define ORACLE_TOUCH 1e-3

/* Size of a shape: a circle's diameter, a box's shorter side. Of a pair, the smaller one counts;
 * terrain and static shapes have no size, so that the other one's counts there. */
typedef struct oracle_score {
    int touching;            /* pairs with a touching point */
    double penetration_max;  /* m, deepest overlap; 0 if nothing overlaps */
    double penetration_mean; /* m, over the touching pairs, 0 for one that does not overlap */
    double relative_max;     /* the same two in sizes */
    double relative_mean;
    double approach_max;     /* m/s, fastest approach at a touching point: the velocity residual.
                 A pair that met within the last step may approach rightly */
    double approach_rms;     /* m/s, over the touching points; parting counts as 0 */
    double gap_max;          /* m, by which a joint is open in what it locks */
    double gap_mean;         /* m, over all joints that are not of lost bodies */
    double gap_angle;        /* rad, likewise, and past limits of turns */
    double kinetic_energy;   /* J, of dynamic bodies, like all below */
    double potential_energy; /* J, 0 at the world's origin */
    double energy;           /* J, the sum of both */
    double momentum_x, momentum_y; /* kg m/s */
    double angular_momentum;       /* kg m^2/s, about the world's origin */
    double speed_max;              /* m/s, of a centre of mass */
    double height;                 /* m, of the highest centre of mass against gravity; in a world
     without gravity along y */
    int lost;                      /* bodies without a finite state; they count nowhere else */
} oracle_score;

typedef struct oracle_meter oracle_meter;

/* Null if memory runs out. The scene must outlive the meter and keep its bodies and shapes. */
oracle_meter *oracle_meter_create(const scene *s);
void oracle_meter_destroy(oracle_meter *meter); /* null is fine */

/* Scores one state, of the scene's bodies in their order. False, and *score is all zero, if memory
 * runs out. Pairs that cannot collide do not count: two shapes of one body, two bodies of which
 * none is dynamic, sensors, and what filters and joints keep apart. */
bool oracle_measure(oracle_meter *meter, const engine_body *bodies, oracle_score *score);

/* How far one state is from another, over the dynamic bodies of the scene. A body that is lost in
 * either makes all of them infinite. */
typedef struct oracle_deviation {
    double position_max, position_rms; /* m, of the centre of mass */
    double angle_max;                  /* rad, in [0, pi] */
    double velocity_max;               /* m/s */
} oracle_deviation;

oracle_deviation oracle_compare(const scene *s, const engine_body *expected,
                                const engine_body *actual);

/* ---- the reference simulation ---- */

typedef struct oracle_settings {
    double step;                  /* s, the longest; default 1/1920. Events cut it shorter */
    double restitution_threshold; /* m/s; a slower approach does not bounce; default 0.01. Engines
                                     have 1 by default */
} oracle_settings;

oracle_settings oracle_default_settings(void);

/* How hard a run was, and how well it went; all since its creation. */
typedef struct oracle_report {
    double time;         /* s, simulated */
    long steps;          /* solved, events included */
    long impacts;        /* moments at which something hit something */
    double residual_max; /* m/s, the worst breach of the contact laws after a solve */
    long hard_solves;    /* that needed more than the active set alone */
} oracle_report;

/* The force at a contact point, averaged over the last step. */
typedef struct oracle_force {
    int body_a, body_b;        /* in the scene's order */
    double x, y;               /* the point, m */
    double normal_x, normal_y; /* from a to b */
    double normal, tangent;    /* N, on b, along the normal and (normal_y, -normal_x) */
} oracle_force;

typedef struct oracle oracle;

/* Null if memory runs out, the scene failed, or a setting is not finite and positive (the threshold
 * may be 0); null settings are the defaults. Bodies that overlap at the start are pushed apart
 * first, without a speed. The scene must outlive it. */
oracle *oracle_create(const scene *s, const oracle_settings *settings);
void oracle_destroy(oracle *o); /* null is fine */

/* Goes on for so many seconds. False, and nothing done, if they are negative or not finite; false
 * as well if memory runs out, somewhere on the way. */
bool oracle_advance(oracle *o, double seconds);

/* The present state, in the scene's order, for oracle_measure and oracle_compare. */
void oracle_read(const oracle *o, engine_body *bodies);
oracle_report oracle_get_report(const oracle *o);
/* The forces at all points that bear any. Belongs to the oracle, valid until its next call; null,
 * and *count 0, if memory runs out. */
const oracle_force *oracle_forces(oracle *o, int *count);

/* The whole in one call: the states at `count` increasing times (s, >= 0) go one after the other
 * to `samples`, which has room for count times body_count of them. `report` may be null. False for
 * the same reasons as oracle_create and oracle_advance. */
bool oracle_run(const scene *s, const oracle_settings *settings, const double *times, int count,
                engine_body *samples, oracle_report *report);

#endif
