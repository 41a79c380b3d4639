/* thud_detection.h: the ways of finding what may collide, for a world def to choose from. A program
 * that never names one does not link it. */
#ifndef THUD_DETECTION_H
#define THUD_DETECTION_H

#ifdef __cplusplus
extern "C" {
#endif

/* A broadphase finds the pairs of shapes whose bounds overlap. All find the same pairs and hand them
 * on in the same order, so that a world does the same, bit for bit, with any of them. (But for a
 * crowd: where a shape overlaps more than 32 others on a side, the grid hands out that many pairs at
 * once, and the rest as the crowd comes apart.) */
typedef struct thud_broadphase thud_broadphase;

/* A grid with a level for each eightfold of size: cost per shape stays flat as their number grows,
 * whatever their sizes. The default. */
extern const thud_broadphase thud_broadphase_grid;
/* Sort and sweep along x, kept sorted by insertion sort: cheap while little moves; dear where many
 * shapes stand above each other, or where one is much wider than the rest. */
extern const thud_broadphase thud_broadphase_sweep;
/* Each shape against each, eight at a time: nothing to keep, and the fastest for a handful. */
extern const thud_broadphase thud_broadphase_all;

const char *thud_broadphase_name(const thud_broadphase *broadphase); /* "" for null */

#ifdef __cplusplus
}
#endif

#endif
