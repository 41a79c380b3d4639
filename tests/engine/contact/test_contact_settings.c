/* test_contact_settings.c: what a prologue's settings (friction, restitution, surface speed) do
 * under every detection, which values are refused, and the impulses that the epilogue is given. */
#include "resolution_support.h"

/* ---- settings of a prologue ---- */

/* The prologue's context: the settings that it sets while `granted`; `heard` counts refusals in the
 * log. */
typedef struct wish {
    thud_contact_settings settings;
    bool granted;
    int heard;
} wish;

/* A prologue that sets the context's settings while they are granted. */
static bool wish_for(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    (void)world;
    assert_in_range(contact->point_count, 1, 2);
    assert_true(fabsf(contact->separation) < 1);
    const wish *w = context;
    if (w->granted) {
        *settings = w->settings;
    }
    return true;
}

/* While a prologue sets friction to 0 a box slides on at its velocity; afterwards the shapes'
 * friction stops it. */
static void ice_of_a_prologue_lasts_as_long_as_it_says(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int kind = 1; kind < 3; kind++) {
            wish w = {{0, 0, 0}, false, 0};
            thud_world *world = make_world_with(detections[d], wish_for, &w, true);
            add_floor(world, NULL);
            thud_body_id box = add_kind(world, kind, 0, 0.5, NULL);
            OK(thud_body_set_velocity(world, box, (thud_vec2){5, 0}, 0));
            run(world, 10);
            double speed = (double)state_of(world, box).velocity.x;
            /* friction acts; its impulse must not be kept for the steps without friction */
            assert_true(speed < 4.5);
            w.granted = true;
            run(world, 120);
            near_to((double)state_of(world, box).velocity.x, speed, 1e-4);
            w.granted = false;
            run(world, 60);
            near_to((double)state_of(world, box).velocity.x, 0, 1e-3);
            thud_world_destroy(world);
        }
    }
}

/* While a prologue sets a surface speed the box is carried at it; afterwards it stops. */
static void belt_of_a_prologue_carries_and_stops(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        wish w = {{0.6f, 0, -3}, true, 0};
        thud_world *world = make_world_with(detections[d], wish_for, &w, true);
        add_floor(world, NULL);
        thud_body_id box = add_kind(world, 2, 0, 0.5, NULL);
        run(world, 60);
        near_to((double)state_of(world, box).velocity.x, -3, 0.01);
        w.granted = false;
        run(world, 60);
        near_to((double)state_of(world, box).velocity.x, 0, 1e-3);
        thud_world_destroy(world);
    }
}

/* The greatest speed in m/s at which a body leaves the floor after a fall from a height under
 * 10 m/s^2, from its velocity and height in any step after. */
static double bounce(const thud_detection *detection, int kind, float restitution, double height) {
    wish w = {{0.6f, restitution, 0}, true, 0};
    thud_world *world = make_world_with(detection, wish_for, &w, true);
    add_floor(world, NULL);
    thud_body_id ball = add_kind(world, kind, 0, 0.5 + height, NULL);
    double fastest = 0;
    for (int i = 0; i < 90; i++) {
        run(world, 1);
        thud_body_state s = state_of(world, ball);
        double up = (double)s.velocity.y;
        fastest = up > 0 ? fmax(fastest, sqrt(up * up + 20 * (s.position.y - 0.5))) : fastest;
    }
    thud_world_destroy(world);
    return fastest;
}

static void trampoline_of_a_prologue_bounces_as_high_as_it_says(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int kind = 0; kind < 3; kind++) {
            /* Without restitution the soft solver returns up to 0.42 at some heights, which is
             * nothing that this test is about. */
            for (int i = 0; i < 20; i++) {
                near_to(bounce(detections[d], kind, 0, 4.8 + 0.02 * i), 0, 0.45);
            }
            near_to(bounce(detections[d], kind, 0.5f, 5), 5, 0.005);
            near_to(bounce(detections[d], kind, 1, 5), 10, 0.005);
            near_to(bounce(detections[d], kind, 1.5f, 5), 15, 0.005);
        }
    }
}

/* The upward speed in m/s of a box that lies on the floor and is then thrown down. */
static float thrown_down(bool by_def) {
    wish w = {{0.6f, 1, 0}, false, 0};
    thud_world *world = make_world_with(&thud_detection_overlap, wish_for, &w, true);
    thud_shape_def floor = thud_default_shape_def();
    floor.restitution = by_def ? 1 : 0;
    add_floor(world, &floor);
    thud_body_id box = add_kind(world, 2, 0, 0.5, NULL);
    run(world, 30);
    w.granted = !by_def;
    OK(thud_body_set_velocity(world, box, (thud_vec2){0, -5}, 0));
    run(world, 1);
    float speed = state_of(world, box).velocity.y;
    thud_world_destroy(world);
    return speed;
}

/* The box has a manifold that is kept from step to step; its normal velocity has to be determined
 * anew when restitution is set. */
static void restitution_of_a_prologue_is_that_of_a_def_for_what_rests_too(void **state) {
    (void)state;
    assert_true(thrown_down(true) > 4);
    near_to((double)thrown_down(false), (double)thrown_down(true), 1e-4);
}

/* A ball hits a belt under `swept`: friction also turns the ball, so it gets a third of the belt's
 * speed. */
