/* test_distances.c: rods (distance joints) in the graph of constraints, as the simplest constraint
 * that is not a contact: they are solved by the soft and the direct solver, coloured, put to sleep,
 * disabled, destroyed, drawn and restored as contacts are; and ropes that are reeled in against
 * static shapes yield. */
#include "joint_support.h"

#include "state/world.h"
#include "some_threads.h"
#include "snapshot_support.h"

#include <thud/thud_testing.h>

static thud_joint_def rod_of(thud_body_id a, thud_body_id b, thud_vec2 at_a, thud_vec2 at_b,
                             float length) {
    thud_joint_def def = between(THUD_JOINT_DISTANCE, a, b, at_a, at_b);
    def.length = length;
    def.collide_connected = true;
    return def;
}

static thud_joint_id tie(thud_world *world, thud_body_id a, thud_body_id b, thud_vec2 at_a,
                         thud_vec2 at_b, float length) {
    return make(world, rod_of(a, b, at_a, at_b, length));
}

static double stretch_of(thud_world *world, thud_joint_id rod) {
    return joint_of(world, rod).gap;
}

static const thud_vec2 middle = {0, 0};

/* The greatest gap of any rod in `steps` steps, in metres. */
static double stretch_after(thud_world *world, const thud_joint_id *rods, int count, int steps) {
    double worst = 0;
    for (int i = 0; i < steps; i++) {
        run(world, 1);
        for (int k = 0; k < count; k++) {
            worst = fmax(worst, stretch_of(world, rods[k]));
        }
    }
    return worst;
}

/* ---- solved ---- */

/* A pendulum of length 2 falls from level for 300 steps. Returns the rod's greatest gap; *least is
 * the lowest height of its bob. */
static double swing(const thud_quality *quality, double *least) {
    thud_world *world = world_at(quality);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 10, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 2, 10, 0);
    add_shape(world, bob, 0.2f, 0, false, NULL);
    thud_joint_id rod = tie(world, hook, bob, middle, middle, 2);
    double worst = 0;
    *least = 10;
    for (int i = 0; i < 300; i++) {
        worst = fmax(worst, stretch_after(world, &rod, 1, 1));
        *least = fmin(*least, state_of(world, bob).position.y);
    }
    thud_world_destroy(world);
    return worst;
}

static void pendulum_keeps_its_length_and_passes_its_lowest_place(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        double least, worst = swing(qualities[i], &least);
        assert_true(worst < 0.02); /* 1 % of the length */
        near_to(least, 8, 0.02);
    }
}

/* A chain of 10 links of rods with a weight of about a thousand links at its end: returns the
 * greatest gap in its fifth second. The soft solver lets the rods open, the direct solver does not.
 * *direct is the number of bodies solved directly. */
static double chain(const thud_quality *quality, int *direct) {
    enum { LINKS = 10 };
    thud_world *world = world_at(quality);
    thud_body_id last = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_joint_id rods[LINKS + 1];
    for (int i = 0; i < LINKS; i++) {
        thud_body_id next = add_body(world, THUD_BODY_DYNAMIC, 0, -1.0 - i, 0);
        add_shape(world, next, 0.1f, 0, false, NULL);
        rods[i] = tie(world, last, next, middle, middle, 1);
        last = next;
    }
    thud_shape_def heavy = thud_default_shape_def();
    heavy.density = 1000;
    thud_body_id weight = add_body(world, THUD_BODY_DYNAMIC, 0, -1.0 - LINKS, 0);
    add_shape(world, weight, 0.1f, 0, false, &heavy);
    rods[LINKS] = tie(world, last, weight, middle, middle, 1);
    stretch_after(world, rods, LINKS + 1, 240);
    double worst = stretch_after(world, rods, LINKS + 1, 60);
    *direct = thud_stats_of(world).direct_bodies;
    thud_world_destroy(world);
    return worst;
}

