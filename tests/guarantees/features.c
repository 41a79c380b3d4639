/* features.c: guarantees of optional features: fields, casts, locked axes, rules, rollback. A yard
 * (yard.h) that uses them runs beside a twin, which differs in a setting that must not matter; both
 * must report the same for each step. */
#include "guarantee.h"
#include "yard.h"

#include <thud/thud_casts.h>
#include <thud/thud_fields.h>
#include <thud/thud_joint.h>
#include <thud/thud_locks.h>
#include <thud/thud_packed.h>
#include <thud/thud_recording.h>
#include <thud/thud_rollback.h>
#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_textured.h>
#include <thud/thud_testing.h>

enum { STEPS = 30, RESTORED_EVERY = 7, RAYS = 96 };

/* ---- twins ---- */

typedef enum twin { SIMD, NEXT_BROADPHASE, LAST_BROADPHASE, FAR_AWAY, RESTORED, ASKED, TWINS } twin;

static const char *const twin_names[TWINS] = {"with the other SIMD",
                                              "with another broadphase",
                                              "with the third broadphase",
                                              "far away",
                                              "restored",
                                              "that is asked"};

static thud_world_def def_of(trial *t, twin kind) {
    thud_world_def def = trial_def(t);
    thud_world_def_set_baseline_simd(&def, kind == SIMD);
    if (kind == NEXT_BROADPHASE || kind == LAST_BROADPHASE) {
        settings other = *t->set;
        other.value[BROADPHASE] += kind == NEXT_BROADPHASE ? 1 : 3;
        other.value[BROADPHASE] %= dimensions[BROADPHASE].count;
        def.broadphase = settings_broadphase(&other);
    }
    return def;
}

/* Exchanges the yard's world for the spare one, which is restored from a snapshot of it. */
static void swap_world(yard *y, thud_world **spare) {
    trial_bytes s = trial_snapshot(y->t, y->world);
    DO(y->t, thud_world_restore(*spare, s.bytes, s.size));
    thud_world *now = *spare;
    *spare = y->world;
    y->world = now;
    free(s.bytes);
}

/* Mixes a hit into the digest and continues the cast. */
static double hear(const thud_ray_hit *hit, void *context) {
    uint64_t *digest = context;
    yard_mix(digest, &hit->shape.index1, sizeof hit->shape.index1);
    yard_mix(digest, &hit->fraction, sizeof hit->fraction);
    return THUD_CAST_ON;
}

/* A digest of casts from the middle of the room in all directions: many in one call, hit by hit,
 * and of single shapes. */
static uint64_t cast(yard *y) {
    trial *t = y->t;
    thud_ray rays[RAYS];
    thud_ray_hit hits[RAYS];
    thud_pos origin = yard_origin(y), middle = trial_place(t, 0, 3);
    uint64_t digest = 0xcbf29ce484222325u;
    middle.x += origin.x;
    middle.y += origin.y;
    for (int i = 0; i < RAYS; i++) {
        double c = 1, s = 0;
        thud_sincos(i * 0.0625, &s, &c);
        rays[i] = (thud_ray){.origin = middle, .dx = 6 * c * t->scale, .dy = 6 * s * t->scale};
    }
    DO(t, thud_world_cast_rays(y->world, rays, RAYS, hits));
    for (int i = 0; i < RAYS; i++) {
        hear(&hits[i], &digest);
    }
    thud_geometry ball = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 0.3 * t->scale};
    for (int i = 0; i < 4; i++) {
        DO(t, thud_world_cast_ray_each(y->world,
                                       &(thud_ray){middle, rays[7 * i].dx, rays[7 * i].dy, NULL},
                                       hear, &digest));
        DO(t, thud_world_cast_shape_each(y->world,
                                         &(thud_shape_cast){middle, ball, rays[9 * i].dx,
                                                            rays[9 * i].dy, NULL},
                                         hear, &digest));
    }
    return digest;
}

/* Queries, reports and snapshots, which must change nothing, also between two edits. */
static void ask(yard *y) {
    cast(y);
    thud_step_error_of(y->world);
    thud_measure_of(y->world);
    free(trial_snapshot(y->t, y->world).bytes);
}

/* Three edits, with queries after each if `asked`, and a step. */
static void step_beside(yard *y, bool asked) {
    for (int i = 0; i < 3 && !trial_failed(y->t); i++) {
        yard_edit(y);
        if (asked) {
            ask(y);
        }
    }
    yard_step(y);
}

/* Runs a yard and its twin, and reports the first step (or cast) in which they differ. */
static void go_beside(trial *t, twin kind, unsigned features, bool casts) {
    yard one, other;
    thud_world *spare = NULL;
    int worlds = t->worlds;
    yard_make_with(&one, t, trial_def(t), 0, features);
    yard_make_with(&other, t, def_of(t, kind), kind == FAR_AWAY ? 1e7 : 0, features);
    if (kind == RESTORED) {
        spare = trial_make(t, def_of(t, SIMD));
        DO(t, thud_world_use_joints(spare));
        DO(t, thud_world_use_rules(spare));
        DO(t, thud_world_use_textures(spare));
    }
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        step_beside(&one, false);
        step_beside(&other, kind == ASKED);
        if (spare && i % RESTORED_EVERY == 0) {
            swap_world(&other, &spare);
        }
        if (!trial_failed(t) &&
            (yard_told(&one) != yard_told(&other) || (casts && cast(&one) != cast(&other)))) {
            trial_fault(t, "step %d differs in a world %s", i, twin_names[kind]);
        }
    }
    while (t->worlds > worlds) {
        thud_world_destroy(t->world[--t->worlds]);
    }
}