static void impact_within_the_step_heeds_surface_speed_and_friction(void **state) {
    (void)state;
    for (int rough = 0; rough < 2; rough++) {
        wish w = {{rough ? 1.0f : 0.02f, 1, 3}, true, 0};
        thud_world *world = make_world_with(&thud_detection_swept, wish_for, &w, false);
        add_floor(world, NULL);
        thud_body_id ball = add_kind(world, 0, 0, 3, NULL);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -10}, 0));
        run(world, 30);
        thud_body_state s = state_of(world, ball);
        near_to((double)s.velocity.y, 10, 1e-3);
        near_to((double)s.velocity.x, rough ? 1 : 0.02 * 20, 0.002);
        thud_world_destroy(world);
    }
}

/* The log: counts the refusals of a prologue's settings. */
static void count_message(thud_result result, const char *message, void *context) {
    assert_int_equal(result, THUD_ERROR_INVALID);
    assert_non_null(strstr(message, "prologue"));
    ++*(int *)context;
}

/* The world's hash after some steps with or without the prologue. */
static uint64_t hash_after(const thud_detection *detection, wish *w, bool asks) {
    thud_world_def def = thud_default_world_def();
    def.detection = detection;
    def.log = count_message;
    def.log_context = &w->heard;
    thud_world *world = make_world(def);
    set_listeners(world, asks ? wish_for : NULL, NULL, w);
    thud_shape_def belt = surface(0.5f, 1);
    belt.restitution = 0.3f;
    add_floor(world, &belt);
    for (int i = 0; i < 12; i++) {
        add_kind(world, i % 3, i % 4 * 1.2, 1 + i / 4 * 1.1, NULL);
    }
    run(world, 60);
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    return hash;
}

/* Wrong settings are logged and the contact keeps the shapes' settings: the world ends with the
 * hash of one without a prologue. */
static void settings_out_of_range_are_refused_and_the_pair_keeps_its_own(void **state) {
    (void)state;
    const thud_contact_settings bad[] = {{-1, 0, 0},         {2e6f, 0, 0},
                                         {NAN, 0, 0},        {INFINITY, 0, 0},
                                         {0.5f, -0.1f, 0},   {0.5f, 4.1f, 0},
                                         {0.5f, NAN, 0},     {0.5f, INFINITY, 0},
                                         {0.5f, 0, NAN},     {0.5f, 0, 1.1e6f},
                                         {0.5f, 0, -1.1e6f}, {0.5f, 0, -INFINITY}};
    for (int d = 0; d < DETECTIONS; d++) {
        wish none = {{0, 0, 0}, false, 0};
        uint64_t plain = hash_after(detections[d], &none, false);
        assert_true(hash_after(detections[d], &none, true) == plain);
        assert_int_equal(none.heard, 0);
        for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
            wish w = {bad[i], true, 0};
            assert_true(hash_after(detections[d], &w, true) == plain);
            assert_true(w.heard > 0);
        }
    }
}

/* A shape with a wrong surface speed is refused; a negative one is valid. */
static void surface_speed_out_of_range_is_no_shape(void **state) {
    (void)state;
    const float bad[] = {NAN, INFINITY, -INFINITY, 1.1e6f, -1.1e6f};
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        thud_shape_def def = surface(0.5f, bad[i]);
        thud_shape_id id;
        assert_int_equal(thud_shape_create_circle(world, body, &def, (thud_vec2){0, 0}, 1, &id),
                         THUD_ERROR_INVALID);
    }
    assert_int_equal(state_of(world, body).shape_count, 0);
    thud_shape_def def = surface(0.5f, -2);
    thud_shape_state shape;
    OK(thud_shape_get_state(world, add_shape(world, body, 1, 1, true, &def), &shape));
    assert_true(shape.surface_speed == -2);
    thud_world_destroy(world);
}

/* ---- the epilogue ---- */

/* Sums of the impulses that an epilogue was given. */
typedef struct pushes {
    double normal, tangent;
} pushes;

static void add_up(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    pushes *p = context;
    p->normal += (double)contact->normal_impulse;
    p->tangent += (double)contact->tangent_impulse;
}

/* The impulses given to the epilogue sum to the momentum that friction took and to the weight times
 * the time. */
static void epilogue_hears_all_of_friction_and_weight(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int quality = 0; quality < QUALITIES; quality++) {
            pushes p = {0, 0};
            thud_world_def def = thud_default_world_def();
            def.detection = detections[d];
            def.quality = qualities[quality];
            thud_world *world = make_world(def);
            set_listeners(world, NULL, add_up, &p);
            add_floor(world, NULL);
            thud_body_id box = add_kind(world, 2, 0, 0.5, NULL);
            run(world, 30);
            p = (pushes){0, 0};
            OK(thud_body_set_velocity(world, box, (thud_vec2){9, 0}, 0));
            run(world, 30);
            thud_body_state s = state_of(world, box);
            double mass = (double)s.mass, lost = mass * (double)(s.velocity.x - 9.0f);
            assert_true(lost < -2 * mass);
            near_to(p.tangent, lost, -0.01 * lost);
            near_to(p.normal, mass * 10 * 0.5, 0.05 * mass);
            thud_world_destroy(world);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ice_of_a_prologue_lasts_as_long_as_it_says),
        cmocka_unit_test(belt_of_a_prologue_carries_and_stops),
        cmocka_unit_test(trampoline_of_a_prologue_bounces_as_high_as_it_says),
        cmocka_unit_test(restitution_of_a_prologue_is_that_of_a_def_for_what_rests_too),
        cmocka_unit_test(impact_within_the_step_heeds_surface_speed_and_friction),
        cmocka_unit_test(settings_out_of_range_are_refused_and_the_pair_keeps_its_own),
        cmocka_unit_test(surface_speed_out_of_range_is_no_shape),
        cmocka_unit_test(epilogue_hears_all_of_friction_and_weight),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
