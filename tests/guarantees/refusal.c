/* refusal.c: guarantees that calls which are refused, or which run out of memory, leave the world
 * unchanged. */
#include "guarantee.h"
#include "hostile_memory.h"
#include "yard.h"

#include <thud/thud_mover.h>
#include <thud/thud_snapshot.h>

/* Reports if the world's snapshot is not `before`. */
static void expect_same(trial *t, const thud_world *world, const trial_bytes *before,
                        const char *what) {
    trial_bytes now = trial_snapshot(t, world);
    if (now.size != before->size || memcmp(now.bytes, before->bytes, now.size) != 0) {
        trial_fault(t, "%s changed the world", what);
    }
    free(now.bytes);
}

static void refuse_bodies(trial *t, yard *y) {
    thud_world *w = y->world;
    thud_body_id body = y->body[0], stale = {body.index1, body.generation + 77}, out;
    thud_body_def def = thud_default_body_def();
    thud_vec2 wild = {NAN, 0};
    thud_pos nowhere = {INFINITY, 0};
    def.position.x = 2e9 * t->scale;
    REFUSED(t, thud_body_create(w, &def, &out), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_destroy(w, stale), THUD_ERROR_STALE);
    REFUSED(t, thud_body_set_transform(w, body, nowhere, 0), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_set_transform(w, body, (thud_pos){0, 0}, 2e6), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_set_velocity(w, body, wild, 0), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_set_velocity(w, y->floor, (thud_vec2){1, 0}, 0), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_apply_impulse(w, body, wild, (thud_pos){0, 0}), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_apply_center_force(w, body, wild), THUD_ERROR_INVALID);
    REFUSED(t, thud_body_set_awake(w, stale, true), THUD_ERROR_STALE);
    REFUSED(t, thud_body_set_enabled(w, stale, true), THUD_ERROR_STALE);
}

static void refuse_shapes(trial *t, yard *y) {
    thud_world *w = y->world;
    thud_body_id body = y->body[0];
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id out, stale = {y->line.index1, y->line.generation + 77};
    thud_vec2 zero = {0, 0};
    double heights[2] = {0, NAN};
    float huge = (float)(20000 * t->scale);
    REFUSED(t, thud_shape_create_circle(w, body, &def, zero, huge, &out), THUD_ERROR_INVALID);
    REFUSED(t, thud_shape_create_circle(w, body, &def, zero, -1, &out), THUD_ERROR_INVALID);
    REFUSED(t,
            thud_shape_create_terrain(w, body, &def, &(thud_terrain){.kind = THUD_TERRAIN_FLAT},
                                      &out),
            THUD_ERROR_INVALID);
    def.restitution = 1.5f;
    REFUSED(t, thud_shape_create_obb(w, body, &def, zero, trial_speed(t, 1, 1), 0, &out),
            THUD_ERROR_INVALID);
    REFUSED(t, thud_shape_destroy(w, stale), THUD_ERROR_STALE);
    REFUSED(t, thud_shape_set_heights(w, y->line, 0, heights, 2), THUD_ERROR_INVALID);
    REFUSED(t, thud_shape_dig(w, y->line, (thud_pos){0, NAN}, t->scale), THUD_ERROR_INVALID);
    REFUSED(t, thud_shape_raise(w, stale, 0, t->scale, t->scale), THUD_ERROR_STALE);
}

static void refuse_settings_and_queries(trial *t, yard *y) {
    thud_world *w = y->world;
    thud_quality wrong = *settings_quality(t->set);
    thud_ray_hit out;
    bool hit;
    wrong.substeps = 65;
    REFUSED(t, thud_world_set_gravity(w, (thud_vec2){INFINITY, 0}), THUD_ERROR_INVALID);
    REFUSED(t, thud_world_set_time_step(w, 0), THUD_ERROR_INVALID);
    REFUSED(t, thud_world_set_max_error(w, -1), THUD_ERROR_INVALID);
    REFUSED(t, thud_world_set_quality(w, &wrong), THUD_ERROR_INVALID);
    REFUSED(t, thud_world_advance(w, -1, 1, NULL, NULL), THUD_ERROR_INVALID);
    REFUSED(t, thud_world_cast_ray(w, &(thud_ray){(thud_pos){NAN, 0}, 1, 0, NULL}, &hit, &out),
            THUD_ERROR_INVALID);
}

