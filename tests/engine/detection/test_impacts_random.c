/* test_impacts_random.c: random worlds of bisected and swept bodies in a closed room: all sizes and
 * speeds, several shapes, sensors, filters, kinematic bodies, and edits by callbacks. They stay
 * finite, run twice with the same bits (with wide and baseline SIMD, and with failing allocations),
 * keep to the bounds of work, and no swept body leaves the room. */
#include "hostile_memory.h"
#include "engine_support.h"

#include "geometry_random.h"

#include <thud/thud_testing.h>

#include <inttypes.h>

enum { BODIES = 14, STEPS = 40 };

#define ROOM 8.0 /* half its width; its walls are 2 thick */
#define WALLS 0x80000000u

/* A random world and its settings. */
typedef struct room {
    thud_world *world;
    thud_body_id bodies[BODIES];
    source random; /* generator of the callbacks */
    double time_step;
    bool edits, swept, kinematic;
} room;

/* ---- failing allocations ---- */

/* Whether allocations may fail at present. */
static bool fails;

/* ---- callbacks ---- */

static thud_vec2 draw_velocity(source *r) {
    double speed = exp(draw(r, log(0.1), log(1e5))), angle = draw(r, 0, 6.28);
    return (thud_vec2){(float)(speed * cos(angle)), (float)(speed * sin(angle))};
}

/* Asserts success, or a lack of memory while allocations fail. */
static void done_or_short(thud_result result) {
    assert_true(result == THUD_OK || (result == THUD_ERROR_MEMORY && fails));
}

/* Makes a random edit from inside a callback, now and then. */
static void edit(room *m) {
    source *r = &m->random;
    thud_body_id body = m->bodies[draw_below(r, BODIES)];
    thud_body_state s;
    if (!m->edits || draw_below(r, 20) || thud_body_get_state(m->world, body, &s) != THUD_OK) {
        return;
    }
    thud_pos at = {draw(r, -5, 5), draw(r, -5, 5)};
    switch (draw_below(r, 4)) {
    case 0:
        done_or_short(thud_body_destroy(m->world, body));
        break;
    case 1:
        done_or_short(thud_body_set_transform(m->world, body, at, 0));
        break;
    case 2:
        done_or_short(thud_body_set_enabled(m->world, body, !s.enabled));
        break;
    default:
        if (s.kind == THUD_BODY_DYNAMIC) {
            done_or_short(thud_body_set_velocity(m->world, body, draw_velocity(r), 1));
        }
    }
}

static bool is_wall(const thud_world *world, thud_body_id body) {
    thud_body_state s;
    return thud_body_get_state(world, body, &s) == THUD_OK && s.kind == THUD_BODY_STATIC;
}

/* A contact with a wall is never vetoed. */
static bool prologue(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    room *m = context;
    edit(m);
    settings->restitution = draw_below(&m->random, 2) ? 0.9f : 0.0f;
    return is_wall(world, contact->body_a) || is_wall(world, contact->body_b) ||
           draw_below(&m->random, 8);
}

static void epilogue(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    assert_true(isfinite((double)contact->normal_impulse));
    edit(context);
}

/* ---- rooms ---- */

static void add_walls(thud_world *world) {
    thud_shape_def def = thud_default_shape_def();
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    def.filter.category = WALLS;
    for (int side = 0; side < 4; side++) {
        float out = (side < 2 ? 1 : -1) * (float)(ROOM + 1), half = (float)ROOM + 2;
        thud_vec2 offset = {side % 2 ? out : 0, side % 2 ? 0 : out};
        thud_vec2 size = {side % 2 ? 1 : half, side % 2 ? half : 1};
        OK(thud_shape_create_aabb(world, body, &def, offset, size, NULL));
    }
}

static void add_shapes(source *r, thud_world *world, thud_body_id body) {
    for (int shapes = 1 + (draw_below(r, 3) == 0) * draw_below(r, 3), i = 0; i < shapes; i++) {
        thud_shape_def def = thud_default_shape_def();
        def.sensor = i > 0 && draw_below(r, 3) == 0;
        def.filter.category = 1u << draw_below(r, 3);
        def.filter.mask = WALLS | (uint32_t)draw_below(r, 8);
        def.restitution = draw_below(r, 3) == 0 ? 1.0f : 0.0f;
        thud_vec2 at = {i ? (float)draw(r, -1, 1) : 0, i ? (float)draw(r, -1, 1) : 0};
        thud_vec2 half = {(float)exp(draw(r, log(0.01), log(1.2))),
                          (float)exp(draw(r, log(0.01), log(1.2)))};
        if (draw_below(r, 2)) {
            OK(thud_shape_create_circle(world, body, &def, at, half.x, NULL));
        } else {
            OK(thud_shape_create_obb(world, body, &def, at, half, draw(r, -2, 2), NULL));
        }
    }
}

