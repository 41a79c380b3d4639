/* wire.h: a simulated network that carries datagrams between players: they are late, by a varying
 * time, lost, delivered twice, and overtake one another. The same options and the same calls give
 * the same deliveries on every platform. It has no clock; callers say what time it is. */
#ifndef THUD_NETWORK_WIRE_H
#define THUD_NETWORK_WIRE_H

#include <stdbool.h>
#include <stdint.h>

/* The most bytes of a datagram, what fits into one Ethernet frame; what UDP and IPv4 put before
 * each. */
enum { WIRE_BYTES_MAX = 1472, WIRE_HEAD_BYTES = 28 };

typedef struct wire_options {
    double delay;      /* ms, one way */
    double jitter;     /* ms; each datagram takes longer by an even chance from 0 to this */
    double loss;       /* share of datagrams that never arrive, [0, 1] */
    double duplicates; /* share of those that arrive twice, the second time by a delay of its own */
    double held;       /* share of those that take `held_for` longer, so that later ones overtake
                          them */
    double held_for;   /* ms */
    uint64_t seed;
} wire_options;

/* What it has done so far. */
typedef struct wire_counts {
    int64_t sent, lost, duplicated, held, delivered;
    int64_t overtaken; /* delivered after a later one from the same to the same player */
} wire_counts;

typedef struct wire wire;

/* Null where memory is short. */
wire *wire_create(const wire_options *options);
void wire_destroy(wire *w);
wire_counts wire_counts_of(const wire *w);

/* Sends `count` bytes, [0, WIRE_BYTES_MAX], at the time `now`, ms. False where memory is short. */
bool wire_send(wire *w, int from, int to, double now, const void *bytes, int count);

/* The next datagram for a player that has arrived by the time `now`, ms: its bytes are copied to
 * `out` of WIRE_BYTES_MAX bytes, and their count is returned; -1 where there is none. *out_from
 * (may be null) is its sender. */
int wire_receive(wire *w, int to, double now, void *out, int *out_from);

/* What is on its way to a player, or from it, is lost. */
void wire_cut(wire *w, int player);

#endif
