/* test_debug_draw.c: what thud_world_draw gives to its callbacks, counted in small worlds whose
 * drawings are known. */
#include "engine_support.h"

/* What a drawing called back with, by style. */
typedef struct seen {
    int circles[THUD_STYLE_COUNT], boxes[THUD_STYLE_COUNT];
    int lines[THUD_STYLE_COUNT], points[THUD_STYLE_COUNT];
    thud_vec2 from[64], to[64]; /* ends of the lines of all styles */
    int line_count;
    float greatest; /* the greatest x of all circles */
} seen;

static void on_circle(thud_vec2 center, float radius, float c, float s, thud_style style,
                      int island, void *context) {
    seen *k = context;
    (void)c, (void)s, (void)island;
    k->circles[style]++;
    k->greatest = fmaxf(k->greatest, center.x + radius);
}

static void on_box(thud_vec2 center, thud_vec2 half, float c, float s, thud_style style, int island,
                   void *context) {
    (void)center, (void)half, (void)c, (void)s, (void)island;
    ((seen *)context)->boxes[style]++;
}

static void on_line(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    seen *k = context;
    k->lines[style]++;
    if (k->line_count < 64) {
        k->from[k->line_count] = a;
        k->to[k->line_count++] = b;
    }
}

static void on_point(thud_vec2 p, thud_style style, void *context) {
    (void)p;
    ((seen *)context)->points[style]++;
}

/* All flags; THUD_DRAW_JOINT_FORCES is the highest. */
static const unsigned EVERYTHING = THUD_DRAW_JOINT_FORCES * 2 - 1;

static thud_debug_draw drawing_of(unsigned flags, seen *k) {
    return (thud_debug_draw){.flags = flags,
                             .lower = {-20, -10},
                             .upper = {20, 10},
                             .context = k,
                             .circle = on_circle,
                             .box = on_box,
                             .line = on_line,
                             .point = on_point};
}

static seen draw(thud_world *world, unsigned flags) {
    seen k = {0};
    thud_debug_draw d = drawing_of(flags, &k);
    OK(thud_world_draw(world, &d));
    return k;
}

static thud_world *world_with(const thud_broadphase *broadphase) {
    thud_world_def def = weightless();
    def.broadphase = broadphase;
    return make_world(def);
}

static thud_body_id add_moving(thud_world *world, thud_body_id body, float vx, float turn) {
    OK(thud_body_set_velocity(world, body, (thud_vec2){vx, 0}, turn));
    return body;
}

/* The motion of a ball is drawn as its circles before and after the step and the two tangents
 * between them; short motions are left out. */
static void motions_of_a_fast_ball_are_two_circles_and_two_tangents(void **state) {
    (void)state;
    thud_world *world = world_with(NULL);
    add_moving(world, add_ball(world, 0, 0, 0.5f), 60, 0); /* 1 m a step */
    /* 0.1 m a step, less than a quarter of its extent: not drawn */
    add_moving(world, add_ball(world, 0, 5, 0.5f), 6, 0);
    assert_int_equal(draw(world, THUD_DRAW_MOTIONS).circles[THUD_STYLE_MOTION], 0);
    run(world, 1);
    seen k = draw(world, THUD_DRAW_MOTIONS);
    assert_int_equal(k.circles[THUD_STYLE_MOTION], 2);
    assert_int_equal(k.lines[THUD_STYLE_MOTION], 2);
    near_to(k.greatest, 1.5, 1e-5);
    for (int i = 0; i < 2; i++) {
        near_to(k.from[i].x, 0, 1e-5);
        near_to(k.to[i].x, 1, 1e-5);
        near_to(k.from[i].y, i ? 0.5 : -0.5, 1e-5);
        near_to(k.to[i].y, k.from[i].y, 1e-5);
    }
    thud_world_destroy(world);
}

/* The corners of a box at (x, 0). */
static void corners_of(double x, double angle, double hx, double hy, thud_pos out[4]) {
    double c = cos(angle), s = sin(angle);
    for (int i = 0; i < 4; i++) {
        double u = i & 1 ? hx : -hx, v = i & 2 ? hy : -hy;
        out[i] = (thud_pos){x + c * u - s * v, s * u + c * v};
    }
}

