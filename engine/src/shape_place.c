/* shape_place.c: where shapes stand, from their body's pose, and the bounds that follow. */
#include "body.h"
#include "shape.h"

void td_shape_settle(thud_world *w, int index)
{
    td_shape *shape = td_shape_at(w, index);
    const td_body *body = td_body_at(w, shape->body);
    float *size = td_row(&w->size, index);
    size[0] = shape->half_x;
    size[1] = shape->half_y;
    size[2] = shape->x - body->center_x;
    size[3] = shape->y - body->center_y;
    shape->plain = size[2] == 0.0f && size[3] == 0.0f && (shape->kind != THUD_OBB || !shape->angle);
}

void td_shape_mark_moved(thud_world *w, int index)
{
    td_shape *shape = td_shape_at(w, index);
    if (!(shape->flags & TD_SHAPE_MOVED)) {
        *(td_bounds *)td_at(&w->was, index) = *td_fat_at(w, index);
        shape->flags |= TD_SHAPE_MOVED;
        td_push_int(&w->moved, index);
    }
}

static int32_t coarse_length(const thud_world *w, float length)
{
    return (int32_t)((double)length * w->to_coarse) + 1;
}

static int32_t margin_of(const thud_world *w, float half_x, float half_y)
{
    float extent = td_max_float(half_x, half_y);
    float more = td_min_float(TD_MARGIN_MORE * w->unit, extent * 0.125f);
    return coarse_length(w, TD_MARGIN * w->unit + more);
}

static void bound(thud_world *w, int index, td_shape *shape, const float *turn)
{
    float hx = shape->half_x, hy = shape->half_y;
    if (shape->kind == THUD_CIRCLE) {
        hy = hx;
    } else if (shape->kind == THUD_OBB) {
        float c = turn[2] < 0.0f ? -turn[2] : turn[2], s = turn[3] < 0.0f ? -turn[3] : turn[3];
        float x = c * hx + s * hy;
        hy = s * hx + c * hy;
        hx = x;
    }
    td_bounds tight = td_bounds_about(*(td_place *)td_at(&w->center, index),
                                      coarse_length(w, hx), coarse_length(w, hy));
    td_bounds *fat = td_fat_at(w, index);
    if ((shape->flags & TD_SHAPE_FRESH) || !td_bounds_contain(fat, &tight)) {
        td_shape_mark_moved(w, index);
        *fat = td_bounds_grown(tight, margin_of(w, hx, hy));
    }
}

void td_shape_place(thud_world *w, int index)
{
    td_shape *shape = td_shape_at(w, index);
    const td_pose *pose = td_pose_at(w, shape->body);
    td_place *center = td_at(&w->center, index);
    float *turn = td_row(&w->turn, index);
    *center = pose->center;
    if (shape->plain) {
        turn[0] = turn[1] = 0.0f;
        turn[2] = shape->kind == THUD_AABB ? 1.0f : pose->c;
        turn[3] = shape->kind == THUD_AABB ? 0.0f : pose->s;
    } else {
        const float *size = td_row(&w->size, index);
        turn[0] = pose->c * size[2] - pose->s * size[3];
        turn[1] = pose->s * size[2] + pose->c * size[3];
        turn[2] = pose->c * shape->angle_c - pose->s * shape->angle_s;
        turn[3] = pose->s * shape->angle_c + pose->c * shape->angle_s;
        center->x += td_length_from(w, turn[0]);
        center->y += td_length_from(w, turn[1]);
    }
    if (shape->kind == THUD_TERRAIN) {
        td_shape_mark_moved(w, index);
    } else {
        bound(w, index, shape, turn);
    }
}

void td_body_place_shapes(thud_world *w, int body)
{
    for (int i = td_body_at(w, body)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_place(w, i);
    }
}

thud_placed td_shape_placed(const thud_world *w, int index, td_place origin)
{
    const td_shape *shape = td_shape_at(w, index);
    const td_place *center = td_at(&w->center, index);
    const float *turn = td_row(&w->turn, index);
    bool turned = shape->kind == THUD_OBB;
    return (thud_placed){.kind = (thud_shape_kind)shape->kind,
                         .x = (double)(center->x - origin.x) / w->to_fixed,
                         .y = (double)(center->y - origin.y) / w->to_fixed,
                         .c = turned ? (double)turn[2] : 1.0,
                         .s = turned ? (double)turn[3] : 0.0,
                         .hx = (double)shape->half_x,
                         .hy = (double)shape->half_y};
}

/* ---- terrain segments under bounds ---- */

/* Bounds relative to the terrain's origin, in the caller's unit; a quantum wider, so that rounding
 * loses nothing. */
static void local_bounds(const thud_world *w, int terrain_shape, td_place at, const td_bounds *b,
                         double *min_x, double *max_x, double *min_y)
{
    const td_place *origin = td_at(&w->center, terrain_shape);
    int64_t x = origin->x >> TD_COARSE_SHIFT, y = origin->y >> TD_COARSE_SHIFT;
    *min_x = (double)(td_unwrap(b->min_x, at.x) - x - 1) / w->to_coarse;
    *max_x = (double)(td_unwrap(b->max_x, at.x) - x + 1) / w->to_coarse;
    *min_y = (double)(td_unwrap(b->min_y, at.y) - y - 1) / w->to_coarse;
}

void td_terrain_segments_of(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                            td_place near_place, const td_bounds *bounds, int *first, int *last)
{
    double min_x, max_x, min_y;
    local_bounds(w, terrain_shape, near_place, bounds, &min_x, &max_x, &min_y);
    thud_terrain_segments(terrain, min_x, max_x, first, last);
}

bool td_terrain_reaches(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                        td_place near_place, const td_bounds *bounds, int segment)
{
    double min_x, max_x, min_y;
    local_bounds(w, terrain_shape, near_place, bounds, &min_x, &max_x, &min_y);
    if (terrain->kind == THUD_TERRAIN_FLAT) {
        double left = terrain->slope * min_x, right = terrain->slope * max_x;
        return (left > right ? left : right) >= min_y;
    }
    const thud_pos *p = &terrain->points[segment], *q = p + 1;
    return p->x <= max_x && q->x >= min_x && (p->y > q->y ? p->y : q->y) >= min_y;
}
