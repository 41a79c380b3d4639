/* explosion.c: thud_world_explode: an impulse away from a centre on all shapes within reach that no
 * other body shields.
 *
 * The side of a shape that faces the centre is cut into `rays` segments of equal width, measured
 * across the direction from the centre to the shape's nearest point. A ray parallel to that
 * direction, through the middle of each segment, finds a point of the shape's surface. Unless a
 * body covers that point from the centre, the segment gets impulse = def.impulse * width *
 * falloff_factor(distance) away from the centre. Points are relative to the centre of the
 * explosion, in the caller's unit. */
#include "fields/fields.h"

#include "casts/walk.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* One call. */
typedef struct blast {
    thud_world *world;
    const thud_explosion *def;
    td_position at;          /* the centre */
    double reach;            /* radius + falloff */
    thud_query_filter cover; /* which shapes may be cover: all but those of the ignored body */
    td_array push;           /* td_push, by body: the sum of its impulses */
    td_array room;           /* int: memory of casts (td_walk_room) */
} blast;

thud_explosion thud_default_explosion(void) {
    return (thud_explosion){.impulse = 1.0f,
                            .cover = THUD_COVER_ALL,
                            .rays = 5,
                            .filter = thud_default_query_filter(),
                            .cookie = TD_COOKIE};
}

/* ---- cover ---- */

/* Whether a shape that a ray hits on its way to a shape of `target` shields it, by the def's
 * setting `cover`. */
static bool is_cover(const blast *b, const thud_ray_hit *hit, td_body_index target) {
    td_body_index body = td_shape_at(b->world, (int)hit->shape.index1 - 1)->body;
    return !td_same_body(body, target) && (b->def->cover == THUD_COVER_ALL ||
                                           td_body_at(b->world, body)->kind != THUD_BODY_DYNAMIC);
}

/* Whether a body covers the point from the centre. The ray ends 1e-9 of its length before the
 * point, so that bodies which touch the shape there are not cover. */
static bool covered(const blast *b, td_body_index target, thud_pos place) {
    if (b->def->cover == THUD_COVER_NONE) {
        return false;
    }
    enum { BATCH = 8 }; /* hits in a call of td_walk_next. Chosen; does not affect results. */
    td_path way = {td_point_meets, b->def->center, b->at, place.x, place.y, .filter = &b->cover};
    td_walk walk = td_walk_begin(b->world, &way, b->room.data, b->room.capacity);
    thud_ray_hit hits[BATCH];
    td_nearest k = {hits, BATCH, 0};
    do {
        td_walk_next(&walk, 1.0 - 1e-9, &k);
        for (int i = 0; i < k.count; i++) {
            if (is_cover(b, &hits[i], target)) {
                return true;
            }
        }
    } while (k.count > 0);
    return false;
}

/* ---- one shape ---- */

/* Adds an impulse (x, y) at a point of a body. */
static void push_at(const blast *b, td_body_index body, thud_pos place, double x, double y) {
    const thud_world *w = b->world;
    td_position center = td_pose_at(w, body)->center;
    double from_x = (double)(center.x - b->at.x) / w->to_fixed;
    double from_y = (double)(center.y - b->at.y) / w->to_fixed;
    td_push_add(TD_AT(td_push, &b->push, body.at), place.x - from_x, place.y - from_y, x, y);
}

/* The share of the impulse at a distance: 1 up to the radius, and from there linearly to 0. */
static double falloff_factor(const blast *b, double distance) {
    if (distance <= b->def->radius) {
        return 1.0;
    }
    return distance < b->reach ? (b->reach - distance) / b->def->falloff : 0.0;
}

/* Pushes at one segment of the side that faces the centre. (dx, dy) is the unit vector to the
 * shape's nearest point, `across` the middle of the segment perpendicular to it, and `length` its
 * width. A ray along (dx, dy) from in front of the shape finds the point. */
