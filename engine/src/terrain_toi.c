/* terrain_toi.c: when a moving shape first meets the ground, and whether it is in it now.
 *
 * The ground is what lies on and below the line, between two upright sides under its ends. */
#include "terrain.h"

static bool below(const thud_terrain *t, double x, double y)
{
    thud_terrain_sample sample;
    return thud_terrain_sample_at(t, x, &sample) == THUD_OK && y <= sample.height;
}

/* Over a segment, the ground's height above the underside of a convex shape is greatest at an end
 * of the segment, or where the underside is parallel to it: at a corner of a box, at one point of a
 * circle. So the shape is in the ground if such a point is, or a vertex is above its underside. */
static bool vertex_in_circle(const thud_placed *circle, thud_pos v)
{
    double dx = v.x - circle->x, dy = v.y - circle->y;
    return td_abs(dx) <= circle->hx && (dy >= 0.0 || dx * dx + dy * dy <= circle->hx * circle->hx);
}

static bool vertex_in_box(const thud_placed *box, thud_pos v)
{
    double u, w, dx = v.x - box->x, dy = v.y - box->y;
    td_to_frame(box, dx, dy, &u, &w);
    /* Faces that look down: towards -u where the frame's first axis points up, and so on. */
    bool over_u = box->s > 0.0 ? u >= -box->hx : box->s < 0.0 ? u <= box->hx : true;
    bool over_w = box->c > 0.0 ? w >= -box->hy : box->c < 0.0 ? w <= box->hy : true;
    return td_abs(dx) <= td_half_width(box) && over_u && over_w;
}

static bool vertex_in(const thud_placed *shape, thud_pos v)
{
    return shape->kind == THUD_CIRCLE ? vertex_in_circle(shape, v) : vertex_in_box(shape, v);
}

/* The point of a circle that is deepest under the segment's line, if that is over the segment. */
static bool circle_under_line(const td_segment *s, const thud_placed *circle, bool endless)
{
    double x = circle->x + s->ty * circle->hx;
    bool here = endless || (x >= s->p.x && x <= s->q.x);
    return here && td_above(s, circle->x, circle->y) <= circle->hx;
}

bool thud_terrain_overlap(const thud_terrain *t, const thud_placed *shape)
{
    if (td_terrain_readable(t) != THUD_OK || thud_placed_check(shape) != THUD_OK) {
        return false;
    }
    for (int i = 0; i < 4 && shape->kind != THUD_CIRCLE; i++) {
        double x, y;
        td_corner(shape, i, &x, &y);
        if (below(t, x, y)) {
            return true;
        }
    }
    int first, last;
    double half = td_half_width(shape);
    bool flat = t->kind == THUD_TERRAIN_FLAT;
    thud_terrain_segments(t, shape->x - half, shape->x + half, &first, &last);
    for (int i = first; i <= last; i++) {
        td_segment s = td_terrain_segment(t, i, shape->x - half, shape->x + half);
        if (!flat && (vertex_in(shape, s.p) || vertex_in(shape, s.q))) {
            return true;
        }
        if (shape->kind == THUD_CIRCLE && circle_under_line(&s, shape, flat)) {
            return true;
        }
    }
    return false;
}

/* The motion against a straight piece of the ground's outline, seen as a box without thickness. */
static void meet(const thud_placed *shape, thud_motion motion, thud_pos p, thud_pos q,
                 double target, bool *hit, double *time)
{
    double dx = q.x - p.x, dy = q.y - p.y, length = __builtin_sqrt(dx * dx + dy * dy);
    thud_placed box = {.kind = THUD_OBB, .x = p.x + 0.5 * dx, .y = p.y + 0.5 * dy,
                       .c = dx / length, .s = dy / length, .hx = 0.5 * length};
    bool hit_here;
    double time_here;
    td_time_of_impact(shape, motion, &box, (thud_motion){0}, target, &hit_here, &time_here);
    if (hit_here && time_here < *time) {
        *time = time_here;
    }
    *hit = *hit || hit_here;
}

thud_result thud_terrain_time_of_impact(const thud_terrain *t, const thud_placed *shape,
                                        thud_motion motion, double target, bool *hit, double *time)
{
    if (!t || !shape || !hit || !time) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(t);
    if (readable != THUD_OK || thud_placed_check(shape) != THUD_OK ||
        !td_motion_valid(motion) ||
        !(target >= 0.0 && target <= 1e15)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    *hit = thud_terrain_overlap(t, shape);
    *time = *hit ? 0.0 : 1.0;
    if (*hit) {
        return THUD_OK;
    }
    double reach = td_reach(shape) + target;
    double x_min = shape->x - reach + (motion.dx < 0.0 ? motion.dx : 0.0);
    double x_max = shape->x + reach + (motion.dx > 0.0 ? motion.dx : 0.0);
    double y_min = shape->y - reach + (motion.dy < 0.0 ? motion.dy : 0.0);
    int first, last;
    thud_terrain_segments(t, x_min, x_max, &first, &last);
    for (int i = first; i <= last; i++) {
        td_segment s = td_terrain_segment(t, i, x_min, x_max);
        meet(shape, motion, s.p, s.q, target, hit, time);
        if (t->kind == THUD_TERRAIN_FLAT) {
            break;
        }
        if (i == 0 && y_min < s.p.y) {
            meet(shape, motion, (thud_pos){s.p.x, y_min}, s.p, target, hit, time);
        }
        if (i == t->count - 2 && y_min < s.q.y) {
            meet(shape, motion, s.q, (thud_pos){s.q.x, y_min}, target, hit, time);
        }
    }
    return THUD_OK;
}
