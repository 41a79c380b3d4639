/* test_internal_edges.c: static shapes side by side act as one ground (contact/internal_edges.h): a
 * body that slides over their seams loses no speed and does not hop, while real edges still stop
 * it. Without this, circles lost 92 % of their speed over 1,000 tiles, and boxes all of it. */
#include "engine_support.h"

#include "contact/internal_edges.h"

/* Kinds of ground: AABBs, OBBs, one terrain, or terrains and boxes alternately. */
enum { TILES, TURNED_TILES, LINE, LINES_AND_BOXES, GROUNDS };

static thud_shape_def smooth(void) {
    thud_shape_def def = thud_default_shape_def();
    def.friction = 0;
    return def;
}

static void add_tile(thud_world *world, double x, double y, float hx, float hy, bool upright) {
    thud_shape_def def = smooth();
    add_shape(world, add_body(world, THUD_BODY_STATIC, x, y, 0), hx, hy, upright, &def);
}

static void add_line(thud_world *world, double x, const thud_pos *points, int count) {
    thud_shape_def def = smooth();
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = count};
    thud_body_id body = add_body(world, THUD_BODY_STATIC, x, 0, 0);
    OK(thud_shape_create_terrain(world, body, &def, &line, NULL));
}

/* Adds a floor of 1,000 units, whose top is at height 0. */
static void add_ground(thud_world *world, int ground) {
    static thud_pos points[1001];
    for (int i = 0; i <= 1000; i++) {
        points[i] = (thud_pos){i, 0};
    }
    for (int i = 0; i < 1000 && ground <= TURNED_TILES; i++) {
        add_tile(world, i + 0.5, -0.5, 0.5f, 0.5f, ground == TILES);
    }
    if (ground == LINE) {
        add_line(world, 0, points, 1001);
    }
    for (int i = 0; i < 100 && ground == LINES_AND_BOXES; i++) {
        if (i % 2) {
            add_tile(world, 10 * i + 5, -1, 5, 1, i % 4 == 1);
        } else {
            add_line(world, 10 * i, points, 11);
        }
    }
}

static thud_body_id add_slider(thud_world *world, int kind, double x) {
    thud_shape_def def = smooth();
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, x, kind ? 0.3 : 0.5, 0);
    add_shape(world, body, kind ? 0.4f : 0.5f, kind ? 0.3f : 0, kind == 1, &def);
    return body;
}

/* Slides a body over the ground; asserts its speed and height. */
static void slide(int ground, int kind, double speed, const thud_detection *detection) {
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    def.detection = detection;
    thud_world *world = make_world(def);
    add_ground(world, ground);
    thud_body_id slider = add_slider(world, kind, 5.3);
    run(world, 60);
    double rest = state_of(world, slider).position.y;
    OK(thud_body_set_velocity(world, slider, (thud_vec2){(float)speed, 0}, 0));
    double least = speed, most = speed, hop = 0;
    while (state_of(world, slider).position.x < 990) {
        run(world, 1);
        thud_body_state s = state_of(world, slider);
        least = fmin(least, (double)s.velocity.x);
        most = fmax(most, (double)s.velocity.x);
        hop = fmax(hop, fabs(s.position.y - rest));
        if (least < 0.999 * speed || most > 1.001 * speed || hop > 1e-4) {
            fail_msg("ground %d, kind %d at %g: at x = %g speed %g to %g, hop %g", ground, kind,
                     speed, s.position.x, least, most, hop);
        }
    }
    thud_world_destroy(world);
}

static void sliding_over_a_thousand_seams_keeps_speed_and_height(void **state) {
    (void)state;
    for (int ground = 0; ground < GROUNDS; ground++) {
        for (int kind = 0; kind < 3; kind++) {
            slide(ground, kind, 9.37, &thud_detection_continuous);
            slide(ground, kind, 3.117, &thud_detection_continuous);
            slide(ground, kind, 31.77, &thud_detection_continuous);
            slide(ground, kind, 7.73, &thud_detection_swept);
        }
    }
}

/* Under `bisect` and `swept` at high the solver leaves no gap, so that detection meets the
 * ground all along the way; and behind a box that has passed the end of the terrain, that end is a
 * second contact point. At a length scale of millimetres, the tops of tiles and terrain differ by
 * rounding of single precision. */
