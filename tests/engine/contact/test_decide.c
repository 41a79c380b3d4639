/* test_decide.c: prologues that decide the velocities after a collision (thud_contact_decide), by
 * every detection and quality, called for one contact at a time or for all at once. */
#include "engine_support.h"
#include "every_choice.h"
#include "hostile_memory.h"

#include <thud/thud_joint.h>
#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_testing.h>

enum { DETECTIONS = 4, FORMS = 2 };

/* A law of a test: a contact whose body b closes against the normal is given these velocities; with
 * `passes` the prologue lets the pair pass in every step. */
typedef struct law {
    thud_velocities after;
    bool on_a;    /* body a is decided, too: at rest */
    bool passes;  /* vetoes the pair where it does not decide */
    bool refused; /* what is decided must be refused */
    int asked, decided, told;
    double energy;     /* that the decisions added, by the velocities that they replaced */
    thud_contact last; /* told */
} law;

/* Half of mass v^2 and inertia w^2. */
static double energy_of(const thud_body_state *s, thud_vec2 v, float w) {
    return 0.5 * ((double)s->mass * ((double)v.x * (double)v.x + (double)v.y * (double)v.y) +
                  (double)s->inertia * (double)w * (double)w);
}

static bool decide(thud_world *world, const thud_contact *contact, law *l) {
    thud_body_state b = state_of(world, contact->body_b);
    float closes = -(b.velocity.x * contact->normal.x + b.velocity.y * contact->normal.y);
    l->asked++;
    if (closes <= 0.01f) {
        return !l->passes;
    }
    thud_velocities still = {{0, 0}, 0};
    thud_result result = thud_contact_decide(world, contact, l->on_a ? &still : NULL, &l->after);
    assert_int_equal(result, l->refused ? THUD_ERROR_INVALID : THUD_OK);
    l->decided++;
    l->energy += energy_of(&b, l->after.velocity, l->after.angular_velocity) -
                 energy_of(&b, b.velocity, b.angular_velocity);
    return true;
}

static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                void *context) {
    (void)settings;
    return decide(world, contact, context);
}

static void ask_all(thud_world *world, const thud_contact *contacts, thud_contact_answer *answers,
                    int count, void *context) {
    for (int i = count - 1; i >= 0; i--) { /* not in the order of the contacts */
        answers[i].collide = decide(world, &contacts[i], context);
    }
}

static void tell(thud_world *world, const thud_contact *contact, void *context) {
    law *l = context;
    (void)world;
    l->told++;
    l->last = *contact;
}

static void tell_all(thud_world *world, const thud_contact *contacts, int count, void *context) {
    for (int i = 0; i < count; i++) {
        tell(world, &contacts[i], context);
    }
}

static void listen(thud_world *world, int form, law *l) {
    OK(thud_world_set_listeners(world, &(thud_listeners){.prologue = form ? NULL : ask,
                                                         .prologue_all = form ? ask_all : NULL,
                                                         .epilogue = form ? NULL : tell,
                                                         .epilogue_all = form ? tell_all : NULL,
                                                         .context = l}));
}

static thud_world_def def_of(int detection, int quality) {
    thud_world_def def = thud_default_world_def_of(qualities[quality]);
    def.gravity = (thud_vec2){0, 0};
    def.sleeping = false;
    def.detection = detections[detection];
    return def;
}

/* A static box whose top is at y = 0, and a body above it that falls with this speed. */
static thud_body_id drop(thud_world *world, double height, float speed) {
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, height, 0.5f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){1, -speed}, 3));
    return ball;
}

/* ---- the law of the prologue holds ---- */

/* A ball that meets the floor leaves it at exactly the velocities that the prologue decides, never
 * before it is a twentieth of a metre near; the epilogue is told of its change of momentum, and the
 * errors of its change of energy. */
