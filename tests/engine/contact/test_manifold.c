/* test_manifold.c: the contact of every pair of shape kinds, in either order, as a prologue is
 * given it: normal, depth, points. */
#include "engine_support.h"

/* The last contact that the prologue was given, and how many there were. */
static thud_contact seen;
static int seen_count;

/* A prologue: keeps the contact, and vetoes it. */
static bool look(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                 void *context) {
    (void)settings;
    (void)world;
    (void)context;
    seen = *contact;
    seen_count++;
    return false;
}

enum { CIRCLE, AABB, OBB, KINDS };

static void add_kind(thud_world *world, thud_body_id body, int kind) {
    add_shape(world, body, 0.5f, kind == CIRCLE ? 0 : 0.5f, kind == AABB, NULL);
}

/* Two shapes of half extent 0.5 overlap by 0.1 along x; the first may be static. */
static void meet(int kind_a, int kind_b, thud_body_kind body_a, bool b_first) {
    thud_world_def def = weightless();
    thud_world *world = make_world(def);
    set_listeners(world, look, NULL, NULL);
    thud_body_id a = {0, 0}, b = {0, 0};
    if (b_first) {
        b = add_body(world, THUD_BODY_DYNAMIC, 0.9, 0, 0);
        add_kind(world, b, kind_b);
    }
    a = add_body(world, body_a, 0, 0, 0);
    add_kind(world, a, kind_a);
    if (!b_first) {
        b = add_body(world, THUD_BODY_DYNAMIC, 0.9, 0, 0);
        add_kind(world, b, kind_b);
    }
    seen_count = 0;
    run(world, 1);
    assert_int_equal(seen_count, 1);
    bool a_is_a = seen.body_a.index1 == a.index1;
    near_to((double)seen.normal.x, a_is_a ? 1 : -1, 1e-5);
    near_to((double)seen.normal.y, 0, 1e-5);
    near_to((double)seen.separation, -0.1, 1e-5);
    near_to(seen.point.x, 0.45, 1e-5);
    near_to(seen.point.y, 0, 1e-5);
    bool boxes = kind_a != CIRCLE && kind_b != CIRCLE && (kind_a == OBB || kind_b == OBB);
    assert_int_equal(seen.point_count, boxes ? 2 : 1);
    thud_world_destroy(world);
}

static void every_pair_of_kinds_has_its_normal_depth_and_point(void **state) {
    (void)state;
    for (int a = 0; a < KINDS; a++) {
        for (int b = 0; b < KINDS; b++) {
            for (int order = 0; order < 2; order++) {
                meet(a, b, THUD_BODY_DYNAMIC, order);
                meet(a, b, THUD_BODY_STATIC, order);
                meet(a, b, THUD_BODY_KINEMATIC, order);
            }
        }
    }
}

/* Random boxes: depth and normal of the wide kernel against the closest features of the scalar
 * geometry. */
static void turned_boxes_agree_with_the_closest_features(void **state) {
    (void)state;
    uint64_t seed = 3;
    int touching = 0;
    for (int i = 0; i < 2000; i++) {
        thud_world_def def = weightless();
        thud_world *world = make_world(def);
        set_listeners(world, look, NULL, NULL);
        thud_geometry p[2];
        for (int k = 0; k < 2; k++) {
            double angle = random_in(&seed, -3, 3);
            thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, random_in(&seed, -0.8, 0.8),
                                       random_in(&seed, -0.8, 0.8), angle);
            float hx = (float)random_in(&seed, 0.2, 1), hy = (float)random_in(&seed, 0.2, 1);
            add_shape(world, id, hx, hy, false, NULL);
            thud_body_state s = state_of(world, id);
            p[k] = (thud_geometry){THUD_SHAPE_OBB, s.position.x, s.position.y, cos(s.angle),
                                   sin(s.angle),   (double)hx,   (double)hy};
        }
        thud_closest closest;
        OK(thud_geometry_closest(&p[0], &p[1], &closest));
        seen_count = 0;
        run(world, 1);
        if (closest.distance < -0.01) {
            assert_int_equal(seen_count, 1);
            /* The deepest clipped point is as deep as the axis of least overlap, except that the
             * kernel prefers faces of a. */
            near_to((double)seen.separation, closest.distance, 6e-4);
            touching++;
        } else if (closest.distance > 0.03) {
            assert_int_equal(seen_count, 0);
        }
        thud_world_destroy(world);
    }
    assert_true(touching > 500);
}

static void terrain_pushes_along_its_normal(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        thud_world_def def = weightless();
        thud_world *world = make_world(def);
        set_listeners(world, look, NULL, NULL);
        thud_shape_def plain = thud_default_shape_def();
        thud_pos points[2] = {{-5, 1}, {5, 1}};
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 2};
        thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
        OK(thud_shape_create_terrain(world, ground, &plain, &line, NULL));
        thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, 0.4, 0);
        add_kind(world, body, kind);
        seen_count = 0;
        run(world, 1);
        assert_int_equal(seen_count, 1);
        near_to((double)seen.normal.y, 1, 1e-6);
        near_to((double)seen.separation, -0.1, 1e-6);
        assert_int_equal(seen.body_a.index1, ground.index1);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pair_of_kinds_has_its_normal_depth_and_point),
        cmocka_unit_test(turned_boxes_agree_with_the_closest_features),
        cmocka_unit_test(terrain_pushes_along_its_normal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
