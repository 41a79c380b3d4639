/* test_mover_worlds.c: movers of every kind make random moves in random static worlds: none ever
 * overlaps a shape, nor moves farther than its speed, a step and a fall allow.
 *
 * A case is one move; there are 20,000, or as many as THUD_CASES of the environment says. */
#include "engine_support.h"
#include "geometry_random.h"

#include <thud/thud_mover.h>

/* MOVES of each mover in a world; TRIES to find a free place for it. */
enum { SOLIDS = 60, POINTS = 40, MOVES = 500, TRIES = 2000 };

#define DT (1.0 / 60)

static bool count_one(thud_shape_id shape, void *context) {
    (void)shape;
    ++*(int *)context;
    return true;
}

/* Whether the shape overlaps anything in the world. */
static bool is_inside(thud_world *world, const thud_geometry *shape) {
    int count = 0;
    OK(thud_world_overlap_shape(world, (thud_pos){0, 0}, *shape, NULL, count_one, &count));
    return count > 0;
}

static void add_ground(thud_world *world, source *r) {
    thud_pos points[POINTS];
    thud_terrain line = {.kind = draw_below(r, 2) ? THUD_TERRAIN_FLAT : THUD_TERRAIN_IRREGULAR,
                         .slope = draw(r, -1, 1),
                         .points = points,
                         .count = POINTS};
    double x = -40;
    for (int i = 0; i < POINTS; i++) {
        points[i] = (thud_pos){x, draw(r, 0, 5)};
        x += draw(r, 0.2, 4);
    }
    thud_shape_def def = thud_default_shape_def();
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, -6, 0), &def, &line,
                                 NULL));
}

static thud_world *make_random_world(source *r) {
    thud_world *world = make_world(weightless());
    add_ground(world, r);
    for (int i = 0; i < SOLIDS; i++) {
        thud_geometry shape = draw_shape(r);
        double angle = shape.kind == THUD_SHAPE_OBB ? draw(r, -3, 3) : 0;
        thud_body_id body =
            add_body(world, THUD_BODY_STATIC, draw(r, -20, 20), draw(r, -5, 20), angle);
        add_shape(world, body, (float)fmax(2 * shape.hx, 0.02), (float)(2 * shape.hy),
                  shape.kind == THUD_SHAPE_AABB, NULL);
    }
    return world;
}

/* Puts the mover at a random place where it overlaps nothing; false if there was none in TRIES
 * tries. */
static bool find_place(thud_world *world, source *r, thud_mover *mover) {
    for (int i = 0; i < TRIES; i++) {
        mover->shape.x = draw(r, -15, 15);
        mover->shape.y = draw(r, -3, 15);
        if (!is_inside(world, &mover->shape)) {
            return true;
        }
    }
    return false;
}

static void random_moves_in_random_worlds_never_enter_anything(void **state) {
    (void)state;
    source r = {31};
    const char *wanted = getenv("THUD_CASES");
    long cases = wanted ? strtol(wanted, NULL, 10) : 20000, on_ground = 0;
    for (long k = 0; k < cases;) {
        thud_world *world = make_random_world(&r);
        thud_geometry shape = {.kind = (thud_shape_kind)draw_below(&r, 3), .c = 1};
        shape.hx = draw(&r, 0.2, 0.8);
        shape.hy = shape.kind == THUD_SHAPE_CIRCLE ? 0 : draw(&r, 0.2, 0.8);
        set_angle(&shape, draw(&r, -3, 3));
        thud_mover mover = thud_default_mover(shape);
        thud_vec2 velocity = {0, 0};
        bool placed = find_place(world, &r, &mover);
        for (int i = 0; placed && i < MOVES && k < cases; i++, k++) {
            if (i % 15 == 0) {
                velocity = (thud_vec2){(float)draw(&r, -15, 15), (float)draw(&r, -20, 15)};
            }
            velocity.y -= 20.0f / 60;
            thud_geometry before = mover.shape;
            thud_mover_report report;
            OK(thud_mover_move(world, &mover, velocity, DT, &report));
            assert_false(is_inside(world, &mover.shape));
            double way = hypot(mover.shape.x - before.x, mover.shape.y - before.y);
            double speed = hypot((double)velocity.x, (double)velocity.y);
            assert_true(way <=
                        speed * DT + mover.step_height + mover.snap_distance + 8 * mover.skin);
            velocity = report.velocity;
            on_ground += mover.on_ground;
        }
        thud_world_destroy(world);
    }
    assert_true(on_ground > cases / 5 && on_ground < cases);
}

/* The first query applies deferred edits: a move that is refused must not. */
static void move_out_of_the_world_is_refused_before_anything_is_done(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
    add_shape(world, box, 0.5f, 0.5f, false, NULL);
    run(world, 120);
    assert_false(state_of(world, box).awake);
    thud_mover mover = thud_default_mover((thud_geometry){THUD_SHAPE_CIRCLE, 1e9, 5, 1, 0, 0.5, 0});
    mover.pass = NULL;
    OK(thud_body_set_velocity(world, box, (thud_vec2){1, 0}, 0));
    uint64_t hash = thud_hash_of(world);
    const thud_mover before = mover;
    for (int i = 0; i < 2; i++) {
        thud_vec2 velocity = {i == 0 ? 20.0f : 0.0f, i == 1 ? 20.0f : 0.0f};
        mover.shape.x = i == 1 ? 0 : before.shape.x;
        mover.shape.y = i == 1 ? 1e9 : before.shape.y;
        assert_int_equal(thud_mover_move(world, &mover, velocity, DT, NULL), THUD_ERROR_INVALID);
        assert_true(thud_hash_of(world) == hash);
        assert_int_equal(thud_stats_of(world).awake_bodies, 0);
    }
    mover.shape.y = 5;
    mover.shape.x = 1e9 - 10;
    OK(thud_mover_move(world, &mover, (thud_vec2){20, 0}, DT, NULL));
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(move_out_of_the_world_is_refused_before_anything_is_done),
        cmocka_unit_test(random_moves_in_random_worlds_never_enter_anything),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
