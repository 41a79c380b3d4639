/* api_body.c: exports that create, read and move bodies, apply forces to them, and list their
 * shapes and contacts. api.h has the conventions. */
#include "api.h"

#include <stdlib.h>

static api_buffer shape_list, contact_rows;

/* Slots out: body_options. */
void api_body_defaults(void) {
    thud_body_def def = thud_default_body_def();
    struct body_options *s = &api_slots.body_options;
    s->kind = def.kind;
    s->position[0] = def.position.x;
    s->position[1] = def.position.y;
    s->angle = def.angle;
    s->velocity[0] = def.velocity.x;
    s->velocity[1] = def.velocity.y;
    s->angular_velocity = def.angular_velocity;
    s->gravity_scale = def.gravity_scale;
    s->linear_damping = def.linear_damping;
    s->angular_damping = def.angular_damping;
    s->fixed_rotation = def.fixed_rotation;
    s->may_sleep = def.may_sleep;
    s->user_data = (double)def.user_data;
    s->detection = -1.0; /* the world's */
}

/* Creates a body. Slots in: body_options. Slots out: handle. */
int api_body_create(thud_world *world) {
    const struct body_options *s = &api_slots.body_options;
    thud_body_def def = thud_default_body_def();
    def.kind = (thud_body_kind)api_to_int(s->kind);
    def.position = (thud_pos){s->position[0], s->position[1]};
    def.angle = s->angle;
    def.velocity = (thud_vec2){(float)s->velocity[0], (float)s->velocity[1]};
    def.angular_velocity = (float)s->angular_velocity;
    def.gravity_scale = (float)s->gravity_scale;
    def.linear_damping = (float)s->linear_damping;
    def.angular_damping = (float)s->angular_damping;
    def.fixed_rotation = s->fixed_rotation != 0.0;
    def.may_sleep = s->may_sleep != 0.0;
    def.user_data = (uint64_t)s->user_data;
    def.detection = api_detection(s->detection);
    thud_body_id id = {0};
    thud_result result = thud_body_create(world, &def, &id);
    api_slots.handle.index1 = id.index1;
    api_slots.handle.generation = id.generation;
    return result;
}

int api_body_destroy(thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_body_destroy(world, api_body(index1, generation));
}

int api_body_is_valid(const thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_body_is_valid(world, api_body(index1, generation));
}

/* Slots out: body_state. */
int api_body_state(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_body_state state;
    thud_result result = thud_body_get_state(world, api_body(index1, generation), &state);
    if (result != THUD_OK)
        return result;
    struct body_state *s = &api_slots.body_state;
    s->kind = state.kind;
    s->position[0] = state.position.x;
    s->position[1] = state.position.y;
    s->center[0] = state.center.x;
    s->center[1] = state.center.y;
    s->angle = state.angle;
    s->velocity[0] = state.velocity.x;
    s->velocity[1] = state.velocity.y;
    s->angular_velocity = state.angular_velocity;
    s->mass = state.mass;
    s->inertia = state.inertia;
    s->gravity_scale = state.gravity_scale;
    s->awake = state.awake;
    s->quarantined = state.quarantined;
    s->user_data = (double)state.user_data;
    s->shape_count = state.shape_count;
    s->enabled = state.enabled;
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

int api_body_apply_center_force(thud_world *world, uint32_t index1, uint32_t generation, double x,
                                double y) {
    return thud_body_apply_center_force(world, api_body(index1, generation),
                                        (thud_vec2){(float)x, (float)y});
}

int api_body_apply_torque(thud_world *world, uint32_t index1, uint32_t generation, double torque) {
    return thud_body_apply_torque(world, api_body(index1, generation), (float)torque);
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

/* The handles of a body's shapes, two uint32_t each. Slots out: list. */
int api_body_shapes(const thud_world *world, uint32_t index1, uint32_t generation) {
    int count = 0;
    thud_body_id body = api_body(index1, generation);
    thud_result result = thud_body_get_shapes(world, body, NULL, 0, &count);
    if (result != THUD_OK)
        return result;
    api_buffer_clear(&shape_list);
    for (int i = 0; i < count; i++)
        api_buffer_push(&shape_list, &(thud_shape_id){0}, sizeof(thud_shape_id));
    if (shape_list.failed)
        return THUD_ERROR_MEMORY;
    result = thud_body_get_shapes(world, body, (thud_shape_id *)shape_list.data, count, &count);
    api_slots.list.address = (double)(uintptr_t)shape_list.data;
    api_slots.list.count = count;
    return result;
}

/* The touching pairs of a body. Slots out: list of contact_row. */
int api_body_contacts(thud_world *world, uint32_t index1, uint32_t generation) {
    thud_body_id body = api_body(index1, generation);
    int count = 0;
    thud_result result = thud_body_get_contacts(world, body, NULL, 0, &count);
    if (result != THUD_OK)
        return result;
    thud_manifold *all = malloc(sizeof *all * (size_t)(count + 1));
    if (all == NULL)
        return THUD_ERROR_MEMORY;
    result = thud_body_get_contacts(world, body, all, count, &count);
    api_buffer_clear(&contact_rows);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        const thud_manifold *m = &all[i];
        struct contact_row row = {.shape_a = {m->shape_a.index1, m->shape_a.generation},
                                  .shape_b = {m->shape_b.index1, m->shape_b.generation},
                                  .body_a = {m->body_a.index1, m->body_a.generation},
                                  .body_b = {m->body_b.index1, m->body_b.generation},
                                  .normal = {m->normal.x, m->normal.y},
                                  .point_count = m->point_count,
                                  .tangent_impulse = m->tangent_impulse,
                                  .direct = m->direct};
        for (int k = 0; k < m->point_count; k++)
            row.points[k] = (struct contact_point){.place = {m->point[k].x, m->point[k].y},
                                                   .separation = m->separation[k],
                                                   .normal_impulse = m->normal_impulse[k]};
        api_buffer_push(&contact_rows, &row, sizeof row);
    }
    free(all);
    api_slots.list.address = (double)(uintptr_t)contact_rows.data;
    api_slots.list.count = count;
    return result != THUD_OK ? result : api_buffer_result(&contact_rows);
}
