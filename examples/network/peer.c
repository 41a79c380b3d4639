/* peer.c: see peer.h. */
#include "peer.h"

#include <thud/thud_snapshot.h>

#include <stdlib.h>
#include <string.h>

/* A player that joins enters this many steps after its entry is announced, so that the announcement
 * reaches all players in time; chosen. */
enum { NOTICE = 12 };

/* Maximum of the time that a packet says it was held, milliseconds: one below NONE_CAME
 * (messages.c). Longer times are clamped to it. */
enum { HELD_MAX = 0xfffe };

_Static_assert((int)CARS_MAX <= (int)MESSAGE_PLAYERS_MAX, "a bit for each player");

/* Steps of play before the game, by which the world allocates the memory that the game will need.
 * Play begins with all bodies on one heap in a corner, which makes more contacts than a game has,
 * and players drive at random. Chosen. */
enum { WARM_STEPS = 600 };

static thud_result warm_up(peer *p) {
    thud_result result = THUD_OK;
    for (int i = 0; i < p->game.count && result == THUD_OK; i++) {
        thud_pos place = {11.5 - 0.4 * (i % 4), 7.5 - 0.4 * (i / 4)};
        result = thud_body_set_transform(p->world, p->game.bodies[i], place, 0.1 * i);
    }
    for (int step = 0; step < WARM_STEPS && result == THUD_OK; step++) {
        uint64_t inputs[CARS_MAX];
        for (int i = 0; i < p->players; i++) {
            inputs[i] = cars_input(1, i, step);
        }
        result = cars_step(p->world, inputs, &p->game);
    }
    return result;
}

/* Creates the rollback of a world whose game begins now. */
static bool open_rollback(peer *p, const thud_rollback_options *options) {
    size_t bytes;
    cars game = p->game;
    void *start = thud_world_get_snapshot_size(p->world, &bytes) == THUD_OK ? malloc(bytes) : NULL;
    bool is_open = start && thud_world_snapshot(p->world, start, bytes, NULL) == THUD_OK &&
                   warm_up(p) == THUD_OK &&
                   thud_rollback_create(p->world, options, &p->rollback) == THUD_OK &&
                   thud_world_restore(p->world, start, bytes) == THUD_OK;
    p->game = game;
    free(start);
    return is_open;
}

static peer_link new_link(void) {
    return (peer_link){
        .is_told = true, .final = -1, .told.step = -1, .hash_step = -1, .differs_from = -1};
}

bool peer_open(peer *p, const peer_options *o) {
    *p = (peer){.me = o->me,
                .players = o->players,
                .depth = o->depth,
                .is_mesh = o->is_mesh,
                .end = o->end,
                .now = -1};
    for (int i = 0; i < MESSAGE_NUMBERS; i++) {
        p->links[i] = new_link();
        p->links[i].is_told = i != p->me && (o->is_mesh ? i < o->players : p->me != 0 && i == 0);
    }
    for (int i = 0; i < CARS_MAX; i++) {
        p->known[i].gone_from = p->known[i].back_at = PEER_NEVER;
    }
    thud_rollback_options options = {.players = o->players,
                                     .depth = o->depth,
                                     .idle = CARS_IDLE,
                                     .step = o->step ? o->step : cars_step,
                                     .state = &p->game,
                                     .state_bytes = CARS_STATE_BYTES};
    return thud_world_create(o->def, &p->world) == THUD_OK &&
           cars_build(p->world, o->players, &p->game) && open_rollback(p, &options);
}

void peer_close(peer *p) {
    thud_rollback_destroy(p->rollback);
    thud_world_destroy(p->world);
    *p = (peer){.me = p->me};
}

static bool is_host(const peer *p) {
    return p->me == 0 && !p->is_mesh;
}

static int64_t steps_of(const peer *p) {
    return thud_progress_of(p->rollback).steps;
}

bool peer_is_absent(const peer *p, int player) {
    const peer_known *k = &p->known[player];
    return k->gone_from != PEER_NEVER && k->back_at == PEER_NEVER;
}