/* Asserts that a line goes from a corner of the first box to one of the second, with all eight
 * corners on one side. */
static void is_side_of_hull(thud_vec2 from, thud_vec2 to, const thud_pos corners[8]) {
    double dx = to.x - from.x, dy = to.y - from.y, least = 1, most = -1;
    int ends[2] = {0, 0};
    for (int i = 0; i < 8; i++) {
        double x = corners[i].x - from.x, y = corners[i].y - from.y;
        double side = (dx * y - dy * x) / hypot(dx, dy);
        least = fmin(least, side);
        most = fmax(most, side);
        ends[i / 4] += hypot(x, y) < 1e-5 || hypot(x - dx, y - dy) < 1e-5;
    }
    assert_true(least > -1e-5 || most < 1e-5);
    assert_int_equal(ends[0], 1);
    assert_int_equal(ends[1], 1);
}

/* The motion of a box is drawn as the boxes before and after the step, joined by sides of their
 * convex hull. */
static void motions_of_a_box_are_joined_by_the_sides_of_its_hull(void **state) {
    (void)state;
    const float turns[] = {0, 30, -45, 94.2477f}, sizes[] = {0.2f, 0.6f};
    for (int i = 0; i < 8; i++) {
        thud_world *world = world_with(NULL);
        float hy = sizes[i / 4];
        thud_body_id box = add_box(world, 0, 0, 0.6f, hy);
        add_moving(world, box, 60, turns[i % 4]);
        run(world, 1);
        seen k = draw(world, THUD_DRAW_MOTIONS);
        thud_body_state end = state_of(world, box);
        thud_pos corners[8];
        corners_of(0, 0, 0.6, hy, corners);
        corners_of(end.position.x, end.angle, 0.6, hy, corners + 4);
        assert_int_equal(k.boxes[THUD_STYLE_MOTION], 2);
        assert_true(k.line_count >= 2 && k.lines[THUD_STYLE_MOTION] == k.line_count);
        for (int line = 0; line < k.line_count; line++) {
            is_side_of_hull(k.from[line], k.to[line], corners);
        }
        if (turns[i % 4] == 0) {
            assert_int_equal(k.line_count, 2);
        }
        thud_world_destroy(world);
    }
}

static void motions_out_of_sight_are_not_drawn(void **state) {
    (void)state;
    thud_world *world = world_with(NULL);
    add_moving(world, add_ball(world, 50, 0, 0.5f), 60, 0);
    run(world, 1);
    seen k = draw(world, THUD_DRAW_MOTIONS);
    assert_int_equal(k.circles[THUD_STYLE_MOTION] + k.lines[THUD_STYLE_MOTION], 0);
    thud_world_destroy(world);
}

/* Adds two balls above each other, one to the right, and one out of the view. */
static void add_four(thud_world *world) {
    add_ball(world, 0, 0, 0.5f);
    add_ball(world, 0.3, 5, 0.5f);
    add_ball(world, 5, 0, 0.5f);
    add_ball(world, 50, 0, 0.5f);
}

/* The sweep broadphase's intervals are drawn at the lower edge of the view: overlapping ones in
 * different rows, each as wide as its shape's bounds. */
static void axes_of_a_plane_sweep_are_bars_in_rows_at_the_lower_edge(void **state) {
    (void)state;
    thud_world *world = world_with(&thud_broadphase_sweep);
    add_four(world);
    run(world, 1);
    seen k = draw(world, THUD_DRAW_AXES);
    assert_int_equal(k.lines[THUD_STYLE_INTERVAL_OVERLAPPING], 2);
    assert_int_equal(k.lines[THUD_STYLE_INTERVAL], 1);
    assert_true(k.from[0].y > -10 && k.from[1].y > k.from[0].y && k.to[1].y < -8);
    near_to(k.from[2].y, k.from[0].y, 1e-6);
    near_to(0.5 * (k.from[1].x + k.to[1].x), 0.3, 1e-3);
    for (int i = 0; i < 3; i++) { /* as wide as the ball and its margin */
        assert_true(k.to[i].x - k.from[i].x >= 1 && k.to[i].x - k.from[i].x < 1.4);
        assert_true(k.from[i].y == k.to[i].y);
    }
    thud_world_destroy(world);
}

