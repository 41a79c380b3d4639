/* test_arrivals.c: what meets bodies that lie against others under `swept` is solved with all their
 * contacts (detection/arrivals.c): it costs few impacts, and has what an impact has: friction, a
 * hit event, a prologue that is asked once, an epilogue. */
#include "engine_support.h"

#include <thud/thud_events.h>
#include <thud/thud_listeners.h>
#include <thud/thud_make.h>

#include "build_thud.h"
#include "scenes.h"

/* A pit of circles in the 60 steps in which most of them land. */
static void landing_heap_has_few_impacts(void **state) {
    (void)state;
    scene s;
    thud_world *world;
    thud_world_def def = thud_default_world_def();
    long impacts = 0, bodies = 0, held = 0;
    def.detection = &thud_detection_swept;
    assert_true(scenes_fill(scenes_find("circle_pit"), 1000, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    run(world, 70);
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        impacts += stats.impacts;
        held += stats.held_bodies;
        bodies += stats.awake_bodies;
    }
    print_message("a body and step: %.3f impacts, %.4f held\n", (double)impacts / (double)bodies,
                  (double)held / (double)bodies);
    assert_true(impacts < bodies / 4);
    assert_true(held < bodies / 200);
    thud_world_destroy(world);
    scene_free(&s);
}

/* What the listeners of a world have seen. */
typedef struct ear {
    int asked, told;       /* about the ball */
    bool refuses, decides; /* the answer of the prologue */
    thud_body_id ball;
    float impulse; /* normal impulse of the epilogue */
} ear;

static bool is_of_ball(const ear *e, const thud_contact *c) {
    return c->body_a.index1 == e->ball.index1 || c->body_b.index1 == e->ball.index1;
}

static bool ask(thud_world *world, const thud_contact *c, thud_contact_settings *settings,
                void *context) {
    (void)settings;
    ear *e = context;
    if (!is_of_ball(e, c)) {
        return true;
    }
    e->asked++;
    if (e->decides) {
        thud_velocities up = {.velocity = {0.0f, 7.0f}};
        bool is_a = c->body_a.index1 == e->ball.index1;
        OK(thud_contact_decide(world, c, is_a ? &up : NULL, is_a ? NULL : &up));
    }
    return !e->refuses;
}

static void tell(thud_world *world, const thud_contact *c, void *context) {
    (void)world;
    ear *e = context;
    if (is_of_ball(e, c)) {
        e->told++;
        e->impulse = c->normal_impulse;
    }
}

/* A row of boxes side by side on the ground, and a ball, 0.1 above the joint of two, that falls
 * onto it obliquely: at the one step that follows it meets bodies that touch others. */
static thud_world *make_row(float friction, thud_body_id *ball) {
    thud_world_def def = thud_default_world_def();
    def.detection = &thud_detection_swept;
    def.sleeping = false;
    thud_world *world = make_world(def);
    thud_body_options options = {.friction = friction};
    thud_body_make(world, thud_aabb_at(0, -1, 20, 1), &options);
    options.kind = THUD_BODY_DYNAMIC;
    for (int i = -3; i < 3; i++) {
        thud_body_make(world, thud_aabb_at(i + 0.5, 0.5, 0.5, 0.5), &options);
    }
    run(world, 60);
    options.velocity = (thud_vec2){4.0f, -12.0f};
    *ball = thud_body_make(world, thud_circle_at(0.45, 1.6, 0.5), &options);
    return world;
}

/* The ball gets the spin that Coulomb's friction gives it against what is heavy or does not move:
 * it slides at 4, so that the impulse is friction times the normal one, m 12, and the disc, whose
 * moment of inertia is m r^2 / 2, turns by 12 friction 2 / r in all steps together. */
static void arrival_has_friction(void **state) {
    (void)state;
    for (int rough = 0; rough < 2; rough++) {
        thud_body_id ball;
        thud_world *world = make_row(rough ? 0.05f : 1e-6f, &ball);
        thud_body_state s;
        run(world, 1);
        OK(thud_body_get_state(world, ball, &s));
        assert_true(fabs((double)s.velocity.y) < 1.0);
        double expected = rough ? -12.0 * 0.05 * 2.0 / 0.5 : 0.0, most = rough ? 0.3 : 1e-3;
        assert_true(fabs((double)s.angular_velocity - expected) < most);
        thud_world_destroy(world);
    }
}

/* One hit event, at the speed with which the ball comes, and one epilogue with its impulse. */
static void arrival_is_told(void **state) {
    (void)state;
    ear e = {0};
    thud_world *world = make_row(0.3f, &e.ball);
    thud_listeners listens = {.prologue = ask, .epilogue = tell, .context = &e};
    OK(thud_world_set_listeners(world, &listens));
    run(world, 1);
    thud_events events;
    OK(thud_world_get_events(world, &events));
    assert_int_equal(events.hit_count, 1);
    assert_true(events.hit[0].speed > 11.0f && events.hit[0].speed < 13.0f);
    assert_int_equal(e.asked, 1);
    assert_int_equal(e.told, 1);
    assert_true(e.impulse > 0.0f);
    thud_world_destroy(world);
}

/* A prologue that refuses lets the ball through, and one that decides gives it its velocity; each
 * is asked once in the step. */
static void arrival_asks_the_prologue_once(void **state) {
    (void)state;
    for (int decides = 0; decides < 2; decides++) {
        ear e = {.refuses = !decides, .decides = decides};
        thud_world *world = make_row(0.3f, &e.ball);
        thud_listeners listens = {.prologue = ask, .epilogue = tell, .context = &e};
        thud_body_state s;
        OK(thud_world_set_listeners(world, &listens));
        run(world, 1);
        OK(thud_body_get_state(world, e.ball, &s));
        assert_int_equal(e.asked, 1);
        if (decides) {
            assert_true(fabs((double)s.velocity.y - 7.0) < 0.2);
            assert_int_equal(e.told, 1);
        } else {
            assert_true(s.velocity.y < -11.0f);
            assert_int_equal(e.told, 0);
        }
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(landing_heap_has_few_impacts),
        cmocka_unit_test(arrival_has_friction),
        cmocka_unit_test(arrival_is_told),
        cmocka_unit_test(arrival_asks_the_prologue_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
