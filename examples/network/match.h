/* match.h: what a program does with a peer, whatever carries its messages: a world whose
 * allocations are counted, a clock that follows the other players, a car that drives at random, and
 * the result. */
#ifndef THUD_NETWORK_MATCH_H
#define THUD_NETWORK_MATCH_H

#include "peer.h"

/* The depth of rollbacks, steps: a second at 60 steps a second. */
enum { MATCH_DEPTH = 60 };

typedef struct match {
    peer peer;
    message_welcome game;
    uint64_t seed;     /* of the inputs of the own car, cars_input */
    double next;       /* seconds: when the next frame is due */
    int64_t allocated; /* allocations since the game began */
} match;

/* Begins the game of a welcome, at its first step, now. False, with a message on stderr, if memory
 * is short. */
bool match_open(match *m, const message_welcome *game, uint64_t seed);
void match_close(match *m);

/* Seconds of a clock that never goes back. */
double match_now(void);

/* Seconds until the next frame is due; 0: it is. */
double match_wait(const match *m);

/* Presses the input of a frame that is due: send messages then, and call match_advance. */
thud_result match_press(match *m);
/* Runs the frame's step, and sets when the next one is due: later where this peer is ahead of the
 * others. */
thud_result match_advance(match *m);

/* Prints how the game ended: steps, hash, allocations. False, with a message on stderr, where the
 * game has not come to its end, or another player had another game. */
bool match_print(match *m);

#endif
