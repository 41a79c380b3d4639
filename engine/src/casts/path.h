/* path.h: a path, the straight line along which a cast moves a point (a ray) or a shape; its test
 * against one shape; the nearest hits found so far; and the division of a long path into pieces. */
#ifndef TD_PATH_H
#define TD_PATH_H

#include "api/query.h"
#include "state/body.h"

typedef struct td_path td_path;

/* Whether the path meets the shape in slot `index`; if so, sets all fields of *out but `shape`. A
 * path has its test as a function pointer, so that a program that casts only rays does not link the
 * test of shapes. */
typedef bool td_meets_fn(const thud_world *w, int index, const td_path *way, thud_ray_hit *out);

struct td_path {
    td_meets_fn *meets;
    thud_pos origin;                 /* of the path, in the world */
    td_position from;                /* `origin` in fixed point */
    double dx, dy;                   /* the displacement from the origin to the end, length */
    const thud_geometry *shape;      /* the moving shape, about the origin; null: a point */
    const thud_query_filter *filter; /* null: everything but sensors */
    bool only_sensors;               /* the path passes through shapes that are no sensors */
};

td_meets_fn td_point_meets, td_shape_meets;

/* The nearest hits found so far, in the order of td_hit_before. */
typedef struct td_nearest {
    thud_ray_hit *hits;
    int capacity, count; /* room in `hits`; hits found, which may be more */
} td_nearest;

/* The order of hits: by fraction, and among equals by slot. */
static inline bool td_hit_before(const thud_ray_hit *a, const thud_ray_hit *b) {
    return a->fraction < b->fraction ||
           (a->fraction == b->fraction && a->shape.index1 < b->shape.index1);
}

/* Refuses a path whose origin or end is out of the world, or whose filter no shape can pass. */
thud_result td_path_check(const thud_world *w, const td_path *way);

/* Whether a shape passes the path's filter and the path meets it; if so, where. */
static inline bool td_path_meets(const thud_world *w, int index, const td_path *way,
                                 thud_ray_hit *hit) {
    return td_query_passes(w, index, way->filter) &&
           (!way->only_sensors || td_shape_at(w, index)->flags & TD_SHAPE_SENSOR) &&
           way->meets(w, index, way, hit);
}

/* Inserts a hit into the nearest hits, and counts it. */
void td_nearest_keep(td_nearest *k, const thud_ray_hit *hit);

/* The broadphase finds candidates by boxes, and the box of a long slanted path contains mostly
 * shapes far from it. So a path is searched in pieces: their length doubles while a piece has fewer
 * candidates than TD_PIECE_MIN, and halves while it has more than TD_PIECE_MAX. A hit counts in the
 * piece that contains its fraction. These numbers and the first length are chosen, not tuned; they
 * cost time, and do not change the hits. */
enum {
    TD_PIECE_MIN = 8,   /* candidates of a piece */
    TD_PIECE_MAX = 32,  /* candidates of a piece */
    TD_PIECES_MAX = 256 /* pieces of a path */
};

/* The length of the first piece, as a fraction of the path: eight length scales, or the whole path.
 */
static inline double td_piece_first(const thud_world *w, const td_path *way) {
    double length = __builtin_sqrt(way->dx * way->dx + way->dy * way->dy);
    return length > 8.0 * (double)w->length_scale ? 8.0 * (double)w->length_scale / length : 1.0;
}

/* The end of the piece that begins at `from`, both as fractions of the path. */
static inline double td_piece_end(double from, double piece) {
    double to = from + td_max_double(piece, 1.0 / TD_PIECES_MAX);
    return to < 1.0 ? to : 1.0;
}

/* The length of the piece after one of length `piece`, which had this many candidates. */
static inline double td_piece_next(double piece, int candidates) {
    return candidates < TD_PIECE_MIN   ? 2.0 * piece
           : candidates > TD_PIECE_MAX ? 0.5 * piece
                                       : piece;
}

/* The bounding box of the moving point or shape between the fractions `from` and `to`. */
static inline void td_piece_bounds(const td_path *way, double from, double to, thud_pos *lower,
                                   thud_pos *upper) {
    *lower = *upper = way->origin;
    if (way->shape) {
        td_query_bounds(way->origin, way->shape, lower, upper);
    }
    double x0 = from * way->dx, x1 = to * way->dx, y0 = from * way->dy, y1 = to * way->dy;
    lower->x += x0 < x1 ? x0 : x1;
    lower->y += y0 < y1 ? y0 : y1;
    upper->x += x0 < x1 ? x1 : x0;
    upper->y += y0 < y1 ? y1 : y0;
}

#endif