static void a_ball_leaves_at_the_velocities_that_are_decided(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES * FORMS * 3; i++) {
        int detection = i % DETECTIONS, quality = i / DETECTIONS % QUALITIES;
        int form = i / DETECTIONS / QUALITIES % FORMS, fast = i / DETECTIONS / QUALITIES / FORMS;
        if (fast == 2 && detection % 2 == 0) {
            continue; /* `overlap` and `bisect` miss the floor */
        }
        law l = {.after = {{3, 7}, 2}};
        thud_world *world = make_world(def_of(detection, quality));
        listen(world, form, &l);
        float speed = fast == 2 ? 300.0f : fast ? 40.0f : 2.0f;
        thud_body_id ball = drop(world, 2.03, speed);
        double change = 0, decided = 0;
        int steps = 0;
        for (; l.told == 0 && steps < 90; steps++) {
            run(world, 1);
            change += thud_step_error_of(world).energy_change;
            decided += thud_step_error_of(world).energy_decided;
        }
        thud_body_state s = state_of(world, ball);
        assert_true(l.told == 1);
        assert_true(s.velocity.x == 3 && s.velocity.y == 7 && s.angular_velocity == 2);
        near_to((double)l.last.normal_impulse, (double)s.mass * (7.0 + (double)speed), 1e-2);
        near_to((double)l.last.tangent_impulse, (double)s.mass * 2.0, 1e-3);
        double before = energy_of(&s, (thud_vec2){1, -speed}, 3);
        double after = energy_of(&s, s.velocity, s.angular_velocity);
        near_to(decided, after - before, 1e-5 * before);
        near_to(change, after - before, 1e-5 * before);
        assert_true(s.position.y > 0.5 - 0.7);
        run(world, 30); /* nothing else acts on it */
        thud_body_state later = state_of(world, ball);
        assert_true(later.velocity.x == 3 && later.velocity.y == 7 && later.angular_velocity == 2);
        assert_true(thud_step_error_of(world).energy_decided == 0);
        assert_true(l.decided < 3 && later.position.y > s.position.y + 3.4);
        thud_world_destroy(world);
    }
}

/* The energy of a step that follows an edit has what is decided in it, and not the edit. */
static void the_energy_of_an_edit_is_not_decided(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        law l = {.after = {{0, 7}, 0}};
        thud_world *world = make_world(def_of(d, 1));
        listen(world, 0, &l);
        thud_body_id ball = drop(world, 0.5, 0);
        run(world, 1);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -1}, 0));
        run(world, 1);
        thud_step_error e = thud_step_error_of(world);
        double mass = (double)state_of(world, ball).mass;
        assert_int_equal(l.decided, 1);
        near_to(e.energy_decided, 0.5 * mass * (49 - 1), 1e-4);
        near_to(e.energy_change, 0.5 * mass * (49 - 1), 1e-4);
        thud_world_destroy(world);
    }
}

/* Within a step of `swept` the rest of the way is travelled at the decided velocity. */
static void the_rest_of_the_step_is_travelled_at_it(void **state) {
    (void)state;
    for (int detection = 2; detection < DETECTIONS; detection++) {
        law l = {.after = {{6, 12}, 0}};
        thud_world *world = make_world(def_of(detection, 1));
        listen(world, 0, &l);
        /* it meets the floor after half a step: 0.5 m at 60 m/s */
        thud_body_id ball = drop(world, 1.0, 60);
        run(world, 1);
        thud_body_state s = state_of(world, ball);
        assert_int_equal(l.told, 1);
        near_to(s.position.y, 0.5 + 0.5 * 12 / 60, 0.005);
        near_to(s.position.x, 0.5 * 1 / 60 + 0.5 * 6 / 60, 0.005);
        assert_int_equal(thud_stats_of(world).impacts, 1);
        thud_world_destroy(world);
    }
}

/* With gravity: a decided velocity gains what gravity gives in the rest of the step. */
static void gravity_acts_on_a_decided_velocity(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        law l = {.after = {{0, 5}, 0}};
        thud_world_def def = def_of(i % DETECTIONS, i / DETECTIONS);
        def.gravity.y = -10;
        thud_world *world = make_world(def);
        listen(world, i & 1, &l);
        thud_body_id ball = drop(world, 1.5, 1);
        while (l.told == 0) {
            run(world, 1);
        }
        double y = (double)state_of(world, ball).velocity.y;
        assert_true(y <= 5.0 && y > 5.0 - 10.5 / 60);
        double highest = 0;
        for (int k = 0; k < 40; k++) {
            run(world, 1);
            highest = fmax(highest, state_of(world, ball).position.y);
        }
        near_to(highest, 0.5 + 25 / 20.0, 0.12);
        thud_world_destroy(world);
    }
}

