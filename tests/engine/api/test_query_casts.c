/* test_query_casts.c: rays, casts, overlaps and closest points where the answer is known by hand,
 * and what each of them refuses. */
#include "engine_support.h"

#include "hostile_memory.h"

enum { ROOM = 8 };

static thud_shape_id add_ground(thud_world *world, double x, double y,
                                const thud_terrain *terrain) {
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id id;
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, x, y, 0), &def, terrain,
                                 &id));
    return id;
}

static thud_shape_id add_still(thud_world *world, double x, double y, float hx, float hy,
                               double angle) {
    return add_shape(world, add_body(world, THUD_BODY_STATIC, x, y, angle), hx, hy, false, NULL);
}

/* Asserts the fields of a hit. */
static void is_hit(const thud_ray_hit *hit, thud_shape_id shape, double fraction, double x,
                   double y, double nx, double ny) {
    assert_int_equal(hit->shape.index1, shape.index1);
    near_to(hit->fraction, fraction, 1e-8);
    near_to(hit->point.x, x, 1e-6);
    near_to(hit->point.y, y, 1e-6);
    near_to((double)hit->normal.x, nx, 1e-6);
    near_to((double)hit->normal.y, ny, 1e-6);
}

static void ray_through_all_lists_the_nearest_first(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id far_off = add_still(world, 8, 0, 1, 0, 0);
    thud_shape_id middle = add_still(world, 4, 0.25, 0.5f, 0.5f, 0);
    thud_terrain slope = {.kind = THUD_TERRAIN_FLAT, .slope = -1};
    add_ground(world, 0, -20, &slope);
    thud_shape_id beside = add_still(world, 4, -3, 0.5f, 0.5f, 0);
    thud_ray_hit hits[ROOM];
    int count;
    OK(thud_world_cast_ray_all(world, &(thud_ray){(thud_pos){-2, 0}, 20, 0, NULL}, hits, ROOM,
                               &count));
    assert_int_equal(count, 2);
    is_hit(&hits[0], middle, 5.5 / 20, 3.5, 0, -1, 0);
    is_hit(&hits[1], far_off, 9.0 / 20, 7, 0, -1, 0);
    OK(thud_world_cast_ray_all(world, &(thud_ray){(thud_pos){-2, 0}, 20, 0, NULL}, hits, 1,
                               &count));
    assert_int_equal(count, 2);
    is_hit(&hits[0], middle, 5.5 / 20, 3.5, 0, -1, 0);
    OK(thud_world_cast_ray_all(world, &(thud_ray){(thud_pos){4, 5}, 0, -50, NULL}, NULL, 0,
                               &count));
    assert_int_equal(count, 3);
    OK(thud_world_cast_ray_all(world, &(thud_ray){(thud_pos){4, 5}, 0, -50, NULL}, hits, ROOM,
                               NULL));
    is_hit(&hits[1], beside, 7.5 / 50, 4, -2.5, 0, 1);
    thud_world_destroy(world);
}

/* Hits at the same fraction are in the order of their shapes' slots. */
static void equal_fractions_are_told_in_the_order_of_slots(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id ids[5];
    for (int i = 0; i < 5; i++) {
        ids[i] = add_still(world, 5, 3 - 1.5 * i, 0.5f, 0.5f, 0);
    }
    thud_ray_hit hits[ROOM];
    int count;
    thud_pos origin = {0, 0};
    OK(thud_world_cast_shape_all(world,
                                 &(thud_shape_cast){origin, thud_obb_at(0, 0, 0.5, 10, 0), 9, 0,
                                                    NULL},
                                 hits, ROOM, &count));
    assert_int_equal(count, 5);
    for (int i = 0; i < 5; i++) {
        assert_int_equal(hits[i].shape.index1, ids[i].index1);
        near_to(hits[i].fraction, 4.0 / 9, 1e-9);
    }
    thud_world_destroy(world);
}

static void circle_cast_meets_faces_corners_and_circles(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id box = add_still(world, 0, 0, 1, 1, 0), disc = add_still(world, 10, 0, 1, 0, 0);
    bool hit;
    thud_ray_hit found;
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0.5, 5}, thud_circle_at(0, 0, 0.5), 0,
                                                -10, NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, box, 0.35, 0.5, 1, 0, 1);
    /* The circle passes the corner (1, 1) by 0.3 and touches it where its centre is at height
     * 1.4. */
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){1.3, 5}, thud_circle_at(0, 0, 0.5), 0,
                                                -10, NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, box, 0.36, 1, 1, 0.6, 0.8);
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){10.9, 5}, thud_circle_at(0, 0, 0.5), 0,
                                                -10, NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, disc, 0.38, 10.6, 0.8, 0.6, 0.8);
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){1.6, 5}, thud_circle_at(0, 0, 0.5), 0,
                                                -10, NULL},
                             &hit, &found));
    assert_false(hit);
    thud_world_destroy(world);
}

