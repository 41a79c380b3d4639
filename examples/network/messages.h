/* messages.h: the bytes that players of a rollback tell each other. The package of npm writes and
 * reads the same bytes (web/package/src/net/messages.ts). All numbers have their low bytes first;
 * each message begins with a mark of four letters, and ends with the FNV-1a of 32 bits (Fowler,
 * Noll, Vo) of all bytes before it.
 *
 * A packet may be lost, doubled or late:
 *     0  4  "TNP3"
 *     4  1  the sender's number
 *     5  1  flags: 1: the times follow; 2: the events follow
 *     6  2  the sender's lead over the receiver, with a sign
 *     8  4  a step of which the sender has the hash, plus 1; 0: none
 *    12  8  the hash
 *    20  1  number of acknowledgements
 *    21  1  number of runs
 *           times: 2, the sender's clock; 2, that of the newest packet of the receiver; 2, how long
 *           ago that has come, 0xffff: none has. Milliseconds of 16 bits
 *           events: 2, number of those that the sender has; 2, number of the first that follows; 1,
 *           how many follow; of each one 1, whether a player enters (1) or leaves (0); 1, the
 *           player; 4, the step before which it does
 *           by acknowledgement: 1, a player; 4, the step before which the sender has its inputs
 *           by run: 1, a player; 4, the step of the first input; 1, their number; the inputs
 * What must arrive:
 *     hello, of who comes: "TNH1"; 1, whether it only watches; 8, a number other than 0 by which it
 *     is known again
 *     welcome: "TNW2"; 1, the receiver's number; 1, players; 2, steps a second; 2, depth of the
 *     rollback; 4, steps of the game, 0: no end; 4, its seed; 4, the step before which the receiver
 *     begins; 2, events that are over by then; 4, who is absent, by bits; 4, bytes of the game; 4,
 *     how many of these, the last ones, the program has added
 *     part of a game: "TNG1"; 4, its place in the game; its bytes */
#ifndef THUD_NETWORK_MESSAGES_H
#define THUD_NETWORK_MESSAGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Numbers of players and of who only watches; players at most; inputs of a run, and events of a
 * packet, at most; bytes of a game in a part; the largest lead; bytes of the longest packet, of a
 * hello, a welcome and the longest part. */
enum {
    MESSAGE_NUMBERS = 32,
    MESSAGE_PLAYERS_MAX = MESSAGE_NUMBERS - 1,
    MESSAGE_RUN_MAX = 120,
    MESSAGE_EVENTS_MAX = 16,
    MESSAGE_PART = 8192,
    MESSAGE_LEAD_MAX = 1000,
    MESSAGE_SUM = 4,
    MESSAGE_HELLO_BYTES = 17,
    MESSAGE_WELCOME_BYTES = 40,
    MESSAGE_PART_BYTES_MAX = 8 + MESSAGE_PART + MESSAGE_SUM
};

/* A player leaves, or enters, before a step. */
typedef struct message_event {
    bool enters;
    int player;
    int64_t step;
} message_event;

/* Inputs of a player from a step on. */
typedef struct message_run {
    int player, count;
    int64_t first;
    const unsigned char *inputs;
} message_run;

typedef struct message_ack {
    int player;
    int64_t step;
} message_ack;

typedef struct message_packet {
    int from, lead;
    int64_t hash_step; /* -1: none */
    uint64_t hash;
    bool has_time, has_events;
    int sent, echo, held;   /* held -1: none has come */
    int known, first_event; /* of events */
    int events, acks, runs; /* numbers of these */
    message_event event[MESSAGE_EVENTS_MAX];
    message_ack ack[MESSAGE_PLAYERS_MAX];
    message_run run[MESSAGE_PLAYERS_MAX]; /* of a packet that was read, their inputs are in it */
} message_packet;

/* The bytes of a packet of a game with so many players at most. */
static inline int message_packet_max(int players) {
    return 22 + 6 + 5 + 6 * MESSAGE_EVENTS_MAX + players * (5 + 6 + MESSAGE_RUN_MAX) + MESSAGE_SUM;
}

/* Writes a packet; returns its length. */
int message_write_packet(const message_packet *packet, unsigned char *out);
/* False for bytes that are no packet of a game with so many players and different inputs, or
 * damaged. */
bool message_read_packet(const unsigned char *bytes, int count, int players, int inputs,
                         message_packet *out);

typedef struct message_hello {
    bool watches;
    uint64_t token;
} message_hello;

int message_write_hello(const message_hello *hello, unsigned char *out);
bool message_read_hello(const unsigned char *bytes, int count, message_hello *out);

/* What a player has to know to begin. */
typedef struct message_welcome {
    int own, players; /* its number; how many there are, the host included */
    int rate;         /* steps a second */
    int depth;        /* of the rollback */
    int64_t end;      /* steps of the game; 0: it has no end */
    uint32_t seed;
    int64_t step; /* it begins before this one */
    int events;
    uint32_t absent;
    int64_t bytes; /* of the game, which follow in parts; 0: it begins with the first step */
    int64_t more;  /* how many of these, the last ones, the program has added */
} message_welcome;

int message_write_welcome(const message_welcome *welcome, unsigned char *out);
bool message_read_welcome(const unsigned char *bytes, int count, message_welcome *out);

/* Writes the part of a game of `bytes` bytes that begins at a place. */
int message_write_part(const unsigned char *game, size_t bytes, size_t at, unsigned char *out);

/* ---- bytes ---- */

void message_put(unsigned char *at, uint64_t value, int bytes);
uint64_t message_number(const unsigned char *at, int bytes);
/* Writes the checksum of `count` bytes behind them; returns the length with it. */
int message_seal(unsigned char *bytes, int count);

#endif
