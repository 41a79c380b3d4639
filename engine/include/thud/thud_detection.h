/* thud_detection.h: the ways of finding what may collide, for a world def to choose from. A program
 * that never names one does not link it. */
#ifndef THUD_DETECTION_H
#define THUD_DETECTION_H

#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A broadphase finds the pairs of shapes whose bounds overlap. All find the same pairs and hand
 * them on in the same order, so that a world does the same, bit for bit, with any of them:
 * contacts, events, what callbacks are asked, and where bodies go.
 *
 * But for crowds. From when more than 8,192 pairs, and 64 a shape of the world, overlap of which
 * one moved, until fewer than half as many do, a shape that overlaps more than 32 others gets some
 * of those pairs in later steps, and which come first is the broadphase's own. Pairs that may not
 * touch hold no places, and sensors get all that are looked at. Of n shapes in one spot each pair
 * is looked at within n / 64 steps, and has come within 4 n if all of them may touch and stay
 * there. */
typedef struct thud_broadphase thud_broadphase;

/* A grid with a level for each eightfold of size, whatever the sizes: in a gas (docs/catalogue.md)
 * a shape costs 30 ns a step among 1,000 and 59 ns among 100,000. The default. */
extern THUD_API const thud_broadphase thud_broadphase_grid;
/* Sort and sweep along x, kept sorted by insertion sort: cheap while little moves; dear where many
 * shapes stand above each other, or where one is much wider than the rest. */
extern THUD_API const thud_broadphase thud_broadphase_sweep;
/* Each shape against each, eight at a time: nothing to keep, and the fastest for a handful. */
extern THUD_API const thud_broadphase thud_broadphase_all;

THUD_API const char *thud_broadphase_name(const thud_broadphase *broadphase); /* "" for null */

/* How moving shapes are tested: a choice for a world, and for single bodies. Of two moving bodies
 * the finer choice decides on their pair; on a pair with a sensor too, of which thud_events.h tells
 * what is reported of ways. `docs/catalogue.md` has what each costs and gets wrong.
 */
typedef struct thud_detection thud_detection;

/* Where they stand at the start of each step, and nowhere else: the cheapest. What moves further
 * than a shape is thick may pass through it. */
extern THUD_API const thud_detection thud_detection_overlap;
/* As above, and bodies that move further than a quarter of their size stop for the rest of the step
 * where they first meet a static shape. The default. */
extern THUD_API const thud_detection thud_detection_continuous;
/* A pair that overlaps at the end of the step's motion is taken back to the time of its collision,
 * found by bisection, gets its new velocities there and moves on. Sees nothing that was passed
 * through: speed * time_step, that of corners that turn too, must stay below the smallest size, see
 * thud_world_bisection_limit; the statistics count who broke it. */
extern THUD_API const thud_detection thud_detection_bisect;
/* Bodies move forward to each of their times of impact, in the order of time, get new velocities
 * there and move on. Nothing passes through anything, and what is apart does not come to overlap;
 * but a kinematic body goes its way whatever stands in it, and load may press what touches
 * together, by up to 0.00035 length scales a step, before the contacts have settled. Bodies that
 * touch others keep the motion that they have together: what hits one changes its velocity at once,
 * and gives way for the rest of the step. A body that meets more than 8 times, 16 if elastic, in a
 * step is held for the rest of it, which the statistics tell; in a pile under impact that is up to
 * three in a hundred. So is whatever meets something once a step has worked out 8192 times of
 * collision, and 48 more for each awake body (thud_stats.motion_exact). So is a body that leaves
 * its expected way where there is no memory to look for whom else it may meet. What touches a body
 * that joints tie as a step begins is left to the contacts, which may let the two overlap
 * (thud_joint.h), under bisect too: ten boxes 40 times as heavy as a plank, dropped on a hinged
 * bridge of twenty, overlap others by up to 0.43, 0.12, 0.17, 0.13 at draft, default, high, exact,
 * and open a hinge by up to 2.1, 0.24, 0.037, 0.038 length scales (bisect 2.6, 0.23, 0.057, 0.029,
 * continuous 4.6, 0.19, 0.009, 0.014). A step takes 3.2 times as long as with overlap in a gas, 6.5
 * times in a heap (docs/catalogue.md).
 *
 * Bisection takes the motion of a step as straight: gravity g bends it by up to g * time_step^2
 * / 8. Swept bodies that nothing bears fly exact parabolas, and elastic ones (restitution 1) keep
 * their energy. In a world that chooses one of the two contacts rest 0.004 length scales apart, so
 * that what load presses together does not overlap. */
extern THUD_API const thud_detection thud_detection_swept;

THUD_API const char *thud_detection_name(const thud_detection *detection); /* "" for null */

#ifdef __cplusplus
}
#endif

#endif