/* A portal: the wall passes the ball on, with its velocity turned; no detection stops it there. */
static void a_portal_passes_and_turns_the_velocity(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        for (int fast = 0; fast < 2; fast++) {
            float speed = fast ? 300.0f : 6.0f;
            if (fast && i % DETECTIONS % 2 == 0) {
                continue; /* `overlap` and `bisect` miss the wall */
            }
            law l = {.after = {{speed, -speed}, 0}, .passes = true};
            thud_world *world = make_world(def_of(i % DETECTIONS, i / DETECTIONS));
            listen(world, 0, &l);
            thud_body_id ball = drop(world, 2.03, speed);
            run(world, fast ? 10 : 60);
            thud_body_state s = state_of(world, ball);
            assert_true(s.velocity.x == speed && s.velocity.y == -speed);
            assert_true(s.position.y < -3 && l.decided > 0);
            thud_world_destroy(world);
        }
    }
}

/* Both bodies of a pair: the bat's law gives both their velocities. */
static void both_bodies_of_a_pair_can_be_decided(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES * FORMS; i++) {
        law l = {.after = {{0, 9}, 0}, .on_a = true};
        thud_world *world = make_world(def_of(i % DETECTIONS, i / DETECTIONS % QUALITIES));
        listen(world, i / DETECTIONS / QUALITIES, &l);
        thud_body_id bat = add_ball(world, 0, 0, 0.5f), ball = add_ball(world, 0, 2, 0.5f);
        OK(thud_body_set_velocity(world, bat, (thud_vec2){0, 1}, 0));
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -4}, 0));
        run(world, 40);
        thud_body_state a = state_of(world, bat), b = state_of(world, ball);
        assert_true((a.velocity.y == 0 && b.velocity.y == 9) ||
                    (a.velocity.y == 9 && b.velocity.y == 0));
        bool bat_is_a = l.last.body_a.index1 == bat.index1;
        assert_true(bat_is_a == (b.velocity.y == 9) && l.decided == 1);
        thud_world_destroy(world);
    }
}

/* A kicked ball meets its neighbour with the decided velocity, later or in the same step: both
 * together have its momentum. */
static void other_contacts_meet_the_decided_velocity(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES * 2; i++) {
        law l = {.after = {{0, 6}, 0}};
        thud_world *world = make_world(def_of(i % DETECTIONS, i / DETECTIONS % QUALITIES));
        bool touches = i / DETECTIONS / QUALITIES;
        thud_shape_def lively = thud_default_shape_def();
        lively.restitution = 1;
        thud_body_id ball = drop(world, touches ? 0.5 : 0.55, 4);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -4}, 0));
        thud_body_id above = add_body(world, THUD_BODY_DYNAMIC, 0, touches ? 1.501 : 1.6, 0);
        add_shape(world, above, 0.5f, 0, false, &lively);
        listen(world, 0, &l);
        double hardest = 0; /* hit between the two */
        for (int k = 0; k < 30; k++) {
            run(world, 1);
            thud_events events = thud_events_of(world);
            for (int h = 0; h < events.hit_count; h++) {
                hardest = fmax(hardest, (double)events.hit[h].speed);
            }
        }
        near_to(hardest, 6, 1e-3);
        double sum = (double)(state_of(world, ball).velocity.y + state_of(world, above).velocity.y);
        near_to(sum, 6, 1e-3);
        near_to((double)state_of(world, above).velocity.y, 6, 0.05); /* the cradle's exchange */
        assert_int_equal(l.decided, 1);
        thud_world_destroy(world);
    }
}

/* ---- what it meets ---- */

