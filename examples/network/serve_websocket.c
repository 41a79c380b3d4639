/* serve_websocket.c: thud-serve, a server without a window that browsers and Node join by WebSocket
 * (libwebsockets). It plays player 0 itself, and passes the other players' messages on. A client
 * sends the number of the player that a message is for, and the message (peer.h); it is sent
 * messages alone, and those of host.h. */
#include "match.h"
#include "options.h"

#include <libwebsockets.h>

#include <signal.h>
#include <stdio.h>
#include <string.h>

/* What waits to be sent to a client: of each player its newest message, since that has what older
 * ones had; in place of it, that the player has left; and the welcome, which goes first. */
enum { WAITING_WELCOME = 0, WAITING_FROM = 1, WAITING_COUNT = WAITING_FROM + CARS_MAX };

/* After the game the others are told what they lack, for so many seconds at most. */
static const double LINGER = 60;

typedef struct client {
    struct lws *socket; /* null: nobody */
    int received;       /* bytes of a message that has arrived in part */
    unsigned char message[1 + PEER_BYTES_MAX];
    int next;                 /* after the welcome, the one of `waiting` to be sent next */
    int bytes[WAITING_COUNT]; /* 0: none */
    unsigned char waiting[WAITING_COUNT][LWS_PRE + PEER_BYTES_MAX]; /* libwebsockets writes its head
                                                                       before each */
} client;

typedef struct server {
    match match;
    client clients[CARS_MAX]; /* by player; 0 is the server */
    int64_t players, steps, rate, seed;
    bool is_playing, is_over, has_failed;
    double linger_until;
    struct lws_context *context;
    lws_sorted_usec_list_t timer;
} server;

_Static_assert((int)HOST_BYTES_MAX <= (int)PEER_BYTES_MAX,
               "a message of the host fits where one of a peer does");

/* A signal handler sees nothing else. */
static server the_server;

static void end_by_signal(int number) {
    (void)number;
    the_server.is_over = true;
    lws_cancel_service(the_server.context);
}

/* ---- sending ---- */

/* `which`: of `waiting`. */
static void send_to(client *c, int which, const unsigned char *bytes, int count) {
    if (c->socket) {
        memcpy(c->waiting[which] + LWS_PRE, bytes, (size_t)count);
        c->bytes[which] = count;
        lws_callback_on_writable(c->socket);
    }
}

/* The one of `waiting` to be sent next; -1: none. */
static int find_next(const client *c) {
    int found = -1;
    for (int i = 0; i < WAITING_COUNT && found < 0; i++) {
        int which = (c->next + i) % WAITING_COUNT;
        found = c->bytes[which] ? which : -1;
    }
    return c->bytes[WAITING_WELCOME] ? WAITING_WELCOME : found;
}

/* Nonzero: the connection is broken. */
static int send_next(client *c) {
    int which = find_next(c);
    if (which < 0) {
        return 0;
    }
    int bytes = c->bytes[which];
    c->bytes[which] = 0;
    c->next = which + 1;
    int sent = lws_write(c->socket, c->waiting[which] + LWS_PRE, (size_t)bytes, LWS_WRITE_BINARY);
    if (find_next(c) >= 0) {
        lws_callback_on_writable(c->socket);
    }
    return sent < bytes;
}

/* ---- frames ---- */

static void send_all(server *s) {
    peer *p = &s->match.peer;
    for (int i = 1; i < p->players; i++) {
        unsigned char message[PEER_BYTES_MAX];
        if (s->clients[i].socket && peer_tells(p, i)) {
            send_to(&s->clients[i], WAITING_FROM, message, peer_write(p, i, message));
        }
    }
}

