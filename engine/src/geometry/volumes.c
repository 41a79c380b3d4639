/* volumes.c: bounding volumes (circle, AABB or OBB) of shapes, of moving shapes, and of two
 * volumes. An OBB is the smallest over a few candidate directions, not over all directions. */
#include "geometry/volumes.h"

/* A bound of the rounding errors of a fit and of a later test, relative to position and size: about
 * eighteen times 2^-53, the maximum error of one operation. */
#define ROUNDING 2e-15

thud_result thud_volume_check(const thud_volume *v) {
    if (!v) {
        return THUD_ERROR_NULL;
    }
    bool circle = td_kind_is_round(v->kind);
    bool place = td_abs(v->x) <= THUD_VOLUME_MAX && td_abs(v->y) <= THUD_VOLUME_MAX;
    bool size = v->hx >= 0.0 && v->hx <= THUD_VOLUME_MAX &&
                (circle || (v->hy >= 0.0 && v->hy <= THUD_VOLUME_MAX));
    bool turned = td_kind_turns(v->kind) ? td_abs(v->c * v->c + v->s * v->s - 1.0) < THUD_UNIT_ERROR
                                         : circle || (v->c == 1.0 && v->s == 0.0);
    return td_kind_is_volume(v->kind) && place && size && turned ? THUD_OK : THUD_ERROR_INVALID;
}

thud_result td_volume_store(thud_shape_kind kind, thud_volume v, thud_volume *out) {
    v.kind = kind;
    double grow = ROUNDING * (td_abs(v.x) + td_abs(v.y) + v.hx + v.hy);
    v.hx += grow;
    v.hy = td_kind_grown_hy(kind, v.hy, grow);
    thud_result result = thud_volume_check(&v);
    if (result == THUD_OK) {
        *out = v;
    }
    return result;
}

thud_volume td_volume_of_span(thud_pos origin, double c, double s, td_volume_span span) {
    thud_volume box = {.kind = THUD_SHAPE_OBB, .c = c, .s = s};
    td_from_frame(&box, 0.5 * (span.u_min + span.u_max), 0.5 * (span.v_min + span.v_max), &box.x,
                  &box.y);
    box.x += origin.x;
    box.y += origin.y;
    box.hx = 0.5 * (span.u_max - span.u_min);
    box.hy = 0.5 * (span.v_max - span.v_min);
    return box;
}

void td_volume_keep_smaller(thud_volume *best, thud_pos origin, double c, double s,
                            td_volume_span span) {
    thud_volume box = td_volume_of_span(origin, c, s, span);
    if (box.hx * box.hy < best->hx * best->hy) {
        *best = box;
    }
}

/* The radius of the smallest circle about the shape's centre that contains the shape. */
static double radius_around(const thud_geometry *shape) {
    double x = shape->hx, y = 0.0;
    if (td_kind_is_box(shape->kind)) {
        td_from_frame(shape, shape->hx, shape->hy, &x, &y);
    }
    return __builtin_sqrt(x * x + y * y);
}

/* ---- motions ---- */

/* The greatest |x| of a corner that turns about the origin from p to q: that of p or of q, or the
 * radius if the corner crosses the x axis between them. `half_turn`: it turns by pi or more. */
static double greatest_x(thud_pos p, thud_pos q, bool half_turn) {
    double x = td_max_double(td_abs(p.x), td_abs(q.x));
    return half_turn || p.y * q.y <= 0.0 ? __builtin_sqrt(p.x * p.x + p.y * p.y) : x;
}

/* Corner 0 or 1 of a box, relative to its centre, in the frame along (c, s); the other two are
 * opposite. */
static thud_pos corner_along(const thud_geometry *box, int i, double c, double s) {
    double x, y;
    td_from_frame(box, box->hx, i ? -box->hy : box->hy, &x, &y);
    return (thud_pos){c * x + s * y, c * y - s * x};
}

/* The span of a moving shape along (c, s), relative to the middle of its centre's path. */
static td_volume_span span_of_motion(const thud_geometry *start, const thud_motion *m, double c,
                                     double s) {
    double u = td_kind_is_round(start->kind) ? start->hx : 0.0, v = u;
    thud_geometry end = td_placed_at(start, m, 1.0);
    bool half_turn = td_kind_turns(start->kind) && td_abs(m->turn) >= TD_PI;
    for (int i = 0; i < 2 && td_kind_is_box(start->kind); i++) {
        thud_pos p = corner_along(start, i, c, s), q = corner_along(&end, i, c, s);
        u = td_max_double(u, greatest_x(p, q, half_turn));
        v = td_max_double(v, greatest_x((thud_pos){p.y, p.x}, (thud_pos){q.y, q.x}, half_turn));
    }
    u += 0.5 * td_abs(c * m->dx + s * m->dy);
    v += 0.5 * td_abs(c * m->dy - s * m->dx);
    return (td_volume_span){-u, u, -v, v};
}

