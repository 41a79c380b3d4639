/* terrain.c: ground lines: lookups, rays, overlap and time of impact. */
#include "placed.h"

thud_result thud_terrain_check(const thud_terrain *t)
{
    if (!t) {
        return THUD_ERROR_NULL;
    }
    if (t->kind == THUD_TERRAIN_FLAT) {
        return t->slope >= -100.0 && t->slope <= 100.0 ? THUD_OK : THUD_ERROR_INVALID;
    }
    if (t->kind != THUD_TERRAIN_UNIFORM && t->kind != THUD_TERRAIN_IRREGULAR) {
        return THUD_ERROR_INVALID;
    }
    if (!t->points) {
        return THUD_ERROR_NULL;
    }
    bool uniform = t->kind == THUD_TERRAIN_UNIFORM;
    if (t->count < 2 || t->count > 100000000 ||
        (uniform && !(t->spacing > 0.0 && t->spacing <= 1e9 && td_abs(t->x0) <= 1e9))) {
        return THUD_ERROR_INVALID;
    }
    for (int i = 0; i < t->count; i++) {
        bool rises = uniform || i == 0 || t->points[i].x > t->points[i - 1].x;
        bool placed = uniform || td_abs(t->points[i].x) <= 1e9;
        if (!(td_abs(t->points[i].y) <= 1e9) || !placed || !rises) {
            return THUD_ERROR_INVALID;
        }
    }
    return THUD_OK;
}

static double x_of(const thud_terrain *t, int i)
{
    return t->kind == THUD_TERRAIN_UNIFORM ? t->x0 + i * t->spacing : t->points[i].x;
}

/* The segment whose half-open column holds x, which lies within the line. */
static int segment_at(const thud_terrain *t, double x)
{
    int low = 0, high = t->count - 2;
    if (t->kind == THUD_TERRAIN_UNIFORM) {
        double guess = (x - t->x0) / t->spacing;
        low = guess <= 0.0 ? 0 : guess >= (double)high ? high : (int)guess;
        /* The division may be off by one at a vertex. */
        if (low > 0 && x < x_of(t, low)) {
            low--;
        } else if (low < high && x >= x_of(t, low + 1)) {
            low++;
        }
        return low;
    }
    while (low < high) {
        int middle = low + (high - low + 1) / 2;
        if (x_of(t, middle) <= x) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

void td_terrain_ends(const thud_terrain *t, int segment, double x_min, double x_max, thud_pos *p,
                     thud_pos *q)
{
    if (t->kind == THUD_TERRAIN_FLAT) {
        *p = (thud_pos){x_min, t->slope * x_min};
        *q = (thud_pos){x_max, t->slope * x_max};
    } else {
        *p = (thud_pos){x_of(t, segment), t->points[segment].y};
        *q = (thud_pos){x_of(t, segment + 1), t->points[segment + 1].y};
    }
}

thud_placed td_terrain_box(thud_pos p, thud_pos q)
{
    double dx = q.x - p.x, dy = q.y - p.y, length = __builtin_sqrt(dx * dx + dy * dy);
    return (thud_placed){.kind = THUD_OBB, .x = p.x + 0.5 * dx, .y = p.y + 0.5 * dy,
                         .c = dx / length, .s = dy / length, .hx = 0.5 * length};
}

thud_result thud_terrain_sample_at(const thud_terrain *t, double x, thud_terrain_sample *out)
{
    if (!t || !out) {
        return THUD_ERROR_NULL;
    }
    if (!td_finite(x)) {
        return THUD_ERROR_INVALID;
    }
    double slope = t->slope;
    if (t->kind == THUD_TERRAIN_FLAT) {
        *out = (thud_terrain_sample){.height = slope * x, .weight = {1.0, 0.0}};
    } else {
        if (t->count < 2 || x < x_of(t, 0) || x > x_of(t, t->count - 1)) {
            return THUD_ERROR_INVALID;
        }
        int i = segment_at(t, x);
        double x0 = x_of(t, i), x1 = x_of(t, i + 1), y0 = t->points[i].y, y1 = t->points[i + 1].y;
        double weight = (x - x0) / (x1 - x0);
        slope = (y1 - y0) / (x1 - x0);
        *out = (thud_terrain_sample){.height = y0 + weight * (y1 - y0),
                                     .segment = i,
                                     .weight = {1.0 - weight, weight}};
    }
    double length = __builtin_sqrt(1.0 + slope * slope);
    out->nx = -slope / length;
    out->ny = 1.0 / length;
    return THUD_OK;
}

void thud_terrain_segments(const thud_terrain *t, double x_min, double x_max, int *first, int *last)
{
    *first = 0;
    *last = t->kind == THUD_TERRAIN_FLAT ? 0 : -1;
    if (t->kind != THUD_TERRAIN_FLAT && t->count >= 2 && x_max >= x_of(t, 0) &&
        x_min <= x_of(t, t->count - 1) && x_min <= x_max) {
        *first = segment_at(t, x_min);
        *last = segment_at(t, x_max);
        if (*first > 0 && x_min == x_of(t, *first)) {
            --*first; /* touches the end of the one before */
        }
    }
}

/* Signed distance above the segment's line at a point. */
static double above(thud_pos p, thud_pos q, double x, double y)
{
    return ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)) /
           __builtin_sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
}

