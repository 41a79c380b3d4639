/* trajectory.h: the paths of bodies through a step, and the pairs of shapes that may meet on them,
 * for continuous collision detection (impacts.c, sensing.c).
 *
 * Time is a share, in [0, 1], of the step. With t from td_trajectory.since to 1 and s = t - since,
 * a body's centre and angle are
 *   p(t) = place + motion s + acceleration s^2 / 2
 *   angle(t) = angle + motion[2] s
 * `motion` is a velocity times the time step (lengths, radians), `acceleration` an acceleration
 * times the square of the time step (lengths); it is zero unless the body is in free flight
 * (ballistics.c). */
#ifndef TD_TRAJECTORY_H
#define TD_TRAJECTORY_H

#include "detection/detection.h"
#include "solver/motion.h"
#include "state/world.h"

/* In multiples of TD_IMPACT_DISTANCE: how much nearer to each other touching shapes may come in a
 * step before it is a collision. The soft solver lets a load press shapes together; a closing of up
 * to this much is left to it. Chosen: at half and twice of it the times of impact in the scene
 * smash change by 3 %. thud_detection.h promises at most 0.00035 length scales a step from all
 * causes (tests/guarantees/passing.c). */
#define TD_LOAD_CLOSING_MAX 0.15

/* The path of an awake body from `since` to the end of the step. */
typedef struct td_trajectory {
    td_position place; /* of the centre of mass, at `since` */
    uint32_t angle;    /* at `since`; 2^32 is a full turn */
    td_body_index body;
    int32_t extras;         /* first of the body's extra candidates, as an edge: td_edge_of, or
                               TD_NONE */
    int32_t impacts;        /* of the body in this step so far */
    double since;           /* in [0, 1] of the step */
    double motion[3];       /* x, y (lengths), angle (radians) a step, at `since` */
    double before[3];       /* velocity at the start of the step: x, y (length/s), angle (rad/s) */
    double acceleration[2]; /* change of `motion` by gravity and forces in a whole step, lengths; 0
                               unless in free flight */
    bool free;      /* only gravity and forces acted on the body: its motion follows its velocity */
    bool deflected; /* an impact of this step has changed this body's motion alone, and left that of
                       the other body (choose_kept_motion, collide.c) */
    int32_t contact_count; /* touching contacts of the body at the start of the step */
    bool borne;            /* contacts carry the body: solver/bounces.c */
    bool changed;          /* its path differs from the one that td_finalize took */
    bool held;             /* it stays at its place until the end of the step */
    bool ring_held;        /* all bodies that joints tie to it are held as well
                              (constraint/tied_bodies.h) */
    int32_t escaped;       /* first of its shapes in scratch.escaped, or TD_NONE */
} td_trajectory;

/* Bounds of paths that may be too long for td_bounds, whose 32-bit numbers wrap around. In bounds
 * quanta (base/fixed.h), whole numbers that do not wrap. */
typedef struct td_far_bounds {
    double min_x, min_y, max_x, max_y;
} td_far_bounds;

/* A piece of the path of a body, from trajectory.since to `end`, where it changes direction or
 * stops. */
typedef struct td_leg {
    td_trajectory trajectory;
    double end;   /* time, in [0, 1] of the step */
    int32_t next; /* next leg of the same body in scratch.legs, or TD_NONE */
} td_leg;

/* An escaped shape: it may leave the fat bounds by which the broadphase paired it at the start of
 * the step. */
typedef struct td_escaped_shape {
    td_far_bounds start; /* those fat bounds */
    td_far_bounds ahead; /* of the rest of its path */
    int32_t shape, next; /* `next`: the next one of the same body, or TD_NONE */
    bool detects;        /* its body's own detection finds times of impact */
} td_escaped_shape;

/* A time-of-impact candidate: two shapes that may meet in the step; a terrain is shape[0].
 * Candidates have numbers. One below w->constraints.count is that of a contact. From there on they
 * are extra candidates, in scratch.extra_candidates: a shape and a terrain, or a pair with an
 * escaped shape, which has no contact. */
