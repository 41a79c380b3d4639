/* snapshot_support.h: snapshots that a test keeps, a digest of everything that a caller can read
 * after a step, digests step by step, and a small scene with terrain and a sensor (yard). */
#ifndef SNAPSHOT_SUPPORT_H
#define SNAPSHOT_SUPPORT_H

#include "engine_support.h"

#include <thud/thud_snapshot.h>
#include <thud/thud_terrain.h>

/* A snapshot in memory of its own. */
typedef struct saved {
    char *bytes;
    size_t size;
} saved;

static inline saved save(const thud_world *world) {
    saved made = {NULL, 0};
    size_t written = 0;
    OK(thud_world_get_snapshot_size(world, &made.size));
    made.bytes = malloc(made.size);
    assert_non_null(made.bytes);
    OK(thud_world_snapshot(world, made.bytes, made.size, &written));
    assert_int_equal(written, made.size);
    return made;
}

/* Restores the world from a snapshot. */
static inline void back_to(thud_world *world, saved snapshot) {
    OK(thud_world_restore(world, snapshot.bytes, snapshot.size));
}

/* Adds bytes to a digest (FNV-1a's step). */
static inline void mix(uint64_t *digest, const void *values, size_t bytes) {
    const unsigned char *at = values;
    for (size_t i = 0; i < bytes; i++) {
        *digest = (*digest ^ at[i]) * 0x100000001b3u;
    }
}

#define MIX(value) mix(&digest, &(value), sizeof(value))

/* Digest of the world's hash, poses, events, errors and statistics, without times and memory. */
static inline uint64_t digest_of(thud_world *world) {
    uint64_t digest = thud_hash_of(world);
    int count = 0;
    const thud_pose *poses = thud_poses_of(world, (thud_pos){0, 0}, 0.5, &count);
    for (int i = 0; i < count; i++) {
        /* else the slot has no body, and its other values mean nothing */
        if (poses[i].x == poses[i].x) {
            MIX(poses[i]);
        }
    }
    thud_events e = thud_events_of(world);
    mix(&digest, e.begin, (size_t)e.begin_count * sizeof *e.begin);
    mix(&digest, e.end, (size_t)e.end_count * sizeof *e.end);
    mix(&digest, e.sensor_begin, (size_t)e.sensor_begin_count * sizeof *e.sensor_begin);
    mix(&digest, e.sensor_end, (size_t)e.sensor_end_count * sizeof *e.sensor_end);
    mix(&digest, e.sensor_begin_time, (size_t)e.sensor_begin_count * sizeof *e.sensor_begin_time);
    mix(&digest, e.sensor_end_time, (size_t)e.sensor_end_count * sizeof *e.sensor_end_time);
    mix(&digest, e.quarantined, (size_t)e.quarantined_count * sizeof *e.quarantined);
    for (int i = 0; i < e.hit_count; i++) {
        MIX(e.hit[i].shape_a);
        MIX(e.hit[i].shape_b);
        MIX(e.hit[i].point);
        MIX(e.hit[i].speed);
    }
    thud_step_error error = thud_step_error_of(world);
    MIX(error.penetration_max);
    MIX(error.penetration_mean);
    MIX(error.residual);
    MIX(error.energy_change);
    MIX(error.energy_decided);
    MIX(error.shortfall);
    double limit;
    OK(thud_world_get_bisection_limit(world, &limit));
    MIX(limit);
    thud_stats s = thud_stats_of(world);
    const uint64_t counts[] = {s.steps,
                               (uint64_t)s.bodies,
                               (uint64_t)s.shapes,
                               (uint64_t)s.awake_bodies,
                               (uint64_t)s.pairs,
                               (uint64_t)s.contacts,
                               (uint64_t)s.colours,
                               (uint64_t)s.blocks,
                               (uint64_t)s.substeps,
                               (uint64_t)s.direct_islands,
                               (uint64_t)s.factorings,
                               (uint64_t)s.island_work,
                               (uint64_t)s.impacts,
                               (uint64_t)s.motion_pairs};
    MIX(counts);
    return digest;
}

#undef MIX

enum { TRAIL_MOST = 256 };

/* Digests before the first step and after each step. */
typedef struct trail {
    int steps;
    uint64_t digest[TRAIL_MOST + 1];
} trail;

/* Steps the world and records its digests. */
static inline trail walk(thud_world *world, int steps) {
    trail made = {.steps = steps};
    assert_true(steps <= TRAIL_MOST);
    made.digest[0] = digest_of(world);
    for (int i = 1; i <= steps; i++) {
        OK(thud_world_step(world));
        made.digest[i] = digest_of(world);
    }
    return made;
}

/* Asserts that the world, which was restored, repeats the recorded steps exactly. `what` names the
 * case. */
static inline void walks_again(thud_world *world, const trail *before, const char *what) {
    trail now = walk(world, before->steps);
    for (int i = 0; i <= before->steps; i++) {
        if (now.digest[i] != before->digest[i]) {
            fail_msg("%s: differs %d steps after the snapshot", what, i);
        }
    }
}

/* A ground of hills, boxes and a ball on it, and a sensor. */
typedef struct yard {
    thud_world *world;
    thud_shape_id ground, ball_shape;
    thud_body_id ball, box, heap[12];
} yard;

static inline yard make_yard(const thud_world_def *def) {
    yard y = {.world = make_world(def ? *def : thud_default_world_def())};
    thud_pos points[33];
    for (int i = 0; i < 33; i++) {
        points[i] = (thud_pos){i - 16, (i % 5) * 0.3};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 33};
    thud_shape_def plain = thud_default_shape_def(), sensor = plain;
    OK(thud_shape_create_terrain(y.world, add_body(y.world, THUD_BODY_STATIC, 0, 0, 0), &plain,
                                 &line, &y.ground));
    y.ball = add_body(y.world, THUD_BODY_DYNAMIC, -5, 3, 0);
    y.ball_shape = add_shape(y.world, y.ball, 0.5f, 0, false, NULL);
    y.box = add_box(y.world, 5, 3, 0.5f, 0.4f);
    sensor.sensor = true;
    add_shape(y.world, add_body(y.world, THUD_BODY_STATIC, 0, 2, 0), 3, 2, true, &sensor);
    for (int i = 0; i < 12; i++) {
        y.heap[i] = add_box(y.world, 0.3 * (i % 3), 2 + i, 0.5f, 0.4f);
    }
    return y;
}

#endif
