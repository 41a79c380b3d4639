/* world.h: the state of a world: plain data in arrays whose elements refer to each other by index.
 *
 * Data are separated by how often they are used: what every substep reads is in the `awake` arrays,
 * which have an element of at most 16 bytes for each awake body (awake_arrays.h); what every step
 * reads is in `pose` and `proxy`; definitions, links and user data are in the records of bodies,
 * shapes and constraints. */
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

struct td_swept; /* shape.h */

/* The optional parts of the engine that a world has from the start: thud_world_def.parts. A def
 * that leaves them out makes a world that does not link their code. */
struct thud_parts {
    const struct td_sensor_hooks *sensors;          /* contact/sensors.h */
    const struct td_restitution_hooks *restitution; /* solver/restitution.h */
    const thud_broadphase *broadphase;              /* the one for a def that names none */
    /* td_budget_keep of solver/budget.h */
    void (*keep_budget)(struct thud_world *w);
    /* td_broadphase_few_resting of api/step.h */
    bool (*few_resting)(struct thud_world *w, const td_array **few);
    const struct td_error_hooks *errors; /* solver/error.h */
    const struct td_sleep_hooks *sleep;  /* state/sleep_hooks.h */
};

/* api/world.c: a def with the default values, but without broadphase and parts, which the caller
 * adds. */
thud_world_def td_world_def_of(const thud_quality *quality);

/* Why restitution is refused without that part; `what` names the argument. */
#define TD_NO_RESTITUTION(what)                                            \
    what "restitution, in a world of thud_default_small_world_def before " \
         "thud_shape_set_restitution"

/* Copies of the proxies that pending edits will give to shapes: preview.h. */
typedef struct td_preview {
    td_array shape;  /* int: the shapes that have a copy */
    td_array proxy;  /* td_shape_proxy, in the order of `shape`; `fat` has the tight bounds */
    td_array number; /* int, by shape: index of its copy in `shape` and `proxy`. Never cleared: it
                        is valid only if that element of `shape` is this shape */
    bool stale;      /* edits have been made since the copies were */
} td_preview;

/* The bins of one number (constraint/lanes.h), by kind of constraint. */
typedef struct td_bins {
    td_bin of[TD_CONSTRAINT_KINDS];
} td_bins;

