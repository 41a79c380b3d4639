/* test_oracle_contacts.c: compares the contacts of the reference simulation with depths that are
 * computed independently (tests/measure/depth.c), and tests its linear solver. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "oracle_support.h"
#include "random.h"
#include "sim/skyline.h"
#include "touch.h"

enum { SHAPES = 20000 };

static depth_shape random_shape(scene_random *random, double spread) {
    bool circle = scene_random_range(random, 0, 1) < 0.4;
    double angle = scene_random_range(random, -3, 3);
    return (depth_shape){
        .circle = circle,
        .x = scene_random_range(random, -spread, spread),
        .y = scene_random_range(random, -spread, spread),
        .cosine = cos(angle),
        .sine = sin(angle),
        .hx = scene_random_range(random, 0.2, 1),
        .hy = circle ? 0 : scene_random_range(random, 0.2, 1),
    };
}

static double deepest(const touch_point *points, int count) {
    double gap = HUGE_VAL;
    for (int i = 0; i < count; i++)
        gap = fmin(gap, points[i].gap);
    return -gap;
}

/* Clipping may miss the deepest corner if it is beside the reference face, but never reports more
 * than the depth. */
static void touch_random_pair_is_as_deep_as_its_depth(void **state) {
    (void)state;
    scene_random random = {21};
    int overlapping = 0, exact = 0;
    for (int i = 0; i < SHAPES; i++) {
        depth_shape a = random_shape(&random, 1.2), b = random_shape(&random, 1.2);
        touch_point points[2];
        touch_axis axis;
        int count = touch_pair(&a, &b, 0, points, &axis);
        double depth = depth_of_pair(&a, &b);
        assert_near(axis.separation, -depth, a.circle || b.circle ? 1e-12 : 1e-8);
        assert_int_equal(count > 0, depth > 0);
        if (count == 0)
            continue;
        overlapping++;
        exact += fabs(deepest(points, count) - depth) < 1e-8;
        assert_true(deepest(points, count) < depth + 1e-8);
        assert_near(hypot(points[0].normal_x, points[0].normal_y), 1, 1e-12);
        /* The normal points from a to b: b moved by the depth along it just touches. */
        b.x += depth * axis.normal_x;
        b.y += depth * axis.normal_y;
        assert_near(depth_of_pair(&a, &b), 0, 1e-8);
    }
    assert_true(overlapping > SHAPES / 4);
    assert_true(exact > 0.95 * overlapping);
}

static void touch_exchanged_pair_gives_same_points_and_opposite_normals(void **state) {
    (void)state;
    scene_random random = {22};
    for (int i = 0; i < SHAPES; i++) {
        depth_shape a = random_shape(&random, 1.2), b = random_shape(&random, 1.2);
        touch_point one[2], other[2];
        int count = touch_pair(&a, &b, 0.1, one, NULL);
        assert_int_equal(touch_pair(&b, &a, 0.1, other, NULL), count);
        for (int p = 0; p < count; p++) {
            assert_near(one[p].x, other[p].x, 1e-12);
            assert_near(one[p].y, other[p].y, 1e-12);
            assert_near(one[p].gap, other[p].gap, 1e-12);
            assert_near(one[p].normal_x, -other[p].normal_x, 1e-12);
            assert_near(one[p].normal_y, -other[p].normal_y, 1e-12);
        }
    }
}

enum { POINTS = 60 };

/* A line with slopes of up to 60 degrees. */
static depth_ground random_ground(scene_random *random, scene_point line[POINTS]) {
    for (int i = 0; i < POINTS; i++)
        line[i] = (scene_point){0.5 * i + scene_random_range(random, 0, 0.2),
                                scene_random_range(random, 0, 0.6)};
    return (depth_ground){line, POINTS};
}

