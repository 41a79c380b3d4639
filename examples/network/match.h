/* match.h: a match, the part of the example programs that does not depend on the network library: a
 * peer whose allocations are counted, a frame clock that follows the other players, a car that
 * drives at random, and the printed result. */
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

/* Begins the game that a welcome describes, at its first step. False, with a message on stderr, if
 * memory is short. */
bool match_open(match *m, const message_welcome *game, uint64_t seed);
void match_close(match *m);

/* Prints that a player or spectator has arrived: what it has done ("has joined"), and at which
 * step, or, before the game begins, how many players are still `missing`. */
void match_print_arrival(const match *m, int number, const char *what, bool is_playing,
                         int missing);

/* The time of a monotonic clock, s. */
double match_now(void);

/* Seconds until the next frame is due; 0 if it is due now. */
double match_wait(const match *m);

/* Gives the input of a frame that is due to the peer. The caller then sends packets and calls
 * match_advance. */
thud_result match_press(match *m);
/* Runs the frame's step, and sets when the next one is due: later where this peer is ahead of the
 * others. */
thud_result match_advance(match *m);

/* Prints how the game ended: steps, hash, allocations. False, with a message on stderr, if the game
 * was not played to its end, or a player's hashes differ. */
bool match_print(match *m);

#endif