static int count_clients(const server *s) {
    int count = 0;
    for (int i = 1; i < s->players; i++) {
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
    s->is_over |= count_clients(s) == 0 || now > s->linger_until;
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

/* Begins the game, and tells all players. */
static void begin(server *s) {
    host_welcome game = {.players = (int)s->players,
                         .rate = (int)s->rate,
                         .steps = s->steps,
                         .depth = MATCH_DEPTH};
    if (!match_open(&s->match, &game, (uint64_t)s->seed)) {
        fail(s, "no game");
        return;
    }
    s->is_playing = true;
    for (int i = 1; i < s->players; i++) {
        unsigned char message[HOST_BYTES_MAX];
        game.player = i;
        send_to(&s->clients[i], WAITING_WELCOME, message, host_write_welcome(&game, message));
    }
    printf("the game begins\n");
    fflush(stdout);
    lws_sul_schedule(s->context, 0, &s->timer, on_timer, 1);
}

/* ---- clients ---- */

/* Nonzero: the game is full. */
static int join(server *s, struct lws *socket, int *player) {
    for (int i = 1; i < s->players && !s->is_playing; i++) {
        if (!s->clients[i].socket) {
            s->clients[i] = (client){.socket = socket};
            *player = i;
            int missing = (int)s->players - 1 - count_clients(s);
            printf("player %d has joined, %d to come\n", i, missing);
            fflush(stdout);
            if (missing == 0) {
                begin(s);
            }
            return 0;
        }
    }
    return 1;
}

/* The others go on without a player. */
static void leave(server *s, int player) {
    peer *p = &s->match.peer;
    s->clients[player].socket = NULL;
    if (!s->is_playing || s->is_over) {
        return;
    }
    unsigned char message[HOST_BYTES_MAX];
    int count = host_write_leave(p, player, message);
    int64_t step = p->others[player].heard;
    if (step < p->end) {
        printf("player %d has left before step %lld\n", player, (long long)step);
    }
    if (peer_part(p, player, step) != THUD_OK) {
        fail(s, "a player that left cannot be left out");
    }
    for (int i = 1; i < s->players; i++) {
        send_to(&s->clients[i], WAITING_FROM + player, message, count);
    }
}

/* Nonzero: the client has sent what no player sends. */
static int take_message(server *s, int player, const unsigned char *bytes, int count) {
    int to = count > 0 ? bytes[0] : player;
    bool is_own = count > 1 + PEER_SENDER_AT && bytes[1 + PEER_SENDER_AT] == player;
    if (!s->is_playing || !is_own || to >= s->players || to == player) {
        return 1;
    }
    if (to == 0) {
        return peer_read(&s->match.peer, bytes + 1, count - 1) != THUD_OK;
    }
    send_to(&s->clients[to], WAITING_FROM + player, bytes + 1, count - 1);
    return 0;
}

/* Messages may arrive in parts. Nonzero: the client has sent what no player sends. */
static int receive(server *s, int player, const void *part, size_t count) {
    client *c = &s->clients[player];
    if (count > sizeof c->message - (size_t)c->received || !lws_frame_is_binary(c->socket)) {
        return 1;
    }
    memcpy(c->message + c->received, part, count);
    c->received += (int)count;
    if (!lws_is_final_fragment(c->socket)) {
        return 0;
    }
    int whole = c->received;
    c->received = 0;
    return take_message(s, player, c->message, whole);
}

static int on_event(struct lws *socket, enum lws_callback_reasons reason, void *session, void *in,
                    size_t count) {
    int *player = session; /* 0: none */
    server *s = &the_server;
    switch ((int)reason) {
    case LWS_CALLBACK_ESTABLISHED:
        return join(s, socket, player);
    case LWS_CALLBACK_RECEIVE:
        return receive(s, *player, in, count);
    case LWS_CALLBACK_SERVER_WRITEABLE:
        return *player ? send_next(&s->clients[*player]) : 0;
    case LWS_CALLBACK_CLOSED:
        if (*player) {
            leave(s, *player);
        }
        return 0;
    default:
        return lws_callback_http_dummy(socket, reason, session, in, count);
    }
}

static const char ABOUT[] =
    "Serves a game of cars: waits until all players have joined by WebSocket, plays player 0 itself,\n"
    "at random, and prints the hash of the last step. examples/network/join_node.mjs is a client for\n"
    "Node, join.html one for browsers.";

int main(int argc, char **argv) {
    server *s = &the_server;
    int64_t port = 8081;
    const char *address = NULL, *page = NULL, *package = NULL;
    s->players = 2;
    s->steps = 3600;
    s->rate = CARS_RATE;
    s->seed = 1;
    const option options[] = {
        {"port", "N", "where to listen; 0: any free port", &port, 0, 65535, NULL},
        {"address", "A", "listen at this address alone, such as 127.0.0.1", NULL, 0, 0, &address},
        {"page", "FOLDER", "serve the page of this folder, examples/network", NULL, 0, 0, &page},
        {"package", "FOLDER", "and the package for it, web/package/dist", NULL, 0, 0, &package},
        {"players", "N", "players, the server among them", &s->players, 2, CARS_MAX, NULL},
        {"steps", "N", "steps of the game", &s->steps, 1, INT32_MAX, NULL},
        {"rate", "N", "steps a second", &s->rate, 1, 10000, NULL},
        {"seed", "N", "of the server's own inputs", &s->seed, 0, INT32_MAX, NULL},
    };
    options_result read =
        options_read(argc, argv, ABOUT, options, sizeof options / sizeof *options);
    if (read != OPTIONS_READ) {
        return read == OPTIONS_HELP ? 0 : 2;
    }
    const struct lws_protocols protocols[] = {
        {.name = "thud", .callback = on_event, .per_session_data_size = sizeof(int)}, {0}};
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
    printf("waiting at ws://%s:%d for players to come: %d\n", name, bound, (int)s->players - 1);
    if (page) {
        printf("browsers join at http://%s:%d\n", name, bound);
    }
    fflush(stdout);
    while (!s->is_over && lws_service(s->context, 0) >= 0) {
    }
    lws_context_destroy(s->context);
    bool is_well = s->is_playing && match_print(&s->match) && !s->has_failed;
    if (s->is_playing) {
        match_close(&s->match);
    }
    return !is_well;
}