bool thud_terrain_cast_ray(const thud_terrain *t, double ox, double oy, double dx, double dy,
                           double *fraction, double *nx, double *ny)
{
    if (!t || !td_finite(ox + oy + dx + dy)) {
        return false;
    }
    double x_min = dx < 0.0 ? ox + dx : ox, x_max = dx < 0.0 ? ox : ox + dx, best = 2.0;
    int first, last;
    thud_terrain_segments(t, x_min, x_max, &first, &last);
    for (int i = first; i <= last; i++) {
        thud_pos p, q;
        td_terrain_ends(t, i, x_min - 1.0, x_max + 1.0, &p, &q);
        double from = above(p, q, ox, oy), to = above(p, q, ox + dx, oy + dy);
        if (!(from >= 0.0 && to < 0.0)) {
            continue;
        }
        double f = from / (from - to), x = ox + f * dx;
        if (f < best && x >= p.x && x <= q.x) {
            double length = __builtin_sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
            best = f;
            if (nx) {
                *nx = -(q.y - p.y) / length;
            }
            if (ny) {
                *ny = (q.x - p.x) / length;
            }
        }
    }
    if (best <= 1.0 && fraction) {
        *fraction = best;
    }
    return best <= 1.0;
}

/* Half the width of the shape's bounding box. */
static double half_width(const thud_placed *s)
{
    return s->kind == THUD_CIRCLE ? s->hx : td_shadow(s, 1.0, 0.0);
}

static bool below(const thud_terrain *t, double x, double y)
{
    thud_terrain_sample sample;
    return thud_terrain_sample_at(t, x, &sample) == THUD_OK && y <= sample.height;
}

bool thud_terrain_overlap(const thud_terrain *t, const thud_placed *shape)
{
    if (!t || thud_placed_check(shape) != THUD_OK) {
        return false;
    }
    if (below(t, shape->x, shape->y)) {
        return true;
    }
    for (int i = 0; i < 4 && shape->kind != THUD_CIRCLE; i++) {
        double x, y;
        td_corner(shape, i, &x, &y);
        if (below(t, x, y)) {
            return true;
        }
    }
    int first, last;
    double half = half_width(shape);
    thud_terrain_segments(t, shape->x - half, shape->x + half, &first, &last);
    for (int i = first; i <= last; i++) {
        thud_pos p, q;
        thud_closest closest;
        td_terrain_ends(t, i, shape->x - 2.0 * half, shape->x + 2.0 * half, &p, &q);
        thud_placed box = td_terrain_box(p, q);
        td_closest(&box, shape, &closest);
        if (closest.distance <= 0.0) {
            return true;
        }
    }
    return false;
}

thud_result thud_terrain_time_of_impact(const thud_terrain *t, const thud_placed *shape,
                                        thud_motion motion, double target, bool *hit, double *time)
{
    if (!t || !shape || !hit || !time) {
        return THUD_ERROR_NULL;
    }
    if (thud_placed_check(shape) != THUD_OK || !td_finite(motion.dx + motion.dy + motion.turn) ||
        td_abs(motion.turn) > 1e6 || !(target >= 0.0 && target <= 1e15)) {
        return THUD_ERROR_INVALID;
    }
    *hit = thud_terrain_overlap(t, shape);
    *time = *hit ? 0.0 : 1.0;
    if (*hit) {
        return THUD_OK;
    }
    double reach = shape->hx + shape->hy + target;
    double x_min = shape->x - reach + (motion.dx < 0.0 ? motion.dx : 0.0);
    double x_max = shape->x + reach + (motion.dx > 0.0 ? motion.dx : 0.0);
    int first, last;
    thud_terrain_segments(t, x_min, x_max, &first, &last);
    for (int i = first; i <= last; i++) {
        thud_pos p, q;
        td_terrain_ends(t, i, x_min, x_max, &p, &q);
        thud_placed box = td_terrain_box(p, q);
        bool hit_here;
        double time_here;
        td_time_of_impact(shape, motion, &box, (thud_motion){0}, target, &hit_here, &time_here);
        if (hit_here && time_here < *time) {
            *hit = true;
            *time = time_here;
        }
    }
    return THUD_OK;
}
