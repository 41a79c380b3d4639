/* test_float_mode.c: results have the same bits in whichever floating-point mode (rounding,
 * denormals) the calling thread is, and the thread has its own mode afterwards. On a processor
 * without such a mode only the calls are made. */
#include "joint_support.h"

#include <thud/thud_mover.h>
#include <thud/thud_packed.h>
#include <thud/thud_snapshot.h>

#include "build_thud.h"
#include "some_threads.h"
#include "scenes.h"
#include "share.h"
#include "base/simd.h"

#if !defined(TD_FLOAT_MODE_OWN)
typedef unsigned td_float_mode;
#define TD_FLOAT_MODE_OWN 0u
#define TD_FLOAT_MODE_FLAGS 0u
#define TD_FLOAT_MODE_GET(mode) ((void)0)
#define TD_FLOAT_MODE_SET(mode) ((void)0)
#endif

static const struct {
    const char *name;
    td_float_mode mode;
} MODES[] = {
    {"the usual one", TD_FLOAT_MODE_OWN},
#if defined(__SSE2__)
    {"denormals flushed", 0x1f80u | 0x8040u},
    {"rounding down", 0x1f80u | 0x2000u},
    {"rounding up", 0x1f80u | 0x4000u},
    {"rounding to zero, denormals flushed", 0x1f80u | 0x6000u | 0x8040u},
    {"trapping everything but inexact results", 0x1000u},
#elif defined(__aarch64__)
    {"denormals flushed", 1u << 24},
    {"rounding up", 1u << 22},
    {"rounding down", 2u << 22},
    {"rounding to zero, denormals flushed", 3u << 22 | 1u << 24},
#endif
};
enum { MODE_COUNT = sizeof MODES / sizeof *MODES };

static void set_mode(td_float_mode mode) {
    (void)mode;
    TD_FLOAT_MODE_SET(mode);
}

static td_float_mode mode_now(void) {
    td_float_mode mode = TD_FLOAT_MODE_OWN;
    TD_FLOAT_MODE_GET(mode);
    return mode & ~(td_float_mode)TD_FLOAT_MODE_FLAGS;
}

static td_float_mode callers; /* the mode of the calling thread, in the current run */

/* Makes the call in the caller's mode and evaluates everything around it in the usual one, so that
 * arguments do not depend on the mode. */
#define IN_MODE(call)                       \
    do {                                    \
        set_mode(callers);                  \
        thud_result result_ = (call);       \
        td_float_mode after_ = mode_now();  \
        set_mode(TD_FLOAT_MODE_OWN);        \
        assert_int_equal(result_, THUD_OK); \
        assert_true(after_ == callers);     \
    } while (0)

/* ---- steps ---- */

/* Hash of a scene after some steps, each in the caller's mode. */
static uint64_t hash_of(const char *name, int size, int steps, const thud_world_def *def) {
    scene s;
    thud_world *world;
    assert_true(scenes_fill(scenes_find(name), size, &s));
    OK(scene_build_thud(&s, def, &world, NULL, NULL));
    for (int i = 0; i < steps; i++) {
        IN_MODE(thud_world_step(world));
    }
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    scene_free(&s);
    return hash;
}

static void scenes_end_with_the_same_bits_in_any_mode(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i += TEST_SHARE) {
        const scene_info *info = scenes_at(i);
        int size = info->default_size > 300 ? 300 : info->default_size;
        uint64_t hash[MODE_COUNT];
        for (int m = 0; m < MODE_COUNT; m++) {
            callers = MODES[m].mode;
            hash[m] = hash_of(info->name, size, 120, NULL);
            if (hash[m] != hash[0]) {
                fail_msg("%s: another hash where the caller has %s", info->name, MODES[m].name);
            }
        }
    }
}

static void qualities_end_with_the_same_bits_in_any_mode(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world_def def = thud_default_world_def_of(qualities[q]);
        uint64_t hash[MODE_COUNT];
        for (int m = 0; m < MODE_COUNT; m++) {
            callers = MODES[m].mode;
            hash[m] =
                hash_of("heavy_on_light", 6, 90, &def) ^ hash_of("mixed_terrain", 80, 90, &def);
            if (hash[m] != hash[0]) {
                fail_msg("%s: differs where the caller has %s", qualities[q]->name, MODES[m].name);
            }
        }
    }
}

