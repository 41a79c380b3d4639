/* test_detection.c: worlds under `bisect` and `swept`: where impacts place bodies, that nothing
 * passes or overlaps, bodies with a detection of their own, callbacks and events of impacts, and
 * that lost motion is counted. */
#include "engine_support.h"

#include <thud/thud_edits.h>

static thud_world_def with(const thud_detection *detection, thud_world_def def) {
    def.detection = detection;
    return def;
}

static void make_elastic(thud_shape_def *def) {
    *def = thud_default_shape_def();
    def->restitution = 1.0f;
    def->friction = 0.0f;
}

/* ---- swept ---- */

/* A ball of radius 0.1 between walls moves 0.8 between impacts; its position follows from the
 * number of impacts. */
static void swept_ball_bounces_between_walls_many_times_a_step(void **state) {
    (void)state;
    thud_world_def def = with(&thud_detection_swept, weightless());
    thud_world *world = make_world(def);
    thud_shape_def elastic;
    make_elastic(&elastic);
    for (int side = -1; side <= 1; side += 2) {
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, side * 0.51, 0, 0);
        add_shape(world, wall, 0.01f, 1, true, &elastic);
    }
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    add_shape(world, ball, 0.1f, 0, false, &elastic);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){240, 0}, 0)); /* 4 m a step: five bounces */
    double way = 0.0;
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        /* It turns 0.001 in front of each wall, at the skin. */
        way += 4.0;
        double gap = 0.8 - 2 * 0.001, phase = fmod(way + gap / 2, 2 * gap);
        double x = phase < gap ? phase - gap / 2 : 1.5 * gap - phase;
        near_to(state_of(world, ball).position.x, x, 0.02 * (i + 1) / 60 + 1e-4);
        near_to(fabs((double)state_of(world, ball).velocity.x), 240, 1e-3);
        assert_in_range(thud_stats_of(world).impacts, 4, 6);
        assert_int_equal(thud_stats_of(world).held_bodies, 0);
    }
    thud_world_destroy(world);
}

/* Shoots a bullet of a kind at a thin wall, static or dynamic; returns 1 where it passed, else
 * 0. */
static int shoot(const thud_detection *detection, int kind, double speed, bool dynamic,
                 uint64_t *seed) {
    thud_world *world = make_world(with(detection, weightless()));
    thud_body_id wall = add_body(world, dynamic ? THUD_BODY_DYNAMIC : THUD_BODY_STATIC, 10, 0, 0);
    thud_shape_def heavy = thud_default_shape_def();
    heavy.density = 1000;
    add_shape(world, wall, 0.01f, 10000, kind == 1, &heavy);
    double slant = random_in(seed, -0.3, 0.3);
    thud_body_id body =
        add_body(world, THUD_BODY_DYNAMIC, random_in(seed, -1, 1), random_in(seed, -1, 1), 0);
    add_shape(world, body, 0.1f, kind ? 0.1f : 0, kind == 1, NULL);
    thud_vec2 v = {(float)speed, (float)(speed * slant)};
    OK(thud_body_set_velocity(world, body, v, kind == 2 ? (float)random_in(seed, -20, 20) : 0));
    int passed = 0;
    for (int i = 0; i < 40; i++) {
        run(world, 1);
        thud_body_state w = state_of(world, wall), b = state_of(world, body);
        double ahead = (b.position.x - w.position.x) * (double)w.cosine +
                       (b.position.y - w.position.y) * (double)w.sine;
        passed |= ahead > 0;
    }
    thud_world_destroy(world);
    return passed;
}

/* At 10 to 1e5 m/s no swept bullet passes a wall, while more than half of those under `overlap`
 * do. */
static void swept_bullets_pass_no_thin_wall_and_overlap_tested_ones_do(void **state) {
    (void)state;
    uint64_t seed = 41;
    int shots = 0, passed_unswept = 0;
    for (int kind = 0; kind < 3; kind++) {
        for (double speed = 10; speed < 2e5; speed *= 10) {
            for (int i = 0; i < 16; i++, shots++) {
                if (shoot(&thud_detection_swept, kind, speed, i % 2, &seed)) {
                    fail_msg("kind %d at %g passed a wall", kind, speed);
                }
                passed_unswept += shoot(&thud_detection_overlap, kind, speed, i % 2, &seed);
            }
        }
    }
    assert_true(passed_unswept > shots / 2);
}