/* The velocity of a fixed rotation stays 0, and a joint goes on holding a decided body. */
static void joints_and_fixed_rotation_go_on_holding(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        law l = {.after = {{4, 3}, 5}};
        thud_world *world = make_world(def_of(i % DETECTIONS, i / DETECTIONS));
        add_floor(world, NULL);
        thud_body_id post = add_body(world, THUD_BODY_STATIC, 0, 3, 0);
        thud_body_def def = thud_default_body_def();
        def.kind = THUD_BODY_DYNAMIC;
        def.position = (thud_pos){-2, 3};
        def.fixed_rotation = true;
        thud_body_id ball;
        OK(thud_body_create(world, &def, &ball));
        add_shape(world, ball, 0.5f, 0, false, NULL);
        thud_joint_def rod = thud_default_joint_def(THUD_JOINT_DISTANCE);
        rod.body_a = post;
        rod.body_b = ball;
        rod.length = 2.5f;
        thud_joint_id joint;
        OK(thud_joint_create(world, &rod, &joint));
        OK(thud_body_set_transform(world, ball, (thud_pos){-0.1, 0.52}, 0));
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -1}, 0));
        listen(world, 0, &l);
        for (int k = 0; k < 60; k++) {
            run(world, 1);
            assert_true(state_of(world, ball).angular_velocity == 0);
        }
        thud_body_state s = state_of(world, ball);
        assert_true(l.decided > 0);
        near_to(hypot(s.position.x, s.position.y - 3), 2.5, 0.03);
        thud_world_destroy(world);
    }
}

/* A sleeping pair that a ball meets wakes, and a decision of this step or the next one kicks it. */
static void decided_bodies_wake(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        thud_world_def def = def_of(i % DETECTIONS, i / DETECTIONS);
        def.sleeping = true;
        thud_world *world = make_world(def);
        law l = {.after = {{0, 4}, 0}};
        thud_body_id sleeper = add_ball(world, 0, 3, 0.5f);
        run(world, 60);
        assert_false(state_of(world, sleeper).awake);
        listen(world, 0, &l); /* wakes all */
        run(world, 60);
        assert_false(state_of(world, sleeper).awake);
        thud_body_id ball = add_ball(world, 0, 0, 0.5f);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 3}, 0));
        while (l.decided == 0 || l.told == 0) {
            run(world, 1);
        }
        assert_true(state_of(world, sleeper).awake && state_of(world, ball).awake);
        run(world, 20);
        thud_body_state a = state_of(world, ball), b = state_of(world, sleeper);
        assert_true((a.velocity.y == 4) != (b.velocity.y == 4));
        thud_world_destroy(world);
    }
}

/* A heap whose closing pairs are all decided moves the same whichever form the prologue has, and
 * whichever kernels the processor runs. */
static void both_forms_decide_the_same(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        law l[FORMS];
        uint64_t hash[FORMS];
        for (int form = 0; form < FORMS; form++) {
            uint64_t seed = 7;
            thud_world_def def = def_of(i % DETECTIONS, i / DETECTIONS);
            def.gravity.y = -10;
            thud_world_def_set_baseline_simd(&def, form == 1);
            thud_world *world = make_world(def);
            l[form] = (law){.after = {{0.5f, 2}, 1}};
            listen(world, form, &l[form]);
            add_floor(world, NULL);
            for (int k = 0; k < 40; k++) {
                double x = random_in(&seed, -4, 4), y = 1 + 0.3 * k;
                thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, x, y, 0);
                add_shape(world, body, 0.4f, k % 3 ? 0.3f : 0, k % 3 == 1, NULL);
                OK(thud_body_set_velocity(world, body, (thud_vec2){0, k % 7 ? -3 : -60}, 0));
            }
            run(world, 60);
            hash[form] = thud_hash_of(world);
            thud_world_destroy(world);
        }
        assert_true(hash[0] == hash[1] && l[0].decided == l[1].decided && l[0].decided > 50);
        assert_int_equal(l[0].told, l[1].told);
    }
}

/* A world that is put back and goes on has the same motion and errors, and so has a twin. */
static void a_restored_world_decides_the_same(void **state) {
    (void)state;
    for (int i = 0; i < DETECTIONS * QUALITIES; i++) {
        law l = {.after = {{1, 4}, 1}};
        thud_world_def def = def_of(i % DETECTIONS, i / DETECTIONS);
        def.gravity.y = -10;
        thud_world *world = make_world(def);
        listen(world, 1, &l);
        drop(world, 2, 1);
        for (int k = 0; k < 5; k++) {
            thud_body_id more = add_ball(world, 0.3 * k, 3 + k, 0.5f);
            OK(thud_body_set_velocity(world, more, (thud_vec2){0, -2}, 0));
        }
        static char bytes[1 << 17];
        size_t size = 0;
        while (l.decided < 3 || thud_step_error_of(world).energy_decided == 0) {
            run(world, 1);
        }
        OK(thud_world_snapshot(world, bytes, sizeof bytes, &size));
        thud_step_error then = thud_step_error_of(world);
        run(world, 60);
        uint64_t hash = thud_hash_of(world);
        thud_step_error at_end = thud_step_error_of(world);
        OK(thud_world_restore(world, bytes, size));
        assert_true(thud_step_error_of(world).energy_decided == then.energy_decided);
        run(world, 60);
        assert_true(thud_hash_of(world) == hash);
        assert_true(thud_step_error_of(world).energy_change == at_end.energy_change);
        thud_world_destroy(world);
    }
}