/* Intervals of static shapes are drawn above those of awake shapes. */
static void axes_of_resting_shapes_stand_above_those_of_awake_ones(void **state) {
    (void)state;
    thud_world *world = world_with(&thud_broadphase_sweep);
    add_ball(world, 0, 0, 0.5f);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 8, 0, 0);
    add_shape(world, wall, 0.5f, 3, true, NULL);
    run(world, 1);
    seen k = draw(world, THUD_DRAW_AXES);
    assert_int_equal(k.lines[THUD_STYLE_INTERVAL], 2);
    assert_true(k.from[1].y > k.from[0].y && k.from[1].x > 7);
    thud_world_destroy(world);
}

static void cells_and_axes_are_drawn_only_of_the_broadphase_that_has_them(void **state) {
    (void)state;
    const thud_broadphase *kinds[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                      &thud_broadphase_all};
    for (int i = 0; i < 3; i++) {
        thud_world *world = world_with(kinds[i]);
        add_four(world);
        run(world, 1);
        seen k = draw(world, THUD_DRAW_CELLS | THUD_DRAW_AXES);
        int bars = k.lines[THUD_STYLE_INTERVAL] + k.lines[THUD_STYLE_INTERVAL_OVERLAPPING];
        assert_int_equal(k.boxes[THUD_STYLE_CELL], i == 0 ? 4 : 0);
        assert_int_equal(bars, i == 1 ? 3 : 0);
        thud_world_destroy(world);
    }
}

/* Cells far apart are stored by their hash, and some have the same one. */
static void cells_of_scattered_shapes_are_drawn_each(void **state) {
    (void)state;
    thud_world *world = world_with(NULL);
    uint64_t seed = 7;
    for (int i = 0; i < 200; i++) {
        double x = (i % 20 - 10) * 1.9, y = (i / 20 - 5) * 1.9; /* each in a cell of its own */
        add_ball(world, x + random_in(&seed, 0, 0.1), y, 0.02f);
    }
    run(world, 1);
    seen k = draw(world, THUD_DRAW_CELLS);
    assert_int_equal(k.boxes[THUD_STYLE_CELL], 200);
    thud_world_destroy(world);
}

/* One pair whose bounds overlap but not its circles, one that touches, and one apart. */
static void pairs_are_lines_between_centers_and_tell_who_touches(void **state) {
    (void)state;
    thud_world *world = world_with(NULL);
    add_ball(world, 0, 0, 0.5f);
    add_ball(world, 0.9, 0.9, 0.5f);
    add_ball(world, 5, 0, 0.5f);
    add_ball(world, 5.95, 0, 0.5f);
    add_ball(world, 12, 0, 0.5f);
    run(world, 1);
    seen k = draw(world, THUD_DRAW_PAIRS);
    assert_int_equal(k.lines[THUD_STYLE_PAIR], 1);
    assert_int_equal(k.lines[THUD_STYLE_PAIR_TOUCHING], 1);
    for (int i = 0; i < 2; i++) {
        bool touching = k.from[i].x > 2 || k.to[i].x > 2;
        near_to(k.from[i].x + k.to[i].x, touching ? 10.95 : 0.9, 0.01);
        near_to(k.from[i].y + k.to[i].y, touching ? 0 : 0.9, 1e-5);
    }
    thud_world_destroy(world);
}

static void pairs_with_the_ground_go_straight_down_to_it(void **state) {
    (void)state;
    thud_world *world = world_with(NULL);
    thud_pos points[] = {{-10, 1}, {0, 1}, {10, 1}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 3};
    thud_shape_def def = thud_default_shape_def();
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, -2, 0);
    OK(thud_shape_create_terrain(world, ground, &def, &line, NULL));
    add_ball(world, 4, -0.5, 0.5f); /* on the terrain, which is at -1 */
    run(world, 1);
    seen k = draw(world, THUD_DRAW_PAIRS);
    assert_int_equal(k.line_count, 1);
    assert_int_equal(k.lines[THUD_STYLE_PAIR_TOUCHING], 1);
    near_to(k.from[0].x, 4, 1e-5);
    near_to(k.from[0].y, -1, 1e-5);
    near_to(k.to[0].y, -0.5, 1e-2);
    thud_world_destroy(world);
}

