/* test_explode.c: explosions (thud_fields.h): the impulse by distance, partial cover, and which
 * bodies are pushed. */
#include "engine_support.h"

#include <thud/thud_fields.h>

static thud_explosion blast_at(double x, double y) {
    thud_explosion blast = thud_default_explosion();
    blast.center = (thud_pos){x, y};
    blast.radius = 10;
    blast.impulse = 3;
    return blast;
}

/* Returns how many bodies were pushed. */
static int explode(thud_world *world, thud_explosion blast) {
    int pushed = -1;
    OK(thud_world_explode(world, &blast, &pushed));
    return pushed;
}

/* A ball 1 wide is given its width times the impulse; beyond the radius the impulse falls to 0 over
 * the distance `falloff`. A negative impulse pulls. */
static void a_ball_gets_its_diameter_and_less_further_out(void **state) {
    (void)state;
    const double distance[] = {0.75, 2.5, 4.9, 5.1};
    const double part[] = {1, 0.625, 0.025, 0};
    for (int i = 0; i < 4; i++) {
        thud_world *world = make_world(weightless());
        thud_body_id ball =
            add_ball(world, 0.6 * (distance[i] + 0.5), 0.8 * (distance[i] + 0.5), 0.5f);
        thud_explosion blast = blast_at(0, 0);
        blast.radius = 1;
        blast.falloff = 4;
        blast.rays = 1;
        assert_int_equal(explode(world, blast), part[i] > 0);
        thud_body_state s = state_of(world, ball);
        near_to((double)s.velocity.x, 0.6 * 3 * part[i] / (double)s.mass, 1e-5);
        near_to((double)s.velocity.y, 0.8 * 3 * part[i] / (double)s.mass, 1e-5);
        near_to((double)s.angular_velocity, 0, 1e-5);
        blast.impulse = -3;
        explode(world, blast);
        near_to((double)state_of(world, ball).velocity.x, 0, 1e-5);
        thud_world_destroy(world);
    }
}

/* A box at (4, 0) after an explosion at the origin, with a wall in between where half_y is > 0. */
static thud_body_state pushed_behind(thud_body_kind kind, double y, float half_y, thud_cover cover,
                                     int rays) {
    thud_world *world = make_world(weightless());
    thud_body_id box = add_box(world, 4, 0, 0.5f, 0.5f);
    if (half_y > 0) {
        add_shape(world, add_body(world, kind, 2, y, 0), 0.1f, half_y, false, NULL);
    }
    thud_explosion blast = blast_at(0, 0);
    blast.cover = cover;
    blast.rays = rays;
    explode(world, blast);
    thud_body_state s = state_of(world, box);
    thud_world_destroy(world);
    return s;
}

/* A wall between explosion and box covers it by the options `cover` and `rays`: completely, or half
 * of it. */
static void cover_is_partial(void **state) {
    (void)state;
    for (int rays = 1; rays <= THUD_EXPLOSION_RAYS_MAX; rays++) {
        double all = (double)pushed_behind(THUD_BODY_STATIC, 0, 0, THUD_COVER_ALL, rays).velocity.x;
        near_to(all, 3, 0.03);
        for (int kind = THUD_BODY_STATIC; kind <= THUD_BODY_DYNAMIC; kind++) {
            thud_body_kind k = (thud_body_kind)kind;
            thud_body_state s = pushed_behind(k, 0, 2, THUD_COVER_ALL, rays);
            assert_true(s.velocity.x == 0 && s.angular_velocity == 0);
            s = pushed_behind(k, 0, 2, THUD_COVER_STATIC, rays);
            near_to((double)s.velocity.x, k == THUD_BODY_DYNAMIC ? all : 0, 1e-6);
            s = pushed_behind(k, 0, 2, THUD_COVER_NONE, rays);
            near_to((double)s.velocity.x, all, 1e-6);
        }
        /* The lower half of the box is covered: the impulse acts on the upper half, and turns the
         * box clockwise. */
        thud_body_state s = pushed_behind(THUD_BODY_STATIC, -2.001, 2, THUD_COVER_ALL, rays);
        near_to((double)s.velocity.x, all * (double)((rays + 1) / 2) / (double)rays, 0.03);
        assert_true(rays == 1 || s.angular_velocity < -0.1f);
    }
}

/* A hill covers the ball behind it. A floor does not cover a ball that stands on it from an
 * explosion at the height of its surface. */
