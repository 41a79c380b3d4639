/* query_cast.c: what a point or a shape meets along a straight way. */
#include "api/query.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "terrain/terrain.h"

typedef struct path path;

/* Whether the point or the shape meets one of the world's shapes. Each path brings its own test, so
 * that a program that casts rays alone links no other. */
typedef bool meet_fn(const thud_world *w, int index, const path *way, thud_ray_hit *out);

struct path {
    meet_fn *meets;
    thud_pos origin;
    td_position from; /* the same */
    double dx, dy;
    const thud_shape_instance *shape; /* about the origin; null: a point */
    const thud_query_filter *filter;
    bool sensors; /* nothing else */
};

/* The nearest hits so far, in order. */
typedef struct kept {
    thud_ray_hit *hits;
    int capacity, count; /* count: of all */
} kept;

static bool before(const thud_ray_hit *a, const thud_ray_hit *b) {
    return a->fraction < b->fraction ||
           (a->fraction == b->fraction && a->shape.index1 < b->shape.index1);
}

static void keep(kept *k, const thud_ray_hit *hit) {
    int at = td_min_int(k->count++, k->capacity);
    if (at == k->capacity && (at == 0 || !before(hit, &k->hits[--at]))) {
        return;
    }
    for (; at > 0 && before(hit, &k->hits[at - 1]); at--) {
        k->hits[at] = k->hits[at - 1];
    }
    k->hits[at] = *hit;
}

/* ---- one shape ---- */

static bool point_meets(const thud_world *w, int index, const path *way, thud_ray_hit *out) {
    thud_shape_instance shape = td_query_instance(w, index, way->from);
    double nx = 0.0, ny = 0.0;
    bool hit;
    if (td_kind_is_line(shape.kind)) {
        thud_terrain terrain = td_terrain_view(w, index);
        hit = thud_terrain_cast_ray(&terrain, -shape.x, -shape.y, way->dx, way->dy, &out->fraction,
                                    &nx, &ny);
    } else {
        hit = thud_shape_cast_ray(&shape, 0.0, 0.0, way->dx, way->dy, &out->fraction, &nx, &ny);
    }
    out->point = (thud_pos){way->origin.x + out->fraction * way->dx,
                            way->origin.y + out->fraction * way->dy};
    out->normal = (thud_vec2){(float)nx, (float)ny};
    out->depth = 0.0;
    return hit;
}

/* How far back from where shapes meet their features are looked at, in sizes of the moving one:
 * where they touch exactly, the way from one to the other has no direction. */
#define LOOK_BACK 1e-7

static thud_pos gone(const path *way, double fraction) {
    double length = __builtin_sqrt(way->dx * way->dx + way->dy * way->dy);
    double before = length > 0.0 ? fraction - LOOK_BACK * td_reach(way->shape) / length : 0.0;
    before = before > 0.0 ? before : 0.0;
    return (thud_pos){before * way->dx, before * way->dy};
}

/* When the moving shape meets `still`, and the closest features then, from `still`. */
static bool meets_solid(const thud_shape_instance *still, const path *way, double *fraction,
                        thud_closest *c) {
    thud_shape_instance moving = *way->shape;
    td_closest(still, &moving, c);
    if (c->distance <= 0.0) {
        *fraction = 0.0;
        return true;
    }
    bool hit;
    td_time_of_impact(&moving, (thud_motion){way->dx, way->dy, 0.0}, still, (thud_motion){0}, 0.0,
                      &hit, fraction);
    if (hit) {
        thud_pos moved = gone(way, *fraction);
        moving.x += moved.x;
        moving.y += moved.y;
        td_closest(still, &moving, c);
    }
    return hit;
}

/* The same for ground whose origin is at (x, y). */
static bool meets_ground(const thud_terrain *terrain, double x, double y, const path *way,
                         double *fraction, thud_closest *c) {
    thud_shape_instance moving = *way->shape;
    moving.x -= x;
    moving.y -= y;
    bool hit;
    thud_result result =
        thud_terrain_time_of_impact(terrain, &moving, (thud_motion){way->dx, way->dy, 0.0}, 0.0,
                                    &hit, fraction);
    if (result != THUD_OK || !hit) {
        return false;
    }
    thud_pos moved = gone(way, *fraction);
    td_terrain_closest(terrain, &moving, moved, c);
    c->ax += way->shape->x + moved.x;
    c->ay += way->shape->y + moved.y;
    return true;
}

