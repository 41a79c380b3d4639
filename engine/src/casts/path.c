/* path.c: one path against one shape: a ray (td_point_meets) by the ray casts of geometry, a moving
 * shape (td_shape_meets) by the time of impact, then the closest features at that time. All
 * coordinates are relative to the path's origin. */
#include "casts/path.h"

#include "state/handles.h"
#include "state/shape.h"
#include "terrain/terrain.h"

thud_result td_path_check(const thud_world *w, const td_path *way) {
    thud_pos from = way->origin, to = {from.x + way->dx, from.y + way->dy};
    thud_result result = td_check_place(w, "cast: x or y of the origin", from.x, from.y);
    if (result == THUD_OK) {
        result = td_check_place(w, "cast: x or y of the way's end", to.x, to.y);
    }
    return result == THUD_OK ? td_query_check_filter(w, way->filter) : result;
}

void td_nearest_keep(td_nearest *k, const thud_ray_hit *hit) {
    int at = td_min_int(k->count++, k->capacity);
    if (at == k->capacity && (at == 0 || !td_hit_before(hit, &k->hits[--at]))) {
        return;
    }
    for (; at > 0 && td_hit_before(hit, &k->hits[at - 1]); at--) {
        k->hits[at] = k->hits[at - 1];
    }
    k->hits[at] = *hit;
}

/* ---- one shape ---- */

bool td_point_meets(const thud_world *w, int index, const td_path *way, thud_ray_hit *out) {
    thud_geometry shape = td_query_instance(w, index, way->from);
    double nx = 0.0, ny = 0.0;
    bool hit;
    if (td_kind_is_line(shape.kind)) {
        thud_terrain terrain = td_terrain_view(w, index);
        hit = thud_terrain_cast_ray(&terrain, (thud_segment){-shape.x, -shape.y, way->dx, way->dy},
                                    &out->fraction, &nx, &ny);
    } else {
        hit = thud_geometry_cast_ray(&shape, (thud_segment){0.0, 0.0, way->dx, way->dy},
                                     &out->fraction, &nx, &ny);
    }
    out->point = (thud_pos){way->origin.x + out->fraction * way->dx,
                            way->origin.y + out->fraction * way->dy};
    out->normal = (thud_vec2){(float)nx, (float)ny};
    out->depth = 0.0;
    return hit;
}

/* The closest features at an impact are computed this far before it, in extents of the moving
 * shape: where shapes touch exactly the vector between them is zero and has no direction. Chosen:
 * about 10^9 times the rounding error of double precision, and too little to change a normal
 * visibly. */
#define LOOK_BACK 1e-7

/* The displacement at a fraction of the path, less LOOK_BACK. */
static thud_pos displacement_before(const td_path *way, double fraction) {
    double length = __builtin_sqrt(way->dx * way->dx + way->dy * way->dy);
    double before = length > 0.0 ? fraction - LOOK_BACK * td_reach(way->shape) / length : 0.0;
    before = before > 0.0 ? before : 0.0;
    return (thud_pos){before * way->dx, before * way->dy};
}

/* Whether the moving shape meets the shape `still`; the fraction of the path at the impact, and the
 * closest features there, from `still` to the moving shape. Shapes that overlap at the start meet
 * at 0. */
static bool meets_solid(const thud_geometry *still, const td_path *way, double *fraction,
                        thud_closest *c) {
    thud_geometry moving = *way->shape;
    td_closest(still, &moving, c);
    if (c->distance <= 0.0) {
        *fraction = 0.0;
        return true;
    }
    bool hit;
    td_time_of_impact(&moving, (thud_motion){way->dx, way->dy, 0.0}, still, (thud_motion){0}, 0.0,
                      &hit, fraction);
    if (hit) {
        thud_pos moved = displacement_before(way, *fraction);
        moving.x += moved.x;
        moving.y += moved.y;
        td_closest(still, &moving, c);
    }
    return hit;
}

/* As meets_solid, for a terrain whose origin is at (x, y). */
static bool meets_ground(const thud_terrain *terrain, double x, double y, const td_path *way,
                         double *fraction, thud_closest *c) {
    thud_geometry moving = *way->shape;
    moving.x -= x;
    moving.y -= y;
    bool hit;
    thud_result result =
        thud_terrain_time_of_impact(terrain, &moving, (thud_motion){way->dx, way->dy, 0.0}, 0.0,
                                    &hit, fraction);
    if (result != THUD_OK || !hit) {
        return false;
    }
    thud_pos moved = displacement_before(way, *fraction);
    td_terrain_closest(terrain, &moving, moved, c);
    c->ax += way->shape->x + moved.x;
    c->ay += way->shape->y + moved.y;
    return true;
}

bool td_shape_meets(const thud_world *w, int index, const td_path *way, thud_ray_hit *out) {
    thud_geometry shape = td_query_instance(w, index, way->from);
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
