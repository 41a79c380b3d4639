/* test_whole_bodies.c: bodies created together with their shapes, shapes placed in one expression,
 * and defs that were not begun from their default functions. */
#include "engine_support.h"
#include "hostile_memory.h"

#include <thud/thud_edits.h>
#include <thud/thud_fields.h>
#include <thud/thud_joint.h>
#include <thud/thud_lists.h>
#include <thud/thud_mover.h>
#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>

/* ---- placed shapes ---- */

static void placed_shapes_are_what_their_names_say(void **state) {
    (void)state;
    thud_geometry disc = thud_circle_at(1, 2, 3), box = thud_aabb_at(1, 2, 3, 4);
    thud_geometry turned = thud_obb_at(1, 2, 3, 4, 0.3);
    double sine, cosine;
    OK(thud_sincos(0.3, &sine, &cosine));
    assert_true(disc.kind == THUD_SHAPE_CIRCLE && disc.x == 1 && disc.y == 2 && disc.hx == 3);
    assert_true(box.kind == THUD_SHAPE_AABB && box.hx == 3 && box.hy == 4 && box.c == 1 &&
                box.s == 0);
    assert_true(turned.kind == THUD_SHAPE_OBB && turned.c == cosine && turned.s == sine);
    OK(thud_geometry_check(&disc));
    OK(thud_geometry_check(&box));
    OK(thud_geometry_check(&turned));
    const double wrong[] = {NAN, INFINITY, 1.1 * THUD_ANGLE_MAX};
    for (int i = 0; i < 3; i++) {
        turned = thud_obb_at(1, 2, 3, 4, wrong[i]);
        assert_int_equal(thud_geometry_check(&turned), THUD_ERROR_INVALID);
    }
}

/* ---- a body with its shapes ---- */

static thud_body_def body_def(thud_body_kind kind) {
    thud_body_def def = thud_default_body_def();
    def.kind = kind;
    def.position = (thud_pos){0, 5};
    return def;
}

/* The result is the same as of single calls, to the bit, for a hundred steps. */
static void bodies_with_shapes_are_those_of_single_calls(void **state) {
    (void)state;
    thud_world *worlds[2];
    for (int i = 0; i < 2; i++) {
        worlds[i] = make_world(thud_default_world_def());
        thud_world *w = worlds[i];
        thud_body_def def = body_def(THUD_BODY_DYNAMIC);
        thud_shape_def heavy = thud_default_shape_def(), plain = thud_default_shape_def();
        heavy.density = 7;
        thud_body_id body, ground = add_body(w, THUD_BODY_STATIC, 0, 0, 0);
        add_shape(w, ground, 20, 1, true, NULL);
        thud_shape_id ids[2];
        if (i == 0) {
            OK(thud_body_create(w, &def, &body));
            OK(thud_shape_create_circle(w, body, &heavy, (thud_vec2){1, 0}, 0.5f, &ids[0]));
            OK(thud_shape_create_obb(w, body, &plain, (thud_vec2){-1, 0}, (thud_vec2){1, 0.25f},
                                     0.5, &ids[1]));
        } else {
            const thud_body_shape shapes[] = {{thud_circle_at(1, 0, 0.5), &heavy},
                                              {thud_obb_at(-1, 0, 1, 0.25, 0.5), NULL}};
            OK(thud_body_create_with_shapes(w, &def, shapes, 2, &body, ids));
        }
        assert_true(ids[0].index1 == 2 && ids[1].index1 == 3);
        for (int k = 0; k < 100; k++) {
            OK(thud_world_step(w));
        }
    }
    assert_true(thud_hash_of(worlds[0]) == thud_hash_of(worlds[1]));
    thud_world_destroy(worlds[0]);
    thud_world_destroy(worlds[1]);
}

/* The angle of a placed shape is recovered from its cosine and sine within 1e-9. */
static void angles_come_back_from_cosine_and_sine(void **state) {
    (void)state;
    thud_world *w = make_world(thud_default_world_def());
    thud_body_def def = body_def(THUD_BODY_STATIC);
    for (int i = -2000; i <= 2000; i++) {
        double angle = i / 2000.0 * 3.14159265358979;
        thud_body_shape one = {thud_obb_at(0, 0, 1, 1, angle), NULL};
        thud_shape_state s;
        thud_shape_id id;
        thud_body_id body;
        OK(thud_body_create_with_shapes(w, &def, &one, 1, &body, &id));
        OK(thud_shape_get_state(w, id, &s));
        assert_true(fabs(remainder(s.angle - angle, 2 * 3.14159265358979323846)) < 1e-9);
        OK(thud_body_destroy(w, body));
    }
    thud_world_destroy(w);
}

/* A snapshot: everything of a world except its reserved memory. */
typedef struct bytes {
    void *data;
    size_t size;
} bytes;

