/* test_rules.c: collision rules between categories of shapes, the caller's own filter, and events
 * of contacts that exceed an impulse limit (thud_rules.h). */
#include "rules_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_listeners.h>

/* ---- which categories collide ---- */

static void ignored_kinds_fall_through(void **unused) {
    (void)unused;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int b = 0; b < BROADPHASES; b++) {
            thud_world *w = make(detections[d], broadphases[b]);
            thud_rule ignore = rule_of_kind(THUD_RULE_IGNORE);
            OK(thud_world_set_rule(w, GROUND, CRATE, &ignore));
            add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
            thud_body_id crate = add(w, THUD_BODY_DYNAMIC, CRATE, 2, -3, 3, 0.5f, 0.5f);
            thud_body_id player = add(w, THUD_BODY_DYNAMIC, PLAYER, 0, 3, 3, 0.5f, 0);
            steps(w, 120);
            assert_true(get(w, crate).position.y < -5);
            assert_true(fabs(get(w, player).position.y - 0.5) < 0.02);
            assert_int_equal(thud_events_of(w).begin_count, 0);
            thud_world_destroy(w);
        }
    }
}

/* A rule also applies to contacts that exist: a sleeping crate wakes, falls through the plank, and
 * rests on the ground. */
static void a_rule_takes_hold_of_what_touches(void **unused) {
    (void)unused;
    thud_world *w = make(NULL, NULL);
    thud_rule ignore = rule_of_kind(THUD_RULE_IGNORE);
    add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
    add(w, THUD_BODY_STATIC, PLANK, 2, 0, 2, 3, 0.1f);
    thud_body_id crate = add(w, THUD_BODY_DYNAMIC, CRATE, 2, 0, 2.6, 0.5f, 0.5f);
    steps(w, 200);
    assert_false(get(w, crate).awake);
    OK(thud_world_set_rule(w, CRATE, PLANK, &ignore));
    steps(w, 1);
    assert_int_equal(thud_events_of(w).end_count, 1);
    steps(w, 200);
    assert_true(fabs(get(w, crate).position.y - 0.5) < 0.02);
    /* Without the rule the plank collides with the crate again, which is below it by now. */
    OK(thud_world_set_rule(w, PLANK, CRATE, NULL));
    throw_up(w, crate, 0, 12);
    steps(w, 40);
    assert_true(get(w, crate).position.y < 1.5);
    thud_world_destroy(w);
}

/* For rules, a shape is of the category of its lowest category bit; a changed filter changes
 * that. */
static void the_lowest_bit_is_the_kind(void **unused) {
    (void)unused;
    thud_world *w = make(NULL, NULL);
    thud_rule ignore = rule_of_kind(THUD_RULE_IGNORE);
    OK(thud_world_set_rule(w, GROUND, PLAYER, &ignore));
    add(w, THUD_BODY_STATIC, GROUND | CRATE, 2, 0, -1, 20, 1);
    thud_body_id both = add(w, THUD_BODY_DYNAMIC, PLAYER | CRATE, 2, -3, 1, 0.5f, 0.5f);
    thud_shape_def def = of_kind(CRATE);
    thud_body_id later = add_body(w, THUD_BODY_DYNAMIC, 3, 1, 0);
    thud_shape_id shape = add_shape(w, later, 0.5f, 0.5f, false, &def);
    steps(w, 60);
    assert_true(get(w, both).position.y < -1);
    assert_true(fabs(get(w, later).position.y - 0.5) < 0.02);
    OK(thud_shape_set_filter(w, shape, (thud_filter){PLAYER, UINT32_MAX, 0}));
    steps(w, 60);
    assert_true(get(w, later).position.y < -1);
    thud_world_destroy(w);
}

/* ---- surfaces ---- */

/* Rules give pairs of categories ice, a belt, or a trampoline. */
static void rules_make_surfaces(void **unused) {
    (void)unused;
    thud_world *w = make(NULL, NULL);
    thud_rule ice = thud_default_rule(), belt = ice, trampoline = ice;
    ice.friction = 0;
    belt.surface_speed = 2;
    trampoline.restitution = 1;
    OK(thud_world_set_rule(w, GROUND, CRATE, &ice));
    OK(thud_world_set_rule(w, GROUND, PLAYER, &belt));
    OK(thud_world_set_rule(w, 16, GROUND, &trampoline));
    add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 100, 1);
    thud_body_id crate = add(w, THUD_BODY_DYNAMIC, CRATE, 2, -5, 0.5, 0.5f, 0.5f);
    thud_body_id player = add(w, THUD_BODY_DYNAMIC, PLAYER, 2, 0, 0.5, 0.5f, 0.5f);
    thud_body_id ball = add(w, THUD_BODY_DYNAMIC, 16, 0, 5, 3, 0.5f, 0);
    throw_up(w, crate, -3, 0);
    double highest = 0;
    for (int i = 0; i < 120; i++) {
        steps(w, 1);
        highest = i > 60 ? fmax(highest, get(w, ball).position.y) : 0;
    }
    assert_true(fabs((double)get(w, crate).velocity.x + 3) < 1e-3);
    assert_true(fabs((double)get(w, player).velocity.x - 2) < 1e-3);
    assert_true(highest > 2.7);
    /* Rules change while contacts touch; without a rule, the settings of the shapes hold. */
    belt.surface_speed = -1;
    OK(thud_world_set_rule(w, PLAYER, GROUND, &belt));
    steps(w, 120);
    assert_true(fabs((double)get(w, player).velocity.x + 1) < 1e-3);
    OK(thud_world_set_rule(w, GROUND, CRATE | PLAYER, NULL));
    steps(w, 120);
    assert_true(fabs((double)get(w, player).velocity.x) < 1e-3);
    assert_true(fabs((double)get(w, crate).velocity.x) < 1e-3);
    thud_world_destroy(w);
}