/* The deepest overlap of any two bodies, each with one shape. */
static double deepest(const thud_world *world, const thud_body_id *ids, int count) {
    thud_geometry *placed = calloc((size_t)count, sizeof *placed);
    double depth = 0.0;
    for (int i = 0; i < count; i++) {
        thud_body_state b = state_of(world, ids[i]);
        thud_shape_id shape;
        thud_shape_state s;
        OK(thud_body_get_shapes(world, ids[i], &shape, 1, NULL));
        OK(thud_shape_get_state(world, shape, &s));
        bool obb = s.kind == THUD_SHAPE_OBB;
        placed[i] = (thud_geometry){s.kind,
                                    b.position.x,
                                    b.position.y,
                                    obb ? cos(b.angle) : 1.0,
                                    obb ? sin(b.angle) : 0.0,
                                    (double)s.half_extents.x,
                                    (double)s.half_extents.y};
        for (int k = 0; k < i; k++) {
            thud_closest c;
            OK(thud_geometry_closest(&placed[k], &placed[i], &c));
            bool both_static =
                b.kind == THUD_BODY_STATIC && state_of(world, ids[k]).kind == THUD_BODY_STATIC;
            depth = both_static ? depth : fmax(depth, -c.distance);
        }
    }
    free(placed);
    return depth;
}

/* The deepest overlap of bodies of all kinds in a closed room, in any step. */
static double deepest_in_a_room(const thud_detection *detection, double speed, thud_stats *sum) {
    enum { BODIES = 60, WALLS = 4 };
    thud_world *world = make_world(with(detection, weightless()));
    thud_body_id ids[BODIES + WALLS];
    uint64_t seed = 99;
    for (int i = 0; i < WALLS; i++) {
        bool upright = i < 2;
        double at = i % 2 ? 11 : -11;
        ids[i] = add_body(world, THUD_BODY_STATIC, upright ? at : 0, upright ? 0 : at, 0);
        add_shape(world, ids[i], upright ? 1 : 12, upright ? 12 : 1, true, NULL);
    }
    for (int i = WALLS; i < BODIES + WALLS; i++) {
        int k = i - WALLS;
        ids[i] =
            add_body(world, THUD_BODY_DYNAMIC, -8.75 + 2.5 * (k % 8), -8.75 + 2.5 * (k / 8), 0);
        thud_shape_def elastic;
        make_elastic(&elastic);
        add_shape(world, ids[i], 0.3f, k % 3 ? 0.2f : 0, k % 3 == 1, &elastic);
        double angle = random_in(&seed, 0, 6.28);
        thud_vec2 v = {(float)(speed * cos(angle)), (float)(speed * sin(angle))};
        OK(thud_body_set_velocity(world, ids[i], v, k % 3 == 2 ? 10 : 0));
    }
    double depth = 0.0;
    for (int step = 0; step < 120; step++) {
        run(world, 1);
        thud_stats s = thud_stats_of(world);
        sum->impacts += s.impacts;
        sum->held_bodies += s.held_bodies;
        sum->held_seconds += s.held_seconds;
        sum->unbisectable += s.unbisectable;
        depth = fmax(depth, deepest(world, ids, BODIES + WALLS));
    }
    thud_world_destroy(world);
    return depth;
}

static void swept_bodies_of_all_kinds_never_overlap_where_unswept_ones_do(void **state) {
    (void)state;
    thud_stats swept = {0}, overlap = {0};
    double depth = deepest_in_a_room(&thud_detection_swept, 60, &swept);
    assert_true(depth < 1e-4);
    assert_true(swept.impacts > 900);
    /* Almost no motion is lost, and the statistics count what is. */
    assert_true(swept.held_seconds < 0.001 * 60 * 2);
    assert_true(deepest_in_a_room(&thud_detection_overlap, 60, &overlap) > 0.15);
    assert_int_equal(overlap.impacts, 0);
}

