/* world.h: the state of a world, as plain data in arrays that name each other by index.
 *
 * Hot and cold stand apart: what every substep touches is in the `awake` arrays, dense and 16 bytes
 * a record; what every step touches lies in per-body and per-shape records; definitions, links and
 * user data are elsewhere. */
#ifndef TD_WORLD_H
#define TD_WORLD_H

#include "base/memory.h"
#include "broadphase/proxy_set.h"
#include "contact/pair_kinds.h"
#include "detection/detection.h"
#include "direct/direct_islands.h"
#include "solver/tally.h"
#include "state/awake_arrays.h"
#include "state/records.h"
#include "state/scratch.h"
#include "thud/thud.h"

/* Copies of the shapes that edits place which are still to take effect: preview.h. */
typedef struct td_preview {
    td_array shape;  /* int */
    td_array proxy;  /* td_shape_proxy, as `shape`; the fat bounds are tight */
    td_array number; /* int, by shape: its index in the two, if it is in them */
    bool stale;      /* edits have been made since */
} td_preview;

struct thud_world {
    /* Configuration: not part of a snapshot. */
    thud_world_def def;
    td_memory memory;
    uint32_t number; /* mixed into generations */
    /* Plugged in by kinds.h, as the next two are, and by what makes joints. */
    const td_constraint_ops *kinds[TD_CONSTRAINT_KINDS];
    const struct td_internal_edge_ops *internal_edges; /* null: nothing has faces */
    const struct td_joint_hooks *joint_hooks;          /* null: there never was a joint */
    const struct td_ground_ops *ground;                /* null: there are no lines */
    const struct td_rule_hooks *rule_hooks;            /* null: there never was a rule */
    struct td_rules *rules;                            /* with it; a snapshot has them */
    bool adds_impulses;                                /* a rule asks what contacts bear */
    const struct td_listener_hooks *listener_hooks;    /* null: there never was a listener */
    struct td_listeners *listeners;                    /* with it */
    bool asks, tells;                                  /* there is a prologue; an epilogue */
    bool wide;                                         /* AVX2 kernels may run */
    bool locked;                                       /* in a step, or inside a callback */
    bool advancing;                                    /* in thud_world_advance */
    /* Null but in its second step and those after: see advance.c. */
    bool (*gather)(struct thud_world *w);
    float unit;           /* L in the caller's unit */
    float quantum;        /* caller's unit a position quantum */
    double to_fixed;      /* position quanta a caller's unit */
    double to_coarse;     /* bounds quanta a caller's unit */
    thud_quality quality; /* with what the def itself named */
    int substeps;
    const thud_detection *detections[TD_RANK_COUNT]; /* those that the world or a body ever chose */
    float skin;                                      /* at which contacts rest */

