/* serve_websocket.c: thud-serve, a server without a window that browsers and Node join by WebSocket
 * (libwebsockets), before the game begins or while it runs. The server itself is player 0, the
 * host. A client sends a hello, receives a welcome, and the state of the game if that has begun;
 * then both send packets (messages.h). */
#include "match.h"
#include "options.h"

#include <libwebsockets.h>

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* SENT_MAX: length of the longest message, bytes. CLIENTS: numbers of clients: players from 1 on,
 * then spectators. */
enum { SENT_MAX = MESSAGE_PART_BYTES_MAX, CLIENTS = CARS_MAX + 8 };

/* After the game the server goes on sending what other players lack, for so many seconds at most.
 */
static const double LINGER = 60;

/* A client and the messages that wait to be sent to it: the welcome, then the game that it joins,
 * in parts, and then packets. Only the newest packet is kept, since it includes what older ones
 * had. */
typedef struct client {
    struct lws *socket; /* null: nobody */
    bool is_invited;    /* the welcome has been written */
    uint64_t token;     /* identifies the client that has or had this number; 0: no client had it */
    int welcome_bytes;  /* 0: sent */
    unsigned char *game;
    size_t game_bytes, game_sent;
    int packet_bytes; /* 0: none waits */
    int received;     /* bytes of a message that has arrived in part */
    unsigned char message[PEER_BYTES_MAX];
    unsigned char welcome[LWS_PRE + MESSAGE_WELCOME_BYTES]; /* LWS_PRE bytes of room, in which
                                                               libwebsockets writes its header */
    unsigned char packet[LWS_PRE + PEER_BYTES_MAX];
} client;

typedef struct server {
    match match;
    client clients[CLIENTS]; /* by number; 0 is the server */
    int64_t players, wait, steps, rate, seed;
    bool is_playing, is_over, has_failed;
    double linger_until;
    struct lws_context *context;
    lws_sorted_usec_list_t timer;
    unsigned char part[LWS_PRE + SENT_MAX];
} server;

/* Global, since a signal handler gets no argument. */
static server the_server;

static void end_by_signal(int number) {
    (void)number;
    the_server.is_over = true;
    lws_cancel_service(the_server.context);
}

/* ---- sending ---- */

static bool has_more(const client *c) {
    return c->welcome_bytes || c->game_sent < c->game_bytes || (c->is_invited && c->packet_bytes);
}

/* Sends the next message of a client, if one waits. Nonzero if the connection is broken. */
static int send_next(server *s, client *c) {
    unsigned char *bytes = c->packet;
    int count = c->is_invited ? c->packet_bytes : 0;
    if (c->welcome_bytes) {
        bytes = c->welcome;
        count = c->welcome_bytes;
        c->welcome_bytes = 0;
    } else if (c->game_sent < c->game_bytes) {
        bytes = s->part;
        count = message_write_part(c->game, c->game_bytes, c->game_sent, bytes + LWS_PRE);
        c->game_sent += MESSAGE_PART;
    } else {
        c->packet_bytes = 0;
    }
    if (count == 0) {
        return 0;
    }
    int sent = lws_write(c->socket, bytes + LWS_PRE, (size_t)count, LWS_WRITE_BINARY);
    if (has_more(c)) {
        lws_callback_on_writable(c->socket);
    }
    return sent < count;
}

static void send_welcome(client *c, const message_welcome *welcome) {
    c->is_invited = true;
    c->welcome_bytes = message_write_welcome(welcome, c->welcome + LWS_PRE);
    lws_callback_on_writable(c->socket);
}

/* ---- frames ---- */

static void fail(server *s, const char *what);

static void drop(client *c) {
    lws_set_timeout(c->socket, PENDING_TIMEOUT_CLOSE_SEND, LWS_TO_KILL_ASYNC);
}

/* Sends the game to a client that has connected while it runs, as soon as no entry or exit is under
 * way. */