static void chain_with_a_weight_a_thousand_times_heavier_is_held_directly(void **state) {
    (void)state;
    int direct;
    double soft = chain(&thud_quality_draft, &direct);
    assert_int_equal(direct, 0);
    assert_true(soft > 0.05);
    assert_true(chain(&thud_quality_default, &direct) < 1e-4);
    assert_int_equal(direct, 11);
    assert_true(chain(&thud_quality_exact, &direct) < 1e-4);
    assert_int_equal(direct, 11);
}

/* A platform that moves at this velocity, and a bob that hangs from it by a rod of length 0.1 and
 * moves likewise: as the rod does not turn, no quality may move the bob against the platform. */
static void hang_from_a_platform(const thud_quality *quality, float velocity, bool takes_one_part) {
    thud_world *world = world_at(quality);
    thud_body_id platform = add_body(world, THUD_BODY_KINEMATIC, 0, 0, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 0, -0.1, 0);
    add_shape(world, bob, 0.02f, 0, false, NULL);
    tie(world, platform, bob, middle, middle, 0.1f);
    OK(thud_body_set_velocity(world, platform, (thud_vec2){velocity, 0}, 0));
    OK(thud_body_set_velocity(world, bob, (thud_vec2){velocity, 0}, 0));
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        thud_pos at = state_of(world, bob).position;
        near_to(at.x - state_of(world, platform).position.x, 0, 1e-4);
        near_to(at.y, -0.1, 1e-3);
        if (takes_one_part) {
            assert_int_equal(thud_stats_of(world).soft_islands, 0);
            assert_in_range(thud_stats_of(world).factorings, 1, 4);
        }
    }
    thud_world_destroy(world);
}

static void rod_hangs_straight_from_a_platform_that_moves(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        hang_from_a_platform(qualities[q], 1, false);
        hang_from_a_platform(qualities[q], 10, false);
    }
}

static void short_rod_on_a_fast_platform_takes_one_part(void **state) {
    (void)state;
    hang_from_a_platform(&thud_quality_high, 1, true);
    hang_from_a_platform(&thud_quality_high, 100, true);
}

/* A rod that is attached off a body's centre turns the body: its row uses the lever arm. */
static void rod_at_the_end_of_a_plank_turns_it(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, -1, 3, 0);
        thud_body_id plank = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
        add_shape(world, plank, 1, 0.1f, false, NULL);
        thud_joint_id rod = tie(world, plank, hook, (thud_vec2){-1, 0}, middle, 3);
        run(world, 10);
        assert_true(state_of(world, plank).angle < -0.05);
        assert_true(stretch_of(world, rod) < 0.02);
        thud_world_destroy(world);
    }
}

static void rods_and_contacts_share_an_island_in_the_direct_solver(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_exact);
    thud_body_id ids[3];
    add_column(world, 0, 3, ids);
    thud_body_id beside = add_box(world, 3, 0.5, 0.5f, 0.5f);
    thud_joint_id rod = tie(world, ids[0], beside, middle, middle, 3);
    run(world, 120);
    thud_stats stats = thud_stats_of(world);
    assert_int_equal(stats.direct_islands, 1);
    assert_int_equal(stats.direct_bodies, 4);
    assert_true(stretch_of(world, rod) < 1e-5);
    thud_world_destroy(world);
}

/* ---- in the graph of constraints ---- */

enum { ACROSS = 12, UP = 5 };

/* A net of circles tied by rods, held at the two ends of its upper edge, which falls onto boxes. */
static thud_world *net(thud_world_def def) {
    thud_world *world = make_world(def);
    thud_body_id knots[UP][ACROSS];
    add_floor(world, NULL);
    for (int y = 0; y < UP; y++) {
        for (int x = 0; x < ACROSS; x++) {
            bool hangs = y == 0 && (x == 0 || x == ACROSS - 1);
            knots[y][x] =
                add_body(world, hangs ? THUD_BODY_STATIC : THUD_BODY_DYNAMIC, x, 8 - y, 0);
            add_shape(world, knots[y][x], 0.3f, 0, false, NULL);
            if (x > 0) {
                tie(world, knots[y][x], knots[y][x - 1], middle, middle, 1);
            }
            if (y > 0) {
                tie(world, knots[y][x], knots[y - 1][x], middle, middle, 1);
            }
        }
    }
    for (int i = 0; i < 5; i++) {
        add_box(world, 3 + i, 0.5, 0.5f, 0.5f);
    }
    return world;
}

