/* api_body.c: bodies. */
#include "api.h"

#include <stdlib.h>

static api_buffer shape_list, contact_rows;

/* Slots: 0 kind  1, 2 position  3 angle  4, 5 velocity  6 angular velocity  7 gravity scale
 * 8 linear damping  9 angular damping  10 fixed rotation  11 may sleep  12 user data
 * 13 detection. */
void api_body_defaults(void) {
    thud_body_def def = thud_default_body_def();
    double *s = api_slots;
    s[0] = def.kind;
    s[1] = def.position.x;
    s[2] = def.position.y;
    s[3] = def.angle;
    s[4] = def.velocity.x;
    s[5] = def.velocity.y;
    s[6] = def.angular_velocity;
    s[7] = def.gravity_scale;
    s[8] = def.linear_damping;
    s[9] = def.angular_damping;
    s[10] = def.fixed_rotation;
    s[11] = def.may_sleep;
    s[12] = (double)def.user_data;
    s[13] = -1.0; /* detection: as the world */
}

/* A body from the slots of api_body_defaults; its handle goes to slots 0 and 1. */
int api_body_create(thud_world *world) {
    const double *s = api_slots;
    thud_body_def def = thud_default_body_def();
    def.kind = (thud_body_kind)api_to_int(s[0]);
    def.position = (thud_pos){s[1], s[2]};
    def.angle = s[3];
    def.velocity = (thud_vec2){(float)s[4], (float)s[5]};
    def.angular_velocity = (float)s[6];
    def.gravity_scale = (float)s[7];
    def.linear_damping = (float)s[8];
    def.angular_damping = (float)s[9];
    def.fixed_rotation = s[10] != 0.0;
    def.may_sleep = s[11] != 0.0;
    def.user_data = (uint64_t)s[12];
    def.detection = api_detection(s[13]);
    thud_body_id id = {0};
    thud_result result = thud_body_create(world, &def, &id);
    api_slots[0] = id.index1;
    api_slots[1] = id.generation;
    return result;
}

int api_body_destroy(thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_body_destroy(world, api_body(index1, generation));
}

int api_body_is_valid(const thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_body_is_valid(world, api_body(index1, generation));
}

/* Slots out: 0 kind  1, 2 position  3, 4 centre of mass  5 angle  6, 7 velocity
 * 8 angular velocity  9 mass  10 inertia  11 gravity scale  12 awake  13 quarantined
 * 14 user data  15 number of shapes  16 enabled. */
int api_body_get(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_body_state state;
    thud_result result = thud_body_get(world, api_body(index1, generation), &state);
    if (result != THUD_OK)
        return result;
    double *s = api_slots;
    s[0] = state.kind;
    s[1] = state.position.x;
    s[2] = state.position.y;
    s[3] = state.center.x;
    s[4] = state.center.y;
    s[5] = state.angle;
    s[6] = state.velocity.x;
    s[7] = state.velocity.y;
    s[8] = state.angular_velocity;
    s[9] = state.mass;
    s[10] = state.inertia;
    s[11] = state.gravity_scale;
    s[12] = state.awake;
    s[13] = state.quarantined;
    s[14] = (double)state.user_data;
    s[15] = state.shape_count;
    s[16] = state.enabled;
    return THUD_OK;
}

int api_body_set_transform(thud_world *world, uint32_t index1, uint32_t generation, double x,
                           double y, double angle) {
    return thud_body_set_transform(world, api_body(index1, generation), (thud_pos){x, y}, angle);
}

int api_body_set_velocity(thud_world *world, uint32_t index1, uint32_t generation, double x,
                          double y, double angular) {
    return thud_body_set_velocity(world, api_body(index1, generation),
                                  (thud_vec2){(float)x, (float)y}, (float)angular);
}

int api_body_apply_impulse(thud_world *world, uint32_t index1, uint32_t generation, double x,
                           double y, double point_x, double point_y) {
    return thud_body_apply_impulse(world, api_body(index1, generation),
                                   (thud_vec2){(float)x, (float)y}, (thud_pos){point_x, point_y});
}

int api_body_apply_force(thud_world *world, uint32_t index1, uint32_t generation, double x,
                         double y, double torque) {
    return thud_body_apply_force(world, api_body(index1, generation),
                                 (thud_vec2){(float)x, (float)y}, (float)torque);
}

int api_body_set_awake(thud_world *world, uint32_t index1, uint32_t generation, int awake) {
    return thud_body_set_awake(world, api_body(index1, generation), awake != 0);
}

int api_body_set_enabled(thud_world *world, uint32_t index1, uint32_t generation, int enabled) {
    return thud_body_set_enabled(world, api_body(index1, generation), enabled != 0);
}

int api_body_set_user_data(thud_world *world, uint32_t index1, uint32_t generation, double data) {
    return thud_body_set_user_data(world, api_body(index1, generation), (uint64_t)data);
}

/* The body's shape handles, two 32-bit numbers each. Slots out: 0 address  1 count. */
int api_body_shapes(const thud_world *world, uint32_t index1, uint32_t generation) {
    int count = 0;
    thud_body_id body = api_body(index1, generation);
    thud_result result = thud_body_shapes(world, body, NULL, 0, &count);
    if (result != THUD_OK)
        return result;
    api_buffer_clear(&shape_list);
    for (int i = 0; i < count; i++)
        api_buffer_push(&shape_list, &(thud_shape_id){0}, sizeof(thud_shape_id));
    if (shape_list.failed)
        return THUD_ERROR_MEMORY;
    result = thud_body_shapes(world, body, (thud_shape_id *)shape_list.data, count, &count);
    api_slots[0] = (double)(uintptr_t)shape_list.data;
    api_slots[1] = count;
    return result;
}

enum { CONTACT_ROW = 21 };

/* The body's contacts. A row is 21 doubles: shapes a and b, bodies a and b (handles), normal,
 * count of points, tangent impulse, solved directly, and of each point: place, separation, normal
 * impulse; where there is no second one zeros. Slots out: 0 address  1 count. */
int api_body_contacts(thud_world *world, uint32_t index1, uint32_t generation) {
    thud_body_id body = api_body(index1, generation);
    int count = 0;
    thud_result result = thud_body_contacts(world, body, NULL, 0, &count);
    if (result != THUD_OK)
        return result;
    thud_manifold *all = malloc(sizeof *all * (size_t)(count + 1));
    if (all == NULL)
        return THUD_ERROR_MEMORY;
    result = thud_body_contacts(world, body, all, count, &count);
    api_buffer_clear(&contact_rows);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        const thud_manifold *m = &all[i];
        double row[CONTACT_ROW] = {
            m->shape_a.index1, m->shape_a.generation, m->shape_b.index1, m->shape_b.generation,
            m->body_a.index1,  m->body_a.generation,  m->body_b.index1,  m->body_b.generation,
            m->normal.x,       m->normal.y,           m->point_count,    m->tangent_impulse,
            m->direct,
        };
        for (int k = 0; k < m->point_count; k++) {
            double *point = row + 13 + 4 * k;
            point[0] = m->point[k].x;
            point[1] = m->point[k].y;
            point[2] = m->separation[k];
            point[3] = m->normal_impulse[k];
        }
        api_buffer_push(&contact_rows, row, sizeof row);
    }
    free(all);
    api_slots[0] = (double)(uintptr_t)contact_rows.data;
    api_slots[1] = count;
    return result != THUD_OK ? result : api_buffer_result(&contact_rows);
}
