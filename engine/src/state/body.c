/* body.c: creates, destroys and reads bodies, and computes their mass from their shapes. Contacts,
 * lanes and the broadphase are not touched here: a body on the change list (td_body_mark) gets what
 * follows from the change at the start of the next step (changes.c). */
#include "state/body.h"

#include "state/awake.h"
#include "state/handles.h"
#include "state/shape.h"
#include "base/rotation.h"

#include <string.h>

thud_body_def thud_default_body_def(void) {
    return (thud_body_def){.gravity_scale = 1.0f, .may_sleep = true, .cookie = TD_COOKIE};
}

bool td_place_valid(const thud_world *w, double x, double y) {
    double max = THUD_PLACE_MAX * (double)w->length_scale;
    return x >= -max && x <= max && y >= -max && y <= max;
}

bool td_in_world(const thud_world *w, td_reason *why, const char *name, double x, double y) {
    double max = THUD_PLACE_MAX * (double)w->length_scale;
    return td_in(why, name, x, -max, max) && td_in(why, name, y, -max, max);
}

thud_result td_check_place(const thud_world *w, const char *name, double x, double y) {
    td_reason why;
    return td_in_world(w, &why, name, x, y) ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, why.text);
}

const char *td_body_def_error(const thud_world *w, const thud_body_def *def, td_reason *why) {
    if (def->cookie != TD_COOKIE) {
        return "body_create: the def does not start from thud_default_body_def()";
    }
    if ((int)def->kind < 0 || def->kind >= THUD_BODY_KIND_COUNT) {
        return "body def: kind is none";
    }
    if (!td_in_world(w, why, "body def: x or y of position", def->position.x, def->position.y) ||
        !td_in(why, "body def: angle", def->angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX) ||
        !td_all_finite(why, "body def: velocity or angular_velocity", def->velocity.x,
                       def->velocity.y, def->angular_velocity) ||
        !td_all_finite(why, "body def: gravity_scale", def->gravity_scale, 0.0f, 0.0f) ||
        !td_float_in(why, "body def: linear_damping", def->linear_damping, 0.0f, FLT_MAX) ||
        !td_float_in(why, "body def: angular_damping", def->angular_damping, 0.0f, FLT_MAX)) {
        return why->text;
    }
    if (def->kind == THUD_BODY_STATIC &&
        !(def->velocity.x == 0.0f && def->velocity.y == 0.0f && def->angular_velocity == 0.0f)) {
        return "body def: a static body has no velocity";
    }
    return NULL;
}

/* Called after edits of settings, such as gravity, by which a body at rest may begin to move. */
void td_wake_all(thud_world *w) {
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        if (td_body_at(w, i)->flags & TD_BODY_LIVE) {
            td_body_mark(w, i, TD_CHANGE_WAKE);
        }
    }
    w->substep_gain_stale = true;
}

thud_result thud_body_create(thud_world *w, const thud_body_def *def, thud_body_id *out) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !def) {
        return td_refuse(w, THUD_ERROR_NULL, "body create: world or def is null");
    }
    td_reason why;
    const char *error = td_body_def_error(w, def, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (!td_slots_reserve(&w->memory, &w->bodies, 1) ||
        !td_array_reserve(&w->memory, &w->pose, td_slots_capacity(&w->bodies)) ||
        !td_array_reserve(&w->memory, &w->changed, td_slots_capacity(&w->bodies)) ||
        !td_awake_reserve(w, 1)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "body create: out of memory");
    }
    td_body_index index = {td_slots_take(&w->bodies)};
    td_body *body = td_body_at(w, index);
    *body = (td_body){
        .generation = body->generation,
        .kind = (uint8_t)def->kind,
        .flags = (uint8_t)(TD_BODY_LIVE | (def->fixed_rotation ? TD_BODY_FIXED : 0) |
                           (def->may_sleep ? 0 : TD_BODY_RESTLESS) |
                           (def->detection ? TD_BODY_OWN_DETECTION : 0)),
        .awake = {TD_NONE},
        .velocity = {def->velocity.x, def->velocity.y, def->angular_velocity},
        .first_shape = TD_NONE,
        .first_constraint = TD_NONE,
        .gravity_scale = def->gravity_scale,
        .linear_damping = def->linear_damping,
        .angular_damping = def->angular_damping,
        .detection = def->detection ? def->detection : w->quality.detection,
        .user_data = def->user_data,
    };
    td_pose *pose = td_pose_at(w, index);
    pose->center = td_place_from(w, def->position);
    pose->angle = td_angle_from(def->angle);
    td_angle_turn(pose->angle, &pose->c, &pose->s);
    td_body_weigh(w, index);
    td_body_mark(w, index, TD_CHANGE_ENTER);
    if (out) {
        *out = td_body_handle(w, index);
    }
    return THUD_OK;
}

