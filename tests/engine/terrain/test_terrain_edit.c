/* test_terrain_edit.c: the vertices of a terrain after digging, raising and replacing a range. */
#include "terrain_support.h"

static void dig_in_uniform_ground_puts_vertices_on_the_arc(void **state) {
    (void)state;
    ground g = level_ground(THUD_TERRAIN_UNIFORM, thud_default_world_def());
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){0.2, 0.5}, 1.5));
    thud_terrain line = line_of(&g);
    assert_int_equal(line.count, 201);
    for (int i = 0; i < line.count; i++) {
        double u = (line.points[i].x - 0.2) / 1.5;
        double arc = fabs(u) < 1 ? 0.5 - 1.5 * sqrt(1 - u * u) : 0;
        near_to(line.points[i].y, fmin(arc, 0), 1e-9);
    }
    thud_world_destroy(g.world);
}

/* Hills with slopes below 1, on vertices at random places. */
static ground hills(uint64_t *seed) {
    thud_pos points[120];
    double x = -30;
    for (int i = 0; i < 120; i++) {
        points[i] = (thud_pos){x, 2 * sin(0.3 * x) + 0.2 * sin(1.7 * x)};
        x += random_in(seed, 0.1, 0.9);
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 120};
    ground g = {.world = make_world(thud_default_world_def())};
    g.body = add_body(g.world, THUD_BODY_STATIC, 0, 0, 0);
    g.shape = add_terrain(g.world, g.body, &line);
    return g;
}

static void dig_in_irregular_ground_follows_the_circle_and_leaves_the_rest(void **state) {
    (void)state;
    uint64_t seed = 3;
    thud_pos points[POINTS_MAX];
    for (int k = 0; k < 200; k++) {
        ground g = hills(&seed);
        thud_terrain old = copy_line(&g, points);
        double r = random_in(&seed, 0.3, 4), cx = random_in(&seed, -20, 20);
        double cy = height_of(&old, cx) + random_in(&seed, -0.9, 1.1) * r;
        OK(thud_shape_dig(g.world, g.shape, (thud_pos){cx, cy}, r));
        thud_terrain now = line_of(&g);
        for (int i = -150; i <= 150; i++) {
            double u = i / 100.0, before = height_of(&old, cx + u * r);
            double height = height_of(&now, cx + u * r);
            if (fabs(u) < 0.97) {
                double arc = cy - r * sqrt(1 - u * u);
                /* The chords are within 1 % of the arc, along its normal. */
                near_to(height, fmin(before, arc), 0.01 * r / sqrt(1 - u * u) + 0.02 * r);
            } else if (fabs(u) > 1.02) {
                near_to(height, before, 0.02 * r);
            }
        }
        assert_true(now.count <= old.count + 24);
        thud_world_destroy(g.world);
    }
}

static void dig_that_meets_no_ground_changes_nothing(void **state) {
    (void)state;
    thud_pos points[POINTS_MAX];
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
    ground u = level_ground(THUD_TERRAIN_UNIFORM, thud_default_world_def());
    thud_body_id box = add_box(g.world, 0, 0.25, 0.25f, 0.25f);
    run_to_sleep(&g);
    thud_terrain old = copy_line(&g, points);
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){0, 2.01}, 2));
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){-70, 0}, 2));
    OK(thud_shape_raise(g.world, g.shape, 0, 2, 0));
    assert_line_is(&g, &old);
    run(g.world, 1);
    assert_false(awake(&g, box));
    /* The circle lies between two vertices of the grid. */
    old = copy_line(&u, points);
    OK(thud_shape_dig(u.world, u.shape, (thud_pos){0.25, 0}, 0.2));
    assert_line_is(&u, &old);
    thud_world_destroy(g.world);
    thud_world_destroy(u.world);
}

static void dig_across_an_end_keeps_the_length_of_the_line(void **state) {
    (void)state;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){-50.3, 0}, 2));
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){50.3, 0}, 2));
    thud_terrain line = line_of(&g);
    assert_true(line.points[0].x == -50 && line.points[line.count - 1].x == 50);
    near_to(line.points[0].y, -sqrt(4 - 0.09), 1e-9);
    near_to(line.points[line.count - 1].y, -sqrt(4 - 0.09), 0.05);
    thud_world_destroy(g.world);
}

static void dig_of_the_whole_line_leaves_a_line(void **state) {
    (void)state;
    const thud_pos two[] = {{0, 0}, {1, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = two, .count = 2};
    ground g = {.world = make_world(thud_default_world_def())};
    g.body = add_body(g.world, THUD_BODY_STATIC, 0, 0, 0);
    g.shape = add_terrain(g.world, g.body, &line);
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){0.5, 0}, 900));
    line = line_of(&g);
    near_to(height_of(&line, 0.5), -900, 4.5);
    thud_world_destroy(g.world);
}

