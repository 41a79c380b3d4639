/* cars.h: the game that the network examples play: two to eight cars push a ball and crates about a
 * walled field, seen from above, without gravity. A car drives forwards and backwards and turns;
 * its wheels damp sideways motion. cars.mjs is the same game in JavaScript; both compute the same
 * bits. */
#ifndef THUD_NETWORK_CARS_H
#define THUD_NETWORK_CARS_H

#include <thud/thud.h>

/* CARS_MAX: maximum number of players, one car each. CARS_CRATES: number of crates.
 * CARS_BODIES_MAX: maximum number of moving bodies (cars, the ball, crates). */
enum { CARS_MAX = 8, CARS_CRATES = 6, CARS_BODIES_MAX = CARS_MAX + 1 + CARS_CRATES };

/* An input is 3 * (drive + 1) + turn + 1, for drive and turn of -1, 0 or 1, one of CARS_INPUTS
 * values. CARS_IDLE is the input of a player who does nothing. */
enum { CARS_IDLE = 4, CARS_INPUTS = 9 };

/* The steps a second. */
#define CARS_RATE 60

/* The state of the game that is not in the world. A rollback saves and restores its first two
 * members with the world (CARS_STATE_BYTES). */
typedef struct cars {
    uint64_t sum;                         /* a hash of all inputs so far */
    thud_body_id bodies[CARS_BODIES_MAX]; /* the cars, then the ball, then the crates */
    int players, count;                   /* number of cars; of bodies */
} cars;

/* Bytes of the first two members of `cars`, which a player who joins receives together with a
 * snapshot of the world; the handles of bodies are valid in that world. */
enum { CARS_STATE_BYTES = sizeof(uint64_t) + CARS_BODIES_MAX * sizeof(thud_body_id) };

/* Builds the game in an empty world. False if memory for a body is short. */
bool cars_build(thud_world *world, int players, cars *out);

/* The def of the game's world: the given quality, no gravity, CARS_RATE steps a second. */
thud_world_def cars_def(const thud_quality *quality);

/* Runs a step of the game (a thud_rollback_step_fn). `inputs`: one for each player; `state`: the
 * struct cars. */
thud_result cars_step(thud_world *world, const uint64_t *inputs, void *state);

/* The input of a player who drives at random, in a given step. Each input is held for 9 to 55
 * steps. The result depends on the arguments alone. */
uint64_t cars_input(uint64_t seed, int player, int64_t step);

#endif