/* Runs a yard against each kind of twin. */
static void go_beside_all(trial *t, unsigned features, bool casts) {
    for (int kind = 0; kind < TWINS && !trial_failed(t); kind++) {
        go_beside(t, (twin)kind, features, casts);
    }
}

static void same_bits_with_fields(trial *t) {
    go_beside_all(t, YARD_FIELDS, false);
}

static void same_bits_with_rules(trial *t) {
    go_beside_all(t, YARD_RULES, false);
}

static void same_bits_with_locks_and_joints(trial *t) {
    go_beside_all(t, YARD_TIED, false);
}

static void same_bits_of_casts(trial *t) {
    go_beside_all(t, YARD_ALL, true);
}

/* An epilogue that sets a body's velocity. */
static void kick(thud_world *world, const thud_contact *contact, void *context) {
    yard *y = context;
    thud_body_set_velocity(world, contact->body_b, trial_speed(y->t, 1, 2), 0);
}

/* Edits that callbacks make take effect in the next step, after the edits that the caller makes in
 * between; queries change nothing of that order. */
static void edits_of_callbacks_wait_for_the_step_asked_or_not(trial *t) {
    yard yards[2];
    for (int k = 0; k < 2; k++) {
        yard_make(&yards[k], t, trial_def(t), 0);
        trial_listen(t, yards[k].world, NULL, kick, &yards[k]);
    }
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        for (int k = 0; k < 2; k++) {
            if (k) {
                ask(&yards[k]);
            }
            for (int b = 0; b < 4; b++) {
                DO(t, thud_body_set_velocity(yards[k].world, yards[k].body[b],
                                             trial_speed(t, -1, 0.5), 0));
            }
            yard_step(&yards[k]);
        }
        if (!trial_failed(t) && yard_told(&yards[0]) != yard_told(&yards[1])) {
            trial_fault(t, "step %d differs", i);
        }
    }
}

/* Many rays in one call are divided among workers. */
static void same_hits_any_workers(trial *t) {
    yard one, other;
    thud_world_def def = trial_def(t);
    long shared = 0;
    yard_make_with(&one, t, def, 0, YARD_ALL);
    def.job_system = trial_jobs(3 - settings_workers(t->set));
    yard_make_with(&other, t, def, 0, YARD_ALL);
    for (int i = 1; i <= STEPS && !trial_failed(t); i++) {
        yard_step(&one);
        yard_step(&other);
        long before = trial_shared_runs();
        if (cast(&one) != cast(&other)) {
            trial_fault(t, "hits of step %d differ", i);
        }
        shared += trial_shared_runs() - before;
    }
    if (shared == 0) {
        trial_fault(t, "no casts were shared");
    }
}

/* ---- rollback ---- */

enum { PLAYERS = 2, DEPTH = 6 };

/* The step function of the rollback: a yard with edits, whose first bodies the players push. */
static thud_result play(thud_world *world, const uint64_t *inputs, void *state) {
    yard *y = state;
    for (int i = 0; i < PLAYERS; i++) {
        double push = 0.01 * ((double)inputs[i] - 3) * y->t->scale * y->t->scale * y->t->scale;
        DO(y->t, thud_body_apply_center_impulse(world, y->body[i], (thud_vec2){(float)push, 0}));
    }
    yard_before_step(y);
    return thud_world_step(world);
}

/* Gives the rollback a player's inputs up to a step. */
static void tell_until(trial *t, thud_rollback *r, uint64_t inputs[STEPS][PLAYERS], int player,
                       int64_t *told, int64_t until) {
    for (; *told <= until && *told < STEPS; ++*told) {
        DO(t, thud_rollback_input(r, player, *told, inputs[*told][player]));
    }
}