static bool shape_meets(const thud_world *w, int index, const path *way, thud_ray_hit *out) {
    thud_shape_instance shape = td_query_instance(w, index, way->from);
    thud_closest c;
    if (td_kind_is_line(shape.kind)) {
        thud_terrain terrain = td_terrain_view(w, index);
        if (!meets_ground(&terrain, shape.x, shape.y, way, &out->fraction, &c)) {
            return false;
        }
    } else if (!meets_solid(&shape, way, &out->fraction, &c)) {
        return false;
    }
    out->point = (thud_pos){way->origin.x + c.ax, way->origin.y + c.ay};
    out->normal = (thud_vec2){(float)c.nx, (float)c.ny};
    out->depth = out->fraction == 0.0 && c.distance < 0.0 ? -c.distance : 0.0;
    return true;
}

/* ---- all that come into question ---- */

/* Keeps what is met among the candidates at a fraction in (after, until]. */
static void keep_met(const thud_world *w, const path *way, double after, double until, kept *k) {
    for (int i = 0; i < w->scratch.hits.count; i++) {
        int index = td_int_at(&w->scratch.hits, i);
        thud_ray_hit hit;
        if (td_query_passes(w, index, way->filter) &&
            (!way->sensors || td_shape_at(w, index)->flags & TD_SHAPE_SENSOR) &&
            way->meets(w, index, way, &hit) && hit.fraction > after && hit.fraction <= until) {
            hit.shape = td_shape_handle(w, index);
            keep(k, &hit);
        }
    }
}

/* The bounding box of a piece of the way. */
static bool list_piece(thud_world *w, const path *way, double from, double to) {
    thud_pos lower = way->origin, upper = way->origin;
    if (way->shape) {
        td_query_bounds(way->origin, way->shape, &lower, &upper);
    }
    double x0 = from * way->dx, x1 = to * way->dx, y0 = from * way->dy, y1 = to * way->dy;
    lower.x += x0 < x1 ? x0 : x1;
    lower.y += y0 < y1 ? y0 : y1;
    upper.x += x0 < x1 ? x1 : x0;
    upper.y += y0 < y1 ? y1 : y0;
    return td_query_list(w, lower, upper);
}

/* A long way is gone piece by piece, since the bounding box of a slanting one is nearly all off the
 * way: pieces grow while they meet few candidates, and shrink while they meet many. A hit counts in
 * the piece in which it lies. `first`: the nearest hit is enough. */
enum { FEW = 8, MANY = 32, MOST_PIECES = 256 };

static bool cast(thud_world *w, const path *way, bool first, kept *k) {
    if (!td_query_prepare(w)) {
        return false;
    }
    w->scratch.hits.count = 0;
    if (!td_query_list_terrains(w)) {
        return false;
    }
    keep_met(w, way, -1.0, 1.0, k);
    double length = __builtin_sqrt(way->dx * way->dx + way->dy * way->dy);
    double piece = length > 8.0 * (double)w->unit ? 8.0 * (double)w->unit / length : 1.0;
    double least = 1.0 / MOST_PIECES;
    for (double done = -1.0; done < 1.0;) {
        double from = done > 0.0 ? done : 0.0, to = from + td_max_double(piece, least);
        to = to < 1.0 ? to : 1.0;
        if (!list_piece(w, way, from, to)) {
            return false;
        }
        keep_met(w, way, done, to, k);
        if (first && k->count && k->hits[0].fraction <= to) {
            break;
        }
        int met = w->scratch.hits.count;
        piece = met < FEW ? 2.0 * piece : met > MANY ? 0.5 * piece : piece;
        done = to;
    }
    return true;
}

static bool way_in_range(const thud_world *w, const path *way) {
    return td_place_valid(w, way->origin.x, way->origin.y) &&
           td_place_valid(w, way->origin.x + way->dx, way->origin.y + way->dy);
}

static thud_result cast_first(thud_world *w, path *way, bool *hit, thud_ray_hit *out) {
    thud_ray_hit nearest;
    kept k = {&nearest, 1, 0};
    way->from = td_place_from(w, way->origin);
    if (!cast(w, way, true, &k)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    if (hit) {
        *hit = k.count > 0;
    }
    if (out && k.count > 0) {
        *out = nearest;
    }
    return THUD_OK;
}

static thud_result cast_all(thud_world *w, path *way, thud_ray_hit *out, int capacity, int *count) {
    kept k = {out, capacity, 0};
    way->from = td_place_from(w, way->origin);
    if (!cast(w, way, false, &k)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "cast: out of memory");
    }
    if (count) {
        *count = k.count;
    }
    return THUD_OK;
}

/* ---- what callers ask ---- */

static thud_result check_ray(const thud_world *w, const path *way) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    return way_in_range(w, way)
               ? THUD_OK
               : td_refuse(w, THUD_ERROR_INVALID, "cast ray: not finite or out of range");
}

static thud_result check_shape(const thud_world *w, const path *way) {
    if (!w || !way->shape) {
        return td_refuse(w, THUD_ERROR_NULL, "cast: world or shape is null");
    }
    if (td_query_check(w, way->origin, way->shape) != THUD_OK || !way_in_range(w, way)) {
        return td_refuse(w, THUD_ERROR_INVALID, "cast: the shape or its way is invalid");
    }
    return THUD_OK;
}

