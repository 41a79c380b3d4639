/* trajectory.h: bodies on their way through a step, and the pairs that may meet on it. */
#ifndef TD_TRAJECTORY_H
#define TD_TRAJECTORY_H

#include "detection/detection.h"
#include "solver/motion.h"
#include "state/world.h"

/* Shapes that touch may be pressed into each other by load, by so many TD_MEET in a step, before it
 * is a collision: that much is left to the contact solver. */
#define TD_PRESSED 0.15

/* The way of an awake body from `since` to the end of the step: at constant speed, or falling. */
typedef struct td_trajectory {
    td_position place; /* of the centre of mass, at `since` */
    uint32_t angle;
    td_body_index body;
    int32_t extras; /* edge of its first extra candidate: extra * 2 + side, or TD_NONE */
    int32_t impacts;
    double since;     /* in [0, 1] of the step */
    double motion[3]; /* in a whole step at the speed of `since`: x, y, angle */
    double fall[2];   /* by how much gravity changes that in a step; 0 where something bears it */
    bool free;        /* nothing but gravity acted on it: it moves as its velocity says */
    bool yielded;     /* its motion gave way to a body that kept its own */
    int32_t touching; /* contacts that it began the step with */
    bool borne;       /* contacts pushed it in the step before */
    bool changed;     /* its way is no more the one that finalize.c took */
    bool held;        /* stays where it is for the rest of the step ... */
    bool all_held;    /* ... and so do all that joints tie to it */
    int32_t strays;   /* first of its shapes in scratch.strays, or TD_NONE */
} td_trajectory;

/* Of ways that are too long for td_bounds, which wrap around: bounds quanta, whole numbers. */
typedef struct td_far_bounds {
    double min_x, min_y, max_x, max_y;
} td_far_bounds;

/* A piece of the way of a body that turns off at its end, or stops there. */
typedef struct td_leg {
    td_trajectory way;
    double end;
    int32_t next; /* of the same body, or TD_NONE */
} td_leg;

/* A shape that may leave the bounds that it had at the start of the step. */
typedef struct td_stray {
    td_far_bounds start, ahead; /* those bounds, and what contains the rest of its way */
    int32_t shape, next;        /* of the same body */
    bool chose;                 /* its body's own detection looks for what it meets */
} td_stray;

/* Two shapes that may meet; a terrain comes first. Numbers below w->constraints.count are
 * contacts', the others extra ones': of terrain, and of bodies that strayed from where they were
 * expected. */
typedef struct td_toi_candidate {
    int32_t shape[2];
    td_body_index body[2];
    int32_t next[2]; /* extra: edges of the same bodies */
    bool vetoed;
} td_toi_candidate;

/* Of motion in a step, x, y and angle, what places and angles can follow: a length as far as a
 * world reaches, so that what is in it leaves the range of 64 bits in no step, and turns likewise.
 * What spins, or pulls with no measure, may drive others at any speed. Not-a-number stays what it
 * is. */
#define TD_MOTION_TURN_MOST 1e9

static inline double td_motion_held(const thud_world *w, int axis, double motion) {
    double most = axis < 2 ? THUD_PLACE_MAX * (double)w->unit : TD_MOTION_TURN_MOST;
    return td_clamp(motion, -most, most);
}

/* What is taken back of the velocity that gravity and forces give in a step: no more than it can
 * have been, since substeps hold a velocity to the greatest. */
static inline double td_gain_held(const thud_world *w, int axis, double gain) {
    double most = axis < 2 ? (double)(w->def.maximum_speed * w->unit) : (double)THUD_SPIN_MAX;
    return td_clamp(gain, -2.0 * most, 2.0 * most);
}

/* The trajectory of an awake body, by its slot. */
static inline td_trajectory *td_trajectory_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(td_trajectory, &w->scratch.trajectories, slot.at);
}

/* The detection that finds out when the two meet. */
const thud_detection *td_detection_of(const thud_world *w, td_body_index body_a,
                                      td_body_index body_b);

/* The trajectory of any body; those at rest stay where they are. */
td_trajectory td_trajectory_of(const thud_world *w, td_body_index body);
/* For sensors, where there are any: it keeps its way until then. Forgotten where memory is short.
 */
void td_leg_note(thud_world *w, const td_trajectory *way, double end);

bool td_held_reserve(thud_world *w);
/* Counts a body that is held at a part, in [0, 1], of the motion that is left to it: once a step,
 * and the time that it loses, however often it is held. */
void td_held_count(thud_world *w, td_awake_slot slot, double time);

/* Brings it to `time`, which is no earlier than `since`. */
void td_trajectory_advance(thud_world *w, td_trajectory *trajectory, double time);
/* How far it has come at `time` from where it was at the start of the step: x, y, angle. */
void td_trajectory_gone(const thud_world *w, const td_trajectory *trajectory, double time,
                        double gone[3]);
/* From `since` on something bears this part of the fall; the velocity at the end lacks it as well.
 */
void td_trajectory_bear(const thud_world *w, td_trajectory *trajectory, double x, double y);
/* One of the body's shapes at `time`, relative to `origin`. */
thud_shape_instance td_trajectory_shape(const thud_world *w, const td_trajectory *trajectory,
                                        int shape, double time, td_position origin);

/* How far a parabola may be from its chord, of one body as the other sees it. */
double td_trajectories_bend(const td_trajectory *a, const td_trajectory *b, double rest);

td_toi_candidate *td_extra_at(const thud_world *w, int number);
td_toi_candidate td_toi_candidate_at(const thud_world *w, int number);

/* Whether the bodies, wherever on them the shapes are, are too far apart at the start of the step
 * to meet in it. */
bool td_toi_candidate_is_far(thud_world *w, const td_toi_candidate *e);

/* How the two fly from `now` until a later time; false where they surely do not meet. */
bool td_toi_candidate_approach(thud_world *w, const td_toi_candidate *e, double now, double until,
                               td_approach *approach);

/* Their ways alone: places at `now`, and motions from then on. */
void td_toi_candidate_ways(const thud_world *w, const td_toi_candidate *e, double now, double until,
                           td_approach *approach);
/* One of them may be hidden from the other: see internal_edges.h. */
bool td_toi_candidate_has_seams(const thud_world *w, const td_toi_candidate *e);

/* The sealed end of a line is no edge: whether a shape is met there beside the ground's own normal.
 * Then *x is where the line ends, and *out the direction that leads out of it, 1 or -1. */
bool td_at_sealed_end(const thud_world *w, int line, const thud_terrain *ground,
                      const thud_shape_instance *shape, const thud_closest *met, double *x,
                      double *out);

/* Where two shapes are nearest to each other, relative to `origin`. */
typedef struct td_features {
    td_position origin;
    thud_contacts contacts;
} td_features;

void td_toi_candidate_features(thud_world *w, const td_toi_candidate *e, double time,
                               td_features *features);

#endif
