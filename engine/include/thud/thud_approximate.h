/* thud_approximate.h: a polygon approximated by circles and boxes, with a bound of what they miss.
 *
 * A body has several shapes, but no polygons. thud_approximate finds shapes that cover a polygon,
 * and measures their errors, so that a caller can weigh the number of shapes against the error:
 *
 *     thud_geometry shapes[8];
 *     thud_approximation found;
 *     thud_approximate_options options = {.shapes_max = 8};
 *     thud_approximate(points, count, &options, shapes, &found);
 *
 * The shapes are those of a thud_body_shape (thud_edits.h), in the coordinates of the points, and
 * may overlap. Lengths are in any unit, relative to any origin near the polygon. There is no state,
 * and memory is only held during a call. The results have the same bits on every platform. */
#ifndef THUD_APPROXIMATE_H
#define THUD_APPROXIMATE_H

#include "thud_geometry.h"
#include "thud_hooks.h"

#ifdef __cplusplus
extern "C" {
#endif

/* THUD_OK if the points are a polygon that can be approximated: 3 to THUD_POLYGON_POINTS_MAX
 * points, counter-clockwise or clockwise, |x|, |y| <= THUD_POLYGON_PLACE_MAX; edges that meet only
 * where one ends and the next begins; and an area of at least THUD_POLYGON_AREA_MIN times the
 * square of the larger of width and height. Three successive points may lie on a line.
 * THUD_ERROR_NULL, THUD_ERROR_INVALID; *out_reason then is a static English text that says why, and
 * null otherwise. out_reason may be null. */
THUD_API thud_result thud_polygon_check(const thud_pos *points, int count, const char **out_reason);

/* The kinds of shapes that thud_approximate uses. */
typedef enum thud_approximate_kind {
    THUD_APPROXIMATE_BOTH = 0,
    THUD_APPROXIMATE_CIRCLES,
    THUD_APPROXIMATE_BOXES /* OBBs */
} thud_approximate_kind;

/* The options of thud_approximate. Zero-initialise it and set shapes_max. */
typedef struct thud_approximate_options {
    int shapes_max;              /* [1, THUD_APPROXIMATE_SHAPES_MAX] */
    thud_approximate_kind kinds; /* default THUD_APPROXIMATE_BOTH */
    double distance; /* the sufficient accuracy, length, [0, THUD_COORDINATE_MAX]: no more shapes
                        are added once thud_approximation.distance is at most this. Default 0, which
                        only a polygon that consists of boxes reaches, within rounding */
    thud_allocator allocator; /* thud_hooks.h. Default: the C library's */
} thud_approximate_options;

/* The number of shapes that thud_approximate found, and their errors. Areas are shares of the
 * polygon's area. */
typedef struct thud_approximation {
    int count;       /* of shapes, [1, shapes_max] */
    double missed;   /* area of the polygon that no shape covers */
    double extra;    /* area outside of the polygon that shapes cover */
    double overlap;  /* sum of the shapes' areas minus the area of their union: a body's mass counts
                        this area more than once. A density divided by 1 + overlap + extra - missed
                        gives the body the polygon's mass */
    double distance; /* an upper bound of the Hausdorff distance, length: no point of the polygon is
                        further from the nearest shape, and no point of a shape further from the
                        polygon, both taken as solid */
} thud_approximation;

/* Covers a polygon (thud_polygon_check) by circles and boxes. Writes the shapes to out_shapes,
 * which has room for options->shapes_max. Neither missed + extra nor distance is larger for a
 * larger shapes_max. A polygon with right angles only needs no more boxes than it has maximal
 * rectangles (an L has two), and if the search finds them it is covered exactly, within rounding.
 *
 * The search is greedy: shape by shape, it takes the circle or box that covers the most area of the
 * polygon that is not covered yet, minus weighted area outside of it. Three searches with different
 * weights run, and for each number of shapes the best result is used. The best possible shapes need
 * not be found. `missed`, `extra` and `overlap` are integrated along lines and exact to about 1e-4.
 * `distance` is a true bound, by branch and bound over convex pieces of the polygon and of the
 * shapes: over a convex piece the distance from a convex set is largest at a corner, since it is a
 * convex function (S. Boyd and L. Vandenberghe, Convex Optimization, 2004, 3.2.5). It exceeds the
 * Hausdorff distance by at most the larger of a sixteenth of it and a five-hundredth of the larger
 * of the polygon's width and height, except for polygons so complex that the search for it is cut
 * off.
 *
 * The time is proportional to shapes_max, and for polygons with many points also to their number.
 * THUD_ERROR_NULL, THUD_ERROR_INVALID, THUD_ERROR_MEMORY; outputs are then not written. */
THUD_API thud_result thud_approximate(const thud_pos *points, int count,
                                      const thud_approximate_options *options,
                                      thud_geometry *out_shapes, thud_approximation *out);

#ifdef __cplusplus
}
#endif

#endif
