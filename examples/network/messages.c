/* messages.c: see messages.h. */
#include "messages.h"

#include <string.h>

/* "TNP3", "TNH1", "TNW2", "TNG1" */
static const uint32_t PACKET = 0x33504e54, HELLO = 0x31484e54, WELCOME = 0x32574e54,
                      GAME = 0x31474e54;

enum { TIMED = 1, EVENTFUL = 2 };

enum { HEAD = 22, TIME = 6, EVENTS_HEAD = 5, EVENT = 6, ACK = 5, RUN_HEAD = 6, PART_HEAD = 8 };

/* The value of `held` in the bytes of a packet if the sender has received no packet. */
enum { NONE_CAME = 0xffff };

/* Maximum size of a game that a player may join, bytes. A larger one is refused, since the number
 * comes from another machine. */
static const int64_t GAME_MAX = 1 << 26;

/* ---- bytes ---- */

void message_put(unsigned char *at, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) {
        at[i] = (unsigned char)(value >> (8 * i));
    }
}

uint64_t message_number(const unsigned char *at, int bytes) {
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++) {
        value |= (uint64_t)at[i] << (8 * i);
    }
    return value;
}

static uint32_t checksum(const unsigned char *bytes, int count) {
    uint32_t sum = 2166136261u;
    for (int i = 0; i < count; i++) {
        sum = (sum ^ bytes[i]) * 16777619u;
    }
    return sum;
}

int message_seal(unsigned char *bytes, int count) {
    message_put(bytes + count, checksum(bytes, count), MESSAGE_SUM);
    return count + MESSAGE_SUM;
}

static bool is_sealed(const unsigned char *bytes, int count, uint32_t mark, int least) {
    return count >= least && message_number(bytes, 4) == mark &&
           message_number(bytes + count - MESSAGE_SUM, MESSAGE_SUM) ==
               checksum(bytes, count - MESSAGE_SUM);
}

/* The position at which the next number is written (out) or read (in). */
typedef struct cursor {
    unsigned char *out;
    const unsigned char *in, *end;
    bool is_whole; /* false once a read has reached beyond the end */
} cursor;

static void put(cursor *c, uint64_t value, int bytes) {
    message_put(c->out, value, bytes);
    c->out += bytes;
}

static const unsigned char *take(cursor *c, int bytes) {
    const unsigned char *at = c->in;
    c->is_whole = c->is_whole && c->end - c->in >= bytes;
    c->in += c->is_whole ? bytes : 0;
    return c->is_whole ? at : NULL;
}

/* Reads the next number; 0 beyond the end. */
static int64_t take_number(cursor *c, int bytes) {
    const unsigned char *at = take(c, bytes);
    return at ? (int64_t)message_number(at, bytes) : 0;
}

/* ---- packets ---- */

int message_write_packet(const message_packet *p, unsigned char *out) {
    cursor c = {.out = out};
    put(&c, PACKET, 4);
    put(&c, (uint64_t)p->from, 1);
    put(&c, (p->has_time ? TIMED : 0) + (p->has_events ? EVENTFUL : 0), 1);
    put(&c, (uint64_t)p->lead, 2);
    put(&c, (uint64_t)(p->hash_step + 1), 4);
    put(&c, p->hash, 8);
    put(&c, (uint64_t)p->acks, 1);
    put(&c, (uint64_t)p->runs, 1);
    if (p->has_time) {
        put(&c, (uint64_t)p->sent, 2);
        put(&c, (uint64_t)p->echo, 2);
        put(&c, p->held < 0 ? NONE_CAME : (uint64_t)p->held, 2);
    }
    if (p->has_events) {
        put(&c, (uint64_t)p->known, 2);
        put(&c, (uint64_t)p->first_event, 2);
        put(&c, (uint64_t)p->events, 1);
        for (int i = 0; i < p->events; i++) {
            put(&c, p->event[i].enters, 1);
            put(&c, (uint64_t)p->event[i].player, 1);
            put(&c, (uint64_t)p->event[i].step, 4);
        }
    }
    for (int i = 0; i < p->acks; i++) {
        put(&c, (uint64_t)p->ack[i].player, 1);
        put(&c, (uint64_t)p->ack[i].step, 4);
    }
    for (int i = 0; i < p->runs; i++) {
        put(&c, (uint64_t)p->run[i].player, 1);
        put(&c, (uint64_t)p->run[i].first, 4);
        put(&c, (uint64_t)p->run[i].count, 1);
        memcpy(c.out, p->run[i].inputs, (size_t)p->run[i].count);
        c.out += p->run[i].count;
    }
    return message_seal(out, (int)(c.out - out));
}

static bool read_events(cursor *c, int players, message_packet *out) {
    out->known = (int)take_number(c, 2);
    out->first_event = (int)take_number(c, 2);
    out->events = (int)take_number(c, 1);
    bool is_right = out->events <= MESSAGE_EVENTS_MAX;
    for (int i = 0; i < out->events && is_right; i++) {
        int64_t enters = take_number(c, 1), player = take_number(c, 1), step = take_number(c, 4);
        out->event[i] = (message_event){.enters = enters == 1, .player = (int)player, .step = step};
        is_right = enters <= 1 && player < players;
    }
    return is_right;
}

