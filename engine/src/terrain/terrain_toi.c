/* terrain_toi.c: when a moving shape first meets the ground, and whether it is in it now.
 *
 * The ground is what lies on and below the line, between two upright sides under its ends. */
#include "terrain/grown_ground.h"

bool thud_terrain_overlap(const thud_terrain *t, const thud_shape_instance *shape) {
    if (td_terrain_readable(t) != THUD_OK || thud_placed_check(shape) != THUD_OK) {
        return false;
    }
    td_grown grown = td_grown_by(t, shape, (thud_pos){0.0, 0.0});
    td_piece top;
    double height;
    return td_grown_highest(&grown, 0.0, 0.0, &top, &height) && height >= 0.0;
}

/* The motion against a straight piece of the ground's outline, seen as a box without thickness. */
static void meet(const thud_shape_instance *shape, thud_motion motion, thud_pos p, thud_pos q,
                 double target, bool *hit, double *time) {
    double dx = q.x - p.x, dy = q.y - p.y, length = __builtin_sqrt(dx * dx + dy * dy);
    thud_shape_instance box = {.kind = THUD_OBB,
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

thud_result thud_terrain_time_of_impact(const thud_terrain *t, const thud_shape_instance *shape,
                                        thud_motion motion, double target, bool *hit,
                                        double *time) {
    if (!t || !shape || !hit || !time) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(t);
    if (readable != THUD_OK || thud_placed_check(shape) != THUD_OK || !td_motion_valid(motion) ||
        !td_target_valid(target)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    *hit = thud_terrain_overlap(t, shape);
    *time = *hit ? 0.0 : 1.0;
    if (*hit) {
        return THUD_OK;
    }
    /* Places are relative to the shape's: those far away are too coarse. */
    double reach = td_reach(shape) + target;
    double left = (motion.dx < 0.0 ? motion.dx : 0.0) - reach;
    double right = (motion.dx > 0.0 ? motion.dx : 0.0) + reach;
    double low = (motion.dy < 0.0 ? motion.dy : 0.0) - reach;
    thud_shape_instance here = *shape;
    here.x = here.y = 0.0;
    if (t->kind == THUD_TERRAIN_FLAT) {
        double height = t->slope * shape->x - shape->y;
        thud_pos p = {left, height + t->slope * left}, q = {right, height + t->slope * right};
        meet(&here, motion, p, q, target, hit, time);
        return THUD_OK;
    }
    int first, last;
    thud_terrain_segments(t, shape->x + left, shape->x + right, &first, &last);
    for (int i = first; i <= last; i++) {
        td_segment s = td_terrain_segment(t, i, 0.0, 0.0);
        thud_pos p = {s.p.x - shape->x, s.p.y - shape->y}, q = {s.q.x - shape->x, s.q.y - shape->y};
        meet(&here, motion, p, q, target, hit, time);
        if (i == 0 && low < p.y) {
            meet(&here, motion, (thud_pos){p.x, low}, p, target, hit, time);
        }
        if (i == t->count - 2 && low < q.y) {
            meet(&here, motion, q, (thud_pos){q.x, low}, target, hit, time);
        }
    }
    return THUD_OK;
}
