/* test_lock_tree.c: trees of hinges and welds satisfy their joints and the equations of motion,
 * and move as they do where the general method solves them; each tree chooses its own parts. */
#include "joint_support.h"

#include "direct/island_step.h"
#include "direct/wide_tree.h"
#include "state/world.h"

#include <thud/thud_detection.h>

enum { BODIES_MOST = 40, TREES = 2000 };

/* Sets a number of each tree. */
static void randomise(td_reals *x, uint64_t *seed) {
    for (int tree = 0; tree < TD_TREES; tree++) {
        (*x)[tree] = random_in(seed, -1, 1);
    }
}

static void randomise_power(td_reals *x, uint64_t *seed) {
    for (int tree = 0; tree < TD_TREES; tree++) {
        (*x)[tree] = pow(10, random_in(seed, -3, 3));
    }
}

/* Trees of the same shape, of bodies whose masses differ by up to 10^6; their root may be joined to
 * a body outside that moves. */
static int grow(td_lock_body *bodies, uint64_t *seed) {
    int count = 1 + (int)random_in(seed, 0, BODIES_MOST);
    bool held = random_in(seed, 0, 1) < 0.5;
    for (int i = 0; i < count; i++) {
        td_lock_body *t = &bodies[i];
        *t = (td_lock_body){.parent = i ? (int)random_in(seed, 0, i) : -1,
                            .joined = i || held,
                            .weld = (i || held) && random_in(seed, 0, 1) < 0.3};
        randomise_power(&t->mass, seed);
        randomise_power(&t->turning, seed);
        for (int k = 0; k < 3; k++) {
            randomise(&t->momentum[k], seed);
            t->momentum[k] *= k < 2 ? t->mass : t->turning;
            randomise(&t->outside[k], seed);
        }
        for (int k = 0; k < 2 && t->joined; k++) {
            randomise(&t->arm_now[k], seed);
            randomise(&t->holder_now[k], seed);
            randomise(&t->target[k], seed);
        }
        randomise(&t->turn_target, seed);
    }
    return count;
}

/* What is left of a body's equation of motion: its momentum, minus that without joints, minus the
 * impulses of the joints that it hangs from and of those that hang from it. */
static void assert_in_balance(const td_lock_body *bodies, int count, int body, int tree) {
    const td_lock_body *t = &bodies[body];
    double left[3], size = 1e-12;
    for (int k = 0; k < 3; k++) {
        double inertia = (k < 2 ? t->mass : t->turning)[tree];
        left[k] = inertia * t->velocity[k][tree] - t->momentum[k][tree];
        size += fabs(t->momentum[k][tree]);
    }
    for (int i = 0; i < count; i++) {
        const td_lock_body *joint = &bodies[i];
        if ((i == body && joint->joined) || (i && joint->parent == body)) {
            double sign = i == body ? 1 : -1;
            const td_reals *arm = i == body ? joint->arm_now : joint->holder_now;
            double x = joint->impulse[0][tree], y = joint->impulse[1][tree];
            double turn = joint->turn_impulse[tree];
            left[0] -= sign * x;
            left[1] -= sign * y;
            left[2] -= sign * (arm[0][tree] * y - arm[1][tree] * x + turn);
            size += fabs(x) + fabs(y) + fabs(turn);
        }
    }
    for (int k = 0; k < 3; k++) {
        near_to(left[k] / size, 0, 1e-8);
    }
}

static void solve(td_lock_body *bodies, int count, td_choice *which) {
    td_tree_sums sums = {{0}, {0}};
    for (int i = count - 1; i >= 0; i--) {
        td_tree_hang(bodies, &bodies[i]);
    }
    for (int i = 0; i < count; i++) {
        td_tree_follow(bodies, &bodies[i], *which, &sums);
    }
    *which = td_tree_sound(bodies, count, *which, &sums);
}

static double residual(const td_lock_body *bodies, int count, int tree) {
    td_reals all = {0};
    for (int i = 0; i < count; i++) {
        all = td_tree_miss(bodies, &bodies[i], all);
    }
    return all[tree];
}

static void random_trees_keep_their_joints_and_their_balance(void **state) {
    (void)state;
    uint64_t seed = 5;
    for (int n = 0; n < TREES; n++) {
        td_lock_body bodies[BODIES_MOST];
        int count = grow(bodies, &seed);
        td_choice which = ~(td_choice){0};
        solve(bodies, count, &which);
        for (int tree = 0; tree < TD_TREES; tree++) {
            double fastest = 1;
            assert_true(which[tree]);
            for (int i = 0; i < count; i++) {
                fastest = fmax(fastest, fabs(bodies[i].velocity[2][tree]));
                assert_in_balance(bodies, count, i, tree);
                assert_true(bodies[i].weld || bodies[i].turn_impulse[tree] == 0);
            }
            assert_true(residual(bodies, count, tree) < 1e-12 * fastest);
        }
        bodies[count / 2].target[0] += 1;
        assert_true(!bodies[count / 2].joined || residual(bodies, count, 0) > 0.9);
    }
}