static void box_that_leaves_tiles_for_a_line_is_not_held_by_its_end(void **state) {
    (void)state;
    for (int k = 0; k < 60; k++) {
        thud_world_def def = thud_default_world_def_of(&thud_quality_high);
        def.detection = k % 2 ? &thud_detection_swept : &thud_detection_bisect;
        def.time_step = 1.0 / 240;
        def.length_scale = 1e-3f;
        def.gravity.y = -0.01f;
        thud_world *world = make_world(def);
        const thud_pos points[] = {{0.024, 0}, {0.0255, 0}, {0.027, 0}};
        double speed = 0.003 + 1e-4 * k;
        for (int i = 20; i < 24; i++) {
            add_tile(world, 1e-3 * i + 5e-4, -5e-4, 5e-4f, 5e-4f, i % 2);
        }
        add_line(world, 0, points, 3);
        thud_shape_def slippery = smooth();
        thud_body_id slider = add_body(world, THUD_BODY_DYNAMIC, 0.0213, 3e-4, 0);
        add_shape(world, slider, 3e-4f, 3e-4f, false, &slippery);
        run(world, 120);
        OK(thud_body_set_velocity(world, slider, (thud_vec2){(float)speed, 0}, 0));
        while (state_of(world, slider).position.x < 0.026) {
            run(world, 1);
            near_to((double)state_of(world, slider).velocity.x, speed, 1e-3 * speed);
        }
        thud_world_destroy(world);
    }
}

static void falling_along_a_wall_of_tiles_is_not_caught(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        thud_world_def def = thud_default_world_def();
        def.gravity = (thud_vec2){4, -10}; /* presses it against the wall */
        thud_world *world = make_world(def);
        for (int i = 0; i < 300; i++) {
            add_tile(world, 0.5, -i, 0.5f, 0.5f, true);
        }
        thud_shape_def slippery = smooth();
        thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, kind ? -0.4 : -0.5, 0, 0);
        add_shape(world, body, kind ? 0.4f : 0.5f, kind ? 0.3f : 0, kind == 1, &slippery);
        run(world, 360);
        near_to((double)state_of(world, body).velocity.y, -60, 0.06);
        thud_world_destroy(world);
    }
}

/* One tile of the floor is higher by 0.05. */
static void real_step_between_tiles_still_stops_a_box(void **state) {
    (void)state;
    for (int kind = 1; kind < 3; kind++) {
        thud_world *world = make_world(thud_default_world_def());
        for (int i = 0; i < 40; i++) {
            add_tile(world, i + 0.5, i == 20 ? -0.45 : -0.5, 0.5f, 0.5f, true);
        }
        thud_body_id box = add_slider(world, 1, 5);
        run(world, 30);
        OK(thud_body_set_velocity(world, box, (thud_vec2){3, 0}, 0));
        run(world, 400);
        near_to(state_of(world, box).position.x, 19.6, 0.01);
        thud_world_destroy(world);
    }
}

/* A tile's face that was covered by a neighbour stops a box once that neighbour is destroyed. */
static void neighbour_that_goes_uncovers_the_face_it_hid(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_tile(world, 10, -1.5, 20, 0.5f, true);
    thud_shape_def def = smooth();
    thud_body_id left = add_body(world, THUD_BODY_STATIC, 4.5, -0.5, 0);
    add_shape(world, left, 0.5f, 0.5f, true, &def);
    add_tile(world, 5.5, -0.5, 0.5f, 0.5f, true);
    run(world, 2);
    OK(thud_body_destroy(world, left));
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 2, -0.7, 0);
    add_shape(world, box, 0.4f, 0.3f, true, &def);
    OK(thud_body_set_velocity(world, box, (thud_vec2){3, 0}, 0));
    run(world, 120);
    near_to(state_of(world, box).position.x, 4.6, 0.01);
    thud_world_destroy(world);
}

/* Neither a sensor nor a tile that the slider's filter leaves out covers an edge for it. */
static void neighbour_that_is_not_met_hides_nothing(void **state) {
    (void)state;
    for (int filtered = 0; filtered < 2; filtered++) {
        thud_world *world = make_world(thud_default_world_def());
        add_tile(world, 10, -1.5, 20, 0.5f, true);
        thud_shape_def def = smooth();
        def.sensor = !filtered;
        def.filter.category = filtered ? 2 : 1;
        add_shape(world, add_body(world, THUD_BODY_STATIC, 4.5, -0.5, 0), 0.5f, 0.5f, true, &def);
        add_tile(world, 5.5, -0.5, 0.5f, 0.5f, true);
        thud_shape_def slider = smooth();
        slider.filter.mask = 1;
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 2, -0.7, 0);
        add_shape(world, box, 0.4f, 0.3f, true, &slider);
        OK(thud_body_set_velocity(world, box, (thud_vec2){3, 0}, 0));
        run(world, 120);
        near_to(state_of(world, box).position.x, 4.6, 0.01);
        thud_world_destroy(world);
    }
}

