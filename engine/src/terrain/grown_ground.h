/* grown_ground.h: the ground grown by a shape's reflection, as the shape's centre meets it: their
 * Minkowski sum (Lozano-Perez 1983).
 *
 * What is above a line stays above a line. The grown ground ends in the highest of many pieces,
 * which are the segments, shifted by the point of the shape that would touch them, and the shape's
 * underside, upside down, on every vertex. Flat ground has neither vertices nor pieces, but the one
 * line. Places are relative to the shape's centre: far from the origin nothing is lost. */
#ifndef TD_GROWN_GROUND_H
#define TD_GROWN_GROUND_H

#include "terrain/terrain.h"

/* Pieces of a vertex: up to two of the underside, and the segment that the vertex begins. */
enum { TD_PIECES = 3 };

typedef struct td_grown {
    const thud_terrain *terrain;
    const thud_shape_instance *shape;
    thud_pos offset;   /* the shape is moved by this */
    thud_pos under[3]; /* the leftmost, lowest and rightmost point of the shape */
    double radius;     /* of a circle */
    bool mirrored;     /* left and right have changed places */
} td_grown;

/* From left to right. */
typedef struct td_piece {
    thud_pos p, q;
    bool round;     /* the upper half of the circle about `touch`, or else straight */
    bool at_vertex; /* the ground is touched at `touch`, or else at `touch` from the centre */
    thud_pos touch;
    double radius;
} td_piece;

td_grown td_grown_by(const thud_terrain *terrain, const thud_shape_instance *shape,
                     thud_pos offset);
td_grown td_grown_mirrored(const td_grown *grown);

/* Where the ground's vertex stands. */
thud_pos td_grown_vertex(const td_grown *grown, int vertex);

/* The vertices whose pieces may lie over [x_min, x_max], and some more. */
void td_grown_vertices(const td_grown *grown, double x_min, double x_max, int *first, int *last);

/* A piece of flat ground's line, shifted, 1 wide. */
td_piece td_grown_line(const td_grown *grown);

/* Piece 0 to TD_PIECES - 1 of a vertex. False if there is none, or it is upright: then the next one
 * covers its place. */
bool td_grown_piece(const td_grown *grown, int vertex, int part, td_piece *out);

/* The highest piece over x, or the first that is `enough` high; of equal ones the one that goes on
 * furthest. */
bool td_grown_highest(const td_grown *grown, double x, double enough, td_piece *out,
                      double *height);

double td_piece_height(const td_piece *piece, double x);

/* Rise over run, without a sign. */
double td_piece_steepness(const td_piece *piece, double x);

/* The unit normal, out of the ground, at a place of the piece. */
thud_pos td_piece_normal(const td_piece *piece, thud_pos at);

#endif
