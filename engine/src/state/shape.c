/* shape.c: creates, destroys and reads shapes, and checks their defs. A new shape is linked into
 * its body's list at once; its place, bounds and contacts follow in the next step, by the change
 * TD_CHANGE_SHAPES. */
#include "state/shape.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/kinds.h"
#include "base/rotation.h"
#include "geometry/shape_instance.h"
#include "terrain/terrain.h"

#include <math.h>
#include <string.h>

thud_shape_def thud_default_shape_def(void) {
    return (thud_shape_def){.density = 1.0f,
                            .friction = 0.6f,
                            .filter = {.category = 1, .mask = UINT32_MAX},
                            .events = true,
                            .cookie = TD_COOKIE};
}

const char *td_shape_def_error(const thud_world *w, const thud_shape_def *def, td_reason *why) {
    if (def->cookie != TD_COOKIE) {
        return "shape_create: the def does not start from thud_default_shape_def()";
    }
    float max_speed = THUD_SURFACE_SPEED_MAX * w->length_scale;
    bool in =
        td_float_in(why, "shape def: density", def->density, 0.0f, THUD_DENSITY_MAX) &&
        td_float_in(why, "shape def: friction", def->friction, 0.0f, THUD_FRICTION_MAX) &&
        td_float_in(why, "shape def: restitution", def->restitution, 0.0f, THUD_RESTITUTION_MAX) &&
        td_float_in(why, "shape def: surface_speed", def->surface_speed, -max_speed, max_speed);
    if (in && def->restitution > 0.0f && !w->restitution_hooks) {
        return TD_NO_RESTITUTION("shape def: ");
    }
    if (def->sensor && !w->sensor_hooks) {
        return "shape def: sensor, in a world of thud_default_small_world_def before thud_shape_set_sensor";
    }
    return in ? NULL : why->text;
}

bool td_size_in(const thud_world *w, td_reason *why, const char *name, int body_kind, float size) {
    float max = body_kind == THUD_BODY_STATIC ? THUD_STATIC_SIZE_MAX : THUD_SIZE_MAX;
    return td_float_in(why, name, size, THUD_SIZE_MIN * w->length_scale, max * w->length_scale);
}

bool td_offset_in(const thud_world *w, td_reason *why, const char *name, thud_vec2 offset) {
    float max = THUD_SIZE_MAX * w->length_scale;
    return td_float_in(why, name, offset.x, -max, max) &&
           td_float_in(why, name, offset.y, -max, max);
}

/* Refuses an offset or half extents out of range for the body. */
static thud_result check_half(const thud_world *w, td_body_index body, thud_vec2 offset,
                              const char *offset_name, thud_vec2 half, const char *half_name) {
    td_reason why;
    int kind = td_body_at(w, body)->kind;
    bool in = td_offset_in(w, &why, offset_name, offset) &&
              td_size_in(w, &why, half_name, kind, half.x) &&
              td_size_in(w, &why, half_name, kind, half.y);
    return in ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, why.text);
}

#define ARRAY(name, element) TD_ARRAY_PLACE(thud_world, name, element)

/* The arrays of the world that have an element for each shape, or room for all. */
static const td_array_place BY_SHAPE[] = {ARRAY(proxy, td_shape_proxy),
                                          ARRAY(previous_fat, td_bounds), ARRAY(marks, uint8_t),
                                          ARRAY(moved, int)};

bool td_shape_reserve(thud_world *w, int count) {
    return td_slots_reserve(&w->memory, &w->shapes, count) && td_deferred_reserve(w, count) &&
           td_arrays_reserve(&w->memory, w, BY_SHAPE, sizeof BY_SHAPE / sizeof *BY_SHAPE,
                             td_slots_capacity(&w->shapes));
}

