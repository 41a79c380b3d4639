/* peer.h: a peer, one player's side of a networked game: a world with the game of cars.h, a
 * rollback, and the exchange of packets (messages.h). A packet has all inputs and all events (a
 * player enters or leaves) that its receiver has not confirmed, so that lost packets do no harm;
 * the lead for thud_rollback_set_lead; and the hash of a final step, by which players detect that
 * their games differ. The caller carries the packets, by any network. RollbackPeers of the npm
 * package is the same in JavaScript, for any game.
 *
 * Player 0, the host, is connected with each of the others and passes their inputs on; the others
 * are connected with the host alone. In a mesh all players are connected with each other, and each
 * sends its own inputs alone; the program itself has to tell all of them who enters and leaves
 * (peer_part, peer_meet). */
#ifndef THUD_NETWORK_PEER_H
#define THUD_NETWORK_PEER_H

#include "cars.h"
#include "messages.h"

#include <thud/thud_rollback.h>

/* PEER_INPUTS: steps whose inputs are stored for each player. PEER_HASH_STEPS: every so many steps
 * a hash is computed and sent. PEER_HASHES, PEER_EVENTS: number of hashes and of events that are
 * stored. PEER_BYTES_MAX: length of the longest packet, bytes. */
enum {
    PEER_INPUTS = 1024,
    PEER_HASH_STEPS = 4,
    PEER_HASHES = 64,
    PEER_EVENTS = 64,
    PEER_BYTES_MAX = 1472
};

/* The hash of a step. */
typedef struct peer_hash {
    int64_t step; /* -1: none */
    uint64_t hash;
} peer_hash;

/* The inputs and the presence of a player, as far as this peer knows them. */
typedef struct peer_known {
    unsigned char inputs[PEER_INPUTS]; /* its inputs, by step */
    int64_t since, heard;              /* inputs are known for the steps since .. heard - 1 */
    int64_t gone_from, back_at;        /* absent from step gone_from until before step back_at;
                                          PEER_NEVER: not known */
} peer_known;

/* The connection with another player or a spectator. */
typedef struct peer_link {
    bool is_told;          /* packets are sent to it */
    bool is_joining;       /* it has received the game, and enters as soon as it has caught up
                              (can_enter) */
    int64_t final;         /* the last step whose hash it has sent; -1: none */
    int64_t has[CARS_MAX]; /* by player: the other side has confirmed that player's inputs before
                              this step */
    int events;            /* number of events that it has confirmed */
    peer_hash told;        /* the hash that it sent last, kept until that step is confirmed here;
                              step -1: none */
    int64_t hash_step;     /* the step of the last hash that was received from it */
    int64_t differs_from;  /* the first step whose hash differs between the two; -1: none */
    bool has_come;         /* whether it has sent a packet; the next two are of its newest one: the
                              sender's clock, and the time of arrival, milliseconds */
    int sent;
    int64_t came;
} peer_link;

#define PEER_NEVER INT64_MAX

typedef struct peer {
    cars game; /* the state that is rolled back with the world (CARS_STATE_BYTES of it) */
    thud_world *world;
    thud_rollback *rollback;
    int me, players, depth;
    bool is_mesh;
    int64_t end; /* the steps of the game; 0: it has no end */
    int64_t now; /* time in milliseconds, set by a caller that wants round trips measured; -1:
                    packets carry no times */
    peer_known known[CARS_MAX];
    peer_link links[MESSAGE_NUMBERS];  /* by number: players and spectators */
    message_event events[PEER_EVENTS]; /* by number */
    int event_count, events_applied;
    peer_hash hashes[PEER_HASHES]; /* this peer's hashes of confirmed steps, by step */
    int64_t hashed;                /* the next step whose hash is computed */
    int64_t bytes, messages;       /* bytes and packets written so far */
    int64_t refused;               /* number of packets that were damaged or not allowed */
    int64_t waits;                 /* calls of peer_advance in which no step was run */
} peer;