/* The world's hash after that many steps of the net. */
static uint64_t net_after(thud_world_def def, int steps) {
    thud_world *world = net(def);
    run(world, steps);
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    return hash;
}

static void net_ends_in_the_same_bits_with_any_workers_and_width(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i]);
        uint64_t alone = net_after(def, 90);
        thud_world_def_set_baseline_simd(&def, true);
        assert_true(net_after(def, 90) == alone);
        for (int workers = 2; workers <= 4; workers += 2) {
            thud_threads *p = some_threads(workers);
            def.job_system = jobs_of_small_steps(p);
            assert_true(net_after(def, 90) == alone);
            thud_threads_destroy(p);
        }
    }
}

/* The eight lanes of a block are solved at once, so no two of them may share a moving body. */
static void rods_of_one_block_share_no_moving_body(void **state) {
    (void)state;
    thud_world *world = net(thud_default_world_def());
    run(world, 30);
    int rods = 0;
    for (int i = 0; i < world->scratch.blocks.count; i++) {
        const td_block *block = *(td_block **)td_at(&world->scratch.blocks, i);
        for (int lane = 0; lane < block->used; lane++) {
            rods += !td_is_contact(td_constraint_at(world, block->constraint[lane]));
            for (int other = 0; other < lane; other++) {
                const uint32_t own[2] = {block->a[lane], block->b[lane]};
                for (int side = 0; side < 2; side++) {
                    assert_true(own[side] == 0 ||
                                (own[side] != block->a[other] && own[side] != block->b[other]));
                }
            }
        }
    }
    assert_int_equal(rods, UP * (ACROSS - 1) + (UP - 1) * ACROSS);
    thud_world_destroy(world);
}

static bool sleeps(thud_world *world, thud_body_id id) {
    return !state_of(world, id).awake;
}

static void bodies_that_a_rod_ties_fall_asleep_and_wake_together(void **state) {
    (void)state;
    thud_world *world = make_world(def_of(&thud_quality_default));
    add_floor(world, NULL);
    thud_body_id a = add_box(world, -2, 0.5, 0.5f, 0.5f), b = add_box(world, 2, 0.5, 0.5f, 0.5f);
    thud_joint_id rod = tie(world, a, b, middle, middle, 4);
    run(world, 120);
    assert_true(sleeps(world, a) && sleeps(world, b));
    OK(thud_body_set_velocity(world, a, (thud_vec2){-3, 0}, 0));
    run(world, 2);
    assert_true(!sleeps(world, a) && !sleeps(world, b));
    run(world, 20);
    assert_true(state_of(world, b).position.x < 1.9);
    assert_true(stretch_of(world, rod) < 0.02);
    thud_world_destroy(world);
}

/* A rod does not act while one of its bodies is disabled. */
static void rod_to_a_disabled_body_lets_go_until_it_is_enabled(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id hook = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 0, -1, 0);
    thud_body_id nail = add_body(world, THUD_BODY_STATIC, 0, 1, 0);
    add_shape(world, hook, 0.1f, 0, false, NULL);
    add_shape(world, bob, 0.1f, 0, false, NULL);
    tie(world, nail, hook, middle, middle, 1);
    thud_joint_id rod = tie(world, hook, bob, middle, middle, 1);
    run(world, 30);
    near_to(state_of(world, bob).position.y, -1, 0.02);
    OK(thud_body_set_enabled(world, hook, false));
    run(world, 6);
    assert_true(state_of(world, bob).position.y < -1.03);
    OK(thud_body_set_enabled(world, hook, true));
    run(world, 120);
    assert_true(stretch_of(world, rod) < 0.02);
    near_to(state_of(world, hook).position.y, 0, 0.05);
    thud_world_destroy(world);
}