thud_result peer_press(peer *p, uint64_t input) {
    int64_t step = steps_of(p);
    bool plays = p->me < p->players && !peer_is_absent(p, p->me);
    thud_result result = THUD_OK;
    while (plays && result == THUD_OK && p->known[p->me].heard <= step &&
           !(p->end && p->known[p->me].heard >= p->end)) {
        result = peer_hear(p, p->me, input);
    }
    return result;
}

/* ---- packets ---- */

/* This peer's newest hash of a confirmed step. */
static peer_hash newest_hash(const peer *p) {
    int64_t step = p->hashed - PEER_HASH_STEPS;
    const peer_hash *h = &p->hashes[(step < 0 ? 0 : step) / PEER_HASH_STEPS % PEER_HASHES];
    return step >= 0 && h->step == step ? *h : (peer_hash){.step = -1};
}

bool peer_tells(const peer *p, int number) {
    return p->links[number].is_told;
}

/* The first step whose input of `player` the other side may lack. Steps in which the player was
 * absent are left out. */
static int64_t next_for(const peer *p, const peer_link *link, int player) {
    const peer_known *k = &p->known[player];
    int64_t has = link->has[player];
    bool is_absence = has >= k->gone_from && has < k->back_at && k->back_at != PEER_NEVER;
    return is_absence ? k->back_at : has;
}

/* Whether the inputs of `player` are sent to connection `number`. */
static bool passes_on(const peer *p, int number, int player) {
    return player != number && (player == p->me || is_host(p));
}

bool peer_is_too_late(const peer *p, int number) {
    bool is_late = false;
    for (int i = 0; i < p->players; i++) {
        is_late |= passes_on(p, number, i) &&
                   p->known[i].heard - next_for(p, &p->links[number], i) > PEER_INPUTS;
    }
    return is_late;
}

/* Whether this peer and another one compare their leads: both are players that are present. */
static bool is_timed(const peer *p, int number) {
    return p->me < p->players && number < p->players && !peer_is_absent(p, p->me) &&
           !peer_is_absent(p, number);
}

/* The inputs of a player that the other side may lack; the bytes are written to `room`. */
static message_run run_for(const peer *p, const peer_link *link, int player, unsigned char *room) {
    const peer_known *k = &p->known[player];
    int64_t first = next_for(p, link, player), count = k->heard - first;
    count = count > MESSAGE_RUN_MAX ? MESSAGE_RUN_MAX : count;
    for (int64_t i = 0; i < count; i++) {
        room[i] = k->inputs[(first + i) % PEER_INPUTS];
    }
    return (message_run){.player = player, .first = first, .count = (int)count, .inputs = room};
}

static void write_events(const peer *p, const peer_link *link, message_packet *out) {
    out->has_events = !p->is_mesh;
    out->known = p->event_count;
    if (is_host(p)) {
        out->first_event = link->events;
        while (out->events < MESSAGE_EVENTS_MAX && link->events + out->events < p->event_count) {
            out->event[out->events] = p->events[(link->events + out->events) % PEER_EVENTS];
            out->events++;
        }
    }
}

int peer_write(peer *p, int number, unsigned char *out) {
    const peer_link *link = &p->links[number];
    unsigned char inputs[CARS_MAX][MESSAGE_RUN_MAX];
    peer_hash hash = newest_hash(p);
    message_packet packet = {.from = p->me, .hash_step = hash.step, .hash = hash.hash, .held = -1};
    if (is_timed(p, number)) {
        int64_t lead = 0;
        thud_rollback_get_lead(p->rollback, number, &lead);
        packet.lead = lead > MESSAGE_LEAD_MAX    ? MESSAGE_LEAD_MAX
                      : lead < -MESSAGE_LEAD_MAX ? -MESSAGE_LEAD_MAX
                                                 : (int)lead;
    }
    packet.has_time = p->now >= 0;
    if (packet.has_time) {
        packet.sent = (int)(p->now & 0xffff);
        packet.echo = link->sent;
        int64_t held = p->now - link->came;
        packet.held = !link->has_come ? -1 : held < HELD_MAX ? (int)held : HELD_MAX;
    }
    write_events(p, link, &packet);
    for (int i = 0; i < p->players; i++) {
        bool acks = is_host(p) || p->is_mesh ? i == number : i != p->me;
        if (acks) {
            packet.ack[packet.acks++] = (message_ack){.player = i, .step = p->known[i].heard};
        }
        message_run run = {0};
        if (passes_on(p, number, i)) {
            run = run_for(p, link, i, inputs[i]);
        }
        if (run.count > 0) {
            packet.run[packet.runs++] = run;
        }
    }
    int bytes = message_write_packet(&packet, out);
    p->bytes += bytes;
    p->messages++;
    return bytes;
}

