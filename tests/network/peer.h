/* peer.h: one player's machine: a world with the game of cars.h, a rollback, and messages over a
 * wire. A message has all inputs that the other player has not confirmed, so that it does not
 * matter which ones are lost, the lead that thud_rollback_set_lead wants, and the hash of a
 * confirmed step, by which players notice that they have different games. */
#ifndef THUD_NETWORK_PEER_H
#define THUD_NETWORK_PEER_H

#include "cars.h"
#include "wire.h"

#include <thud/thud_rollback.h>

/* The most steps of inputs that are kept to be sent; hashes are told of every so many steps, and as
 * many are kept. */
enum { PEER_INPUTS = 512, PEER_HASH_STEPS = 4, PEER_HASHES = 64 };

/* The hash of a step. */
typedef struct peer_hash {
    int64_t step; /* -1: none */
    uint64_t hash;
} peer_hash;

/* What a peer knows of another player. */
typedef struct peer_other {
    int64_t heard;        /* its inputs are known before this step */
    int64_t confirmed;    /* it has the own inputs before this step */
    bool is_gone;         /* nothing is sent to it */
    peer_hash told;       /* what it told last, of a step that is not confirmed here yet */
    int64_t differs_from; /* the first step whose hash it told differently; -1: none */
} peer_other;

typedef struct peer {
    cars game; /* the state that is rolled back; the first member */
    thud_world *world;
    thud_rollback *rollback;
    int me, players;
    uint64_t seed; /* of the players' inputs, cars_input */
    int64_t told;  /* own inputs given so far */
    peer_other others[CARS_MAX];
    peer_hash hashes[PEER_HASHES];     /* own ones of confirmed steps, by step */
    int64_t hashed;                    /* the next step of which the hash is told */
    unsigned char inputs[PEER_INPUTS]; /* own ones, by step */
    int64_t bytes, messages;           /* sent so far, without the heads of IP and UDP */
    int64_t refused;                   /* messages that were damaged, or no messages at all */
    int64_t waits;                     /* calls of peer_advance in which no step was run */

    /* Of a cheat: before the step `pushes_at` it pushes its car; it tells player `lies_to` another
     * input of the step `lies_at`. -1: never. */
    int64_t pushes_at, lies_at;
    int lies_to;
} peer;

/* Sets up a player's machine; `depth` is the rollback's, `def` the world's. False if it cannot be
 * made. */
bool peer_open(peer *p, int me, int players, int depth, uint64_t seed, const thud_world_def *def);
void peer_close(peer *p);

/* Reads the own input of the next step, unless that has been done, and gives it to the rollback. */
thud_result peer_press(peer *p);

/* Sends each other player what it is not known to have. False where memory is short. */
bool peer_send(peer *p, wire *w, double now);

/* Gives the rollback what has arrived by now. */
thud_result peer_receive(peer *p, wire *w, double now);

/* Reads a message of `count` bytes. What is no message, or damaged, changes nothing and is counted
 * in `refused`. */
thud_result peer_read(peer *p, const unsigned char *bytes, int count);

/* Runs the next step, unless the rollback waits, and compares the hashes of confirmed steps. */
thud_result peer_advance(peer *p);

/* The player has left before a step, see thud_rollback_leave. Its inputs before it, which somebody
 * has, are told. */
thud_result peer_part(peer *p, int player, int64_t step);
/* The player comes back at a step, and has the own inputs before `has`. */
thud_result peer_meet(peer *p, int player, int64_t step, int64_t has);
/* Joins the game that another peer has, to play from a step on. */
thud_result peer_join(peer *p, peer *host, int64_t step);

#endif