static void invite(server *s, int number) {
    client *c = &s->clients[number];
    message_welcome welcome;
    if (peer_invite(&s->match.peer, number, &welcome, &c->game, &c->game_bytes) != THUD_OK) {
        fail(s, "the game cannot be told: memory is short");
    } else if (c->game) {
        welcome.rate = (int)s->rate;
        c->game_sent = 0;
        send_welcome(c, &welcome);
    }
}

static void send_all(server *s) {
    peer *p = &s->match.peer;
    for (int i = 1; i < CLIENTS; i++) {
        client *c = &s->clients[i];
        if (!c->socket) {
            continue;
        }
        if (!c->is_invited) {
            invite(s, i);
        } else if (peer_tells(p, i) && peer_is_too_late(p, i)) {
            drop(c);
        } else if (peer_tells(p, i)) {
            c->packet_bytes = peer_write(p, i, c->packet + LWS_PRE);
            lws_callback_on_writable(c->socket);
        }
    }
}

static int count_clients(const server *s) {
    int count = 0;
    for (int i = 1; i < CLIENTS; i++) {
        count += s->clients[i].socket != NULL;
    }
    return count;
}

static void fail(server *s, const char *what) {
    fprintf(stderr, "thud-serve: %s\n", what);
    s->has_failed = s->is_over = true;
}

static void play_frame(server *s) {
    match *m = &s->match;
    bool is_done = peer_is_done(&m->peer);
    double now = match_now();
    s->linger_until = is_done ? s->linger_until : now + LINGER;
    s->is_over |= (is_done && count_clients(s) == 0) || now > s->linger_until;
    if (match_press(m) != THUD_OK) {
        fail(s, "the own input is refused");
    }
    send_all(s);
    if (match_advance(m) != THUD_OK) {
        fail(s, "a step has failed: memory is short");
    }
}

static void on_timer(lws_sorted_usec_list_t *timer) {
    server *s = lws_container_of(timer, server, timer);
    if (!s->is_over && match_wait(&s->match) == 0) {
        play_frame(s);
    }
    lws_usec_t wait = (lws_usec_t)(1e6 * match_wait(&s->match));
    lws_sul_schedule(s->context, 0, &s->timer, on_timer, wait > 0 ? wait : 1);
}

/* Begins the game with the connected clients, and sends them welcomes. */
static void begin(server *s) {
    message_welcome game = {.players = (int)s->players,
                            .rate = (int)s->rate,
                            .end = s->steps,
                            .depth = MATCH_DEPTH};
    if (!match_open(&s->match, &game, (uint64_t)s->seed)) {
        fail(s, "no game");
        return;
    }
    s->is_playing = true;
    for (int i = 1; i < CLIENTS; i++) {
        client *c = &s->clients[i];
        if (c->socket) {
            peer_connect(&s->match.peer, i);
            game.own = i;
            send_welcome(c, &game);
        } else if (i < s->players && peer_miss(&s->match.peer, i) != THUD_OK) {
            fail(s, "a player that has not come cannot be left out");
        }
    }
    printf("the game begins\n");
    fflush(stdout);
    lws_sul_schedule(s->context, 0, &s->timer, on_timer, 1);
}

/* ---- clients ---- */

/* The number for a client that sends a hello: the number that it had before, else one that no
 * client had, else any free one; 0 if there is none. */
static int number_for(const server *s, const message_hello *hello) {
    int first = hello->watches ? CARS_MAX : 1, end = hello->watches ? CLIENTS : (int)s->players;
    int unused = 0, left = 0;
    for (int i = end - 1; i >= first; i--) {
        const client *c = &s->clients[i];
        bool is_free =
            !c->socket && (hello->watches || !s->is_playing || peer_is_absent(&s->match.peer, i));
        if (is_free && hello->token && c->token == hello->token) {
            return i;
        }
        unused = is_free && !c->token ? i : unused;
        left = is_free ? i : left;
    }
    return unused ? unused : left;
}

static int count_missing(const server *s) {
    int count = (int)s->wait;
    for (int i = 1; i < s->players; i++) {
        count -= s->clients[i].socket != NULL;
    }
    return count;
}