/* Whether `from` may send these inputs, and none contradicts an input that is known already. */
static bool is_run(const peer *p, int from, const message_run *run) {
    const peer_known *k = &p->known[run->player];
    bool is_right = run->player != p->me && (run->player == from || (from == 0 && !p->is_mesh));
    int64_t oldest = k->heard - PEER_INPUTS;
    oldest = oldest < k->since ? k->since : oldest;
    for (int64_t i = 0; i < run->count && is_right; i++) {
        int64_t step = run->first + i;
        is_right =
            step < oldest || step >= k->heard || k->inputs[step % PEER_INPUTS] == run->inputs[i];
    }
    return is_right;
}

/* Whether the events of a packet are allowed: only the host may send events, and no player can
 * confirm more of them than the host has sent. */
static bool are_events(const peer *p, const message_packet *m) {
    if (!m->has_events) {
        return true;
    }
    if (is_host(p)) {
        return m->known <= p->event_count && m->events == 0;
    }
    bool is_right =
        m->from == 0 && !p->is_mesh && (m->events == 0 || m->first_event <= p->event_count);
    for (int i = 0; i < m->events && is_right; i++) {
        is_right = m->event[i].player != p->me || m->event[i].enters;
    }
    return is_right;
}

/* Whether the sender of a packet may send it, by what this peer knows. */
static bool is_packet(const peer *p, int from, const message_packet *m) {
    bool is_right = (from < 0 || from == m->from) && peer_tells(p, m->from) &&
                    m->lead <= MESSAGE_LEAD_MAX && m->lead >= -MESSAGE_LEAD_MAX && are_events(p, m);
    for (int i = 0; i < m->acks && is_right; i++) {
        /* A player that does not know yet that it enters has given no inputs, so that others may
         * know more of its steps than it does. */
        int player = m->ack[i].player;
        is_right = player != p->me || peer_is_absent(p, player) ||
                   m->ack[i].step <= p->known[player].heard;
    }
    for (int i = 0; i < m->runs && is_right; i++) {
        is_right = is_run(p, m->from, &m->run[i]);
    }
    return is_right;
}

thud_result peer_hear(peer *p, int player, uint64_t input) {
    peer_known *k = &p->known[player];
    thud_result result = thud_rollback_input(p->rollback, player, k->heard, input);
    if (result == THUD_OK) {
        k->inputs[k->heard % PEER_INPUTS] = (unsigned char)input;
        k->heard++;
    }
    return result;
}

/* Takes the inputs that continue the known ones, as far as the rollback can store them. A player
 * that waits may be sent more than that; they are sent again later. */
static thud_result take_run(peer *p, const message_run *run) {
    peer_known *k = &p->known[run->player];
    int64_t end = steps_of(p) + p->depth;
    end = peer_is_absent(p, run->player) && k->gone_from < end ? k->gone_from : end;
    end = run->first + run->count < end ? run->first + run->count : end;
    thud_result result = THUD_OK;
    while (run->first <= k->heard && k->heard < end && result == THUD_OK) {
        result = peer_hear(p, run->player, run->inputs[k->heard - run->first]);
    }
    return result;
}

