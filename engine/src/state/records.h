/* records.h: the records of a world's state: one for each body, shape, terrain, constraint, joint
 * and so on. They are plain data, and refer to each other by index, so that a snapshot copies them.
 */
#ifndef TD_RECORDS_H
#define TD_RECORDS_H

#include "base/fixed.h"
#include "base/memory.h"
#include "base/indices.h"
#include "thud/thud.h"

enum {
    TD_COLOURS = 64, /* colours of the constraint graph; the last is overflow: one lane a block */
    TD_OVERFLOW = TD_COLOURS - 1,
    TD_KINEMATIC_COLOUR =
        48, /* the first colour of constraints of kinematic bodies. Chosen: other constraints use a
               colour that high only where a body has as many constraints as that */
    TD_BINS_A_KIND =
        2 * TD_COLOURS + 1, /* one bin a colour for constraints of two moving bodies, one a colour
                               for those with a static body, and one for those of sleeping bodies */
    TD_SLEEPING = 2 * TD_COLOURS /* the bin of sleeping lanes */
};

/* A place is a range of so many awake slots. The first colours of two moving bodies, which hold
 * nearly all lanes of a large world, have a bin for each place (constraint/lanes.h). Chosen: with
 * larger places workers share more cache lines, with smaller places and with more colours more
 * blocks have empty lanes. */
enum { TD_PLACE_SLOTS = 1024, TD_PLACED_COLOURS = 8, TD_PLACES_MAX = 8192 }; /* powers of two */

typedef struct td_pose {
    td_position center; /* centre of mass */
    uint32_t angle;     /* 2^32 is a full turn, so that it wraps around by itself */
    float c, s;         /* cosine and sine of the angle */
    int32_t padding;
} td_pose;

/* td_body.flags */
enum {
    TD_BODY_LIVE = 1,
    TD_BODY_FIXED = 2,    /* rotation is fixed by its def */
    TD_BODY_RESTLESS = 4, /* may not sleep */
    TD_BODY_QUARANTINED = 8,
    TD_BODY_DISABLED = 16,      /* has no contacts and no awake slot */
    TD_BODY_OWN_DETECTION = 32, /* has a detection of its own, not the world's */
    TD_BODY_MASS_GIVEN = 64,    /* mass, inertia and centre of mass are the caller's; shapes do not
                                   change them */
    TD_BODY_ANCHOR = 128        /* static, without shapes, made by the engine to lock a body:
                                   edits/locks.c */
};

typedef struct td_body {
    int32_t next_free; /* must be the first member: td_slots */
    uint32_t generation;
    uint8_t kind, flags, changes, aabbs; /* aabbs: 1 while the body has an AABB, which fixes its
                                            rotation; else 0 */
    td_awake_slot awake;                 /* TD_NONE: static, asleep, or waits for the next step */
    int32_t first_shape, shape_count;
    int32_t first_constraint; /* first edge of the list (td_edge_of) */
    float velocity[3];        /* while the body has no awake slot: x, y, turn */
    float force[3];           /* forces that act in the next step: x, y, torque */
    float mass, inertia, inv_mass, inv_inertia;
    float center_x, center_y;     /* centre of mass, in the body's frame */
    float min_extent, max_extent; /* half thickness of the thinnest shape; greatest distance of a
                                     shape's point from the centre of mass */
    float gravity_scale, linear_damping, angular_damping;
    uint32_t rest_epoch;  /* thud_world.rest_epoch when the body fell asleep */
    uint8_t direct_steps; /* while the body has no awake slot: see awake_arrays.h */
    uint8_t unused;       /* 0, in place of padding: snapshots copy all bytes */
    uint16_t passes;      /* a hash of the bodies that joints let it pass through: td_passing_bit */
    const thud_detection *detection;
    uint64_t user_data;
} td_body;

/* td_shape.flags */
enum {
    TD_SHAPE_LIVE = 1,
    TD_SHAPE_SENSOR = 2, /* 4 is TD_SHAPE_UNSEEN of internal_edges.h */
    /* Made inside a callback: has no contacts and no mass before the next step. */
    TD_SHAPE_WAITS = 8,
    TD_SHAPE_SILENT = 16,                              /* makes no events */
    TD_SHAPE_HOLLOW = TD_SHAPE_SENSOR | TD_SHAPE_WAITS /* with either flag it stops no body */
};

/* thud_world.marks */
enum {
    TD_MARK_MOVED = 1,  /* the shape is in thud_world.moved; thud_world.previous_fat has the fat
                           bounds that it had before */
    TD_MARK_FRESH = 2,  /* new, has no contacts yet; previous_fat is not set */
    TD_MARK_WOKEN = 4,  /* contacts of the shape may be missing: the broadphase searches the contact
                           lists for each of its pairs */
    TD_MARK_CROWDED = 8 /* with TD_MARK_WOKEN: the world was crowded (broadphase.c) */
};