static void body_that_is_destroyed_takes_its_rods_away(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 0, -1, 0);
    add_shape(world, bob, 0.1f, 0, false, NULL);
    thud_joint_id rod = tie(world, hook, bob, middle, middle, 1);
    run(world, 10);
    OK(thud_body_destroy(world, hook));
    run(world, 30);
    assert_true(state_of(world, bob).position.y < -2);
    assert_int_equal(thud_joint_destroy(world, rod), THUD_ERROR_STALE);
    assert_int_equal(world->joints.live, 0);
    thud_world_destroy(world);
}

/* Destroying a rod wakes the body that hung on it. */
static void rod_that_is_destroyed_lets_go_of_sleepers(void **state) {
    (void)state;
    thud_world *world = make_world(def_of(&thud_quality_default));
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 0, -1, 0);
    add_shape(world, bob, 0.1f, 0, false, NULL);
    thud_joint_id rod = tie(world, hook, bob, middle, middle, 1);
    run(world, 120);
    assert_true(sleeps(world, bob));
    OK(thud_joint_destroy(world, rod));
    run(world, 30);
    assert_true(state_of(world, bob).position.y < -2);
    thud_world_destroy(world);
}

/* ---- snapshots, drawing, errors, wrong input ---- */

static void restored_net_goes_on_to_the_same_bits(void **state) {
    (void)state;
    thud_world *world = net(thud_default_world_def());
    run(world, 60);
    saved then = save(world);
    run(world, 60);
    uint64_t first = digest_of(world);
    back_to(world, then);
    run(world, 60);
    assert_true(digest_of(world) == first);
    thud_world *other = net(thud_default_world_def());
    back_to(other, then);
    run(other, 60);
    assert_true(digest_of(other) == first);
    thud_world *without = make_world(thud_default_world_def());
    assert_int_equal(thud_world_restore(without, then.bytes, then.size), THUD_ERROR_INVALID);
    free(then.bytes);
    thud_world_destroy(without);
    thud_world_destroy(other);
    thud_world_destroy(world);
}

static void count_lines(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    (void)a, (void)b, (void)style;
    ++*(int *)context;
}

static void colours_of_rods_are_drawn(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 0, -1, 0);
    add_shape(world, bob, 0.1f, 0, false, NULL);
    tie(world, hook, bob, middle, middle, 1);
    run(world, 1);
    int lines = 0;
    thud_debug_draw draw = {.line = count_lines,
                            .context = &lines,
                            .flags = THUD_DRAW_COLOURS,
                            .lower = {-5, -5},
                            .upper = {5, 5}};
    OK(thud_world_draw(world, &draw));
    assert_int_equal(lines, 1);
    draw.flags = THUD_DRAW_CONTACTS | THUD_DRAW_PAIRS | THUD_DRAW_STAGES | THUD_DRAW_MANIFOLDS;
    OK(thud_world_draw(world, &draw));
    assert_int_equal(lines, 1);
    assert_true(thud_measure_of(world).penetration_max == 0);
    assert_int_equal(thud_stats_of(world).pairs, 0);
    assert_int_equal(thud_stats_of(world).contacts, 0);
    thud_world_destroy(world);
}

/* A rod has no penetration; its error is the velocity by which it misses its target, the
 * residual. */
static void error_report_has_the_speed_that_a_rod_misses(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_draft);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id bob = add_body(world, THUD_BODY_DYNAMIC, 0, -1, 0);
    add_shape(world, bob, 0.1f, 0, false, NULL);
    tie(world, hook, bob, middle, middle, 0.5f);
    run(world, 1);
    thud_step_error error = thud_step_error_of(world);
    assert_true(error.residual > 1e-3);
    assert_true(error.penetration_max == 0 && error.overlaps == 0);
    thud_world_destroy(world);
}

