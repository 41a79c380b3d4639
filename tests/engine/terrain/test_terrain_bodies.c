/* test_terrain_bodies.c: bodies on ground that is edited: which of them wake, where they come to
 * rest, and that their contacts and events are right; and bodies that are teleported from ground.
 */
#include "terrain_support.h"

/* Makes one of four edits at x: dig, raise, or replace a range. */
static void edit_by_number(const ground *g, int which, double x) {
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

/* Asserts that the body sleeps and has not moved. */
static void sleeps_as_it_was(const ground *g, thud_body_id body, const thud_body_state *was) {
    thud_body_state now = state_of(g->world, body);
    assert_false(now.awake);
    assert_true(now.position.x == was->position.x && now.position.y == was->position.y &&
                now.angle == was->angle);
}

/* An edit wakes the stack at its place, and leaves stacks 20 m away asleep and in place. */
static void edit_wakes_what_rests_there_and_nothing_far_away(void **state) {
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
        assert_int_equal(thud_stats_of(g.world).awake_bodies, 3);
        run(g.world, 300);
        sleeps_as_it_was(&g, left, &was_left);
        sleeps_as_it_was(&g, right, &was_right);
        /* Their contacts have the indices of the edited line: nothing moves when they wake. */
        OK(thud_body_set_awake(g.world, right, true));
        OK(thud_body_set_awake(g.world, left, true));
        run(g.world, 60);
        near_to(state_of(g.world, left).position.y, was_left.position.y, 1e-3);
        near_to(state_of(g.world, right).position.y, was_right.position.y, 1e-3);
        thud_world_destroy(g.world);
    }
}

/* Far from an edit, a running world continues with the same bits as one without the edit. */
static void edit_of_bare_ground_does_not_touch_the_motion_elsewhere(void **state) {
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
        assert_true(thud_hash_of(edited.world) == thud_hash_of(other.world));
    }
    thud_world_destroy(edited.world);
    thud_world_destroy(other.world);
}

