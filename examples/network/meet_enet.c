/* meet_enet.c: thud-meet, a game between computers over UDP (ENet): one listens and is player 0,
 * the host; the others join it, before the game begins or in its midst, and who was lost comes
 * back. Each packet has all inputs that its receiver has not confirmed, so they are sent
 * unreliably; who says hello, the welcome, the game, and the last packet are sent until they
 * arrive, in order, through a channel of their own (messages.h). */
#include "match.h"
#include "options.h"

#include <enet/enet.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Times in milliseconds: within which the host has to answer (ANSWER_MS), and all have to
 * disconnect after the game (PART_MS); and the minimum and maximum of ENet's timeout, after which a
 * silent side counts as gone. Chosen. */
enum { ANSWER_MS = 10000, PART_MS = 30000, GONE_MS = 15000, GONE_MS_MAX = 30000 };

/* The channels: packets, which are sent unreliably; all else, which is sent reliably. */
enum { PACKETS, MESSAGES, CHANNELS };

/* The other side of a connection. */
typedef struct client {
    ENetPeer *peer;  /* null: nobody */
    bool is_invited; /* the game has been sent to it */
    uint64_t token;  /* of who has, or had, this number; 0: nobody had */
} client;

typedef struct meeting {
    match match;
    ENetHost *host;
    client clients[CARS_MAX]; /* by number; to who joins there is only the host, 0 */
    int64_t listen;           /* -1: it joins another */
    int64_t players, wait, steps, rate, seed, token, leave;
    bool is_playing, has_parted, has_failed;
    message_welcome game; /* of who joins: its game, of which so many bytes have come */
    unsigned char *bytes;
    size_t received;
} meeting;

static bool is_host(const meeting *m) {
    return m->listen >= 0;
}

static void fail(meeting *m, const char *what) {
    fprintf(stderr, "thud-meet: %s\n", what);
    m->has_failed = true;
}

/* ---- sending ---- */

static void send_bytes(meeting *m, ENetPeer *to, const unsigned char *bytes, int count,
                       int channel) {
    uint32_t how = channel == MESSAGES ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED;
    ENetPacket *packet = enet_packet_create(bytes, (size_t)count, how);
    if (!packet) {
        fail(m, "memory is short");
    } else if (enet_peer_send(to, (enet_uint8)channel, packet) != 0) {
        enet_packet_destroy(packet);
    }
}

static void send_packet(meeting *m, int number, int channel) {
    unsigned char packet[PEER_BYTES_MAX];
    int count = peer_write(&m->match.peer, number, packet);
    send_bytes(m, m->clients[number].peer, packet, count, channel);
}

static void send_welcome(meeting *m, int number, const message_welcome *welcome) {
    unsigned char message[MESSAGE_WELCOME_BYTES];
    m->clients[number].is_invited = true;
    send_bytes(m, m->clients[number].peer, message, message_write_welcome(welcome, message),
               MESSAGES);
}

/* Sends who has come in the midst of the game that game, unless somebody is leaving or entering. */
static void invite(meeting *m, int number) {
    unsigned char *game, part[MESSAGE_PART_BYTES_MAX];
    size_t bytes;
    message_welcome welcome;
    if (peer_invite(&m->match.peer, number, &welcome, &game, &bytes) != THUD_OK) {
        fail(m, "the game cannot be told: memory is short");
    } else if (game) {
        welcome.rate = (int)m->rate;
        send_welcome(m, number, &welcome);
        for (size_t at = 0; at < bytes; at += MESSAGE_PART) {
            send_bytes(m, m->clients[number].peer, part, message_write_part(game, bytes, at, part),
                       MESSAGES);
        }
        free(game);
    }
}

static void send_all(meeting *m) {
    peer *p = &m->match.peer;
    for (int i = 0; i < CARS_MAX; i++) {
        client *c = &m->clients[i];
        if (c->peer && !c->is_invited) {
            invite(m, i);
        } else if (c->peer && peer_tells(p, i) && peer_is_too_late(p, i)) {
            enet_peer_disconnect(c->peer, 0);
        } else if (c->peer && peer_tells(p, i)) {
            send_packet(m, i, PACKETS);
        }
    }
}

/* ---- the host ---- */

static int count_missing(const meeting *m) {
    int count = (int)m->wait;
    for (int i = 1; i < m->players; i++) {
        count -= m->clients[i].peer != NULL;
    }
    return count;
}