static void touch_ball_on_random_ground_is_as_deep_as_its_depth(void **state) {
    (void)state;
    scene_random random = {23};
    scene_point line[POINTS];
    depth_ground ground = random_ground(&random, line);
    int touching = 0;
    for (int i = 0; i < SHAPES; i++) {
        depth_shape ball = {.circle = true,
                            .x = scene_random_range(&random, 2, 27),
                            .y = scene_random_range(&random, 0, 2),
                            .cosine = 1,
                            .hx = scene_random_range(&random, 0.1, 0.6)};
        touch_point points[TOUCH_GROUND_POINTS];
        int count = touch_ground(&ground, &ball, 0, points);
        double depth = depth_in_ground(&ground, &ball);
        if (depth >= ball.hx)
            continue; /* the centre is below the ground */
        assert_int_equal(count > 0, depth > 0);
        touching += count > 0;
        if (count > 0)
            assert_near(deepest(points, count), depth, 1e-12);
    }
    assert_true(touching > SHAPES / 10);
}

/* Each overlap is found. The depth depends on how it is measured, by much only for boxes with a
 * vertex near a corner, which can be separated in several directions. */
static void touch_box_on_random_ground_is_found_where_it_has_entered(void **state) {
    (void)state;
    scene_random random = {25};
    scene_point line[POINTS];
    depth_ground ground = random_ground(&random, line);
    int touching = 0, deeper = 0;
    for (int i = 0; i < 10 * SHAPES; i++) {
        depth_shape box = random_shape(&random, 0);
        box.circle = false;
        box.hy = fmax(box.hy, 0.2);
        box.x = scene_random_range(&random, 2, 27);
        box.y = scene_random_range(&random, 0.5, 2);
        double depth = depth_in_ground(&ground, &box);
        touch_point points[TOUCH_GROUND_POINTS];
        int count = touch_ground(&ground, &box, 0, points);
        if (depth <= 0)
            assert_int_equal(count, 0);
        if (depth <= 1e-6 || depth > 0.02)
            continue;
        touching++;
        if (!count)
            fail_msg("%.17g box %.17g %.17g %.17g %.17g %.17g %.17g", depth, box.x, box.y,
                     box.cosine, box.sine, box.hx, box.hy);
        assert_true(deepest(points, count) > 0.3 * depth);
        deeper += deepest(points, count) > 3 * depth;
    }
    assert_true(touching > 500);
    assert_true(deeper < touching / 100);
}

/* On a straight line cut into segments a box has as many contacts as on one segment, all with
 * vertical normals. */
static void touch_along_straight_line_has_no_contact_with_hidden_ends(void **state) {
    (void)state;
    scene_point line[11];
    for (int i = 0; i < 11; i++)
        line[i] = (scene_point){i, 0};
    depth_ground ground = {line, 11};
    for (int i = 0; i < 1000; i++) {
        double x = 2 + 0.005 * i;
        depth_shape box = {false, x, 0.499, 1, 0, 0.75, 0.5};
        depth_shape ball = {true, x, 0.499, 1, 0, 0.5, 0};
        touch_point points[TOUCH_GROUND_POINTS];
        assert_int_equal(touch_ground(&ground, &ball, 0.01, points), 1);
        assert_near(points[0].normal_y, 1, 0);
        assert_int_equal(touch_ground(&ground, &box, 0.01, points), 2);
        for (int p = 0; p < 2; p++) {
            assert_near(points[p].normal_y, 1, 0);
            assert_near(points[p].gap, -1e-3, 1e-12);
        }
    }
}

/* A ridge of two slopes of 45 degrees under the middle of an upright box. */
static void touch_box_on_ridge_is_touched_by_the_vertex(void **state) {
    (void)state;
    const scene_point line[] = {{-2, -2}, {0, 0}, {2, -2}};
    depth_ground ground = {line, 3};
    depth_shape box = {false, 0.25, 0.49, 1, 0, 1, 0.5};
    touch_point points[TOUCH_GROUND_POINTS];
    assert_int_equal(touch_ground(&ground, &box, 0, points), 1);
    assert_near(points[0].normal_y, 1, 1e-12);
    assert_near(points[0].x, 0, 1e-12);
    assert_near(points[0].gap, -0.01, 1e-12);
}