typedef struct td_toi_candidate {
    int32_t shape[2];
    td_body_index body[2];
    int32_t next[2]; /* of extra candidates: next edge (candidate * 2 + side) of each body, or
                        TD_NONE */
    bool vetoed;     /* the prologue refused the pair in this step */
} td_toi_candidate;

/* The index in scratch.extra_candidates of the extra candidate that an edge belongs to; edges are
 * numbered candidate * 2 + side. */
static inline int td_edge_candidate(int edge) {
    return edge / 2;
}

/* Upper bound of the rotation of a body in one step, radians. Motors and springs without a maximum
 * force could give any speed; this bound, and that of the motion of the centre, THUD_PLACE_MAX
 * length scales, keep positions in the range of 64 bits and angles in that of td_round64. Clamping
 * leaves not-a-number as it is. */
#define TD_MOTION_TURN_MAX 1e9

/* A motion in a step, clamped to its bounds: x and y (axes 0, 1) in lengths, the angle (axis 2) in
 * radians. (It has nothing to do with td_trajectory.held.) */
static inline double td_motion_held(const thud_world *w, int axis, double motion) {
    double max = axis < 2 ? THUD_PLACE_MAX * (double)w->length_scale : TD_MOTION_TURN_MAX;
    return td_clamp(motion, -max, max);
}

/* The bound to which a step clamps the velocity along an axis: length/s, of the spin (axis 2)
 * rad/s. */
static inline double td_speed_max(const thud_world *w, int axis) {
    return axis < 2 ? (double)(w->def.maximum_speed * w->length_scale)
                    : (double)THUD_ANGULAR_SPEED_MAX;
}

/* Clamps a velocity that gravity and forces gave within a step and that is removed again. Substeps
 * clamp velocities to the maximum speed, so that a gain is at most twice that: from the one bound
 * to the other. */
static inline double td_gain_clamped(const thud_world *w, int axis, double gain) {
    double max = td_speed_max(w, axis);
    return td_clamp(gain, -2.0 * max, 2.0 * max);
}

/* The velocity of a body that is held at its place without what gravity and forces gave it in the
 * rest of the step. The velocity may be at its bound already because an impulse acted against that
 * gain, so that the result is clamped again. */
static inline float td_velocity_without_gain(const thud_world *w, int axis, float velocity,
                                             double gain) {
    double max = td_speed_max(w, axis);
    return (float)td_clamp((double)(velocity - (float)td_gain_clamped(w, axis, gain)), -max, max);
}

/* The trajectory of an awake body, by its slot, for changes. */
static inline td_trajectory *td_trajectory_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(td_trajectory, &w->scratch.trajectories, slot.at);
}

/* The awake slot of a body, or 0, that of a body at rest, where it is static or sleeps. */
static inline td_awake_slot td_moving_slot(const thud_world *w, td_body_index body) {
    td_awake_slot slot = td_body_at(w, body)->awake;
    return slot.at > 0 ? slot : (td_awake_slot){0};
}

/* The detection that decides on a pair: of two dynamic bodies that of the higher rank, else that
 * of the dynamic one. */
const thud_detection *td_detection_of(const thud_world *w, td_body_index body_a,
                                      td_body_index body_b);

/* Sets a trajectory to the motion of the step that the solver gave the body, from the start of the
 * step. `moved`: the pose is that of the end already. The fields `before`, `acceleration`, `free`
 * and `contact_count` keep their values. */
void td_trajectory_begin(thud_world *w, td_awake_slot slot, bool moved);
/* A copy of the trajectory of any body. A body that is not awake has a trajectory without motion.
 */
td_trajectory td_trajectory_of(const thud_world *w, td_body_index body);
/* Appends a piece of a path, from trajectory.since to `end` (both shares of the step), to
 * scratch.legs, if the world has sensors. If memory is short, the piece is lost, and sensors take
 * the path as straight. */