/* A wall stands on the floor: the floor's face beside it is not covered, and carries bodies. */
static void box_and_ball_in_a_corner_rest_on_the_floor(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        thud_world_def def = thud_default_world_def();
        def.gravity = (thud_vec2){3, -10};
        thud_world *world = make_world(def);
        for (int i = 0; i < 10; i++) {
            add_tile(world, i - 4.5, -0.5, 0.5f, 0.5f, true);
            add_tile(world, 2.5, i + 0.5, 0.5f, 0.5f, i % 2);
        }
        thud_body_id body = add_slider(world, kind, kind ? 1.55 : 1.45);
        run(world, 200);
        thud_body_state s = state_of(world, body);
        near_to(s.position.x, kind ? 1.6 : 1.5, 0.002);
        near_to(s.position.y, kind ? 0.3 : 0.5, 0.002);
        thud_world_destroy(world);
    }
}

/* Floors that overlap, with their tops in line, or twice the same floor, carry bodies as one. */
static void floors_that_overlap_bear_all_the_same(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        for (int upright = 0; upright < 2; upright++) {
            thud_world *world = make_world(thud_default_world_def());
            add_tile(world, 0, -1, 5, 1, upright);
            add_tile(world, 0, -1, 5, 1, upright);
            add_tile(world, 4, -0.5, 5, 0.5f, true);
            add_tile(world, -2, -2, 1, 2, false);
            double at[] = {-2, 0, 1.2, 4.8, 5, 7};
            thud_body_id bodies[6];
            for (int i = 0; i < 6; i++) {
                bodies[i] = add_slider(world, kind, at[i] * 1.5);
            }
            run(world, 120);
            for (int i = 0; i < 6; i++) {
                if (at[i] * 1.5 > -5 && at[i] * 1.5 < 9) {
                    near_to(state_of(world, bodies[i]).position.y, kind ? 0.3 : 0.5, 0.002);
                }
            }
            thud_world_destroy(world);
        }
    }
}

/* A terrain begins at the corner of the upper box and goes down steeply, then up again: it does not
 * cover the corner, and a box that lies across does not sink in. */
static void corner_at_the_start_of_a_steep_line_is_met(void **state) {
    (void)state;
    for (int k = 0; k < 20; k++) {
        thud_world *world = make_world(thud_default_world_def());
        const thud_pos points[] = {{0, 0.002}, {0.33, -0.26}, {0.6, -0.16}, {6, -0.16}};
        add_tile(world, -1, -0.1, 1, 0.1f, false);
        add_tile(world, 2, -1.2, 5, 0.97f, true);
        add_line(world, 0, points, 4);
        thud_shape_def def = thud_default_shape_def();
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0.4 + 0.01 * k, 1, 0);
        add_shape(world, box, 0.06f, 0.27f, false, &def);
        run(world, 150);
        thud_body_state s = state_of(world, box);
        thud_geometry b = {THUD_SHAPE_OBB, s.position.x, s.position.y, cos(s.angle),
                           sin(s.angle),   0.06,         0.27};
        thud_geometry upper = {THUD_SHAPE_AABB, -1, -0.1, 1, 0, 1, 0.1};
        thud_geometry lower = {THUD_SHAPE_AABB, 2, -1.2, 1, 0, 5, 0.97};
        thud_closest c;
        OK(thud_geometry_closest(&upper, &b, &c));
        if (!(c.distance > -0.005)) {
            fail_msg("case %d: in the upper box by %g", k, -c.distance);
        }
        OK(thud_geometry_closest(&lower, &b, &c));
        if (!(c.distance > -0.005)) {
            fail_msg("case %d: in the lower box by %g", k, -c.distance);
        }
        thud_world_destroy(world);
    }
}

/* Turned tiles form a hill: a body rolls up, over the top and down, without leaving it or getting
 * stuck. */
/* A tilted box glides along the ground. The manifold of its lower face with a tile has two points,
 * which close at 2 m/s along the face's normal; that at the seam replaces it has one point, along
 * the ground's normal, which does not close at all. */