static bytes all_of(thud_world *w) {
    bytes all = {NULL, 0};
    OK(thud_world_get_snapshot_size(w, &all.size));
    all.data = malloc(all.size);
    OK(thud_world_snapshot(w, all.data, all.size, NULL));
    return all;
}

static void assert_unchanged(thud_world *w, bytes before) {
    bytes after = all_of(w);
    assert_int_equal(after.size, before.size);
    assert_memory_equal(after.data, before.data, before.size);
    free(after.data);
}

/* A body with one wrong shape is not created, and neither are its other shapes. */
static void one_wrong_shape_leaves_nothing_behind(void **state) {
    (void)state;
    thud_world *w = make_world(thud_default_world_def());
    add_shape(w, add_body(w, THUD_BODY_DYNAMIC, 0, 0, 0), 1, 0, false, NULL);
    thud_shape_def dense = thud_default_shape_def(), zeroed = {0};
    dense.density = -1;
    const thud_body_shape wrong[] = {
        {thud_circle_at(0, 0, -1), NULL},
        {thud_circle_at(0, 0, 1e-5), NULL},
        {thud_circle_at(NAN, 0, 1), NULL},
        {thud_circle_at(0, 17000, 1), NULL},
        {thud_aabb_at(0, 0, 1, 17000), NULL},
        {thud_obb_at(0, 0, 1, 1, NAN), NULL},
        {thud_circle_at(0, 0, 1), &dense},
        {thud_circle_at(0, 0, 1), &zeroed},
        {{.kind = THUD_SHAPE_TERRAIN, .c = 1, .hx = 1, .hy = 1}, NULL},
        {{0}, NULL},
    };
    bytes before = all_of(w);
    thud_body_def def = body_def(THUD_BODY_DYNAMIC), none = {0};
    thud_body_id body = {7, 7};
    thud_shape_id ids[3] = {{7, 7}, {7, 7}, {7, 7}};
    thud_body_shape shapes[3] = {{thud_circle_at(0, 0, 1), NULL}, {thud_aabb_at(0, 0, 1, 1), NULL}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        shapes[2] = wrong[i];
        assert_int_equal(thud_body_create_with_shapes(w, &def, shapes, 3, &body, ids),
                         THUD_ERROR_INVALID);
        assert_unchanged(w, before);
    }
    assert_int_equal(thud_body_create_with_shapes(w, &none, shapes, 2, &body, ids),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_body_create_with_shapes(w, &def, shapes, -1, &body, ids),
                     THUD_ERROR_INVALID);
    def.angle = 0.1;
    assert_int_equal(thud_body_create_with_shapes(w, &def, shapes, 2, &body, ids),
                     THUD_ERROR_INVALID);
    def.angle = 0;
    def.kind = THUD_BODY_KINEMATIC;
    def.angular_velocity = 1;
    assert_int_equal(thud_body_create_with_shapes(w, &def, shapes, 2, &body, ids),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_body_create_with_shapes(w, &def, NULL, 1, &body, ids), THUD_ERROR_NULL);
    assert_int_equal(thud_body_create_with_shapes(w, NULL, shapes, 1, &body, ids), THUD_ERROR_NULL);
    assert_int_equal(thud_body_create_with_shapes(NULL, &def, shapes, 1, &body, ids),
                     THUD_ERROR_NULL);
    assert_unchanged(w, before);
    assert_true(body.index1 == 7 && ids[0].index1 == 7 && ids[2].index1 == 7);
    OK(thud_body_create_with_shapes(w, &def, NULL, 0, NULL, NULL));
    free(before.data);
    thud_world_destroy(w);
}

/* ---- without memory ---- */

/* The context of a prologue that creates bodies: result, statistics around the call, and how many
 * allocations succeed. */
typedef struct try_made {
    thud_result result;
    thud_stats before, after;
    long allowed;
} try_made;

/* A prologue that creates a body with many shapes while an allocation fails. */
static bool make_many(thud_world *w, const thud_contact *contact, thud_contact_settings *settings,
                      void *context) {
    (void)contact, (void)settings;
    try_made *t = context;
    thud_body_def def = body_def(THUD_BODY_DYNAMIC);
    thud_body_shape shapes[100];
    for (int i = 0; i < 100; i++) {
        shapes[i] = (thud_body_shape){thud_circle_at(i, 50, 0.25), NULL};
    }
    t->before = thud_stats_of(w);
    memory_allowed = t->allowed;
    t->result = thud_body_create_with_shapes(w, &def, shapes, 100, NULL, NULL);
    memory_allowed = -1;
    t->after = thud_stats_of(w);
    return true;
}