/* A corner below the vertex of a valley with two slopes of 1/2: its foot is on neither segment. */
static void touch_corner_below_a_valley_is_pushed_by_both_slopes(void **state) {
    (void)state;
    const scene_point line[] = {{-2, 1}, {0, 0}, {2, 1}};
    depth_ground ground = {line, 3};
    depth_shape box = {false, 0, sqrt(0.5) - 0.01, sqrt(0.5), sqrt(0.5), 0.5, 0.5};
    touch_point points[TOUCH_GROUND_POINTS];
    assert_int_equal(touch_ground(&ground, &box, 0, points), 2);
    for (int i = 0; i < 2; i++) {
        assert_near(points[i].gap, -0.01 * 2 / sqrt(5), 1e-12);
        assert_near(points[i].normal_x, (i == 0 ? 1 : -1) / sqrt(5), 1e-12);
    }
}

/* A peak of 53 degrees whose tip is inside a box beside it: the contact is with the box's nearest
 * face, whose normal is close to that of the far slope. */
static void touch_sharp_peak_inside_a_box_is_pushed_out_of_its_nearest_face(void **state) {
    (void)state;
    const scene_point line[] = {{-2, -4}, {0, 0}, {2, -4}};
    depth_ground ground = {line, 3};
    const double c = cos(0.3), s = sin(0.3); /* the normal of the slope is at 0.46 rad */
    depth_shape box = {false, 0.49 * c, 0.49 * s, c, s, 0.5, 0.1};
    touch_point points[TOUCH_GROUND_POINTS];
    int count = touch_ground(&ground, &box, 0, points), tips = 0;
    for (int i = 0; i < count; i++) {
        if (fabs(points[i].gap + 0.01) > 1e-12)
            continue;
        tips++;
        assert_near(points[i].normal_x, c, 1e-12);
        assert_near(points[i].normal_y, s, 1e-12);
    }
    assert_int_equal(tips, 1);
}

/* A random diagonally dominant matrix with a random profile. */
static void skyline_solution_of_ragged_matrix_gives_right_side_back(void **state) {
    (void)state;
    enum { N = 40 };
    scene_random random = {24};
    double full[N][N] = {{0}}, x[N], right[N];
    skyline a;
    assert_true(skyline_init(&a, N));
    a.size = N;
    for (int i = 0; i < N; i++)
        a.first[i] = i - i * 7 % 5 < 0 ? 0 : i - i * 7 % 5;
    skyline_clear(&a);
    for (int i = 0; i < N; i++)
        for (int j = a.first[i]; j <= i; j++) {
            full[i][j] = scene_random_range(&random, -1, 1) + (i == j ? 8 : 0);
            skyline_add(&a, i, j, full[i][j]);
            if (i != j) {
                full[j][i] = scene_random_range(&random, -1, 1);
                skyline_add(&a, j, i, full[j][i]);
            }
        }
    for (int i = 0; i < N; i++)
        x[i] = right[i] = scene_random_range(&random, -1, 1);
    assert_true(skyline_factor(&a));
    skyline_solve(&a, x);
    for (int i = 0; i < N; i++) {
        double sum = 0;
        for (int j = 0; j < N; j++)
            sum += full[i][j] * x[j];
        assert_near(sum, right[i], 1e-13);
    }
    skyline_free(&a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(touch_random_pair_is_as_deep_as_its_depth),
        cmocka_unit_test(touch_exchanged_pair_gives_same_points_and_opposite_normals),
        cmocka_unit_test(touch_ball_on_random_ground_is_as_deep_as_its_depth),
        cmocka_unit_test(touch_box_on_random_ground_is_found_where_it_has_entered),
        cmocka_unit_test(touch_along_straight_line_has_no_contact_with_hidden_ends),
        cmocka_unit_test(touch_box_on_ridge_is_touched_by_the_vertex),
        cmocka_unit_test(touch_corner_below_a_valley_is_pushed_by_both_slopes),
        cmocka_unit_test(touch_sharp_peak_inside_a_box_is_pushed_out_of_its_nearest_face),
        cmocka_unit_test(skyline_solution_of_ragged_matrix_gives_right_side_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
