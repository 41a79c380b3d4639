/* cover.h: measures how a set of circles and boxes covers a polygon: areas, sampled along
 * horizontal lines, and a bound of the distance. The polygon is counter-clockwise; its coordinates
 * are near the origin, and the larger of its width and height is 0.5 to 1. */
#ifndef TD_COVER_H
#define TD_COVER_H

#include "geometry/shape_instance.h"

/* ---- areas ---- */

/* The part of a horizontal line between two values of x. */
typedef struct td_interval {
    double from, to;
} td_interval;

/* A horizontal line in the middle of the strip from y0 to y1: its intervals in the polygon that no
 * shape covers, and the intervals of shapes, inside or outside of the polygon, in rising order and
 * disjoint. */
typedef struct td_cover_line {
    double y0, y1;
    td_interval *open, *taken;
    int open_count, taken_count;
} td_cover_line;

enum {
    /* Strips between the lowest and the highest point, in addition to one at each level edge: the
     * resolution with which shapes are compared. Chosen: the error of the radius of the best circle
     * in a regular polygon is then below a hundredth. */
    TD_COVER_LINES = 96
};

/* The lines of a polygon of `count` points: sets up to count + TD_COVER_LINES of them, whose lists
 * the caller has allocated, and returns their number. `ys` has room for count + 2 numbers. */
int td_cover_lines(const thud_pos *points, int count, double *ys, td_cover_line *lines);

/* Areas that a shape would cover: of the polygon and not covered yet, outside of the polygon and
 * not covered yet, and already covered. */
typedef struct td_cover_gain {
    double inside, outside, again;
} td_cover_gain;

td_cover_gain td_cover_gain_of(const td_cover_line *lines, int count, const thud_geometry *shape);

/* Adds a shape: takes its interval from `open` and adds it to `taken`, on each line over more than
 * half of whose strip's height the shape extends. */
void td_cover_add(td_cover_line *lines, int count, const thud_geometry *shape);

/* Areas, in squares of the internal unit of length. */
typedef struct td_cover_areas {
    double missed, extra, covered;
} td_cover_areas;

/* The areas of the polygon and the shapes, by two-point Gauss quadrature on strips between all
 * corners. `ys` has room for count + 4 shape_count numbers, `intervals` for count + 3
 * shape_count. */
td_cover_areas td_cover_measure(const thud_pos *points, int count, const thud_geometry *shapes,
                                int shape_count, double *ys, td_interval *intervals);

/* ---- distance ---- */

/* A convex set from which distances are measured: a circle, or a polygon, counter-clockwise. */
typedef struct td_convex {
    thud_pos corners[4], normals[4]; /* normals[i]: unit, outward, of the edge from corner i */
    int count;                       /* of corners; 0: a circle */
    double x, y, reach; /* centre, and the greatest distance of a point of the set from it: the
                           radius of a circle */
} td_convex;

td_convex td_convex_of_shape(const thud_geometry *shape);
td_convex td_convex_of_triangle(thud_pos a, thud_pos b, thud_pos c);

enum {
    TD_PIECE_CORNERS = 12, /* maximum corners of a piece. Chosen: a cut along a line can add a
                              corner, so a piece with one corner fewer than this, or more, is cut
                              between two opposite corners instead */
    TD_PIECE_DEPTH = 48,   /* maximum depth of successive cuts. Chosen: 24 halvings in both
                              directions */
    TD_PIECE_STACK = 2 * TD_PIECE_DEPTH + 8
};

/* A convex piece of a set, or the segment of a circle between an arc and its chord. */
typedef struct td_cover_piece {
    thud_pos corners[TD_PIECE_CORNERS];
    int count; /* of corners. 0: the circle's segment from corners[0] to corners[1]; the tangents at
                  these points meet in corners[2] */
    int depth, nearest;
} td_cover_piece;

/* An upper bound of the distance of the points of `from` from the union of `to`. `points`: the
 * outline of that union if it is a polygon, by which pieces deep inside are recognised at once;
 * otherwise null. `stack` has room for TD_PIECE_STACK pieces. `known`: the caller uses the maximum
 * of this and the result, so a result below `known` need not be precise. */
double td_cover_distance(const td_convex *from, const td_convex *to, int count,
                         const thud_pos *points, int point_count, double known,
                         td_cover_piece *stack);

#endif