/* A tree that is not chosen keeps its velocities and impulses, and one that fails does not touch
 * the other. */
static void trees_side_by_side_do_not_depend_on_each_other(void **state) {
    (void)state;
    uint64_t seed = 6;
    for (int n = 0; n < TREES; n++) {
        td_lock_body together[BODIES_MOST], alone[BODIES_MOST];
        int count = grow(together, &seed), last = TD_TREES - 1;
        bool kept = n % 2;
        memcpy(alone, together, sizeof alone);
        td_choice all = ~(td_choice){0}, one = {0};
        one[last] = -1;
        if (kept) {
            all[0] = 0;
        } else {
            together[count - 1].momentum[0][0] = NAN;
        }
        solve(together, count, &all);
        solve(alone, count, &one);
        assert_true(all[last] && one[last] && !all[0]);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < 3; k++) {
                assert_true(together[i].velocity[k][last] == alone[i].velocity[k][last]);
                assert_true(together[i].velocity[k][0] == 0);
            }
            for (int k = 0; k < 2; k++) {
                assert_true(together[i].impulse[k][last] == alone[i].impulse[k][last]);
                assert_true(!kept || together[i].impulse[k][0] == 0);
            }
        }
    }
}

static void what_has_no_finite_solution_is_refused(void **state) {
    (void)state;
    td_lock_body body = {.parent = -1};
    body.mass += 1;
    body.turning += 1;
    const double turns[] = {1e9, NAN, 1};
    for (int i = 0; i < 3; i++) {
        td_choice which = {-1};
        for (int tree = 0; tree < TD_TREES; tree++) {
            body.momentum[2][tree] = turns[i];
        }
        solve(&body, 1, &which);
        assert_int_equal(which[0], i == 2 ? -1 : 0);
    }
}

/* A rope of twelve bars with two branches, of hinges and welds, that swings from its end; with
 * `general`, a limit that is never reached is added to its first joint, so that the island is no
 * tree of locks. Listed from its free end, so that the tree is turned over. */
static thud_world *swing(const thud_quality *quality, bool general) {
    thud_world_def def = def_of(quality);
    def.gravity = (thud_vec2){0, -10};
    def.sleeping = false;
    def.detection = &thud_detection_overlap;
    thud_world *world = make_world(def);
    thud_body_id bar[14];
    for (int i = 0; i < 12; i++) {
        bar[i] = add_box(world, 11.5 - i, 0, 0.5f, 0.05f);
    }
    bar[12] = add_box(world, 4.5, -0.5, 0.05f, 0.5f);
    bar[13] = add_box(world, 8.5, 0.5, 0.05f, 0.5f);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    for (int i = 0; i < 14; i++) {
        thud_joint_kind kind = i % 4 == 2 ? THUD_JOINT_WELD : THUD_JOINT_HINGE;
        bool last = i == 11, branch = i > 11;
        thud_body_id other = branch ? bar[i == 12 ? 7 : 3] : last ? hook : bar[i + 1];
        float half = i == 12 ? 0.5f : -0.5f;
        thud_joint_def joint =
            between(kind, bar[i], other, branch ? (thud_vec2){0, half} : (thud_vec2){-0.5f, 0},
                    last ? (thud_vec2){0, 0} : (thud_vec2){0.5f, 0});
        if (branch) {
            joint.frame_b.position = (thud_vec2){0, 0};
        }
        joint.drive[THUD_DIRECTION_TURN].limited = general && last;
        joint.drive[THUD_DIRECTION_TURN].lower = -3.1f;
        joint.drive[THUD_DIRECTION_TURN].upper = 3.1f;
        make(world, joint);
    }
    return world;
}

/* Sixty steps of both give the same motion: in the last one poses differ by no more than rounding
 * to single precision grows to in a swing. */
static void tree_moves_as_by_the_general_method(void **state) {
    (void)state;
    static const thud_quality *const firm[] = {&thud_quality_high, &thud_quality_exact};
    for (int q = 0; q < 2; q++) {
        thud_world *tree = swing(firm[q], false), *general = swing(firm[q], true);
        for (int i = 0; i < 60; i++) {
            OK(thud_world_step(tree));
            OK(thud_world_step(general));
            thud_stats a = thud_stats_of(tree), b = thud_stats_of(general);
            assert_int_equal(a.direct_islands - a.soft_islands, 1);
            assert_int_equal(b.direct_islands - b.soft_islands, 1);
            assert_true(a.island_work < b.island_work); /* it was solved as a tree */
            near_to(thud_step_error_of(tree).joint_gap_max, 0, 1e-5);
        }
        thud_measure m = thud_measure_of(tree), g = thud_measure_of(general);
        near_to(m.kinetic_energy / g.kinetic_energy, 1, 1e-5);
        near_to((m.potential_energy - g.potential_energy) / g.kinetic_energy, 0, 1e-5);
        int count, other;
        const thud_pose *a = thud_poses_of(tree, (thud_pos){0, 0}, 1, &count);
        const thud_pose *b = thud_poses_of(general, (thud_pos){0, 0}, 1, &other);
        assert_int_equal(count, other);
        for (int i = 0; i < count; i++) {
            near_to((double)a[i].x, (double)b[i].x, 1e-3);
            near_to((double)a[i].y, (double)b[i].y, 1e-3);
        }
        thud_world_destroy(tree);
        thud_world_destroy(general);
    }
}