static bool veto(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                 void *context) {
    (void)world, (void)contact, (void)settings, (void)context;
    return false;
}

/* A box that hangs over the edge of a floor touches it aside of its centre. */
static void contacts_are_drawn_unless_a_prologue_vetoes_them(void **state) {
    (void)state;
    for (int vetoed = 0; vetoed < 2; vetoed++) {
        thud_world *world = world_with(NULL);
        thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        add_shape(world, ground, 2, 0.5f, false, NULL);
        add_box(world, 1.8, 1, 0.5f, 0.5f);
        thud_listeners listeners = {.prologue = vetoed ? veto : NULL};
        OK(thud_world_set_listeners(world, &listeners));
        run(world, 1);
        seen k = draw(world, THUD_DRAW_CONTACTS);
        assert_int_equal(k.points[THUD_STYLE_CONTACT], vetoed ? 0 : 1);
        assert_int_equal(k.lines[THUD_STYLE_NORMAL], vetoed ? 0 : 1);
        if (!vetoed) {
            near_to(k.from[0].x, 1.65, 1e-3); /* the middle of 1.3 .. 2 */
            near_to(k.from[0].y, 0.5, 1e-2);
        }
        thud_world_destroy(world);
    }
}

static void null_callbacks_are_skipped_and_no_flag_draws_nothing(void **state) {
    (void)state;
    const thud_broadphase *kinds[] = {&thud_broadphase_grid, &thud_broadphase_sweep};
    for (int i = 0; i < 2; i++) {
        thud_world *world = world_with(kinds[i]);
        thud_debug_draw silent = {.flags = EVERYTHING, .lower = {-20, -10}, .upper = {20, 10}};
        add_four(world);
        add_ball(world, 0.2, 0, 0.5f);
        add_moving(world, add_box(world, 3, 3, 0.5f, 0.5f), 100, 5);
        run(world, 1);
        OK(thud_world_draw(world, &silent));
        silent.flags = ~0u;
        OK(thud_world_draw(world, &silent));
        seen none = {0}, k = draw(world, ~EVERYTHING);
        assert_memory_equal(&k, &none, sizeof none);
        thud_world_destroy(world);
    }
}

static void draw_refuses_null_and_places_out_of_range(void **state) {
    (void)state;
    thud_world *world = world_with(NULL);
    seen k = {0};
    thud_debug_draw d = drawing_of(EVERYTHING, &k);
    assert_int_equal(thud_world_draw(NULL, &d), THUD_ERROR_NULL);
    assert_int_equal(thud_world_draw(world, NULL), THUD_ERROR_NULL);
    d.lower.x = NAN;
    assert_int_equal(thud_world_draw(world, &d), THUD_ERROR_INVALID);
    d.lower.x = -1e12;
    assert_int_equal(thud_world_draw(world, &d), THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(motions_of_a_fast_ball_are_two_circles_and_two_tangents),
        cmocka_unit_test(motions_of_a_box_are_joined_by_the_sides_of_its_hull),
        cmocka_unit_test(motions_out_of_sight_are_not_drawn),
        cmocka_unit_test(axes_of_a_plane_sweep_are_bars_in_rows_at_the_lower_edge),
        cmocka_unit_test(axes_of_resting_shapes_stand_above_those_of_awake_ones),
        cmocka_unit_test(cells_and_axes_are_drawn_only_of_the_broadphase_that_has_them),
        cmocka_unit_test(cells_of_scattered_shapes_are_drawn_each),
        cmocka_unit_test(pairs_are_lines_between_centers_and_tell_who_touches),
        cmocka_unit_test(pairs_with_the_ground_go_straight_down_to_it),
        cmocka_unit_test(contacts_are_drawn_unless_a_prologue_vetoes_them),
        cmocka_unit_test(null_callbacks_are_skipped_and_no_flag_draws_nothing),
        cmocka_unit_test(draw_refuses_null_and_places_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