/* A thread begins in the mode of the thread that created it. */
static void workers_in_any_mode_give_the_same_bits(void **state) {
    (void)state;
    uint64_t hash[MODE_COUNT];
    for (int m = 0; m < MODE_COUNT; m++) {
        callers = MODES[m].mode;
        set_mode(callers);
        thud_threads *p = some_threads(3);
        set_mode(TD_FLOAT_MODE_OWN);
        assert_non_null(p);
        thud_world_def def = thud_default_world_def();
        def.job_system = jobs_of_small_steps(p);
        hash[m] = hash_of("platformer", 1000, 80, &def);
        thud_threads_destroy(p);
        assert_true(hash[m] == hash[0]);
    }
}

/* ---- every call that changes a world's state ---- */

/* A world, and the hash of all that its calls returned. */
typedef struct deeds {
    thud_world *world;
    thud_mover mover;
    uint64_t seen; /* hash of what the calls returned */
} deeds;

/* Adds a result to the hash. */
static void see(deeds *d, const void *bytes, size_t size) {
    for (size_t i = 0; i < size; i++) {
        d->seen = (d->seen ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3ull;
    }
}

static void make_ground(deeds *d) {
    thud_body_def def = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id ground;
    thud_shape_id line;
    def.position = (thud_pos){0.1, -0.3};
    thud_pos points[40];
    for (int i = 0; i < 40; i++) {
        points[i] = (thud_pos){-20 + i * 1.03, 0.37 * (i % 4)};
    }
    thud_terrain hills = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 40};
    IN_MODE(thud_body_create(d->world, &def, &ground));
    IN_MODE(thud_shape_create_terrain(d->world, ground, &shape, &hills, &line));
    IN_MODE(thud_shape_dig(d->world, line, (thud_pos){3.3, 0.1}, 1.7));
    IN_MODE(thud_shape_raise(d->world, line, -7.1, 2.3, 0.77));
    thud_terrain made;
    OK(thud_shape_get_terrain(d->world, line, &made));
    see(d, made.points, (size_t)made.count * sizeof *made.points);
}

static void make_bodies(deeds *d) {
    thud_shape_def shape = thud_default_shape_def();
    shape.density = 0.7f;
    for (int i = 0; i < 30; i++) {
        thud_body_def def = thud_default_body_def();
        thud_body_id body;
        def.kind = THUD_BODY_DYNAMIC;
        def.position = (thud_pos){-12.3 + 0.81 * i, 4.1 + 0.3 * (i % 5)};
        def.angle = i % 3 ? 0.123 * i : 0.0;
        def.velocity = (thud_vec2){1e-39f, 0.1f * (float)i};
        IN_MODE(thud_body_create(d->world, &def, &body));
        thud_vec2 off = {0.1f, 0.03f * (float)i}, half = {0.31f, 0.17f};
        volatile double turn = 0.7 * i, far = 0.37 * i;
        if (i % 3 == 0) {
            IN_MODE(thud_shape_create_aabb(d->world, body, &shape, off, half, NULL));
        } else {
            IN_MODE(thud_shape_create_obb(d->world, body, &shape, off, half, turn, NULL));
        }
        IN_MODE(
            thud_shape_create_circle(d->world, body, &shape, (thud_vec2){0.2f, 0.1f}, 0.23f, NULL));
        IN_MODE(thud_body_apply_impulse(d->world, body, (thud_vec2){0.1f, 1e-39f}, def.position));
        IN_MODE(thud_body_apply_center_force(d->world, body, (thud_vec2){0.3f, 0.7f}));
        IN_MODE(thud_body_apply_torque(d->world, body, 0.11f));
        if (i % 5 == 0) {
            IN_MODE(
                thud_body_set_transform(d->world, body, (thud_pos){far, 9.1}, i % 3 ? 0.77 : 0));
            IN_MODE(thud_body_set_velocity(d->world, body, (thud_vec2){0.3f, 1e-40f}, 1e-39f));
        }
    }
}