static void swept_head_on_impact_keeps_momentum_and_exchanges_velocities(void **state) {
    (void)state;
    thud_world *world = make_world(with(&thud_detection_swept, weightless()));
    thud_shape_def elastic;
    make_elastic(&elastic);
    thud_body_id a = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_body_id b = add_body(world, THUD_BODY_DYNAMIC, 3, 0, 0);
    add_shape(world, a, 0.5f, 0, false, &elastic);
    add_shape(world, b, 0.5f, 0, false, &elastic);
    /* 2.5 m a step, 2 m to the impact */
    OK(thud_body_set_velocity(world, a, (thud_vec2){150, 0}, 0));
    run(world, 1);
    near_to((double)state_of(world, a).velocity.x, 0, 1e-4);
    near_to((double)state_of(world, b).velocity.x, 150, 1e-3);
    /* The rest of the step is not lost: b continues the way that a had left. */
    near_to(state_of(world, a).position.x, 2, 0.0011);
    near_to(state_of(world, b).position.x, 3.5, 0.0011);
    thud_world_destroy(world);
}

/* Two kinematic plates press a body from both sides: it is held, and the statistics say for how
 * long. */
static void swept_body_without_a_way_out_is_held_and_counted(void **state) {
    (void)state;
    thud_world *world = make_world(with(&thud_detection_swept, weightless()));
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    for (int side = -1; side <= 1; side += 2) {
        thud_body_id plate = add_body(world, THUD_BODY_KINEMATIC, side * 1.2, 0, 0);
        add_shape(world, plate, 0.5f, 3, true, NULL);
        OK(thud_body_set_velocity(world, plate, (thud_vec2){(float)(-12 * side), 0}, 0));
    }
    int held = 0;
    double lost = 0.0;
    for (int i = 0; i < 3; i++) {
        run(world, 1);
        held += thud_stats_of(world).held_bodies;
        lost += thud_stats_of(world).held_seconds;
    }
    assert_true(held > 0 && lost > 0.0 && lost <= 3.0 / 60.0);
    assert_true(isfinite(state_of(world, ball).position.x));
    thud_world_destroy(world);
}

/* ---- bisected ---- */

static void bisected_body_is_taken_back_to_its_collision(void **state) {
    (void)state;
    thud_world *world = make_world(with(&thud_detection_bisect, weightless()));
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 3, 0, 0);
    add_shape(world, wall, 0.5f, 4, true, NULL);
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    /* 2.4 m a step, 2 m to the impact */
    OK(thud_body_set_velocity(world, ball, (thud_vec2){144, 0}, 0));
    run(world, 1);
    near_to(state_of(world, ball).position.x, 2, 0.0011);
    assert_true(state_of(world, ball).position.x <= 2);
    near_to((double)state_of(world, ball).velocity.x, 0, 1e-4);
    assert_int_equal(thud_stats_of(world).impacts, 1);
    /* 2.4 m a step is more than the wall's thickness, 1 m */
    assert_int_equal(thud_stats_of(world).unbisectable, 1);
    thud_world_destroy(world);
}

/* thud_world_get_bisection_limit is the thickness of the thinnest shape divided by the time step,
 * and statistics count bodies that move faster. */