/* What was decided of one collision within the step says nothing of the next one, which a one-way
 * rule lets pass unasked. */
static void a_decision_is_not_taken_for_another_collision(void **state) {
    (void)state;
    for (int detection = 2; detection < DETECTIONS; detection++) {
        law l = {.after = {{0, 6}, 0}};
        thud_world *world = make_world(def_of(detection, 1));
        thud_rule one_way = thud_default_rule();
        one_way.kind = THUD_RULE_ONE_WAY;
        OK(thud_world_set_rule(world, 2, 4, &one_way));
        thud_shape_def shelf = thud_default_shape_def(), rising = shelf;
        shelf.filter.category = 2;
        rising.filter.category = 4;
        drop(world, 0.8, 60); /* it meets the floor after 0.3 of the step */
        thud_body_id platform = add_body(world, THUD_BODY_STATIC, 10, 5, 0);
        add_shape(world, platform, 2, 0.1f, true, &shelf);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 10, 3.8, 0);
        add_shape(world, ball, 0.5f, 0, false, &rising);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 60}, 0)); /* after 0.6 of it */
        listen(world, 0, &l);
        run(world, 1);
        assert_int_equal(l.decided, 1);
        assert_int_equal(l.told, 1);
        assert_int_equal(thud_stats_of(world).impacts, 1);
        assert_true(state_of(world, ball).velocity.y == 60);
        thud_world_destroy(world);
    }
}

/* ---- refused ---- */

static void what_is_refused_leaves_the_pair_to_the_solver(void **state) {
    (void)state;
    const thud_velocities bad[] = {{{NAN, 0}, 0}, {{0, INFINITY}, 0}, {{0, 0}, -INFINITY}};
    for (int i = 0; i < DETECTIONS * 4; i++) {
        law l = {.refused = true}, plain = {0};
        l.after = bad[i / DETECTIONS % 3];
        l.on_a = i / DETECTIONS == 3; /* the floor is static */
        thud_world *world = make_world(def_of(i % DETECTIONS, 1));
        thud_world *twin = make_world(def_of(i % DETECTIONS, 1));
        listen(world, i & 1, &l);
        set_listeners(twin, NULL, tell, &plain);
        drop(world, 2, 4);
        drop(twin, 2, 4);
        run(world, 60);
        run(twin, 60);
        assert_true(l.decided > 0 && l.told == plain.told);
        assert_true(thud_hash_of(world) == thud_hash_of(twin));
        assert_true(thud_step_error_of(world).energy_decided == 0);
        thud_world_destroy(world);
        thud_world_destroy(twin);
    }
}

static thud_contact remembered;

