/* world.h: the state of a world, as plain data in arrays that name each other by index.
 *
 * Hot and cold stand apart: what every substep touches is in the `awake` arrays, dense and 16 bytes
 * a record; what every step touches lies in per-body and per-shape records; definitions, links and
 * user data are elsewhere. */
#ifndef TD_WORLD_H
#define TD_WORLD_H

#include "base/event_queue.h"
#include "contact/pair_kinds.h"
#include "detection/detection.h"
#include "geometry/shape_kind.h"
#include "islands/direct_islands.h"
#include "base/memory.h"
#include "broadphase/proxy_set.h"
#include "solver/tally.h"

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
    TD_BODY_DISABLED = 16, /* has no contacts and no awake slot */
    TD_BODY_CHOSE = 32     /* its detection itself */
};

typedef struct td_body {
    int32_t next_free; /* first: see td_slots */
    uint32_t generation;
    uint8_t kind, flags, changes, aabbs; /* aabbs: number of AABB shapes, which fix rotation */
    int32_t awake;                       /* slot, or TD_NONE: static, asleep or not yet applied */
    int32_t first_shape, shape_count;
    int32_t first_contact; /* edge: contact * 2 + side */
    float velocity[3];     /* while there is no awake slot */
    float force[3];        /* for the next step: x, y, torque */
    float mass, inertia, inv_mass, inv_inertia;
    float center_x, center_y; /* of mass, in the body's frame */
    float core, rim;          /* smallest half extent; farthest reach from the centre of mass */
    float gravity_scale, linear_damping, angular_damping;
    uint32_t rest_epoch;  /* world's, when it fell asleep */
    uint8_t direct_steps; /* while there is no awake slot: see thud_world.hard */
    const thud_detection *detection;
    uint64_t user_data;
} td_body;

/* td_shape.flags */
enum {
    TD_SHAPE_LIVE = 1,
    TD_SHAPE_SENSOR = 2, /* 4: see internal_edges.h */
    TD_SHAPE_WAITS =
        8, /* made inside a callback: nothing meets or weighs it before the next step */
    TD_SHAPE_HOLLOW = TD_SHAPE_SENSOR | TD_SHAPE_WAITS /* either: no body is stopped by it */
};

/* thud_world.marks */
enum {
    TD_MARK_MOVED = 1, /* in the moved list; its bounds before are in `was` */
    TD_MARK_FRESH = 2, /* has no pairs yet: `was` means nothing */
    TD_MARK_WOKEN = 4  /* pairs may be missing; look each one up */
};

typedef struct td_shape {
    int32_t next_free;
    uint32_t generation;
    uint8_t kind, flags, plain; /* plain: centred on the body's centre of mass, angle 0 */
    uint8_t internal_edges; /* static: what another static shape stands at; see internal_edges.h */
    uint8_t hidden;         /* static: what another one hides altogether; likewise */
    int32_t body, next;     /* of the same body */
    int32_t terrain;        /* index, or TD_NONE */
    float x, y;             /* in the body's frame */
    float arm_x, arm_y;     /* from the centre of mass, in the body's frame */
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
    double slope, x0, spacing;
    double highest;  /* no point is higher, relative to the origin; infinite on a flat slope */
    td_array points; /* thud_pos */
} td_terrain_record;

/* td_contact.state */
enum {
    TD_WAITING = 0, /* bounds overlap, shapes do not touch: index in its kind's waiting list */
    TD_TOUCHING,    /* slot is block * 8 + lane */
    TD_RESTING      /* waiting, but nobody is awake: in no list */
};

typedef struct td_contact {
    int32_t next_free;
    int32_t shape_a, shape_b;
    int32_t body[2]; /* of shape_a and shape_b */
    int32_t
        child; /* terrain segment; TD_NONE: an edit took it away, and the next step the contact */
    int32_t slot;
    int32_t next[2], prev[2]; /* edges in the bodies' contact lists */
    uint16_t bin;
    uint8_t kind, state;
    uint8_t open;   /* touches, or overlaps a sensor: has begun and not ended */
    uint8_t listed; /* while a list of contacts is being made */
    uint8_t live;
    uint8_t vetoed; /* by the prologue of this step */
} td_contact;