static void bisection_limit_is_the_thinnest_shape_a_step_and_who_breaks_it_is_counted(
    void **state) {
    (void)state;
    thud_world *world = make_world(with(&thud_detection_bisect, weightless()));
    double limit = 0.0;
    OK(thud_world_get_bisection_limit(world, &limit));
    assert_true(isinf(limit));
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 9, 0, 0);
    thud_shape_id thin = add_shape(world, wall, 0.1f, 4, true, NULL);
    add_shape(world, wall, 1, 4, true, NULL);
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    OK(thud_world_get_bisection_limit(world, &limit));
    near_to(limit, 0.2 * 60, 1e-6);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){11.9f, 0}, 0));
    run(world, 1);
    assert_int_equal(thud_stats_of(world).unbisectable, 0);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){12.1f, 0}, 0));
    run(world, 1);
    assert_int_equal(thud_stats_of(world).unbisectable, 1);
    OK(thud_shape_destroy(world, thin));
    run(world, 1);
    OK(thud_world_get_bisection_limit(world, &limit));
    near_to(limit, 1.0 * 60, 1e-6);
    assert_int_equal(thud_world_get_bisection_limit(world, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_bisection_limit(NULL, &limit), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

static void bisected_bodies_within_the_limit_never_overlap(void **state) {
    (void)state;
    thud_stats bisected = {0};
    assert_true(deepest_in_a_room(&thud_detection_bisect, 11, &bisected) < 0.001);
    assert_true(bisected.impacts > 200);
    assert_int_equal(bisected.unbisectable, 0);
}

/* ---- choice ---- */

/* In a world under `overlap`, a body whose own detection is `swept` stops at a wall that another
 * one passes. */
static void body_chooses_its_own_detection(void **state) {
    (void)state;
    thud_world *world = make_world(with(&thud_detection_overlap, weightless()));
    thud_body_id wall = add_body(world, THUD_BODY_DYNAMIC, 10, 0, 0);
    thud_shape_def heavy = thud_default_shape_def();
    heavy.density = 1e4f;
    add_shape(world, wall, 0.01f, 8, true, &heavy);
    thud_body_id bullets[2];
    for (int i = 0; i < 2; i++) {
        thud_body_def def = thud_default_body_def();
        def.kind = THUD_BODY_DYNAMIC;
        def.position.y = i * 2.0;
        def.velocity.x = 500;
        def.detection = i ? &thud_detection_swept : NULL;
        OK(thud_body_create(world, &def, &bullets[i]));
        add_shape(world, bullets[i], 0.1f, 0, false, NULL);
    }
    run(world, 10);
    assert_true(state_of(world, bullets[0]).position.x > 20);
    assert_true(state_of(world, bullets[1]).position.x < state_of(world, wall).position.x);
    assert_true(state_of(world, wall).velocity.x > 0);
    thud_world_destroy(world);
}

static void names_tell_what_was_chosen(void **state) {
    (void)state;
    assert_string_equal(thud_detection_name(&thud_detection_overlap), "overlap");
    assert_string_equal(thud_detection_name(&thud_detection_continuous), "continuous");
    assert_string_equal(thud_detection_name(&thud_detection_bisect), "bisect");
    assert_string_equal(thud_detection_name(&thud_detection_swept), "swept");
    assert_string_equal(thud_detection_name(NULL), "");
}

/* ---- callbacks and events of impacts ---- */

/* Counts of callbacks, the sum of impulses, and whether the prologue vetoes. */
typedef struct heard {
    int asked, told;
    double impulse;
    bool veto;
} heard;

static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                void *context) {
    (void)settings;
    (void)world;
    (void)contact;
    heard *h = context;
    h->asked++;
    return !h->veto;
}

static void tell(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    heard *h = context;
    h->told++;
    h->impulse += (double)contact->normal_impulse;
}

/* An impact within a step calls the prologue and, unless that vetoes it, the epilogue, and makes
 * one hit event with its speed. */
static void impact_within_a_step_asks_tells_and_hits(void **state) {
    (void)state;
    for (int veto = 0; veto < 2; veto++) {
        heard h = {.veto = veto};
        thud_world_def def = with(&thud_detection_swept, weightless());
        thud_world *world = make_world(def);
        set_listeners(world, ask, tell, &h);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 5, 0, 0);
        add_shape(world, wall, 0.01f, 4, true, NULL);
        thud_body_id ball = add_ball(world, 0, 0, 0.5f);
        double mass = (double)state_of(world, ball).mass;
        OK(thud_body_set_velocity(world, ball, (thud_vec2){600, 0}, 0)); /* 10 m a step */
        run(world, 1);
        assert_int_equal(h.asked, 1);
        assert_int_equal(h.told, veto ? 0 : 1);
        near_to(h.impulse, veto ? 0 : mass * 600, 0.01);
        assert_int_equal(thud_events_of(world).hit_count, veto ? 0 : 1);
        assert_true(veto == (state_of(world, ball).position.x > 9));
        if (!veto) {
            near_to((double)thud_events_of(world).hit[0].speed, 600, 0.01);
        }
        thud_world_destroy(world);
    }
}

