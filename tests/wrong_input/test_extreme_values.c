/* test_extreme_values.c: tests extreme values that the API accepts: speeds, forces and impulses of
 * 1e38, very small masses, places at the edge of the world, the shortest time step. The world must
 * stay finite. A body that overflows is quarantined, with an event; distant bodies behave bit for
 * bit as without it, and bodies that it touched as if it were removed. */
#include "village.h"

static const float HUGE_VALUE = 3e38f;

/* ---- extreme edits of one body ---- */

static void fling(thud_world *w, thud_body_id b) {
    OK(thud_body_set_velocity(w, b, (thud_vec2){HUGE_VALUE, -HUGE_VALUE}, 0));
}

static void spin(thud_world *w, thud_body_id b) {
    OK(thud_body_set_velocity(w, b, (thud_vec2){0, 0}, HUGE_VALUE));
}

static void strike(thud_world *w, thud_body_id b) {
    OK(thud_body_apply_impulse(w, b, (thud_vec2){HUGE_VALUE, HUGE_VALUE}, state_of(w, b).position));
}

static void strike_twice(thud_world *w, thud_body_id b) {
    strike(w, b);
    strike(w, b);
}

static void strike_from_afar(thud_world *w, thud_body_id b) {
    OK(thud_body_apply_impulse(w, b, (thud_vec2){0, 1e37f}, (thud_pos){1e9, 0}));
}

static void strike_to_and_fro(thud_world *w, thud_body_id b) {
    thud_pos at = state_of(w, b).position;
    for (int i = 0; i < 3; i++) {
        OK(thud_body_apply_impulse(w, b, (thud_vec2){HUGE_VALUE, 0}, at));
    }
    for (int i = 0; i < 3; i++) {
        OK(thud_body_apply_impulse(w, b, (thud_vec2){-HUGE_VALUE, 0}, at));
    }
}

static void force(thud_world *w, thud_body_id b) {
    OK(thud_body_apply_center_force(w, b, (thud_vec2){-HUGE_VALUE, HUGE_VALUE}));
}

static void force_down(thud_world *w, thud_body_id b) {
    OK(thud_body_apply_center_force(w, b, (thud_vec2){0, -HUGE_VALUE}));
}

static void force_twice(thud_world *w, thud_body_id b) {
    force(w, b);
    force(w, b);
}

static void twist(thud_world *w, thud_body_id b) {
    OK(thud_body_apply_torque(w, b, HUGE_VALUE));
}

static void force_there_and_back(thud_world *w, thud_body_id b) {
    force_twice(w, b);
    for (int i = 0; i < 2; i++) {
        OK(thud_body_apply_center_force(w, b, (thud_vec2){HUGE_VALUE, -HUGE_VALUE}));
    }
}

typedef struct blow {
    const char *name;
    void (*deal)(thud_world *w, thud_body_id b);
} blow;

static const blow blows[] = {
    {"velocity", fling},
    {"spin", spin},
    {"impulse", strike},
    {"two impulses", strike_twice},
    {"impulse from afar", strike_from_afar},
    {"impulses to and fro", strike_to_and_fro},
    {"force", force},
    {"force down", force_down},
    {"two forces", force_twice},
    {"torque", twist},
    {"forces to and fro", force_there_and_back},
};
enum { BLOWS = sizeof blows / sizeof *blows };

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum { DETECTIONS = 4 };

static bool body_is_finite(const thud_world *w, thud_body_id b) {
    thud_body_state s = state_of(w, b);
    return isfinite(s.position.x + s.position.y + s.angle) &&
           isfinite((double)s.velocity.x + (double)s.velocity.y + (double)s.angular_velocity) &&
           isfinite((double)s.cosine + (double)s.sine);
}

/* ---- bystanders ---- */

enum { STACK = 6 };

typedef struct site {
    thud_world *world;
    thud_body_id stack[STACK], ball, victim;
} site;