static void late_inputs_end_as_a_straight_run(trial *t) {
    yard late, straight;
    thud_rollback *r = NULL;
    uint64_t inputs[STEPS][PLAYERS], hash = 0;
    int64_t told[PLAYERS] = {0};
    yard_make_with(&late, t, trial_def(t), 0, YARD_ALL);
    yard_make_with(&straight, t, trial_def(t), 0, YARD_ALL);
    DO(t, thud_rollback_create(late.world,
                               &(thud_rollback_options){.step = play,
                                                        .idle = 3,
                                                        .depth = DEPTH,
                                                        .state = &late,
                                                        .state_bytes = sizeof late},
                               &r));
    for (int i = 0; i < STEPS && !trial_failed(t); i++) {
        for (int player = 0; player < PLAYERS; player++) {
            inputs[i][player] = (uint64_t)trial_pick(t, 7);
        }
        for (int player = 0; player < PLAYERS; player++) {
            tell_until(t, r, inputs, player, &told[player], i - trial_pick(t, DEPTH));
        }
        DO(t, thud_rollback_advance(r, NULL));
    }
    if (!trial_failed(t) && thud_progress_of(r).replayed == 0) {
        trial_fault(t, "no step was played again");
    }
    for (int player = 0; player < PLAYERS && r; player++) {
        tell_until(t, r, inputs, player, &told[player], STEPS - 1);
    }
    for (int i = 0; i < STEPS && !trial_failed(t); i++) {
        DO(t, play(straight.world, inputs[i], &straight));
    }
    DO(t, thud_rollback_settle(r));
    DO(t, thud_rollback_get_state(r, STEPS, &hash, NULL));
    if (!trial_failed(t) &&
        (hash != thud_hash_of(straight.world) || yard_told(&late) != yard_told(&straight))) {
        trial_fault(t, "late inputs end elsewhere");
    }
    thud_rollback_destroy(r);
}

/* ---- packed snapshots ---- */

/* A snapshot of the world, in memory of its own. */
static thud_bytes snapshot_of(trial *t, const thud_world *world) {
    size_t bytes = 0;
    DO(t, thud_world_get_snapshot_size(world, &bytes));
    char *buffer = malloc(bytes + 1);
    DO(t, thud_world_snapshot(world, buffer, bytes, NULL));
    return (thud_bytes){buffer, bytes};
}

/* Packs a snapshot, unpacks it, and finds the same bytes. */
static void pack_and_unpack(trial *t, const thud_world *world, thud_bytes base,
                            thud_bytes snapshot) {
    size_t packed = 0, back = 0, room = 2 * snapshot.count + 4096;
    char *small = malloc(room), *whole = malloc(room);
    DO(t, thud_world_pack(world, base, snapshot, small, room, &packed));
    DO(t, thud_world_unpack(world, base, (thud_bytes){small, packed}, whole, room, &back));
    if (!trial_failed(t) && (back != snapshot.count || memcmp(whole, snapshot.data, back) != 0)) {
        trial_fault(t, "other bytes are unpacked than were packed");
    }
    free(small);
    free(whole);
}

static void packed_snapshots_unpack_to_the_same_bytes(trial *t) {
    yard y;
    yard_make_with(&y, t, trial_def(t), 0, YARD_ALL);
    thud_bytes base = {NULL, 0};
    for (int i = 0; i < STEPS && !trial_failed(t); i++) {
        yard_before_step(&y);
        DO(t, thud_world_step(y.world));
        thud_bytes now = snapshot_of(t, y.world);
        pack_and_unpack(t, y.world, (thud_bytes){NULL, 0}, now);
        pack_and_unpack(t, y.world, base, now);
        free((void *)base.data);
        base = now;
    }
    free((void *)base.data);
}

/* ---- recordings ---- */

/* Plays a recording, and finds the yard as it is. */
static void play_recording(trial *t, const yard *y, thud_bytes bytes) {
    thud_player *player = NULL;
    thud_player_progress progress = {0};
    yard played = *y;
    DO(t, thud_player_create(bytes, NULL, &player));
    for (bool stepped = true; stepped && !trial_failed(t);) {
        DO(t, thud_player_step(player, &stepped));
    }
    DO(t, thud_player_get_progress(player, &progress));
    DO(t, thud_player_get_world(player, &played.world));
    if (!trial_failed(t) && (progress.steps != STEPS || yard_told(&played) != yard_told(y) ||
                             thud_hash_of(played.world) != thud_hash_of(y->world))) {
        trial_fault(t, "a recording is played to another state");
    }
    thud_player_destroy(player);
}

static void recordings_play_to_the_same_bits(trial *t) {
    yard y;
    thud_recorder *recorder = NULL;
    thud_bytes bytes = {NULL, 0};
    yard_make_with(&y, t, trial_def(t), 0, YARD_ALL);
    DO(t, thud_recorder_begin(y.world, &(thud_recorder_options){.hash_steps = 8}, &recorder));
    for (int i = 0; i < STEPS && !trial_failed(t); i++) {
        yard_step(&y);
    }
    if (!trial_failed(t)) {
        DO(t, thud_recorder_get_bytes(recorder, &bytes));
        play_recording(t, &y, bytes);
    }
    thud_recorder_end(recorder);
}

const guarantee guarantees_of_features[] = {
    GUARANTEE(edits_of_callbacks_wait_for_the_step_asked_or_not),
    GUARANTEE(late_inputs_end_as_a_straight_run),
    GUARANTEE(packed_snapshots_unpack_to_the_same_bytes),
    GUARANTEE(recordings_play_to_the_same_bits),
    GUARANTEE(same_bits_of_casts),
    GUARANTEE(same_bits_with_fields),
    GUARANTEE(same_bits_with_locks_and_joints),
    GUARANTEE(same_bits_with_rules),
    GUARANTEE(same_hits_any_workers),
    {.name = NULL},
};