static void box_cast_meets_corners_slopes_and_turned_boxes(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_terrain slope = {.kind = THUD_TERRAIN_FLAT, .slope = 0.75};
    thud_shape_id ground = add_ground(world, 0, 0, &slope);
    bool hit;
    thud_ray_hit found;
    /* The lower right corner of the box meets the slope. */
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0, 4}, thud_obb_at(0, 0, 0.5, 0.5, 0), 0,
                                                -8, NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, ground, 3.125 / 8, 0.5, 0.375, -0.6, 0.8);
    /* Rotated to the slope, the whole face of the box meets it. */
    double angle = atan(0.75);
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0, 4}, thud_obb_at(0, 0, 2, 0.5, angle),
                                                0, -8, NULL},
                             &hit, &found));
    assert_true(hit);
    near_to(found.fraction, (4 - 0.5 / 0.8) / 8, 1e-8);
    near_to((double)found.normal.y, 0.8, 1e-6);
    /* A square, rotated by 45 degrees, falls with its tip on an upright box. */
    thud_shape_id box = add_still(world, -10, 10, 1, 1, 0);
    thud_pos above = {-10.5, 20};
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){above, thud_obb_at(0, 0, 1, 1, atan(1)), 0, -10,
                                                NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, box, (9 - sqrt(2)) / 10, -10.5, 11, 0, 1);
    thud_world_destroy(world);
}

static void cast_that_starts_in_a_shape_hits_at_zero_by_the_shortest_way_out(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id box = add_still(world, 0, 0, 2, 1, 0);
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    thud_shape_id ground = add_ground(world, 0, -10, &flat);
    bool hit;
    thud_ray_hit found;
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){-1.9, 0.2}, thud_circle_at(0, 0, 0.5), 9,
                                                0, NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, box, 0, -2, 0.2, -1, 0);
    near_to(found.depth, 0.6, 1e-9);
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0.5, 1.2},
                                                thud_obb_at(0, 0, 0.5, 0.5, 0), 0, 9, NULL},
                             &hit, &found));
    assert_true(hit);
    assert_true(found.fraction == 0);
    near_to((double)found.normal.y, 1, 1e-6);
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){40, -9.75}, thud_circle_at(0, 0, 0.5), 0,
                                                0, NULL},
                             &hit, &found));
    assert_true(hit);
    is_hit(&found, ground, 0, 40, -10, 0, 1);
    near_to(found.depth, 0.25, 1e-9);
    /* A ray that starts inside a shape continues to shapes outside. */
    OK(thud_world_cast_ray(world, &(thud_ray){(thud_pos){0, 0}, 0, -20, NULL}, &hit, &found));
    assert_true(hit);
    is_hit(&found, ground, 0.5, 0, -10, 0, 1);
    thud_world_destroy(world);
}

static void long_slanting_way_among_many_misses_none(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    for (int i = 0; i < 60; i++) {
        for (int j = 0; j < 60; j++) {
            add_still(world, 3.0 * i, 3.0 * j, 0.5f, 0, 0);
        }
    }
    thud_ray_hit hits[64];
    int count;
    OK(thud_world_cast_ray_all(world, &(thud_ray){(thud_pos){-3, -3}, 200, 200, NULL}, hits, 64,
                               &count));
    assert_int_equal(count, 60);
    for (int i = 0; i < 60; i++) {
        assert_int_equal(hits[i].shape.index1, 61 * i + 1);
    }
    OK(thud_world_cast_shape_all(world,
                                 &(thud_shape_cast){(thud_pos){-3, -3}, thud_circle_at(0, 0, 2),
                                                    200, 200, NULL},
                                 hits, 64, &count));
    assert_int_equal(count, 60 + 2 * 59);
    thud_world_destroy(world);
}

/* An overlap's callback: notes the shape in an array behind its count. */
static bool gather(thud_shape_id shape, void *context) {
    int *count = context;
    count[++*count] = (int)shape.index1;
    return true;
}