/* A stack, a ball, and, if wanted, a victim far away, after 20 steps. */
static site make_site(const thud_detection *detection, bool with_victim) {
    thud_world_def def = thud_default_world_def();
    site s = {.victim = {0, 0}};
    def.detection = detection;
    s.world = make_world(def);
    add_floor(s.world, NULL);
    for (int i = 0; i < STACK; i++) {
        s.stack[i] = add_box(s.world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    s.ball = add_ball(s.world, -20, 0.5, 0.5f);
    OK(thud_body_set_velocity(s.world, s.ball, (thud_vec2){1, 0}, 0));
    if (with_victim) {
        s.victim = add_box(s.world, 80, 30, 0.5f, 0.25f); /* in the air, far from all others */
    }
    run(s.world, 20);
    return s;
}

/* Fails if the two bodies differ in a bit. */
static void body_is_as(const site *a, thud_body_id of_a, const site *b, thud_body_id of_b,
                       const char *name, int step) {
    char one[1024], other[1024];
    village_body_text(a->world, of_a, one, sizeof one);
    village_body_text(b->world, of_b, other, sizeof other);
    if (strcmp(one, other) != 0) {
        fail_msg("%s, step %d: a bystander is affected\n%s%s", name, step, one, other);
    }
}

static void blow_far_from_others_leaves_them_as_they_are_to_the_bit(void **state) {
    (void)state;
    for (int i = 0; i < BLOWS * DETECTIONS; i++) {
        const blow *dealt = &blows[i / DETECTIONS];
        site hit = make_site(detections[i % DETECTIONS], true);
        site without = make_site(detections[i % DETECTIONS], false);
        dealt->deal(hit.world, hit.victim);
        for (int step = 0; step < 120; step++) {
            run(hit.world, 1);
            run(without.world, 1);
            for (int k = 0; k < STACK; k++) {
                body_is_as(&hit, hit.stack[k], &without, without.stack[k], dealt->name, step);
            }
            body_is_as(&hit, hit.ball, &without, without.ball, dealt->name, step);
            if (!body_is_finite(hit.world, hit.victim)) {
                fail_msg("%s, step %d: the body is not finite", dealt->name, step);
            }
        }
        thud_world_destroy(hit.world);
        thud_world_destroy(without.world);
    }
}

/* The victim is the third box of the stack from below. */
static void blow_to_one_of_a_stack_leaves_the_others_finite(void **state) {
    (void)state;
    for (int i = 0; i < BLOWS * DETECTIONS; i++) {
        const blow *dealt = &blows[i / DETECTIONS];
        site s = make_site(detections[i % DETECTIONS], false);
        thud_body_id victim = s.stack[2];
        int quarantined = 0;
        dealt->deal(s.world, victim);
        for (int step = 0; step < 240; step++) {
            run(s.world, 1);
            thud_events e = thud_events_of(s.world);
            for (int k = 0; k < e.quarantined_count; k++) {
                quarantined++;
                if (e.quarantined[k].index1 != victim.index1) {
                    fail_msg("%s, step %d: body %u is quarantined, too", dealt->name, step,
                             e.quarantined[k].index1);
                }
            }
            for (int k = 0; k < STACK; k++) {
                if (!body_is_finite(s.world, s.stack[k])) {
                    fail_msg("%s, step %d: box %d is not finite", dealt->name, step, k);
                }
            }
        }
        assert_int_equal(quarantined, state_of(s.world, victim).quarantined);
        thud_world_destroy(s.world);
    }
}

/* A body whose gravity force overflows: gravity 10 times a scale of 3e38. */
static thud_body_id add_doomed(thud_world *w, double x) {
    thud_body_def def = thud_default_body_def();
    thud_body_id body;
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){x, 0.5};
    def.gravity_scale = HUGE_VALUE;
    OK(thud_body_create(w, &def, &body));
    add_shape(w, body, 0.5f, 0.5f, false, NULL);
    return body;
}

/* The body touches the stack and stands on the same floor. The step in which it overflows is one of
 * the soft solver, which under bisect and swept pushes contacts apart, each by up to 3e-3. */
static void body_that_overflows_is_quarantined_and_the_rest_goes_on_without_it(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        site s = make_site(detections[d], false), without = make_site(detections[d], false);
        thud_body_id doomed = add_doomed(s.world, 1);
        for (int step = 0; step < 120; step++) {
            run(s.world, 1);
            run(without.world, 1);
            thud_events e = thud_events_of(s.world);
            assert_int_equal(e.quarantined_count, step == 0);
            if (step == 0) {
                assert_int_equal(e.quarantined[0].index1, doomed.index1);
            }
            body_is_as(&s, s.ball, &without, without.ball, "quarantine", step);
            for (int k = 0; k < STACK; k++) {
                thud_pos is = state_of(s.world, s.stack[k]).position;
                thud_pos wanted = state_of(without.world, without.stack[k]).position;
                bool in_order_of_time = detections[d] == &thud_detection_bisect ||
                                        detections[d] == &thud_detection_swept;
                double tolerance = in_order_of_time ? 3e-3 * (k + 1) : 1e-3;
                near_to(is.x, wanted.x, tolerance);
                near_to(is.y, wanted.y, tolerance);
            }
        }
        assert_true(state_of(s.world, doomed).quarantined);
        near_to(state_of(s.world, doomed).position.x, 1, 0);
        OK(thud_body_destroy(s.world, doomed));
        run(s.world, 1);
        thud_body_id heir = add_box(s.world, 1.5, 0.5, 0.5f, 0.5f);
        run(s.world, 60);
        assert_int_equal(heir.index1, doomed.index1);
        assert_false(state_of(s.world, heir).quarantined);
        thud_world_destroy(s.world);
        thud_world_destroy(without.world);
    }
}