struct thud_world {
    /* Configuration: not part of a snapshot. */
    thud_world_def def;
    td_memory memory; /* allocator and its counters */
    uint32_t number;  /* distinguishes the handles of worlds: td_tag in handles.h */
    /* By constraint kind: its operations, plugged in by kinds.h and by the first joint. */
    const td_constraint_ops *kinds[TD_CONSTRAINT_KINDS];
    const td_instance_ops *instances; /* geometry of two shapes; null: it never had a shape */
    const struct td_internal_edge_ops *internal_edges; /* null: no shape has faces */
    const struct td_joint_hooks *joint_hooks;          /* null: the world never had a joint */
    const struct td_ground_ops *ground;           /* null: the world never had a terrain line */
    const struct td_rule_hooks *rule_hooks;       /* null: the world never had a rule or filter */
    struct td_rules *rules;                       /* null as rule_hooks; in snapshots */
    const struct td_texture_hooks *texture_hooks; /* null: the world never had a texture */
    struct td_textures *textures;                 /* null as texture_hooks; in snapshots */
    const struct td_sensor_hooks *sensor_hooks;   /* null: no shape can be a sensor yet */
    const struct td_error_hooks *error_hooks;     /* null: errors of steps are not collected yet */
    const struct td_sleep_hooks *sleep_hooks;     /* null: no body can fall asleep yet */
    const struct td_restitution_hooks *restitution_hooks; /* null: no contact can bounce yet */
    /* td_broadphase_few_resting; null: not in thud_parts */
    bool (*few_resting)(struct thud_world *w, const td_array **few);
    bool adds_impulses; /* a rule has a bound of the impulse: add up those of contacts */
    const struct td_listener_hooks *listener_hooks; /* null: the world never had a listener */
    struct td_listeners *listeners;                 /* null as listener_hooks */
    /* td_sweep_is_vetoed of shape.h; null: the world never had a rule or a listener */
    bool (*sweep_is_vetoed)(struct thud_world *w, const struct td_swept *swept, int shape,
                            int other, double time);
    /* td_edit_apply of body.h; null: no callback ever edited a body */
    void (*edit_apply)(struct thud_world *w, td_body_index body, td_deferred_kind what,
                       const double v[4]);
    bool asks, tells; /* there is a prologue (pre-solve callback); an epilogue (post-solve) */
    /* listeners/decisions.h; null: no prologue ever decided velocities */
    struct td_decisions *decisions;
    bool wide;      /* the processor runs the AVX2 kernels. As 0 or 1 the index of functions that
                       come in pairs, one for each instruction set */
    bool locked;    /* in a step, or inside a callback: edits are deferred or refused */
    bool advancing; /* in thud_world_advance */
    /* Collects the events of the step before; null but in steps of one thud_world_advance after the
     * first: advance.c. */
    bool (*gather)(struct thud_world *w);
    float length_scale;   /* L of base.h, in the caller's unit: of def.length_scale the
                             greatest power of two that is not above it */
    float quantum;        /* length of a position quantum, in the caller's unit */
    double to_fixed;      /* position quanta per unit of length of the caller */
    double to_coarse;     /* bounds quanta per unit of length of the caller */
    thud_quality quality; /* the quality that is used: the def's, with the fields that the def and
                             the detection replace */
    int substeps;         /* of the next step */
    const thud_detection *detections[TD_RANK_COUNT]; /* by rank: the detection, if the world or a
                                                        body ever chose it; else null */
    float skin; /* distance at which soft contacts rest, caller's unit: 0, or TD_SKIN or
                   TD_IMPACT_DISTANCE times length_scale (solver/quality.c) */

    /* State. */
    uint64_t steps;         /* made so far */
    double spare_time;      /* of thud_world_advance: time that has not been stepped yet, s */
    uint64_t begun;         /* of thud_world_advance: number of the step that ran out of memory and
                               is tried again; 0: none */
    td_array force_records; /* of thud_world_advance: td_force_record, by body; or empty */
    uint32_t rest_epoch; /* counts changes of the resting set: an island that fell asleep before the
                            last change searches for its pairs again when it wakes */
    td_slots bodies, shapes, constraints, joints, terrains;
    td_array pose;         /* td_pose, by body */
    td_array proxy;        /* td_shape_proxy, by shape */
    td_array previous_fat; /* td_bounds, by shape; of a moved one: its fat bounds before it moved */
    td_array marks;        /* uint8_t, by shape: TD_MARK_MOVED and so on */
    union {                /* arrays by awake slot; by their number, and by name */
        td_array awake[TD_AWAKE_ARRAY_COUNT];
        struct {
            TD_AWAKE_ARRAYS(TD_AWAKE_FIELD)
        };
    };
    td_array waiting[TD_CONSTRAINT_KINDS]; /* int: constraints that are TD_WAITING */
    td_array moved;                        /* int: shapes with TD_MARK_MOVED */
    td_array changed;             /* td_body_index: bodies with pending changes, the change list */
    td_array deferred;            /* td_deferred_edit, in the order of calls */
    td_slots pool[TD_FORM_COUNT]; /* td_block, by form (size of block) */
    td_bins bins[TD_BINS_A_KIND];
    td_array placed_bins; /* td_bins: by place from the second on, and colour */
    int touching;         /* lanes of contacts in use, of sleeping bodies too */
    int bouncy;           /* lanes in use that have restitution */
    int surface_speeds;   /* lanes in use that have a surface speed */
    int sensors;          /* shapes that are sensors */
    int mobile_sensors;   /* sensors that belong to dynamic bodies */
    int constraint_count[TD_CONSTRAINT_KINDS]; /* live constraints of each kind */
    int damped;                                /* awake bodies with damping */
    bool substep_gain_stale;                   /* the array substep_gain must be recomputed */
    double kinetic;                            /* kinetic energy of the awake bodies */
    bool kinetic_stale;                        /* `kinetic` must be recomputed */
    int idle_bodies;                           /* bodies at rest for TD_SLEEP_TIME or longer */
    int drowsy_bodies; /* bodies that are at rest for TD_SLEEP_TIME, or will be after one more step
                        */
    float thinnest;    /* thickness of the thinnest shape: td_thinnest */
    bool thinnest_stale; /* `thinnest` must be recomputed */
    td_proxy_set awake_shapes, rest_shapes;
    bool vast; /* so wide that bounds may wrap around: is_vast in broadphase.c */
    /* Progress of a step that ran out of memory, valid until the next edit. `paired`: its
     * broadphase is done; `narrowed`: the number of parts of its narrowphase that are done. */
    bool paired;
    int narrowed;
    td_event_lists events;    /* since the last whole step */
    td_event_lists published; /* of the last whole step: what callers read */
    td_array broken;          /* thud_joint_event, of the last whole step */
    td_gathered gathered;     /* of all steps of the last thud_world_advance: what callers read */
    bool gathers;             /* callers read `gathered`: that call did not make exactly one step */
    int breakable;            /* joints with a force or torque at which they break */