void td_leg_note(thud_world *w, const td_trajectory *trajectory, double end);

/* The pose of an awake body at the start of the step, from that at the end and the motion. */
td_pose td_start_pose(const thud_world *w, td_awake_slot slot);

/* Reserves memory for td_held_count; false: out of memory. */
bool td_held_reserve(thud_world *w);
/* Counts a body that stops at the share `time`, in [0, 1], of the motion that is left to it, in
 * thud_stats: held_bodies once a step, however often it stops, and held_seconds by the time that
 * it loses. */
void td_held_count(thud_world *w, td_awake_slot slot, double time);

/* Moves the start of the trajectory to `time`, not earlier than `since`. */
void td_trajectory_advance(thud_world *w, td_trajectory *trajectory, double time);
/* The displacement at `time` from the pose at the start of the step: x, y (lengths), angle
 * (radians). */
void td_trajectory_displacement(const thud_world *w, const td_trajectory *trajectory, double time,
                                double displacement[3]);
/* Reduces `acceleration` by (x, y) from `since` on, since a contact carries that part of gravity.
 * The body's velocity at the end of the step is reduced by as much. */
void td_trajectory_reduce_acceleration(const thud_world *w, td_trajectory *trajectory, double x,
                                       double y);
/* One of the body's shapes at `time`, relative to `origin`. */
thud_geometry td_trajectory_shape(const thud_world *w, const td_trajectory *trajectory, int shape,
                                  double time, td_position origin);

/* The largest distance of the relative path of two bodies from its chord in a `duration` (share of
 * the step): |acceleration_b - acceleration_a| duration^2 / 8, the sagitta of a parabola. */
double td_trajectories_chord_error(const td_trajectory *a, const td_trajectory *b, double duration);

/* The extra candidate of a number >= w->constraints.count, for changes; and a copy of any
 * candidate. */
td_toi_candidate *td_extra_candidate_at(const thud_world *w, int number);
td_toi_candidate td_toi_candidate_at(const thud_world *w, int number);

/* Whether the two bodies, as circles of their max_extent, are too far apart at the start of the
 * step to meet in it. Never true where the first body is static, whose extent is not known. */
bool td_toi_candidate_is_far(thud_world *w, const td_toi_candidate *e);

/* Describes the pair from time `now` to `until` for a test of time of impact; false where bounds
 * show that the two do not meet. Counts the tests in thud_stats.motion_pairs, motion_circles,
 * motion_boxes. */
bool td_toi_candidate_approach(thud_world *w, const td_toi_candidate *e, double now, double until,
                               td_approach *approach);

/* Sets only the shapes of the approach at `now`, and their motions until `until`. */
void td_toi_candidate_motions(const thud_world *w, const td_toi_candidate *e, double now,
                              double until, td_approach *approach);
/* Whether one of the shapes has internal edges, so that contacts may be ghosts: see
 * contact/internal_edges.h. */
bool td_toi_candidate_has_internal_edges(const thud_world *w, const td_toi_candidate *e);

/* Whether a shape meets a line of terrain at an end that a neighbour covers (a sealed end), along
 * a normal that is not that of the end segment: this contact is a ghost. Then *x is the x
 * coordinate of the end, and *out the direction out of the line, 1 or -1. `met` is the closest
 * point of both. */
bool td_is_at_sealed_end(const thud_world *w, int line, const thud_terrain *ground,
                         const thud_geometry *shape, const thud_closest *met, double *x,
                         double *out);

/* The contact points of two shapes at one time, relative to `origin`. */
typedef struct td_features {
    td_position origin;
    thud_contacts contacts;
} td_features;

/* The contact points of a candidate at `time` that are nearer than TD_SPECULATIVE, without ghosts.
 */
void td_toi_candidate_features(thud_world *w, const td_toi_candidate *e, double time,
                               td_features *features);

#endif