static void wrong_rods_are_refused(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id a = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                 b = add_body(world, THUD_BODY_STATIC, 1, 0, 0);
    thud_body_id c = add_body(world, THUD_BODY_DYNAMIC, 2, 0, 0);
    const thud_joint_def wrong[] = {rod_of(a, b, middle, middle, 1),
                                    rod_of(c, c, middle, middle, 1),
                                    rod_of(a, c, middle, middle, 0),
                                    rod_of(a, c, middle, middle, NAN),
                                    rod_of(a, c, (thud_vec2){INFINITY, 0}, middle, 1)};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_equal(thud_joint_create(world, &wrong[i], NULL), THUD_ERROR_INVALID);
    }
    assert_int_equal(thud_joint_create(world, NULL, NULL), THUD_ERROR_NULL);
    thud_joint_def stale = rod_of(c, (thud_body_id){77, 1}, middle, middle, 1);
    assert_int_equal(thud_joint_create(world, &stale, NULL), THUD_ERROR_STALE);
    assert_int_equal(world->constraints.live, 0);
    thud_world_destroy(world);
}

/* A ball or a box lies on a floor, joined by a rope or a rod to a hook far below, and the joint is
 * shortened at 0.3, 3 or 30 m/s. The contact with the floor holds, and the joint stays open by the
 * gap that the error report states. Under `bisect` and `swept` a ball rests on the floor in every
 * step. Under the others contacts are soft: the ball overlaps the floor by less than half of its
 * radius at first, and by a tenth of it at the end. */
static void floor_bears_what_is_reeled_in(void **state) {
    (void)state;
    const thud_detection *const detections[] = {&thud_detection_bisect, &thud_detection_swept,
                                                &thud_detection_overlap,
                                                &thud_detection_continuous};
    static const float speeds[] = {0.3f, 3, 30};
    for (int i = 0; i < 3 * 2 * 2 * 4 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        int detection = i / QUALITIES % 4;
        bool rope = i / QUALITIES / 4 % 2, box = i / QUALITIES / 8 % 2;
        bool meets = detection < 2;
        float length = 4.3f, speed = speeds[i / QUALITIES / 16];
        def.detection = detections[detection];
        thud_world *world = make_world(def);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, -4, 0);
        thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -0.25, 0);
        add_shape(world, floor, 5, 0.25f, true, NULL);
        thud_body_id load =
            box ? add_box(world, 0, 0.3, 0.3f, 0.3f) : add_ball(world, 0, 0.3, 0.3f);
        thud_joint_def joint = rod_of(hook, load, middle, middle, length);
        joint.drive[THUD_DIRECTION_ALONG].limited = rope;
        joint.drive[THUD_DIRECTION_ALONG].upper = length;
        thud_joint_id id = make(world, joint);
        double height = 0;
        for (int k = 0; k < 300; k++) {
            length = fmaxf(length - speed / 60, 1);
            joint.drive[THUD_DIRECTION_ALONG].upper = length;
            OK(rope ? thud_joint_set_drive(world, id, THUD_DIRECTION_ALONG,
                                           &joint.drive[THUD_DIRECTION_ALONG])
                    : thud_joint_set_length(world, id, length));
            run(world, 1);
            height = state_of(world, load).position.y;
            if (meets && !box) {
                near_to(height, 0.3, 2e-3);
            }
            /* without yielding it was through the floor after 2 to 120 steps */
            assert_true(height > 0.15);
        }
        if (!box) {
            near_to(thud_step_error_of(world).joint_gap_max, 4 + height - (double)length, 1e-3);
        }
        assert_true(height > 0.26);
        thud_world_destroy(world);
    }
}

/* A rope leads from a ball before a wall to a hook beyond the wall, and is reeled in at 3 m/s, but
 * never shorter than the distance to the hook by more than 0.1 m. A loose box lies on the ball.
 * Once the ball is at the hook's height, the rope only presses it against the wall. Returns the
 * greatest speed of ball and box in m/s. */
