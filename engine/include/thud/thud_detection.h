/* thud_detection.h: the broadphases and the kinds of collision detection that a world def chooses
 * from. A program links only those to which it refers. */
#ifndef THUD_DETECTION_H
#define THUD_DETECTION_H

#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A broadphase finds the pairs of shapes whose bounds (AABBs) overlap. All broadphases find the
 * same pairs and report them in the same order, so that contacts, events, calls of callbacks and
 * motions of bodies are the same, bit for bit, with any of them.
 *
 * An exception is a crowd. It begins when more than 8,192 pairs, and 64 for each shape of the
 * world, overlap of which one shape moved, and ends when fewer than half as many do. In a crowd a
 * shape that overlaps more than 32 others gets some of those pairs in later steps, and their order
 * depends on the broadphase. Pairs that may not touch do not count towards the 32, and sensors get
 * all pairs that are tested. If n shapes stay in one spot, each pair is tested within n / 64 steps,
 * and has become a contact within 4 n steps if all of them may touch. */
typedef struct thud_broadphase thud_broadphase;

/* A hashed grid for shapes of any sizes, with one level for each factor of eight in size: in a gas
 * (docs/catalogue.md) a shape costs 35 ns a step among 1,000 and 59 ns among 100,000. The number
 * of bounds that are tested for a shape does not grow with the world
 * (thud_world_get_broadphase_counts), but its time does, since more memory is visited. The
 * default. */
extern THUD_API const thud_broadphase thud_broadphase_grid;
/* Sort and sweep along x, kept sorted by insertion sort: cheap while few shapes move; expensive if
 * many shapes lie above each other, or if one is much wider than the rest. */
extern THUD_API const thud_broadphase thud_broadphase_sweep;
/* The same along y: expensive if many shapes lie side by side. */
extern THUD_API const thud_broadphase thud_broadphase_sweep_y;
/* The same along the axis with the larger variance of the centres of bounds. The axis is chosen
 * whenever shapes are sorted, which is in each step in which one moves. It changes, and all shapes
 * are sorted again, if the variance along the other axis is more than one and a half times that
 * along the present one. */
extern THUD_API const thud_broadphase thud_broadphase_sweep_widest;
/* The same with two sorted lists, along x and along y. Each shape is tested against the shapes
 * whose intervals it may overlap in one of the lists, the one in which these are fewer; so each
 * pair is considered from both of its shapes. It tests the fewest bounds if some shapes form rows
 * and others columns, but tests them one by one instead of eight at a time. */
extern THUD_API const thud_broadphase thud_broadphase_sweep_both;
/* Tests each shape against every other, eight at a time: there is no structure to maintain, and it
 * is the fastest for few shapes. The default of thud_default_small_world_def. */
extern THUD_API const thud_broadphase thud_broadphase_all;

THUD_API const char *thud_broadphase_name(const thud_broadphase *broadphase); /* "" for null */

/* How collisions of moving shapes are found: a choice for a world (thud_world_def.detection), and
 * for single bodies (thud_body_def.detection). For a pair of two dynamic bodies the later of both
 * choices in the order below is used, else that of the dynamic body; the choice of a static or
 * kinematic body has no effect. For sensors see thud_events.h. docs/catalogue.md has the cost
 * and the errors of each. */
typedef struct thud_detection thud_detection;

/* Discrete detection: shapes are tested at their poses at the start of each step only. The
 * cheapest. A body that moves further in a step than a shape is thick may pass through it. */
extern THUD_API const thud_detection thud_detection_overlap;
/* As above, but a body that moves further in a step than a quarter of its smallest extent stops at
 * its first time of impact with a static shape, for the rest of the step. The default. */
extern THUD_API const thud_detection thud_detection_continuous;
/* A pair that overlaps at the end of the step's motion is moved back to the time of its collision,
 * which is found by bisection, gets its new velocities there, and continues with these. It does not
 * find collisions of shapes that have passed through each other by the end of the step: speed *
 * time_step, including the speed of rotating corners, must stay below the thickness of the thinnest
 * shape, see thud_world_get_bisection_limit; thud_stats.unbisectable counts the bodies beyond
 * it. */