/* Begins the game with those who are there, and tells them. */
static void begin(meeting *m) {
    message_welcome game = {.players = (int)m->players,
                            .rate = (int)m->rate,
                            .depth = MATCH_DEPTH,
                            .end = m->steps};
    m->is_playing = match_open(&m->match, &game, (uint64_t)m->seed);
    m->has_failed |= !m->is_playing;
    for (int i = 1; m->is_playing && i < m->players; i++) {
        if (m->clients[i].peer) {
            peer_connect(&m->match.peer, i);
            game.own = i;
            send_welcome(m, i, &game);
        } else if (peer_miss(&m->match.peer, i) != THUD_OK) {
            fail(m, "a player that has not come cannot be left out");
        }
    }
}

/* The number for who says hello: that which it had, else one that nobody had, else any; 0: none. */
static int number_for(const meeting *m, uint64_t token) {
    int unused = 0, left = 0;
    for (int i = (int)m->players - 1; i > 0; i--) {
        const client *c = &m->clients[i];
        bool is_free = !c->peer && (!m->is_playing || peer_is_absent(&m->match.peer, i));
        if (is_free && token && c->token == token) {
            return i;
        }
        unused = is_free && !c->token ? i : unused;
        left = is_free ? i : left;
    }
    return unused ? unused : left;
}

/* Somebody has said who it is. */
static void take_hello(meeting *m, ENetPeer *from, const unsigned char *bytes, int count) {
    message_hello hello;
    bool is_hello = message_read_hello(bytes, count, &hello) && !hello.watches;
    int number = is_hello ? number_for(m, hello.token) : 0;
    if (number == 0) {
        enet_peer_disconnect(from, 0);
        return;
    }
    bool was_here = hello.token && m->clients[number].token == hello.token;
    m->clients[number] = (client){.peer = from, .token = hello.token};
    from->data = &m->clients[number];
    int missing = count_missing(m);
    match_print_arrival(&m->match, number, was_here ? "has come back" : "has joined", m->is_playing,
                        missing);
    if (!m->is_playing && missing == 0) {
        begin(m);
    }
}

/* The others go on without somebody. */
static void take_leave(meeting *m, int number) {
    peer *p = &m->match.peer;
    m->clients[number] = (client){.token = m->clients[number].token};
    if (!m->is_playing) {
        return;
    }
    if (p->known[number].heard >= p->end) {
        p->links[number].is_told = false;
        return;
    }
    if (!peer_is_absent(p, number)) {
        printf("player %d has left before step %lld\n", number, (long long)p->known[number].heard);
        fflush(stdout);
    }
    if (peer_lose(p, number) != THUD_OK) {
        fail(m, "a player that left cannot be left out");
    }
}

/* ---- who joins ---- */

static void begin_as_guest(meeting *m) {
    m->is_playing = match_open(&m->match, &m->game, (uint64_t)m->seed);
    m->has_failed |= !m->is_playing;
    if (m->is_playing && m->game.bytes > 0 &&
        peer_accept(&m->match.peer, &m->game, m->bytes) != THUD_OK) {
        fail(m, "the game cannot be joined");
    }
}

/* Handles the welcome, and the game that follows it. */
static void take_game(meeting *m, const unsigned char *bytes, int count) {
    if (m->game.players == 0) {
        bool is_welcome = message_read_welcome(bytes, count, &m->game) && m->game.end > 0 &&
                          m->game.players <= CARS_MAX && m->game.own > 0 &&
                          m->game.own < m->game.players;
        m->bytes = is_welcome ? malloc((size_t)m->game.bytes + 1) : NULL;
        if (!m->bytes) {
            fail(m, is_welcome ? "memory is short" : "the host is no thud-meet of this version");
        }
    } else {
        size_t size = (size_t)m->game.bytes;
        size_t taken = message_read_part(bytes, count, m->bytes, size, m->received);
        m->received += taken;
        if (taken == 0) {
            fail(m, "the game does not arrive as it was sent");
        }
    }
    if (!m->has_failed && m->received == (size_t)m->game.bytes) {
        begin_as_guest(m);
    }
}

/* ---- events ---- */

