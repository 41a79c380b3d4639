/* api_push.c: exports for further forces and impulses, points of bodies, and single values of
 * bodies and shapes (thud_forces.h, thud_reads.h). api.h has the conventions. */
#include "api.h"

#include <thud/thud_forces.h>
#include <thud/thud_reads.h>
#include <thud/thud_version.h>

#include <string.h>

/* The version of thud: 1,000,000 * major + 1,000 * minor + patch. */
int api_version(void) {
    return thud_version();
}

/* ---- forces and impulses ---- */

int api_body_apply_force(thud_world *world, uint32_t index1, uint32_t generation, double x,
                         double y, double point_x, double point_y) {
    return thud_body_apply_force(world, api_body(index1, generation),
                                 (thud_vec2){(float)x, (float)y}, (thud_pos){point_x, point_y});
}

int api_body_apply_center_impulse(thud_world *world, uint32_t index1, uint32_t generation, double x,
                                  double y) {
    return thud_body_apply_center_impulse(world, api_body(index1, generation),
                                          (thud_vec2){(float)x, (float)y});
}

int api_body_apply_angular_impulse(thud_world *world, uint32_t index1, uint32_t generation,
                                   double impulse) {
    return thud_body_apply_angular_impulse(world, api_body(index1, generation), (float)impulse);
}

int api_body_set_target(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                        double angle) {
    return thud_body_set_target(world, api_body(index1, generation), (thud_pos){x, y}, angle);
}

/* ---- points; slots out: place ---- */

/* Slots out: place, unless the result is an error. */
static int place(thud_result result, double x, double y) {
    if (result == THUD_OK)
        api_slots.place = (struct place){{x, y}};
    return result;
}

int api_body_velocity_at(const thud_world *world, uint32_t index1, uint32_t generation, double x,
                         double y) {
    thud_vec2 out = {0};
    thud_result result =
        thud_body_get_velocity_at(world, api_body(index1, generation), (thud_pos){x, y}, &out);
    return place(result, out.x, out.y);
}

int api_body_world_point(const thud_world *world, uint32_t index1, uint32_t generation, double x,
                         double y) {
    thud_pos out = {0};
    thud_result result = thud_body_get_world_point(world, api_body(index1, generation),
                                                   (thud_vec2){(float)x, (float)y}, &out);
    return place(result, out.x, out.y);
}

int api_body_local_point(const thud_world *world, uint32_t index1, uint32_t generation, double x,
                         double y) {
    thud_vec2 out = {0};
    thud_result result =
        thud_body_get_local_point(world, api_body(index1, generation), (thud_pos){x, y}, &out);
    return place(result, out.x, out.y);
}

int api_body_world_vector(const thud_world *world, uint32_t index1, uint32_t generation, double x,
                          double y) {
    thud_vec2 out = {0};
    thud_result result = thud_body_get_world_vector(world, api_body(index1, generation),
                                                    (thud_vec2){(float)x, (float)y}, &out);
    return place(result, out.x, out.y);
}

int api_body_local_vector(const thud_world *world, uint32_t index1, uint32_t generation, double x,
                          double y) {
    thud_vec2 out = {0};
    thud_result result = thud_body_get_local_vector(world, api_body(index1, generation),
                                                    (thud_vec2){(float)x, (float)y}, &out);
    return place(result, out.x, out.y);
}

/* ---- single values ---- */

/* Slots out: place. */
int api_body_position(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_pos out = {0};
    thud_result result = thud_body_get_position(world, api_body(index1, generation), &out);
    return place(result, out.x, out.y);
}

/* Slots out: rotation. */
int api_body_rotation(const thud_world *world, uint32_t index1, uint32_t generation) {
    double angle = 0.0;
    float cosine = 1.0f, sine = 0.0f;
    thud_result result =
        thud_body_get_rotation(world, api_body(index1, generation), &angle, &cosine, &sine);
    if (result == THUD_OK)
        api_slots.rotation = (struct rotation){angle, cosine, sine};
    return result;
}

/* Slots out: motion. */
int api_body_velocity(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_vec2 velocity = {0};
    float angular = 0.0f;
    thud_result result =
        thud_body_get_velocity(world, api_body(index1, generation), &velocity, &angular);
    if (result == THUD_OK)
        api_slots.motion = (struct motion){{velocity.x, velocity.y}, angular};
    return result;
}

/* Slots out: number. */
int api_body_user_data(const thud_world *world, uint32_t index1, uint32_t generation) {
    uint64_t data = 0;
    thud_result result = thud_body_get_user_data(world, api_body(index1, generation), &data);
    if (result == THUD_OK)
        api_slots.number.value = (double)data;
    return result;
}

int api_shape_user_data(const thud_world *world, uint32_t index1, uint32_t generation) {
    uint64_t data = 0;
    thud_result result = thud_shape_get_user_data(world, api_shape(index1, generation), &data);
    if (result == THUD_OK)
        api_slots.number.value = (double)data;
    return result;
}

/* Slots out: handle. */
int api_shape_body(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_body_id body = {0};
    thud_result result = thud_shape_get_body(world, api_shape(index1, generation), &body);
    if (result == THUD_OK)
        api_slots.handle = (struct handle){body.index1, body.generation};
    return result;
}

/* The index of a name among the first three of four; 3 for any other name. */
static int number_of(const char *name, const char *const *names) {
    int number = 0;
    while (number < 3 && strcmp(name, names[number]) != 0)
        number++;
    return number;
}

/* Slots out: step_settings. */
int api_world_step_settings(const thud_world *world) {
    const char *const qualities[] = {thud_quality_draft.name, thud_quality_default.name,
                                     thud_quality_high.name};
    const char *const detections[] = {thud_detection_name(&thud_detection_overlap),
                                      thud_detection_name(&thud_detection_continuous),
                                      thud_detection_name(&thud_detection_bisect)};
    thud_step_settings now;
    thud_result result = thud_world_get_step_settings(world, &now);
    if (result != THUD_OK)
        return result;
    const thud_quality *q = &now.quality;
    api_slots.step_settings =
        (struct step_settings){.gravity = {now.gravity.x, now.gravity.y},
                               .time_step = now.time_step,
                               .max_error = now.max_error,
                               .substeps = now.substeps,
                               .sleeping = now.sleeping,
                               .base = number_of(q->name, qualities),
                               .quality = {q->substeps, q->contact_stiffness, q->contact_damping,
                                           number_of(thud_detection_name(q->detection), detections),
                                           q->islands != NULL}};
    return result;
}
