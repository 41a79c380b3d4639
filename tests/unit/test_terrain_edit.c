/* test_terrain_edit.c: digging, raising and replacing ground, and what rests on it meanwhile. */
#include "engine_support.h"

enum { ROOM = 4000 };

/* ---- ground to edit ---- */

typedef struct ground {
    thud_world *world;
    thud_body_id body;
    thud_shape_id shape;
} ground;

static thud_shape_id add_line(thud_world *world, thud_body_id body, const thud_terrain *line,
                              bool sensor)
{
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id shape;
    def.sensor = sensor;
    OK(thud_shape_create_terrain(world, body, &def, line, &shape));
    return shape;
}

/* Level ground of height 0 from -50 to 50, a vertex every half. */
static ground level_ground(thud_terrain_kind kind, thud_world_def def)
{
    thud_pos points[201];
    for (int i = 0; i < 201; i++) {
        points[i] = (thud_pos){-50 + 0.5 * i, 0};
    }
    ground g = {.world = make_world(def)};
    thud_terrain line = {.kind = kind, .x0 = -50, .spacing = 0.5, .points = points, .count = 201};
    g.body = add_body(g.world, THUD_STATIC, 0, 0, 0);
    g.shape = add_line(g.world, g.body, &line, false);
    return g;
}

static thud_terrain line_of(const ground *g)
{
    thud_terrain line;
    OK(thud_shape_terrain(g->world, g->shape, &line));
    OK(thud_terrain_check(&line));
    return line;
}

static double height_of(const thud_terrain *line, double x)
{
    thud_terrain_sample sample;
    OK(thud_terrain_sample_at(line, x, &sample));
    return sample.height;
}

static double height_at(const ground *g, double x)
{
    thud_terrain line = line_of(g);
    return height_of(&line, x);
}

/* A copy that outlives edits. */
static thud_terrain keep_line(const ground *g, thud_pos room[ROOM])
{
    thud_terrain line = line_of(g);
    assert_in_range(line.count, 2, ROOM);
    memcpy(room, line.points, (size_t)line.count * sizeof *room);
    line.points = room;
    return line;
}

static void line_is(const ground *g, const thud_terrain *wanted)
{
    thud_terrain line = line_of(g);
    assert_int_equal(line.count, wanted->count);
    assert_memory_equal(line.points, wanted->points, (size_t)line.count * sizeof *line.points);
}

static bool awake(const ground *g, thud_body_id body)
{
    return state_of(g->world, body).awake;
}

/* A pile of boxes of half extent 0.25, and the last of them. */
static thud_body_id add_stack(const ground *g, double x, int boxes)
{
    thud_body_id top = {0, 0};
    for (int i = 0; i < boxes; i++) {
        top = add_box(g->world, x, 0.25 + 0.5 * i, 0.25f, 0.25f);
    }
    return top;
}

/* So that nothing rolls off the ends. */
static void add_walls(const ground *g)
{
    add_shape(g->world, add_body(g->world, THUD_STATIC, -30, 0, 0), 1, 30, true, NULL);
    add_shape(g->world, add_body(g->world, THUD_STATIC, 30, 0, 0), 1, 30, true, NULL);
}

static void run_to_sleep(const ground *g)
{
    run(g->world, 1);
    for (int i = 0; i < 600 && thud_world_stats(g->world).awake_bodies; i++) {
        run(g->world, 1);
    }
    assert_int_equal(thud_world_stats(g->world).awake_bodies, 0);
}

/* ---- what becomes of the line ---- */

