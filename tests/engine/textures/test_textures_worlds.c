/* test_textures_worlds.c: textured ground (thud_textured.h) beside what else decides about a
 * contact or a line: detections, qualities, rules, prologues, sleep, edits, and calls that are
 * refused. */
#include "textured_support.h"

#include "hostile_memory.h"

/* ---- as the friction of a shape ---- */

static double even(double x) {
    (void)x;
    return (double)0.3f;
}

/* From vertex to vertex it goes up and down. */
static double uneven(double x) {
    return 0.5 + 0.4 * sin(7 * x);
}

static double growing(double x) {
    return 0.5 + 0.01 * x;
}

/* Balls and boxes fall on level ground and are thrown along it, so that there are contacts that
 * last and, with bisect and swept, collisions within a step. The ground has friction 0.3, by its
 * def or by a texture. */
static thud_world *lively(int detection, int quality, int kind, bool has_texture) {
    thud_world_def def = thud_default_world_def();
    def.detection = detections[detection];
    def.quality = qualities[quality];
    textured t = {.world = make_world(def)};
    uint64_t seed = 5;
    add_ground(&t, (thud_terrain_kind)kind, -2, has_texture ? 0.9f : 0.3f);
    if (has_texture) {
        set_friction(&t, even);
    }
    for (int i = 0; i < 14; i++) {
        thud_shape_def material = thud_default_shape_def();
        material.friction = (float)random_in(&seed, 0.1, 0.9);
        material.restitution = i % 3 ? 0 : 0.6f;
        thud_body_id body = add_body(t.world, THUD_BODY_DYNAMIC, 1.5 * i - 10,
                                     random_in(&seed, 0.6, 3), i % 3 == 2 ? 0 : 0.2 * i);
        add_shape(t.world, body, 0.4f, i % 3 ? 0.3f : 0, i % 3 == 2, &material);
        OK(thud_body_set_velocity(t.world, body,
                                  (thud_vec2){(float)random_in(&seed, -6, 6),
                                              (float)random_in(&seed, -20, 0)},
                                  i % 3 == 2 ? 0 : 1));
    }
    return t.world;
}

static void even_texture_gives_the_bits_of_that_friction(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES * LINES; i++) {
        int detection = i % DETECTIONS, quality = i / DETECTIONS % QUALITIES;
        int kind = i / DETECTIONS / QUALITIES;
        thud_world *a = lively(detection, quality, kind, false);
        thud_world *b = lively(detection, quality, kind, true);
        int impacts = 0;
        for (int step = 0; step < 200; step++) {
            run(a, 1);
            run(b, 1);
            impacts += thud_stats_of(a).impacts;
            if (thud_hash_of(a) != thud_hash_of(b)) {
                fail_msg("detection %d, quality %d, line %d: step %d differs", detection, quality,
                         kind, step);
            }
        }
        assert_true(detection < 2 || impacts > 0);
        thud_world_destroy(a);
        thud_world_destroy(b);
    }
}

/* ---- prologues and rules ---- */

/* What a prologue saw, and what it answers. */
typedef struct watcher {
    const textured *t;
    int seen;
    float body_friction; /* of the body; NaN: a rule has set the pair's */
    float expected;      /* then */
    float answer;        /* friction; negative: that which it is given */
} watcher;

static bool watch(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)world;
    watcher *at = context;
    float friction = at->expected;
    if (at->body_friction == at->body_friction) {
        friction = sqrtf(friction_of(at->t, contact->point.x) * at->body_friction);
    }
    near_to((double)settings->friction, (double)friction, 1e-6);
    settings->friction = at->answer >= 0 ? at->answer : settings->friction;
    at->seen++;
    return true;
}

/* The prologue sees the friction of where the contact stands in that step: also of a slow body,
 * whose manifold is kept from step to step, after it has answered with another one, and of
 * collisions within a step. */