static void refused_calls_change_nothing(trial *t) {
    yard y;
    yard_make(&y, t, trial_def(t), 0);
    for (int i = 0; i < 20; i++) {
        yard_step(&y);
    }
    if (trial_failed(t)) {
        return;
    }
    t->heard = 0;
    trial_bytes before = trial_snapshot(t, y.world);
    refuse_bodies(t, &y);
    expect_same(t, y.world, &before, "a refused edit of a body");
    refuse_shapes(t, &y);
    expect_same(t, y.world, &before, "a refused edit of a shape");
    refuse_settings_and_queries(t, &y);
    expect_same(t, y.world, &before, "a refused setting or query");
    free(before.bytes);
}

/* Restores snapshots that are truncated, that have a changed byte at any place, or that come from a
 * world with other settings. */
static void damaged_snapshots_are_refused(trial *t) {
    yard y;
    yard_make(&y, t, trial_def(t), 0);
    for (int i = 0; i < 20; i++) {
        yard_step(&y);
    }
    thud_world_def def = trial_def(t);
    def.push_speed = 5;
    thud_world *other = trial_make(t, def);
    if (trial_failed(t)) {
        return;
    }
    trial_bytes s = trial_snapshot(t, y.world), empty = trial_snapshot(t, other);
    yard_step(&y);
    trial_bytes before = trial_snapshot(t, y.world);
    t->heard = 0;
    for (int i = 0; i < 8; i++) {
        size_t at = (size_t)trial_draw(t, 0, (double)s.size);
        s.bytes[at] ^= (char)(1 << trial_pick(t, 8));
        REFUSED(t, thud_world_restore(y.world, s.bytes, s.size), THUD_ERROR_INVALID);
        REFUSED(t, thud_world_restore(y.world, s.bytes, at), THUD_ERROR_INVALID);
        s.bytes[at] = before.bytes[0]; /* keeps the damage, except in every so many rounds */
        expect_same(t, y.world, &before, "a damaged snapshot");
        free(s.bytes);
        s = trial_snapshot(t, y.world);
    }
    REFUSED(t, thud_world_restore(other, s.bytes, s.size), THUD_ERROR_INVALID);
    expect_same(t, other, &empty, "a snapshot of other settings");
    free(s.bytes);
    free(before.bytes);
    free(empty.bytes);
}

/* ---- memory ---- */

/* Reports if the world's events are not those of the last step. */
static void same_events(trial *t, const thud_world *world, const thud_events *before, int step) {
    thud_events e = thud_events_of(world);
    if (e.begin_count != before->begin_count || e.end_count != before->end_count ||
        e.sensor_begin_count != before->sensor_begin_count || e.hit_count != before->hit_count) {
        trial_fault(t, "step %d: events were told without a step", step);
    }
}

/* Each step is tried with its first, second, ... allocation failing, beside a world without
 * failures. A step that fails moves nothing and reports no event; the step that succeeds gives the
 * same result as in the other world. */
static void steps_without_memory_change_nothing(trial *t) {
    thud_world_def def = trial_def(t);
    yard one, other;
    long held = memory_held;
    int failures = 0;
    yard_make_with(&one, t, def, 0, YARD_ALL);
    def.allocator = hostile_memory();
    yard_make_with(&other, t, def, 0, YARD_ALL);
    for (int i = 1; i <= 40 && !trial_failed(t); i++) {
        yard_step(&one);
        yard_before_step(&other);
        thud_result result = THUD_ERROR_MEMORY;
        for (int allowed = 0; result == THUD_ERROR_MEMORY && allowed < 200; allowed++) {
            uint64_t hash = thud_hash_of(other.world);
            thud_events before = thud_events_of(other.world);
            memory_allowed = allowed;
            result = thud_world_step(other.world);
            memory_allowed = -1;
            if (result == THUD_ERROR_MEMORY) {
                failures++;
                if (thud_hash_of(other.world) != hash) {
                    trial_fault(t, "step %d moved something and failed", i);
                }
                same_events(t, other.world, &before, i);
            }
        }
        DO(t, result);
        if (yard_told(&one) != yard_told(&other)) {
            trial_fault(t, "step %d differs", i);
        }
    }
    if (failures == 0) {
        trial_fault(t, "no step ran out of memory");
    }
    thud_world_destroy(other.world);
    t->worlds--;
    if (memory_held != held) {
        trial_fault(t, "%ld blocks of memory were not given back", memory_held - held);
    }
}

const guarantee guarantees_of_refusal[] = {
    GUARANTEE(damaged_snapshots_are_refused),
    GUARANTEE(refused_calls_change_nothing),
    GUARANTEE(steps_without_memory_change_nothing),
    {.name = NULL},
};