    /* Rebuilt by every step. */
    td_scratch scratch;
    td_islands islands; /* the islands of the step that are solved directly */
    td_array poses;     /* thud_pose: what thud_world_get_poses returns */
    td_preview preview;

    /* Statistics. */
    td_errors errors;
    td_budget budget;
    thud_stats stats;
    td_broadphase_counts broadphase; /* of the last step; not in snapshots */

    /* recording/recorder.h; null: the world is not being recorded. It is the last member: recording
     * then changes no other member's offset. */
    struct thud_recorder *recorder;
};

/* Loops that read records all over memory prefetch them if the world has more shapes than this. The
 * records of fewer shapes are in a cache near the processor, where prefetching costs more time than
 * it saves. Measured in gases of circles: with prefetching the broadphase took 2 % longer for
 * 16,000 of them, and a fifth less time for 256,000. Chosen between both. */
enum { TD_FETCH_SHAPES_MIN = 20000 };

static inline bool td_fetches(const thud_world *w) {
    return TD_HAS_PREFETCH && w->shapes.count > TD_FETCH_SHAPES_MIN;
}

static inline td_body *td_body_at(const thud_world *w, td_body_index i) {
    return td_slot_of(&w->bodies, i.at, sizeof(td_body));
}

/* Whether the body is dynamic and has no awake slot. */
static inline bool td_body_sleeps(const thud_world *w, td_body_index i) {
    return td_body_at(w, i)->kind == THUD_BODY_DYNAMIC && td_body_at(w, i)->awake.at < 0;
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

static inline td_bounds *td_previous_fat_at(const thud_world *w, int shape) {
    return TD_AT(td_bounds, &w->previous_fat, shape);
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

/* Whether no constraint has a lane at the body, so that the solver moves it on its exact path
 * (motion.h). A dynamic body alone: kinematic ones never have a colour. */
static inline bool td_is_unconstrained(const thud_world *w, td_awake_slot slot) {
    const td_colours *colours = td_colours_at(w, slot);
    return !(colours->with_moving | colours->with_static);
}

/* An element of an array of awake_arrays.h that consists of one, two or four floats. */
static inline float *td_row(const td_array *rows, td_awake_slot slot) {
    return td_at(rows, slot.at);
}

/* The inverse mass of an awake body, the fourth float of its velocity; 0: constraints do not move
 * it (a kinematic body; slot 0, which stands for all static ones). */
static inline float td_inv_mass_of(const thud_world *w, td_awake_slot slot) {
    return td_row(&w->velocity, slot)[3];
}

#endif
