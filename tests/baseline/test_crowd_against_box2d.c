/* test_crowd_against_box2d.c: compares events, filters, and quantities of whole crowds with
 * Box2D's: energy, momentum, the height of a heap. Paths of single bodies are chaotic there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "duel.h"
#include "scenes.h"

/* Ten separate balls: each lands once, faster than 1 m/s, and stays. */
static void events_ten_balls_dropped_begin_and_hit_once_each(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 20, 1);
    for (int i = 0; i < 10; i++)
        scene_dynamic_circle(&d.scene, 2 * i - 9, 1.5 + 0.1 * i, 0.5);
    duel_begin(&d);
    duel_step(&d, 120);
    for (int e = 0; e < ENGINES; e++) {
        assert_int_equal(d.events[e].begin, 10);
        assert_int_equal(d.events[e].end, 0);
        assert_int_equal(d.events[e].hit, 10);
    }
    duel_end(&d);
}

/* With restitution 0.9 from 3 m the landings are at 0.77, 2.17 and 3.42 s: three within 3.8 s, and
 * the ball leaves the floor after each. */
static void events_bouncing_ball_begins_and_ends_alike(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 10, 1);
    scene_dynamic_circle(&d.scene, 0, 3.5, 0.5);
    d.scene.shapes[1].material.restitution = 0.9;
    duel_begin(&d);
    duel_step(&d, 228);
    for (int e = 0; e < ENGINES; e++) {
        assert_int_equal(d.events[e].begin, 3);
        assert_int_equal(d.events[e].end, 3);
    }
    duel_end(&d);
}

static void events_ball_through_sensor_enters_and_leaves_once(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, 0, 1, 1);
    d.scene.shapes[0].sensor = true;
    scene_dynamic_circle(&d.scene, 0, 3, 0.25);
    duel_begin(&d);
    duel_step(&d, 90);
    for (int e = 0; e < ENGINES; e++) {
        assert_int_equal(d.events[e].sensor_begin, 1);
        assert_int_equal(d.events[e].sensor_end, 1);
        assert_int_equal(d.events[e].begin, 0);
        assert_true(d.bodies[e][1].y < -2);
    }
    duel_end(&d);
}

/* The floor's mask excludes category 2, a positive group overrides it, and a negative group
 * excludes a pair that the masks allow. */
static void filters_decide_alike_who_falls_through(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 10, 1);
    d.scene.shapes[0].mask = ~2u;
    d.scene.shapes[0].group = 5;
    scene_static_box(&d.scene, 30, -1, 10, 1);
    d.scene.shapes[1].group = -3;
    const struct {
        double x;
        uint32_t category;
        int32_t group;
        bool falls;
    } balls[] = {
        {-4, 1, 0, false}, {0, 2, 0, true}, {4, 2, 5, false}, {28, 1, -3, true}, {32, 1, 0, false}};
    for (int i = 0; i < 5; i++) {
        scene_dynamic_circle(&d.scene, balls[i].x, 1, 0.5);
        d.scene.shapes[2 + i].category = balls[i].category;
        d.scene.shapes[2 + i].group = balls[i].group;
    }
    duel_begin(&d);
    duel_step(&d, 90);
    for (int e = 0; e < ENGINES; e++)
        for (int i = 0; i < 5; i++)
            assert_true((d.bodies[e][2 + i].y < 0) == balls[i].falls);
    duel_end(&d);
}

static void begin_scene(duel *d, const scene_info *info, int size) {
    duel_init(d);
    scene_free(&d->scene);
    assert_true(scenes_fill(info, size, &d->scene));
    duel_begin(d);
}

/* Mass-weighted means over the dynamic bodies, and their kinetic energy. */
typedef struct crowd {
    double mass, height, momentum_x, momentum_y, kinetic;
} crowd;

static crowd crowd_of(const duel *d, int engine) {
    crowd c = {0};
    for (int i = 0; i < d->scene.body_count; i++) {
        const engine_body *b = &d->bodies[engine][i];
        if (d->scene.bodies[i].kind != SCENE_DYNAMIC)
            continue;
        c.mass += b->mass;
        c.height += b->mass * b->y;
        c.momentum_x += b->mass * b->vx;
        c.momentum_y += b->mass * b->vy;
        c.kinetic += 0.5 * b->mass * (b->vx * b->vx + b->vy * b->vy) +
                     0.5 * b->inertia * b->angular_velocity * b->angular_velocity;
    }
    c.height /= c.mass;
    return c;
}

/* The packing of a random heap varies by one or two percent. An energy per mass of 0.05 J/kg is a
 * mean speed of 0.3 m/s, at which nearly all energy of the fall is lost. */
static void crowd_circle_pit_settles_at_equal_height_and_comes_to_rest(void **state) {
    (void)state;
    duel d;
    begin_scene(&d, &scene_circle_pit, 400);
    duel_step(&d, 600);
    crowd own = crowd_of(&d, THUD), other = crowd_of(&d, BOX2D);
    assert_near(own.height, other.height, 0.03 * other.height);
    assert_true(own.kinetic / own.mass < 0.05);
    assert_true(other.kinetic / other.mass < 0.05);
    duel_end(&d);
}

/* The momentum is that of the hammer, up to rounding over thousands of contacts. The energy that
 * remains is about that of a perfectly inelastic impact; the rest depends on the order of impacts.
 */
static void crowd_smash_keeps_momentum_and_loses_energy_alike(void **state) {
    (void)state;
    duel d;
    begin_scene(&d, &scene_smash, 300);
    crowd start = crowd_of(&d, THUD);
    duel_step(&d, 120);
    crowd after[ENGINES] = {crowd_of(&d, THUD), crowd_of(&d, BOX2D)};
    for (int e = 0; e < ENGINES; e++) {
        assert_near(after[e].momentum_x, start.momentum_x, 1e-3 * start.momentum_x);
        assert_near(after[e].momentum_y, 0, 1e-3 * start.momentum_x);
        assert_true(after[e].kinetic < start.kinetic);
    }
    assert_near(after[THUD].kinetic, after[BOX2D].kinetic, 0.15 * start.kinetic);
    duel_end(&d);
}

/* No body may leave the drum, whose corner is sqrt(2) * (inner + wall) from the centre. */
static void crowd_tumbler_keeps_everybody_inside(void **state) {
    (void)state;
    duel d;
    begin_scene(&d, &scene_tumbler_half, 100);
    duel_step(&d, 600);
    double center = d.scene.bodies[0].y, inner = center;
    for (int e = 0; e < ENGINES; e++)
        for (int i = 1; i < d.scene.body_count; i++)
            assert_true(hypot(d.bodies[e][i].x, d.bodies[e][i].y - center) < sqrt(2) * inner);
    duel_end(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(events_ten_balls_dropped_begin_and_hit_once_each),
        cmocka_unit_test(events_bouncing_ball_begins_and_ends_alike),
        cmocka_unit_test(events_ball_through_sensor_enters_and_leaves_once),
        cmocka_unit_test(filters_decide_alike_who_falls_through),
        cmocka_unit_test(crowd_circle_pit_settles_at_equal_height_and_comes_to_rest),
        cmocka_unit_test(crowd_smash_keeps_momentum_and_loses_energy_alike),
        cmocka_unit_test(crowd_tumbler_keeps_everybody_inside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