static bool read_runs(cursor *c, int players, int inputs, message_packet *out) {
    bool is_right = out->runs <= players;
    for (int i = 0; i < out->runs && is_right; i++) {
        message_run *run = &out->run[i];
        run->player = (int)take_number(c, 1);
        run->first = take_number(c, 4);
        run->count = (int)take_number(c, 1);
        run->inputs = take(c, run->count);
        is_right =
            run->player < players && run->count > 0 && run->count <= MESSAGE_RUN_MAX && run->inputs;
        for (int k = 0; k < run->count && is_right; k++) {
            is_right = run->inputs[k] < inputs;
        }
    }
    return is_right;
}

bool message_read_packet(const unsigned char *bytes, int count, int players, int inputs,
                         message_packet *out) {
    if (!is_sealed(bytes, count, PACKET, HEAD + MESSAGE_SUM)) {
        return false;
    }
    int flags = bytes[5];
    *out = (message_packet){.from = bytes[4],
                            .lead = (int16_t)(uint16_t)message_number(bytes + 6, 2),
                            .hash_step = (int64_t)message_number(bytes + 8, 4) - 1,
                            .hash = message_number(bytes + 12, 8),
                            .has_time = flags & TIMED,
                            .has_events = flags & EVENTFUL,
                            .acks = bytes[20],
                            .runs = bytes[21]};
    cursor c = {.in = bytes + HEAD, .end = bytes + count - MESSAGE_SUM, .is_whole = true};
    if (out->has_time) {
        out->sent = (int)take_number(&c, 2);
        out->echo = (int)take_number(&c, 2);
        out->held = (int)take_number(&c, 2);
        out->held = out->held == NONE_CAME ? -1 : out->held;
    }
    bool is_right = flags <= TIMED + EVENTFUL && out->from < MESSAGE_NUMBERS &&
                    out->acks <= players && (!out->has_events || read_events(&c, players, out));
    for (int i = 0; i < out->acks && is_right; i++) {
        out->ack[i].player = (int)take_number(&c, 1);
        out->ack[i].step = take_number(&c, 4);
        is_right = out->ack[i].player < players;
    }
    return is_right && read_runs(&c, players, inputs, out) && c.is_whole && c.in == c.end;
}

/* ---- what must arrive ---- */

int message_write_hello(const message_hello *hello, unsigned char *out) {
    message_put(out, HELLO, 4);
    message_put(out + 4, hello->watches, 1);
    message_put(out + 5, hello->token, 8);
    return message_seal(out, MESSAGE_HELLO_BYTES - MESSAGE_SUM);
}

bool message_read_hello(const unsigned char *bytes, int count, message_hello *out) {
    if (count != MESSAGE_HELLO_BYTES || !is_sealed(bytes, count, HELLO, count) || bytes[4] > 1) {
        return false;
    }
    *out = (message_hello){.watches = bytes[4], .token = message_number(bytes + 5, 8)};
    return true;
}

int message_write_welcome(const message_welcome *w, unsigned char *out) {
    cursor c = {.out = out};
    put(&c, WELCOME, 4);
    put(&c, (uint64_t)w->own, 1);
    put(&c, (uint64_t)w->players, 1);
    put(&c, (uint64_t)w->rate, 2);
    put(&c, (uint64_t)w->depth, 2);
    put(&c, (uint64_t)w->end, 4);
    put(&c, w->seed, 4);
    put(&c, (uint64_t)w->step, 4);
    put(&c, (uint64_t)w->events, 2);
    put(&c, w->absent, 4);
    put(&c, (uint64_t)w->bytes, 4);
    put(&c, (uint64_t)w->more, 4);
    return message_seal(out, (int)(c.out - out));
}

bool message_read_welcome(const unsigned char *bytes, int count, message_welcome *out) {
    if (count != MESSAGE_WELCOME_BYTES || !is_sealed(bytes, count, WELCOME, count)) {
        return false;
    }
    *out = (message_welcome){.own = bytes[4],
                             .players = bytes[5],
                             .rate = (int)message_number(bytes + 6, 2),
                             .depth = (int)message_number(bytes + 8, 2),
                             .end = (int64_t)message_number(bytes + 10, 4),
                             .seed = (uint32_t)message_number(bytes + 14, 4),
                             .step = (int64_t)message_number(bytes + 18, 4),
                             .events = (int)message_number(bytes + 22, 2),
                             .absent = (uint32_t)message_number(bytes + 24, 4),
                             .bytes = (int64_t)message_number(bytes + 28, 4),
                             .more = (int64_t)message_number(bytes + 32, 4)};
    return out->players >= 2 && out->players <= MESSAGE_PLAYERS_MAX && out->own < MESSAGE_NUMBERS &&
           out->rate > 0 && out->depth > 0 && out->depth <= MESSAGE_LEAD_MAX &&
           out->absent >> out->players == 0 && out->bytes <= GAME_MAX && out->more <= out->bytes &&
           (out->bytes > 0 || out->step == 0);
}

int message_write_part(const unsigned char *game, size_t bytes, size_t at, unsigned char *out) {
    size_t count = bytes - at < MESSAGE_PART ? bytes - at : MESSAGE_PART;
    message_put(out, GAME, 4);
    message_put(out + 4, at, 4);
    memcpy(out + PART_HEAD, game + at, count);
    return message_seal(out, PART_HEAD + (int)count);
}

size_t message_read_part(const unsigned char *part, int count, unsigned char *game, size_t bytes,
                         size_t at) {
    if (!is_sealed(part, count, GAME, PART_HEAD + MESSAGE_SUM) ||
        message_number(part + 4, 4) != at) {
        return 0;
    }
    size_t length = (size_t)count - PART_HEAD - MESSAGE_SUM;
    if (length > bytes - at) {
        return 0;
    }
    memcpy(game + at, part + PART_HEAD, length);
    return length;
}