static void take_connection(meeting *m, ENetPeer *other) {
    unsigned char message[MESSAGE_HELLO_BYTES];
    enet_peer_timeout(other, 0, GONE_MS, GONE_MS_MAX);
    other->data = NULL;
    if (!is_host(m)) {
        message_hello hello = {.token = (uint64_t)m->token};
        m->clients[0] = (client){.peer = other, .is_invited = true};
        other->data = &m->clients[0];
        send_bytes(m, other, message, message_write_hello(&hello, message), MESSAGES);
    }
}

static void take_message(meeting *m, const ENetEvent *event) {
    const unsigned char *bytes = event->packet->data;
    int count = (int)event->packet->dataLength;
    const client *from = event->peer->data;
    if (!from) {
        take_hello(m, event->peer, bytes, count);
    } else if (m->is_playing) {
        if (peer_read(&m->match.peer, (int)(from - m->clients), bytes, count) != THUD_OK) {
            fail(m, "what another player has told cannot be stored");
        }
    } else if (!is_host(m) && event->channelID == MESSAGES) {
        /* Packets may arrive before the game: they come again. */
        take_game(m, bytes, count);
    }
}

static void take_disconnection(meeting *m, ENetPeer *other) {
    const client *c = other->data;
    if (!is_host(m)) {
        m->clients[0].peer = NULL;
        m->has_parted = true;
    } else if (c) {
        take_leave(m, (int)(c - m->clients));
    }
}

/* Handles all network events, after waiting at most `ms` milliseconds for the first one. */
static void take_events(meeting *m, uint32_t ms) {
    ENetEvent event;
    while (!m->has_failed && enet_host_service(m->host, &event, ms) > 0) {
        ms = 0;
        switch (event.type) {
        case ENET_EVENT_TYPE_CONNECT:
            take_connection(m, event.peer);
            break;
        case ENET_EVENT_TYPE_RECEIVE:
            take_message(m, &event);
            enet_packet_destroy(event.packet);
            break;
        case ENET_EVENT_TYPE_DISCONNECT:
            take_disconnection(m, event.peer);
            break;
        case ENET_EVENT_TYPE_NONE:
            break;
        }
    }
}

/* ---- the game ---- */

/* Runs a frame that is due, and, after this player has joined, the steps that others have run
 * before. */
static void play_frame(meeting *m) {
    match *own = &m->match;
    bool is_well = match_press(own) == THUD_OK;
    send_all(m);
    is_well = is_well && match_advance(own) == THUD_OK;
    while (is_well && peer_is_behind(&own->peer)) {
        int64_t waits = own->peer.waits;
        is_well = peer_advance(&own->peer) == THUD_OK;
        if (own->peer.waits > waits) {
            break;
        }
    }
    if (!is_well) {
        fail(m, "a step has failed: memory is short");
    }
}

static bool leaves(const meeting *m) {
    return m->leave > 0 && thud_progress_of(m->match.peer.rollback).steps >= m->leave;
}

/* Plays to the end, or until the host has gone. */
static void play(meeting *m) {
    match *own = &m->match;
    while (!m->has_failed && !m->has_parted && !peer_is_done(&own->peer) && !leaves(m)) {
        while (!m->has_failed && match_wait(own) == 0) {
            play_frame(m);
        }
        take_events(m, (uint32_t)(1000 * match_wait(own)));
    }
    /* Packets that the host sent before it disconnected may complete the game. */
    if (!m->has_failed && peer_advance(&own->peer) != THUD_OK) {
        fail(m, "a step has failed: memory is short");
    }
}

static bool is_connected(const meeting *m) {
    bool is = false;
    for (int i = 0; i < CARS_MAX; i++) {
        is |= m->clients[i].peer != NULL;
    }
    return is;
}

/* Sends the last packet reliably, since the others need it to end their games, and disconnects. */
static void part(meeting *m) {
    for (int i = 0; i < CARS_MAX; i++) {
        if (m->clients[i].peer) {
            if (peer_tells(&m->match.peer, i)) {
                send_packet(m, i, MESSAGES);
            }
            enet_peer_disconnect_later(m->clients[i].peer, 0);
        }
    }
    enet_uint32 began = enet_time_get();
    while (!m->has_failed && is_connected(m) && enet_time_get() - began < PART_MS) {
        take_events(m, 100);
    }
}