/* Takes the hello of a connection, and gives it a number. Nonzero if the bytes are no hello, or no
 * number is free. */
static int join(server *s, struct lws *socket, int *number, const unsigned char *bytes, int count) {
    message_hello hello;
    *number = message_read_hello(bytes, count, &hello) && !s->is_over ? number_for(s, &hello) : 0;
    if (*number == 0) {
        return 1;
    }
    bool was_here = s->clients[*number].token && s->clients[*number].token == hello.token;
    s->clients[*number] = (client){.socket = socket, .token = hello.token};
    const char *what = hello.watches ? "watches" : was_here ? "has come back" : "has joined";
    int missing = count_missing(s);
    match_print_arrival(&s->match, *number, what, s->is_playing, missing);
    if (!s->is_playing && missing == 0) {
        begin(s);
    }
    return 0;
}

/* Called when a client has disconnected: the others play on without it. */
static void leave(server *s, int number) {
    peer *p = &s->match.peer;
    client *c = &s->clients[number];
    free(c->game);
    *c = (client){.token = c->token};
    if (!s->is_playing || s->is_over) {
        return;
    }
    if (number < p->players && !peer_is_absent(p, number) && p->known[number].heard < p->end) {
        printf("player %d has left before step %lld\n", number, (long long)p->known[number].heard);
        fflush(stdout);
    }
    bool is_at_end = number < p->players && p->known[number].heard >= p->end;
    if (is_at_end) {
        p->links[number].is_told = false;
    } else if (peer_lose(p, number) != THUD_OK) {
        fail(s, "a player that left cannot be left out");
    }
}

/* Takes a whole message. Nonzero if the client has sent something that no player sends; its
 * connection is then closed. */
static int take_message(server *s, struct lws *socket, int *number, const unsigned char *bytes,
                        int count) {
    if (*number == 0) {
        return join(s, socket, number, bytes, count);
    }
    peer *p = &s->match.peer;
    int64_t refused = p->refused;
    return !s->is_playing || peer_read(p, *number, bytes, count) != THUD_OK || p->refused > refused;
}

/* A connection, and the part of a hello that it has received before it has a number. */
typedef struct session {
    int number; /* 0: none yet */
    int received;
    unsigned char message[MESSAGE_HELLO_BYTES];
} session;

/* Takes a part of a message; messages may arrive in several. Nonzero if the connection has to be
 * closed. */
static int receive(server *s, struct lws *socket, session *own, const void *part, size_t count) {
    client *c = own->number ? &s->clients[own->number] : NULL;
    unsigned char *message = c ? c->message : own->message;
    int *received = c ? &c->received : &own->received;
    size_t room = c ? sizeof c->message : sizeof own->message;
    if (count > room - (size_t)*received || !lws_frame_is_binary(socket)) {
        return 1;
    }
    memcpy(message + *received, part, count);
    *received += (int)count;
    if (!lws_is_final_fragment(socket)) {
        return 0;
    }
    int whole = *received;
    *received = 0;
    return take_message(s, socket, &own->number, message, whole);
}

static int on_event(struct lws *socket, enum lws_callback_reasons reason, void *user, void *in,
                    size_t count) {
    session *own = user;
    server *s = &the_server;
    switch ((int)reason) {
    case LWS_CALLBACK_ESTABLISHED:
        *own = (session){0};
        return 0;
    case LWS_CALLBACK_RECEIVE:
        return receive(s, socket, own, in, count);
    case LWS_CALLBACK_SERVER_WRITEABLE:
        return own->number ? send_next(s, &s->clients[own->number]) : 0;
    case LWS_CALLBACK_CLOSED:
        if (own->number) {
            leave(s, own->number);
        }
        return 0;
    default:
        return lws_callback_http_dummy(socket, reason, user, in, count);
    }
}

static const char ABOUT[] =
    "Serves a game of cars: waits until players have joined by WebSocket, plays player 0 itself, at\n"
    "random, and prints the hash of the last step. Others join in the midst of the game, and who left\n"
    "comes back. examples/network/join_node.mjs is a client for\n"
    "Node, join.html one for browsers.";