/* For each allocation that fails, inside and outside of a callback. */
static void bodies_without_memory_are_not_made(void **state) {
    (void)state;
    for (int inside = 0; inside < 2; inside++) {
        int refused = 0;
        try_made t = {.result = THUD_ERROR_MEMORY};
        for (; t.result != THUD_OK; t.allowed++) {
            thud_world_def def = thud_default_world_def();
            def.allocator = hostile_memory();
            thud_world *w = make_world(def);
            set_listeners(w, inside ? make_many : NULL, NULL, &t);
            add_shape(w, add_body(w, THUD_BODY_DYNAMIC, 0, 0, 0), 1, 0, false, NULL);
            add_shape(w, add_body(w, THUD_BODY_STATIC, 0, -1.5, 0), 1, 1, true, NULL);
            if (inside) {
                OK(thud_world_step(w));
            } else {
                make_many(w, NULL, NULL, &t);
            }
            int more = t.result == THUD_OK;
            assert_true(more || t.result == THUD_ERROR_MEMORY);
            assert_int_equal(t.after.bodies, t.before.bodies + more);
            assert_int_equal(t.after.shapes, t.before.shapes + 100 * more);
            refused += !more;
            OK(thud_world_step(w));
            thud_world_destroy(w);
            assert_int_equal(memory_held, 0);
        }
        assert_true(refused >= 3);
    }
}

/* ---- defs not begun from their defaults ---- */

/* The last result and message of the log. */
static thud_result heard;
static char said[160];

static void hear(thud_result result, const char *message, void *context) {
    (void)context;
    heard = result;
    strncpy(said, message, sizeof said - 1);
}

static void defs_that_do_not_start_from_the_defaults_are_refused(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def(), zeroed = {0};
    def.log = zeroed.log = hear;
    thud_world *w = make_world(def), *none = NULL;
    thud_body_id a = add_body(w, THUD_BODY_STATIC, 0, 0, 0),
                 b = add_body(w, THUD_BODY_DYNAMIC, 2, 0, 0);
    thud_body_def body = {.gravity_scale = 1, .may_sleep = true};
    thud_shape_def shape = {.density = 1, .filter = {1, 1, 0}};
    thud_joint_def joint = thud_default_joint_def(THUD_JOINT_HINGE);
    thud_explosion blast = {.impulse = 1, .rays = 5};
    thud_water water = {.normal = {0, 1}, .density = 1};
    joint.body_a = a;
    joint.body_b = b;
    joint.cookie = 0;
    const thud_result results[] = {
        thud_world_create(&zeroed, &none),
        thud_body_create(w, &body, NULL),
        thud_shape_create_circle(w, b, &shape, (thud_vec2){0, 0}, 1, NULL),
        thud_joint_create(w, &joint, NULL),
        thud_world_explode(w, &blast, NULL),
        thud_body_apply_buoyancy(w, b, &water),
    };
    for (size_t i = 0; i < sizeof results / sizeof *results; i++) {
        assert_int_equal(results[i], THUD_ERROR_INVALID);
    }
    assert_null(none);
    heard = THUD_OK;
    assert_int_equal(thud_body_create(w, &body, NULL), THUD_ERROR_INVALID);
    assert_int_equal(heard, THUD_ERROR_INVALID);
    assert_string_equal(said, "body_create: the def does not start from thud_default_body_def()");
    thud_joint_id made;
    thud_joint_def again;
    joint.cookie = thud_default_joint_def(THUD_JOINT_HINGE).cookie;
    OK(thud_joint_create(w, &joint, &made));
    OK(thud_joint_get_def(w, made, &again));
    OK(thud_joint_create(w, &again, NULL));
    thud_world_destroy(w);
}

/* The structs without a cookie whose defaults are not zero (thud.h). */
static void zeroed_filters_rules_and_movers_are_refused(void **state) {
    (void)state;
    thud_world *w = make_world(thud_default_world_def());
    thud_query_filter filter = {0};
    thud_rule rule = {0};
    thud_mover mover = {0};
    thud_ray_hit hit;
    bool any;
    thud_ray ray = {.dy = -1, .filter = &filter};
    assert_int_equal(thud_world_cast_ray(w, &ray, &any, &hit), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_set_rule(w, 1, 2, &rule), THUD_ERROR_INVALID);
    assert_int_equal(thud_mover_move(w, &mover, (thud_vec2){0, 0}, 0.1, NULL), THUD_ERROR_INVALID);
    thud_world_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(placed_shapes_are_what_their_names_say),
        cmocka_unit_test(bodies_with_shapes_are_those_of_single_calls),
        cmocka_unit_test(angles_come_back_from_cosine_and_sine),
        cmocka_unit_test(one_wrong_shape_leaves_nothing_behind),
        cmocka_unit_test(bodies_without_memory_are_not_made),
        cmocka_unit_test(defs_that_do_not_start_from_the_defaults_are_refused),
        cmocka_unit_test(zeroed_filters_rules_and_movers_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