static void dig_in_uniform_ground_puts_vertices_on_the_arc(void **state)
{
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
static ground hills(uint64_t *seed)
{
    thud_pos points[120];
    double x = -30;
    for (int i = 0; i < 120; i++) {
        points[i] = (thud_pos){x, 2 * sin(0.3 * x) + 0.2 * sin(1.7 * x)};
        x += random_in(seed, 0.1, 0.9);
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 120};
    ground g = {.world = make_world(thud_default_world_def())};
    g.body = add_body(g.world, THUD_STATIC, 0, 0, 0);
    g.shape = add_line(g.world, g.body, &line, false);
    return g;
}

static void dig_in_irregular_ground_follows_the_circle_and_leaves_the_rest(void **state)
{
    (void)state;
    uint64_t seed = 3;
    thud_pos room[ROOM];
    for (int k = 0; k < 200; k++) {
        ground g = hills(&seed);
        thud_terrain old = keep_line(&g, room);
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

static void dig_that_meets_no_ground_changes_nothing(void **state)
{
    (void)state;
    thud_pos room[ROOM];
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
    ground u = level_ground(THUD_TERRAIN_UNIFORM, thud_default_world_def());
    thud_body_id box = add_box(g.world, 0, 0.25, 0.25f, 0.25f);
    run_to_sleep(&g);
    thud_terrain old = keep_line(&g, room);
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){0, 2.01}, 2));
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){-70, 0}, 2));
    OK(thud_shape_raise(g.world, g.shape, 0, 2, 0));
    line_is(&g, &old);
    run(g.world, 1);
    assert_false(awake(&g, box));
    /* Between two vertices of the grid. */
    old = keep_line(&u, room);
    OK(thud_shape_dig(u.world, u.shape, (thud_pos){0.25, 0}, 0.2));
    line_is(&u, &old);
    thud_world_destroy(g.world);
    thud_world_destroy(u.world);
}

