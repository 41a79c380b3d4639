/* records.h: what the state of a world is made of: one record a body, shape, terrain, contact and
 * so on, as plain data that name each other by index. */
#ifndef TD_RECORDS_H
#define TD_RECORDS_H

#include "base/fixed.h"
#include "base/memory.h"
#include "base/indices.h"
#include "thud/thud.h"

enum {
    TD_COLOURS = 64, /* the last one is overflow: one lane a block */
    TD_OVERFLOW = TD_COLOURS - 1,
    TD_BINS_A_KIND = 2 * TD_COLOURS + 1, /* moving by colour, static by colour, asleep */
    TD_SLEEPING = 2 * TD_COLOURS
};

typedef struct td_pose {
    td_position center; /* of mass */
    uint32_t angle;     /* 2^32 a turn: wraps by itself, needs no renormalising */
    float c, s;         /* of the angle */
    int32_t padding;
} td_pose;

/* td_body.flags */
enum {
    TD_BODY_LIVE = 1,
    TD_BODY_FIXED = 2,    /* rotation is fixed by its def */
    TD_BODY_RESTLESS = 4, /* may not sleep */
    TD_BODY_QUARANTINED = 8,
    TD_BODY_DISABLED = 16,   /* has no contacts and no awake slot */
    TD_BODY_CHOSE = 32,      /* has a detection of its own choice, not the world's */
    TD_BODY_MASS_GIVEN = 64, /* mass, inertia and their centre are the caller's: no shape changes
                                them */
    TD_BODY_ANCHOR = 128     /* static and without shapes, to lock others: edits/locks.c */
};

typedef struct td_body {
    int32_t next_free; /* first: see td_slots */
    uint32_t generation;
    uint8_t kind, flags, changes, aabbs; /* aabbs: number of AABB shapes, which fix rotation */
    td_awake_slot awake;                 /* TD_NONE: static, asleep or not yet applied */
    int32_t first_shape, shape_count;
    int32_t first_constraint; /* edge: contact * 2 + side */
    float velocity[3];        /* while there is no awake slot */
    float force[3];           /* for the next step: x, y, torque */
    float mass, inertia, inv_mass, inv_inertia;
    float center_x, center_y; /* of mass, in the body's frame */
    float core, rim;          /* smallest half extent; farthest reach from the centre of mass */
    float gravity_scale, linear_damping, angular_damping;
    uint32_t rest_epoch;  /* world's, when it fell asleep */
    uint8_t direct_steps; /* while there is no awake slot: see awake_arrays.h */
    uint8_t unused;       /* 0: in place of padding */
    uint16_t passes;      /* bits of the bodies that it passes through, joined to them: joining.c */
    const thud_detection *detection;
    uint64_t user_data;
} td_body;

/* td_shape.flags */
enum {
    TD_SHAPE_LIVE = 1,
    TD_SHAPE_SENSOR = 2, /* 4: see internal_edges.h */
    /* Made inside a callback: nothing meets or weighs it before the next step. */
    TD_SHAPE_WAITS = 8,
    TD_SHAPE_SILENT = 16,                              /* makes no events */
    TD_SHAPE_HOLLOW = TD_SHAPE_SENSOR | TD_SHAPE_WAITS /* either: no body is stopped by it */
};

/* thud_world.marks */
enum {
    TD_MARK_MOVED = 1,  /* in the moved list; its bounds before are in `was` */
    TD_MARK_FRESH = 2,  /* has no pairs yet: `was` means nothing */
    TD_MARK_WOKEN = 4,  /* pairs may be missing; look each one up */
    TD_MARK_CROWDED = 8 /* likewise, in a world that stays crowded; see broadphase.c */
};

typedef struct td_shape {
    int32_t next_free;
    uint32_t generation;
    uint8_t kind, flags, plain; /* plain: centred on the body's centre of mass, angle 0 */
    uint8_t internal_edges; /* static: what another static shape stands at; see internal_edges.h */
    uint8_t hidden;         /* static: what another one hides altogether; see internal_edges.h */
    td_body_index body;
    int32_t next;       /* of the same body */
    int32_t terrain;    /* index, or TD_NONE */
    float x, y;         /* in the body's frame */
    float arm_x, arm_y; /* from the centre of mass, in the body's frame */
    uint32_t angle;
    float angle_c, angle_s;
    float half_x, half_y;
    float density, friction, restitution, surface_speed;
    thud_filter filter;
    uint64_t user_data;
} td_shape;

typedef struct td_terrain_record {
    int32_t next_free;
    int32_t shape; /* TD_NONE when free */
    thud_terrain_kind kind;
    int32_t unused; /* 0: in place of padding, which snapshots would take along unwritten */
    double slope, x0, spacing;
    double highest;  /* no point is higher, relative to the origin; infinite on a flat slope */
    td_array points; /* thud_pos */
} td_terrain_record;

/* td_constraint.state */
enum {
    TD_WAITING = 0, /* bounds overlap, shapes do not touch: index in its kind's waiting list */
    TD_TOUCHING,    /* it acts: slot is block * 8 + lane */
    TD_RESTING      /* waiting, but nobody is awake: in no list */
};

/* td_constraint.vetoed, of a contact. */
enum {
    TD_VETOED = 1,  /* does nothing in this step */
    TD_PASSING = 2, /* by a one-way rule, until the two part or it has come out; vetoed as well */
    TD_HELD = 4     /* by a one-way rule, until the two part */
};