static void prologue_sees_the_friction_of_the_place_and_may_change_it(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * LINES * 2; i++) {
        thud_world_def def = thud_default_world_def();
        def.detection = detections[i % DETECTIONS];
        def.sleeping = false;
        textured t = {.world = make_world(def)};
        add_ground(&t, (thud_terrain_kind)(i / DETECTIONS % LINES), 4, 0.9f);
        set_friction(&t, t.line.kind == THUD_TERRAIN_FLAT ? growing : uneven);
        watcher w = {.t = &t,
                     .body_friction = 0.4f,
                     .answer = i / DETECTIONS / LINES ? 0.001f : -1};
        set_listeners(t.world, watch, NULL, &w);
        thud_shape_def material = thud_default_shape_def();
        material.friction = 0.4f;
        thud_body_id box = add_body(t.world, THUD_BODY_DYNAMIC, 0, 0.2, 0);
        add_shape(t.world, box, 0.5f, 0.2f, false, &material);
        thud_body_id ball = add_body(t.world, THUD_BODY_DYNAMIC, 3, 5, 0);
        add_shape(t.world, ball, 0.3f, 0, false, &material);
        OK(thud_body_set_velocity(t.world, box, (thud_vec2){0.05f, 0}, 0));
        OK(thud_body_set_velocity(t.world, ball, (thud_vec2){3, -30}, 0));
        /* It rolls slowly over a vertex. */
        thud_body_id slow = add_body(t.world, THUD_BODY_DYNAMIC, 4 + t.points[60].x - 0.01, 0.3, 0);
        add_shape(t.world, slow, 0.3f, 0, false, &material);
        OK(thud_body_set_velocity(t.world, slow, (thud_vec2){0.04f, 0}, -0.13f));
        run(t.world, 60);
        assert_true(w.seen > 60);
        /* It slides on where the answer takes the friction away. */
        bool slides = state_of(t.world, box).velocity.x > 0.03f;
        assert_true(slides == (w.answer >= 0));
        thud_world_destroy(t.world);
    }
}

/* A rule's friction replaces the texture's; without one its other settings leave the texture. */
static void rule_with_a_friction_overrules_the_texture(void **state) {
    (void)state;
    for (int i = 0; i < 2 * DETECTIONS; i++) {
        bool has_friction = i < DETECTIONS;
        thud_world_def def = thud_default_world_def();
        def.detection = detections[i % DETECTIONS];
        textured t = {.world = make_world(def)};
        add_ground(&t, THUD_TERRAIN_UNIFORM, 0, 0.9f);
        set_friction(&t, growing);
        thud_rule rule = thud_default_rule();
        rule.friction = has_friction ? 0.125f : rule.friction;
        rule.surface_speed = 2;
        OK(thud_world_set_rule(t.world, 1, 2, &rule));
        watcher w = {.t = &t,
                     .body_friction = has_friction ? __builtin_nanf("") : 0.6f,
                     .expected = 0.125f,
                     .answer = -1};
        set_listeners(t.world, watch, NULL, &w);
        thud_shape_def material = thud_default_shape_def();
        material.filter.category = 2;
        thud_body_id box = add_body(t.world, THUD_BODY_DYNAMIC, 0, 0.6, 0);
        add_shape(t.world, box, 0.5f, 0.2f, false, &material);
        OK(thud_body_set_velocity(t.world, box, (thud_vec2){0, -20}, 0));
        run(t.world, 60);
        assert_true(w.seen > 30 && fabs((double)state_of(t.world, box).velocity.x) > 0.1);
        thud_world_destroy(t.world);
    }
}

/* Without prologue, and without texture, contacts have the friction of their shapes again. */
static void texture_that_is_taken_away_leaves_the_shapes_friction(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    textured t = {.world = make_world(def)};
    add_ground(&t, THUD_TERRAIN_IRREGULAR, 0, 0.64f);
    thud_shape_def material = thud_default_shape_def();
    material.friction = 1;
    thud_body_id box = add_body(t.world, THUD_BODY_DYNAMIC, 0, 0.2, 0);
    add_shape(t.world, box, 0.5f, 0.2f, false, &material);
    run(t.world, 120);
    assert_false(state_of(t.world, box).awake);
    set_friction(&t, growing);
    run(t.world, 1);
    assert_true(state_of(t.world, box).awake); /* bodies on the line wake */
    run(t.world, 120);
    assert_false(state_of(t.world, box).awake);
    OK(thud_shape_set_texture(t.world, t.shape, NULL));
    assert_true(friction_of(&t, 0) == 0.64f);
    watcher w = {.t = &t, .body_friction = 1, .answer = -1};
    set_listeners(t.world, watch, NULL, &w);
    run(t.world, 3);
    assert_true(w.seen > 3 && state_of(t.world, box).awake);
    OK(thud_shape_set_texture(t.world, t.shape, NULL));
    thud_texture none = {.count = 9};
    OK(thud_shape_get_texture(t.world, t.shape, &none));
    assert_true(!none.vertices && !none.table && none.count == 0 && none.table_count == 0);
    thud_world_destroy(t.world);
}