/* Applies events to the rollback, up to the last step that it accepts. */
static thud_result apply_events(peer *p) {
    thud_result result = THUD_OK;
    for (; p->events_applied < p->event_count && result == THUD_OK; p->events_applied++) {
        const message_event *e = &p->events[p->events_applied % PEER_EVENTS];
        peer_known *k = &p->known[e->player];
        if (e->step > steps_of(p) + p->depth || (e->enters && k->heard < k->gone_from)) {
            break;
        }
        if (e->enters) {
            result = thud_rollback_enter(p->rollback, e->player, e->step);
            k->since = k->heard = k->back_at = e->step;
        } else {
            result = thud_rollback_leave(p->rollback, e->player, e->step);
            k->gone_from = e->step;
            k->back_at = PEER_NEVER;
        }
    }
    return result;
}

/* Appends the events that this peer lacks, as far as there is room; the others are sent again. On
 * the host: notes how many events the sender has. */
static thud_result take_events(peer *p, peer_link *link, const message_packet *m) {
    if (m->has_events && is_host(p)) {
        link->events = m->known > link->events ? m->known : link->events;
    }
    for (int i = p->event_count - m->first_event; !is_host(p) && i >= 0 && i < m->events; i++) {
        if (p->event_count - p->events_applied == PEER_EVENTS) {
            break;
        }
        p->events[p->event_count++ % PEER_EVENTS] = m->event[i];
    }
    return apply_events(p);
}

thud_result peer_read(peer *p, int from, const unsigned char *bytes, int count) {
    message_packet m;
    if (!message_read_packet(bytes, count, p->players, CARS_INPUTS, &m) ||
        !is_packet(p, from, &m)) {
        p->refused++;
        return THUD_OK;
    }
    peer_link *link = &p->links[m.from];
    link->final = m.hash_step > link->final ? m.hash_step : link->final;
    for (int i = 0; i < m.acks; i++) {
        int player = m.ack[i].player;
        int64_t step = m.ack[i].step, known = p->known[player].heard;
        step = step < known ? step : known;
        link->has[player] = step > link->has[player] ? step : link->has[player];
    }
    thud_result result = take_events(p, link, &m);
    for (int i = 0; i < m.runs && result == THUD_OK; i++) {
        result = take_run(p, &m.run[i]);
    }
    if (m.has_time && p->now >= 0) {
        int past = (int)((p->now - m.sent) & 0xffff),
            before = (int)((p->now - link->sent) & 0xffff);
        if (!link->has_come || past <= before) {
            link->has_come = true;
            link->sent = m.sent;
            link->came = p->now;
        }
    }
    if (link->told.step < 0 && m.hash_step > link->hash_step) {
        link->told = (peer_hash){m.hash_step, m.hash};
        link->hash_step = m.hash_step;
    }
    if (result == THUD_OK && is_timed(p, m.from)) {
        result = thud_rollback_set_lead(p->rollback, m.from, m.lead);
    }
    return result;
}

/* ---- playing ---- */

/* Compares a hash that was received with this peer's own, once the step is confirmed here. */
static void compare_hash(const peer *p, peer_link *link) {
    int64_t step = link->told.step;
    if (step < 0 || step >= p->hashed) {
        return;
    }
    const peer_hash *own = &p->hashes[step / PEER_HASH_STEPS % PEER_HASHES];
    if (own->step == step && own->hash != link->told.hash && link->differs_from < 0) {
        link->differs_from = step;
    }
    link->told.step = -1;
}

/* Appends an event to the host's list, and applies it. */
static thud_result announce(peer *p, bool enters, int player, int64_t step) {
    p->events[p->event_count++ % PEER_EVENTS] =
        (message_event){.enters = enters, .player = player, .step = step};
    return apply_events(p);
}

/* Whether a player can enter: it has caught up, and all others have its inputs from before it left.
 */
static bool can_enter(const peer *p, int player, int64_t step) {
    const peer_link *own = &p->links[player];
    /* The hashes of the other side are late by the time that three messages take, and told of every
     * few steps alone, hence the depth as a margin. What it has confirmed says less: it confirms
     * inputs that it has not run yet. */
    bool can = own->is_joining && own->final >= 0 &&
               own->final + PEER_HASH_STEPS >= steps_of(p) - p->depth &&
               (p->end == 0 || step < p->end) && p->events_applied == p->event_count;
    for (int i = 0; i < MESSAGE_NUMBERS && can; i++) {
        const peer_link *link = &p->links[i];
        can = !link->is_told ||
              (link->events == p->event_count && link->has[player] >= p->known[player].gone_from);
    }
    return can;
}