static void dig_across_an_end_keeps_the_length_of_the_line(void **state)
{
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

static void dig_of_the_whole_line_leaves_a_line(void **state)
{
    (void)state;
    const thud_pos two[] = {{0, 0}, {1, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = two, .count = 2};
    ground g = {.world = make_world(thud_default_world_def())};
    g.body = add_body(g.world, THUD_STATIC, 0, 0, 0);
    g.shape = add_line(g.world, g.body, &line, false);
    OK(thud_shape_dig(g.world, g.shape, (thud_pos){0.5, 0}, 900));
    line = line_of(&g);
    near_to(height_of(&line, 0.5), -900, 4.5);
    thud_world_destroy(g.world);
}

static void thousands_of_digs_keep_a_bounded_number_of_vertices(void **state)
{
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
    assert_true(line_of(&g).count < 3000); /* 40 wide, none nearer than a sixtieth */
    thud_world_destroy(g.world);
}

static void raise_adds_a_smooth_mound_and_a_negative_one_a_hollow(void **state)
{
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

static void edits_go_by_places_in_the_world_wherever_the_body_stands(void **state)
{
    (void)state;
    const thud_pos points[] = {{-9, 0}, {-3, 0}, {3, 0}, {9, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
    ground here = {.world = make_world(thud_default_world_def())};
    ground there = {.world = make_world(thud_default_world_def())};
    here.body = add_body(here.world, THUD_STATIC, 0, 0, 0);
    there.body = add_body(there.world, THUD_STATIC, 1048576, -7340032, 0);
    here.shape = add_line(here.world, here.body, &line, false);
    there.shape = add_line(there.world, there.body, &line, false);
    OK(thud_shape_dig(here.world, here.shape, (thud_pos){0.5, 0.25}, 2));
    OK(thud_shape_dig(there.world, there.shape, (thud_pos){1048576.5, -7340031.75}, 2));
    thud_terrain wanted = line_of(&here);
    line_is(&there, &wanted);
    thud_world_destroy(here.world);
    thud_world_destroy(there.world);
}

static void replace_range_changes_what_is_in_it_and_may_move_the_ends(void **state)
{
    (void)state;
    const thud_pos points[] = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}};
    const thud_pos more[] = {{0.5, 5}, {1.5, 6}, {2.5, 7}}, beyond[] = {{7, 1}, {9, 2}};
    const thud_pos wanted[] = {{0, 0}, {0.5, 5}, {1.5, 6}, {2.5, 7}, {3, 1}};
    const thud_pos longer[] = {{0, 0}, {0.5, 5}, {1.5, 6}, {2.5, 7}, {7, 1}, {9, 2}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 5};
    ground g = {.world = make_world(thud_default_world_def())};
    g.body = add_body(g.world, THUD_STATIC, 0, 0, 0);
    g.shape = add_line(g.world, g.body, &line, false);
    OK(thud_shape_replace_range(g.world, g.shape, 0.5, 2.9, more, 3));
    OK(thud_shape_replace_range(g.world, g.shape, 4, 4, NULL, 0));
    line_is(&g, &(thud_terrain){.points = wanted, .count = 5});
    OK(thud_shape_replace_range(g.world, g.shape, 3, INFINITY, beyond, 2));
    line_is(&g, &(thud_terrain){.points = longer, .count = 6});
    OK(thud_shape_replace_range(g.world, g.shape, -3, 2, NULL, 0));
    line_is(&g, &(thud_terrain){.points = longer + 3, .count = 3});
    thud_world_destroy(g.world);
}

/* ---- what becomes of the bodies ---- */

static void edit_by_number(const ground *g, int which, double x)
{
    const thud_pos bumps[] = {{x - 0.9, 0.2}, {x - 0.3, -0.1}, {x, 0.1}, {x + 0.8, 0.3}};
    switch (which % 4) {
    case 0:
        OK(thud_shape_dig(g->world, g->shape, (thud_pos){x, 0.2}, 1));
        break;
    case 1:
        OK(thud_shape_raise(g->world, g->shape, x, 1, 0.5));
        break;
    case 2:
        OK(thud_shape_replace_range(g->world, g->shape, x - 1, x + 1, bumps, 4));
        break;
    default:
        OK(thud_shape_replace_range(g->world, g->shape, x - 1, x + 1, NULL, 0));
        break;
    }
}

static void sleeps_as_it_was(const ground *g, thud_body_id body, const thud_body_state *was)
{
    thud_body_state now = state_of(g->world, body);
    assert_false(now.awake);
    assert_true(now.position.x == was->position.x && now.position.y == was->position.y &&
                now.angle == was->angle);
}

static void edit_wakes_what_rests_there_and_nothing_far_away(void **state)
{
    (void)state;
    for (int which = 0; which < 4; which++) {
        ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
        thud_body_id left = add_stack(&g, -20, 5), right = add_stack(&g, 20, 5);
        thud_body_id here = add_stack(&g, 0, 3);
        run_to_sleep(&g);
        thud_body_state was_left = state_of(g.world, left), was_right = state_of(g.world, right);
        edit_by_number(&g, which, 0);
        run(g.world, 1);
        assert_true(awake(&g, here));
        assert_int_equal(thud_world_stats(g.world).awake_bodies, 3);
        run(g.world, 300);
        sleeps_as_it_was(&g, left, &was_left);
        sleeps_as_it_was(&g, right, &was_right);
        /* Their supports have the right numbers: nothing moves when they wake. */
        OK(thud_body_set_awake(g.world, right, true));
        OK(thud_body_set_awake(g.world, left, true));
        run(g.world, 60);
        near_to(state_of(g.world, left).position.y, was_left.position.y, 1e-3);
        near_to(state_of(g.world, right).position.y, was_right.position.y, 1e-3);
        thud_world_destroy(g.world);
    }
}

/* Far from an edit a running world goes on as if there were none, bit for bit. */
static void edit_of_bare_ground_does_not_touch_the_motion_elsewhere(void **state)
{
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    ground edited = level_ground(THUD_TERRAIN_IRREGULAR, def);
    ground other = level_ground(THUD_TERRAIN_IRREGULAR, def);
    for (int k = 0; k < 2; k++) {
        const ground *g = k ? &other : &edited;
        add_stack(g, -20, 8);
        add_stack(g, 20, 8);
        add_ball(g->world, 25, 3, 0.4f);
    }
    for (int i = 0; i < 120; i++) {
        if (i % 10 == 5) {
            edit_by_number(&edited, i / 10, 2.0 * (i / 10) - 12);
        }
        run(edited.world, 1);
        run(other.world, 1);
        assert_true(thud_world_hash(edited.world) == thud_world_hash(other.world));
    }
    thud_world_destroy(edited.world);
    thud_world_destroy(other.world);
}

static void ball_on_dug_ground_comes_to_rest_in_the_crater(void **state)
{
    (void)state;
    for (int kind = THUD_TERRAIN_UNIFORM; kind <= THUD_TERRAIN_IRREGULAR; kind++) {
        ground g = level_ground((thud_terrain_kind)kind, thud_default_world_def());
        thud_body_id ball = add_ball(g.world, 0, 0.3, 0.3f);
        run_to_sleep(&g);
        OK(thud_shape_dig(g.world, g.shape, (thud_pos){0.5, 0}, 2));
        run(g.world, 900);
        thud_body_state s = state_of(g.world, ball);
        assert_true(s.position.y < -1.4);
        assert_true(s.position.y - 0.3 > height_at(&g, s.position.x) - 0.02);
        thud_world_destroy(g.world);
    }
}

static void bodies_inside_raised_ground_are_pushed_out(void **state)
{
    (void)state;
    for (int kind = THUD_TERRAIN_UNIFORM; kind <= THUD_TERRAIN_IRREGULAR; kind++) {
        ground g = level_ground((thud_terrain_kind)kind, thud_default_world_def());
        thud_body_id bodies[12];
        add_walls(&g);
        for (int i = 0; i < 12; i++) {
            double x = -5.5 + i;
            bodies[i] = i % 2 ? add_ball(g.world, x, 0.3, 0.3f)
                              : add_box(g.world, x, 0.3, 0.4f, 0.3f);
        }
        run_to_sleep(&g);
        OK(thud_shape_raise(g.world, g.shape, 0, 8, 6));
        run(g.world, 900);
        thud_terrain line = line_of(&g);
        for (int i = 0; i < 12; i++) {
            thud_body_state s = state_of(g.world, bodies[i]);
            assert_true(fabs(s.position.x) < 29);
            assert_true(s.position.y - 0.25 > height_of(&line, s.position.x));
        }
        assert_true(thud_world_measure(g.world).penetration_max < 0.02);
        thud_world_destroy(g.world);
    }
}

static void raised_ground_wakes_a_body_that_did_not_touch_it(void **state)
{
    (void)state;
    ground g = level_ground(THUD_TERRAIN_UNIFORM, thud_default_world_def());
    thud_body_id shelf = add_body(g.world, THUD_STATIC, 0, 1, 0);
    add_shape(g.world, shelf, 0.5f, 0.1f, true, NULL);
    thud_body_id plank = add_box(g.world, 0, 1.2, 3, 0.1f), high = add_ball(g.world, 9, 8, 0.3f);
    thud_body_id perch = add_body(g.world, THUD_STATIC, 9, 7.6, 0);
    add_shape(g.world, perch, 0.5f, 0.1f, true, NULL);
    run_to_sleep(&g);
    OK(thud_shape_raise(g.world, g.shape, 6, 5, 4));
    run(g.world, 1);
    assert_true(awake(&g, plank));
    assert_false(awake(&g, high));
    run(g.world, 300);
    assert_true(state_of(g.world, plank).angle > 0.05);
    thud_world_destroy(g.world);
}

static void two_edits_between_steps_wake_only_their_own_places(void **state)
{
    (void)state;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
    thud_body_id left = add_stack(&g, -20, 2), middle = add_stack(&g, 0, 2);
    thud_body_id right = add_stack(&g, 20, 2);
    run_to_sleep(&g);
    double y = state_of(g.world, middle).position.y;
    for (int i = 0; i < 3; i++) {
        edit_by_number(&g, 3 - i, -20);
        edit_by_number(&g, 2 + i, 20);
    }
    run(g.world, 1);
    assert_true(awake(&g, left) && awake(&g, right) && !awake(&g, middle));
    run(g.world, 300);
    assert_true(state_of(g.world, middle).position.y == y);
    thud_world_destroy(g.world);
}

static void edit_among_sensors(const thud_broadphase *broadphase)
{
    uint64_t seed = 21;
    thud_world_def def = weightless();
    def.broadphase = broadphase;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    for (int i = 0; i < 80; i++) {
        thud_body_id body = add_body(g.world, THUD_DYNAMIC, random_in(&seed, -52, 52),
                                     random_in(&seed, -3, 2), 0);
        add_shape(g.world, body, (float)random_in(&seed, 0.05, 1.5),
                  i % 2 ? (float)random_in(&seed, 0.05, 0.5) : 0, false, &sensor);
    }
    for (int k = 0; k < 400; k++) {
        double x = random_in(&seed, -52, 52);
        const thud_pos ends[] = {{k % 2 ? 51.5 : -51.5, 0.5}};
        for (int n = 0; n <= k % 3; n++) {
            edit_by_number(&g, (int)random_in(&seed, 0, 5), x + n);
        }
        if (k % 20 < 2) {
            OK(thud_shape_replace_range(g.world, g.shape, ends[0].x, ends[0].x, ends, 1));
        }
        run(g.world, 1);
        int pairs = thud_world_stats(g.world).pairs;
        assert_true(pairs > 50);
        OK(thud_body_set_transform(g.world, g.body, (thud_pos){0, 0}, 0));
        run(g.world, 1);
        assert_int_equal(pairs, thud_world_stats(g.world).pairs);
    }
    thud_world_destroy(g.world);
}

/* Sensors do not move: after any edit they have exactly the pairs that a new line would give. */
static void pairs_after_random_edits_are_those_of_a_new_line(void **state)
{
    (void)state;
    edit_among_sensors(&thud_broadphase_grid);
    edit_among_sensors(&thud_broadphase_sweep);
    edit_among_sensors(&thud_broadphase_all);
}

/* Through a thousand edits in a crowd every touch has its begin and its end, and nobody is lost. */
static void edits_under_a_crowd_lose_no_event_and_no_body(void **state)
{
    (void)state;
    uint64_t seed = 33;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, thud_default_world_def());
    thud_body_id bodies[100];
    add_walls(&g);
    int touches[256] = {0};
    for (int i = 0; i < 100; i++) {
        double x = random_in(&seed, -15, 15), y = random_in(&seed, 1, 5);
        bodies[i] = i % 2 ? add_ball(g.world, x, y, 0.3f) : add_box(g.world, x, y, 0.3f, 0.3f);
    }
    for (int k = 0; k < 1600; k++) {
        if (k < 1000) {
            edit_by_number(&g, k % 7, random_in(&seed, -15, 15));
        }
        run(g.world, 1);
        thud_events e = thud_world_events(g.world);
        for (int i = 0; i < e.begin_count; i++) {
            touches[e.begin[i].shape_a.index1]++;
            touches[e.begin[i].shape_b.index1]++;
        }
        for (int i = 0; i < e.end_count; i++) {
            touches[e.end[i].shape_a.index1]--;
            touches[e.end[i].shape_b.index1]--;
        }
    }
    int sum = 0, lost = 0;
    for (int i = 0; i < 256; i++) {
        assert_true(touches[i] >= 0);
        sum += touches[i];
    }
    assert_int_equal(sum, 2 * thud_world_stats(g.world).contacts);
    thud_terrain line = line_of(&g);
    for (int i = 0; i < 100; i++) {
        thud_pos p = state_of(g.world, bodies[i]).position;
        assert_true(fabs(p.x) < 29);
        lost += p.y < height_of(&line, p.x);
    }
    assert_int_equal(lost, 0);
    thud_world_destroy(g.world);
}

/* ---- what is refused ---- */

static long allowed = -1; /* allocations until one fails; negative: no end */

static void *allocate(size_t bytes, void *context)
{
    (void)context;
    return allowed >= 0 && allowed-- == 0 ? NULL : aligned_alloc(64, bytes);
}

static void release(void *block, size_t bytes, void *context)
{
    (void)bytes;
    (void)context;
    free(block);
}

static thud_result edit_result(const ground *g, int which)
{
    const thud_pos more[] = {{0.1, 1}, {0.2, 2}, {0.3, 1}};
    const double heights[] = {1, 2, 3};
    switch (which) {
    case 0:
        return thud_shape_dig(g->world, g->shape, (thud_pos){0, 0}, 3);
    case 1:
        return thud_shape_raise(g->world, g->shape, 0, 3, 1);
    case 2:
        return thud_shape_replace_range(g->world, g->shape, 0.1, 0.3, more, 3);
    default:
        return thud_shape_set_heights(g->world, g->shape, 7, heights, 3);
    }
}

static void edit_without_memory_leaves_line_and_world_as_they_were(void **state)
{
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.allocator = (thud_allocator){allocate, release, NULL};
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    thud_body_id box = add_box(g.world, 0, 0.25, 0.25f, 0.25f);
    thud_pos room[ROOM];
    run_to_sleep(&g);
    for (int which = 0; which < 4; which++) {
        int failures = 0;
        for (thud_result result = THUD_ERROR_MEMORY; result != THUD_OK; failures++) {
            thud_terrain old = keep_line(&g, room);
            allowed = failures;
            result = edit_result(&g, which);
            allowed = -1;
            if (result != THUD_OK) {
                assert_int_equal(result, THUD_ERROR_MEMORY);
                line_is(&g, &old);
                run(g.world, 1);
                assert_false(awake(&g, box));
            }
        }
        assert_true(failures > 1 || which == 2);
        run_to_sleep(&g);
    }
    thud_world_destroy(g.world);
}

static int messages;

static void count_message(thud_result result, const char *message, void *context)
{
    (void)context;
    assert_true(result != THUD_OK && message[0]);
    messages++;
}

static void edit_with_bad_input_is_refused_with_a_message(void **state)
{
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.log = count_message;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    ground u = level_ground(THUD_TERRAIN_UNIFORM, def);
    thud_world *w = g.world;
    thud_shape_id s = g.shape, none = {0, 0};
    thud_terrain slope = {.kind = THUD_TERRAIN_FLAT, .slope = 0.5};
    thud_shape_id flat = add_line(w, g.body, &slope, false);
    thud_shape_id box = add_shape(w, add_body(w, THUD_STATIC, 0, 9, 0), 1, 1, true, NULL);
    const thud_pos fine[] = {{1, 0}, {2, 0}}, back[] = {{2, 0}, {1, 0}}, twice[] = {{1, 0}, {1, 0}};
    const thud_pos holes[] = {{1, 0}, {1.5, NAN}}, high[] = {{1, 0}, {2, 2e9}};
    const double heights[] = {0, NAN};
    thud_pos room[ROOM];
    thud_terrain old = keep_line(&g, room);
    const struct {
        thud_result got, wanted;
    } calls[] = {
        {thud_shape_dig(NULL, s, (thud_pos){0, 0}, 1), THUD_ERROR_NULL},
        {thud_shape_dig(w, none, (thud_pos){0, 0}, 1), THUD_ERROR_STALE},
        {thud_shape_dig(w, u.shape, (thud_pos){0, 0}, 1), THUD_ERROR_STALE},
        {thud_shape_dig(w, box, (thud_pos){0, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, flat, (thud_pos){0, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){NAN, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, INFINITY}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, -1e9}, 100), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, 0), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, -1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, NAN), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, 16385), THUD_ERROR_INVALID},
        {thud_shape_raise(NULL, s, 0, 1, 1), THUD_ERROR_NULL},
        {thud_shape_raise(w, none, 0, 1, 1), THUD_ERROR_STALE},
        {thud_shape_raise(w, box, 0, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, flat, 0, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, NAN, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 0, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 1, INFINITY), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 1, NAN), THUD_ERROR_INVALID},
        {thud_shape_replace_range(NULL, s, 0, 3, fine, 2), THUD_ERROR_NULL},
        {thud_shape_replace_range(w, none, 0, 3, fine, 2), THUD_ERROR_STALE},
        {thud_shape_replace_range(w, box, 0, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, flat, 0, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(u.world, u.shape, 0, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, NULL, 2), THUD_ERROR_NULL},
        {thud_shape_replace_range(w, s, 3, 0, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, NAN, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, fine, -1), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 1.5, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 1.5, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, back, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, twice, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, holes, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, high, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, -INFINITY, INFINITY, fine, 1), THUD_ERROR_INVALID},
        {thud_shape_set_heights(NULL, s, 0, heights, 1), THUD_ERROR_NULL},
        {thud_shape_set_heights(w, s, 0, NULL, 1), THUD_ERROR_NULL},
        {thud_shape_set_heights(w, s, 0, heights, 2), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, s, 200, heights, 2), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, s, -1, heights, 1), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, flat, 0, heights, 1), THUD_ERROR_INVALID},
    };
    int wordless = 0; /* without a world nobody can be told */
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        if (calls[i].got != calls[i].wanted) {
            fail_msg("call %d: %d", (int)i, calls[i].got);
        }
        wordless += calls[i].got == THUD_ERROR_NULL;
    }
    wordless -= 2; /* null points and heights are told */
    assert_int_equal(messages, (int)(sizeof calls / sizeof *calls) - wordless);
    line_is(&g, &old);
    thud_world_destroy(w);
    thud_world_destroy(u.world);
}

