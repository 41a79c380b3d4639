/* terrain_toi.c: whether a shape overlaps a terrain, and the time of impact of a moving shape with
 * it.
 *
 * The ground is the area on and below the line, between the two vertical sides under its ends. Its
 * outline is a chain of straight edges; the time of impact is the earliest of those with each edge
 * as a box of thickness 0 (geometry/toi.c). */
#include "terrain/grown_ground.h"

/* As thud_terrain_overlap, for input known to be valid. */
static bool overlaps(const thud_terrain *t, const thud_geometry *shape) {
    td_grown grown = td_grown_by(t, shape, (thud_pos){0.0, 0.0});
    td_piece top;
    double height;
    return td_grown_highest(&grown, 0.0, 0.0, &top, &height) && height >= 0.0;
}

bool thud_terrain_overlap(const thud_terrain *t, const thud_geometry *shape) {
    return td_terrain_readable(t) == THUD_OK && thud_geometry_check(shape) == THUD_OK &&
           overlaps(t, shape);
}

/* If the motion has an impact with the edge from p to q, sets *hit, and *time to the earlier of its
 * value and the impact's time. */
static void impact_with_edge(const thud_geometry *shape, thud_motion motion, thud_pos p, thud_pos q,
                             double target, bool *hit, double *time) {
    double dx = q.x - p.x, dy = q.y - p.y, length = __builtin_sqrt(dx * dx + dy * dy);
    thud_geometry box = {.kind = THUD_SHAPE_OBB,
                         .x = p.x + 0.5 * dx,
                         .y = p.y + 0.5 * dy,
                         .c = dx / length,
                         .s = dy / length,
                         .hx = 0.5 * length};
    bool hit_here;
    double time_here;
    td_time_of_impact(shape, motion, &box, (thud_motion){0}, target, &hit_here, &time_here);
    if (hit_here && time_here < *time) {
        *time = time_here;
    }
    *hit = *hit || hit_here;
}

void td_terrain_time_of_impact(const thud_terrain *t, const thud_geometry *shape,
                               thud_motion motion, double target, bool *out_hit, double *out_time) {
    *out_hit = overlaps(t, shape);
    *out_time = *out_hit ? 0.0 : 1.0;
    if (*out_hit) {
        return;
    }
    /* Coordinates are relative to the shape's centre, so that no precision is lost far from the
     * origin. */
    double reach = td_reach(shape) + target;
    double left = (motion.dx < 0.0 ? motion.dx : 0.0) - reach;
    double right = (motion.dx > 0.0 ? motion.dx : 0.0) + reach;
    double low = (motion.dy < 0.0 ? motion.dy : 0.0) - reach;
    thud_geometry here = *shape;
    here.x = here.y = 0.0;
    if (t->kind == THUD_TERRAIN_FLAT) {
        double height = t->slope * shape->x - shape->y;
        thud_pos p = {left, height + t->slope * left}, q = {right, height + t->slope * right};
        impact_with_edge(&here, motion, p, q, target, out_hit, out_time);
        return;
    }
    int first, last;
    thud_terrain_segments(t, shape->x + left, shape->x + right, &first, &last);
    for (int i = first; i <= last; i++) {
        td_segment s = td_terrain_segment(t, i, 0.0, 0.0);
        thud_pos p = {s.p.x - shape->x, s.p.y - shape->y}, q = {s.q.x - shape->x, s.q.y - shape->y};
        impact_with_edge(&here, motion, p, q, target, out_hit, out_time);
        if (i == 0 && low < p.y) {
            impact_with_edge(&here, motion, (thud_pos){p.x, low}, p, target, out_hit, out_time);
        }
        if (i == t->count - 2 && low < q.y) {
            impact_with_edge(&here, motion, q, (thud_pos){q.x, low}, target, out_hit, out_time);
        }
    }
}

thud_result thud_terrain_time_of_impact(const thud_terrain *t, const thud_geometry *shape,
                                        thud_motion motion, double target, bool *out_hit,
                                        double *out_time) {
    if (!t || !shape || !out_hit || !out_time) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(t);
    if (readable != THUD_OK || thud_geometry_check(shape) != THUD_OK || !td_motion_valid(motion) ||
        !td_target_valid(target)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    td_terrain_time_of_impact(t, shape, motion, target, out_hit, out_time);
    return THUD_OK;
}