typedef struct td_bin {
    int32_t head, tail, lanes;
} td_bin;

typedef struct td_colours {
    uint64_t moving, fixed; /* taken by this body's contacts with moving and static bodies */
} td_colours;

/* What happened, in the order it did; see thud_events. */
typedef struct td_event_lists {
    td_array begin, end, sensor_begin, sensor_end; /* thud_contact_event */
    td_array hit;                                  /* thud_hit_event */
    td_array quarantined;                          /* thud_body_id */
} td_event_lists;

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
    int32_t body;
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
} td_errors;

enum { TD_BUDGET_STEPS = 9 }; /* between two decisions */

/* What the last steps took, and would have with twice the substeps: seconds. */
typedef struct td_budget {
    double taken[TD_BUDGET_STEPS], doubled[TD_BUDGET_STEPS];
    int count;
} td_budget;

struct thud_world {
    /* Configuration: not part of a snapshot. */
    thud_world_def def;
    td_memory memory;
    uint32_t number;                                   /* mixed into generations */
    const td_pair_ops *pairs[TD_PAIR_TOUCH_COUNT];     /* plugged in by kinds.h */
    const struct td_internal_edge_ops *internal_edges; /* likewise; null: nothing has faces */
    const struct td_ground_ops *ground;                /* likewise; null: there are no lines */
    bool wide;                                         /* AVX2 kernels may run */
    bool locked;                                       /* in a step, or inside a callback */
    float unit;                                        /* L in the caller's unit */
    float quantum;                                     /* caller's unit a position quantum */
    double to_fixed;                                   /* position quanta a caller's unit */
    double to_coarse;                                  /* bounds quanta a caller's unit */
    thud_quality quality;                              /* with what the def itself named */
    int substeps;
    const thud_detection *detections[TD_RANK_COUNT]; /* those that the world or a body ever chose */
    float skin;                                      /* at which contacts rest */

    /* State. */
    uint64_t steps;
    double spare_time;   /* of thud_world_advance */
    uint32_t rest_epoch; /* rises whenever a resting shape enters or moves */
    td_slots bodies, shapes, contacts, terrains;
    td_array pose;                         /* td_pose, by body */
    td_array proxy;                        /* td_shape_proxy, by shape */
    td_array was;                          /* td_bounds, by shape */
    td_array marks;                        /* uint8_t, by shape */
    td_array velocity, delta, start, push; /* float[4], by awake slot; push: velocity
                                              gained a substep */
    td_array damping;                      /* float[2], by awake slot */
    td_array idle;                         /* float, by awake slot: time at rest */
    td_array direct_steps;                 /* uint8_t, by awake slot: steps for which
                                      its island still counts as hard */
    td_array slow_steps;                   /* uint16_t, by awake slot: steps that took
                                          its island's solver long */
    td_array reach;                        /* float[2], by awake slot: core, rim */
    td_array mass, inertia, weight;        /* float, by awake slot; weight: mass by
                                              gravity scale */
    td_array body_of;                      /* int, by awake slot */
    td_array lone;                         /* int, by awake slot: the only shape of the
                                              body, if it is plain; else TD_NONE */
    td_array colours;                      /* td_colours, by awake slot */
    td_array waiting[TD_PAIR_COUNT];       /* int: contacts */
    td_array moved;                        /* int: shapes */
    td_array changed;                      /* int: bodies */
    td_array deferred;                     /* td_deferred_edit */
    td_slots pool[TD_FORM_COUNT];          /* td_block of each form */
    td_bin bins[TD_PAIR_TOUCH_COUNT][TD_BINS_A_KIND];
    int touching;       /* lanes in use, asleep ones too */
    int bouncy;         /* ... of which have restitution */
    int surface_speeds; /* ... of which have a surface speed */
    int mobile_sensors; /* shapes: sensors of dynamic bodies */
    int contact_count[TD_PAIR_COUNT];
    int damped;         /* awake bodies with damping */
    bool push_stale;    /* `push` must be made anew */
    double kinetic;     /* energy of the awake bodies, ... */
    bool kinetic_stale; /* ... unless they changed since */
    int idle_bodies;    /* at rest for long enough to sleep */
    float thinnest;     /* no shape is thinner; see td_thinnest */
    bool thinnest_stale;
    int drowsy_bodies; /* ... or will be after one more step */
    td_proxy_set awake_shapes, rest_shapes;
    bool vast;                /* wider than bounds can tell; broadphase.c */
    bool paired;              /* the broadphase is done, and so many parts */
    int narrowed;             /* of the narrowphase, of a step that ran out of
                                 memory afterwards; until the next edit */
    td_event_lists events;    /* since the last whole step */
    td_event_lists published; /* of that step: what callers read */

