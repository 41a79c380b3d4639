/* shape_place.c: computes the places of shapes from their bodies' poses, their tight and fat
 * bounds, and which terrain segments bounds reach. wide_finalize.c computes places and bounds for
 * the awake bodies of a step, eight at a time and with the same rounding. */
#include "state/body.h"
#include "state/shape.h"

#include "geometry/shape_instance.h"

/* The distance between tight and fat bounds, TD_MARGIN + min(TD_MARGIN_MORE, extent / 8), in bounds
 * quanta, rounded up. */
static int32_t margin_of(const thud_world *w, float half_x, float half_y) {
    float extent = td_max_float(half_x, half_y);
    float more = td_min_float(TD_MARGIN_MORE * w->length_scale, extent * 0.125f);
    return (int32_t)((double)(TD_MARGIN * w->length_scale + more) * w->to_coarse) + 1;
}

/* td_shape_settle for a given record and proxy. */
static void settle(const thud_world *w, td_shape *shape, td_shape_proxy *proxy) {
    const td_body *body = td_body_at(w, shape->body);
    shape->arm_x = shape->x - body->center_x;
    shape->arm_y = shape->y - body->center_y;
    bool offset = shape->arm_x != 0.0f || shape->arm_y != 0.0f || td_kind_is_line(shape->kind);
    shape->centred = offset ? 0 : shape->angle ? 1 : 2;
    proxy->half_x = shape->half_x;
    proxy->half_y =
        (float)td_kind_half_y(shape->kind, (double)shape->half_x, (double)shape->half_y);
    proxy->turns = !td_kind_turns(shape->kind) ? 0.0f : shape->angle ? 2.0f : 1.0f;
    proxy->margin = margin_of(w, proxy->half_x, proxy->half_y);
}

void td_shape_settle(thud_world *w, int index) {
    settle(w, td_shape_at(w, index), td_shape_proxy_at(w, index));
}

/* The least thickness of all shapes but lines, cached until shapes change. */
float td_thinnest(thud_world *w) {
    if (w->thinnest_stale) {
        w->thinnest_stale = false;
        w->thinnest = __builtin_inff();
        for (int i = 0; i < w->shapes.count; i++) {
            const td_shape *shape = td_shape_at(w, i);
            if ((shape->flags & TD_SHAPE_LIVE) && !td_kind_is_line(shape->kind)) {
                w->thinnest = td_min_float(w->thinnest, td_thickness(shape));
            }
        }
    }
    return w->thinnest;
}

void td_shape_mark_moved_in(thud_world *w, td_array *moved, int index) {
    uint8_t *marks = td_marks_at(w, index);
    if (!(*marks & TD_MARK_MOVED)) {
        *td_previous_fat_at(w, index) = *td_fat_at(w, index);
        *marks |= TD_MARK_MOVED;
        td_push_int(moved, index);
    }
}

/* The set of resting shapes stays valid: its shapes move by edits alone, and changes.c invalidates
 * it then. */
void td_shape_mark_moved(thud_world *w, int index) {
    td_shape_mark_moved_in(w, &w->moved, index);
    w->awake_shapes.valid = false;
}

/* A half extent along an axis, in bounds quanta, never less than the exact one. Up to 512 length
 * scales (2^23 quanta) the error of single precision is at most half a quantum, and the conversion
 * to an integer drops less than one quantum: together less than the 2 that are added. For larger
 * shapes the error is less than the margin between tight and fat bounds. wide_finalize.c has the
 * same. */
static int32_t coarse_extent(const thud_world *w, float length) {
    return (int32_t)(length * (float)w->to_coarse) + 2;
}

/* The bounds of the shape itself; of a box that turns, those of its rotated corners. */
static td_bounds tight_bounds(const thud_world *w, const td_shape_proxy *proxy) {
    float hx = proxy->half_x, hy = proxy->half_y;
    if (proxy->turns != 0.0f) {
        float c = proxy->c < 0.0f ? -proxy->c : proxy->c;
        float s = proxy->s < 0.0f ? -proxy->s : proxy->s;
        float x = c * hx + s * hy;
        hy = s * hx + c * hy;
        hx = x;
    }
    return td_bounds_about(proxy->center, coarse_extent(w, hx), coarse_extent(w, hy));
}