static void tilted_box_that_glides_over_seams_hits_nothing(void **state) {
    (void)state;
    const double tilt = 0.09, hx = 0.4, hy = 0.3, lowest = 0.004;
    int touching = 0;
    for (int i = 0; i < 100; i++) {
        thud_world *world = make_world(weightless());
        for (int k = 0; k < 8; k++) {
            add_tile(world, k, -0.5, 0.5f, 0.5f, i % 2);
        }
        double y = lowest + hx * sin(tilt) + hy * cos(tilt);
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 2.5 + 0.02 * i, y, tilt);
        add_shape(world, box, (float)hx, (float)hy, false, NULL);
        OK(thud_body_set_velocity(world, box, (thud_vec2){22, 0}, 0));
        run(world, 1);
        thud_events events = thud_events_of(world);
        touching += events.begin_count;
        assert_int_equal(events.hit_count, 0);
        thud_world_destroy(world);
    }
    assert_true(touching >= 100);
}

static void rolling_over_a_hill_of_turned_tiles_follows_it(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    double slope = 0.05, length = 2.0;
    thud_shape_def def = smooth();
    for (int i = -8; i < 8; i++) {
        double a = i < 0 ? slope : -slope, mid = (i + 0.5) * length;
        double x = mid * cos(a), y = -fabs(mid) * sin(slope);
        thud_body_id tile =
            add_body(world, THUD_BODY_STATIC, x + 0.5 * sin(a), y - 0.5 * cos(a), a);
        add_shape(world, tile, (float)(length / 2), 0.5f, false, &def);
    }
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, -10, 0, 0);
    add_shape(world, ball, 0.3f, 0, false, &def);
    run(world, 30);
    double from = 8.5;
    OK(thud_body_set_velocity(world, ball,
                              (thud_vec2){(float)(from * cos(slope)), (float)(from * sin(slope))},
                              0));
    thud_body_state s = state_of(world, ball);
    double energy = 0.5 * from * from + 10 * s.position.y;
    for (int i = 0; i < 400 && s.position.x < 9; i++) {
        run(world, 1);
        s = state_of(world, ball);
    }
    double v = hypot((double)s.velocity.x, (double)s.velocity.y);
    assert_true(s.position.x >= 9);
    near_to(0.5 * v * v + 10 * s.position.y, energy, 0.02 * energy);
    thud_world_destroy(world);
}

/* The neighbours of a tile are determined when a body comes near it: in a first step, all of 12,000
 * tiles took 16 ms. */
static void tiles_that_nothing_is_near_are_not_looked_at(void **state) {
    (void)state;
    enum { ROWS = 40, ALL = ROWS * ROWS };
    thud_world *world = make_world(thud_default_world_def());
    for (int i = 0; i < ALL; i++) {
        add_tile(world, i % ROWS, -(i / ROWS), 0.5f, 0.5f, i % 2);
    }
    thud_body_id ball = add_ball(world, 10, 1.2, 0.5f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){4, 0}, 0));
    for (int step = 0; step < 120; step++) {
        run(world, 1);
        int unseen = 0;
        for (int i = 0; i < world->shapes.count; i++) {
            const td_shape *shape = td_shape_at(world, i);
            bool met = td_body_at(world, shape->body)->first_constraint != TD_NONE;
            bool hidden = shape->flags & TD_SHAPE_UNSEEN;
            assert_false(met && hidden);
            unseen += hidden;
        }
        assert_true(unseen >= ALL - 30);
        assert_true(step < 60 || unseen < ALL - 4);
    }
    near_to(state_of(world, ball).position.y, 1, 0.01);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sliding_over_a_thousand_seams_keeps_speed_and_height),
        cmocka_unit_test(box_that_leaves_tiles_for_a_line_is_not_held_by_its_end),
        cmocka_unit_test(falling_along_a_wall_of_tiles_is_not_caught),
        cmocka_unit_test(real_step_between_tiles_still_stops_a_box),
        cmocka_unit_test(neighbour_that_goes_uncovers_the_face_it_hid),
        cmocka_unit_test(neighbour_that_is_not_met_hides_nothing),
        cmocka_unit_test(box_and_ball_in_a_corner_rest_on_the_floor),
        cmocka_unit_test(floors_that_overlap_bear_all_the_same),
        cmocka_unit_test(corner_at_the_start_of_a_steep_line_is_met),
        cmocka_unit_test(tilted_box_that_glides_over_seams_hits_nothing),
        cmocka_unit_test(rolling_over_a_hill_of_turned_tiles_follows_it),
        cmocka_unit_test(tiles_that_nothing_is_near_are_not_looked_at),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
