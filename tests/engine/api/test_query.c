/* test_query.c: ray casts, overlaps, interpolated poses, and stepping by elapsed time. */
#include "engine_support.h"

static void ray_finds_the_first_shape_of_many(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    uint64_t seed = 12;
    thud_body_id ids[200];
    double x[200], y[200], r[200];
    for (int i = 0; i < 200; i++) {
        x[i] = random_in(&seed, -20, 20);
        y[i] = random_in(&seed, -20, 20);
        r[i] = (double)(float)random_in(&seed, 0.1, 1);
        ids[i] = add_body(world, i % 2 ? THUD_BODY_STATIC : THUD_BODY_DYNAMIC, x[i], y[i], 0);
        add_shape(world, ids[i], (float)r[i], 0, false, NULL);
    }
    for (int k = 0; k < 300; k++) {
        double ox = random_in(&seed, -30, 30), oy = random_in(&seed, -30, 30);
        double dx = random_in(&seed, -50, 50), dy = random_in(&seed, -50, 50);
        double best = 2;
        int first = -1;
        for (int i = 0; i < 200; i++) {
            double a = dx * dx + dy * dy, px = ox - x[i], py = oy - y[i];
            double b = px * dx + py * dy, c = px * px + py * py - r[i] * r[i];
            double root = b * b - a * c, t = root < 0 ? 3 : (-b - sqrt(root)) / a;
            if (c >= 0 && t >= 0 && t <= 1 && t < best) {
                best = t;
                first = i;
            }
        }
        bool hit;
        thud_ray_hit found;
        OK(thud_world_cast_ray(world, &(thud_ray){(thud_pos){ox, oy}, dx, dy, NULL}, &hit, &found));
        assert_int_equal(hit, first >= 0);
        if (hit) {
            thud_shape_state shape;
            OK(thud_shape_get_state(world, found.shape, &shape));
            assert_int_equal(shape.body.index1, ids[first].index1);
            near_to(found.fraction, best, 1e-6);
            near_to(hypot((double)found.normal.x, (double)found.normal.y), 1, 1e-5);
        }
    }
    thud_world_destroy(world);
}

static void ray_meets_the_ground_and_heeds_filters(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    def.filter.category = 4;
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, -2, 0);
    OK(thud_shape_create_terrain(world, ground, &def, &flat, NULL));
    bool hit;
    thud_ray_hit found;
    OK(thud_world_cast_ray(world, &(thud_ray){(thud_pos){0, 8}, 0, -20, NULL}, &hit, &found));
    assert_true(hit);
    near_to(found.point.y, -2, 1e-9);
    near_to((double)found.normal.y, 1, 1e-9);
    thud_query_filter others = thud_default_query_filter();
    others.mask = 1;
    OK(thud_world_cast_ray(world, &(thud_ray){(thud_pos){0, 8}, 0, -20, &others}, &hit, &found));
    assert_false(hit);
    thud_world_destroy(world);
}

/* An overlap's callback: notes up to three shapes in an array behind their count, then stops. */
static bool gather(thud_shape_id shape, void *context) {
    int *count = context;
    count[++*count] = (int)shape.index1;
    return *count < 3;
}

/* An overlap reports shapes in the order of their slots until the callback returns false. */
static void overlap_tells_in_order_of_slots_until_told_to_stop(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    for (int i = 0; i < 6; i++) {
        add_ball(world, 5.0 - i, 0, 0.4f);
    }
    int found[8] = {0};
    OK(thud_world_overlap_aabb(world, (thud_pos){0.5, -1}, (thud_pos){3.5, 1}, NULL, gather,
                               found));
    assert_int_equal(found[0], 3);
    assert_true(found[1] == 3 && found[2] == 4 && found[3] == 5);
    int one[8] = {0};
    thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 0.2};
    OK(thud_world_overlap_shape(world, (thud_pos){4, 0.5}, disc, NULL, gather, one));
    assert_int_equal(one[0], 1);
    assert_int_equal(one[1], 2);
    thud_world_destroy(world);
}

static void poses_interpolate_and_mark_free_slots(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id gone = add_ball(world, 0, 0, 1), ball = add_ball(world, 10, 0, 1);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){6, 0}, 3));
    OK(thud_body_destroy(world, gone));
    run(world, 10);
    int count;
    const thud_pose *poses = thud_poses_of(world, (thud_pos){10, 0}, 1, &count);
    assert_int_equal(count, 2);
    assert_true(isnan(poses[gone.index1 - 1].x));
    near_to((double)poses[ball.index1 - 1].x, 1, 1e-5);
    near_to((double)poses[ball.index1 - 1].s, sin(0.5), 1e-5);
    poses = thud_poses_of(world, (thud_pos){10, 0}, 0.5, &count);
    near_to((double)poses[ball.index1 - 1].x, 0.95, 1e-5);
    near_to((double)poses[ball.index1 - 1].s, sin(0.475), 1e-5);
    assert_null(thud_poses_of(world, (thud_pos){NAN, 0}, 0.5, &count));
    thud_world_destroy(world);
}

static void advance_runs_whole_steps_and_keeps_the_rest(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    int steps;
    double alpha;
    OK(thud_world_advance(world, 2.5 / 60, 10, &steps, &alpha));
    assert_int_equal(steps, 2);
    near_to(alpha, 0.5, 1e-9);
    OK(thud_world_advance(world, 0.6 / 60, 10, &steps, &alpha));
    assert_int_equal(steps, 1);
    near_to(alpha, 0.1, 1e-9);
    OK(thud_world_advance(world, 100, 4, &steps, &alpha));
    assert_int_equal(steps, 4);
    assert_true(alpha >= 0 && alpha < 1);
    assert_int_equal(thud_stats_of(world).steps, 7);
    thud_world_destroy(world);
}

/* A box that sleeps on a terrain is lifted with it by thud_shape_set_heights. */
static void raised_ground_lifts_what_rests_on_it(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def def = thud_default_shape_def();
    thud_pos points[5] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
    thud_terrain line = {
        .kind = THUD_TERRAIN_UNIFORM, .x0 = -4, .spacing = 2, .points = points, .count = 5};
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_id shape;
    OK(thud_shape_create_terrain(world, ground, &def, &line, &shape));
    thud_body_id box = add_box(world, 0, 0.5, 0.5f, 0.5f);
    run(world, 120);
    assert_false(state_of(world, box).awake);
    double up[5] = {0.3, 0.3, 0.3, 0.3, 0.3};
    assert_int_equal(thud_shape_set_heights(world, shape, 2, up, 4), THUD_ERROR_INVALID);
    OK(thud_shape_set_heights(world, shape, 0, up, 5));
    run(world, 120);
    near_to(state_of(world, box).position.y, 0.8, 0.01);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ray_finds_the_first_shape_of_many),
        cmocka_unit_test(ray_meets_the_ground_and_heeds_filters),
        cmocka_unit_test(overlap_tells_in_order_of_slots_until_told_to_stop),
        cmocka_unit_test(poses_interpolate_and_mark_free_slots),
        cmocka_unit_test(advance_runs_whole_steps_and_keeps_the_rest),
        cmocka_unit_test(raised_ground_lifts_what_rests_on_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