int main(int argc, char **argv) {
    server *s = &the_server;
    int64_t port = 8081;
    const char *address = NULL, *page = NULL, *package = NULL;
    s->players = 2;
    s->wait = -1;
    s->steps = 3600;
    s->rate = CARS_RATE;
    s->seed = 1;
    const option options[] = {
        {"port", "N", "where to listen; 0: any free port", &port, 0, 65535, NULL},
        {"address", "A", "listen at this address alone, such as 127.0.0.1", NULL, 0, 0, &address},
        {"page", "FOLDER", "serve the page of this folder, examples/network", NULL, 0, 0, &page},
        {"package", "FOLDER", "and the package for it, web/package/dist", NULL, 0, 0, &package},
        {"players", "N", "players, the server among them", &s->players, 2, CARS_MAX, NULL},
        {"wait", "N", "begin when so many have joined; default all", &s->wait, 0, CARS_MAX - 1,
         NULL},
        {"steps", "N", "steps of the game", &s->steps, 1, INT32_MAX, NULL},
        {"rate", "N", "steps a second", &s->rate, 1, 10000, NULL},
        {"seed", "N", "of the server's own inputs", &s->seed, 0, INT32_MAX, NULL},
    };
    options_result read =
        options_read(argc, argv, ABOUT, options, sizeof options / sizeof *options);
    if (read != OPTIONS_READ) {
        return read == OPTIONS_HELP ? 0 : 2;
    }
    s->wait = s->wait < 0 || s->wait >= s->players ? s->players - 1 : s->wait;
    const struct lws_protocols protocols[] = {
        {.name = "thud", .callback = on_event, .per_session_data_size = sizeof(session)}, {0}};
    const struct lws_protocol_vhost_options wasm = {.name = ".wasm", .value = "application/wasm"};
    const struct lws_protocol_vhost_options types = {.next = &wasm,
                                                     .name = ".mjs",
                                                     .value = "text/javascript"};
    const struct lws_http_mount package_files = {.mountpoint = "/thud",
                                                 .mountpoint_len = 5,
                                                 .origin = package,
                                                 .def = "index.js",
                                                 .extra_mimetypes = &types,
                                                 .origin_protocol = LWSMPRO_FILE};
    const struct lws_http_mount files = {.mount_next = package ? &package_files : NULL,
                                         .mountpoint = "/",
                                         .mountpoint_len = 1,
                                         .origin = page,
                                         .def = "join.html",
                                         .extra_mimetypes = &types,
                                         .origin_protocol = LWSMPRO_FILE};
    struct lws_context_creation_info info = {.port = (int)port,
                                             .iface = address,
                                             .protocols = protocols,
                                             .mounts = page ? &files : NULL};
    lws_set_log_level(0, NULL);
    s->context = lws_create_context(&info);
    struct lws_vhost *vhost = s->context ? lws_get_vhost_by_name(s->context, "default") : NULL;
    if (!vhost) {
        fprintf(stderr, "thud-serve: cannot listen at port %lld%s%s: is it taken?\n",
                (long long)port, address ? " of " : "", address ? address : "");
        return 1;
    }
    signal(SIGINT, end_by_signal);
    signal(SIGTERM, end_by_signal);
    const char *name = address ? address : "localhost";
    int bound = lws_get_vhost_listen_port(vhost);
    printf("waiting at ws://%s:%d for players to come: %d\n", name, bound, (int)s->wait);
    if (page) {
        printf("browsers join at http://%s:%d\n", name, bound);
    }
    fflush(stdout);
    if (s->wait == 0) {
        begin(s);
    }
    while (!s->is_over && lws_service(s->context, 0) >= 0) {
    }
    lws_context_destroy(s->context);
    for (int i = 0; i < CLIENTS; i++) {
        free(s->clients[i].game);
    }
    bool is_well = s->is_playing && match_print(&s->match) && !s->has_failed;
    if (s->is_playing) {
        match_close(&s->match);
    }
    return !is_well;
}