/* Makes each kind of query, in the caller's mode. */
static void ask(deeds *d, int step) {
    bool hit;
    /* volatile, since the compiler may otherwise compute the product after the mode is set */
    volatile double up = 0.1 * step;
    thud_ray_hit ray = {0};
    thud_closest_hit closest = {0};
    IN_MODE(thud_world_cast_ray(d->world, &(thud_ray){(thud_pos){-15.3, 0.9}, 29.7, up, NULL}, &hit,
                                &ray));
    see(d, &ray.fraction, sizeof ray.fraction);
    IN_MODE(
        thud_world_cast_shape(d->world,
                              &(thud_shape_cast){(thud_pos){-9.7, 8},
                                                 thud_obb_at(0, 0, 0.3, 0.7, 0.3), 7.1, -9.3, NULL},
                              &hit, &ray));
    see(d, &ray.fraction, sizeof ray.fraction);
    IN_MODE(thud_world_closest(d->world, (thud_pos){1.3, 7.7}, 30, NULL, &hit, &closest));
    see(d, &closest.distance, sizeof closest.distance);
    thud_mover_report report;
    IN_MODE(thud_mover_move(d->world, &d->mover, (thud_vec2){2.1f, -3.3f}, 1.0 / 60, &report));
    see(d, &d->mover.shape.x, 2 * sizeof d->mover.shape.x);
    set_mode(callers);
    int count;
    const thud_pose *poses = thud_poses_of(d->world, (thud_pos){0.1, 0.3}, 0.3, &count);
    thud_measure measure = thud_measure_of(d->world);
    set_mode(TD_FLOAT_MODE_OWN);
    see(d, poses + 1, (size_t)(count - 1) * sizeof *poses);
    see(d, &measure, sizeof measure);
}

/* Makes every call that changes a world, in the caller's mode; returns the hash of all results and
 * of the world. */
static uint64_t do_all(const thud_quality *quality) {
    thud_world_def def = thud_default_world_def();
    def.length_scale = 0.7f;
    deeds d = {.seen = 1};
    d.mover = thud_default_mover(
        (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = -6.2, .y = 5.3, .c = 1, .hx = 0.4});
    IN_MODE(thud_world_create(&def, &d.world));
    IN_MODE(thud_world_set_quality(d.world, quality));
    make_ground(&d);
    make_bodies(&d);
    for (int i = 0; i < 60; i++) {
        int steps;
        double alpha;
        ask(&d, i);
        IN_MODE(thud_world_advance(d.world, 0.0171, 3, &steps, &alpha));
        see(&d, &alpha, sizeof alpha);
    }
    uint64_t hash = thud_hash_of(d.world);
    see(&d, &hash, sizeof hash);
    thud_world_destroy(d.world);
    return d.seen;
}

static void every_call_does_the_same_in_any_mode(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        uint64_t seen[MODE_COUNT];
        for (int m = 0; m < MODE_COUNT; m++) {
            callers = MODES[m].mode;
            seen[m] = do_all(qualities[q]);
            if (seen[m] != seen[0]) {
                fail_msg("%s: differs where the caller has %s", qualities[q]->name, MODES[m].name);
            }
        }
    }
}

/* ---- joints ---- */

/* A body with half extents 0.3, joined to the wall by `kind` with an anchor at (x, 0) of it. */
static thud_joint_id join(deeds *d, thud_body_id wall, thud_joint_kind kind, float x) {
    thud_body_id body = add_box(d->world, (double)x, 1, 0.3f, 1);
    return make(d->world, between(kind, wall, body, (thud_vec2){x, 0}, (thud_vec2){0.1f, 0.7f}));
}

/* Makes every call that changes or reads a joint, in the caller's mode. */
static uint64_t do_joints(void) {
    deeds d = {.world = world_at(&thud_quality_default), .seen = 1};
    thud_body_id wall = add_body(d.world, THUD_BODY_STATIC, 0, 0, 0);
    thud_joint_id axle[2], weld = join(&d, wall, THUD_JOINT_WELD, 7.3f);
    thud_joint_def def = thud_default_joint_def(THUD_JOINT_GEAR);
    for (int i = 0; i < 2; i++) {
        axle[i] = def.gear[i] = join(&d, wall, THUD_JOINT_HINGE, 2.1f * (float)i);
    }
    def.ratio = 0.37f;
    thud_joint_id gear = make(d.world, def);
    for (int i = 0; i < 40; i++) {
        thud_step_error error;
        thud_joint_frame frame = {{7.3f, 0.01f * (float)i}, 0.013 * i};
        IN_MODE(thud_joint_set_frame(d.world, weld, 0, frame));
        IN_MODE(thud_joint_set_enabled(d.world, gear, i % 3 == 0));
        IN_MODE(thud_joint_get_def(d.world, weld, &def));
        see(&d, &def.frame_a, sizeof def.frame_a);
        OK(thud_world_step(d.world));
        IN_MODE(thud_world_get_step_error(d.world, &error));
        see(&d, &error.joint_gap_mean, sizeof error.joint_gap_mean);
    }
    IN_MODE(thud_joint_set_length(d.world, join(&d, wall, THUD_JOINT_DISTANCE, 1), 0.7f));
    IN_MODE(thud_joint_set_drive(d.world, axle[1], THUD_DIRECTION_TURN,
                                 &(thud_drive){.motor_speed = 0.3f, .motor_force = 1}));
    OK(thud_world_step(d.world));
    uint64_t hash = thud_hash_of(d.world);
    see(&d, &hash, sizeof hash);
    thud_world_destroy(d.world);
    return d.seen;
}