/* Adds a pending change of the body to the change list, and invalidates what depends on it. */
void td_body_mark(thud_world *w, td_body_index index, td_change_kind change) {
    td_body *body = td_body_at(w, index);
    if (!body->changes) {
        td_push_body(&w->changed, index);
    }
    body->changes |= (uint8_t)change;
    w->preview.stale = true; /* where pending edits will place shapes: preview.h */
    w->kinetic_stale = true; /* its velocity may have been edited */
}

thud_result thud_body_destroy(thud_world *w, thud_body_id id) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result == THUD_OK) {
        td_body *body = td_body_at(w, index);
        body->flags &= (uint8_t)~TD_BODY_LIVE;
        for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
            td_shape_at(w, i)->flags &= (uint8_t)~TD_SHAPE_LIVE;
        }
        td_body_mark(w, index, TD_CHANGE_LEAVE);
    }
    return result;
}

bool thud_body_is_valid(const thud_world *w, thud_body_id id) {
    td_body_index named = {(int32_t)(id.index1 - 1)};
    return w && id.index1 > 0 && id.index1 <= (uint32_t)w->bodies.count &&
           (td_body_at(w, named)->flags & TD_BODY_LIVE) &&
           td_tag(w, td_body_at(w, named)->generation) == id.generation;
}

/* ---- mass ---- */

/* Area of a shape (length^2), and its second moment of area about its centre (length^4). */
static void area_of(const td_shape *shape, double *area, double *moment) {
    td_kind_area(shape->kind, (double)shape->half_x, (double)shape->half_y, area, moment);
}

/* The greatest distance of a point of the shape from the shape's centre; of a circle, whose half_y
 * is 0, its radius to the bit, since the root of a square is exact. */
static float radius_of(const td_shape *shape) {
    return __builtin_sqrtf(shape->half_x * shape->half_x + shape->half_y * shape->half_y);
}

/* Sets the centre of mass to (x, y) in the body's frame. The pose stores the place of the centre of
 * mass, so it is moved as well: the body's origin stays where it is. */
static void set_center(thud_world *w, td_body_index index, double x, double y) {
    td_body *body = td_body_at(w, index);
    td_position from = td_body_origin(w, index), *center = &td_pose_at(w, index)->center;
    body->center_x = (float)x;
    body->center_y = (float)y;
    td_position to = td_body_origin(w, index);
    center->x = td_wrap_add64(center->x, td_wrap_sub64(from.x, to.x));
    center->y = td_wrap_add64(center->y, td_wrap_sub64(from.y, to.y));
}

/* Bounds of the weight of shapes, sqrt(mass * inertia). With lengths of 1e-10 to 1e10, those of the
 * smallest and largest shapes in the caller's unit, mass and inertia then lie in 1e-38..1e37, where
 * they and their inverses are finite as floats. Chosen, powers of two. */
#define WEIGHT_MIN 0x1p-90
#define WEIGHT_MAX 0x1p90

/* Mass, inertia and centre of mass as the sums over the body's shapes (the parallel axis theorem);
 * zero for a body that is not dynamic. Beyond the bounds of weight both are scaled alike, as if the
 * shapes had another density. */