static thud_result let_in(peer *p) {
    thud_result result = THUD_OK;
    int64_t step = p->known[p->me].heard + NOTICE;
    for (int i = 0; is_host(p) && i < p->players && result == THUD_OK; i++) {
        if (can_enter(p, i, step)) {
            p->links[i].is_joining = false;
            result = announce(p, true, i, step);
        }
    }
    return result;
}

thud_result peer_advance(peer *p) {
    bool made = true, is_over = p->end && steps_of(p) >= p->end;
    thud_result result = let_in(p);
    result = result == THUD_OK ? apply_events(p) : result;
    if (result == THUD_OK) {
        result =
            is_over ? thud_rollback_settle(p->rollback) : thud_rollback_advance(p->rollback, &made);
    }
    int64_t sure = thud_progress_of(p->rollback).confirmed;
    p->waits += result == THUD_OK && !made;
    for (; p->hashed <= sure && result == THUD_OK; p->hashed += PEER_HASH_STEPS) {
        peer_hash *h = &p->hashes[p->hashed / PEER_HASH_STEPS % PEER_HASHES];
        h->step = p->hashed;
        result = thud_rollback_get_state(p->rollback, p->hashed, &h->hash, NULL);
    }
    for (int i = 0; i < MESSAGE_NUMBERS; i++) {
        compare_hash(p, &p->links[i]);
    }
    return result;
}

bool peer_has_ended(const peer *p) {
    thud_rollback_progress now = thud_progress_of(p->rollback);
    return p->end && now.confirmed >= p->end && now.settled >= p->end;
}

bool peer_is_done(const peer *p) {
    bool is_done = peer_has_ended(p);
    for (int i = 0; i < MESSAGE_NUMBERS && is_done; i++) {
        const peer_link *link = &p->links[i];
        for (int player = 0; link->is_told && player < p->players; player++) {
            is_done &=
                !passes_on(p, i, player) || next_for(p, link, player) >= p->known[player].heard;
        }
        is_done &= !link->is_told || !is_host(p) || link->events == p->event_count;
    }
    return is_done;
}

thud_result peer_hash_of(peer *p, uint64_t *out) {
    int64_t sure = thud_progress_of(p->rollback).confirmed;
    return thud_rollback_get_state(p->rollback, sure, out, NULL);
}

/* ---- the host ---- */

void peer_connect(peer *p, int number) {
    p->links[number] = new_link();
}

thud_result peer_miss(peer *p, int player) {
    return announce(p, false, player, p->known[player].heard);
}

thud_result peer_lose(peer *p, int number) {
    p->links[number].is_told = p->links[number].is_joining = false;
    return number < p->players && !peer_is_absent(p, number) ? peer_miss(p, number) : THUD_OK;
}

/* Whether all entries and exits take effect at or before a step, and are applied. */
static bool is_settled(const peer *p, int64_t step) {
    bool is = p->events_applied == p->event_count;
    for (int i = 0; i < p->players; i++) {
        const peer_known *k = &p->known[i];
        is &= (k->gone_from == PEER_NEVER || k->gone_from <= step) &&
              (k->back_at == PEER_NEVER || k->back_at <= step);
    }
    return is;
}