/* The checks that all kinds share. On success *body is the body's slot, and memory is reserved. */
static thud_result begin_create(thud_world *w, thud_body_id id, const thud_shape_def *def,
                                td_body_index *body) {
    thud_result result = td_find_body(w, id, body);
    if (result != THUD_OK) {
        return result;
    }
    if (!def) {
        return td_refuse(w, THUD_ERROR_NULL, "shape create: def is null");
    }
    td_reason why;
    const char *error = td_shape_def_error(w, def, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    return td_shape_reserve(w, 1) ? THUD_OK
                                  : td_refuse(w, THUD_ERROR_MEMORY, "shape create: out of memory");
}

/* Takes a slot for the shape `made`, fills in what follows from the def, and marks the body. Inside
 * a callback the shape gets TD_SHAPE_WAITS and a deferred edit. Cannot fail. */
static thud_result finish_create(thud_world *w, td_body_index body_index, const thud_shape_def *def,
                                 td_shape made, thud_shape_id *out) {
    int index = td_slots_take(&w->shapes);
    td_shape *shape = td_shape_at(w, index);
    td_body *body = td_body_at(w, body_index);
    made.generation = shape->generation;
    made.flags = (uint8_t)(TD_SHAPE_LIVE | (def->sensor ? TD_SHAPE_SENSOR : 0) |
                           (def->events ? 0 : TD_SHAPE_SILENT) | (w->locked ? TD_SHAPE_WAITS : 0));
    *td_marks_at(w, index) = TD_MARK_FRESH;
    *td_shape_proxy_at(w, index) = (td_shape_proxy){.margin = 0}; /* not placed yet */
    made.body = body_index;
    made.next = body->first_shape;
    made.density = def->density;
    made.friction = def->friction;
    made.restitution = def->restitution;
    made.surface_speed = def->surface_speed;
    made.filter = def->filter;
    made.user_data = def->user_data;
    if (td_kind_is_line(made.kind)) {
        td_terrain_record_at(w, made.terrain)->shape = index;
    } else {
        made.terrain = TD_NONE;
    }
    *shape = made;
    w->thinnest_stale = true;
    w->sensors += def->sensor;
    w->mobile_sensors += def->sensor && body->kind == THUD_BODY_DYNAMIC;
    body->first_shape = index;
    body->shape_count++;
    body->aabbs = (uint8_t)(body->aabbs | td_kind_fixes_rotation(made.kind));
    if (w->locked) {
        td_deferred_add(w, body_index, TD_PUT_SHAPE, (double[4]){index});
    } else if (body->kind != THUD_BODY_STATIC) {
        td_body_weigh(w, body_index);
    }
    td_body_mark(w, body_index, TD_CHANGE_SHAPES);
    if (out) {
        *out = td_shape_handle(w, index);
    }
    if (!(def->filter.category | def->filter.mask | (uint32_t)def->filter.group)) {
        td_refuse(w, THUD_OK, "shape create: made, but meets nothing: its filter is zero");
    }
    return THUD_OK;
}

thud_result thud_shape_create_circle(thud_world *w, thud_body_id id, const thud_shape_def *def,
                                     thud_vec2 offset, float radius, thud_shape_id *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index body;
    thud_result result = begin_create(w, id, def, &body);
    if (result != THUD_OK) {
        return result;
    }
    result = check_half(w, body, offset, "circle: x or y of offset", (thud_vec2){radius, radius},
                        "circle: radius");
    if (result != THUD_OK) {
        return result;
    }
    td_kind_circle(w);
    return finish_create(w, body, def,
                         (td_shape){.kind = THUD_SHAPE_CIRCLE,
                                    .x = offset.x,
                                    .y = offset.y,
                                    .angle_c = 1.0f,
                                    .half_x = radius,
                                    .half_y = 0.0f},
                         out);
}

thud_result thud_shape_create_aabb(thud_world *w, thud_body_id id, const thud_shape_def *def,
                                   thud_vec2 offset, thud_vec2 half, thud_shape_id *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index body;
    thud_result result = begin_create(w, id, def, &body);
    if (result != THUD_OK) {
        return result;
    }
    result = check_half(w, body, offset, "AABB: x or y of offset", half, "AABB: x or y of half");
    if (result != THUD_OK) {
        return result;
    }
    if (td_pose_at(w, body)->angle != 0 || td_deferred_turns(w, body)) {
        return td_refuse(w, THUD_ERROR_INVALID, "AABB: its body's angle must be 0");
    }
    if (td_body_at(w, body)->kind == THUD_BODY_KINEMATIC &&
        td_body_velocity(w, td_body_at(w, body))[2] != 0.0f) {
        return td_refuse(w, THUD_ERROR_INVALID, "AABB: its body must not turn");
    }
    td_kind_aabb(w);
    return finish_create(w, body, def,
                         (td_shape){.kind = THUD_SHAPE_AABB,
                                    .x = offset.x,
                                    .y = offset.y,
                                    .angle_c = 1.0f,
                                    .half_x = half.x,
                                    .half_y = half.y},
                         out);
}

thud_result thud_shape_create_obb(thud_world *w, thud_body_id id, const thud_shape_def *def,
                                  thud_vec2 offset, thud_vec2 half, double angle,
                                  thud_shape_id *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index body;
    thud_result result = begin_create(w, id, def, &body);
    if (result != THUD_OK) {
        return result;
    }
    result = check_half(w, body, offset, "OBB: x or y of offset", half, "OBB: x or y of half");
    if (result == THUD_OK) {
        result = td_check(w, "OBB: angle", angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    td_kind_obb(w);
    td_shape made = {.kind = THUD_SHAPE_OBB,
                     .x = offset.x,
                     .y = offset.y,
                     .angle = td_angle_from(angle),
                     .half_x = half.x,
                     .half_y = half.y};
    td_angle_turn(made.angle, &made.angle_c, &made.angle_s);
    return finish_create(w, body, def, made, out);
}

/* ---- terrain ---- */

/* Copies the vertices of a line, those of a uniform one with their x, and finds the highest. A flat
 * line has none. False when memory is short. */
static bool copy_points(thud_world *w, td_terrain_record *record, const thud_terrain *terrain) {
    record->highest = -INFINITY;
    if (terrain->kind == THUD_TERRAIN_FLAT) {
        record->highest = terrain->slope == 0.0 ? 0.0 : INFINITY;
        return true;
    }
    if (!td_array_reserve(&w->memory, &record->points, terrain->count)) {
        return false;
    }
    thud_pos *points = record->points.data;
    for (int i = 0; i < terrain->count; i++) {
        bool uniform = terrain->kind == THUD_TERRAIN_UNIFORM;
        points[i].x = uniform ? terrain->x0 + i * terrain->spacing : terrain->points[i].x;
        points[i].y = terrain->points[i].y;
        record->highest = td_max_double(record->highest, points[i].y);
    }
    record->points.count = terrain->count;
    return true;
}

/* The reason why thud_terrain_check has refused the line. */
static const char *terrain_error(const thud_terrain *t) {
    bool uniform = t->kind == THUD_TERRAIN_UNIFORM;
    if (t->kind == THUD_TERRAIN_FLAT) {
        return "terrain: |slope| is not in [0, THUD_TERRAIN_SLOPE_MAX]";
    }
    if (!uniform && t->kind != THUD_TERRAIN_IRREGULAR) {
        return "terrain: kind is none";
    }
    if (!t->points) {
        return "terrain: points is null";
    }
    if (t->count < 2 || t->count > THUD_TERRAIN_COUNT_MAX) {
        return "terrain: count is not in 2..THUD_TERRAIN_COUNT_MAX";
    }
    if (td_terrain_readable(t) != THUD_OK) {
        return t->spacing > 0.0 ? "terrain: spacing or x0 is too large, or spacing too small for x0"
                                : "terrain: spacing is not above 0";
    }
    return uniform ? "terrain: y of a point is not finite, or beyond THUD_TERRAIN_PLACE_MAX"
                   : "terrain: x does not rise, or a point is not finite, or beyond "
                     "THUD_TERRAIN_PLACE_MAX";
}

thud_result thud_shape_create_terrain(thud_world *w, thud_body_id id, const thud_shape_def *def,
                                      const thud_terrain *terrain, thud_shape_id *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index body;
    thud_result result = begin_create(w, id, def, &body);
    if (result != THUD_OK) {
        return result;
    }
    if (!terrain) {
        return td_refuse(w, THUD_ERROR_NULL, "terrain: the line is null");
    }
    result = thud_terrain_check(terrain);
    if (result != THUD_OK) {
        return td_refuse(w, result, terrain_error(terrain));
    }
    if (td_body_at(w, body)->kind != THUD_BODY_STATIC || td_pose_at(w, body)->angle != 0 ||
        td_deferred_turns(w, body)) {
        return td_refuse(w, THUD_ERROR_INVALID, "terrain: needs a static body with angle 0");
    }
    if (!td_slots_reserve(&w->memory, &w->terrains, 1)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "terrain: out of memory");
    }
    td_terrain_record made = {.kind = terrain->kind,
                              .slope = terrain->slope,
                              .x0 = terrain->x0,
                              .spacing = terrain->spacing,
                              .points.stride = sizeof(thud_pos)};
    if (!copy_points(w, &made, terrain)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "terrain: out of memory");
    }
    td_kind_terrain(w);
    int index = td_slots_take(&w->terrains);
    td_terrain_record *record = td_terrain_record_at(w, index);
    *record = made;
    return finish_create(w, body, def,
                         (td_shape){.kind = THUD_SHAPE_TERRAIN, .terrain = index, .angle_c = 1.0f},
                         out);
}

thud_result thud_shape_get_terrain(const thud_world *w, thud_shape_id id, thud_terrain *out) {
    int index;
    thud_result result = td_find_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (!td_kind_is_line(td_shape_at(w, index)->kind)) {
        return td_refuse(w, THUD_ERROR_INVALID, "shape terrain: the shape is no terrain");
    }
    if (out) {
        *out = td_terrain_view(w, index);
    }
    return THUD_OK;
}

/* ---- the rest of a shape's life ---- */

/* Lets a body rotate again whose last AABB was destroyed. Its moment of inertia is computed in the
 * next step, with its mass. One that the caller has set (TD_BODY_MASS_GIVEN) acts at once. */
static void free_rotation(const thud_world *w, td_body *body) {
    body->aabbs = 0;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        body->aabbs |= (shape->flags & TD_SHAPE_LIVE) && td_kind_fixes_rotation(shape->kind);
    }
    bool given = (body->flags & (TD_BODY_MASS_GIVEN | TD_BODY_FIXED)) == TD_BODY_MASS_GIVEN;
    if (given && !body->aabbs && body->inertia > 0.0f) {
        body->inv_inertia = 1.0f / body->inertia;
    }
}

