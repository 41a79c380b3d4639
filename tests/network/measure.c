/* measure.c: see measure.h. Everything happens in frames of a step's length, in this order: all
 * players send their input of the frame and the server its state, all receive what has arrived, and
 * all run the step. So without delay and loss nothing is ever predicted. */
#include "measure.h"

#include "over_wire.h"
#include "series.h"

#include <thud/thud_packed.h>
#include <thud/thud_prediction.h>
#include <thud/thud_reads.h>
#include <thud/thud_snapshot.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* States of the truth that are kept for players to be shown; the first frames, of which no error is
 * taken; where the seeds begin. */
enum { KEPT = 128, WARMING = 2 * CARS_RATE, SEED = 32 };

#define FRAME_MS (1000.0 / CARS_RATE)
#define DEGREES (180 / 3.14159265358979323846)

const char *const MEASURE_WAYS[WAY_COUNT] = {"last known place", "extrapolation",
                                             "swept prediction", "resimulation"};

typedef struct place {
    double x, y, angle;
} place;

/* Numbers of which a spread is wanted. */
typedef struct heap {
    double *values;
    int count;
} heap;

/* What is shown to a player. */
typedef struct viewer {
    int64_t newest;                        /* step of the newest state that has arrived */
    place off[WAY_COUNT][CARS_BODIES_MAX]; /* of the frame before */
} viewer;

/* A run of one plan. */
typedef struct run {
    const measure_plan *plan;
    int bodies;
    place *truth;     /* by step and body: before the step */
    uint64_t *hashes; /* likewise, of the world */
    char *states[KEPT];
    size_t state_bytes[KEPT], state_room;
    int64_t *newest; /* by frame and player: what `newest` was */
    peer peers[CARS_MAX];
    viewer viewers[CARS_MAX];
    thud_world *server, *asked;
    cars game;
    wire *inputs, *state_wire;
    heap places[WAY_COUNT], angles[WAY_COUNT], place_jumps[WAY_COUNT], angle_jumps[WAY_COUNT];
    series frame_ms, step_ms;
    double packed_bytes;
    int64_t waits, replayed_max;
} run;

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static place place_of(const thud_world *world, thud_body_id body) {
    thud_pos at = {0};
    double angle = 0;
    float cosine, sine;
    bool is_found = thud_body_get_position(world, body, &at) == THUD_OK &&
                    thud_body_get_rotation(world, body, &angle, &cosine, &sine) == THUD_OK;
    return is_found ? (place){at.x, at.y, angle} : (place){NAN, NAN, NAN};
}

/* ---- the truth ---- */

/* Keeps what the server has before a step. */
static bool note_truth(run *r, int64_t step) {
    for (int i = 0; i < r->bodies; i++) {
        r->truth[step * r->bodies + i] = place_of(r->server, r->game.bodies[i]);
    }
    r->hashes[step] = thud_hash_of(r->server);
    int slot = (int)(step % KEPT);
    return thud_world_snapshot(r->server, r->states[slot], r->state_room, &r->state_bytes[slot]) ==
           THUD_OK;
}

static bool step_truth(run *r, int64_t step, int repetition) {
    uint64_t inputs[CARS_MAX];
    for (int i = 0; i < r->plan->players; i++) {
        inputs[i] = cars_input(SEED, i, step);
    }
    double began = now_ms();
    bool is_done = cars_step(r->server, inputs, &r->game) == THUD_OK;
    r->step_ms.ms[repetition * r->plan->steps + step] = now_ms() - began;
    return is_done && note_truth(r, step + 1);
}

/* Sends each player that the state has changed. What it would be sent is the state packed against
 * the newest one that the server knows it to have, by a confirmation that took the same delay. */