/* ---- worlds and bodies at the ends of their ranges ---- */

/* A pile of balls and boxes on a floor. After two seconds all bodies must be there, finite and not
 * quarantined. */
typedef struct pile {
    thud_world_def world;
    thud_body_def body;
    thud_shape_def shape;
    double size, x, y; /* size of the bodies; place of the floor's top */
} pile;

static pile usual_pile(void) {
    pile p = {.world = thud_default_world_def(),
              .body = thud_default_body_def(),
              .shape = thud_default_shape_def(),
              .size = 0.5};
    p.body.kind = THUD_BODY_DYNAMIC;
    return p;
}

enum { PILE = 12 };

static void fill_pile(const pile *p, thud_world *w, thud_body_id made[PILE]) {
    float half = (float)p->size;
    thud_body_def body = p->body;
    thud_body_id floor = add_body(w, THUD_BODY_STATIC, p->x, p->y - p->size, 0);
    add_shape(w, floor, 20 * half, half, true, &p->shape);
    for (int i = 0; i < PILE; i++) {
        body.position =
            (thud_pos){p->x + (i % 3 - 1) * 2.02 * p->size, p->y + (1 + 2 * (i / 3)) * p->size};
        OK(thud_body_create(w, &body, &made[i]));
        add_shape(w, made[i], half, i % 2 ? half : 0, i % 4 == 1 && body.angle == 0, &p->shape);
    }
}

/* Exact gets fewer steps: differences between qualities appear within few steps. */
static void pile_stays_finite(const pile *p, const char *name) {
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        int d = i % DETECTIONS, steps = qualities[i / DETECTIONS] == &thud_quality_exact ? 24 : 120;
        thud_world_def def = p->world;
        thud_body_id made[PILE];
        def.detection = detections[d];
        def.quality = qualities[i / DETECTIONS];
        thud_world *w = make_world(def);
        fill_pile(p, w, made);
        for (int step = 0; step < steps; step++) {
            run(w, 1);
            if (thud_events_of(w).quarantined_count) {
                fail_msg("%s, %s at %s, step %d: a body is quarantined", name,
                         thud_detection_name(detections[d]), def.quality->name, step);
            }
        }
        for (int k = 0; k < PILE; k++) {
            if (!body_is_finite(w, made[k])) {
                fail_msg("%s, %s at %s: body %d is not finite", name,
                         thud_detection_name(detections[d]), def.quality->name, k);
            }
        }
        thud_measure m = thud_measure_of(w);
        assert_true(isfinite(m.kinetic_energy + m.potential_energy + m.penetration_max));
        thud_world_destroy(w);
    }
}