static double speed_of_reeled_in(const thud_world_def *def) {
    thud_world *world = make_world(*def);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 12, 4, 0);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_def solid = thud_default_shape_def();
    OK(thud_shape_create_aabb(world, wall, &solid, (thud_vec2){7, 5}, (thud_vec2){2, 8}, NULL));
    OK(thud_shape_create_aabb(world, wall, &solid, (thud_vec2){0, -1}, (thud_vec2){9, 1}, NULL));
    thud_body_id ball = add_ball(world, 4.5, 0.5, 0.4f), box = add_box(world, 4.5, 1.4, 0.4f, 0.3f);
    thud_joint_def rope = rod_of(hook, ball, middle, middle, 1);
    rope.drive[THUD_DIRECTION_ALONG].limited = true;
    rope.drive[THUD_DIRECTION_ALONG].upper = (float)hypot(7.5, 3.5);
    thud_joint_id id = make(world, rope);
    thud_drive drive = rope.drive[THUD_DIRECTION_ALONG];
    double worst = 0;
    for (double time = 0; time < 4; time += def->time_step) {
        float taut = (float)joint_of(world, id).value[THUD_DIRECTION_ALONG] - 0.1f;
        drive.upper = fmaxf(drive.upper - 3 * (float)def->time_step, taut);
        OK(thud_joint_set_drive(world, id, THUD_DIRECTION_ALONG, &drive));
        run(world, 1);
        for (int k = 0; k < 2; k++) {
            thud_body_state s = state_of(world, k ? box : ball);
            worst = fmax(worst, hypot((double)s.velocity.x, (double)s.velocity.y));
        }
    }
    thud_world_destroy(world);
    return worst;
}

/* Where rope and wall are nearly at right angles, the ball moves much faster than the rope is
 * reeled in. From 25 length scales per second on, every detection stops a body at the shapes that
 * it moves towards. */
static void rope_that_is_much_too_short_throws_nothing(void **state) {
    (void)state;
    for (int i = 0; i < 2 * 4 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                           &thud_detection_continuous,
                                                           &thud_detection_bisect,
                                                           &thud_detection_swept};
        def.detection = detections[i / QUALITIES % 4];
        def.time_step = i / QUALITIES / 4 ? 1.0 / 240 : 1.0 / 60;
        assert_true(speed_of_reeled_in(&def) < 25);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pendulum_keeps_its_length_and_passes_its_lowest_place),
        cmocka_unit_test(chain_with_a_weight_a_thousand_times_heavier_is_held_directly),
        cmocka_unit_test(rod_hangs_straight_from_a_platform_that_moves),
        cmocka_unit_test(short_rod_on_a_fast_platform_takes_one_part),
        cmocka_unit_test(rod_at_the_end_of_a_plank_turns_it),
        cmocka_unit_test(rods_and_contacts_share_an_island_in_the_direct_solver),
        cmocka_unit_test(net_ends_in_the_same_bits_with_any_workers_and_width),
        cmocka_unit_test(rods_of_one_block_share_no_moving_body),
        cmocka_unit_test(bodies_that_a_rod_ties_fall_asleep_and_wake_together),
        cmocka_unit_test(rod_to_a_disabled_body_lets_go_until_it_is_enabled),
        cmocka_unit_test(body_that_is_destroyed_takes_its_rods_away),
        cmocka_unit_test(rod_that_is_destroyed_lets_go_of_sleepers),
        cmocka_unit_test(restored_net_goes_on_to_the_same_bits),
        cmocka_unit_test(colours_of_rods_are_drawn),
        cmocka_unit_test(error_report_has_the_speed_that_a_rod_misses),
        cmocka_unit_test(wrong_rods_are_refused),
        cmocka_unit_test(floor_bears_what_is_reeled_in),
        cmocka_unit_test(rope_that_is_much_too_short_throws_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