    /* State. */
    uint64_t steps;
    double spare_time;   /* of thud_world_advance, as the next two are */
    uint64_t begun;      /* the step that it failed in; 0: none */
    td_array pulls;      /* td_pull, by body; empty where there is no force */
    uint32_t rest_epoch; /* rises whenever a resting shape enters or moves */
    td_slots bodies, shapes, constraints, joints, terrains;
    td_array pose;  /* td_pose, by body */
    td_array proxy; /* td_shape_proxy, by shape */
    td_array was;   /* td_bounds, by shape */
    td_array marks; /* uint8_t, by shape */
    union {         /* by awake slot: by number, and by name */
        td_array awake[TD_AWAKE_ARRAY_COUNT];
        struct {
            TD_AWAKE_ARRAYS(TD_AWAKE_FIELD)
        };
    };
    td_array waiting[TD_CONSTRAINT_KINDS]; /* int: constraints */
    td_array moved;                        /* int: shapes */
    td_array changed;                      /* td_body_index */
    td_array deferred;                     /* td_deferred_edit */
    td_slots pool[TD_FORM_COUNT];          /* td_block of each form */
    td_bin bins[TD_CONSTRAINT_KINDS][TD_BINS_A_KIND];
    int touching;       /* lanes of contacts in use, asleep ones too */
    int bouncy;         /* lanes in use that have restitution */
    int surface_speeds; /* lanes in use that have a surface speed */
    int sensors;        /* shapes */
    int mobile_sensors; /* shapes: sensors of dynamic bodies */
    int constraint_count[TD_CONSTRAINT_KINDS];
    int damped;          /* awake bodies with damping */
    bool push_stale;     /* `push` must be made anew */
    double kinetic;      /* energy of the awake bodies */
    bool kinetic_stale;  /* `kinetic` must be added up anew */
    int idle_bodies;     /* at rest for long enough to sleep */
    int drowsy_bodies;   /* at rest for long enough after one more step */
    float thinnest;      /* no shape is thinner; see td_thinnest */
    bool thinnest_stale; /* `thinnest` must be looked for anew */
    td_proxy_set awake_shapes, rest_shapes;
    bool vast; /* wider than bounds can tell; broadphase.c */
    /* A step that ran out of memory has done its broadphase, and so many parts of its narrowphase,
     * which hold until the next edit. */
    bool paired;
    int narrowed;
    td_event_lists events;    /* since the last whole step */
    td_event_lists published; /* of the last whole step: what callers read */
    td_array broken;          /* thud_joint_event, of the last whole step */
    td_gathered gathered;     /* of all steps of the last thud_world_advance: what callers read, */
    bool gathers;             /* ... if it made another number of steps than one */
    int breakable;            /* joints that may break */

    /* Rebuilt by every step. */
    td_scratch scratch;
    td_islands islands; /* the direct ones */
    td_array poses;     /* thud_pose */
    td_preview preview;

    /* Statistics. */
    td_errors errors;
    td_budget budget;
    thud_stats stats;
};

static inline td_body *td_body_at(const thud_world *w, td_body_index i) {
    return td_slot_of(&w->bodies, i.at, sizeof(td_body));
}

static inline bool td_body_sleeps(const thud_world *w, td_body_index i) {
    return td_body_at(w, i)->kind == THUD_DYNAMIC && td_body_at(w, i)->awake.at < 0;
}

static inline td_shape *td_shape_at(const thud_world *w, int i) {
    return td_slot_of(&w->shapes, i, sizeof(td_shape));
}

static inline td_constraint *td_constraint_at(const thud_world *w, int i) {
    return td_slot_of(&w->constraints, i, sizeof(td_constraint));
}

static inline bool td_is_contact(const td_constraint *constraint) {
    return constraint->kind < TD_PAIR_COUNT;
}

static inline td_contact *td_contact_at(const thud_world *w, int i) {
    assert(td_is_contact(td_constraint_at(w, i)));
    return td_slot_of(&w->constraints, i, sizeof(td_contact));
}

static inline td_terrain_record *td_terrain_record_at(const thud_world *w, int i) {
    return td_slot_of(&w->terrains, i, sizeof(td_terrain_record));
}

static inline td_pose *td_pose_at(const thud_world *w, td_body_index body) {
    assert(body.at >= 0 && body.at < w->pose.capacity);
    return (td_pose *)w->pose.data + body.at;
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

static inline td_bounds *td_was_at(const thud_world *w, int shape) {
    return TD_AT(td_bounds, &w->was, shape);
}

/* ---- by awake slot ---- */

static inline td_body_index td_body_of(const thud_world *w, td_awake_slot slot) {
    return td_body_in(&w->body_of, slot.at);
}

static inline uint8_t *td_direct_steps_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(uint8_t, &w->direct_steps, slot.at);
}

static inline uint16_t *td_slow_steps_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(uint16_t, &w->slow_steps, slot.at);
}

static inline td_colours *td_colours_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(td_colours, &w->colours, slot.at);
}

/* Of an array of awake_arrays.h that has one, two or four floats an element. */
static inline float *td_row(const td_array *rows, td_awake_slot slot) {
    return td_at(rows, slot.at);
}

#endif