static thud_shape_id to_dig;

static bool dig_inside(thud_world *world, const thud_contact *contact, void *context)
{
    (void)contact;
    *(thud_result *)context = thud_shape_dig(world, to_dig, (thud_pos){0, 0}, 1);
    return true;
}

static void edit_inside_a_callback_is_refused(void **state)
{
    (void)state;
    thud_result result = THUD_OK;
    thud_world_def def = thud_default_world_def();
    def.prologue = dig_inside;
    def.callback_context = &result;
    ground g = level_ground(THUD_TERRAIN_UNIFORM, def);
    to_dig = g.shape;
    add_ball(g.world, 0, 0.25, 0.25f);
    run(g.world, 2);
    assert_int_equal(result, THUD_ERROR_LOCKED);
    assert_true(height_at(&g, 0) == 0);
    thud_world_destroy(g.world);
}

int main(void)
{
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
        cmocka_unit_test(edit_wakes_what_rests_there_and_nothing_far_away),
        cmocka_unit_test(edit_of_bare_ground_does_not_touch_the_motion_elsewhere),
        cmocka_unit_test(ball_on_dug_ground_comes_to_rest_in_the_crater),
        cmocka_unit_test(bodies_inside_raised_ground_are_pushed_out),
        cmocka_unit_test(raised_ground_wakes_a_body_that_did_not_touch_it),
        cmocka_unit_test(two_edits_between_steps_wake_only_their_own_places),
        cmocka_unit_test(pairs_after_random_edits_are_those_of_a_new_line),
        cmocka_unit_test(edits_under_a_crowd_lose_no_event_and_no_body),
        cmocka_unit_test(edit_without_memory_leaves_line_and_world_as_they_were),
        cmocka_unit_test(edit_with_bad_input_is_refused_with_a_message),
        cmocka_unit_test(edit_inside_a_callback_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