typedef struct td_shape {
    int32_t next_free;
    uint32_t generation;
    uint8_t kind, flags;
    uint8_t centred; /* 0: the shape's centre is not the body's centre of mass, or it is a line of
                        ground; 1: it is that centre; 2: it is, and its angle in the body's frame
                        is 0 */
    uint8_t internal_edges; /* faces and corners that have a neighbour at them: internal_edges.h */
    uint8_t hidden; /* faces and corners that one neighbour covers wholly: internal_edges.h */
    td_body_index body;
    int32_t next;           /* next shape of the same body */
    int32_t terrain;        /* index, or TD_NONE */
    float x, y;             /* centre in the body's frame */
    float arm_x, arm_y;     /* centre from the body's centre of mass, in the body's frame */
    uint32_t angle;         /* in the body's frame; 2^32 is a full turn */
    float angle_c, angle_s; /* its cosine and sine */
    float half_x, half_y;
    float density, friction, restitution, surface_speed;
    thud_filter filter;
    uint64_t user_data;
} td_shape;

typedef struct td_terrain_record {
    int32_t next_free;
    int32_t shape; /* TD_NONE when free */
    thud_terrain_kind kind;
    int32_t unused; /* 0, in place of padding: snapshots copy all bytes */
    double slope, x0, spacing;
    double highest; /* upper bound of the heights from the origin (an edit that lowers the line does
                       not lower it); infinite for an inclined flat line */
    td_array points; /* thud_pos */
} td_terrain_record;

/* td_constraint.state */
enum {
    TD_WAITING =
        0, /* does not act (shapes do not touch): slot is an index in its kind's waiting list */
    TD_TOUCHING, /* acts: slot is block * 8 + lane */
    TD_RESTING   /* does not act, and neither body is awake: in no list */
};

/* td_constraint.vetoed, of a contact. */
enum {
    TD_VETOED = 1,  /* does nothing in this step */
    TD_PASSING = 2, /* a one-way rule lets the shapes pass until they part, or are found apart on
                       the solid side (one_way.c); TD_VETOED is set, too */
    TD_HELD = 4     /* a one-way rule has found the shapes on the solid side: the contact acts until
                       the two part */
};

/* A constraint: an edge in the graph of bodies (constraint.h). */
typedef struct td_constraint {
    int32_t next_free;
    int32_t shape_a, shape_b; /* of a contact; else TD_NONE */
    td_body_index body[2];    /* of a contact those of shape_a and shape_b */
    union {
        int32_t child; /* of a contact: terrain segment; TD_NONE: an edit has removed it, and the
                          contact ends in the next step */
        int32_t joint; /* of a joint's part: index of the td_joint */
    };
    int32_t slot;             /* its meaning depends on `state`: TD_WAITING, TD_TOUCHING */
    int32_t next[2], prev[2]; /* edges of the lists of body[0] and body[1] */
    uint16_t bin;
    uint8_t kind, state;
    uint8_t open;   /* the contact has begun and not ended: TD_OPEN, TD_TOLD */
    uint8_t listed; /* scratch flag while a list of constraints is made */
    uint8_t live;   /* the record is in use */
    uint8_t vetoed; /* TD_VETOED, TD_PASSING, TD_HELD: set by a prologue or a rule */
} td_constraint;

/* An edge: a constraint in the list of one of its bodies, a number. Side 0 is body[0]. */
static inline int td_edge_of(int constraint, int side) {
    return constraint * 2 + side;
}

static inline int td_edge_constraint(int edge) {
    return edge / 2;
}

static inline int td_edge_side(int edge) {
    return edge & 1;
}

/* td_constraint.open of a contact. The contacts of a shape with several segments of a terrain have
 * the same value. */
enum {
    TD_OPEN = 1,
    TD_TOLD =
        2 /* its begin event was added (where the world has such events): its end event will be */
};

/* A constraint whose kind is a pair kind. */
typedef td_constraint td_contact;

/* The parts of a joint, each a constraint: one for the limits, springs and motors of each
 * direction, and one for all directions that are locked. */
enum { TD_JOINT_DIRECTIONS = 3, TD_JOINT_LOCK = TD_JOINT_DIRECTIONS, TD_JOINT_PARTS };

/* thud_drive (limits, spring and motor of a direction), without padding. */
typedef struct td_drive {
    uint32_t limited;
    float lower, upper, frequency, damping, target, spring_force, motor_speed, motor_force;
} td_drive;

/* A gear couples the coordinates q of two joints: q0 + ratio q1 - rest = 0. A coordinate is the
 * rotation or translation of the joint's second body against its first; rotations are counted
 * beyond a full turn. */
typedef struct td_gear {
    int32_t joint[2];
    uint32_t generation[2]; /* generations of both joints when the gear was made */
    uint32_t last[2];       /* angles in the last step, to count full turns by */
    float ratio;
    int32_t apart;     /* 1: the gear does nothing, since it, one of the joints or of its bodies is
                          or was disabled; as it acts again it takes a new `rest` */
    int64_t turned[2]; /* rotations counted, 2^32 is a full turn */
    double rest;
} td_gear;