static bool send_states(run *r, int64_t step) {
    int64_t back = (int64_t)ceil(r->plan->delay / FRAME_MS) + 1;
    for (int i = 0; i < r->plan->players; i++) {
        int64_t base = step > back ? r->newest[(step - 1 - back) * r->plan->players + i] : 0;
        base = step - base < KEPT ? base : step - KEPT + 1;
        int old = (int)(base % KEPT), slot = (int)(step % KEPT);
        size_t bytes;
        uint32_t number = (uint32_t)step;
        if (thud_world_pack(r->server, (thud_bytes){r->states[old], r->state_bytes[old]},
                            (thud_bytes){r->states[slot], r->state_bytes[slot]}, NULL, 0,
                            &bytes) != THUD_OK ||
            !wire_send(r->state_wire, r->plan->players, i, (double)(step - 1) * FRAME_MS, &number,
                       sizeof number)) {
            return false;
        }
        r->packed_bytes += (double)(bytes + sizeof number + WIRE_HEAD_BYTES);
    }
    return true;
}

/* ---- errors ---- */

static void add(heap *h, double value) {
    h->values[h->count++] = value;
}

static int ascending(const void *left, const void *right) {
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static measure_spread spread_of(heap *h) {
    if (h->count == 0) {
        return (measure_spread){0};
    }
    double sum = 0;
    for (int i = 0; i < h->count; i++) {
        sum += h->values[i];
    }
    qsort(h->values, (size_t)h->count, sizeof *h->values, ascending);
    return (measure_spread){sum / h->count, series_quantile(h->values, h->count, 0.99),
                            h->values[h->count - 1]};
}

/* What a player is shown of the other bodies, `ahead` seconds after its newest state. */
static bool predict(run *r, const viewer *v, double ahead, thud_prediction flight[],
                    thud_prediction swept[]) {
    int slot = (int)(v->newest % KEPT);
    return thud_world_restore(r->asked, r->states[slot], r->state_bytes[slot]) == THUD_OK &&
           thud_world_extrapolate(r->asked, r->game.bodies, r->bodies, ahead, flight) == THUD_OK &&
           thud_world_predict(r->asked, r->game.bodies, r->bodies, ahead, swept) == THUD_OK;
}

static bool take_errors(run *r, int player, int64_t step, bool is_counted) {
    viewer *v = &r->viewers[player];
    thud_prediction flight[CARS_BODIES_MAX], swept[CARS_BODIES_MAX];
    if (!predict(r, v, (double)(step - v->newest) / CARS_RATE, flight, swept)) {
        return false;
    }
    for (int way = 0; way < WAY_COUNT; way++) {
        double place_jump = 0, angle_jump = 0;
        for (int i = 0; i < r->bodies; i++) {
            if (i == player) {
                continue;
            }
            place shown = r->truth[v->newest * r->bodies + i];
            if (way == WAY_FLIGHT || way == WAY_SWEPT) {
                const thud_prediction *p = way == WAY_FLIGHT ? &flight[i] : &swept[i];
                shown = (place){p->position.x, p->position.y, p->angle};
            } else if (way == WAY_ROLLBACK) {
                const peer *p = &r->peers[player];
                shown = place_of(p->world, p->game.bodies[i]);
            }
            const place *truth = &r->truth[step * r->bodies + i], *before = &v->off[way][i];
            place off = {shown.x - truth->x, shown.y - truth->y,
                         DEGREES * remainder(shown.angle - truth->angle, 2 * 180 / DEGREES)};
            if (is_counted) {
                add(&r->places[way], hypot(off.x, off.y));
                add(&r->angles[way], fabs(off.angle));
            }
            place_jump = fmax(place_jump, hypot(off.x - before->x, off.y - before->y));
            angle_jump = fmax(angle_jump, fabs(remainder(off.angle - before->angle, 360)));
            v->off[way][i] = off;
        }
        if (is_counted) {
            add(&r->place_jumps[way], place_jump);
            add(&r->angle_jumps[way], angle_jump);
        }
    }
    return true;
}

/* ---- frames ---- */

static bool play_peer(run *r, int player, int64_t step, int repetition) {
    peer *p = &r->peers[player];
    uint32_t number;
    unsigned char bytes[WIRE_BYTES_MAX];
    double now = (double)step * FRAME_MS;
    if (receive_over(p, r->inputs, now) != THUD_OK) {
        return false;
    }
    while (wire_receive(r->state_wire, player, now, bytes, NULL) >= 0) {
        memcpy(&number, bytes, sizeof number);
        viewer *v = &r->viewers[player];
        v->newest = (int64_t)number > v->newest ? (int64_t)number : v->newest;
    }
    r->newest[step * r->plan->players + player] = r->viewers[player].newest;
    int64_t replayed = thud_progress_of(p->rollback).replayed;
    bool made = false;
    double began = now_ms();
    thud_result result = thud_rollback_advance(p->rollback, &made);
    double ms = now_ms() - began;
    r->frame_ms.ms[repetition * r->frame_ms.steps + step * r->plan->players + player] = ms;
    replayed = thud_progress_of(p->rollback).replayed - replayed;
    r->replayed_max = replayed > r->replayed_max ? replayed : r->replayed_max;
    r->waits += !made;
    return result == THUD_OK;
}

static bool play_frame(run *r, int64_t step, int repetition) {
    const measure_plan *plan = r->plan;
    for (int i = 0; i < plan->players; i++) {
        if (press_at_random(&r->peers[i], SEED) != THUD_OK ||
            !send_over(&r->peers[i], r->inputs, (double)step * FRAME_MS)) {
            return false;
        }
    }
    bool is_first = repetition == 0; /* the others only repeat what is timed */
    if (!step_truth(r, step, repetition) || (is_first && !send_states(r, step + 1))) {
        return false;
    }
    for (int i = 0; i < plan->players; i++) {
        if (!play_peer(r, i, step, repetition) ||
            (is_first && !take_errors(r, i, step + 1, step >= WARMING))) {
            return false;
        }
    }
    return true;
}

/* Whether the confirmed state of each player is the truth. */
static bool is_agreed(run *r) {
    for (int i = 0; i < r->plan->players; i++) {
        uint64_t hash;
        int64_t sure = thud_progress_of(r->peers[i].rollback).confirmed;
        if (thud_rollback_get_state(r->peers[i].rollback, sure, &hash, NULL) != THUD_OK ||
            hash != r->hashes[sure]) {
            return false;
        }
    }
    return true;
}

/* ---- setting up ---- */

static bool open_run(run *r) {
    const measure_plan *plan = r->plan;
    wire_options o = {.delay = plan->delay,
                      .jitter = plan->line->jitter,
                      .loss = plan->line->loss,
                      .duplicates = plan->line->duplicates,
                      .held = plan->line->held,
                      .held_for = plan->line->held_for,
                      .seed = SEED};
    r->inputs = wire_create(&o);
    o.seed++;
    r->state_wire = wire_create(&o);
    thud_world_def def = cars_def(&thud_quality_default);
    cars ignored;
    if (!r->inputs || !r->state_wire || thud_world_create(&def, &r->server) != THUD_OK ||
        thud_world_create(&def, &r->asked) != THUD_OK ||
        !cars_build(r->server, plan->players, &r->game) ||
        !cars_build(r->asked, plan->players, &ignored)) {
        return false;
    }
    for (int i = 0; i < plan->players; i++) {
        r->viewers[i] = (viewer){0};
        if (!open_player(&r->peers[i], i, plan->players, MEASURE_DEPTH, &def)) {
            return false;
        }
    }
    r->waits = r->replayed_max = 0;
    return note_truth(r, 0);
}

static void close_run(run *r) {
    for (int i = 0; i < r->plan->players; i++) {
        peer_close(&r->peers[i]);
    }
    thud_world_destroy(r->server);
    thud_world_destroy(r->asked);
    wire_destroy(r->inputs);
    wire_destroy(r->state_wire);
    r->server = r->asked = NULL;
    r->inputs = r->state_wire = NULL;
}

static bool reserve(run *r) {
    const measure_plan *plan = r->plan;
    size_t frames = (size_t)plan->steps * (size_t)plan->players;
    r->bodies = plan->players + 1 + CARS_CRATES;
    size_t bodies = (size_t)r->bodies, steps = (size_t)plan->steps + 1;
    r->state_room = 1 << 20;
    r->truth = calloc(steps * bodies, sizeof *r->truth);
    r->hashes = calloc(steps, sizeof *r->hashes);
    r->newest = calloc(frames, sizeof *r->newest);
    bool is_there = r->truth && r->hashes && r->newest;
    for (int i = 0; i < KEPT; i++) {
        r->states[i] = malloc(r->state_room);
        is_there &= r->states[i] != NULL;
    }
    for (int way = 0; way < WAY_COUNT; way++) {
        r->places[way].values = calloc(frames * bodies, sizeof(double));
        r->angles[way].values = calloc(frames * bodies, sizeof(double));
        r->place_jumps[way].values = calloc(frames, sizeof(double));
        r->angle_jumps[way].values = calloc(frames, sizeof(double));
        is_there &= r->places[way].values && r->angles[way].values && r->place_jumps[way].values &&
                    r->angle_jumps[way].values;
    }
    is_there &= series_init(&r->frame_ms, (int)frames, plan->repetitions);
    return series_init(&r->step_ms, plan->steps, plan->repetitions) && is_there;
}

static void release(run *r) {
    free(r->truth);
    free(r->hashes);
    free(r->newest);
    for (int i = 0; i < KEPT; i++) {
        free(r->states[i]);
    }
    for (int way = 0; way < WAY_COUNT; way++) {
        free(r->places[way].values);
        free(r->angles[way].values);
        free(r->place_jumps[way].values);
        free(r->angle_jumps[way].values);
    }
    series_free(&r->frame_ms);
    series_free(&r->step_ms);
}

static void conclude(run *r, measure_result *out) {
    int players = r->plan->players;
    double seconds = (double)r->plan->steps / CARS_RATE * players;
    *out = (measure_result){.wire = wire_counts_of(r->inputs),
                            .replayed_max = (double)r->replayed_max,
                            .waits = (double)r->waits / (r->plan->steps * players),
                            .bytes_states = r->packed_bytes / seconds};
    for (int i = 0; i < players; i++) {
        const peer *p = &r->peers[i];
        out->replayed += (double)thud_progress_of(p->rollback).replayed / seconds;
        out->bytes += (double)p->bytes / seconds;
        out->bytes_in_all += (double)(p->bytes + p->messages * WIRE_HEAD_BYTES) / seconds;
    }
}

bool measure_run(const measure_plan *plan, measure_result *out) {
    run r = {.plan = plan};
    bool is_done = reserve(&r);
    for (int repetition = 0; repetition < plan->repetitions && is_done; repetition++) {
        is_done = open_run(&r);
        for (int64_t step = 0; step < plan->steps && is_done; step++) {
            is_done = play_frame(&r, step, repetition);
        }
        is_done = is_done && is_agreed(&r);
        if (is_done) {
            conclude(&r, out);
        }
        close_run(&r);
    }
    if (is_done) {
        series_summary frame = series_summarize(&r.frame_ms);
        out->ms_median = frame.median;
        out->ms_p99 = frame.p99;
        out->ms_step = series_summarize(&r.step_ms).median;
        for (int way = 0; way < WAY_COUNT; way++) {
            out->of[way] =
                (measure_errors){spread_of(&r.places[way]), spread_of(&r.angles[way]),
                                 spread_of(&r.place_jumps[way]), spread_of(&r.angle_jumps[way])};
        }
    }
    release(&r);
    return is_done;
}
