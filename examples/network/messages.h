/* messages.h: the messages of players of a game with rollback. The package of npm writes and reads
 * the same bytes (web/package/src/net/messages.ts). Numbers are little-endian. Each message begins
 * with a mark of four letters, and ends with the 32-bit FNV-1a hash (Fowler, Noll, Vo) of all bytes
 * before it.
 *
 * A packet may be lost, duplicated or late. Its bytes, by offset and number:
 *     0  4  "TNP3"
 *     4  1  the sender's number
 *     5  1  flags: 1: the packet has times; 2: it has events
 *     6  2  the sender's lead over the receiver, steps, signed
 *     8  4  a step whose hash the sender knows, plus 1; 0: none
 *    12  8  that hash
 *    20  1  number of acknowledgements
 *    21  1  number of runs
 * Then follow, each number with its bytes in front:
 *     times, milliseconds modulo 2^16: 2, the sender's clock; 2, the clock in the newest packet
 * that it has from the receiver; 2, how long ago that packet came, or 0xffff if none has come
 *     events: 2, number of events that the sender has; 2, number of the first event that follows;
 *       1, how many follow; for each of them: 1, whether a player enters (1) or leaves (0); 1, the
 *       player; 4, the step before which it does so
 *     acknowledgements, each: 1, a player; 4, the step before which the sender has its inputs
 *     runs of inputs, each: 1, a player; 4, the step of the first input; 1, number of inputs; the
 *       inputs, a byte each
 *
 * These messages must arrive, so that they need a reliable channel:
 *     hello, from a client that connects: "TNH1"; 1, whether it only watches; 8, a token other than
 *       0 by which it is recognised when it connects again
 *     welcome, the answer: "TNW2"; 1, the receiver's number; 1, number of players; 2, steps a
 * second; 2, depth of the rollback; 4, steps of the game, 0: no end; 4, its seed; 4, the step
 * before which the receiver begins; 2, number of events before that step; 4, a bit for each player
 *       that is absent; 4, bytes of the game; 4, how many of these, at their end, are the program's
 *     part of a game: "TNG1"; 4, the offset of the part in the game; the bytes of the part
 *     migration, from a player whose host is gone to the player that takes the host's place
 *       (RollbackPeers alone): "TNM1"; 1, the sender's number; 1, number of players; 4, the step
 *       before which everything is final for the sender; 2, number of the first event that follows;
 *       2, how many follow; these, as in a packet; for each player: 4, a step; 2, how many inputs
 *       the sender has from that step on; the inputs */
#ifndef THUD_NETWORK_MESSAGES_H
#define THUD_NETWORK_MESSAGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Numbers that players and spectators (clients that only watch) may have; maximum number of
 * players; maximum number of inputs in a run, and of events in a packet; bytes of a game in one
 * part; maximum lead, steps; bytes of the checksum, of a hello, of a welcome, and of the longest
 * part. */
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

/* A player enters or leaves the game before a step. */
typedef struct message_event {
    bool enters;
    int player;
    int64_t step;
} message_event;

/* Inputs of a player for successive steps, from `first` on. */
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
    int sent, echo, held;   /* the times; held -1: no packet has come */
    int known, first_event; /* of events */
    int events, acks, runs; /* lengths of the three arrays */
    message_event event[MESSAGE_EVENTS_MAX];
    message_ack ack[MESSAGE_PLAYERS_MAX];
    message_run run[MESSAGE_PLAYERS_MAX]; /* for a packet that was read, `inputs` points into its
                                             bytes */
} message_packet;

/* Maximum length of a packet in a game with so many players, bytes. */
static inline int message_packet_max(int players) {
    return 22 + 6 + 5 + 6 * MESSAGE_EVENTS_MAX + players * (5 + 6 + MESSAGE_RUN_MAX) + MESSAGE_SUM;
}

/* Writes a packet; returns its length. */
int message_write_packet(const message_packet *packet, unsigned char *out);
/* Reads a packet. False for bytes that are damaged, or are no packet of a game with so many players
 * and so many different inputs. */
bool message_read_packet(const unsigned char *bytes, int count, int players, int inputs,
                         message_packet *out);

typedef struct message_hello {
    bool watches;
    uint64_t token;
} message_hello;

int message_write_hello(const message_hello *hello, unsigned char *out);
bool message_read_hello(const unsigned char *bytes, int count, message_hello *out);

/* The data that a player needs to begin a game, or to join it. */
typedef struct message_welcome {
    int own, players; /* its own number; number of players, the host included */
    int rate;         /* steps a second */
    int depth;        /* of the rollback */
    int64_t end;      /* steps of the game; 0: it has no end */
    uint32_t seed;
    int64_t step; /* it begins before this one */
    int events;
    uint32_t absent;
    int64_t bytes; /* bytes of the game, which follow in parts; 0: the receiver begins with the
                      first step */
    int64_t more;  /* how many of these bytes, at their end, are the program's own */
} message_welcome;

int message_write_welcome(const message_welcome *welcome, unsigned char *out);
bool message_read_welcome(const unsigned char *bytes, int count, message_welcome *out);

/* Writes the part of a game that begins at byte `at`; `bytes`: length of the whole game. Returns
 * the length of the message. */
int message_write_part(const unsigned char *game, size_t bytes, size_t at, unsigned char *out);
/* Reads the part of a game of `bytes` bytes that begins at a place into the game; returns how many
 * bytes of it that were; 0: it is no such part, or damaged. */
size_t message_read_part(const unsigned char *part, int count, unsigned char *game, size_t bytes,
                         size_t at);

/* ---- bytes ---- */

void message_put(unsigned char *at, uint64_t value, int bytes);
uint64_t message_number(const unsigned char *at, int bytes);
/* Appends the checksum of `count` bytes to them; returns the length including it. */
int message_seal(unsigned char *bytes, int count);

#endif
