/* ground.c: what the stages of a step ask of lines; plugged into a world with its first one. */
#include "broadphase/pairs.h"
#include "state/shape.h"

static bool overlap(const thud_world *w, int line, const thud_shape_instance *shape) {
    thud_terrain terrain = td_terrain_view(w, line);
    return thud_terrain_overlap(&terrain, shape);
}

static void time_of_impact(const thud_world *w, int line, const thud_shape_instance *shape,
                           thud_motion motion, bool *hit, double *time) {
    thud_terrain terrain = td_terrain_view(w, line);
    thud_terrain_time_of_impact(&terrain, shape, motion, 0.0, hit, time);
}

static thud_closest below(const thud_world *w, int line, const thud_shape_instance *shape) {
    thud_terrain terrain = td_terrain_view(w, line);
    thud_terrain_sample ground = {.height = shape->y, .ny = 1.0};
    thud_terrain_sample_at(&terrain, shape->x, &ground);
    return (thud_closest){.nx = ground.nx,
                          .ny = ground.ny,
                          .ax = shape->x,
                          .ay = ground.height,
                          .bx = shape->x,
                          .by = ground.height};
}

static bool near_sweep(const thud_world *w, int line, const td_swept *swept) {
    int first, last;
    if (swept->far) {
        return true;
    }
    if (td_terrain_below(w, line, swept->start, &swept->bounds)) {
        return false;
    }
    thud_terrain terrain = td_terrain_view(w, line);
    td_terrain_segments_of(w, line, &terrain, swept->start, &swept->bounds, &first, &last);
    while (first <= last &&
           !td_terrain_reaches(w, line, &terrain, swept->start, &swept->bounds, first)) {
        first++;
    }
    return first <= last;
}

static void sweep(const thud_world *w, int line, const td_swept *swept, td_swept_hit *hit) {
    if (!near_sweep(w, line, swept)) {
        return;
    }
    thud_terrain terrain = td_terrain_view(w, line);
    const td_position *origin = &td_shape_proxy_at(w, line)->center;
    double x = (double)(swept->start.x - origin->x) / w->to_fixed;
    double y = (double)(swept->start.y - origin->y) / w->to_fixed;
    thud_shape_instance placed = swept->placed;
    thud_motion motion = swept->motion;
    placed.x += x, placed.y += y;
    hit->inside = thud_terrain_overlap(&terrain, &placed);
    if (hit->inside) {
        placed = swept->core;
        placed.x += x, placed.y += y;
        motion.turn = 0.0;
    }
    thud_terrain_time_of_impact(&terrain, &placed, motion, 0.0, &hit->hit, &hit->time);
}

static bool reaches(const thud_world *w, int line, int shape, int segment) {
    thud_terrain terrain = td_terrain_view(w, line);
    const td_shape_proxy *proxy = td_shape_proxy_at(w, shape);
    return td_terrain_reaches(w, line, &terrain, proxy->center, &proxy->fat, segment);
}

static bool each(thud_world *w, int line, int shape,
                 bool (*visit)(thud_world *w, int shape, int line, int segment)) {
    thud_terrain terrain = td_terrain_view(w, line);
    td_position at = td_shape_proxy_at(w, shape)->center;
    const td_bounds *fat = td_fat_at(w, shape);
    int first, last;
    td_terrain_segments_of(w, line, &terrain, at, fat, &first, &last);
    bool done = true;
    for (int i = first; i <= last && done; i++) {
        done = !td_terrain_reaches(w, line, &terrain, at, fat, i) || visit(w, shape, line, i);
    }
    return done;
}

const td_ground_ops td_ground = {overlap, time_of_impact, below, near_sweep,
                                 sweep,   reaches,        each,  td_pairs_add_ground};