#define PILE_WITH(field, value)                         \
    do {                                                \
        pile with_ = usual_pile();                      \
        with_.field = (value);                          \
        pile_stays_finite(&with_, #field " = " #value); \
    } while (0)

static void worlds_at_the_ends_of_their_ranges_stay_finite(void **state) {
    (void)state;
    PILE_WITH(world.gravity.y, -HUGE_VALUE);
    PILE_WITH(world.gravity.x, HUGE_VALUE);
    PILE_WITH(world.gravity.y, -1e-45f);
    PILE_WITH(world.time_step, 1);
    PILE_WITH(world.time_step, 1e-9);
    PILE_WITH(world.time_step, 1e-30);
    PILE_WITH(world.time_step, 1e-45);
    PILE_WITH(world.time_step, 1e-300);
    PILE_WITH(world.time_step, 5e-324);
    PILE_WITH(world.maximum_speed, 1e-45f);
    PILE_WITH(world.maximum_speed, 1e6f);
    PILE_WITH(world.push_speed, 0);
    PILE_WITH(world.push_speed, 1e6f);
    PILE_WITH(world.substeps, 1);
    PILE_WITH(world.substeps, 64);
    PILE_WITH(world.contact_damping, 0.0001f);
    PILE_WITH(world.contact_damping, 100);
    PILE_WITH(world.contact_stiffness, 0.5f);
    PILE_WITH(world.contact_stiffness, 0.01f);
}

static void bodies_at_the_ends_of_their_ranges_stay_finite(void **state) {
    (void)state;
    PILE_WITH(body.gravity_scale, 1e37f);
    PILE_WITH(body.gravity_scale, -1e37f);
    PILE_WITH(body.linear_damping, HUGE_VALUE);
    PILE_WITH(body.angular_damping, HUGE_VALUE);
    PILE_WITH(body.linear_damping, 1e-45f);
    PILE_WITH(body.velocity.x, 1e6f);
    PILE_WITH(body.velocity.y, -1e6f);
    PILE_WITH(body.angle, 1e6);
    PILE_WITH(shape.density, 0);
    PILE_WITH(shape.density, 1e-30f);
    PILE_WITH(shape.density, 1e12f);
    PILE_WITH(shape.friction, 1e6f);
    PILE_WITH(shape.restitution, 1);
    PILE_WITH(shape.surface_speed, 1e6f);
    PILE_WITH(size, 1e-4);
    PILE_WITH(size, 800);
    PILE_WITH(x, 1e9 - 20);
    PILE_WITH(y, -1e9 + 20);
}

/* A body that leaves the range of positions by its own motion flies on; queries do not find it
 * there. */
static void body_that_flies_past_the_edge_of_the_world_flies_on(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        thud_world_def def = weightless();
        def.detection = detections[d];
        def.time_step = 1;
        thud_world *w = make_world(def);
        thud_body_id box = add_box(w, 1e9 - 1e6, -1e9, 0.5f, 0.5f);
        bool hit = true;
        OK(thud_body_set_velocity(w, box, (thud_vec2){1e6f, -1e5f}, 0));
        run(w, 40);
        near_to(state_of(w, box).position.x, 1.039e9, 1);
        near_to(state_of(w, box).position.y, -1.004e9, 1);
        OK(thud_world_cast_ray(w, &(thud_ray){(thud_pos){-1e9, -1e9}, 2e9, 0, NULL}, &hit, NULL));
        assert_false(hit);
        thud_world_destroy(w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blow_far_from_others_leaves_them_as_they_are_to_the_bit),
        cmocka_unit_test(blow_to_one_of_a_stack_leaves_the_others_finite),
        cmocka_unit_test(body_that_overflows_is_quarantined_and_the_rest_goes_on_without_it),
        cmocka_unit_test(worlds_at_the_ends_of_their_ranges_stay_finite),
        cmocka_unit_test(bodies_at_the_ends_of_their_ranges_stay_finite),
        cmocka_unit_test(body_that_flies_past_the_edge_of_the_world_flies_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