/* Without padding between the fields: snapshots copy all bytes. */
typedef struct td_joint {
    int32_t next_free;
    uint32_t generation;
    td_body_index body[2];        /* in the order of its constraints: a static one first */
    int32_t part[TD_JOINT_PARTS]; /* constraints; TD_NONE: no such part. There is at least one. */
    uint8_t kind;                 /* thud_joint_kind */
    uint8_t live, disabled, collides;
    uint8_t swapped;        /* body[0] is the caller's b */
    uint8_t only_reports;   /* a force beyond break_force makes an event, and does not break it */
    uint8_t locked, driven; /* bits of directions: locked; with limits, springs or motors */
    float anchor[2][2];     /* on each body, from its origin and in its frame */
    float axis_c, axis_s;   /* direction `along`, in the frame of body[0] */
    uint32_t angle[2];      /* of the joint's frames in the bodies' frames */
    uint32_t turn;          /* relative angle of the bodies at which the coordinate `turn` is 0 */
    float length;
    union {
        struct {
            td_drive drive[TD_JOINT_DIRECTIONS];
            uint32_t unused_too;
        };
        td_gear gear;
    };
    float break_force, break_torque;
    uint64_t user_data;
} td_joint;

typedef struct td_bin {
    int32_t head, tail, lanes;
} td_bin;

typedef struct td_colours {
    /* Colours that this body's constraints with moving and with static bodies have, a bit each. */
    uint64_t with_moving, with_static;
} td_colours;

/* Events in the order in which they happened: thud_events. It consists of arrays and nothing else.
 */
typedef struct td_event_lists {
    td_array begin, end, sensor_begin, sensor_end; /* thud_contact_event */
    td_array sensor_begin_time, sensor_end_time;   /* float: the time in [0, 1] of the step of each
                                                      sensor event */
    td_array hit;                                  /* thud_hit_event */
    td_array quarantined;                          /* thud_body_id */
} td_event_lists;
enum { TD_EVENT_LIST_COUNT = sizeof(td_event_lists) / sizeof(td_array) };

/* The events of several steps of one thud_world_advance. */
typedef struct td_gathered {
    td_event_lists lists;
    td_array broken;   /* thud_joint_event */
    td_array impulses; /* thud_impulse_event */
} td_gathered;

/* Forces on a body for the steps that thud_world_advance will make: x, y, torque. */
typedef struct td_force_record {
    uint32_t generation; /* of the body; the forces are 0 for a body of another generation */
    float mean[3];       /* mean force over the time that has not been stepped yet */
    float now[3];        /* force over the time of the present call */
    float due[3];        /* force over the whole next step, and not longer */
} td_force_record;

typedef enum td_change_kind {
    TD_CHANGE_ENTER = 1,  /* created: takes its awake slot and enters the broadphase */
    TD_CHANGE_LEAVE = 2,  /* destroyed */
    TD_CHANGE_SHAPES = 4, /* shapes were added or removed */
    TD_CHANGE_WAKE = 8,
    TD_CHANGE_PLACE = 16, /* teleported */
    TD_CHANGE_SLEEP = 32,
    TD_CHANGE_ENABLE = 64 /* enabled or disabled */
} td_change_kind;

/* td_deferred_edit.what, and its four values. */
typedef enum td_deferred_kind {
    TD_PUT_TRANSFORM, /* x, y, angle */
    TD_PUT_VELOCITY,  /* x, y, angular */
    TD_PUT_IMPULSE,   /* x, y; x, y of the point */
    TD_PUT_FORCE,     /* x, y, torque */
    TD_PUT_AWAKE,     /* not 0: wakes; 0: sleeps */
    TD_PUT_ENABLED,   /* not 0: enabled */
    TD_PUT_SHAPE /* index of a shape made in a callback: from now on it has mass and contacts */
} td_deferred_kind;

/* An edit made inside a callback, which takes effect at the start of the next step. */
typedef struct td_deferred_edit {
    td_body_index body;
    uint32_t generation;
    int32_t what; /* td_deferred_kind */
    double value[4];
} td_deferred_edit;

/* The error statistics of a step: thud_step_error. */
typedef struct td_errors {
    int64_t points, overlaps;
    double depth;            /* sum of penetration depths, in whole position quanta */
    float deepest, residual; /* greatest depth, length; greatest approach speed left, length/s */
    double energy_change, energy_decided;
    float
        shortfall_squared; /* of the longest piece of a motion that detection has cut off, length^2
                            */
    int64_t projected;     /* 1: gaps.c changed motions after points were counted, which are counted
                              anew by td_errors_of_step; else 0 */
} td_errors;

enum { TD_BUDGET_STEPS = 9 }; /* steps between two decisions of solver/budget.c. Chosen. */

/* Times of the last steps, s, and an estimate of them with twice the substeps. */
typedef struct td_budget {
    double taken[TD_BUDGET_STEPS], doubled[TD_BUDGET_STEPS];
    int count;
} td_budget;

#endif