/* ---- edits of the line ---- */

/* Asserts that the friction is still that of `growing` from x = -39 to 39. */
static void still_grows(const textured *t) {
    for (double x = -39; x < 39; x += 0.0973) {
        near_to((double)friction_of(t, x), growing(x), 1e-6);
    }
}

/* Where friction is linear in x, vertices that come and go do not change it. */
static void edits_leave_the_texture_where_it_lies(void **state) {
    (void)state;
    uint64_t seed = 9;
    for (int kind = THUD_TERRAIN_UNIFORM; kind <= THUD_TERRAIN_IRREGULAR; kind++) {
        textured t = {.world = make_world(thud_default_world_def())};
        add_ground(&t, (thud_terrain_kind)kind, 0, 0.9f);
        set_friction(&t, growing);
        add_box(t.world, 1, 0.5, 0.5f, 0.5f);
        for (int i = 0; i < 60; i++) {
            double x = random_in(&seed, -38, 38), r = random_in(&seed, 0.1, 3);
            OK(i % 2 ? thud_shape_raise(t.world, t.shape, x, r, r - 1)
                     : thud_shape_dig(t.world, t.shape, (thud_pos){x, 0.3}, r));
            run(t.world, 1);
            still_grows(&t);
        }
        const double heights[] = {1, 2, 0.5};
        OK(thud_shape_set_heights(t.world, t.shape, 40, heights, 3));
        still_grows(&t);
        thud_terrain line;
        thud_texture texture;
        OK(thud_shape_get_terrain(t.world, t.shape, &line));
        OK(thud_shape_get_texture(t.world, t.shape, &texture));
        assert_int_equal(texture.count, line.count);
        assert_true(kind == THUD_TERRAIN_UNIFORM || line.count > VERTICES);
        thud_world_destroy(t.world);
    }
}

/* A peak of friction is cut with its vertex, the ends stay as they are, and a body that stands on a
 * changed segment gets the friction of the present one. */
static void replaced_vertices_get_the_value_of_their_place(void **state) {
    (void)state;
    const double values[] = {0.1, 0.9, 0.1, 0.3};
    const thud_pos points[] = {{0, 0}, {10, 0}, {20, 0}, {30, 0}}, more[] = {{35, 0}, {40, 2}};
    const thud_pos fine[] = {{4, 0}, {6, 0}};
    textured t = {.world = make_world(thud_default_world_def())};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
    thud_shape_def def = thud_default_shape_def();
    t.body = add_body(t.world, THUD_BODY_STATIC, 0, 0, 0);
    OK(thud_shape_create_terrain(t.world, t.body, &def, &line, &t.shape));
    OK(thud_shape_set_texture(t.world, t.shape, &(thud_texture){.vertices = values, .count = 4}));
    add_box(t.world, 8, 0.5, 0.5f, 0.5f);
    watcher w = {.t = &t, .body_friction = 0.6f, .answer = -1};
    set_listeners(t.world, watch, NULL, &w);
    run(t.world, 5);
    OK(thud_shape_replace_range(t.world, t.shape, 3, 7, fine, 2));
    near_to((double)friction_of(&t, 5), 0.5, 1e-6);
    near_to((double)friction_of(&t, 8), 0.74, 1e-6);
    OK(thud_shape_replace_range(t.world, t.shape, 8, 12, NULL, 0));
    near_to((double)friction_of(&t, 6), 0.58, 1e-6);
    near_to((double)friction_of(&t, 13), 0.34, 1e-6);
    run(t.world, 5);
    OK(thud_shape_replace_range(t.world, t.shape, 35, 40, more, 2));
    near_to((double)friction_of(&t, 40), 0.3, 1e-6);
    near_to((double)friction_of(&t, 33), 0.3, 1e-6);
    near_to((double)friction_of(&t, 1e6), 0.3, 1e-6);
    near_to((double)friction_of(&t, -5), 0.1, 1e-6);
    assert_true(w.seen > 9);
    thud_world_destroy(t.world);
}