typedef struct peer_options {
    int me, players, depth; /* the peer's own number, from 0; the others as in thud_rollback_options
                             */
    bool is_mesh;
    int64_t end; /* as in peer */
    const thud_world_def *def;
    thud_rollback_step_fn *step; /* null: cars_step; its state is the peer's game */
} peer_options;

/* Opens a peer: in a mesh connected with all others, else with the host. Nearly all memory that the
 * game needs is allocated here (warm_up, peer.c). False if memory is short. */
bool peer_open(peer *p, const peer_options *options);
void peer_close(peer *p);

/* Gives this player's input for the next step to the rollback, unless it has been given already or
 * the game has no further step. */
thud_result peer_press(peer *p, uint64_t input);

/* Whether packets are sent to a player or spectator. */
bool peer_tells(const peer *p, int number);

/* Writes the packet for a player or spectator to `out`, which has PEER_BYTES_MAX bytes; returns its
 * length. */
int peer_write(peer *p, int number, unsigned char *out);

/* Reads a packet of `count` bytes. Bytes that are no packet, are damaged, or come from another
 * player than `from` change nothing and are counted in `refused`. `from` -1: the sender is the one
 * that the packet names. */
thud_result peer_read(peer *p, int from, const unsigned char *bytes, int count);

/* Runs the next step, unless the rollback waits or the game is at its end, and compares the hashes
 * of confirmed steps. On the host, lets players enter that have joined and caught up. */
thud_result peer_advance(peer *p);

/* Whether the game is at its end here: all inputs are known, and all steps were run with them. */
bool peer_has_ended(const peer *p);
/* Whether the game is at its end, and all connected players have confirmed all that this peer has
 * to send. */
bool peer_is_done(const peer *p);
/* The hash after the last step that is confirmed. */
thud_result peer_hash_of(peer *p, uint64_t *out);

/* ---- the host ---- */

/* Connects a player or spectator that takes part from the first step on. */
void peer_connect(peer *p, int number);
/* Called before the first step for a player that is not connected yet: it is absent. */
thud_result peer_miss(peer *p, int player);
/* Called when a connection has ended. The player, if it is one, leaves the game. */
thud_result peer_lose(peer *p, int number);
/* Whether a player is absent from the next step on. */
bool peer_is_absent(const peer *p, int player);
/* Whether a player or spectator lacks inputs that are no longer stored, so that its connection has
 * to be ended (peer_lose). */
bool peer_is_too_late(const peer *p, int number);

/* Makes the messages that a joining player or spectator has to receive, in order, before packets:
 * *out_welcome, whose `rate` and `seed` the caller sets, and the game, *out_bytes bytes that the
 * caller frees. A joining player is absent until it has caught up, and then enters. *out_game is
 * null while an entry or exit is under way: call again after the next step. */
thud_result peer_invite(peer *p, int number, message_welcome *out_welcome, unsigned char **out_game,
                        size_t *out_bytes);

/* ---- who joins ---- */

/* Joins the game of a welcome from a host, as who was opened with its number and players. */
thud_result peer_accept(peer *p, const message_welcome *welcome, const void *game);
/* Whether the next step lies far behind what is known: who has joined runs until it does not. */
bool peer_is_behind(const peer *p);

/* ---- a mesh ---- */

/* Takes a player's input for the first step for which it is not known yet; for a caller that gets
 * inputs by another way than packets. */
thud_result peer_hear(peer *p, int player, uint64_t input);
/* Called when a player has left before a step, see thud_rollback_leave. */
thud_result peer_part(peer *p, int player, int64_t step);
/* Called when a player comes back at a step; it has this peer's inputs before step `has`. */
thud_result peer_meet(peer *p, int player, int64_t step, int64_t has);
/* Joins the game of another peer, to play from `step` on. */
thud_result peer_join(peer *p, peer *host, int64_t step);

#endif
