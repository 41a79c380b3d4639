/* detection.h: the kinds of collision detection, as worlds and bodies choose them. */
#ifndef TD_DETECTION_H
#define TD_DETECTION_H

#include "base/indices.h"
#include "geometry/shape_instance.h"
#include "thud/thud_detection.h"

/* Two shapes, or a shape and the ground, on their straight ways through the rest of a step. */
typedef struct td_approach {
    bool on_ground; /* a against `ground`, relative to it, and no b */
    thud_terrain ground;
    thud_shape_instance a, b;
    thud_motion motion_a, motion_b;
    double distance;  /* now, where it is small; negative: overlap */
    double target;    /* the distance at which they count as met, less than the present one;
                         negative where they touch already */
    double swing;     /* so far may their arcs be from the straight ways */
    double tolerance; /* they may be so much further apart when they meet */
} td_approach;

/* When shapes that are apart meet, in [0, 1] of the rest; false where they do not. At *time they do
 * not overlap. */
typedef bool td_meet_fn(const td_approach *approach, double *time);

enum { TD_RANK_OVERLAP, TD_RANK_CONTINUOUS, TD_RANK_BISECT, TD_RANK_SWEPT, TD_RANK_COUNT };

struct thud_world;

/* When in a step detection has its say. */
typedef enum td_moment {
    TD_BEFORE_SOLVING,
    TD_BEFORE_MOVING, /* velocities and motions are known, and no body is where they take it */
    TD_AFTER_MOVING,
    TD_MOMENT_COUNT
} td_moment;

/* The part of a step that a detection needs; it runs once for all detections that share it. */
typedef struct td_detection_stage {
    /* Room, so that `run` cannot fail; false: out of memory. */
    bool (*reserve)(struct thud_world *w);
    void (*run[TD_MOMENT_COUNT])(struct thud_world *w); /* null: nothing */
} td_detection_stage;

/* continuous.c: fast bodies go back to where they first met a static shape. */
extern const td_detection_stage td_stage_continuous;
/* impacts.c: bodies that are bisected or swept move on from each collision. */
extern const td_detection_stage td_stage_impacts;

/* continuous.c: brings a body back to a part, in [0, 1], of the motion that it has made. It does
 * not fall on in the rest of the step, so that the velocity which gravity and forces give it there
 * is taken back. */
void td_hold_at(struct thud_world *w, td_awake_slot slot, double time);

struct td_sensing;

struct thud_detection {
    const char *name;
    int rank; /* TD_RANK_...; the higher of two moving bodies' decides on their pair */
    const td_detection_stage *stage;  /* null: the contacts of the narrowphase are all there is */
    td_meet_fn *meet;                 /* for td_stage_impacts */
    const struct td_sensing *sensing; /* sensing.h; null: sensors go by where bodies stand alone */
};

#endif