thud_result thud_volume_around_motion(thud_shape_kind kind, const thud_geometry *shape,
                                      thud_motion motion, thud_volume *out) {
    if (!shape || !out) {
        return THUD_ERROR_NULL;
    }
    if (!td_kind_is_volume(kind) || thud_geometry_check(shape) != THUD_OK ||
        !td_motion_valid(motion)) {
        return THUD_ERROR_INVALID;
    }
    thud_pos middle = {shape->x + 0.5 * motion.dx, shape->y + 0.5 * motion.dy};
    if (td_kind_is_round(kind)) {
        double path = __builtin_sqrt(motion.dx * motion.dx + motion.dy * motion.dy);
        thud_volume circle = {.x = middle.x,
                              .y = middle.y,
                              .c = 1.0,
                              .hx = radius_around(shape) + 0.5 * path};
        return td_volume_store(kind, circle, out);
    }
    thud_pos axis = {1.0, 0.0};
    if (td_kind_turns(kind) && td_kind_turns(shape->kind)) {
        thud_geometry halfway = td_placed_at(shape, &motion, 0.5);
        axis = td_volume_direction(halfway.c, halfway.s);
    }
    thud_volume box =
        td_volume_of_span(middle, axis.x, axis.y, span_of_motion(shape, &motion, axis.x, axis.y));
    if (td_kind_turns(kind)) {
        thud_pos forward = td_volume_direction(motion.dx, motion.dy);
        td_volume_keep_smaller(&box, middle, forward.x, forward.y,
                               span_of_motion(shape, &motion, forward.x, forward.y));
    }
    return td_volume_store(kind, box, out);
}

thud_result thud_volume_around_shape(thud_shape_kind kind, const thud_geometry *shape,
                                     thud_volume *out) {
    return thud_volume_around_motion(kind, shape, (thud_motion){0}, out);
}

/* ---- two volumes ---- */

/* The span of two volumes along (c, s), relative to a's centre. */
static td_volume_span span_of_both(const thud_volume *a, const thud_volume *b, double c, double s) {
    double au = td_half_along(a, c, s), av = td_half_along(a, -s, c);
    double bu = td_half_along(b, c, s), bv = td_half_along(b, -s, c);
    double x = b->x - a->x, y = b->y - a->y, u = c * x + s * y, v = c * y - s * x;
    return (td_volume_span){u - bu < -au ? u - bu : -au, td_max_double(u + bu, au),
                            v - bv < -av ? v - bv : -av, td_max_double(v + bv, av)};
}

/* The smallest circle around the circles of both volumes. */
static thud_volume circle_around_both(const thud_volume *a, const thud_volume *b) {
    double x = b->x - a->x, y = b->y - a->y, distance = __builtin_sqrt(x * x + y * y);
    double ra = radius_around(a), rb = radius_around(b);
    thud_volume circle = {.x = a->x, .y = a->y, .c = 1.0, .hx = ra};
    if (distance + ra <= rb) {
        circle.x = b->x;
        circle.y = b->y;
        circle.hx = rb;
    } else if (distance + rb > ra) {
        circle.hx = 0.5 * (distance + ra + rb);
        circle.x += x * ((circle.hx - ra) / distance);
        circle.y += y * ((circle.hx - ra) / distance);
    }
    return circle;
}

thud_result thud_volume_merge(thud_shape_kind kind, const thud_volume *a, const thud_volume *b,
                              thud_volume *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (!td_kind_is_volume(kind) || thud_volume_check(a) != THUD_OK ||
        thud_volume_check(b) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    if (td_kind_is_round(kind)) {
        return td_volume_store(kind, circle_around_both(a, b), out);
    }
    thud_pos from = {a->x, a->y};
    thud_volume box = td_volume_of_span(from, 1.0, 0.0, span_of_both(a, b, 1.0, 0.0));
    const thud_pos directions[] = {td_kind_turns(a->kind) ? td_volume_direction(a->c, a->s)
                                                          : (thud_pos){1.0, 0.0},
                                   td_kind_turns(b->kind) ? td_volume_direction(b->c, b->s)
                                                          : (thud_pos){1.0, 0.0},
                                   td_volume_direction(b->x - a->x, b->y - a->y)};
    for (int i = 0; i < 3 && td_kind_turns(kind); i++) {
        double c = directions[i].x, s = directions[i].y;
        td_volume_keep_smaller(&box, from, c, s, span_of_both(a, b, c, s));
    }
    return td_volume_store(kind, box, out);
}
