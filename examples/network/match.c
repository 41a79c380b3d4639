/* match.c: see match.h. */
#include "match.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* A peer that is n frames ahead of the others lengthens each frame by the share CORRECTION * n of
 * it, at most by CORRECTION_MAX. The small factor keeps the clocks from oscillating. Chosen. */
static const double CORRECTION = 0.02, CORRECTION_MAX = 0.2;

/* Maximum number of frames by which the clock may lag after a pause, and that are then run without
 * waiting; the rest is skipped. */
enum { MADE_UP_MAX = MATCH_DEPTH };

static void *allocate(size_t bytes, void *context) {
    match *m = context;
    m->allocated++;
    return aligned_alloc(64, (bytes + 63) & ~(size_t)63);
}

static void release(void *block, size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    free(block);
}

double match_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

bool match_open(match *m, const message_welcome *game, uint64_t seed) {
    *m = (match){.game = *game, .seed = seed, .next = match_now()};
    thud_world_def def = cars_def(&thud_quality_default);
    def.allocator = (thud_allocator){allocate, release, m};
    peer_options options = {.me = game->own,
                            .players = game->players,
                            .depth = game->depth,
                            .end = game->end,
                            .def = &def};
    if (!peer_open(&m->peer, &options)) {
        fprintf(stderr, "the game cannot be made: memory is short\n");
        return false;
    }
    m->allocated = 0;
    return true;
}

void match_close(match *m) {
    peer_close(&m->peer);
}

double match_wait(const match *m) {
    double left = m->next - match_now();
    return left > 0 ? left : 0;
}

thud_result match_press(match *m) {
    peer *p = &m->peer;
    p->now = (int64_t)(1000 * match_now());
    return peer_press(p, cars_input(m->seed, p->me, thud_progress_of(p->rollback).steps));
}

thud_result match_advance(match *m) {
    double frame = 1.0 / m->game.rate, now = match_now();
    double wait = CORRECTION * thud_progress_of(m->peer.rollback).ahead;
    wait = wait > CORRECTION_MAX ? CORRECTION_MAX : wait < -CORRECTION_MAX ? -CORRECTION_MAX : wait;
    m->next += frame * (1 + wait);
    m->next = m->next < now - MADE_UP_MAX * frame ? now : m->next;
    return peer_advance(&m->peer);
}

void match_print_arrival(const match *m, int number, const char *what, bool is_playing,
                         int missing) {
    printf("player %d %s", number, what);
    if (is_playing) {
        printf(" at step %lld\n", (long long)thud_progress_of(m->peer.rollback).steps);
    } else {
        printf(", %d to come\n", missing);
    }
    fflush(stdout);
}

bool match_print(match *m) {
    peer *p = &m->peer;
    thud_rollback_progress now = thud_progress_of(p->rollback);
    uint64_t hash;
    bool is_well = peer_has_ended(p);
    if (!is_well) {
        fprintf(stderr, "the game ended after %lld of %lld steps\n", (long long)now.confirmed,
                (long long)m->game.end);
    }
    for (int i = 0; i < MESSAGE_NUMBERS; i++) {
        if (p->links[i].differs_from >= 0) {
            fprintf(stderr, "player %d has another game from step %lld on, or before\n", i,
                    (long long)p->links[i].differs_from);
            is_well = false;
        }
    }
    if (peer_hash_of(p, &hash) == THUD_OK) {
        printf("player %d: %lld steps, %lld run again, %lld bytes sent, %lld messages refused, "
               "%lld allocations while playing\nhash %016llx\n",
               p->me, (long long)now.confirmed, (long long)now.replayed, (long long)p->bytes,
               (long long)p->refused, (long long)m->allocated, (unsigned long long)hash);
    }
    return is_well;
}