static void overlap_of_each_kind_finds_what_really_overlaps(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id a = add_still(world, 0, 0, 1, 1, 0), b = add_still(world, 3, 0, 1, 0, 0);
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    thud_shape_id ground = add_ground(world, 0, -3, &flat);
    int circle[ROOM] = {0}, apart[ROOM] = {0}, box[ROOM] = {0}, turned[ROOM] = {0};
    OK(thud_world_overlap_shape(world, (thud_pos){1.5, 0}, thud_circle_at(0, 0, 0.6), NULL, gather,
                                circle));
    assert_true(circle[0] == 2 && circle[1] == (int)a.index1 && circle[2] == (int)b.index1);
    OK(thud_world_overlap_shape(world, (thud_pos){1.4, 1.4}, thud_circle_at(0, 0, 0.5), NULL,
                                gather, apart));
    assert_int_equal(apart[0], 0); /* beyond the corner, though within the box's bounds */
    OK(thud_world_overlap_aabb(world, (thud_pos){0.5, -4}, (thud_pos){1.5, 0}, NULL, gather, box));
    assert_true(box[0] == 2 && box[1] == (int)a.index1 && box[2] == (int)ground.index1);
    OK(thud_world_overlap_shape(world, (thud_pos){2.2, 1.7}, thud_obb_at(0, 0, 1, 0.1, atan(-1)),
                                NULL, gather, turned));
    assert_true(turned[0] == 1 && turned[1] == (int)b.index1);
    thud_world_destroy(world);
}

static void closest_measures_from_outside_and_from_inside(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id disc = add_still(world, 0, 0, 1, 0, 0), box = add_still(world, 10, 0, 2, 1, 0);
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    thud_shape_id ground = add_ground(world, 0, -5, &flat);
    bool found;
    thud_closest_hit out;
    OK(thud_world_closest(world, (thud_pos){3, 4}, 100, NULL, &found, &out));
    assert_true(found);
    assert_int_equal(out.shape.index1, disc.index1);
    near_to(out.distance, 4, 1e-9);
    near_to(out.point.x, 0.6, 1e-9);
    near_to((double)out.normal.y, 0.8, 1e-6);
    OK(thud_world_closest(world, (thud_pos){9, 0.75}, 100, NULL, &found, &out));
    assert_int_equal(out.shape.index1, box.index1);
    near_to(out.distance, -0.25, 1e-9);
    near_to(out.point.y, 1, 1e-9);
    near_to((double)out.normal.y, 1, 1e-6);
    OK(thud_world_closest(world, (thud_pos){5, -4}, 100, NULL, &found, &out));
    assert_int_equal(out.shape.index1, ground.index1);
    near_to(out.distance, 1, 1e-9);
    near_to(out.point.y, -5, 1e-9);
    OK(thud_world_closest(world, (thud_pos){5, -7}, 0, NULL, &found, &out));
    near_to(out.distance, -2, 1e-9);
    near_to(out.point.y, -5, 1e-9);
    memset(&out, 7, sizeof out);
    thud_closest_hit untouched = out;
    OK(thud_world_closest(world, (thud_pos){3, 4}, 3.9, NULL, &found, &out));
    assert_false(found);
    assert_memory_equal(&out, &untouched, sizeof out);
    thud_world_destroy(world);
}

/* Queries use filters and sensors, and apply edits that no step has applied yet. */
static void queries_heed_filters_sensors_and_edits_not_stepped_yet(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def red = thud_default_shape_def(), eye = thud_default_shape_def();
    red.filter.category = 4;
    eye.sensor = true;
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_shape_id first = add_shape(world, body, 1, 0, false, &red);
    add_shape(world, add_body(world, THUD_BODY_STATIC, 0, 6, 0), 1, 0, false, &eye);
    thud_query_filter filter = thud_default_query_filter();
    bool hit;
    thud_ray_hit found;
    thud_closest_hit near_by;
    filter.mask = ~4u;
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0, 10}, thud_circle_at(0, 0, 0.5), 0,
                                                -20, &filter},
                             &hit, &found));
    assert_false(hit);
    OK(thud_world_closest(world, (thud_pos){0, 5}, 50, &filter, &hit, &near_by));
    assert_false(hit);
    filter.sensors = true;
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0, 10}, thud_circle_at(0, 0, 0.5), 0,
                                                -20, &filter},
                             &hit, &found));
    near_to(found.fraction, 2.5 / 20, 1e-9);
    OK(thud_world_closest(world, (thud_pos){0, 4}, 50, &filter, &hit, &near_by));
    near_to(near_by.distance, 1, 1e-9);
    OK(thud_body_set_transform(world, body, (thud_pos){0, -4}, 0));
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){0, 10}, thud_circle_at(0, 0, 0.5), 0,
                                                -20, NULL},
                             &hit, &found));
    is_hit(&found, first, 12.5 / 20, 0, -3, 0, 1);
    thud_world_destroy(world);
}