static thud_result check_room(const thud_world *w, const thud_ray_hit *out, int capacity) {
    if (capacity < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "cast: capacity is negative");
    }
    return out || capacity == 0 ? THUD_OK
                                : td_refuse(w, THUD_ERROR_NULL, "cast: no room for the hits");
}

thud_result thud_world_cast_ray(thud_world *w, thud_pos origin, double dx, double dy,
                                const thud_query_filter *filter, bool *hit, thud_ray_hit *out) {
    TD_IN_OWN_MODE;
    path way = {point_meets, origin, .dx = dx, .dy = dy, .filter = filter};
    thud_result result = check_ray(w, &way);
    return result != THUD_OK ? result : cast_first(w, &way, hit, out);
}

thud_result thud_world_cast_ray_all(thud_world *w, thud_pos origin, double dx, double dy,
                                    const thud_query_filter *filter, thud_ray_hit *out,
                                    int capacity, int *count) {
    TD_IN_OWN_MODE;
    path way = {point_meets, origin, .dx = dx, .dy = dy, .filter = filter};
    thud_result result = check_ray(w, &way);
    result = result != THUD_OK ? result : check_room(w, out, capacity);
    return result != THUD_OK ? result : cast_all(w, &way, out, capacity, count);
}

thud_result thud_world_cast_shape(thud_world *w, thud_pos center, const thud_shape_instance *shape,
                                  double dx, double dy, const thud_query_filter *filter, bool *hit,
                                  thud_ray_hit *out) {
    TD_IN_OWN_MODE;
    path way = {shape_meets, center, .dx = dx, .dy = dy, .shape = shape, .filter = filter};
    thud_result result = check_shape(w, &way);
    return result != THUD_OK ? result : cast_first(w, &way, hit, out);
}

thud_result td_query_cast_sensors(thud_world *w, thud_pos center, const thud_shape_instance *shape,
                                  double dx, double dy, const thud_query_filter *filter,
                                  thud_ray_hit *out, int capacity, int *count) {
    path way = {shape_meets,    center,           .dx = dx,       .dy = dy,
                .shape = shape, .filter = filter, .sensors = true};
    thud_result result = check_shape(w, &way);
    return result != THUD_OK ? result : cast_all(w, &way, out, capacity, count);
}

thud_result thud_world_cast_shape_all(thud_world *w, thud_pos center,
                                      const thud_shape_instance *shape, double dx, double dy,
                                      const thud_query_filter *filter, thud_ray_hit *out,
                                      int capacity, int *count) {
    TD_IN_OWN_MODE;
    path way = {shape_meets, center, .dx = dx, .dy = dy, .shape = shape, .filter = filter};
    thud_result result = check_shape(w, &way);
    result = result != THUD_OK ? result : check_room(w, out, capacity);
    return result != THUD_OK ? result : cast_all(w, &way, out, capacity, count);
}

thud_result thud_world_cast_circle(thud_world *w, thud_pos center, double radius, double dx,
                                   double dy, const thud_query_filter *filter, bool *hit,
                                   thud_ray_hit *out) {
    thud_shape_instance circle = {.kind = THUD_CIRCLE, .c = 1.0, .hx = radius};
    return thud_world_cast_shape(w, center, &circle, dx, dy, filter, hit, out);
}

thud_result thud_world_cast_circle_all(thud_world *w, thud_pos center, double radius, double dx,
                                       double dy, const thud_query_filter *filter,
                                       thud_ray_hit *out, int capacity, int *count) {
    thud_shape_instance circle = {.kind = THUD_CIRCLE, .c = 1.0, .hx = radius};
    return thud_world_cast_shape_all(w, center, &circle, dx, dy, filter, out, capacity, count);
}

thud_result thud_world_cast_box(thud_world *w, thud_pos center, double half_x, double half_y,
                                double angle, double dx, double dy, const thud_query_filter *filter,
                                bool *hit, thud_ray_hit *out) {
    TD_IN_OWN_MODE;
    thud_shape_instance box = td_query_box(half_x, half_y, angle);
    return thud_world_cast_shape(w, center, &box, dx, dy, filter, hit, out);
}

thud_result thud_world_cast_box_all(thud_world *w, thud_pos center, double half_x, double half_y,
                                    double angle, double dx, double dy,
                                    const thud_query_filter *filter, thud_ray_hit *out,
                                    int capacity, int *count) {
    TD_IN_OWN_MODE;
    thud_shape_instance box = td_query_box(half_x, half_y, angle);
    return thud_world_cast_shape_all(w, center, &box, dx, dy, filter, out, capacity, count);
}
