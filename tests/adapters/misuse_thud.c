/* misuse_thud.c: makes each invalid call in thud. */
#include "misuse_thud.h"

static thud_result add_circle(thud_world *w, thud_body_id body, float radius, float density,
                              float friction) {
    thud_shape_def def = thud_default_shape_def();
    def.density = density;
    def.friction = friction;
    return thud_shape_create_circle(w, body, &def, (thud_vec2){0, 0}, radius, NULL);
}

static thud_result create_at(thud_world *w, double x) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){x, x};
    return thud_body_create(w, &def, NULL);
}

/* Sets the velocity of a destroyed body. */
static thud_result push_gone(thud_world *w) {
    thud_body_def def = thud_default_body_def();
    thud_body_id gone;
    def.kind = THUD_BODY_DYNAMIC;
    thud_result made = thud_body_create(w, &def, &gone);
    if (made == THUD_OK)
        made = thud_body_destroy(w, gone);
    return made == THUD_OK ? thud_body_set_velocity(w, gone, (thud_vec2){1, 0}, 0) : THUD_OK;
}

bool misuse_thud(thud_world *w, thud_body_id body, misuse call, double x) {
    const thud_pos here = {0, 0};
    const float f = (float)x;
    thud_result got = THUD_OK;
    switch (call) {
    case MISUSE_POSITION:
        got = thud_body_set_transform(w, body, (thud_pos){x, x}, 0);
        break;
    case MISUSE_ANGLE:
        got = thud_body_set_transform(w, body, here, x);
        break;
    case MISUSE_VELOCITY:
        got = thud_body_set_velocity(w, body, (thud_vec2){f, f}, 0);
        break;
    case MISUSE_SPIN:
        got = thud_body_set_velocity(w, body, (thud_vec2){0, 0}, f);
        break;
    case MISUSE_FORCE:
        got = thud_body_apply_center_force(w, body, (thud_vec2){f, f});
        break;
    case MISUSE_TORQUE:
        got = thud_body_apply_torque(w, body, f);
        break;
    case MISUSE_IMPULSE:
        got = thud_body_apply_impulse(w, body, (thud_vec2){f, f}, here);
        break;
    case MISUSE_IMPULSE_POINT:
        got = thud_body_apply_impulse(w, body, (thud_vec2){0.01f, 0}, (thud_pos){x, x});
        break;
    case MISUSE_NEW_BODY:
        got = create_at(w, x);
        break;
    case MISUSE_RADIUS:
        got = add_circle(w, body, f, 1, 0.6f);
        break;
    case MISUSE_DENSITY:
        got = add_circle(w, body, 0.1f, f, 0.6f);
        break;
    case MISUSE_FRICTION:
        got = add_circle(w, body, 0.1f, 1, f);
        break;
    case MISUSE_GRAVITY:
        got = thud_world_set_gravity(w, (thud_vec2){f, f});
        break;
    case MISUSE_TIME_STEP:
        got = thud_world_set_time_step(w, x);
        break;
    case MISUSE_RAY:
        got = thud_world_cast_ray(w, &(thud_ray){(thud_pos){x, x}, 1, 0, NULL}, NULL, NULL);
        break;
    case MISUSE_GONE:
        got = push_gone(w);
        break;
    case MISUSE_NOBODY:
        got = thud_body_set_velocity(w, (thud_body_id){0, 0}, (thud_vec2){1, 0}, 0);
        break;
    }
    return got != THUD_OK;
}