enum { LINKS_MOST = 50 };

/* A rope of `links` bars that reaches to the right from a point at (0, y) and turns about it at
 * `rate`, rad/s. */
static void add_rope(thud_world *world, double y, float rate, int links, thud_body_id *bars) {
    thud_body_id holder = add_body(world, THUD_BODY_STATIC, 0, y, 0);
    for (int i = 0; i < links; i++) {
        bars[i] = add_box(world, 0.5 + i, y, 0.5f, 0.05f);
        OK(thud_body_set_velocity(world, bars[i], (thud_vec2){0, rate * (0.5f + (float)i)}, rate));
        make(world, between(THUD_JOINT_HINGE, i ? bars[i - 1] : holder, bars[i],
                            (thud_vec2){i ? 0.5f : 0, 0}, (thud_vec2){-0.5f, 0}));
    }
}

static thud_world *world_of_ropes(void) {
    thud_world_def def = def_of(&thud_quality_default);
    def.gravity = (thud_vec2){0, -10};
    def.sleeping = false;
    return make_world(def);
}

/* The parts of a step that the fastest rotation of a bar requires: one for each 0.1 rad. */
static double parts_of(const thud_world *world, const thud_body_id *bars) {
    double fastest = 0;
    for (int i = 0; i < LINKS_MOST; i++) {
        fastest = fmax(fastest, fabs((double)state_of(world, bars[i]).angular_velocity));
    }
    return ceil(fastest / 60 / 0.1);
}

/* A tree that is solved after the soft solver may still be refused, so that it does not count in
 * the step's residual. */
static void tree_that_may_be_refused_is_not_counted(void **state) {
    (void)state;
    thud_world *world = swing(&thud_quality_high, false);
    run(world, 10);
    td_islands *s = &world->islands;
    assert_true(s->trees_residual > 0);
    s->trees_residual = 0;
    const td_island *island = s->island.data;
    assert_int_equal(td_lock_tree_step(world, island, NULL), TD_TREE_SOLVED);
    assert_true(s->trees_residual == 0);
    thud_world_destroy(world);
}

/* The end of a rope that swings cracks like a whip: within a step it turns faster and faster. What
 * is solved of the step is kept then, and what is left of it is divided into more parts, each of
 * which takes three solutions, some a few more. */
static void step_of_a_whip_is_solved_once(void **state) {
    (void)state;
    thud_world *world = world_of_ropes();
    thud_body_id bars[LINKS_MOST];
    add_rope(world, 0, 0, LINKS_MOST, bars);
    double most = 0, before = 0;
    for (int i = 0; i < 400; i++) {
        OK(thud_world_step(world));
        double after = parts_of(world, bars), parts = fmax(before, after);
        assert_true(thud_stats_of(world).factorings <= 3.5 * parts + 5);
        most = fmax(most, parts);
        before = after;
    }
    assert_true(most >= 8);
    thud_world_destroy(world);
}

/* Ropes that turn at different rates are solved side by side, in more parts or fewer: each moves to
 * the bit as it does alone. */
static void ropes_side_by_side_do_not_depend_on_each_other(void **state) {
    (void)state;
    enum { LINKS = 10, ROPES = 4 };
    thud_world *alone = world_of_ropes(), *together = world_of_ropes();
    thud_body_id one[LINKS], bars[ROPES][LINKS];
    add_rope(alone, 0, 4, LINKS, one);
    for (int i = 0; i < ROPES; i++) {
        add_rope(together, 50 * i, (float)(4 + 10 * i), LINKS, bars[i]);
    }
    for (int i = 0; i < 120; i++) {
        OK(thud_world_step(alone));
        OK(thud_world_step(together));
        thud_stats stats = thud_stats_of(together);
        assert_int_equal(stats.direct_islands - stats.soft_islands, ROPES);
        for (int k = 0; k < LINKS; k++) {
            thud_body_state a = state_of(alone, one[k]), b = state_of(together, bars[0][k]);
            assert_true(a.position.x == b.position.x && a.position.y == b.position.y);
            assert_true(a.velocity.x == b.velocity.x && a.velocity.y == b.velocity.y);
            assert_true(a.angular_velocity == b.angular_velocity);
        }
    }
    thud_world_destroy(alone);
    thud_world_destroy(together);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_trees_keep_their_joints_and_their_balance),
        cmocka_unit_test(trees_side_by_side_do_not_depend_on_each_other),
        cmocka_unit_test(what_has_no_finite_solution_is_refused),
        cmocka_unit_test(tree_moves_as_by_the_general_method),
        cmocka_unit_test(tree_that_may_be_refused_is_not_counted),
        cmocka_unit_test(step_of_a_whip_is_solved_once),
        cmocka_unit_test(ropes_side_by_side_do_not_depend_on_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
