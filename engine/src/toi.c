/* toi.c: time of impact. Shapes that do not turn meet where their path enters their Minkowski sum,
 * in closed form. Turning ones meet by conservative advancement (Mirtich 1996): along the present
 * closest normal the shapes cannot meet before they have closed their distance at the fastest rate
 * that their motion allows, so time may safely jump that far. The jump is exact for motion along
 * the normal, and never goes past an impact. */
#include "minkowski.h"

enum { MAX_JUMPS = 200 };

/* How fast turning may move a point of the shape. */
static double turning(const thud_placed *shape, const thud_motion *m)
{
    if (shape->kind != THUD_OBB) {
        return 0.0;
    }
    return td_abs(m->turn) * __builtin_sqrt(shape->hx * shape->hx + shape->hy * shape->hy);
}

/* In closed form: the second centre is a point that enters the sum of both shapes. */
static void translating(const thud_placed *a, const thud_motion *ma, const thud_placed *b,
                        const thud_motion *mb, double target, bool *hit, double *time)
{
    double x = b->x - a->x, y = b->y - a->y, nx, ny;
    thud_minkowski sum;
    td_minkowski_sum(a, b, &sum);
    sum.radius += target;
    *time = 0.0;
    *hit = td_minkowski_contains(&sum, x, y);
    if (!*hit) {
        *time = 1.0;
        *hit = td_minkowski_enter(&sum, x, y, mb->dx - ma->dx, mb->dy - ma->dy, time, &nx, &ny);
    }
}

/* The distance at which shapes count as met: far below what anyone sees, above the rounding of
 * their places. */
static double tolerance_of(const thud_placed *a, const thud_motion *ma, const thud_placed *b,
                           const thud_motion *mb)
{
    double size = td_reach(a) + td_reach(b);
    double place = td_abs(a->x) + td_abs(a->y) + td_abs(b->x) + td_abs(b->y) + td_abs(ma->dx) +
                   td_abs(ma->dy) + td_abs(mb->dx) + td_abs(mb->dy);
    return 1e-10 * size + 1e-15 * place;
}

void td_time_of_near_impact(const thud_placed *a, thud_motion ma, const thud_placed *b,
                            thud_motion mb, double target, double tolerance, bool *hit,
                            double *time)
{
    double spin = turning(a, &ma) + turning(b, &mb);
    if (spin == 0.0 && target >= 0.0) {
        translating(a, &ma, b, &mb, target, hit, time);
        return;
    }
    tolerance = td_max_double(tolerance, tolerance_of(a, &ma, b, &mb));
    double t = 0.0;
    *hit = false;
    *time = 1.0;
    for (int i = 0; i < MAX_JUMPS; i++) {
        thud_placed pa = td_placed_at(a, &ma, t), pb = td_placed_at(b, &mb, t);
        thud_closest closest;
        td_closest(&pa, &pb, &closest);
        double gap = closest.distance - target;
        if (gap <= tolerance) {
            break;
        }
        double closing = (ma.dx - mb.dx) * closest.nx + (ma.dy - mb.dy) * closest.ny + spin;
        if (!(closing > 0.0) || t + gap / closing > 1.0) {
            return;
        }
        t += gap / closing;
    }
    /* Out of jumps: they are almost there, and this time is still before the impact. */
    *hit = true;
    *time = t;
}

void td_time_of_impact(const thud_placed *a, thud_motion ma, const thud_placed *b, thud_motion mb,
                       double target, bool *hit, double *time)
{
    td_time_of_near_impact(a, ma, b, mb, target, 0.0, hit, time);
}

thud_result thud_shapes_time_of_impact(const thud_placed *a, thud_motion motion_a,
                                       const thud_placed *b, thud_motion motion_b, double target,
                                       bool *hit, double *time)
{
    if (!a || !b || !hit || !time) {
        return THUD_ERROR_NULL;
    }
    if (thud_placed_check(a) != THUD_OK || thud_placed_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b) || !(target >= 0.0 && target <= 1e15)) {
        return THUD_ERROR_INVALID;
    }
    td_time_of_impact(a, motion_a, b, motion_b, target, hit, time);
    return THUD_OK;
}
