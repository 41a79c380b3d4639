/* peer.h: one player's machine: a world with the game of cars.h, a rollback, and the messages that
 * players send each other. A message has all inputs that the other player has not confirmed, so
 * that it does not matter which ones are lost, the lead that thud_rollback_set_lead wants, and the
 * hash of a confirmed step, by which players notice that they have different games. peer.mjs is the
 * same in JavaScript, with the same bytes. What carries the messages is not known here. */
#ifndef THUD_NETWORK_PEER_H
#define THUD_NETWORK_PEER_H

#include "cars.h"

#include <thud/thud_rollback.h>

/* The steps of inputs that are stored of each player; hashes are told of every so many steps, and
 * as many are stored; the longest message, bytes, and where in it stand the sender's number, the
 * step of its first input, and the inputs. */
enum {
    PEER_INPUTS = 512,
    PEER_HASH_STEPS = 4,
    PEER_HASHES = 64,
    PEER_BYTES_MAX = 289,
    PEER_SENDER_AT = 4,
    PEER_FIRST_AT = 6,
    PEER_INPUTS_AT = 30
};

/* The hash of a step. */
typedef struct peer_hash {
    int64_t step; /* -1: none */
    uint64_t hash;
} peer_hash;

/* What a peer knows of a player. */
typedef struct peer_other {
    unsigned char inputs[PEER_INPUTS]; /* its inputs, by step */
    int64_t heard;                     /* they are known before this step */
    int64_t confirmed;                 /* it has the own inputs before this step */
    bool is_gone;                      /* nothing is sent to it */
    peer_hash told;       /* what it told last, of a step that is not confirmed here yet */
    int64_t differs_from; /* the first step whose hash it told differently; -1: none */
} peer_other;

typedef struct peer {
    cars game; /* the state that is rolled back; the first member */
    thud_world *world;
    thud_rollback *rollback;
    int me, players, depth;
    int64_t end;                   /* the steps of the game; 0: it has no end */
    int64_t told;                  /* own inputs given so far */
    peer_other others[CARS_MAX];   /* of the own number: the own inputs */
    peer_hash hashes[PEER_HASHES]; /* own ones of confirmed steps, by step */
    int64_t hashed;                /* the next step of which the hash is told */
    int64_t bytes, messages;       /* written so far */
    int64_t refused;               /* messages that were damaged, or no messages at all */
    int64_t waits;                 /* calls of peer_advance in which no step was run */
} peer;

typedef struct peer_options {
    int me, players, depth; /* the own number, from 0; as in thud_rollback_options */
    int64_t end;            /* as in peer */
    const thud_world_def *def;
    thud_rollback_step_fn *step; /* null: cars_step; its state is the peer's game */
} peer_options;

/* Sets up a player's machine. The memory that playing needs is allocated here; few lists of the
 * world may grow once more. False if it cannot
 * be made. */
bool peer_open(peer *p, const peer_options *options);
void peer_close(peer *p);

/* Gives the own input of the next step to the rollback, unless that has been done, or the game has
 * no further step. */
thud_result peer_press(peer *p, uint64_t input);

/* Whether a message to a player would tell it anything: it is another one, and has not gone. */
bool peer_tells(const peer *p, int player);

/* Writes the message to another player to `out` of PEER_BYTES_MAX bytes; returns its length. */
int peer_write(peer *p, int player, unsigned char *out);

/* Reads a message of `count` bytes. What is no message, or damaged, changes nothing and is counted
 * in `refused`. */
thud_result peer_read(peer *p, const unsigned char *bytes, int count);

/* Runs the next step, unless the rollback waits or the game is at its end, and compares the hashes
 * of confirmed steps. */
thud_result peer_advance(peer *p);

/* Whether the game is at its end here: all inputs are known, and all steps were run with them. */
bool peer_has_ended(const peer *p);
/* Whether, besides, every other player has all own inputs: nothing is left to be sent. */
bool peer_is_done(const peer *p);
/* The hash after the last step that is confirmed. */
thud_result peer_hash_of(peer *p, uint64_t *out);

/* The input of a player in the first step of which it is not known; for who knows it otherwise than
 * by a message. */
thud_result peer_hear(peer *p, int player, uint64_t input);
/* The player has left before a step, see thud_rollback_leave. */
thud_result peer_part(peer *p, int player, int64_t step);
/* The player comes back at a step, and has the own inputs before `has`. */
thud_result peer_meet(peer *p, int player, int64_t step, int64_t has);
/* Joins the game that another peer has, to play from a step on. */
thud_result peer_join(peer *p, peer *host, int64_t step);

/* ---- bytes ---- */

/* Numbers with their low bytes first, and the checksum that ends every message: FNV-1a of 32 bits
 * (Fowler, Noll, Vo). */
void peer_put_number(unsigned char *at, uint64_t value, int bytes);
uint64_t peer_number_at(const unsigned char *at, int bytes);
/* Writes the checksum of `count` bytes behind them; returns the length with it. */
int peer_seal(unsigned char *bytes, int count);
/* Whether the last of `count` bytes are the checksum of those before. */
bool peer_is_sealed(const unsigned char *bytes, int count);

#endif