static void ground_hides_and_the_edge_of_a_floor_does_not(void **state) {
    (void)state;
    const thud_pos hill[] = {{-20, 0}, {-2, 0}, {0, 3}, {2, 0}, {20, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 5};
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id ground;
    thud_world *world = make_world(weightless());
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 &ground));
    thud_body_id behind = add_ball(world, 4, 0.5, 0.5f), before = add_ball(world, -6, 0.5, 0.5f);
    assert_int_equal(explode(world, blast_at(-4, 0.25)), 1);
    assert_true(state_of(world, behind).velocity.x == 0 && state_of(world, before).velocity.x < 0);
    /* The explosion is exactly on the terrain, as where a shot has hit it. */
    assert_int_equal(explode(world, blast_at(6, 0)), 1);
    assert_true(state_of(world, behind).velocity.x < 0);
    thud_world_destroy(world);
    world = make_world(weightless());
    add_floor(world, NULL);
    behind = add_ball(world, 4, 0.5, 0.5f);
    before = add_ball(world, 4, -2.5, 0.5f);
    for (int i = -8; i < 15; i++) {
        OK(thud_body_set_velocity(world, behind, (thud_vec2){0, 0}, 0));
        assert_int_equal(explode(world, blast_at(0.7 * i, 0)), 1);
        assert_true(state_of(world, behind).velocity.x != 0);
    }
    thud_world_destroy(world);
}

/* An explosion's filter selects categories and ignores a body; sensors do not cover, and disabled
 * bodies are not pushed. */
static void filters_sensors_and_bodies_of_several_shapes(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def(), sensor = def;
    sensor.sensor = true;
    def.filter.category = 2;
    thud_body_id pair = add_body(world, THUD_BODY_DYNAMIC, 3, 0, 0),
                 other = add_ball(world, -3, 0, 0.5f);
    thud_vec2 ahead = {-1, 0};
    thud_shape_id ball;
    OK(thud_shape_create_circle(world, pair, &def, (thud_vec2){0, 0}, 0.5f, &ball));
    OK(thud_shape_create_circle(world, pair, &def, ahead, 0.5f, &ball));
    add_shape(world, add_body(world, THUD_BODY_STATIC, 1, 0, 0), 0.1f, 3, true, &sensor);
    thud_explosion blast = blast_at(0, 0);
    blast.rays = 1;
    blast.filter.mask = 2;
    assert_int_equal(explode(world, blast), 1);
    thud_body_state s = state_of(world, pair);
    /* shapes of one body do not cover each other */
    near_to((double)s.velocity.x, 2 * 3 / (double)s.mass, 1e-5);
    assert_true(state_of(world, other).velocity.x == 0);
    blast.filter.mask = UINT32_MAX;
    blast.filter.ignore = pair;
    assert_int_equal(explode(world, blast), 1);
    assert_true(state_of(world, other).velocity.x < 0);
    OK(thud_body_set_enabled(world, other, false));
    assert_int_equal(explode(world, blast), 0);
    thud_world_destroy(world);
}

/* An explosion wakes a sleeping box, and pushes one that contains its centre. One out of reach
 * pushes nothing; too many rays are refused. */
static void sleepers_wake_and_what_holds_the_centre_is_pushed(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    thud_body_id box = add_box(world, 0, 0.5, 0.5f, 0.5f);
    run(world, 120);
    assert_false(state_of(world, box).awake);
    assert_int_equal(explode(world, blast_at(0.1, state_of(world, box).center.y)), 1);
    run(world, 1);
    assert_true(state_of(world, box).awake);
    near_to((double)state_of(world, box).velocity.x, -3, 0.2);
    thud_explosion far = blast_at(100, 0);
    assert_int_equal(explode(world, far), 0);
    thud_explosion wrong = blast_at(0, 0);
    wrong.rays = THUD_EXPLOSION_RAYS_MAX + 1;
    assert_int_equal(thud_world_explode(world, &wrong, NULL), THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

/* The context of an epilogue that explodes. */
typedef struct bomb {
    thud_body_id ball;
    int asked;
} bomb;

/* An epilogue that explodes once; its impulses are deferred to the next step. */
static void explode_once(thud_world *world, const thud_contact *contact, void *context) {
    bomb *b = context;
    (void)contact;
    if (b->asked++ == 0) {
        int pushed = explode(world, blast_at(20, 5));
        assert_int_equal(pushed, 1);
        assert_true(state_of(world, b->ball).velocity.x == 0);
    }
}

/* An explosion inside an epilogue acts in the next step. */
static void inside_callbacks_it_acts_through_the_next_step(void **state) {
    (void)state;
    bomb b = {.asked = 0};
    thud_world_def def = weightless();
    thud_world *world = make_world(def);
    set_listeners(world, NULL, explode_once, &b);
    b.ball = add_ball(world, 24, 5, 0.5f);
    add_floor(world, NULL);
    add_ball(world, -9, 0.499, 0.5f);
    run(world, 1);
    assert_true(b.asked > 0 && state_of(world, b.ball).velocity.x == 0);
    run(world, 1);
    assert_true(state_of(world, b.ball).velocity.x > 3);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_gets_its_diameter_and_less_further_out),
        cmocka_unit_test(cover_is_partial),
        cmocka_unit_test(ground_hides_and_the_edge_of_a_floor_does_not),
        cmocka_unit_test(filters_sensors_and_bodies_of_several_shapes),
        cmocka_unit_test(sleepers_wake_and_what_holds_the_centre_is_pushed),
        cmocka_unit_test(inside_callbacks_it_acts_through_the_next_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
