/* test_islands_random.c: random heaps in a closed room, at each quality (the presets from draft to
 * exact) in turn: circles, boxes and bodies of several shapes, with density ratios up to 10^4, with
 * and without restitution, in columns and heaps, a third of them edited while islands merge and
 * split. All bodies stay finite and inside the room, energy does not grow by more than position
 * correction explains, the statistics of a step agree with each other, and the baseline SIMD code
 * gives the same bits as the widest that the processor runs. */
#include "engine_support.h"

#include "geometry_random.h"

#include <thud/thud_testing.h>

#include <inttypes.h>

/* Most bodies of a room, columns and rows of cells in which they begin, and steps of a room. */
enum { BODIES_MAX = 24, COLUMNS_MAX = 6, ROWS = 5, STEPS = 100 };

#define HALF_WIDTH 6.0     /* of the square room, inside, m */
#define WALL_THICKNESS 2.0 /* m */
#define GRAVITY 10.0       /* m/s^2, downwards */

/* Largest gain of energy, as a share of what all bodies would gain from the floor to the ceiling.
 * Position correction lifts the bodies above an overlap. Chosen; not tuned. */
#define ENERGY_GAIN_MAX 0.03

/* Largest difference between the penetration that a step reports and that of thud_measure, m.
 * Chosen; not tuned. */
#define PENETRATION_TOLERANCE 2e-3

/* A random world. */
typedef struct room {
    thud_world *world;
    thud_body_id bodies[BODIES_MAX]; /* the dynamic ones; handles of destroyed bodies are stale */
    int count;                       /* of `bodies` */
    int quality;                     /* the world's present one, as an index of `qualities` */
    source random;                   /* generator of the edits */
    double mass, energy; /* at the start: mass of all dynamic bodies, kg, and their energy, J */
    bool edited;         /* edits are made while it runs */
} room;

/* ---- rooms ---- */

/* One static body with a box for each wall; the boxes overlap at the corners. */
static void add_walls(thud_world *world, const thud_shape_def *def) {
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    for (int side = 0; side < 4; side++) {
        float across = 0.5f * (float)WALL_THICKNESS, along = (float)(HALF_WIDTH + WALL_THICKNESS);
        float out = (side < 2 ? 1 : -1) * ((float)HALF_WIDTH + across);
        thud_vec2 offset = {side % 2 ? out : 0, side % 2 ? 0 : out};
        thud_vec2 half_extents = {side % 2 ? across : along, side % 2 ? along : across};
        OK(thud_shape_create_aabb(world, body, def, offset, half_extents, NULL));
    }
}

/* Adds random shapes, which all lie within a circle of this radius about the body's origin: a
 * circle, a circle and a turned box, or a box. */
static void add_shapes(source *r, thud_world *world, thud_body_id body, float radius,
                       const thud_shape_def *def) {
    float half = 0.7f * radius; /* of a square whose corners are within the circle */
    switch (draw_below(r, 4)) {
    case 0:
        add_shape(world, body, radius, 0, false, def); /* 0: a circle */
        break;
    case 1:
        OK(thud_shape_create_circle(world, body, def, (thud_vec2){-0.5f * radius, 0}, 0.5f * radius,
                                    NULL));
        OK(thud_shape_create_obb(world, body, def, (thud_vec2){0.4f * radius, 0},
                                 (thud_vec2){0.4f * radius, 0.3f * radius}, 0.3, NULL));
        break;
    default: /* an AABB where the sixth argument is true, else an OBB */
        add_shape(world, body, half, half * (float)draw(r, 0.5, 1), draw_below(r, 2), def);
    }
}

/* Makes the room of a seed. Each body begins in a cell of its own, so that nothing overlaps. */
static void make_room(room *m, uint64_t seed, int quality, bool baseline_simd) {
    source r = {seed};
    thud_world_def def = thud_default_world_def();
    thud_shape_def surface = thud_default_shape_def();
    int columns = 1 + draw_below(&r, COLUMNS_MAX);
    double cell = 2 * HALF_WIDTH / COLUMNS_MAX;
    double density_ratio_max = exp(draw(&r, 0, log(1e4)));
    *m = (room){.quality = quality,
                .random = {seed ^ 0x5555}, /* other numbers than those of the bodies */
                .edited = draw_below(&r, 3) == 0};
    def.quality = qualities[quality];
    thud_world_def_set_baseline_simd(&def, baseline_simd);
    def.sleeping = draw_below(&r, 2);
    def.gravity = (thud_vec2){0, (float)-GRAVITY};
    def.time_step = draw_below(&r, 2) ? 1.0 / 60 : 1.0 / draw(&r, 30, 240);
    surface.friction = draw_below(&r, 3) ? (float)draw(&r, 0, 1) : 0.0f;
    surface.restitution = draw_below(&r, 3) ? 0.0f : (float)draw(&r, 0, 0.8);
    m->world = make_world(def);
    add_walls(m->world, &surface);
    m->count = 2 + draw_below(&r, BODIES_MAX - 1);
    m->count = m->count < columns * ROWS ? m->count : columns * ROWS;
    for (int i = 0; i < m->count; i++) {
        double x = cell * (i % columns + 0.5) - HALF_WIDTH;
        double y = cell * (i / columns + 0.5) - HALF_WIDTH;
        float radius = (float)(cell * (draw_below(&r, 2) ? 0.49 : draw(&r, 0.1, 0.49)));
        surface.density = (float)exp(draw(&r, 0, log(density_ratio_max)));
        m->bodies[i] = add_body(m->world, THUD_BODY_DYNAMIC, x, y, 0);
        add_shapes(&r, m->world, m->bodies[i], radius, &surface);
        m->mass += (double)state_of(m->world, m->bodies[i]).mass;
    }
    thud_measure start = thud_measure_of(m->world);
    m->energy = start.kinetic_energy + start.potential_energy;
}

