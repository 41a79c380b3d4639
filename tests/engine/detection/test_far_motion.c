/* test_far_motion.c: extreme gravity scales, forces and spins under every detection: bodies move no
 * further in a step than positions can represent. A conversion that overflowed moved bodies half
 * around the range of positions. */
#include "joint_support.h"
#include "share.h"

#include <thud/thud_detection.h>
#include <thud/thud_make.h>

enum { HEAPS = 1500, MOST = 16, RUNS = 12 };

static const thud_detection *const detections[] = {&thud_detection_swept, &thud_detection_bisect,
                                                   &thud_detection_continuous};

/* True for one of `many` draws. */
static bool one_in(uint64_t *seed, double many) {
    return random_in(seed, 0, many) < 1;
}

static float either_sign(uint64_t *seed, double value) {
    return (float)(one_in(seed, 2) ? value : -value);
}

/* A heap; `size` is its bodies' extent, and `what` is extreme: 0 gravity scales, 1 spins, 2
 * forces. */
typedef struct heap {
    thud_world *world;
    thud_body_id body[MOST];
    double size, extreme; /* extreme force or gravity scale */
    int what;
} heap;

/* The def of body i, with extreme values in some of them. */
static thud_body_def body_def(const heap *h, int i, uint64_t *seed) {
    thud_body_def def = thud_default_body_def();
    def.kind = one_in(seed, 8) ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC;
    def.position = (thud_pos){(i % 4 - 2) * 2.02 * h->size,
                              (0.5 + i / 4) * 2 * h->size + random_in(seed, 0, 0.02)};
    if (h->what == 0 && one_in(seed, 3)) {
        def.gravity_scale = either_sign(seed, h->extreme);
    } else if (h->what == 1 && one_in(seed, 3)) {
        def.angular_velocity = either_sign(seed, 1e8);
    }
    double fast = one_in(seed, 6) ? 1e6 : 100;
    def.velocity =
        (thud_vec2){(float)random_in(seed, -fast, fast), (float)random_in(seed, -fast, 0)};
    return def;
}

/* Creates heap number `number`; settings follow from the number, the rest is random. */
static heap make_heap(uint64_t *seed, int number) {
    static const double steps[] = {1.0 / 60, 0.1, 1};
    bool joined = number % 2;
    thud_world_def def = def_of(qualities[number / 2 % QUALITIES]);
    def.gravity = (thud_vec2){0, -10};
    def.detection = detections[number / 8 % 3];
    def.time_step = steps[number / 24 % 3];
    heap h = {.world = make_world(def),
              .size = one_in(seed, 3) ? pow(10, random_in(seed, 0, 3)) : 0.5,
              .extreme = pow(10, random_in(seed, 0, 36)),
              .what = number / 72 % 3};
    add_floor(h.world, NULL);
    for (int i = 0; i < MOST; i++) {
        thud_body_def body = body_def(&h, i, seed);
        thud_shape_def shape = thud_default_shape_def();
        shape.density = (float)pow(10, random_in(seed, -6, 6));
        shape.restitution = one_in(seed, 2) ? 0 : (float)random_in(seed, 0, 1);
        OK(thud_body_create(h.world, &body, &h.body[i]));
        add_shape(h.world, h.body[i], (float)h.size, one_in(seed, 2) ? 0 : (float)h.size, false,
                  &shape);
        if (joined && i && one_in(seed, 3) && body.kind == THUD_BODY_DYNAMIC) {
            make(h.world,
                 between(one_in(seed, 2) ? THUD_JOINT_HINGE : THUD_JOINT_WELD, h.body[i - 1],
                         h.body[i], (thud_vec2){(float)h.size, 0}, (thud_vec2){-(float)h.size, 0}));
        }
    }
    return h;
}

static void push_some(const heap *h, uint64_t *seed) {
    for (int i = 0; i < MOST && h->what == 2; i++) {
        if (one_in(seed, 5) && state_of(h->world, h->body[i]).kind == THUD_BODY_DYNAMIC &&
            !state_of(h->world, h->body[i]).quarantined) {
            thud_vec2 force = {either_sign(seed, h->extreme), either_sign(seed, h->extreme)};
            OK(thud_body_apply_center_force(h->world, h->body[i], force));
        }
    }
}