static void weigh_shapes(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    double mass = 0.0, mx = 0.0, my = 0.0, inertia = 0.0;
    bool dynamic = body->kind == THUD_BODY_DYNAMIC;
    for (int i = body->first_shape; dynamic && i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        double area, moment;
        double density = shape->flags & TD_SHAPE_WAITS ? 0.0 : (double)shape->density;
        double x = (double)shape->x, y = (double)shape->y;
        area_of(shape, &area, &moment);
        mass += density * area;
        mx += density * area * x;
        my += density * area * y;
        inertia += density * (moment + area * (x * x + y * y));
    }
    if (!(mass > 0.0)) {
        mass = 1.0; /* without shapes or density it still falls */
    }
    double cx = mx / mass, cy = my / mass;
    inertia -= mass * (cx * cx + cy * cy);
    bool rotates = inertia > 0.0 && !(body->flags & TD_BODY_FIXED) && !body->aabbs;
    double weight = rotates ? __builtin_sqrt(mass * inertia) : mass;
    double share = td_clamp(weight, WEIGHT_MIN, WEIGHT_MAX) / weight;
    mass *= share;
    inertia *= share;
    body->mass = dynamic ? (float)mass : 0.0f;
    body->inertia = rotates ? (float)inertia : 0.0f;
    body->inv_mass = dynamic ? (float)(1.0 / mass) : 0.0f;
    body->inv_inertia = rotates ? (float)(1.0 / inertia) : 0.0f;
    set_center(w, index, cx, cy);
}

/* Recomputes mass, inertia, centre of mass and extents from the body's shapes. */
void td_body_weigh(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    if (body->aabbs) {
        td_body_velocity(w, body)[2] = body->inv_inertia = 0.0f; /* an AABB fixes rotation */
    }
    if (!(body->flags & TD_BODY_MASS_GIVEN)) {
        weigh_shapes(w, index);
    }
    if (body->kind == THUD_BODY_STATIC) {
        return;
    }
    body->min_extent = body->shape_count ? 3.0e38f : 0.0f;
    body->max_extent = 0.0f;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        float x = shape->x - body->center_x, y = shape->y - body->center_y;
        body->min_extent = td_min_float(body->min_extent, td_half_thickness(shape));
        body->max_extent =
            td_max_float(body->max_extent, __builtin_sqrtf(x * x + y * y) + radius_of(shape));
    }
}

/* ---- reading ---- */

td_position td_origin_at(const thud_world *w, td_body_index index, const td_pose *pose) {
    const td_body *body = td_body_at(w, index);
    float x = pose->c * body->center_x - pose->s * body->center_y;
    float y = pose->s * body->center_x + pose->c * body->center_y;
    return (td_position){td_wrap_sub64(pose->center.x, td_length_from(w, x)),
                         td_wrap_sub64(pose->center.y, td_length_from(w, y))};
}

td_position td_body_origin(const thud_world *w, td_body_index index) {
    return td_origin_at(w, index, td_pose_at(w, index));
}

thud_result thud_body_get_state(const thud_world *w, thud_body_id id, thud_body_state *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK || !out) {
        return result;
    }
    const td_body *body = td_body_at(w, index);
    const td_pose *pose = td_pose_at(w, index);
    const float *velocity = td_body_velocity(w, body);
    *out = (thud_body_state){
        .kind = (thud_body_kind)body->kind,
        .position = td_place_to(w, td_body_origin(w, index)),
        .center = td_place_to(w, pose->center),
        .angle = td_angle_radians(pose->angle),
        .cosine = pose->c,
        .sine = pose->s,
        .velocity = {velocity[0], velocity[1]},
        .angular_velocity = velocity[2],
        .mass = body->mass,
        .inertia = body->inv_inertia > 0.0f ? body->inertia : 0.0f,
        .gravity_scale = body->gravity_scale,
        .awake = td_body_is_awake(body),
        .enabled = !(body->flags & TD_BODY_DISABLED),
        .quarantined = (body->flags & TD_BODY_QUARANTINED) != 0,
        .user_data = body->user_data,
        .shape_count = body->shape_count,
    };
    return THUD_OK;
}

thud_result thud_body_get_shapes(const thud_world *w, thud_body_id id, thud_shape_id *out,
                                 int capacity, int *out_count) {
    td_body_index index;
    int n = 0;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (capacity < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "body shapes: capacity is negative");
    }
    for (int i = td_body_at(w, index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (!(td_shape_at(w, i)->flags & TD_SHAPE_LIVE)) {
            continue;
        }
        if (out && n < capacity) {
            out[n] = td_shape_handle(w, i);
        }
        n++;
    }
    if (out_count) {
        *out_count = n;
    }
    return THUD_OK;
}

thud_result thud_body_set_user_data(thud_world *w, thud_body_id id, uint64_t user_data) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result == THUD_OK) {
        td_body_at(w, index)->user_data = user_data;
    }
    return result;
}
