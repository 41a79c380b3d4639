/* test_body_contacts.c: the contacts of a body as thud_body_get_contacts reports them, and how the
 * debug drawing shows contacts, pairs and colours. */
#include "engine_support.h"

/* The contact of a body that has exactly one. */
static thud_manifold only_contact_of(thud_world *world, thud_body_id body) {
    thud_manifold all[4];
    int count = -1;
    OK(thud_body_get_contacts(world, body, all, 4, &count));
    assert_int_equal(count, 1);
    return all[0];
}

static thud_world *world_with_box_at_rest(thud_body_id *box) {
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    *box = add_box(world, 3, 0.5, 1, 0.5f);
    run(world, 60);
    return world;
}

static void box_at_rest_stands_on_two_points_that_carry_its_weight(void **state) {
    (void)state;
    thud_body_id box;
    thud_world *world = world_with_box_at_rest(&box);
    thud_manifold m = only_contact_of(world, box);
    assert_int_equal(m.point_count, 2);
    assert_int_equal(m.body_b.index1, box.index1);
    near_to(m.normal.x, 0, 1e-4);
    near_to(m.normal.y, 1, 1e-6);
    near_to(fabs(m.point[0].x - m.point[1].x), 2, 0.02);
    near_to(0.5 * (m.point[0].x + m.point[1].x), 3, 0.02);
    near_to(m.point[0].y, 0, 0.02);
    near_to(m.separation[0], 0, 0.01);
    /* mass 2 kg, gravity 10 m/s^2, a step of 1/60 s */
    near_to(m.normal_impulse[0] + m.normal_impulse[1], 2.0 * 10 / 60, 0.02);
    near_to(m.tangent_impulse, 0, 1e-3);
    assert_false(m.direct);
    thud_world_destroy(world);
}

static void heavy_box_on_a_light_one_is_solved_directly(void **state) {
    (void)state;
    thud_body_id light;
    thud_world *world = world_with_box_at_rest(&light);
    thud_shape_def dense = thud_default_shape_def();
    dense.density = 2000;
    thud_body_id heavy = add_body(world, THUD_BODY_DYNAMIC, 3, 1.5, 0);
    add_shape(world, heavy, 1, 0.5f, false, &dense);
    run(world, 60);
    assert_true(only_contact_of(world, heavy).direct);
    thud_world_destroy(world);
}

static void bodies_apart_and_bodies_removed_have_no_contacts(void **state) {
    (void)state;
    thud_body_id box;
    thud_world *world = world_with_box_at_rest(&box);
    int count = -1;
    OK(thud_body_get_contacts(world, add_ball(world, 0, 9, 1), NULL, 0, &count));
    assert_int_equal(count, 0);
    thud_body_id second = add_box(world, 3, 1.5, 1, 0.5f);
    run(world, 10);
    OK(thud_body_get_contacts(world, box, NULL, 0, &count));
    assert_int_equal(count, 2);
    OK(thud_body_destroy(world, second));
    only_contact_of(world, box);
    thud_world_destroy(world);
}