static bool remember(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    thud_velocities v = {{0, 0}, 0};
    (void)settings;
    (void)context;
    remembered = *contact; /* a copy is not what the prologue was asked about */
    assert_int_equal(thud_contact_decide(world, &remembered, NULL, &v), THUD_ERROR_INVALID);
    assert_int_equal(thud_contact_decide(world, contact, NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_contact_decide(NULL, contact, NULL, &v), THUD_ERROR_NULL);
    return true;
}

static void too_late(thud_world *world, const thud_contact *contact, void *context) {
    thud_velocities v = {{0, 0}, 0};
    assert_int_equal(thud_contact_decide(world, contact, NULL, &v), THUD_ERROR_INVALID);
    ++*(int *)context;
}

static void only_a_prologue_decides_and_only_what_it_is_asked_about(void **state) {
    (void)state;
    int told = 0;
    thud_velocities v = {{0, 0}, 0};
    thud_world *world = make_world(def_of(0, 1));
    drop(world, 0.6, 4);
    set_listeners(world, remember, too_late, &told);
    run(world, 10);
    assert_true(told > 0);
    assert_int_equal(thud_contact_decide(world, &remembered, NULL, &v), THUD_ERROR_INVALID);
    assert_int_equal(thud_contact_decide(world, NULL, NULL, &v), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

/* Of two decisions for a contact the later one holds, and is told once. */
static bool twice(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)settings;
    thud_velocities first = {{50, 50}, 0};
    OK(thud_contact_decide(world, contact, NULL, &first));
    return decide(world, contact, context);
}

static void the_last_decision_for_a_contact_holds(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        law l = {.after = {{0, 6}, 0}};
        thud_world *world = make_world(def_of(d, 1));
        thud_body_id ball = drop(world, 1.2, 40);
        set_listeners(world, twice, tell, &l);
        while (l.told == 0) {
            run(world, 1);
        }
        assert_true(l.told == 1 && state_of(world, ball).velocity.y == 6);
        thud_world_destroy(world);
    }
}

/* A prologue that is removed leaves nothing behind that an epilogue would be told. */
static void nothing_is_left_of_a_prologue_that_is_removed(void **state) {
    (void)state;
    law l = {.after = {{0, 6}, 0}}, later = {0};
    thud_world *world = make_world(def_of(0, 1));
    drop(world, 0.52, 2);
    set_listeners(world, ask, NULL, &l);
    run(world, 1);
    assert_int_equal(l.decided, 1);
    set_listeners(world, NULL, tell, &later);
    run(world, 1);
    assert_int_equal(later.told, 0);
    assert_true(thud_step_error_of(world).energy_decided == 0);
    thud_world_destroy(world);
}

static thud_result short_result;

static bool without_memory(thud_world *world, const thud_contact *contact,
                           thud_contact_settings *settings, void *context) {
    (void)settings;
    law *l = context;
    memory_allowed = l->asked == 0 ? 0 : l->asked == 1 ? 1 : -1;
    short_result = thud_contact_decide(world, contact, NULL, &l->after);
    memory_allowed = -1;
    assert_int_equal(short_result, l->asked++ < 2 ? THUD_ERROR_MEMORY : THUD_OK);
    return true;
}

static void a_decision_out_of_memory_changes_nothing(void **state) {
    (void)state;
    law l = {.after = {{0, 6}, 0}};
    thud_world_def def = def_of(0, 1);
    thud_world *twin = make_world(def);
    thud_body_id there = drop(twin, 0.5, 0);
    def.allocator = hostile_memory();
    thud_world *world = make_world(def);
    thud_body_id ball = drop(world, 0.5, 0);
    set_listeners(world, without_memory, NULL, &l);
    run(world, 2);
    run(twin, 2);
    assert_int_equal(short_result, THUD_ERROR_MEMORY);
    assert_true(state_of(world, ball).velocity.y == state_of(twin, there).velocity.y);
    run(world, 1);
    assert_true(l.asked == 3 && state_of(world, ball).velocity.y == 6);
    thud_world_destroy(world);
    thud_world_destroy(twin);
    assert_int_equal(memory_held, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_leaves_at_the_velocities_that_are_decided),
        cmocka_unit_test(the_energy_of_an_edit_is_not_decided),
        cmocka_unit_test(the_rest_of_the_step_is_travelled_at_it),
        cmocka_unit_test(gravity_acts_on_a_decided_velocity),
        cmocka_unit_test(a_portal_passes_and_turns_the_velocity),
        cmocka_unit_test(both_bodies_of_a_pair_can_be_decided),
        cmocka_unit_test(other_contacts_meet_the_decided_velocity),
        cmocka_unit_test(joints_and_fixed_rotation_go_on_holding),
        cmocka_unit_test(decided_bodies_wake),
        cmocka_unit_test(both_forms_decide_the_same),
        cmocka_unit_test(a_restored_world_decides_the_same),
        cmocka_unit_test(a_decision_is_not_taken_for_another_collision),
        cmocka_unit_test(what_is_refused_leaves_the_pair_to_the_solver),
        cmocka_unit_test(only_a_prologue_decides_and_only_what_it_is_asked_about),
        cmocka_unit_test(the_last_decision_for_a_contact_holds),
        cmocka_unit_test(nothing_is_left_of_a_prologue_that_is_removed),
        cmocka_unit_test(a_decision_out_of_memory_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
