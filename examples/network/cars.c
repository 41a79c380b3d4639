/* cars.c: see cars.h. */
#include "cars.h"

#include "random.h"

#include <thud/thud_make.h>
#include <thud/thud_reads.h>

/* Half the length and width of the field. */
#define HALF_LENGTH 12.0
#define HALF_WIDTH 8.0
/* DRIVE, TURN: accelerations of a car, length/s^2 and rad/s^2. GRIP: the share of its sideways
 * velocity that a car loses in a step. */
#define DRIVE 14.0f
#define TURN 24.0f
#define GRIP 0.25f

/* A random input is drawn for each block of HOLD steps. It begins at a random step of the block,
 * less than LATER steps after the block's first one; until then the input of the block before
 * holds. */
enum { HOLD = 32, LATER = 24 };

thud_world_def cars_def(const thud_quality *quality) {
    thud_world_def def = thud_default_world_def_of(quality);
    def.gravity = (thud_vec2){0, 0};
    def.time_step = 1.0 / CARS_RATE;
    return def;
}

bool cars_build(thud_world *world, int players, cars *out) {
    *out = (cars){.players = players, .sum = 1};
    thud_body_options wall = {.restitution = 0.6f, .friction = 0.2f};
    for (int side = -1; side <= 1; side += 2) {
        thud_body_make(world, thud_aabb_at(side * (HALF_LENGTH + 1), 0, 1, HALF_WIDTH + 2), &wall);
        thud_body_make(world, thud_aabb_at(0, side * (HALF_WIDTH + 1), HALF_LENGTH + 2, 1), &wall);
    }
    thud_body_options car = {.kind = THUD_BODY_DYNAMIC,
                             .linear_damping = 1.2f,
                             .angular_damping = 6,
                             .restitution = 0.3f,
                             .friction = 0.3f};
    for (int i = 0; i < players; i++) {
        double across = (i / 2 + 1) * HALF_WIDTH / 3 - HALF_WIDTH * 5 / 6;
        thud_geometry box = thud_obb_at(i % 2 ? 9 : -9, across, 0.8f, 0.4f, i % 2 ? 3.0 : 0.1);
        out->bodies[out->count++] = thud_body_make(world, box, &car);
    }
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC,
                              .velocity = {4, 3},
                              .linear_damping = 0.1f,
                              .restitution = 0.9f,
                              .friction = 0.3f,
                              .density = 0.2f};
    out->bodies[out->count++] = thud_body_make(world, thud_circle_at(0, 0, 0.5f), &ball);
    thud_body_options crate = {.kind = THUD_BODY_DYNAMIC,
                               .linear_damping = 1,
                               .angular_damping = 1,
                               .restitution = 0.2f,
                               .density = 0.5f};
    for (int i = 0; i < CARS_CRATES; i++) {
        thud_geometry box = thud_obb_at(4 * (i % 3) - 4, i < 3 ? -3 : 3, 0.5f, 0.5f, 0.3 * i);
        out->bodies[out->count++] = thud_body_make(world, box, &crate);
    }
    for (int i = 0; i < out->count; i++) {
        if (!thud_body_is_valid(world, out->bodies[i])) {
            return false;
        }
    }
    return true;
}

thud_result cars_step(thud_world *world, const uint64_t *inputs, void *state) {
    cars *c = state;
    for (int i = 0; i < c->players; i++) {
        thud_body_id car = c->bodies[i];
        float drive = (float)(inputs[i] % CARS_INPUTS / 3) - 1, turn = (float)(inputs[i] % 3) - 1;
        double angle;
        float cosine, sine, spin;
        thud_vec2 v;
        thud_result result = thud_body_get_rotation(world, car, &angle, &cosine, &sine);
        if (result == THUD_OK) {
            result = thud_body_get_velocity(world, car, &v, &spin);
        }
        if (result != THUD_OK) {
            return result;
        }
        float along = v.x * cosine + v.y * sine + DRIVE * drive / CARS_RATE;
        float across = (v.y * cosine - v.x * sine) * (1 - GRIP);
        v = (thud_vec2){along * cosine - across * sine, along * sine + across * cosine};
        result = thud_body_set_velocity(world, car, v, spin + TURN * turn / CARS_RATE);
        if (result != THUD_OK) {
            return result;
        }
        c->sum = c->sum * 31 + inputs[i];
    }
    return thud_world_step(world);
}

/* The random number of a player and a block of steps. */
static uint64_t drawn(uint64_t seed, int player, int64_t block) {
    uint64_t state = seed ^ ((uint64_t)block * CARS_MAX + (uint64_t)player) << 8;
    return random_next(&state);
}

uint64_t cars_input(uint64_t seed, int player, int64_t step) {
    int64_t block = step / HOLD;
    uint64_t own = drawn(seed, player, block);
    bool began = step % HOLD >= (int64_t)(own >> 32) % LATER;
    if (!began) {
        own = block ? drawn(seed, player, block - 1) : CARS_IDLE;
    }
    /* The three inputs that drive forwards are twice as likely as the others: a car that goes back
     * and forth equally often would stay where it is. */
    uint64_t input = own % (CARS_INPUTS + 3);
    return input < CARS_INPUTS ? input : input - 3;
}