static void push_segment(const blast *b, td_body_index body, const thud_geometry *shape, double dx,
                         double dy, double across, double length) {
    double back = 2.0 * td_reach(shape), along = dx * shape->x + dy * shape->y - back;
    double x = dx * along - dy * across, y = dy * along + dx * across, fraction, nx, ny;
    if (!thud_geometry_cast_ray(shape, (thud_segment){x, y, 2.0 * back * dx, 2.0 * back * dy},
                                &fraction, &nx, &ny)) {
        return;
    }
    thud_pos place = {x + fraction * 2.0 * back * dx, y + fraction * 2.0 * back * dy};
    double distance = __builtin_sqrt(place.x * place.x + place.y * place.y);
    double impulse = (double)b->def->impulse * length * falloff_factor(b, distance);
    if (impulse != 0.0 && distance > 0.0 && !covered(b, body, place)) {
        impulse /= distance;
        push_at(b, body, place, impulse * place.x, impulse * place.y);
    }
}

/* Pushes a shape that contains the centre: all of the impulse at the shape's own centre. */
static void push_from_within(const blast *b, td_body_index body, const thud_geometry *shape) {
    double x = shape->x, y = shape->y, length = __builtin_sqrt(x * x + y * y);
    double dx = length > 0.0 ? x / length : 0.0, dy = length > 0.0 ? y / length : 1.0;
    double impulse = 2.0 * td_half_along(shape, -dy, dx) * (double)b->def->impulse;
    push_at(b, body, (thud_pos){x, y}, impulse * dx, impulse * dy);
}

/* Pushes one shape. The parts of its side whose distance from the centre, measured across, is
 * beyond the reach get no segment. */
static void push_shape(const blast *b, int index) {
    const thud_world *w = b->world;
    td_body_index body = td_shape_at(w, index)->body;
    thud_geometry shape = td_query_instance(w, index, b->at);
    thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0};
    thud_closest c;
    td_closest(&shape, &point, &c);
    if (c.distance > b->reach) {
        return;
    }
    if (c.distance <= 0.0) {
        push_from_within(b, body, &shape);
        return;
    }
    double dx = -c.nx, dy = -c.ny;
    double half = td_half_along(&shape, -dy, dx), middle = dx * shape.y - dy * shape.x;
    double from = td_max_double(middle - half, -b->reach);
    double to = td_min_double(middle + half, b->reach);
    double length = (to - from) / b->def->rays;
    for (int i = 0; i < b->def->rays; i++) {
        push_segment(b, body, &shape, dx, dy, from + (i + 0.5) * length, length);
    }
}

/* ---- all shapes ---- */

/* Whether the explosion acts on the shape. */
static bool may_push(const blast *b, int index) {
    const td_shape *shape = td_shape_at(b->world, index);
    const td_body *body = td_body_at(b->world, shape->body);
    return body->kind == THUD_BODY_DYNAMIC && !(body->flags & TD_BODY_QUARANTINED) &&
           !(shape->flags & TD_SHAPE_SENSOR) && td_query_passes(b->world, index, &b->def->filter);
}

static bool is_pushed(const td_push *push) {
    return push->x != 0.0 || push->y != 0.0 || push->turn != 0.0;
}

/* Whether thud_body_apply_center_impulse and _angular_impulse accept the sum of a body's impulses,
 * and the resulting velocities. */
static bool is_push_in_range(const thud_world *w, int body, const td_push *p) {
    const td_body *at = td_body_at(w, (td_body_index){body});
    double inverse = w->locked ? 1.0 / w->def.time_step : 1.0;
    double inv_mass = (double)at->inv_mass, inv_inertia = (double)at->inv_inertia;
    return td_push_valid((td_push){inverse * p->x, inverse * p->y, inverse * p->turn}) &&
           td_push_valid((td_push){inv_mass * p->x, inv_mass * p->y, inv_inertia * p->turn});
}

/* Applies the impulses to all bodies, or to none if one is out of range or memory is short: both
 * are checked first. Each body takes two deferred edits inside a callback. */