extern THUD_API const thud_detection thud_detection_bisect;
/* Bodies advance to each of their times of impact, in the order of time, get new velocities there,
 * and continue with these.
 *
 * What follows holds in a world that chooses it. A body that chooses it alone
 * (thud_body_def.detection), or bisect, passes through nothing, but its contacts are those of the
 * world's detection: they may overlap under a load, its path counts as straight, and elastic
 * bounces may change energy.
 *
 * No body passes through another, and separate shapes do not begin to overlap, with these
 * exceptions: a kinematic body moves at its velocity, whatever is in its path;
 * and a load may press touching shapes together, by up to 0.00035 length scales a step, before the
 * contacts have settled.
 *
 * A body that touches others keeps the motion that the solver computed for all of them: a body that
 * hits it changes its velocity at once, and does not enter its path for the rest of the step. Where
 * a pair would meet in a step without bouncing, and its bodies touch at least two others together,
 * it is solved with all contacts of these at once, and comes to rest against them at the end of the
 * step in place of the time of impact; its prologue, epilogue and hit event are those of an impact.
 * A body stops at its position for the rest of the step, and is counted in thud_stats.held_bodies,
 * in three cases: it has impacts more than 8 times, 16 if elastic, in a step (while a
 * scene comes to rest, in the mean one circle of seven hundred in a pit, one box of twenty in a
 * full drum); it has an impact
 * after the step has worked out 8192 times of collision, and 48 more for each awake body
 * (thud_stats.motion_exact); or it leaves the predicted bounds of its path, and there is no memory
 * to find the shapes that it may meet there.
 *
 * Contacts that a body with joints has at the start of a step are left to the contact solver, which
 * may let the shapes overlap (thud_joint.h), also under bisect: ten boxes 40 times as heavy as a
 * plank, dropped on a hinged bridge of twenty, overlap others by up to 0.43, 0.12, 0.17, 0.13 at
 * draft, default, high, exact, and open a hinge by up to 2.1, 0.24, 0.037, 0.038 length scales
 * (bisect 2.6, 0.23, 0.057, 0.029, continuous 4.6, 0.19, 0.009, 0.014). A step takes 3.2 times as
 * long as with overlap in a gas, 3.5 times in a heap (docs/catalogue.md).
 *
 * Bisection treats the path of a step as straight, although gravity g bends it by up to g *
 * time_step^2 / 8. Swept bodies in free flight meet others on their exact parabola, and elastic
 * ones (restitution 1) keep their energy.
 *
 * In a world that chooses bisect or swept, every island without joints is solved directly, within
 * the quality's island_limit and island_work; a quality without an island solver, such as draft,
 * gets one and at least four substeps, unless its island_limit is 1. Stacks that stand under
 * continuous also stand here: columns of 30 and 100 boxes, which sink by 0.21 and 0.56 m at
 * default, lose no height, and boxes and discs on slopes stay within 1e-4 m of their path (under
 * continuous they leave it by 0.043 and 0.035 m). Larger islands are left to the soft solver. Their
 * contacts rest 0.003 length scales apart, at high and exact 0.001, so that shapes that a load
 * presses together do not overlap; under a higher load they do: in a pit of a thousand bodies by
 * 0.02 m in the mean of a step, under continuous by 0.05 m. Swept has no advantage in large heaps
 * that collapse, where a step takes seven times (circles in a pit) to thirty times (boxes in a full
 * drum) as long as under continuous, or between bodies with joints. docs/tradeoff.md has the
 * figures. */
extern THUD_API const thud_detection thud_detection_swept;

THUD_API const char *thud_detection_name(const thud_detection *detection); /* "" for null */

#ifdef __cplusplus
}
#endif

#endif
