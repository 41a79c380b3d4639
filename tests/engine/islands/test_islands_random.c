/* test_islands_random.c: random heaps in a closed room at all qualities in turn: circles, boxes and
 * bodies of several shapes, with density ratios up to 10^4, with and without restitution, in
 * columns and heaps, edited while islands merge and split. Everything stays finite and inside the
 * room, no energy is gained, the statistics of a step are right, and baseline SIMD gives the same
 * bits. */
#include "engine_support.h"

#include "geometry_random.h"

#include <thud/thud_testing.h>

#include <inttypes.h>

/* Bodies of a room at most, and steps of each room. */
enum { BODIES_MOST = 24, STEPS = 100 };

#define ROOM 6.0 /* half its width; its walls are 2 thick */
#define GRAVITY 10.0

/* A random world; its mass, and its energy at the start. */
typedef struct room {
    thud_world *world;
    thud_body_id bodies[BODIES_MOST];
    int count, quality;
    source random; /* generator of the edits */
    double mass, energy;
    bool edits;
} room;

/* ---- rooms ---- */

static void add_walls(thud_world *world, const thud_shape_def *def) {
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    for (int side = 0; side < 4; side++) {
        float out = (side < 2 ? 1 : -1) * (float)(ROOM + 1), half = (float)ROOM + 2;
        thud_vec2 offset = {side % 2 ? out : 0, side % 2 ? 0 : out};
        thud_vec2 size = {side % 2 ? 1 : half, side % 2 ? half : 1};
        OK(thud_shape_create_aabb(world, body, def, offset, size, NULL));
    }
}

/* Within a circle of the given radius. */
static void add_shapes(source *r, thud_world *world, thud_body_id body, float radius,
                       const thud_shape_def *def) {
    float half = 0.7f * radius;
    switch (draw_below(r, 4)) {
    case 0:
        add_shape(world, body, radius, 0, false, def);
        break;
    case 1:
        OK(thud_shape_create_circle(world, body, def, (thud_vec2){-0.5f * radius, 0}, 0.5f * radius,
                                    NULL));
        OK(thud_shape_create_obb(world, body, def, (thud_vec2){0.4f * radius, 0},
                                 (thud_vec2){0.4f * radius, 0.3f * radius}, 0.3, NULL));
        break;
    default:
        add_shape(world, body, half, half * (float)draw(r, 0.5, 1), draw_below(r, 2), def);
    }
}

/* Each body begins in a cell of its own, so nothing overlaps. */
static void make_room(room *m, uint64_t seed, int quality, bool plain_simd) {
    source r = {seed};
    thud_world_def def = thud_default_world_def();
    thud_shape_def surface = thud_default_shape_def();
    int columns = 1 + draw_below(&r, 6), rows = 5;
    double cell = 2 * ROOM / 6;
    double unevenness = exp(draw(&r, 0, log(1e4)));
    *m = (room){.quality = quality, .random = {seed ^ 0x5555}, .edits = draw_below(&r, 3) == 0};
    def.quality = qualities[quality];
    thud_world_def_set_baseline_simd(&def, plain_simd);
    def.sleeping = draw_below(&r, 2);
    def.gravity = (thud_vec2){0, (float)-GRAVITY};
    def.time_step = draw_below(&r, 2) ? 1.0 / 60 : 1.0 / draw(&r, 30, 240);
    surface.friction = draw_below(&r, 3) ? (float)draw(&r, 0, 1) : 0.0f;
    surface.restitution = draw_below(&r, 3) ? 0.0f : (float)draw(&r, 0, 0.8);
    m->world = make_world(def);
    add_walls(m->world, &surface);
    m->count = 2 + draw_below(&r, BODIES_MOST - 1);
    m->count = m->count < columns * rows ? m->count : columns * rows;
    for (int i = 0; i < m->count; i++) {
        double x = cell * (i % columns + 0.5) - ROOM, y = cell * (i / columns + 0.5) - ROOM;
        float radius = (float)(cell * (draw_below(&r, 2) ? 0.49 : draw(&r, 0.1, 0.49)));
        surface.density = (float)exp(draw(&r, 0, log(unevenness)));
        m->bodies[i] = add_body(m->world, THUD_BODY_DYNAMIC, x, y, 0);
        add_shapes(&r, m->world, m->bodies[i], radius, &surface);
        m->mass += (double)state_of(m->world, m->bodies[i]).mass;
    }
    thud_measure start = thud_measure_of(m->world);
    m->energy = start.kinetic_energy + start.potential_energy;
}

