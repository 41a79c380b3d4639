/* over_wire.h: the peers of examples/network over the simulated network. */
#ifndef THUD_NETWORK_OVER_WIRE_H
#define THUD_NETWORK_OVER_WIRE_H

#include "peer.h"
#include "wire.h"

/* The worst network on which tests play, but for its delay, ms. */
wire_options worst_wire(double delay, uint64_t seed);

/* Opens a peer of a game without an end. */
bool open_player(peer *p, int me, int players, int depth, const thud_world_def *def);

/* Presses what cars_input gives a player for the next step. */
thud_result press_at_random(peer *p, uint64_t seed);

/* Sends each other player what it is not known to have. False where memory is short. */
bool send_over(peer *p, wire *w, double now);

/* Gives the peer what has arrived by now. */
thud_result receive_over(peer *p, wire *w, double now);

#endif