thud_result peer_invite(peer *p, int number, message_welcome *out_welcome, unsigned char **out_game,
                        size_t *out_bytes) {
    *out_game = NULL;
    thud_result result = thud_rollback_settle(p->rollback);
    int64_t step = thud_progress_of(p->rollback).confirmed;
    if (result != THUD_OK || !is_settled(p, step)) {
        return result;
    }
    result = thud_rollback_snapshot(p->rollback, NULL, 0, out_bytes);
    unsigned char *game = result == THUD_OK ? malloc(*out_bytes) : NULL;
    if (!game) {
        return result == THUD_OK ? THUD_ERROR_MEMORY : result;
    }
    result = thud_rollback_snapshot(p->rollback, game, *out_bytes, out_bytes);
    if (result != THUD_OK) {
        free(game);
        return result;
    }
    *out_game = game;
    *out_welcome = (message_welcome){.own = number,
                                     .players = p->players,
                                     .depth = p->depth,
                                     .end = p->end,
                                     .step = step,
                                     .events = p->event_count,
                                     .bytes = (int64_t)*out_bytes};
    p->links[number] = new_link();
    p->links[number].events = p->event_count;
    p->links[number].is_joining = number < p->players;
    for (int i = 0; i < p->players; i++) {
        p->links[number].has[i] = step;
        out_welcome->absent |= (uint32_t)peer_is_absent(p, i) << i;
    }
    return THUD_OK;
}

/* ---- who joins ---- */

/* The next step whose hash is told, where the rollback has begun in the midst of a game. */
static void hash_from_now(peer *p) {
    p->hashed = (steps_of(p) + PEER_HASH_STEPS - 1) / PEER_HASH_STEPS * PEER_HASH_STEPS;
}

thud_result peer_accept(peer *p, const message_welcome *welcome, const void *game) {
    thud_result result = thud_rollback_restore(p->rollback, game, (size_t)welcome->bytes);
    if (result == THUD_OK && steps_of(p) != welcome->step) {
        return THUD_ERROR_INVALID;
    }
    if (result == THUD_OK) {
        hash_from_now(p);
        p->event_count = p->events_applied = welcome->events;
        for (int i = 0; i < p->players; i++) {
            peer_known *k = &p->known[i];
            k->since = k->heard = p->links[0].has[i] = welcome->step;
            k->gone_from = welcome->absent >> i & 1 ? welcome->step : PEER_NEVER;
        }
    }
    return result;
}

bool peer_is_behind(const peer *p) {
    int64_t step = steps_of(p), known = PEER_NEVER;
    for (int i = 0; i < p->players; i++) {
        /* The own inputs are given step by step, from the one on in which this player enters. */
        int64_t to = i == p->me ? p->known[i].since : p->known[i].heard;
        known = !peer_is_absent(p, i) && to < known ? to : known;
    }
    return known != PEER_NEVER && known > step + 2 && !(p->end && step >= p->end);
}

/* ---- a mesh ---- */

thud_result peer_part(peer *p, int player, int64_t step) {
    p->links[player].is_told = false;
    p->known[player].gone_from = step;
    p->known[player].back_at = PEER_NEVER;
    return thud_rollback_leave(p->rollback, player, step);
}

thud_result peer_meet(peer *p, int player, int64_t step, int64_t has) {
    thud_result result = thud_rollback_enter(p->rollback, player, step);
    if (result == THUD_OK) {
        peer_known *k = &p->known[player];
        k->since = k->heard = k->back_at = step;
        p->links[player] = new_link();
        p->links[player].has[p->me] = has;
    }
    return result;
}

thud_result peer_join(peer *p, peer *host, int64_t step) {
    size_t bytes;
    thud_result result = thud_rollback_snapshot(host->rollback, NULL, 0, &bytes);
    void *game = result == THUD_OK ? malloc(bytes) : NULL;
    if (!game) {
        return result != THUD_OK ? result : THUD_ERROR_MEMORY;
    }
    result = thud_rollback_snapshot(host->rollback, game, bytes, &bytes);
    result = result == THUD_OK ? thud_rollback_restore(p->rollback, game, bytes) : result;
    free(game);
    result = result == THUD_OK ? thud_rollback_enter(p->rollback, p->me, step) : result;
    if (result == THUD_OK) {
        int64_t now = steps_of(p);
        hash_from_now(p);
        for (int i = 0; i < p->players; i++) {
            p->known[i].since = p->known[i].heard = i == p->me ? step : now;
            p->links[i].has[p->me] = step;
        }
    }
    return result;
}