/* Gives the shape new fat bounds where its tight bounds have left them, and lists it as moved. */
static void update_fat_bounds(thud_world *w, int index, td_shape_proxy *proxy) {
    td_bounds tight = tight_bounds(w, proxy);
    if ((*td_marks_at(w, index) & TD_MARK_FRESH) || !td_bounds_contain(&proxy->fat, &tight)) {
        td_shape_mark_moved(w, index);
        proxy->fat = td_bounds_grown(tight, proxy->margin);
    }
}

/* A half extent in bounds quanta, cut off at a quarter of the range after which bounds wrap around.
 */
static int32_t coarse_reach(const thud_world *w, double length) {
    return (int32_t)td_min_double(length * w->to_coarse, 0x1p30) + 2;
}

td_bounds td_placed_bounds(const thud_world *w, const thud_geometry *p, td_position origin,
                           double slack) {
    double x = td_half_along(p, 1.0, 0.0), y = td_half_along(p, 0.0, 1.0);
    td_position center = {td_wrap_add64(origin.x, td_round64(p->x * w->to_fixed)),
                          td_wrap_add64(origin.y, td_round64(p->y * w->to_fixed))};
    return td_bounds_about(center, coarse_reach(w, x + slack), coarse_reach(w, y + slack));
}

/* The greatest motion in a step, along an axis, over which td_shape_expect extends bounds, in
 * length scales: 1/16 of the 2^18 after which bounds wrap around. Pairs further along the path are
 * found by the detection itself. Chosen. */
#define EXPECTED_MOTION_MAX 16384.0f

/* Extends the fat bounds over an expected motion (dx, dy), caller's unit. */
void td_shape_expect(thud_world *w, int index, float dx, float dy) {
    td_shape_proxy *proxy = td_shape_proxy_at(w, index);
    float max = EXPECTED_MOTION_MAX * w->length_scale;
    thud_geometry now = td_shape_instance(w, index, proxy->center), then = now;
    then.x = (double)td_max_float(-max, td_min_float(dx, max));
    then.y = (double)td_max_float(-max, td_min_float(dy, max));
    td_bounds a = td_placed_bounds(w, &now, proxy->center, 0.0);
    td_bounds b = td_placed_bounds(w, &then, proxy->center, 0.0);
    if (!td_bounds_contain(&proxy->fat, &b)) {
        td_shape_mark_moved(w, index);
        proxy->fat = td_bounds_grown(td_bounds_around(&a, &b), proxy->margin);
    }
}

/* Computes the place of a shape, settled before, from its body's pose. */
static void compute_place(const thud_world *w, const td_shape *shape, td_shape_proxy *proxy) {
    const td_pose *pose = td_pose_at(w, shape->body);
    proxy->center = pose->center;
    proxy->x = proxy->y = proxy->s = 0.0f;
    proxy->c = 1.0f;
    if (!shape->centred) {
        proxy->x = pose->c * shape->arm_x - pose->s * shape->arm_y;
        proxy->y = pose->s * shape->arm_x + pose->c * shape->arm_y;
        proxy->center.x += td_length_from(w, proxy->x);
        proxy->center.y += td_length_from(w, proxy->y);
    }
    if (td_kind_turns(shape->kind)) {
        proxy->c = pose->c * shape->angle_c - pose->s * shape->angle_s;
        proxy->s = pose->s * shape->angle_c + pose->c * shape->angle_s;
    }
}

/* Computes the shape's place, and updates its fat bounds. */
void td_shape_place(thud_world *w, int index) {
    const td_shape *shape = td_shape_at(w, index);
    td_shape_proxy *proxy = td_shape_proxy_at(w, index);
    compute_place(w, shape, proxy);
    if (td_kind_is_line(shape->kind)) {
        td_shape_mark_moved(w, index);
    } else {
        update_fat_bounds(w, index, proxy);
    }
}

