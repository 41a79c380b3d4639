/* meet_enet.c: thud-meet, a game between two computers over UDP (ENet): one listens and is player
 * 0, the other joins. Each packet has all inputs that the other player has not confirmed, so that
 * packets are sent unreliably. Only the welcome and the last packet are sent reliably. */
#include "match.h"
#include "options.h"

#include <enet/enet.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Times in milliseconds: within which the other side has to answer (ANSWER_MS), and to disconnect
 * after the game (PART_MS); and the minimum and maximum of ENet's timeout, after which a silent
 * side counts as gone. Chosen. */
enum { ANSWER_MS = 10000, PART_MS = 30000, GONE_MS = 15000, GONE_MS_MAX = 30000 };

typedef struct meeting {
    match match;
    ENetHost *host;
    ENetPeer *other;
    int64_t listen; /* -1: it joins another */
    int64_t steps, rate, seed;
    bool is_playing, has_parted;
} meeting;

/* False where memory is short. */
static bool send_bytes(meeting *m, const unsigned char *bytes, int count, uint32_t how) {
    ENetPacket *packet = enet_packet_create(bytes, (size_t)count, how);
    if (packet && enet_peer_send(m->other, 0, packet) != 0) {
        enet_packet_destroy(packet);
    }
    return packet != NULL;
}

static bool send_message(meeting *m, uint32_t how) {
    unsigned char message[PEER_BYTES_MAX];
    return send_bytes(m, message, peer_write(&m->match.peer, !m->match.peer.me, message), how);
}

/* The listening side begins the game as soon as the other one has connected. */
static bool begin_as_host(meeting *m) {
    unsigned char message[MESSAGE_WELCOME_BYTES];
    message_welcome game = {
        .own = 1, .players = 2, .rate = (int)m->rate, .depth = MATCH_DEPTH, .end = m->steps};
    m->is_playing =
        send_bytes(m, message, message_write_welcome(&game, message), ENET_PACKET_FLAG_RELIABLE);
    game.own = 0;
    m->is_playing = m->is_playing && match_open(&m->match, &game, (uint64_t)m->seed);
    if (m->is_playing) {
        peer_connect(&m->match.peer, 1);
    }
    return m->is_playing;
}

/* Takes a packet. False if the program has to end; the reason has been printed. */
static bool take_packet(meeting *m, const unsigned char *bytes, int count) {
    if (m->is_playing) {
        return peer_read(&m->match.peer, !m->match.peer.me, bytes, count) == THUD_OK;
    }
    message_welcome game;
    if (m->listen >= 0 || !message_read_welcome(bytes, count, &game) || game.players != 2 ||
        game.own != 1 || game.end == 0 || game.bytes > 0) {
        fprintf(stderr, "thud-meet: the other is no thud-meet of this version\n");
        return false;
    }
    m->is_playing = match_open(&m->match, &game, (uint64_t)m->seed);
    return m->is_playing;
}

/* Handles all network events, after waiting at most `ms` milliseconds for the first one. False if
 * the program has to end. */
static bool take_events(meeting *m, uint32_t ms) {
    ENetEvent event;
    bool is_well = true;
    while (is_well && enet_host_service(m->host, &event, ms) > 0) {
        ms = 0;
        switch (event.type) {
        case ENET_EVENT_TYPE_CONNECT:
            m->other = event.peer;
            enet_peer_timeout(m->other, 0, GONE_MS, GONE_MS_MAX);
            is_well = m->listen < 0 || begin_as_host(m);
            break;
        case ENET_EVENT_TYPE_RECEIVE:
            is_well = take_packet(m, event.packet->data, (int)event.packet->dataLength);
            enet_packet_destroy(event.packet);
            break;
        case ENET_EVENT_TYPE_DISCONNECT:
            m->has_parted = true;
            return true;
        case ENET_EVENT_TYPE_NONE:
            break;
        }
    }
    return is_well;
}

/* Plays to the end, or until the other has gone. */
static bool play(meeting *m) {
    match *own = &m->match;
    bool is_well = true;
    while (is_well && !m->has_parted && !peer_is_done(&own->peer)) {
        while (is_well && match_wait(own) == 0) {
            is_well = match_press(own) == THUD_OK &&
                      send_message(m, ENET_PACKET_FLAG_UNSEQUENCED) &&
                      match_advance(own) == THUD_OK;
        }
        is_well = is_well && take_events(m, (uint32_t)(1000 * match_wait(own)));
    }
    /* Packets that the other side sent before it disconnected may complete the game. */
    return is_well && peer_advance(&own->peer) == THUD_OK;
}

/* Sends the last packet reliably, since the other side needs it to end its game, and disconnects.
 */
static void part(meeting *m) {
    if (!m->has_parted) {
        send_message(m, ENET_PACKET_FLAG_RELIABLE);
        enet_peer_disconnect_later(m->other, 0);
    }
    enet_uint32 began = enet_time_get();
    while (!m->has_parted && enet_time_get() - began < PART_MS && take_events(m, 100)) {
    }
}

/* Splits HOST:PORT. */
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

/* Waits for the other player. `address`: where to listen, or, with `join`, the address to connect
 * to. */
static bool meet(meeting *m, ENetAddress address, const char *join) {
    m->host = enet_host_create(join ? NULL : &address, 1, 1, 0, 0);
    if (!m->host) {
        fprintf(stderr, "thud-meet: cannot listen at port %lld: is it taken?\n",
                (long long)m->listen);
        return false;
    }
    m->other = join ? enet_host_connect(m->host, &address, 1, 0) : NULL;
    if (!join) {
        printf("waiting for the other player at port %d\n", m->host->address.port);
        fflush(stdout);
    }
    enet_uint32 began = enet_time_get();
    while (!m->is_playing && !m->has_parted) {
        if (!take_events(m, 100)) {
            return false;
        }
        m->has_parted |= join && !m->is_playing && enet_time_get() - began > ANSWER_MS;
    }
    if (!m->is_playing) {
        fprintf(stderr, "thud-meet: nobody answers%s%s\n", join ? " at " : "", join ? join : "");
    }
    return m->is_playing;
}

static const char ABOUT[] =
    "A game of cars between two computers over UDP: one calls it with --listen, the other with --join.\n"
    "Both drive at random, and print the hash of the last step.";

int main(int argc, char **argv) {
    static meeting m = {.listen = -1, .steps = 3600, .rate = CARS_RATE, .seed = 1};
    const char *join = NULL;
    const option options[] = {
        {"listen", "PORT", "wait for the other player; 0: at a free port", &m.listen, 0, 65535,
         NULL},
        {"join", "HOST:PORT", "where the other player waits", NULL, 0, 0, &join},
        {"steps", "N", "of the game; who listens says it", &m.steps, 1, INT32_MAX, NULL},
        {"rate", "N", "steps a second; who listens says it", &m.rate, 1, 10000, NULL},
        {"seed", "N", "of the own inputs", &m.seed, 0, INT32_MAX, NULL},
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
    if (enet_initialize() != 0) {
        fprintf(stderr, "thud-meet: there is no network\n");
        return 1;
    }
    ENetAddress address = {.host = ENET_HOST_ANY, .port = (enet_uint16)m.listen};
    if (join && !read_address(join, &address)) {
        return 2;
    }
    bool is_well = meet(&m, address, join) && play(&m);
    if (m.is_playing) {
        part(&m);
        is_well = match_print(&m.match) && is_well;
        match_close(&m.match);
    }
    if (m.host) {
        enet_host_destroy(m.host);
    }
    enet_deinitialize();
    return !is_well;
}