static void joints_are_set_and_read_the_same_in_any_mode(void **state) {
    (void)state;
    uint64_t seen[MODE_COUNT];
    for (int m = 0; m < MODE_COUNT; m++) {
        callers = MODES[m].mode;
        seen[m] = do_joints();
        if (seen[m] != seen[0]) {
            fail_msg("joints differ where the caller has %s", MODES[m].name);
        }
    }
}

/* ---- packed snapshots ---- */

enum { PACKED_MAX = 1 << 20 };

/* What was packed in one mode is unpacked in another. */
static void packed_snapshots_are_the_same_bytes_in_any_mode(void **state) {
    (void)state;
    static char base[PACKED_MAX], now[PACKED_MAX], packed[2][PACKED_MAX], unpacked[PACKED_MAX];
    size_t base_bytes, bytes, packed_bytes[2], unpacked_bytes;
    scene s;
    thud_world *world;
    assert_true(scenes_fill(scenes_find("platformer"), 200, &s));
    OK(scene_build_thud(&s, NULL, &world, NULL, NULL));
    run(world, 30);
    OK(thud_world_snapshot(world, base, sizeof base, &base_bytes));
    run(world, 1);
    OK(thud_world_snapshot(world, now, sizeof now, &bytes));
    thud_bytes from = {base, base_bytes}, to = {now, bytes};
    OK(thud_world_pack(world, from, to, packed[0], PACKED_MAX, &packed_bytes[0]));
    for (int m = 0; m < MODE_COUNT; m++) {
        callers = MODES[m].mode;
        IN_MODE(thud_world_pack(world, from, to, packed[1], PACKED_MAX, &packed_bytes[1]));
        assert_int_equal(packed_bytes[1], packed_bytes[0]);
        assert_memory_equal(packed[1], packed[0], packed_bytes[0]);
        IN_MODE(thud_world_unpack(world, from, (thud_bytes){packed[0], packed_bytes[0]}, unpacked,
                                  PACKED_MAX, &unpacked_bytes));
        assert_int_equal(unpacked_bytes, bytes);
        assert_memory_equal(unpacked, now, bytes);
    }
    thud_world_destroy(world);
    scene_free(&s);
}

/* ---- callbacks ---- */

/* A prologue: *context is whether it is called in the world's own mode. */
static bool prologue_notes_mode(thud_world *world, const thud_contact *contact,
                                thud_contact_settings *settings, void *context) {
    (void)world;
    (void)contact;
    (void)settings;
    *(bool *)context = mode_now() == TD_FLOAT_MODE_OWN;
    return true;
}

static void callbacks_are_called_in_the_worlds_own_mode(void **state) {
    (void)state;
    bool own = false;
    thud_world_def def = thud_default_world_def();
    thud_world *world = make_world(def);
    set_listeners(world, prologue_notes_mode, NULL, &own);
    add_floor(world, NULL);
    add_ball(world, 0, 0.5, 0.5f);
    callers = MODES[MODE_COUNT > 1].mode;
    IN_MODE(thud_world_step(world));
    assert_true(own);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_end_with_the_same_bits_in_any_mode),
        cmocka_unit_test(qualities_end_with_the_same_bits_in_any_mode),
        cmocka_unit_test(workers_in_any_mode_give_the_same_bits),
        cmocka_unit_test(every_call_does_the_same_in_any_mode),
        cmocka_unit_test(joints_are_set_and_read_the_same_in_any_mode),
        cmocka_unit_test(packed_snapshots_are_the_same_bytes_in_any_mode),
        cmocka_unit_test(callbacks_are_called_in_the_worlds_own_mode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