/* In no step does a body move by more than 1.01e9 in x or y, and velocities stay finite. */
static void nothing_is_driven_further_than_places_can_follow(void **state) {
    (void)state;
    uint64_t seed = 11;
    for (int number = 0; number < share_of(HEAPS); number++) {
        heap h = make_heap(&seed, number);
        for (int step = 0; step < RUNS; step++) {
            thud_body_state before[MOST];
            for (int i = 0; i < MOST; i++) {
                before[i] = state_of(h.world, h.body[i]);
            }
            push_some(&h, &seed);
            run(h.world, 1);
            for (int i = 0; i < MOST; i++) {
                thud_body_state now = state_of(h.world, h.body[i]);
                double x = now.center.x - before[i].center.x, y = now.center.y - before[i].center.y;
                if (!now.quarantined && !(fabs(x) < 1.01e9 && fabs(y) < 1.01e9)) {
                    fail_msg("heap %d, step %d: body %d moved by (%g, %g)", number, step, i, x, y);
                }
                if (!isfinite(now.velocity.x) || !isfinite(now.velocity.y)) {
                    fail_msg("heap %d, step %d: body %d is not finite", number, step, i);
                }
            }
        }
        thud_world_destroy(h.world);
    }
}

/* ---- motions longer than the range of the broadphase's bounds ---- */

static const thud_broadphase *const broadphases[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                     &thud_broadphase_all};

/* What a flight ended with. */
typedef struct flight {
    thud_stats stats;
    thud_pos end;
    uint64_t hash;
} flight;

/* One step of 1 s, in which a ball flies 1e6 length scales towards a wall or a body, past
 * others. */
static flight fly(const thud_detection *detection, const thud_broadphase *broadphase,
                  thud_body_kind kind, double distance, double angle) {
    thud_world_def def = def_of(&thud_quality_default);
    def.gravity = (thud_vec2){0, 0};
    def.time_step = 1;
    def.broadphase = broadphase;
    def.detection = detection;
    thud_world *world = make_world(def);
    double c = cos(angle), s = sin(angle);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    add_shape(world, ball, 0.5f, 0, false, NULL);
    for (int i = 0; i < 9; i++) {
        double along = i < 8 ? 1e5 * (i + 1) : distance, beside = i < 8 ? 3e4 : 0;
        thud_body_id other = add_body(world, i < 8 ? THUD_BODY_STATIC : kind,
                                      c * along - s * beside, s * along + c * beside, 0);
        add_shape(world, other, 50, 0, false, NULL);
    }
    thud_vec2 velocity = {(float)(9.9e5 * c), (float)(9.9e5 * s)};
    OK(thud_body_set_velocity(world, ball, velocity, 0));
    run(world, 1);
    flight f = {thud_stats_of(world), state_of(world, ball).position, thud_hash_of(world)};
    thud_world_destroy(world);
    return f;
}

/* Bounds wrap around at 262144 length scales. */
static void nothing_is_passed_on_the_longest_way_in_any_broadphase(void **state) {
    (void)state;
    static const double distances[] = {1e3, 4e4, 7e4, 1.3e5, 1.4e5, 2.6e5, 2.7e5, 5.3e5, 9e5};
    for (int n = 0; n < 9 * 12 * 4; n++) {
        const thud_detection *detection = detections[n % 4 == 3 ? 2 : 0];
        thud_body_kind kind = n % 4 == 1 ? THUD_BODY_DYNAMIC : THUD_BODY_STATIC;
        double distance = distances[n / 4 % 9], angle = n / 36 * 0.55;
        flight first = fly(detection, broadphases[0], kind, distance, angle);
        double gone = hypot(first.end.x, first.end.y);
        if (kind == THUD_BODY_STATIC && !(gone < distance - 50)) {
            fail_msg("flight %d: a wall at %g is passed, to %g", n, distance, gone);
        }
        for (int b = 1; b < 3; b++) {
            flight other = fly(detection, broadphases[b], kind, distance, angle);
            assert_int_equal(first.hash, other.hash);
            assert_int_equal(first.stats.motion_pairs, other.stats.motion_pairs);
            assert_int_equal(first.stats.impacts, other.stats.impacts);
        }
    }
}

/* A body whose motion in a step is too long for the broadphase looks at all shapes, but not at the
 * holes that a body leaves in the set of resting shapes when it is woken. */
static void long_motion_passes_over_bodies_that_were_woken(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.detection = &thud_detection_swept;
    def.gravity = (thud_vec2){0, 0};
    thud_world *world = make_world(def);
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC}, spin = ball;
    thud_body_id balls[8];
    for (int i = 0; i < 8; i++) {
        balls[i] = thud_body_make(world, thud_circle_at(10 * i, 0, 0.5), &ball);
    }
    run(world, 60); /* all fall asleep */
    spin.angular_velocity = 2e7f;
    assert_true(thud_body_make(world, thud_obb_at(0, 20, 1, 0.5, 0), &spin).index1);
    run(world, 5);
    OK(thud_body_set_awake(world, balls[3], true));
    run(world, 5);
    thud_world_destroy(world);
}

