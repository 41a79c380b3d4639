/* callbacks.c: the collision rules of a small game by listeners. A prologue (pre-solve callback)
 * changes the friction or restitution of a contact, or lets a body pass, depending on the material
 * of a shape: ice, a trampoline, a platform that bodies pass from below. A conveyor belt and a coin
 * (a sensor) need no callback. Lengths are in metres. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <thud/thud_edits.h>
#include <thud/thud_listeners.h>

enum { PLAIN, ICE, TRAMPOLINE, ONE_WAY }; /* materials, the user data of shapes */
enum { STEPS_PER_SECOND = 60 };           /* of thud_default_world_def */

/* A one-way platform holds a body if the normal, from the platform to the body, points up within 45
 * degrees, the body does not rise, and it did not overlap the platform one step before. Speed (m/s)
 * and overlap (m) have tolerances, since a resting body has a little of both. Chosen. */
static const float NORMAL_Y_MIN = 0.7f, RISING_SPEED_MAX = 0.2f, OVERLAP_MAX = 0.05f;

/* The material of a shape; PLAIN where the shape no longer exists. */
static uint64_t material_of(const thud_world *world, thud_shape_id shape) {
    thud_shape_state state = {.user_data = PLAIN};
    thud_shape_get_state(world, shape, &state);
    return state.user_data;
}

static thud_body_state state_of(const thud_world *world, thud_body_id body) {
    thud_body_state state = {0};
    thud_body_get_state(world, body, &state);
    return state;
}

/* Whether a body with this vertical speed (m/s) lands on the one-way platform, which is shape a of
 * the contact. */
static bool lands(const thud_contact *contact, float vertical_speed) {
    float separation_before = contact->separation - vertical_speed / STEPS_PER_SECOND;
    return contact->normal.y > NORMAL_Y_MIN && vertical_speed < RISING_SPEED_MAX &&
           separation_before > -OVERLAP_MAX;
}

/* Called before a contact is solved. If one of the shapes is static, it is shape a. Returns whether
 * the pair collides in this step. */
static bool prologue(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    (void)context;
    switch (material_of(world, contact->shape_a)) {
    case ICE:
        settings->friction = 0;
        break;
    case TRAMPOLINE:
        settings->restitution = 1.2f; /* above 1: each bounce is higher */
        break;
    case ONE_WAY:
        return lands(contact, state_of(world, contact->body_b).velocity.y);
    }
    return true;
}

/* Called after a contact was solved, with the impulses that were applied. Keeps the greatest normal
 * impulse, kg m/s, in the context. */
static void epilogue(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    float *max_impulse = context;
    *max_impulse = fmaxf(*max_impulse, contact->normal_impulse);
}

/* A static box, 0.5 m high. */
static void add_box(thud_world *world, double x, double y, float half_width, thud_shape_def def) {
    thud_body_def body_def = thud_default_body_def();
    body_def.position = (thud_pos){x, y};
    thud_body_shape box = {thud_aabb_at(0, 0, half_width, 0.25), &def};
    if (thud_body_create_with_shapes(world, &body_def, &box, 1, NULL, NULL) != THUD_OK)
        exit(1);
}

/* A dynamic box of 1 m by 1 m with mass 1. */
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

int main(void) {
    float max_impulse = 0;
    thud_world *world;
    thud_world_def world_def = thud_default_world_def();
    thud_listeners listeners = {.prologue = prologue,
                                .epilogue = epilogue,
                                .context = &max_impulse};
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
    for (int i = 0; i < 3 * STEPS_PER_SECOND; i++) {
        thud_world_step(world);
        coins += thud_events_of(world).sensor_begin_count;
        bool fallen = i > STEPS_PER_SECOND; /* the jumper has landed once: a fall of 2 m takes 0.6 s
                                             */
        highest = fmax(highest, fallen ? state_of(world, jumper).position.y : 0);
    }
    printf("the skater glides at %.2f\n", (double)state_of(world, skater).velocity.x);
    printf("the jumper fell from 2.5 and rose to %.1f\n", highest);
    printf("the climber stands at %.2f\n", state_of(world, climber).position.y);
    printf("the parcel rides at %.2f and collected %d coin\n",
           (double)state_of(world, parcel).velocity.x, coins);
    printf("the loudest thud: %.0f\n", (double)max_impulse);
    thud_world_destroy(world);
}
