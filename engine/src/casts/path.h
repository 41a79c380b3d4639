/* path.h: a straight way, and what a point or a shape meets on it. */
#ifndef TD_PATH_H
#define TD_PATH_H

#include "api/query.h"
#include "state/body.h"

typedef struct td_path td_path;

/* Whether the point or the shape meets one of the world's shapes. Each path brings its own test, so
 * that a program that casts rays alone links no other. Sets all of *out but the shape. */
typedef bool td_meets_fn(const thud_world *w, int index, const td_path *way, thud_ray_hit *out);

struct td_path {
    td_meets_fn *meets;
    thud_pos origin;
    td_position from; /* the same */
    double dx, dy;
    const thud_shape_instance *shape; /* about the origin; null: a point */
    const thud_query_filter *filter;
    bool sensors; /* nothing else */
};

td_meets_fn td_point_meets, td_shape_meets;

/* The nearest hits so far, in order. */
typedef struct td_nearest {
    thud_ray_hit *hits;
    int capacity, count; /* count: of all */
} td_nearest;

/* The order in which hits are told: the nearer first, and among equals the lower slot. */
static inline bool td_hit_before(const thud_ray_hit *a, const thud_ray_hit *b) {
    return a->fraction < b->fraction ||
           (a->fraction == b->fraction && a->shape.index1 < b->shape.index1);
}

/* Refuses a path whose origin or end is no place of the world, or whose filter meets nothing. */
thud_result td_path_check(const thud_world *w, const td_path *way);

/* Whether the path meets a shape at all that it is to meet, and where. */
static inline bool td_path_meets(const thud_world *w, int index, const td_path *way,
                                 thud_ray_hit *hit) {
    return td_query_passes(w, index, way->filter) &&
           (!way->sensors || td_shape_at(w, index)->flags & TD_SHAPE_SENSOR) &&
           way->meets(w, index, way, hit);
}

/* Puts a hit into its place among the nearest. */
void td_nearest_keep(td_nearest *k, const thud_ray_hit *hit);

/* A long way is gone piece by piece, since the bounding box of a slanting one is nearly all off the
 * way: pieces grow while they meet few candidates, and shrink while they meet many. A hit counts in
 * the piece in which it lies. */
enum { TD_PIECE_FEW = 8, TD_PIECE_MANY = 32, TD_PIECES = 256 };

/* The first piece of a path, as a fraction of it. */
static inline double td_piece_first(const thud_world *w, const td_path *way) {
    double length = __builtin_sqrt(way->dx * way->dx + way->dy * way->dy);
    return length > 8.0 * (double)w->unit ? 8.0 * (double)w->unit / length : 1.0;
}

/* Where the piece ends that begins at `from`. */
static inline double td_piece_end(double from, double piece) {
    double to = from + td_max_double(piece, 1.0 / TD_PIECES);
    return to < 1.0 ? to : 1.0;
}

/* The next piece, after one with so many candidates. */
static inline double td_piece_next(double piece, int met) {
    return met < TD_PIECE_FEW ? 2.0 * piece : met > TD_PIECE_MANY ? 0.5 * piece : piece;
}

/* The bounding box of a piece. */
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