static void ball_on_dug_ground_comes_to_rest_in_the_crater(void **state) {
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

static void bodies_inside_raised_ground_are_pushed_out(void **state) {
    (void)state;
    for (int kind = THUD_TERRAIN_UNIFORM; kind <= THUD_TERRAIN_IRREGULAR; kind++) {
        ground g = level_ground((thud_terrain_kind)kind, thud_default_world_def());
        thud_body_id bodies[12];
        add_walls(&g);
        for (int i = 0; i < 12; i++) {
            double x = -5.5 + i;
            bodies[i] =
                i % 2 ? add_ball(g.world, x, 0.3, 0.3f) : add_box(g.world, x, 0.3, 0.4f, 0.3f);
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
        assert_true(thud_measure_of(g.world).penetration_max < 0.02);
        thud_world_destroy(g.world);
    }
}

/* A sleeping plank lies on a shelf above the ground that is raised into it; a ball on a high perch
 * is out of reach, and sleeps on. */
static void raised_ground_wakes_a_body_that_did_not_touch_it(void **state) {
    (void)state;
    ground g = level_ground(THUD_TERRAIN_UNIFORM, thud_default_world_def());
    thud_body_id shelf = add_body(g.world, THUD_BODY_STATIC, 0, 1, 0);
    add_shape(g.world, shelf, 0.5f, 0.1f, true, NULL);
    thud_body_id plank = add_box(g.world, 0, 1.2, 3, 0.1f), high = add_ball(g.world, 9, 8, 0.3f);
    thud_body_id perch = add_body(g.world, THUD_BODY_STATIC, 9, 7.6, 0);
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

/* Two edits between steps wake the bodies at both places, and not those between them. */
static void two_edits_between_steps_wake_only_their_own_places(void **state) {
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

/* Edits a terrain among sensors in 400 steps, and compares the number of pairs after each with that
 * after the terrain was set to its own place, which makes its pairs anew. */
static void edit_among_sensors(const thud_broadphase *broadphase) {
    uint64_t seed = 21;
    thud_world_def def = weightless();
    def.broadphase = broadphase;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    for (int i = 0; i < 80; i++) {
        thud_body_id body = add_body(g.world, THUD_BODY_DYNAMIC, random_in(&seed, -52, 52),
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
        int pairs = thud_stats_of(g.world).pairs;
        assert_true(pairs > 50);
        OK(thud_body_set_transform(g.world, g.body, (thud_pos){0, 0}, 0));
        run(g.world, 1);
        assert_int_equal(pairs, thud_stats_of(g.world).pairs);
    }
    thud_world_destroy(g.world);
}

/* Sensors do not move, so after any edit they must have the pairs that a new terrain would have. */
static void pairs_after_random_edits_are_those_of_a_new_line(void **state) {
    (void)state;
    edit_among_sensors(&thud_broadphase_grid);
    edit_among_sensors(&thud_broadphase_sweep);
    edit_among_sensors(&thud_broadphase_all);
}

/* Counts the shapes that each shape touches, by its slot, according to the events. */
static void count_touches(const thud_world *world, int touches[256]) {
    thud_events e = thud_events_of(world);
    for (int i = 0; i < e.begin_count; i++) {
        touches[e.begin[i].shape_a.index1]++;
        touches[e.begin[i].shape_b.index1]++;
    }
    for (int i = 0; i < e.end_count; i++) {
        touches[e.end[i].shape_a.index1]--;
        touches[e.end[i].shape_b.index1]--;
    }
}

/* In a thousand edits under a crowd each begin has its end, and no body is lost. */
static void edits_under_a_crowd_lose_no_event_and_no_body(void **state) {
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
        count_touches(g.world, touches);
    }
    int lost = 0;
    for (int i = 0; i < 256; i++) {
        assert_true(touches[i] >= 0);
    }
    thud_terrain line = line_of(&g);
    for (int i = 0; i < 100; i++) {
        thud_pos p = state_of(g.world, bodies[i]).position;
        assert_true(fabs(p.x) < 29);
        lost += p.y < height_of(&line, p.x);
    }
    assert_int_equal(lost, 0);
    for (int i = 0; i < 100; i++) {
        OK(thud_body_destroy(g.world, bodies[i]));
    }
    run(g.world, 1);
    count_touches(g.world, touches);
    for (int i = 0; i < 256; i++) {
        assert_int_equal(touches[i], 0);
    }
    thud_world_destroy(g.world);
}

/* A box at rest on a slope is teleported downhill, so that it is in the air, and must fall. The
 * manifold cache of terrain has places modulo 256 length scales. */
static void teleported_box_leaves_the_ground_whatever_the_distance(void **state) {
    (void)state;
    static const thud_pos slope[] = {{-1000, -100}, {1000, 100}};
    static const double distances[] = {8, 255, 256, 512};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = slope, .count = 2};
    for (int i = 0; i < 4; i++) {
        thud_world *world = make_world(thud_default_world_def());
        add_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &line);
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0.51, atan(0.1));
        add_shape(world, box, 0.5f, 0.5f, false, NULL);
        run(world, 20);
        thud_body_state at = state_of(world, box);
        near_to(at.position.y, 0.5, 0.02);
        at.position.x -= distances[i];
        OK(thud_body_set_transform(world, box, at.position, at.angle));
        run(world, 10);
        assert_true(state_of(world, box).position.y < at.position.y - 0.1);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edit_wakes_what_rests_there_and_nothing_far_away),
        cmocka_unit_test(edit_of_bare_ground_does_not_touch_the_motion_elsewhere),
        cmocka_unit_test(ball_on_dug_ground_comes_to_rest_in_the_crater),
        cmocka_unit_test(bodies_inside_raised_ground_are_pushed_out),
        cmocka_unit_test(raised_ground_wakes_a_body_that_did_not_touch_it),
        cmocka_unit_test(two_edits_between_steps_wake_only_their_own_places),
        cmocka_unit_test(pairs_after_random_edits_are_those_of_a_new_line),
        cmocka_unit_test(edits_under_a_crowd_lose_no_event_and_no_body),
        cmocka_unit_test(teleported_box_leaves_the_ground_whatever_the_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
