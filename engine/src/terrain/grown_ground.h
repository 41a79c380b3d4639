/* grown_ground.h: the Minkowski sum of a terrain and the reflection of a shape ("grown ground"):
 * the set of positions of the shape's centre at which the shape touches or overlaps the ground (its
 * configuration-space obstacle: Lozano-Perez, "Spatial Planning", 1983). The signed distance of the
 * shape from the ground equals that of its centre from the outline of the grown ground.
 *
 * The grown ground of a line is again a line with one height for each x. Its height at x is the
 * maximum of the heights of all *pieces* over x:
 * - for each segment of the terrain, the segment, minus the point of the shape (relative to its
 * centre) that would touch it;
 * - for each vertex, the shape's underside, turned upside down: the upper half of a circle, or two
 *   edges of a box.
 *
 * A flat terrain has no vertices, and one piece: the whole line. All coordinates are relative to
 * the shape's centre, so that precision does not depend on the distance from the origin. */
#ifndef TD_GROWN_GROUND_H
#define TD_GROWN_GROUND_H

#include "terrain/terrain.h"

/* Pieces of a vertex: up to two of the shape's underside (parts 0 and 1), and the segment that
 * begins at the vertex (part 2). */
enum { TD_PIECES = 3 };

/* A terrain and the shape by which it is grown. */
typedef struct td_grown {
    const thud_terrain *terrain;
    const thud_geometry *shape;
    thud_pos offset;   /* added to the position of `shape` */
    thud_pos under[3]; /* leftmost, lowest and rightmost point of the shape, from its centre */
    double radius;     /* of a circle; else 0 */
    bool mirrored;     /* x is negated, so that vertices are numbered from the right */
} td_grown;

/* A piece of the outline, from its left end p to its right end q. */
typedef struct td_piece {
    thud_pos p, q;
    bool round;     /* the upper half of the circle about `touch`; false: a straight line */
    bool at_vertex; /* true: when the shape's centre is on the piece, the shape touches the ground
                       at the fixed point `touch` (a vertex); false: at `touch` relative to the
                       centre */
    thud_pos touch;
    double radius; /* if `round` */
} td_piece;

/* The grown ground for a shape moved by `offset`. */
td_grown td_grown_by(const thud_terrain *terrain, const thud_geometry *shape, thud_pos offset);
/* The grown ground reflected at the y axis: left and right are exchanged. */
td_grown td_grown_mirrored(const td_grown *grown);

/* A vertex of the terrain, not of a flat one, relative to the shape's centre. */
thud_pos td_grown_vertex(const td_grown *grown, int vertex);

/* The range of vertices whose pieces may lie over [x_min, x_max]; the range may contain a few
 * others. */
void td_grown_vertices(const td_grown *grown, double x_min, double x_max, int *first, int *last);

/* The piece of a flat terrain: a part of its shifted line, from x = 0 to x = 1. */
td_piece td_grown_line(const td_grown *grown);

/* Piece 0 to TD_PIECES - 1 of a vertex. False if there is none, or if it is vertical: the next
 * piece then covers its x. */
bool td_grown_piece(const td_grown *grown, int vertex, int part, td_piece *out);

/* Finds the highest piece over x, and its height there; the search ends at the first piece that is
 * at least `enough` high. Of pieces of equal height, it returns the one that ends furthest to the
 * right. False if no piece is over x. */
bool td_grown_highest(const td_grown *grown, double x, double enough, td_piece *out,
                      double *height);

/* The height of a piece at x. */
double td_piece_height(const td_piece *piece, double x);

/* The absolute slope of a piece at x, |dy/dx|. */
double td_piece_steepness(const td_piece *piece, double x);

/* The unit normal of a piece, out of the ground, at its point `at`. */
thud_pos td_piece_normal(const td_piece *piece, thud_pos at);

#endif