thud_result thud_shape_destroy(thud_world *w, thud_shape_id id) {
    TD_IN_OWN_FLOAT_MODE;
    int index;
    thud_result result = td_find_shape(w, id, &index);
    if (result == THUD_OK) {
        td_shape *shape = td_shape_at(w, index);
        shape->flags &= (uint8_t)~TD_SHAPE_LIVE;
        free_rotation(w, td_body_at(w, shape->body));
        td_body_mark(w, shape->body, TD_CHANGE_SHAPES);
    }
    return result;
}

bool thud_shape_is_valid(const thud_world *w, thud_shape_id id) {
    return w && id.index1 > 0 && id.index1 <= (uint32_t)w->shapes.count &&
           (td_shape_at(w, (int)id.index1 - 1)->flags & TD_SHAPE_LIVE) &&
           td_tag(w, td_shape_at(w, (int)id.index1 - 1)->generation) == id.generation;
}

thud_result thud_shape_get_state(const thud_world *w, thud_shape_id id, thud_shape_state *out) {
    TD_IN_OWN_FLOAT_MODE;
    int index;
    thud_result result = td_find_shape(w, id, &index);
    if (result == THUD_OK && out) {
        const td_shape *shape = td_shape_at(w, index);
        *out = (thud_shape_state){
            .kind = (thud_shape_kind)shape->kind,
            .body = td_body_handle(w, shape->body),
            .offset = {shape->x, shape->y},
            .half_extents = {shape->half_x, shape->half_y},
            .angle = td_angle_radians(shape->angle),
            .density = shape->density,
            .friction = shape->friction,
            .restitution = shape->restitution,
            .surface_speed = shape->surface_speed,
            .filter = shape->filter,
            .sensor = (shape->flags & TD_SHAPE_SENSOR) != 0,
            .events = !(shape->flags & TD_SHAPE_SILENT),
            .user_data = shape->user_data,
        };
    }
    return result;
}
