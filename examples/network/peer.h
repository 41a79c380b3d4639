/* peer.h: one player's machine: a world with the game of cars.h, a rollback, and what players tell
 * each other (messages.h). A packet has all inputs, and who leaves and enters, that its receiver
 * has not confirmed, so that it does not matter which packets are lost; the lead that
 * thud_rollback_set_lead wants; and the hash of a final step, by which players notice that they
 * have different games. RollbackPeers of the package is the same in JavaScript, for any game. What
 * carries the messages is not known here.
 *
 * Player 0, the host, is connected with each of the others and passes their inputs on; the others
 * are connected with the host alone. In a mesh all are connected, each tells its own inputs, and
 * what is said of who leaves and enters comes otherwise than by packets. */
#ifndef THUD_NETWORK_PEER_H
#define THUD_NETWORK_PEER_H

#include "cars.h"
#include "messages.h"

#include <thud/thud_rollback.h>

/* The steps of inputs that are stored of each player; hashes are told of every so many steps, and
 * as many are stored; events that are stored; the longest packet, bytes. */
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

/* What is known of a player. */
typedef struct peer_known {
    unsigned char inputs[PEER_INPUTS]; /* its inputs, by step */
    int64_t since, heard;              /* they are known from one step until before the other */
    int64_t gone_from, back_at;        /* absent from one step until before the other; PEER_NEVER */
} peer_known;

/* Somebody to whom packets are sent. */
typedef struct peer_link {
    bool is_told;          /* packets are sent to it */
    bool is_joining;       /* it enters as soon as it has come near enough to the present */
    int64_t has[CARS_MAX]; /* by player: it has its inputs before this step */
    int events;            /* it has so many */
    peer_hash told;        /* what it told last, of a step that is not confirmed here yet */
    int64_t hash_step;     /* the step of the last hash that was taken from it */
    int64_t differs_from;  /* the first step whose hash it told differently; -1: none */
    bool has_come;         /* a packet of it, the newest of which has these times: */
    int sent;
    int64_t came;
} peer_link;

#define PEER_NEVER INT64_MAX

typedef struct peer {
    cars game; /* the state that is rolled back: its first member; the first member */
    thud_world *world;
    thud_rollback *rollback;
    int me, players, depth;
    bool is_mesh;
    int64_t end; /* the steps of the game; 0: it has no end */
    int64_t now; /* milliseconds, for who measures round trips; -1, unless the caller sets it */
    peer_known known[CARS_MAX];
    peer_link links[MESSAGE_NUMBERS];  /* by number: players, and who only watches */
    message_event events[PEER_EVENTS]; /* by number */
    int event_count, events_applied;
    peer_hash hashes[PEER_HASHES]; /* own ones of confirmed steps, by step */
    int64_t hashed;                /* the next step of which the hash is told */
    int64_t bytes, messages;       /* written so far */
    int64_t refused;               /* messages that were damaged, or no messages at all */
    int64_t waits;                 /* calls of peer_advance in which no step was run */
} peer;

typedef struct peer_options {
    int me, players, depth; /* the own number, from 0; as in thud_rollback_options */
    bool is_mesh;
    int64_t end; /* as in peer */
    const thud_world_def *def;
    thud_rollback_step_fn *step; /* null: cars_step; its state is the peer's game */
} peer_options;

/* Sets up a player's machine, in a mesh connected with all others, else with the host. The memory
 * that playing needs is allocated here; few lists of the world may grow once more. False if it
 * cannot be made. */
bool peer_open(peer *p, const peer_options *options);
void peer_close(peer *p);

/* Gives the own input of the next step to the rollback, unless that has been done, or the game has
 * no further step. */
thud_result peer_press(peer *p, uint64_t input);

/* Whether packets are sent to somebody. */
bool peer_tells(const peer *p, int number);

/* Writes the packet to somebody to `out` of PEER_BYTES_MAX bytes; returns its length. */
int peer_write(peer *p, int number, unsigned char *out);

/* Reads a packet of `count` bytes. What is no packet, or damaged, or of another than `from`,
 * changes nothing and is counted in `refused`; `from` -1: of whoever it says. */
thud_result peer_read(peer *p, int from, const unsigned char *bytes, int count);

/* Runs the next step, unless the rollback waits or the game is at its end, and compares the hashes
 * of confirmed steps. On the host, who has joined and caught up enters. */
thud_result peer_advance(peer *p);

/* Whether the game is at its end here: all inputs are known, and all steps were run with them. */
bool peer_has_ended(const peer *p);
/* Whether, besides, everyone has what this player knows: nothing is left to be sent. */
bool peer_is_done(const peer *p);
/* The hash after the last step that is confirmed. */
thud_result peer_hash_of(peer *p, uint64_t *out);

/* ---- the host ---- */

/* Packets are sent to somebody, who has the game from its first step on. */
void peer_connect(peer *p, int number);
/* Before the first step: a player is not there yet. */
thud_result peer_miss(peer *p, int player);
/* The connection with somebody has ended. */
thud_result peer_lose(peer *p, int number);
/* Whether a player is absent from the next step on. */
bool peer_is_absent(const peer *p, int player);
/* Whether somebody lacks inputs that are not stored any more: it has to be lost. */
bool peer_is_too_late(const peer *p, int number);

/* What somebody who joins has to get, in order, before packets: *out_welcome, whose `rate` and
 * `seed` the caller sets, and the game, *out_bytes bytes that the caller frees. As a player, who
 * is absent, it enters as soon as it has come near enough to the present. *out_game is null while
 * somebody is leaving or entering: ask again after the next step. */
thud_result peer_invite(peer *p, int number, message_welcome *out_welcome, unsigned char **out_game,
                        size_t *out_bytes);

/* ---- a mesh ---- */

/* The input of a player in the first step of which it is not known; for who knows it otherwise than
 * by a message. */
thud_result peer_hear(peer *p, int player, uint64_t input);
/* The player has left before a step, see thud_rollback_leave. */
thud_result peer_part(peer *p, int player, int64_t step);
/* The player comes back at a step, and has the own inputs before `has`. */
thud_result peer_meet(peer *p, int player, int64_t step, int64_t has);
/* Joins the game that another peer has, to play from a step on. */
thud_result peer_join(peer *p, peer *host, int64_t step);

#endif