/* A line in the slot of one that was destroyed has no texture, and one on a body that is moved
 * takes its texture along. */
static void texture_goes_with_its_line(void **state) {
    (void)state;
    textured t = {.world = make_world(thud_default_world_def())};
    add_ground(&t, THUD_TERRAIN_UNIFORM, 0, 0.9f);
    set_friction(&t, growing);
    OK(thud_body_set_transform(t.world, t.body, (thud_pos){5, 1}, 0));
    run(t.world, 1);
    near_to((double)friction_of(&t, 5), growing(0), 1e-6);
    OK(thud_shape_destroy(t.world, t.shape));
    run(t.world, 1);
    add_ground(&t, THUD_TERRAIN_UNIFORM, 0, 0.25f);
    assert_true(friction_of(&t, 5) == 0.25f);
    thud_world_destroy(t.world);
}

/* ---- refused ---- */

static bool edit_inside(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)contact, (void)settings;
    const textured *t = context;
    assert_int_equal(thud_shape_set_texture(world, t->shape, NULL), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_use_textures(world), THUD_ERROR_LOCKED);
    return true;
}

static void wrong_textures_are_refused_and_change_nothing(void **state) {
    (void)state;
    textured t = {.world = make_world(thud_default_world_def())};
    double values[VERTICES] = {0.5}, bad[] = {-1, 1e7, __builtin_nan(""), __builtin_inf()};
    float table[] = {0.5f, 1}, bad_entry[] = {-1, 1e7f, __builtin_nanf(""), __builtin_inff()};
    thud_texture good = {.vertices = values, .count = VERTICES}, wrong = good, out;
    thud_body_id box = add_box(t.world, 0, 0.4, 0.5f, 0.5f);
    thud_shape_id shape = add_shape(t.world, box, 0.5f, 0.5f, false, NULL);
    add_ground(&t, THUD_TERRAIN_UNIFORM, 0, 0.9f);
    thud_shape_id stale = t.shape;
    stale.generation++;
    set_friction(&t, growing);
    assert_int_equal(thud_shape_set_texture(NULL, t.shape, &good), THUD_ERROR_NULL);
    assert_int_equal(thud_shape_set_texture(t.world, stale, &good), THUD_ERROR_STALE);
    assert_int_equal(thud_shape_set_texture(t.world, shape, &good), THUD_ERROR_INVALID);
    assert_int_equal(thud_shape_set_texture(t.world, shape, NULL), THUD_ERROR_INVALID);
    wrong.vertices = NULL;
    assert_int_equal(thud_shape_set_texture(t.world, t.shape, &wrong), THUD_ERROR_NULL);
    for (int count = -1; count < 2 * VERTICES; count++) {
        wrong = good;
        wrong.count = count;
        if (count != VERTICES) {
            assert_int_equal(thud_shape_set_texture(t.world, t.shape, &wrong), THUD_ERROR_INVALID);
        }
    }
    const int counts[] = {-1, 0, THUD_TERRAIN_COUNT_MAX + 1, INT32_MAX};
    for (int i = 0; i < 4; i++) {
        wrong = good;
        wrong.table = table;
        wrong.table_count = counts[i];
        assert_int_equal(thud_shape_set_texture(t.world, t.shape, &wrong), THUD_ERROR_INVALID);
        wrong.table_count = 2;
        table[1] = bad_entry[i];
        assert_int_equal(thud_shape_set_texture(t.world, t.shape, &wrong), THUD_ERROR_INVALID);
        table[1] = 1;
        values[VERTICES - 1] = bad[i];
        assert_int_equal(thud_shape_set_texture(t.world, t.shape, &good), THUD_ERROR_INVALID);
        values[VERTICES - 1] = 1.1e9;
        assert_int_equal(thud_shape_set_texture(t.world, t.shape, &wrong), THUD_ERROR_INVALID);
        values[VERTICES - 1] = 0;
    }
    wrong = good;
    wrong.table_count = 1;
    assert_int_equal(thud_shape_set_texture(t.world, t.shape, &wrong), THUD_ERROR_INVALID);
    assert_int_equal(thud_shape_get_texture(NULL, t.shape, &out), THUD_ERROR_NULL);
    assert_int_equal(thud_shape_get_texture(t.world, stale, &out), THUD_ERROR_STALE);
    assert_int_equal(thud_shape_get_texture(t.world, shape, &out), THUD_ERROR_INVALID);
    float friction = 7;
    assert_int_equal(thud_shape_get_friction_at(NULL, t.shape, 0, &friction), THUD_ERROR_NULL);
    assert_int_equal(thud_shape_get_friction_at(t.world, stale, 0, &friction), THUD_ERROR_STALE);
    assert_int_equal(thud_shape_get_friction_at(t.world, shape, 0, &friction), THUD_ERROR_INVALID);
    for (int i = 2; i < 4; i++) {
        assert_int_equal(thud_shape_get_friction_at(t.world, t.shape, bad[i], &friction),
                         THUD_ERROR_INVALID);
    }
    assert_true(friction == 7);
    assert_int_equal(thud_world_use_textures(NULL), THUD_ERROR_NULL);
    OK(thud_shape_get_texture(t.world, t.shape, NULL));
    OK(thud_shape_get_friction_at(t.world, t.shape, 0, NULL));
    set_listeners(t.world, edit_inside, NULL, &t);
    run(t.world, 3);
    still_grows(&t);
    /* Its own arrays may be given back. */
    OK(thud_shape_get_texture(t.world, t.shape, &out));
    OK(thud_shape_set_texture(t.world, t.shape, &out));
    still_grows(&t);
    thud_world_destroy(t.world);
}