/* A prologue that sets friction to 0.8 where the rule made it 0, else to 0.1. */
static bool last_word(thud_world *w, const thud_contact *contact, thud_contact_settings *settings,
                      void *context) {
    (void)w, (void)contact;
    ++*(int *)context;
    settings->friction = settings->friction == 0 ? 0.8f : 0.1f;
    return true;
}

/* The prologue is given the settings of the rule, anew in each step, and is not called for bodies
 * that pass a one-way shape. */
static void a_prologue_comes_after_the_rules(void **unused) {
    (void)unused;
    thud_world *w = make(NULL, NULL);
    int asked = 0;
    thud_rule ice = thud_default_rule(), one_way = rule_of_kind(THUD_RULE_ONE_WAY);
    ice.friction = 0;
    OK(thud_world_set_rule(w, GROUND, CRATE, &ice));
    OK(thud_world_set_rule(w, PLANK, PLAYER, &one_way));
    OK(thud_world_set_listeners(w, &(thud_listeners){.prologue = last_word, .context = &asked}));
    add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 100, 1);
    thud_body_id crate = add(w, THUD_BODY_DYNAMIC, CRATE, 2, -5, 0.5, 0.5f, 0.5f);
    throw_up(w, crate, 4, 0);
    steps(w, 60);
    assert_true(fabs((double)get(w, crate).velocity.x) < 1e-3);
    assert_true(asked >= 60 && asked < 64);
    OK(thud_world_set_listeners(w, NULL));
    throw_up(w, crate, 4, 0);
    steps(w, 30);
    assert_true((double)get(w, crate).velocity.x > 3.99);
    thud_world_destroy(w);

    w = make(NULL, NULL);
    OK(thud_world_set_rule(w, PLANK, PLAYER, &one_way));
    OK(thud_world_set_listeners(w, &(thud_listeners){.prologue = last_word, .context = &asked}));
    asked = 0;
    add(w, THUD_BODY_STATIC, PLANK, 2, 0, 0, 3, 0.4f);
    add(w, THUD_BODY_DYNAMIC, PLAYER, 2, 0, 0, 0.2f, 0.2f);
    steps(w, 10);
    assert_int_equal(asked, 0);
    thud_world_destroy(w);
}

/* ---- impulse limits ---- */

/* A landing whose impulse is above the limit makes impulse events with the point, normal and
 * impulse; a landing below it, and a pair without the rule, make none. */
static void impulses_are_told(void **unused) {
    (void)unused;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int form = 0; form < 3; form++) {
            thud_world *w = make(detections[d], NULL);
            thud_rule fragile = thud_default_rule();
            fragile.event_impulse = 3;
            OK(thud_world_set_rule(w, CRATE, GROUND, &fragile));
            add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
            thud_body_id crate = add(w, THUD_BODY_DYNAMIC, CRATE, form, 0, 1, 0.5f, 0.5f);
            add(w, THUD_BODY_DYNAMIC, PLAYER, form, 5, 3, 0.5f, 0.5f);
            int count = 0;
            /* it falls 0.5 m and lands with 3.2 m/s times up to 1 kg */
            for (int i = 0; i < 60; i++) {
                steps(w, 1);
                thud_impulse_events_of(w, &count);
                assert_true(count == 0 || form > 0);
            }
            throw_up(w, crate, 0, 8);
            float most = 0;
            for (int i = 0; i < 120; i++) {
                steps(w, 1);
                const thud_impulse_event *events = thud_impulse_events_of(w, &count);
                for (int k = 0; k < count; k++) {
                    assert_true(events[k].impulse > 3);
                    assert_true(fabs((double)events[k].normal.y) > 0.99);
                    assert_true(fabs(events[k].point.y) < 0.1);
                    most = fmaxf(most, events[k].impulse);
                }
            }
            /* It lands as fast as it left the ground, and stops. */
            double momentum = 8 * (form ? 1 : 3.14159265 * 0.25);
            assert_true((double)most > 0.9 * momentum && (double)most < 1.2 * momentum);
            thud_world_destroy(w);
        }
    }
}