    /* Scratch and statistics: rebuilt by every step. */
    struct td_scratch {
        td_array hits;    /* int: what a grid reports */
        td_array ahead;   /* int: shapes at rest that a fast body may hit */
        td_array crowded; /* int: shapes in a crowd of which pairs are missing */
        td_array stamps;  /* uint32_t, by shape: the last one that it was found to touch */
        uint32_t stamp;
        td_array pairs;            /* td_new_pair */
        td_array bodies, contacts; /* int: an island that wakes or falls asleep */
        td_array blocks;           /* td_block *: in solver order */
        td_array runs;             /* td_run */
        bool sequenced;            /* the two list all blocks of the awake bins */
        td_array parted;           /* td_block *: have a lane that touches no more */
        td_array chunks;           /* td_chunk: what workers take of the blocks */
        td_array counters;         /* atomic_int: of phases, see jobs.h */
        td_array begins, ends;     /* int: contacts */
        td_array parents;          /* int: union-find by awake slot */
        td_array lane_bins;        /* int: see td_lanes_place */
        td_array test_blocks;      /* td_block of the largest form: waiting pairs under test */
        td_array test_list;        /* td_block *: to them */
        td_array fast;             /* int: awake slots of dynamic bodies that moved further than
                                      half their core */
        td_event_queue queue;      /* of the candidates that are going to meet */
        td_array trajectories;     /* td_trajectory, by awake slot */
        td_array candidates;       /* td_toi_candidate: the extra ones */
        td_array strays;           /* td_stray */
        td_array impacts;          /* td_impact */
        td_array odd;              /* int: awake slots that the wide part of finish leaves over */
        td_array order;            /* while a proxy set is put into its order */
    } scratch;
    td_islands islands; /* likewise, of direct islands */
    td_array poses;     /* thud_pose */
    td_errors errors;
    td_budget budget;
    thud_stats stats;
};

static inline td_body *td_body_at(const thud_world *w, int i) {
    return td_slot_of(&w->bodies, i, sizeof(td_body));
}

static inline bool td_body_sleeps(const thud_world *w, int i) {
    return td_body_at(w, i)->kind == THUD_DYNAMIC && td_body_at(w, i)->awake < 0;
}

static inline td_shape *td_shape_at(const thud_world *w, int i) {
    return td_slot_of(&w->shapes, i, sizeof(td_shape));
}

static inline td_contact *td_contact_at(const thud_world *w, int i) {
    return td_slot_of(&w->contacts, i, sizeof(td_contact));
}

static inline td_pose *td_pose_at(const thud_world *w, int body) {
    assert(body >= 0 && body < w->pose.capacity);
    return (td_pose *)w->pose.data + body;
}

static inline td_shape_proxy *td_shape_proxy_at(const thud_world *w, int shape) {
    assert(shape >= 0 && shape < w->proxy.capacity);
    return (td_shape_proxy *)w->proxy.data + shape;
}

static inline td_bounds *td_fat_at(const thud_world *w, int shape) {
    return &td_shape_proxy_at(w, shape)->fat;
}

static inline uint8_t *td_marks_at(const thud_world *w, int shape) {
    assert(shape >= 0 && shape < w->marks.capacity);
    return (uint8_t *)w->marks.data + shape;
}

static inline float *td_row(const td_array *rows, int i) {
    return td_at(rows, i);
}

#endif