/* ---- bad input ---- */

#define REFUSED(call, code)                                \
    do {                                                   \
        assert_int_equal((call), (code));                  \
        assert_memory_equal(&out, &untouched, sizeof out); \
        assert_true(hit == 2 && count == 77);              \
    } while (0)

static bool never(thud_shape_id shape, void *context) {
    (void)shape;
    (void)context;
    fail_msg("called back");
    return false;
}

static void casts_refuse_bad_input_and_leave_outputs_alone(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_still(world, 0, 0, 1, 1, 0);
    thud_ray_hit out, untouched;
    memset(&out, 9, sizeof out);
    untouched = out;
    int count = 77;
    unsigned char hit = 2;
    bool *flag = (bool *)&hit;
    thud_pos at = {0, 5}, nowhere = {NAN, 0}, far_off = {2e9, 0};
    REFUSED(thud_world_cast_ray(NULL, &(thud_ray){at, 0, -9, NULL}, flag, &out), THUD_ERROR_NULL);
    REFUSED(thud_world_cast_ray(world, &(thud_ray){at, 0, INFINITY, NULL}, flag, &out),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_ray_all(world, &(thud_ray){nowhere, 0, -9, NULL}, &out, 1, &count),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_ray_all(world, &(thud_ray){at, 0, -9, NULL}, &out, -1, &count),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_ray_all(world, &(thud_ray){at, 0, -9, NULL}, NULL, 1, &count),
            THUD_ERROR_NULL);
    REFUSED(thud_world_cast_ray_all(NULL, &(thud_ray){at, 0, -9, NULL}, &out, 1, &count),
            THUD_ERROR_NULL);
    REFUSED(thud_world_cast_shape(world, NULL, flag, &out), THUD_ERROR_NULL);
    thud_geometry line = {.kind = THUD_SHAPE_TERRAIN, .c = 1, .hx = 1, .hy = 1};
    REFUSED(thud_world_cast_shape(world, &(thud_shape_cast){at, line, 0, -9, NULL}, flag, &out),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_shape_all(world, &(thud_shape_cast){at, line, 0, -9, NULL}, &out, 1,
                                      &count),
            THUD_ERROR_INVALID);
    const double bad[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        double size = bad[i];
        REFUSED(thud_world_cast_shape(world,
                                      &(thud_shape_cast){at, thud_circle_at(0, 0, size), 0, -9,
                                                         NULL},
                                      flag, &out),
                THUD_ERROR_INVALID);
        REFUSED(thud_world_cast_shape_all(world,
                                          &(thud_shape_cast){at, thud_circle_at(0, 0, size), 0, -9,
                                                             NULL},
                                          &out, 1, &count),
                THUD_ERROR_INVALID);
        REFUSED(thud_world_cast_shape(world,
                                      &(thud_shape_cast){at, thud_obb_at(0, 0, size, 1, 0), 0, -9,
                                                         NULL},
                                      flag, &out),
                THUD_ERROR_INVALID);
        REFUSED(thud_world_cast_shape_all(world,
                                          &(thud_shape_cast){at, thud_obb_at(0, 0, 1, size, 0), 0,
                                                             -9, NULL},
                                          &out, 1, &count),
                THUD_ERROR_INVALID);
        REFUSED(thud_world_overlap_shape(world, at, thud_circle_at(0, 0, size), NULL, never, NULL),
                THUD_ERROR_INVALID);
        REFUSED(thud_world_overlap_shape(world, at, thud_obb_at(0, 0, size, 1, 0), NULL, never,
                                         NULL),
                THUD_ERROR_INVALID);
        REFUSED(thud_world_overlap_aabb(world, at, (thud_pos){size, 6}, NULL, never, NULL),
                THUD_ERROR_INVALID);
    }
    REFUSED(thud_world_cast_shape(world,
                                  &(thud_shape_cast){at, thud_obb_at(0, 0, 1, 1, NAN), 0, -9, NULL},
                                  flag, &out),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_shape(world,
                                  &(thud_shape_cast){at, thud_obb_at(0, 0, 1, 1, 2e6), 0, -9, NULL},
                                  flag, &out),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_shape(world,
                                  &(thud_shape_cast){far_off, thud_circle_at(0, 0, 1), 0, -9, NULL},
                                  flag, &out),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_cast_shape(world,
                                  &(thud_shape_cast){at, thud_circle_at(0, 0, 1), 2e9, 0, NULL},
                                  flag, &out),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_overlap_shape(world, nowhere, thud_circle_at(0, 0, 1), NULL, never, NULL),
            THUD_ERROR_INVALID);
    REFUSED(thud_world_overlap_shape(world, at, thud_circle_at(0, 0, 1), NULL, NULL, NULL),
            THUD_ERROR_NULL);
    REFUSED(thud_world_overlap_shape(NULL, at, thud_obb_at(0, 0, 1, 1, 0), NULL, never, NULL),
            THUD_ERROR_NULL);
    REFUSED(thud_world_overlap_shape(world, at, thud_obb_at(0, 0, 1, 1, INFINITY), NULL, never,
                                     NULL),
            THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

static void closest_refuses_bad_input_and_leaves_outputs_alone(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_still(world, 0, 0, 1, 1, 0);
    thud_closest_hit out, untouched;
    memset(&out, 9, sizeof out);
    untouched = out;
    int count = 77;
    unsigned char hit = 2;
    bool *flag = (bool *)&hit;
    thud_pos at = {0, 5};
    REFUSED(thud_world_closest(NULL, at, 9, NULL, flag, &out), THUD_ERROR_NULL);
    REFUSED(thud_world_closest(world, (thud_pos){0, NAN}, 9, NULL, flag, &out), THUD_ERROR_INVALID);
    REFUSED(thud_world_closest(world, at, -1, NULL, flag, &out), THUD_ERROR_INVALID);
    REFUSED(thud_world_closest(world, at, NAN, NULL, flag, &out), THUD_ERROR_INVALID);
    REFUSED(thud_world_closest(world, at, INFINITY, NULL, flag, &out), THUD_ERROR_INVALID);
    OK(thud_world_closest(world, at, 9, NULL, NULL, NULL));
    thud_world_destroy(world);
}

static void queries_without_memory_say_so_and_work_once_there_is_some(void **state) {
    (void)state;
    thud_world_def def = weightless();
    def.allocator = hostile_memory();
    thud_world *world = make_world(def);
    for (int i = 0; i < 50; i++) {
        add_ball(world, 3 * i, 0, 1);
    }
    thud_ray_hit out, untouched;
    memset(&out, 9, sizeof out);
    untouched = out;
    int failures = 0, count = 77;
    unsigned char hit = 2;
    for (;; failures++) {
        memory_allowed = failures;
        thud_result result =
            thud_world_cast_ray_all(world, &(thud_ray){(thud_pos){-5, 0}, 99, 0, NULL}, &out, 1,
                                    &count);
        if (result == THUD_OK) {
            break;
        }
        REFUSED(result, THUD_ERROR_MEMORY);
    }
    memory_allowed = -1;
    assert_true(failures > 1);
    assert_int_equal(count, 32);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ray_through_all_lists_the_nearest_first),
        cmocka_unit_test(equal_fractions_are_told_in_the_order_of_slots),
        cmocka_unit_test(circle_cast_meets_faces_corners_and_circles),
        cmocka_unit_test(box_cast_meets_corners_slopes_and_turned_boxes),
        cmocka_unit_test(cast_that_starts_in_a_shape_hits_at_zero_by_the_shortest_way_out),
        cmocka_unit_test(long_slanting_way_among_many_misses_none),
        cmocka_unit_test(overlap_of_each_kind_finds_what_really_overlaps),
        cmocka_unit_test(closest_measures_from_outside_and_from_inside),
        cmocka_unit_test(queries_heed_filters_sensors_and_edits_not_stepped_yet),
        cmocka_unit_test(casts_refuse_bad_input_and_leave_outputs_alone),
        cmocka_unit_test(closest_refuses_bad_input_and_leaves_outputs_alone),
        cmocka_unit_test(queries_without_memory_say_so_and_work_once_there_is_some),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
