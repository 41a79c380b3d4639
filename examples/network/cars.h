/* cars.h: the game that is played over networks: two to eight cars push a ball and crates about a
 * walled field, seen from above, without gravity. A car goes forwards and backwards and turns; its
 * wheels hold it from sliding sideways. cars.mjs is the same game in JavaScript, to the bit. */
#ifndef THUD_NETWORK_CARS_H
#define THUD_NETWORK_CARS_H

#include <thud/thud.h>

/* The most players; crates; bodies that move, at most: cars, the ball, crates. */
enum { CARS_MAX = 8, CARS_CRATES = 6, CARS_BODIES_MAX = CARS_MAX + 1 + CARS_CRATES };

/* Inputs are 3 * (drive + 1) + turn + 1, for drive and turn in [-1, 1]; this one is: hands off. */
enum { CARS_IDLE = 4, CARS_INPUTS = 9 };

/* The steps a second. */
#define CARS_RATE 60

/* The game's own state. */
typedef struct cars {
    uint64_t sum;                         /* a hash of all inputs so far */
    thud_body_id bodies[CARS_BODIES_MAX]; /* the cars, then the ball, then the crates */
    int players, count;                   /* number of cars; of bodies */
} cars;

/* What those who join get of it: its first two members. Handles are those of a world, which is
 * taken over with them. */
enum { CARS_STATE_BYTES = sizeof(uint64_t) + CARS_BODIES_MAX * sizeof(thud_body_id) };

/* Builds the game in an empty world. False where a body cannot be made. */
bool cars_build(thud_world *world, int players, cars *out);

/* What the game's worlds are made of: this quality, no gravity, CARS_RATE steps a second. */
thud_world_def cars_def(const thud_quality *quality);

/* The step of the game, a thud_rollback_step_fn; `state` is the cars. */
thud_result cars_step(thud_world *world, const uint64_t *inputs, void *state);

/* What a player who drives at random does in a step: each input is held for 9 to 55 steps. It
 * follows from the arguments alone. */
uint64_t cars_input(uint64_t seed, int player, int64_t step);

#endif