static void thousands_of_digs_keep_a_bounded_number_of_vertices(void **state) {
    (void)state;
    uint64_t seed = 9;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
    for (int i = 0; i < 4000; i++) {
        double x = random_in(&seed, -20, 20);
        if (i % 3) {
            OK(thud_shape_dig(g.world, g.shape, (thud_pos){x, height_at(&g, x)}, 1));
        } else {
            OK(thud_shape_raise(g.world, g.shape, x, 1, 1));
        }
    }
    /* the ground is 40 wide, and vertices are at least 1/60 apart */
    assert_true(line_of(&g).count < 3000);
    thud_world_destroy(g.world);
}

/* Raising adds height * (1 - u^2)^2, where u is the distance divided by the radius; a negative
 * height lowers. */
static void raise_adds_a_smooth_mound_and_a_negative_one_a_hollow(void **state) {
    (void)state;
    for (int kind = THUD_TERRAIN_UNIFORM; kind <= THUD_TERRAIN_IRREGULAR; kind++) {
        ground g = level_ground((thud_terrain_kind)kind, thud_default_world_def());
        OK(thud_shape_raise(g.world, g.shape, 10.25, 3, 1.5));
        OK(thud_shape_raise(g.world, g.shape, -10.25, 3, -1.5));
        for (int i = -150; i <= 150; i++) {
            double u = i / 100.0, v = fmax(1 - u * u, 0);
            near_to(height_at(&g, 10.25 + 3 * u), 1.5 * v * v, 0.03);
            near_to(height_at(&g, -10.25 + 3 * u), -1.5 * v * v, 0.03);
        }
        assert_true(height_at(&g, 7) == 0 && height_at(&g, 14) == 0);
        thud_world_destroy(g.world);
    }
}

static void edits_go_by_places_in_the_world_wherever_the_body_stands(void **state) {
    (void)state;
    const thud_pos points[] = {{-9, 0}, {-3, 0}, {3, 0}, {9, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
    ground here = {.world = make_world(thud_default_world_def())};
    ground there = {.world = make_world(thud_default_world_def())};
    here.body = add_body(here.world, THUD_BODY_STATIC, 0, 0, 0);
    there.body = add_body(there.world, THUD_BODY_STATIC, 1048576, -7340032, 0);
    here.shape = add_terrain(here.world, here.body, &line);
    there.shape = add_terrain(there.world, there.body, &line);
    OK(thud_shape_dig(here.world, here.shape, (thud_pos){0.5, 0.25}, 2));
    OK(thud_shape_dig(there.world, there.shape, (thud_pos){1048576.5, -7340031.75}, 2));
    thud_terrain wanted = line_of(&here);
    assert_line_is(&there, &wanted);
    thud_world_destroy(here.world);
    thud_world_destroy(there.world);
}

static void replace_range_changes_what_is_in_it_and_may_move_the_ends(void **state) {
    (void)state;
    const thud_pos points[] = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}};
    const thud_pos more[] = {{0.5, 5}, {1.5, 6}, {2.5, 7}}, beyond[] = {{7, 1}, {9, 2}};
    const thud_pos wanted[] = {{0, 0}, {0.5, 5}, {1.5, 6}, {2.5, 7}, {3, 1}};
    const thud_pos longer[] = {{0, 0}, {0.5, 5}, {1.5, 6}, {2.5, 7}, {7, 1}, {9, 2}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 5};
    ground g = {.world = make_world(thud_default_world_def())};
    g.body = add_body(g.world, THUD_BODY_STATIC, 0, 0, 0);
    g.shape = add_terrain(g.world, g.body, &line);
    OK(thud_shape_replace_range(g.world, g.shape, 0.5, 2.9, more, 3));
    OK(thud_shape_replace_range(g.world, g.shape, 4, 4, NULL, 0));
    assert_line_is(&g, &(thud_terrain){.points = wanted, .count = 5});
    OK(thud_shape_replace_range(g.world, g.shape, 3, INFINITY, beyond, 2));
    assert_line_is(&g, &(thud_terrain){.points = longer, .count = 6});
    OK(thud_shape_replace_range(g.world, g.shape, -3, 2, NULL, 0));
    assert_line_is(&g, &(thud_terrain){.points = longer + 3, .count = 3});
    thud_world_destroy(g.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dig_in_uniform_ground_puts_vertices_on_the_arc),
        cmocka_unit_test(dig_in_irregular_ground_follows_the_circle_and_leaves_the_rest),
        cmocka_unit_test(dig_that_meets_no_ground_changes_nothing),
        cmocka_unit_test(dig_across_an_end_keeps_the_length_of_the_line),
        cmocka_unit_test(dig_of_the_whole_line_leaves_a_line),
        cmocka_unit_test(thousands_of_digs_keep_a_bounded_number_of_vertices),
        cmocka_unit_test(raise_adds_a_smooth_mound_and_a_negative_one_a_hollow),
        cmocka_unit_test(edits_go_by_places_in_the_world_wherever_the_body_stands),
        cmocka_unit_test(replace_range_changes_what_is_in_it_and_may_move_the_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