/* Adds a flat line of ground whose body is at x. */
static void add_line_at(thud_world *world, double x, double slope) {
    thud_body_def at = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_terrain line = {.kind = THUD_TERRAIN_FLAT, .slope = slope};
    thud_body_id ground;
    at.position.x = x;
    OK(thud_body_create(world, &at, &ground));
    OK(thud_shape_create_terrain(world, ground, &shape, &line, NULL));
}

/* Shapes that are as far from each other as a world allows, over 1e15 units, have no points of
 * contact. */
static void shapes_at_opposite_ends_of_the_world_have_no_contacts(void **state) {
    (void)state;
    for (int repeat = 0; repeat < 4; repeat++) {
        thud_world_def def = thud_default_world_def();
        def.length_scale = 1e6f;
        def.gravity.y = -5e6f;
        def.detection = &thud_detection_swept;
        thud_world *world = make_world(def);
        add_line_at(world, 5.2e14, 0);
        for (int i = 0; i < 8; i++) {
            double x = -5.2e14 + i * 4e5;
            thud_body_options o = {.kind = THUD_BODY_DYNAMIC,
                                   .velocity = {(float)(i * 7 % 11 - 5) * 1e7f, -1e7f},
                                   .angular_velocity = (float)(i % 5)};
            thud_body_make(world,
                           i & 1 ? thud_circle_at(x, 1e6 + i % 3 * 7e5, 3e5)
                                 : thud_obb_at(x, 1e6, 3e5, 2e5, 0.3),
                           &o);
        }
        run(world, 200);
        thud_world_destroy(world);
    }
}

/* A flat line has no end: a fast ball stops on it as far from its body as a world allows. */
static void flat_line_stops_what_is_at_the_other_end_of_the_world(void **state) {
    (void)state;
    for (int i = 0; i < 3 * 2 * 2; i++) {
        double x = i / 6 ? 5.2e14 : 1e14, slope = i / 3 % 2 * 1e-3;
        thud_world_def def = thud_default_world_def();
        def.length_scale = THUD_LENGTH_SCALE_MAX;
        def.maximum_speed = 1e5f;
        def.gravity.y = -5e6f;
        def.detection = detections[i % 3];
        thud_world *world = make_world(def);
        add_line_at(world, x, slope);
        thud_body_options down = {.kind = THUD_BODY_DYNAMIC, .velocity = {1e6f, -1e9f}};
        thud_body_id ball =
            thud_body_make(world, thud_circle_at(-x, 3e6 - slope * 2 * x, 3e5), &down);
        run(world, 200);
        thud_pos p = state_of(world, ball).position;
        near_to((p.y - slope * (p.x - x)) / 3e5, 1, 0.01);
        thud_world_destroy(world);
    }
}

/* A body that flies over the end of the range of positions comes in at the other end, without an
 * addition that overflows: undefined, which builds with sanitizers stop at. */
static void body_that_leaves_the_range_of_positions_comes_in_at_the_other_end(void **state) {
    (void)state;
    for (int d = 0; d < 3; d++) {
        thud_world_def def = weightless();
        def.time_step = 1;
        def.maximum_speed = THUD_SPEED_MAX;
        def.detection = detections[d];
        thud_world *world = make_world(def);
        thud_body_options flies = {.kind = THUD_BODY_DYNAMIC, .velocity = {1e6f, 0}};
        thud_body_options stays = {.kind = THUD_BODY_STATIC}, senses = stays;
        senses.sensor = true;
        thud_body_id last = {0, 0};
        for (int i = 0; i < 3; i++) {
            thud_body_make(world, thud_circle_at(1e9 - 10 * i, 0, 0.5), &flies);
            last = thud_body_make(world, thud_obb_at(1e9 - 10 * i, 3, 0.5, 0.5, 0.2), &flies);
            thud_body_make(world, thud_aabb_at(9e8 * (i - 1), 0, 1, 1), &stays);
            thud_body_make(world, thud_aabb_at(9e8 * (i - 1), 5, 1, 1), &senses);
        }
        run(world, 1200);
        near_to(state_of(world, last).position.x, 1e9 + 1.2e9 - 0x1p32, 100);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_driven_further_than_places_can_follow),
        cmocka_unit_test(nothing_is_passed_on_the_longest_way_in_any_broadphase),
        cmocka_unit_test(long_motion_passes_over_bodies_that_were_woken),
        cmocka_unit_test(shapes_at_opposite_ends_of_the_world_have_no_contacts),
        cmocka_unit_test(flat_line_stops_what_is_at_the_other_end_of_the_world),
        cmocka_unit_test(body_that_leaves_the_range_of_positions_comes_in_at_the_other_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