static void sleeper_that_is_hit_by_a_swept_body_wakes(void **state) {
    (void)state;
    thud_world_def def = with(&thud_detection_swept, thud_default_world_def());
    def.gravity = (thud_vec2){0, 0};
    thud_world *world = make_world(def);
    thud_body_id box = add_box(world, 20, 0, 0.5f, 0.5f);
    run(world, 60);
    assert_false(state_of(world, box).awake);
    thud_body_id ball = add_ball(world, 0, 0, 0.2f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){900, 0}, 0));
    run(world, 6);
    assert_true(state_of(world, box).awake);
    assert_true(state_of(world, box).velocity.x > 10);
    assert_true(state_of(world, ball).position.x < state_of(world, box).position.x);
    thud_world_destroy(world);
}

/* Kinetic energy; the body is neither quarantined nor at a speed that is not finite. */
static double energy_of(const thud_world *world, thud_body_id body) {
    thud_body_state s = state_of(world, body);
    double x = (double)s.velocity.x, y = (double)s.velocity.y, turn = (double)s.angular_velocity;
    assert_true(isfinite(x + y + turn) && !s.quarantined);
    return 0.5 * (double)s.mass * (x * x + y * y) + 0.5 * (double)s.inertia * turn * turn;
}

/* Boxes whose inertia is any share of their mass down to THUD_MASS_MIN meet static and dynamic ones
 * at any angle: no impact gives energy, or a velocity that is not finite. */
static void bodies_of_any_inertia_meet_without_gain(void **state) {
    (void)state;
    uint64_t seed = 88172645463325252u;
    for (int i = 0; i < 1600; i++) {
        thud_world *world =
            make_world(with(i % 2 ? &thud_detection_swept : &thud_detection_bisect, weightless()));
        thud_mass mass = {.mass = (float)pow(10, random_in(&seed, -6, 6))};
        mass.inertia = fmaxf(mass.mass * (float)pow(10, -i / 2 % 40), THUD_MASS_MIN);
        thud_shape_def def = thud_default_shape_def();
        def.restitution = i % 3 ? 0 : (float)random_in(&seed, 0, 1);
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0, random_in(&seed, 0, 3));
        add_shape(world, box, 0.5f, 0.3f, false, &def);
        bool rests = i % 5 == 0;
        thud_body_id other = add_body(world, rests ? THUD_BODY_STATIC : THUD_BODY_DYNAMIC, 3,
                                      random_in(&seed, -0.5, 0.5), random_in(&seed, 0, 3));
        add_shape(world, other, 0.5f, 0.4f, false, &def);
        OK(thud_body_set_mass(world, box, &mass));
        if (i % 5 == 1) {
            OK(thud_body_set_mass(world, other, &mass));
        }
        thud_vec2 velocity = {(float)random_in(&seed, 5, 60), (float)random_in(&seed, -5, 5)};
        OK(thud_body_set_velocity(world, box, velocity, (float)random_in(&seed, -3, 3)));
        double before = energy_of(world, box) + energy_of(world, other);
        for (int step = 0; step < 30; step++) {
            run(world, 1);
            assert_true(energy_of(world, box) + energy_of(world, other) <= before * 1.001);
        }
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(swept_ball_bounces_between_walls_many_times_a_step),
        cmocka_unit_test(swept_bullets_pass_no_thin_wall_and_overlap_tested_ones_do),
        cmocka_unit_test(swept_bodies_of_all_kinds_never_overlap_where_unswept_ones_do),
        cmocka_unit_test(swept_head_on_impact_keeps_momentum_and_exchanges_velocities),
        cmocka_unit_test(swept_body_without_a_way_out_is_held_and_counted),
        cmocka_unit_test(bisected_body_is_taken_back_to_its_collision),
        cmocka_unit_test(bisection_limit_is_the_thinnest_shape_a_step_and_who_breaks_it_is_counted),
        cmocka_unit_test(bisected_bodies_within_the_limit_never_overlap),
        cmocka_unit_test(body_chooses_its_own_detection),
        cmocka_unit_test(names_tell_what_was_chosen),
        cmocka_unit_test(impact_within_a_step_asks_tells_and_hits),
        cmocka_unit_test(sleeper_that_is_hit_by_a_swept_body_wakes),
        cmocka_unit_test(bodies_of_any_inertia_meet_without_gain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