/* Creates the random world of a seed. */
static void make_room(room *m, uint64_t seed, bool plain_simd) {
    source r = {seed};
    thud_world_def def = thud_default_world_def();
    bool bisects = draw_below(&r, 3) == 0;
    m->time_step = def.time_step = 1.0 / exp(draw(&r, log(15), log(1000)));
    m->edits = draw_below(&r, 2);
    m->kinematic = draw_below(&r, 3) == 0;
    m->swept = !bisects;
    m->random = (source){seed ^ 0x5555};
    def.detection = bisects ? &thud_detection_bisect : &thud_detection_swept;
    thud_world_def_set_baseline_simd(&def, plain_simd);
    def.allocator = hostile_memory();
    m->world = make_world(def);
    set_listeners(m->world, prologue, epilogue, m);
    add_walls(m->world);
    for (int i = 0; i < BODIES; i++) {
        bool moves = !m->kinematic || i > 1;
        thud_body_id body = add_body(m->world, moves ? THUD_BODY_DYNAMIC : THUD_BODY_KINEMATIC,
                                     draw(&r, -5, 5), draw(&r, -5, 5), draw(&r, -3, 3));
        m->bodies[i] = body;
        add_shapes(&r, m->world, body);
        thud_vec2 v = draw_below(&r, 2) ? draw_velocity(&r) : (thud_vec2){0, 0};
        if (!moves) {
            v = (thud_vec2){(float)draw(&r, -5, 5), (float)draw(&r, -5, 5)};
        }
        OK(thud_body_set_velocity(m->world, body, v, (float)draw(&r, -20, 20)));
    }
}

/* ---- what must hold after every step ---- */

/* Asserts the bounds of work, and that bodies are finite and inside the room. */
static void check(const room *m, uint64_t seed, int step) {
    thud_stats stats = thud_stats_of(m->world);
    if (stats.impacts > 9 * BODIES || stats.held_bodies > BODIES ||
        !(stats.held_seconds <= BODIES * m->time_step * 1.000001)) {
        fail_msg("room %016" PRIx64 ", step %d: %d impacts, %d held for %g s", seed, step,
                 stats.impacts, stats.held_bodies, stats.held_seconds);
    }
    assert_int_equal(thud_events_of(m->world).quarantined_count, 0);
    for (int i = 0; i < BODIES; i++) {
        thud_body_state s;
        if (thud_body_get_state(m->world, m->bodies[i], &s) != THUD_OK) {
            continue;
        }
        assert_true(isfinite(s.center.x + s.center.y + s.angle));
        assert_true(isfinite((double)(s.velocity.x + s.velocity.y + s.angular_velocity)));
        /* The first shape is solid, and its centre is the body's origin; the centre of mass may be
         * inside a sensor. Bodies that began inside each other and rotate by many turns a step may
         * be pressed into a wall. */
        bool outside = fabs(s.position.x) > ROOM + 1 || fabs(s.position.y) > ROOM + 1;
        if (m->swept && !m->kinematic && outside) {
            fail_msg("room %016" PRIx64 ", step %d: body %d is out at %g, %g", seed, step, i,
                     s.position.x, s.position.y);
        }
    }
}

/* Every 16th step fails at its first allocation, then at its second, and so on, until it
 * succeeds. */
static void step_with_failures(room *m, int step) {
    for (long failures = 0;; failures++) {
        fails = step % 16 == 3;
        memory_allowed = fails ? failures : -1;
        thud_result result = thud_world_step(m->world);
        memory_allowed = -1;
        fails = false;
        if (result == THUD_OK) {
            return;
        }
        assert_int_equal(result, THUD_ERROR_MEMORY);
    }
}

static void random_rooms_run_alike_within_bounds_and_lose_nothing(void **state) {
    (void)state;
    for (int k = 0; k < case_count(200); k++) {
        uint64_t seed = 0x9e3779b97f4a7c15ull * (uint64_t)(k + 1);
        room wide, plain;
        make_room(&wide, seed, false);
        make_room(&plain, seed, true);
        for (int step = 0; step < STEPS; step++) {
            run(wide.world, 1);
            run(plain.world, 1);
            check(&wide, seed, step);
            if (thud_hash_of(wide.world) != thud_hash_of(plain.world)) {
                fail_msg("room %016" PRIx64 " differs at step %d", seed, step);
            }
        }
        thud_world_destroy(wide.world);
        thud_world_destroy(plain.world);
    }
}

/* A failed step may have been partly done: what callbacks and impacts added is neither lost nor
 * done twice. Impacts in a step with failing allocations may need memory that the step before did
 * not, and then hold their bodies, so that the two worlds may differ; all else holds. */
static void random_rooms_survive_failing_allocations(void **state) {
    (void)state;
    for (int k = 0; k < case_count(60); k++) {
        uint64_t seed = 0xd1342543de82ef95ull * (uint64_t)(k + 1);
        room m;
        make_room(&m, seed, false);
        for (int step = 0; step < STEPS; step++) {
            step_with_failures(&m, step);
            check(&m, seed, step);
        }
        thud_world_destroy(m.world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_rooms_run_alike_within_bounds_and_lose_nothing),
        cmocka_unit_test(random_rooms_survive_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
