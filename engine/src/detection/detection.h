/* detection.h: the four kinds of collision detection that a world or a body chooses (overlap,
 * continuous, bisect, swept; thud_detection.h), and the functions that a kind consists of.
 *
 * Times are shares, in [0, 1], of the step or of what is left of it; lengths are in the caller's
 * unit. */
#ifndef TD_DETECTION_H
#define TD_DETECTION_H

#include "base/indices.h"
#include "base/memory.h"
#include "geometry/shape_instance.h"
#include "thud/thud_detection.h"

/* Two shapes, or a shape and a terrain, that move on straight paths during an interval of the step:
 * the input of a time-of-impact test. */
typedef struct td_approach {
    bool on_ground;      /* shape a against `ground`, in the frame of the ground; b is not set */
    thud_terrain ground; /* a view; the world owns its points */
    thud_geometry a, b;  /* at the start of the interval */
    thud_motion motion_a, motion_b; /* over the whole interval */
    double distance;                /* at the start; negative: overlap */
    double target;     /* the distance at which the pair counts as meeting; < distance */
    double path_error; /* bound on how far the true paths, which are arcs and parabolas, are from
                          the straight ones, both sides together */
    double tolerance;  /* the time of impact may be found up to this length short of `target` */
} td_approach;

/* Finds when an approach first comes within its target. False where it does not. *time is a share,
 * in [0, 1], of the interval; shapes that are apart at its start do not overlap at *time. */
typedef bool td_time_of_impact_fn(const td_approach *approach, double *time);

/* Order of the kinds, from coarse to fine. */
enum { TD_RANK_OVERLAP, TD_RANK_CONTINUOUS, TD_RANK_BISECT, TD_RANK_SWEPT, TD_RANK_COUNT };

struct thud_world;

/* The moments of a step at which a detection stage may run. */
typedef enum td_moment {
    TD_BEFORE_SOLVING, /* after the narrowphase */
    TD_BEFORE_MOVING,  /* velocities and motions of the step are known; poses are those of the start
                        */
    TD_AFTER_MOVING,   /* poses are those of the end */
    TD_MOMENT_COUNT
} td_moment;

/* The part of a step that a kind of detection needs. It runs once a step for all kinds that share
 * it. */
typedef struct td_detection_stage {
    /* Reserves memory, so that `run` cannot fail. False: out of memory. */
    bool (*reserve)(struct thud_world *w);
    void (*run[TD_MOMENT_COUNT])(struct thud_world *w); /* null: nothing runs at that moment */
} td_detection_stage;

/* continuous.c: stops fast bodies at their first time of impact with a static shape. */
extern const td_detection_stage td_stage_continuous;
/* impacts.c: moves bisected and swept bodies from impact to impact. */
extern const td_detection_stage td_stage_impacts;

/* continuous.c: moves a body, whose pose is that of the end of the step, back to the share `time`,
 * in [0, 1], of its motion in the step. The velocity that gravity and forces gave it in the rest
 * of the step is removed, since it does not move in the rest. */
void td_hold_at(struct thud_world *w, td_awake_slot slot, double time);

/* continuous.c: whether td_stage_continuous has to sweep a fast body, since a shape is near its
 * path. `hits` (int) and `memory` are for the shapes that a query finds; if both are too small, the
 * result is true. Threads may call it at the same time. */
bool td_fast_meets(struct thud_world *w, td_awake_slot slot, td_array *hits, td_memory *memory);
/* Prefetches what td_fast_meets reads of bodies after the one at index i of scratch.fast. */
void td_fast_fetch(const struct thud_world *w, int i);

struct thud_detection {
    const char *name;
    int rank; /* TD_RANK_...; in a pair of moving bodies the higher rank decides */
    const td_detection_stage *stage;      /* null: the detection consists of the narrowphase only */
    td_time_of_impact_fn *time_of_impact; /* for td_stage_impacts; null in other stages */
    /* Null, or the island solver that a world with this detection has where its quality has none
     * (take_quality of quality.c). With one, every island without joints is solved directly
     * (direct/direct_islands.c). */
    const struct thud_island_solver *islands;
    bool senses; /* sensors also report shapes that pass through them within a step (sensing.c);
                    false: they report by the poses at the end of the step only */
    /* Tests the paths of fast bodies against those of awake bodies, for sensors. Null: paths are
     * tested against resting bodies only. */
    void (*sense_awake)(struct thud_world *w);
};

#endif
