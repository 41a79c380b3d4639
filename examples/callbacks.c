/* callbacks.c: the collision rules of a small game by listeners: a prologue (pre-solve) changes
 * friction or restitution, or lets a body pass, by the material of a shape: ice, a trampoline, a
 * platform that is passed from below. A conveyor belt and a coin (a sensor) need no callback. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <thud/thud_edits.h>
#include <thud/thud_listeners.h>

enum { PLAIN, ICE, TRAMPOLINE, ONE_WAY }; /* materials, the user data of shapes */

/* The material of a shape; PLAIN where the shape no longer exists. */
static uint64_t material_of(const thud_world *world, thud_shape_id shape) {
    thud_shape_state state = {.user_data = PLAIN};
    thud_shape_get_state(world, shape, &state);
    return state.user_data;
}

/* Called before a pair is solved. Of a static and a moving shape, a is the static one. */
static bool prologue(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    (void)context;
    thud_body_state body;
    switch (material_of(world, contact->shape_a)) {
    case ICE:
        settings->friction = 0;
        break;
    case TRAMPOLINE:
        settings->restitution = 1.2f; /* above 1: each bounce is higher */
        break;
    case ONE_WAY: /* collides with a body that comes down on it and was above it a step before */
        thud_body_get_state(world, contact->body_b, &body);
        return contact->normal.y > 0.7f && body.velocity.y < 0.2f &&
               contact->separation > body.velocity.y / 60 - 0.05f;
    }
    return true;
}

/* Called after a pair was solved, with the impulses that were applied. */
static void epilogue(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    float *loudest = context;
    *loudest = fmaxf(*loudest, contact->normal_impulse);
}

/* A static box, half a length high; returns its shape. */
static thud_shape_id add_box(thud_world *world, double x, double y, float half_width,
                             thud_shape_def def) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_id shape;
    body_def.position = (thud_pos){x, y};
    thud_body_shape box = {thud_aabb_at(0, 0, half_width, 0.25), &def};
    if (thud_body_create_with_shapes(world, &body_def, &box, 1, NULL, &shape) != THUD_OK)
        exit(1);
    return shape;
}

/* A dynamic box of 1 by 1 with mass 1. */
static thud_body_id add_crate(thud_world *world, double x, double y, float vx, float vy) {
    thud_body_def body_def = thud_default_body_def();
    thud_body_shape square = {thud_aabb_at(0, 0, 0.5, 0.5), NULL};
    thud_body_id body;
    body_def.kind = THUD_BODY_DYNAMIC;
    body_def.position = (thud_pos){x, y};
    body_def.velocity = (thud_vec2){vx, vy};
    if (thud_body_create_with_shapes(world, &body_def, &square, 1, &body, NULL) != THUD_OK)
        exit(1);
    return body;
}

static thud_body_state state_of(const thud_world *world, thud_body_id body) {
    thud_body_state state = {0};
    thud_body_get_state(world, body, &state);
    return state;
}

int main(void) {
    float loudest = 0;
    thud_world *world;
    thud_world_def world_def = thud_default_world_def();
    thud_listeners listeners = {.prologue = prologue, .epilogue = epilogue, .context = &loudest};
    if (thud_world_create(&world_def, &world) != THUD_OK ||
        thud_world_set_listeners(world, &listeners) != THUD_OK)
        return 1;

    thud_shape_def def = thud_default_shape_def();
    add_box(world, 0, -0.25, 8, (def.user_data = ICE, def));
    add_box(world, 20, -0.25, 2, (def.user_data = TRAMPOLINE, def));
    add_box(world, 30, -0.25, 2, (def.user_data = ONE_WAY, def));
    def.user_data = PLAIN;
    def.surface_speed = 2; /* a conveyor belt to +x */
    add_box(world, 50, -0.25, 8, def);
    def.surface_speed = 0;
    def.sensor = true;
    add_box(world, 50, 0.25, 1, def); /* a coin above the belt */

    thud_body_id skater = add_crate(world, -6, 0.5, 3, 0);
    thud_body_id jumper = add_crate(world, 20, 2.5, 0, 0);
    thud_body_id climber = add_crate(world, 30, -3, 0, 10);
    thud_body_id parcel = add_crate(world, 46, 0.5, 0, 0);
    double highest = 0;
    int coins = 0;
    for (int i = 0; i < 180; i++) {
        thud_world_step(world);
        coins += thud_events_of(world).sensor_begin_count;
        highest = fmax(highest, i > 60 ? state_of(world, jumper).position.y : 0);
    }
    printf("the skater glides at %.2f\n", (double)state_of(world, skater).velocity.x);
    printf("the jumper fell from 2.5 and rose to %.1f\n", highest);
    printf("the climber stands at %.2f\n", state_of(world, climber).position.y);
    printf("the parcel rides at %.2f and collected %d coin\n",
           (double)state_of(world, parcel).velocity.x, coins);
    printf("the loudest thud: %.0f\n", (double)loudest);
    thud_world_destroy(world);
}
