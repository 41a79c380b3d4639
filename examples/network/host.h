/* host.h: what the program that players join tells them, besides the messages of peer.h: that the
 * game begins, and that a player has left. The host is player 0. host.mjs reads the same bytes. */
#ifndef THUD_NETWORK_HOST_H
#define THUD_NETWORK_HOST_H

#include "peer.h"

/* The longest of these messages, bytes. */
enum { HOST_BYTES_MAX = 269 };

/* What a player has to know to begin. */
typedef struct host_welcome {
    int player, players; /* its own number; how many there are, the host included */
    int rate;            /* steps a second */
    int depth;           /* of the rollback */
    int64_t steps;       /* of the game, > 0 */
} host_welcome;

/* Writes a welcome to `out` of HOST_BYTES_MAX bytes; returns its length. */
int host_write_welcome(const host_welcome *w, unsigned char *out);
/* False for bytes that are no welcome, or damaged. */
bool host_read_welcome(const unsigned char *bytes, int count, host_welcome *out);

/* Writes that a player has left before the first step of which the host has not its input, with its
 * inputs of the steps before, which others may lack. */
int host_write_leave(const peer *p, int player, unsigned char *out);

#endif