static void contacts_refuse_what_they_cannot_do(void **state) {
    (void)state;
    thud_body_id box;
    thud_world *world = world_with_box_at_rest(&box);
    thud_manifold one;
    int count = 7;
    assert_int_equal(thud_body_get_contacts(NULL, box, &one, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_body_get_contacts(world, box, NULL, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_body_get_contacts(world, box, &one, 1, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_body_get_contacts(world, box, &one, -1, &count), THUD_ERROR_INVALID);
    OK(thud_body_destroy(world, box));
    assert_int_equal(thud_body_get_contacts(world, box, &one, 1, &count), THUD_ERROR_STALE);
    assert_int_equal(count, 7);
    thud_world_destroy(world);
}

/* ---- drawing ---- */

/* What a debug drawing called back with, by style. */
typedef struct seen {
    int lines[THUD_STYLE_COUNT], points[THUD_STYLE_COUNT];
    double length[THUD_STYLE_COUNT]; /* total length of the lines */
} seen;

static void on_line(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    seen *k = context;
    k->lines[style]++;
    k->length[style] += hypot((double)(b.x - a.x), (double)(b.y - a.y));
}

static void on_point(thud_vec2 p, thud_style style, void *context) {
    (void)p;
    ((seen *)context)->points[style]++;
}

static seen draw(thud_world *world, unsigned flags) {
    seen k = {0};
    thud_debug_draw d = {.flags = flags,
                         .lower = {-20, -10},
                         .upper = {20, 10},
                         .context = &k,
                         .line = on_line,
                         .point = on_point};
    OK(thud_world_draw(world, &d));
    return k;
}

static void manifolds_are_points_with_depth_and_impulse(void **state) {
    (void)state;
    thud_body_id box;
    thud_world *world = world_with_box_at_rest(&box);
    seen k = draw(world, THUD_DRAW_MANIFOLDS);
    assert_int_equal(k.points[THUD_STYLE_MANIFOLD], 2);
    assert_int_equal(k.lines[THUD_STYLE_DEPTH], 2);
    /* the length drawn for an impulse: the distance that its velocity covers in one second */
    near_to(k.length[THUD_STYLE_IMPULSE], 10.0 / 60, 0.01);
    thud_world_destroy(world);
}

/* The drawing of stages has a line in its own style for pairs whose fat bounds overlap, whose
 * bounds overlap, and which touch. */
static void stages_tell_fat_bounds_from_true_ones_from_touching(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_ball(world, 0, 0, 0.5f);
    add_ball(world, 1.04, 0, 0.5f); /* only the fat bounds overlap */
    add_ball(world, 0, 5, 0.5f);
    add_ball(world, 0.8, 5.8, 0.5f); /* the bounds overlap, the circles do not */
    add_ball(world, 9, 0, 0.5f);
    add_ball(world, 9.95, 0, 0.5f);
    run(world, 1);
    seen k = draw(world, THUD_DRAW_STAGES);
    assert_int_equal(k.lines[THUD_STYLE_PAIR_CANDIDATE], 1);
    assert_int_equal(k.lines[THUD_STYLE_PAIR], 1);
    assert_int_equal(k.lines[THUD_STYLE_PAIR_TOUCHING], 1);
    thud_world_destroy(world);
}

static void colours_of_a_stack_alternate(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    for (int i = 0; i < 4; i++) {
        add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    run(world, 30);
    seen k = draw(world, THUD_DRAW_COLOURS);
    /* One contact with the floor and three between boxes; neighbouring contacts share a body, and
     * so differ in colour. */
    int total = 0;
    for (int style = THUD_STYLE_COLOUR; style <= THUD_STYLE_COLOUR_LAST; style++) {
        total += k.lines[style];
    }
    assert_int_equal(total, 4);
    assert_true(k.lines[THUD_STYLE_COLOUR] >= 1 && k.lines[THUD_STYLE_COLOUR + 1] >= 1);
    thud_world_destroy(world);
}

static void pairs_solved_directly_are_marked_with_the_islands(void **state) {
    (void)state;
    thud_body_id light;
    thud_world *world = world_with_box_at_rest(&light);
    assert_int_equal(draw(world, THUD_DRAW_ISLANDS).lines[THUD_STYLE_DIRECT], 0);
    thud_shape_def dense = thud_default_shape_def();
    dense.density = 2000;
    thud_body_id heavy = add_body(world, THUD_BODY_DYNAMIC, 3, 1.5, 0);
    add_shape(world, heavy, 1, 0.5f, false, &dense);
    run(world, 60);
    assert_int_equal(draw(world, THUD_DRAW_ISLANDS).lines[THUD_STYLE_DIRECT], 2);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_at_rest_stands_on_two_points_that_carry_its_weight),
        cmocka_unit_test(heavy_box_on_a_light_one_is_solved_directly),
        cmocka_unit_test(bodies_apart_and_bodies_removed_have_no_contacts),
        cmocka_unit_test(contacts_refuse_what_they_cannot_do),
        cmocka_unit_test(manifolds_are_points_with_depth_and_impulse),
        cmocka_unit_test(stages_tell_fat_bounds_from_true_ones_from_touching),
        cmocka_unit_test(colours_of_a_stack_alternate),
        cmocka_unit_test(pairs_solved_directly_are_marked_with_the_islands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