/* An edge of the graph of constraints: constraint.h. */
typedef struct td_constraint {
    int32_t next_free;
    int32_t shape_a, shape_b; /* of a contact; else TD_NONE */
    td_body_index body[2];    /* of a contact those of shape_a and shape_b */
    union {
        int32_t child; /* of a contact: terrain segment; TD_NONE: gone by an edit, as the contact is
                          a step later */
        int32_t joint; /* of another kind: index of its td_joint */
    };
    int32_t slot;
    int32_t next[2], prev[2]; /* edges in the bodies' lists */
    uint16_t bin;
    uint8_t kind, state;
    uint8_t open;   /* touches, or overlaps a sensor: has begun and not ended; see below */
    uint8_t listed; /* while a list of contacts is being made */
    uint8_t live;
    uint8_t vetoed; /* by a prologue or a rule, see above */
} td_constraint;

/* td_constraint.open, of a contact; all segments of a line that a shape touches have the same. */
enum {
    TD_OPEN = 1,
    TD_TOLD = 2 /* its begin was told, as far as the world tells any, and its end will be */
};

/* A constraint whose kind is a pair kind. */
typedef td_constraint td_contact;

/* The parts of a joint, each a constraint: what drives it in either direction, and what it locks.
 */
enum { TD_JOINT_DIRECTIONS = 3, TD_JOINT_HOLD = TD_JOINT_DIRECTIONS, TD_JOINT_PARTS };

/* thud_drive, without padding. */
typedef struct td_drive {
    uint32_t limited;
    float lower, upper, frequency, damping, target, spring_force, motor_speed, motor_force;
} td_drive;

/* Two joints that turn or move each other, each by its second body, whose first one never moves by
 * itself: first value + ratio * second value - rest is 0. Turns are counted. */
typedef struct td_gear {
    int32_t joint[2];
    uint32_t generation[2]; /* of those joints, as they were */
    uint32_t last[2];       /* turns as they were last looked at */
    float ratio;
    int32_t apart; /* 1: a joint of it is disabled, and nothing holds */
    int64_t turned[2];
    double rest;
} td_gear;

/* Fields without padding between them, which snapshots would take along unwritten. */
typedef struct td_joint {
    int32_t next_free;
    uint32_t generation;
    td_body_index body[2];        /* as its parts have them: a static one first */
    int32_t part[TD_JOINT_PARTS]; /* TD_NONE: none; a joint has one at least */
    uint8_t kind;                 /* thud_joint_kind */
    uint8_t live, disabled, collides;
    uint8_t swapped; /* the first body is the caller's b */
    uint8_t only_reports;
    uint8_t locked, driven; /* bits of its directions */
    float anchor[2][2];     /* on either body, from its origin and in its frame */
    float axis_c, axis_s;   /* of `along`, in the first body's frame */
    uint32_t angle[2];      /* of the frames */
    uint32_t turn;          /* of the second body against the first where `turn` is 0 */
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
    uint64_t moving, fixed; /* taken by this body's contacts with moving and static bodies */
} td_colours;

/* What happened, in the order it did; see thud_events. Arrays and nothing else. */
typedef struct td_event_lists {
    td_array begin, end, sensor_begin, sensor_end; /* thud_contact_event */
    td_array hit;                                  /* thud_hit_event */
    td_array quarantined;                          /* thud_body_id */
} td_event_lists;
enum { TD_EVENT_LIST_COUNT = sizeof(td_event_lists) / sizeof(td_array) };

/* Everything that several steps told. */
typedef struct td_gathered {
    td_event_lists lists;
    td_array broken;   /* thud_joint_event */
    td_array impulses; /* thud_impulse_event */
} td_gathered;

/* Forces on a body for steps that thud_world_advance has yet to make: x, y, torque. */
typedef struct td_pull {
    uint32_t generation; /* of the body; all zero for another one */
    float mean[3];       /* over the time that waits to be stepped */
    float now[3];        /* over the time of the present call */
    float due[3];        /* through the next step alone, and all of it */
} td_pull;

typedef enum td_change_kind {
    TD_CHANGE_ENTER = 1,  /* created: takes its awake slot and enters the broadphase */
    TD_CHANGE_LEAVE = 2,  /* destroyed */
    TD_CHANGE_SHAPES = 4, /* shapes came or went */
    TD_CHANGE_WAKE = 8,
    TD_CHANGE_PLACE = 16, /* teleported */
    TD_CHANGE_SLEEP = 32,
    TD_CHANGE_ENABLE = 64 /* enabled or disabled */
} td_change_kind;

/* An edit made inside a callback, deferred to the start of the next step. */
typedef struct td_deferred_edit {
    td_body_index body;
    uint32_t generation;
    int32_t what; /* td_deferred_kind in body.h */
    double value[4];
} td_deferred_edit;

/* What a step has found of its errors; see thud_step_error. */
typedef struct td_errors {
    int64_t points, overlaps;
    double depth; /* sum of penetrations, whole position quanta */
    float deepest, residual;
    double energy_change;
    float shortfall; /* squared */
    int64_t moved;   /* motions were projected after points were counted: td_error_of_step */
} td_errors;

enum { TD_BUDGET_STEPS = 9 }; /* between two decisions */

/* What the last steps took, and would have with twice the substeps: seconds. */
typedef struct td_budget {
    double taken[TD_BUDGET_STEPS], doubled[TD_BUDGET_STEPS];
    int count;
} td_budget;

#endif