/* ---- the caller's filter ---- */

/* A filter's context: the shape whose pairs it refuses while `refuse` is set. */
typedef struct apart {
    thud_shape_id shape;
    int asked;
    bool refuse;
    thud_world *world;
} apart;

/* A filter that refuses the pairs of one shape; world calls inside it are refused. */
static bool keep_apart(const thud_world *w, thud_shape_id a, thud_shape_id b, void *context) {
    apart *s = context;
    thud_shape_state state;
    s->asked++;
    OK(thud_shape_get_state(w, a, &state));
    assert_int_equal(thud_world_step(s->world), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_filter(s->world, NULL, NULL), THUD_ERROR_LOCKED);
    return !s->refuse || (a.index1 != s->shape.index1 && b.index1 != s->shape.index1);
}

/* The caller's filter keeps the pairs of one shape apart until it is set again. */
static void a_filter_keeps_apart(void **unused) {
    (void)unused;
    for (int i = 0; i < DETECTIONS * BROADPHASES; i++) {
        thud_world *w = make(detections[i % DETECTIONS], broadphases[i / DETECTIONS]);
        apart s = {.refuse = true, .world = w};
        add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
        thud_body_id faller = add_body(w, THUD_BODY_DYNAMIC, -3, 1, 0);
        s.shape = add_shape(w, faller, 0.5f, 0.5f, false, NULL);
        thud_body_id other = add(w, THUD_BODY_DYNAMIC, 1, 0, 3, 1, 0.5f, 0);
        OK(thud_world_set_filter(w, keep_apart, &s));
        steps(w, 60);
        assert_true(s.asked > 0);
        assert_true(get(w, faller).position.y < -1);
        assert_true(fabs(get(w, other).position.y - 0.5) < 0.02);
        /* the filter is set again and asked about all pairs: the body is pushed out of the
         * ground */
        s.refuse = false;
        OK(thud_world_set_filter(w, keep_apart, &s));
        OK(thud_body_set_transform(w, faller, (thud_pos){-3, 1}, 0));
        steps(w, 90);
        assert_true(fabs(get(w, faller).position.y - 0.5) < 0.02);
        thud_world_destroy(w);
    }
}

/* ---- refusals ---- */

static void wrong_rules_change_nothing(void **unused) {
    (void)unused;
    thud_world *w = make(NULL, NULL);
    thud_rule good = thud_default_rule(), read;
    bool set;
    good.friction = 0.25f;
    OK(thud_world_set_rule(w, 1, 2, &good));
    thud_rule bad[9];
    for (int i = 0; i < 9; i++) {
        bad[i] = thud_default_rule();
    }
    bad[0].kind = (thud_rule_kind)3;
    bad[1].kind = (thud_rule_kind)-1;
    bad[2].solid_side = (thud_vec2){0, 0};
    bad[3].solid_side.x = INFINITY;
    bad[4].friction = nextafterf(THUD_FRICTION_MAX, INFINITY);
    bad[5].restitution = -1e-30f;
    bad[6].surface_speed = nextafterf(-THUD_SURFACE_SPEED_MAX, -INFINITY);
    bad[7].event_impulse = -1;
    bad[8].event_impulse = NAN;
    for (int i = 0; i < 9; i++) {
        assert_int_equal(thud_world_set_rule(w, 1, 2, &bad[i]), THUD_ERROR_INVALID);
    }
    thud_rule one_way = rule_of_kind(THUD_RULE_ONE_WAY);
    assert_int_equal(thud_world_set_rule(w, 3, 2, &one_way), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_set_rule(w, 0, 2, &good), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_set_rule(w, 1, 0, NULL), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_set_rule(NULL, 1, 2, &good), THUD_ERROR_NULL);
    assert_int_equal(thud_world_set_filter(NULL, NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_rule(w, 3, 1, &read, NULL, NULL), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_get_rule(NULL, 1, 1, &read, NULL, NULL), THUD_ERROR_NULL);
    OK(thud_world_get_rule(w, 1, 2, &read, &set, NULL));
    assert_true(set && read.friction == 0.25f && isnan(read.restitution));
    int count = 7;
    assert_null(thud_impulse_events_of(NULL, &count));
    assert_int_equal(count, 0);
    thud_world_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ignored_kinds_fall_through),
        cmocka_unit_test(a_rule_takes_hold_of_what_touches),
        cmocka_unit_test(the_lowest_bit_is_the_kind),
        cmocka_unit_test(rules_make_surfaces),
        cmocka_unit_test(a_prologue_comes_after_the_rules),
        cmocka_unit_test(impulses_are_told),
        cmocka_unit_test(a_filter_keeps_apart),
        cmocka_unit_test(wrong_rules_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