/* Sets a texture and edits the line with every allocation failing in turn. */
static void without_memory_texture_and_line_stay_as_they_were(void **state) {
    (void)state;
    for (long allowed = 0, done = 0; done < 2; allowed++) {
        thud_world_def def = thud_default_world_def();
        def.allocator = hostile_memory();
        memory_allowed = -1;
        memory_held = 0;
        textured t = {.world = make_world(def)};
        add_ground(&t, THUD_TERRAIN_IRREGULAR, 0, 0.75f);
        double values[VERTICES], u[VERTICES];
        const float table[] = {0, 1};
        for (int i = 0; i < VERTICES; i++) {
            values[i] = growing(t.points[i].x);
            u[i] = growing(t.points[i].x);
        }
        memory_allowed = allowed;
        thud_result result =
            thud_shape_set_texture(t.world, t.shape, &(thud_texture){u, VERTICES, table, 2, false});
        memory_allowed = -1;
        done = result == THUD_OK;
        if (result != THUD_OK) {
            assert_int_equal(result, THUD_ERROR_MEMORY);
            assert_true(friction_of(&t, 3) == 0.75f);
            run(t.world, 1);
            OK(thud_shape_set_texture(t.world, t.shape,
                                      &(thud_texture){.vertices = values, .count = VERTICES}));
        }
        still_grows(&t);
        memory_allowed = allowed;
        result = thud_shape_dig(t.world, t.shape, (thud_pos){0, 0.3}, 2);
        memory_allowed = -1;
        done += result == THUD_OK;
        assert_true(result == THUD_OK || result == THUD_ERROR_MEMORY);
        thud_terrain line;
        thud_texture texture;
        OK(thud_shape_get_terrain(t.world, t.shape, &line));
        OK(thud_shape_get_texture(t.world, t.shape, &texture));
        assert_int_equal(texture.count, line.count);
        assert_true((result == THUD_OK) == (line.count > VERTICES));
        still_grows(&t);
        thud_world_destroy(t.world);
        assert_int_equal(memory_held, 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(even_texture_gives_the_bits_of_that_friction),
        cmocka_unit_test(prologue_sees_the_friction_of_the_place_and_may_change_it),
        cmocka_unit_test(rule_with_a_friction_overrules_the_texture),
        cmocka_unit_test(texture_that_is_taken_away_leaves_the_shapes_friction),
        cmocka_unit_test(edits_leave_the_texture_where_it_lies),
        cmocka_unit_test(replaced_vertices_get_the_value_of_their_place),
        cmocka_unit_test(texture_goes_with_its_line),
        cmocka_unit_test(wrong_textures_are_refused_and_change_nothing),
        cmocka_unit_test(without_memory_texture_and_line_stay_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