static thud_result apply(blast *b, int *pushed) {
    thud_world *w = b->world;
    int count = 0;
    for (int i = 0; i < w->bodies.count; i++) {
        const td_push *push = TD_AT(td_push, &b->push, i);
        count += is_pushed(push);
        if (!is_push_in_range(w, i, push)) {
            return td_refuse(w, THUD_ERROR_INVALID, "explode: an impulse is out of range");
        }
    }
    if (w->locked && !td_array_reserve(&w->memory, &w->deferred, w->deferred.count + 2 * count)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "explode: out of memory");
    }
    for (int i = 0; i < w->bodies.count; i++) {
        const td_push *push = TD_AT(td_push, &b->push, i);
        if (is_pushed(push)) {
            thud_body_id body = td_body_handle(w, (td_body_index){i});
            thud_vec2 impulse = {(float)push->x, (float)push->y};
            thud_body_apply_center_impulse(w, body, impulse);
            thud_body_apply_angular_impulse(w, body, (float)push->turn);
        }
    }
    if (pushed) {
        *pushed = count;
    }
    return THUD_OK;
}

/* Finds the shapes within reach, in the order of their indices, and pushes them. */
static thud_result explode(blast *b, int *pushed) {
    thud_world *w = b->world;
    thud_pos at = b->def->center;
    thud_pos lower = {at.x - b->reach, at.y - b->reach}, upper = {at.x + b->reach, at.y + b->reach};
    if (!td_query_prepare(w) || !td_query_list(w, lower, upper) ||
        !td_array_reserve(&w->memory, &b->room, td_walk_room(w)) ||
        !td_array_reserve(&w->memory, &b->push, w->bodies.count)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "explode: out of memory");
    }
    td_sort_ints(&w->scratch.found_shapes);
    for (int i = 0; i < w->scratch.found_shapes.count; i++) {
        int index = td_int_at(&w->scratch.found_shapes, i);
        if (may_push(b, index)) {
            push_shape(b, index);
        }
    }
    return apply(b, pushed);
}

/* Refuses a def with a value out of range. */
static thud_result check(const thud_world *w, const thud_explosion *def) {
    double max_length = THUD_PLACE_MAX * (double)w->length_scale,
           max_impulse = (double)THUD_EXPLOSION_MAX;
    td_reason why;
    if (!td_in_world(w, &why, "explode: x or y of center", def->center.x, def->center.y) ||
        !td_in(&why, "explode: radius", def->radius, 0.0, max_length) ||
        !td_in(&why, "explode: falloff", def->falloff, 0.0, max_length) ||
        !td_in(&why, "explode: impulse", (double)def->impulse, -max_impulse, max_impulse) ||
        !td_in(&why, "explode: rays", def->rays, 1.0, THUD_EXPLOSION_RAYS_MAX)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    if ((unsigned)def->cover > THUD_COVER_ALL) {
        return td_refuse(w, THUD_ERROR_INVALID, "explode: cover is none");
    }
    if (def->radius + def->falloff == 0.0) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "explode: radius and falloff are 0: it reaches nobody");
    }
    return td_query_check_filter(w, &def->filter);
}

thud_result thud_world_explode(thud_world *w, const thud_explosion *def, int *out_pushed) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !def) {
        return td_refuse(w, THUD_ERROR_NULL, "explode: world or explosion is null");
    }
    if (def->cookie != TD_COOKIE) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "explode: the explosion does not start from thud_default_explosion()");
    }
    thud_result result = check(w, def);
    if (result != THUD_OK) {
        return result;
    }
    blast b = {.world = w,
               .def = def,
               .at = td_place_from(w, def->center),
               .reach = def->radius + def->falloff,
               .cover = thud_default_query_filter(),
               .push = {.stride = (int)sizeof(td_push)},
               .room = {.stride = (int)sizeof(int)}};
    b.cover.ignore = def->filter.ignore;
    result = explode(&b, out_pushed);
    td_array_free(&w->memory, &b.push);
    td_array_free(&w->memory, &b.room);
    return result;
}