/* The proxy as it would be after td_shape_settle and td_shape_place. */
td_shape_proxy td_shape_placed(const thud_world *w, int index) {
    td_shape shape = *td_shape_at(w, index);
    td_shape_proxy proxy = {.margin = 0};
    settle(w, &shape, &proxy);
    compute_place(w, &shape, &proxy);
    proxy.fat = tight_bounds(w, &proxy);
    return proxy;
}

void td_body_place_shapes(thud_world *w, td_body_index body) {
    for (int i = td_body_at(w, body)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (!(td_shape_at(w, i)->flags & TD_SHAPE_WAITS)) {
            td_shape_place(w, i);
        }
    }
}

thud_geometry td_shape_instance_of(const thud_world *w, int index, const td_shape_proxy *proxy,
                                   td_position origin) {
    const td_shape *shape = td_shape_at(w, index);
    return (thud_geometry){.kind = (thud_shape_kind)shape->kind,
                           .x = (double)td_wrap_sub64(proxy->center.x, origin.x) / w->to_fixed,
                           .y = (double)td_wrap_sub64(proxy->center.y, origin.y) / w->to_fixed,
                           .c = (double)proxy->c,
                           .s = (double)proxy->s,
                           .hx = (double)shape->half_x,
                           .hy = (double)shape->half_y};
}

thud_geometry td_shape_instance(const thud_world *w, int index, td_position origin) {
    return td_shape_instance_of(w, index, td_shape_proxy_at(w, index), origin);
}

/* ---- terrain ---- */

thud_terrain td_terrain_view(const thud_world *w, int shape) {
    const td_terrain_record *record = td_terrain_record_at(w, td_shape_at(w, shape)->terrain);
    return (thud_terrain){record->kind,    record->slope,       record->x0,
                          record->spacing, record->points.data, record->points.count};
}

/* Bounds relative to the terrain's origin, in the caller's unit, one bounds quantum wider on each
 * side against rounding. */
static void local_bounds(const thud_world *w, int terrain_shape, td_position at, const td_bounds *b,
                         double *min_x, double *max_x, double *min_y) {
    const td_position *origin = &td_shape_proxy_at(w, terrain_shape)->center;
    int64_t x = origin->x >> TD_COARSE_SHIFT, y = origin->y >> TD_COARSE_SHIFT;
    *min_x = (double)(td_unwrap(b->min_x, at.x) - x - 1) / w->to_coarse;
    *max_x = (double)(td_unwrap(b->max_x, at.x) - x + 1) / w->to_coarse;
    *min_y = (double)(td_unwrap(b->min_y, at.y) - y - 1) / w->to_coarse;
}

bool td_terrain_below(const thud_world *w, int terrain_shape, td_position near_place,
                      const td_bounds *bounds) {
    const td_terrain_record *record =
        td_terrain_record_at(w, td_shape_at(w, terrain_shape)->terrain);
    int64_t origin = td_shape_proxy_at(w, terrain_shape)->center.y >> TD_COARSE_SHIFT;
    int64_t lowest = td_unwrap(bounds->min_y, near_place.y) - origin;
    return (double)(lowest - 1) > record->highest * w->to_coarse;
}

void td_terrain_segments_of(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                            td_position near_place, const td_bounds *bounds, int *first,
                            int *last) {
    double min_x, max_x, min_y;
    local_bounds(w, terrain_shape, near_place, bounds, &min_x, &max_x, &min_y);
    thud_terrain_segments(terrain, min_x, max_x, first, last);
}

bool td_terrain_reaches(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                        td_position near_place, const td_bounds *bounds, int segment) {
    double min_x, max_x, min_y;
    local_bounds(w, terrain_shape, near_place, bounds, &min_x, &max_x, &min_y);
    if (terrain->kind == THUD_TERRAIN_FLAT) {
        double left = terrain->slope * min_x, right = terrain->slope * max_x;
        return (left > right ? left : right) >= min_y;
    }
    const thud_pos *p = &terrain->points[segment], *q = p + 1;
    return p->x <= max_x && q->x >= min_x && (p->y > q->y ? p->y : q->y) >= min_y;
}
