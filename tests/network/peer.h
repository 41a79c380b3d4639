/* peer.h: one player's machine: a world with the game of cars.h, a rollback, and messages of inputs
 * over a wire. A message has all inputs that the other player has not confirmed, so that it does
 * not matter which ones are lost. */
#ifndef THUD_NETWORK_PEER_H
#define THUD_NETWORK_PEER_H

#include "cars.h"
#include "wire.h"

#include <thud/thud_rollback.h>

/* The most steps of inputs that are kept to be sent. */
enum { PEER_INPUTS = 512 };

typedef struct peer {
    thud_world *world;
    thud_rollback *rollback;
    cars game;
    int me, players;
    uint64_t seed;                     /* of the players' inputs, cars_input */
    int64_t told;                      /* own inputs given so far */
    int64_t heard[CARS_MAX];           /* inputs known of each player: all before this step */
    int64_t confirmed[CARS_MAX];       /* own inputs that each player has: all before this step */
    unsigned char inputs[PEER_INPUTS]; /* own ones, by step */
    int64_t bytes, messages;           /* sent so far, without the heads of IP and UDP */
    int64_t refused;                   /* messages that were damaged, or no messages at all */
} peer;

/* Sets up a player's machine; `depth` is the rollback's, `def` the world's. False if it cannot be
 * made. */
bool peer_open(peer *p, int me, int players, int depth, uint64_t seed, const thud_world_def *def);
void peer_close(peer *p);

/* Reads the own input of the next step, unless that has been done, and gives it to the rollback. */
thud_result peer_press(peer *p);

/* Sends what each other player is not known to have. False where memory is short. */
bool peer_send(peer *p, wire *w, double now);

/* Gives the rollback what has arrived by now. */
thud_result peer_receive(peer *p, wire *w, double now);

/* Reads a message of `count` bytes. What is no message, or damaged, changes nothing and is counted
 * in `refused`. */
thud_result peer_read(peer *p, const unsigned char *bytes, int count);

#endif