/* Splits HOST:PORT. False, with a message on stderr, if it cannot be used. */
static bool read_address(const char *text, ENetAddress *out) {
    char name[256];
    const char *colon = strrchr(text, ':');
    char *end = NULL;
    long port = colon ? strtol(colon + 1, &end, 10) : 0;
    if (!colon || colon == text || colon - text >= (int)sizeof name || *end || port < 1 ||
        port > 65535) {
        fprintf(stderr, "thud-meet: --join needs HOST:PORT, not '%s'\n", text);
        return false;
    }
    memcpy(name, text, (size_t)(colon - text));
    name[colon - text] = 0;
    out->port = (enet_uint16)port;
    if (enet_address_set_host(out, name) != 0) {
        fprintf(stderr, "thud-meet: there is no host '%s'\n", name);
        return false;
    }
    return true;
}

/* Waits for the other players. `address`: where to listen, or, with `join`, the address to connect
 * to. */
static bool meet(meeting *m, ENetAddress address, const char *join) {
    m->host = enet_host_create(join ? NULL : &address, CARS_MAX, CHANNELS, 0, 0);
    if (!m->host) {
        fprintf(stderr, "thud-meet: cannot listen at port %lld: is it taken?\n",
                (long long)m->listen);
        return false;
    }
    if (join) {
        enet_host_connect(m->host, &address, CHANNELS, 0);
    } else {
        printf("waiting at port %d for players to come: %d\n", m->host->address.port, (int)m->wait);
        fflush(stdout);
    }
    enet_uint32 began = enet_time_get();
    while (!m->is_playing && !m->has_parted && !m->has_failed) {
        take_events(m, 100);
        m->has_parted |= join && !m->is_playing && enet_time_get() - began > ANSWER_MS;
    }
    if (!m->is_playing && !m->has_failed) {
        fprintf(stderr, "thud-meet: nobody answers at %s, or the game is full\n", join);
    }
    return m->is_playing;
}

static const char ABOUT[] =
    "A game of cars between computers over UDP: one calls it with --listen, the others with --join.\n"
    "Others join in the midst of the game, and who left comes back. All drive at random, and print the\n"
    "hash of the last step.";

int main(int argc, char **argv) {
    static meeting m = {
        .listen = -1, .players = 2, .wait = -1, .steps = 3600, .rate = CARS_RATE, .seed = 1};
    const char *join = NULL;
    const option options[] = {
        {"listen", "PORT", "wait for the other players; 0: at a free port", &m.listen, 0, 65535,
         NULL},
        {"join", "HOST:PORT", "where the host waits", NULL, 0, 0, &join},
        {"players", "N", "players, the host among them; who listens says it", &m.players, 2,
         CARS_MAX, NULL},
        {"wait", "N", "begin when so many have joined; default all", &m.wait, 1, CARS_MAX - 1,
         NULL},
        {"steps", "N", "of the game; who listens says it", &m.steps, 1, INT32_MAX, NULL},
        {"rate", "N", "steps a second; who listens says it", &m.rate, 1, 10000, NULL},
        {"seed", "N", "of the own inputs", &m.seed, 0, INT32_MAX, NULL},
        {"token", "N", "by it the host knows who comes back; 0: it does not", &m.token, 0,
         INT32_MAX, NULL},
        {"leave", "N", "leave before this step; 0: play to the end", &m.leave, 0, INT32_MAX, NULL},
    };
    options_result read =
        options_read(argc, argv, ABOUT, options, sizeof options / sizeof *options);
    if (read != OPTIONS_READ) {
        return read == OPTIONS_HELP ? 0 : 2;
    }
    if ((m.listen < 0) == !join) {
        fprintf(stderr, "thud-meet: either --listen PORT or --join HOST:PORT\n");
        return 2;
    }
    m.wait = m.wait < 0 || m.wait >= m.players ? m.players - 1 : m.wait;
    if (enet_initialize() != 0) {
        fprintf(stderr, "thud-meet: there is no network\n");
        return 1;
    }
    ENetAddress address = {.host = ENET_HOST_ANY, .port = (enet_uint16)m.listen};
    if (join && !read_address(join, &address)) {
        return 2;
    }
    bool is_well = meet(&m, address, join);
    if (is_well) {
        play(&m);
        bool has_left = leaves(&m);
        part(&m);
        is_well = has_left || match_print(&m.match);
    }
    if (m.is_playing) {
        match_close(&m.match);
    }
    if (m.host) {
        enet_host_destroy(m.host);
    }
    free(m.bytes);
    enet_deinitialize();
    return !is_well || m.has_failed;
}