/* In an edited room, before every eighth step: destroys a random body, wakes it or puts it to
 * sleep, enables or disables it, or changes the world's quality. */
static void edit(room *m, int step) {
    source *r = &m->random;
    thud_body_id body = m->bodies[draw_below(r, m->count)];
    if (!m->edited || step % 8 || !thud_body_is_valid(m->world, body)) {
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
        m->quality = draw_below(r, QUALITIES);
        OK(thud_world_set_quality(m->world, qualities[m->quality]));
    }
}

/* ---- what must hold after every step ---- */

static void check_bodies(const room *m, uint64_t seed, int step) {
    /* No body became non-finite and was stopped by the engine. */
    assert_int_equal(thud_events_of(m->world).quarantined_count, 0);
    for (int i = 0; i < m->count; i++) {
        if (!thud_body_is_valid(m->world, m->bodies[i])) {
            continue;
        }
        thud_body_state s = state_of(m->world, m->bodies[i]);
        assert_true(isfinite((double)(s.velocity.x + s.velocity.y + s.angular_velocity)));
        /* A body may be pressed into a wall, but its centre must not pass the wall's middle. */
        double max = HALF_WIDTH + 0.5 * WALL_THICKNESS;
        if (!(fabs(s.center.x) <= max && fabs(s.center.y) <= max)) {
            fail_msg("room %016" PRIx64 " at %s, step %d: body %d is outside at %g, %g", seed,
                     qualities[m->quality]->name, step, i, s.center.x, s.center.y);
        }
    }
}

/* Kinetic and potential energy exceed those of the start by no more than ENERGY_GAIN_MAX. Edits
 * change energy, so that edited rooms are left out. */
static void check_energy(const room *m, uint64_t seed, int step) {
    thud_measure now = thud_measure_of(m->world);
    double gained = now.kinetic_energy + now.potential_energy - m->energy;
    double share = gained / (m->mass * GRAVITY * 2 * HALF_WIDTH);
    if (!m->edited && !(share <= ENERGY_GAIN_MAX)) {
        fail_msg("room %016" PRIx64 " at %s, step %d: energy gained, %% of m g height: %g", seed,
                 qualities[m->quality]->name, step, 100 * share);
    }
}

/* The counters of a step agree with each other, and its penetration with that of thud_measure.
 *
 * The step counts the contacts of awake bodies while it solves them; thud_measure goes through all
 * contacts afterwards. So they are compared where every body is awake; and not where detection
 * moved bodies after the solver, since there the same function computes both. */
static void check_statistics(const room *m) {
    thud_stats stats = thud_stats_of(m->world);
    /* Islands that were tried directly include those that kept the soft solver's result. */
    assert_in_range(stats.soft_islands, 0, stats.direct_islands);
    assert_in_range(stats.direct_bodies, stats.direct_islands, m->count);
    /* A factorisation costs at least one operation on 3 x 3 blocks. */
    assert_true(stats.island_work >= stats.factorings);
    if (stats.direct_islands == 0) {
        assert_int_equal(stats.factorings, 0);
    }
    bool all_awake = stats.awake_bodies == stats.bodies - 1; /* all but the body of the walls */
    if (all_awake && stats.held_bodies == 0 && stats.impacts == 0) {
        near_to(thud_step_error_of(m->world).penetration_max,
                thud_measure_of(m->world).penetration_max, PENETRATION_TOLERANCE);
    }
}

static void random_heaps_stay_inside_gain_no_energy_and_match_baseline_simd(void **state) {
    (void)state;
    int direct_islands = 0;
    for (int k = 0; k < case_count(600); k++) {
        uint64_t seed = 0x9e3779b97f4a7c15ull * (uint64_t)(k + 1);
        room widest, baseline;
        make_room(&widest, seed, k % QUALITIES, false);
        make_room(&baseline, seed, k % QUALITIES, true);
        for (int step = 0; step < STEPS; step++) {
            edit(&widest, step);
            edit(&baseline, step);
            run(widest.world, 1);
            run(baseline.world, 1);
            check_bodies(&widest, seed, step);
            check_energy(&widest, seed, step);
            check_statistics(&widest);
            direct_islands += thud_stats_of(widest.world).direct_islands;
            if (thud_hash_of(widest.world) != thud_hash_of(baseline.world)) {
                fail_msg("room %016" PRIx64 " differs between SIMD levels at step %d", seed, step);
            }
        }
        thud_world_destroy(widest.world);
        thud_world_destroy(baseline.world);
    }
    assert_true(direct_islands > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_heaps_stay_inside_gain_no_energy_and_match_baseline_simd),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