/* Destroys, disables and enables bodies, and changes the quality. */
static void edit(room *m, int step) {
    source *r = &m->random;
    thud_body_id body = m->bodies[draw_below(r, m->count)];
    if (!m->edits || step % 8 || !thud_body_is_valid(m->world, body)) {
        return;
    }
    switch (draw_below(r, 4)) {
    case 0:
        OK(thud_body_destroy(m->world, body));
        break;
    case 1:
        OK(thud_body_set_awake(m->world, body, draw_below(r, 2)));
        break;
    case 2:
        OK(thud_body_set_enabled(m->world, body, !state_of(m->world, body).enabled));
        break;
    default:
        OK(thud_world_set_quality(m->world, qualities[draw_below(r, QUALITIES)]));
    }
}

/* ---- what must hold after every step ---- */

static void check_bodies(const room *m, uint64_t seed, int step) {
    assert_int_equal(thud_events_of(m->world).quarantined_count, 0);
    for (int i = 0; i < m->count; i++) {
        if (!thud_body_is_valid(m->world, m->bodies[i])) {
            continue;
        }
        thud_body_state s = state_of(m->world, m->bodies[i]);
        assert_true(isfinite((double)(s.velocity.x + s.velocity.y + s.angular_velocity)));
        /* A body that is pressed against a wall may overlap it, but not by half of its
         * thickness. */
        if (!(fabs(s.center.x) <= ROOM + 1 && fabs(s.center.y) <= ROOM + 1)) {
            fail_msg("room %016" PRIx64 " at %s, step %d: body %d is out at %g, %g", seed,
                     qualities[m->quality]->name, step, i, s.center.x, s.center.y);
        }
    }
}

/* Separating overlaps lifts the bodies above: 3 % of the greatest potential energy of the room is
 * allowed. */
static void check_energy(const room *m, uint64_t seed, int step) {
    thud_measure now = thud_measure_of(m->world);
    double gained = now.kinetic_energy + now.potential_energy - m->energy;
    double share = gained / (m->mass * GRAVITY * 2 * ROOM);
    if (!m->edits && !(share <= 0.03)) {
        fail_msg("room %016" PRIx64 " at %s, step %d: energy gained, %% of what there could be: %g",
                 seed, qualities[m->quality]->name, step, 100 * share);
    }
}

/* The error of a step covers awake bodies alone, and detection may change motions after it is
 * measured: it is compared where all are awake and none was stopped. */
static void check_telling(const room *m) {
    thud_stats stats = thud_stats_of(m->world);
    assert_in_range(stats.soft_islands, 0, stats.direct_islands);
    assert_in_range(stats.direct_bodies, stats.direct_islands, m->count);
    assert_true(stats.island_work >= stats.factorings);
    if (stats.direct_islands == 0) {
        assert_int_equal(stats.factorings, 0);
    }
    bool all_awake = stats.awake_bodies == stats.bodies - 1; /* all but the body of the walls */
    if (all_awake && stats.held_bodies == 0 && stats.impacts == 0) {
        near_to(thud_step_error_of(m->world).penetration_max,
                thud_measure_of(m->world).penetration_max, 2e-3);
    }
}

static void random_heaps_stay_inside_gain_nothing_and_run_alike(void **state) {
    (void)state;
    int hard = 0;
    for (int k = 0; k < case_count(600); k++) {
        uint64_t seed = 0x9e3779b97f4a7c15ull * (uint64_t)(k + 1);
        room wide, plain;
        make_room(&wide, seed, k % QUALITIES, false);
        make_room(&plain, seed, k % QUALITIES, true);
        for (int step = 0; step < STEPS; step++) {
            edit(&wide, step);
            edit(&plain, step);
            run(wide.world, 1);
            run(plain.world, 1);
            check_bodies(&wide, seed, step);
            check_energy(&wide, seed, step);
            check_telling(&wide);
            hard += thud_stats_of(wide.world).direct_islands;
            if (thud_hash_of(wide.world) != thud_hash_of(plain.world)) {
                fail_msg("room %016" PRIx64 " differs at step %d", seed, step);
            }
        }
        thud_world_destroy(wide.world);
        thud_world_destroy(plain.world);
    }
    assert_true(hard > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_heaps_stay_inside_gain_nothing_and_run_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
