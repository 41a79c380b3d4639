/* test_advance.c: thud_world_advance, with which a program steps by elapsed time: events, forces,
 * and the callbacks before and after each step give the same bits for any rate of calls. */
#include "engine_support.h"

#include "hostile_memory.h"

#include <thud/thud_fields.h>
#include <thud/thud_joint.h>
#include <thud/thud_lists.h>
#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>

enum { STEPS = 600, BALLS = 12 };

/* Calls per second, where a step is 1/60 s. */
static const double RATES[] = {20, 30, 60, 144, 7.3, 1000};
enum { RATE_COUNT = sizeof RATES / sizeof *RATES };

/* ---- a game: balls that bounce for ever, a pushed box, a buoy, a sensor gate ---- */

/* A game: its world, and what its program has counted. */
typedef struct game {
    thud_world *world;
    thud_body_id ball[BALLS], box, buoy;
    thud_joint_id tie;
    int before, after;
    /* counted by the program after each call */
    long begins, ends, hits, gates, ties, impulses, quarantined;
    uint64_t told[2]; /* hash of the begin events, and of the hits, in their order */
} game;

static thud_world_def game_def(void) {
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){0, -2};
    return def;
}

/* Creates the game's world and objects; the counters are 0. */
static void make_game(game *g, thud_world_def def) {
    memset(g, 0, sizeof *g);
    g->world = make_world(def);
    thud_shape_def bouncy = thud_default_shape_def(), gate = thud_default_shape_def();
    bouncy.restitution = 1;
    bouncy.filter.category = 2;
    gate.sensor = true;
    thud_rule rule = thud_default_rule();
    rule.event_impulse = 2;
    OK(thud_world_set_rule(g->world, 2, 1, &rule));
    add_shape(g->world, add_body(g->world, THUD_BODY_STATIC, 0, -1, 0), 20, 1, true, NULL);
    add_shape(g->world, add_body(g->world, THUD_BODY_STATIC, 0, 4, 0), 1, 0.5f, true, &gate);
    for (int i = 0; i < BALLS; i++) {
        g->ball[i] = add_body(g->world, THUD_BODY_DYNAMIC, i - 5.5, 3 + 0.31 * i, 0);
        add_shape(g->world, g->ball[i], 0.3f, 0, false, &bouncy);
    }
    g->box = add_box(g->world, 0, 30, 0.5f, 0.5f);
    g->buoy = add_box(g->world, 30, 0.5, 0.5f, 0.5f);
    thud_joint_def tie = thud_default_joint_def(THUD_JOINT_DISTANCE);
    tie.body_a = g->ball[0];
    tie.body_b = g->ball[1];
    tie.break_force = 0.5f;
    tie.only_reports = true;
    OK(thud_joint_create(g->world, &tie, &g->tie));
}

/* Adds two numbers to a hash (FNV-1a's step). */
static void mix(uint64_t *told, uint32_t a, uint32_t b) {
    *told = (*told ^ (((uint64_t)a << 32) | b)) * 1099511628211u;
}

/* Counts the events of the last call, and adds them to the hashes. */
static void count_events(game *g) {
    thud_events e = thud_events_of(g->world);
    int ties, impulses;
    const thud_joint_event *tie = thud_joint_events_of(g->world, &ties);
    const thud_impulse_event *impulse = thud_impulse_events_of(g->world, &impulses);
    g->begins += e.begin_count;
    g->ends += e.end_count;
    g->hits += e.hit_count;
    g->gates += e.sensor_begin_count + e.sensor_end_count;
    g->quarantined += e.quarantined_count;
    g->ties += ties;
    g->impulses += impulses;
    for (int i = 0; i < e.begin_count; i++) {
        mix(&g->told[0], e.begin[i].shape_a.index1, e.begin[i].shape_b.index1);
    }
    for (int i = 0; i < e.hit_count; i++) {
        uint32_t speed;
        memcpy(&speed, &e.hit[i].speed, sizeof speed);
        mix(&g->told[1], e.hit[i].shape_a.index1, speed);
    }
    for (int i = 0; i < ties; i++) {
        assert_int_equal(tie[i].joint.index1, g->tie.index1);
    }
    for (int i = 0; i < impulses; i++) {
        assert_true(impulse[i].impulse > 2);
    }
}

/* The callback before each step: forces that depend on positions, and now and then an edit. */
static void before(thud_world *world, void *context) {
    game *g = context;
    g->before++;
    assert_ptr_equal(world, g->world);
    thud_water water = thud_default_water();
    water.density = 2;
    OK(thud_body_apply_buoyancy(world, g->buoy, &water));
    if (g->before % 50 == 0) { /* an edit, and a force for one step */
        OK(thud_body_set_velocity(world, g->ball[g->before % BALLS], (thud_vec2){1, 3}, 0));
        OK(thud_body_apply_center_force(world, g->ball[0], (thud_vec2){3, 1}));
        OK(thud_body_apply_torque(world, g->ball[0], 0.5f));
    }
}

/* The callback after each step. Its forces act in the next step, which may be the first one of the
 * next call. */
static void after(thud_world *world, void *context) {
    game *g = context;
    g->after++;
    if (thud_events_of(world).hit_count > 0) {
        OK(thud_body_apply_center_force(world, g->ball[2], (thud_vec2){0.5f, 2}));
    }
}

/* Forces that the program applies before each call. */
static void pull(game *g) {
    OK(thud_body_apply_center_force(g->world, g->box, (thud_vec2){1.1f, 0.7f}));
    OK(thud_body_apply_torque(g->world, g->box, 0.3f));
    OK(thud_body_apply_center_force(g->world, g->ball[4], (thud_vec2){0.1f, 0.2f}));
}

/* Plays the game with one call for each step, as the reference. */
static void play_by_steps(game *g) {
    for (int i = 0; i < STEPS; i++) {
        pull(g);
        before(g->world, g);
        OK(thud_world_step(g->world));
        after(g->world, g);
        count_events(g);
    }
}

/* Plays the game with a call for each frame, at `rate` frames per second. */
static void play_by_pictures(game *g, double rate) {
    const thud_step_calls calls = {before, after, g};
    double h = game_def().time_step;
    for (int made = 0, steps; made < STEPS; made += steps) {
        pull(g);
        OK(thud_world_advance_with(g->world, h * 60 / rate, STEPS - made, &calls, &steps, NULL));
        count_events(g);
    }
}

/* The game has the same counts of events, the same hashes and the same final state, whether it
 * makes single steps or calls thud_world_advance_with at any rate. */
static void the_outcome_is_the_same_at_any_rate(void **state) {
    (void)state;
    for (int quality = 0; quality < QUALITIES; quality++) {
        thud_world_def def = game_def();
        def.quality = qualities[quality];
        game steps, pictures;
        make_game(&steps, def);
        play_by_steps(&steps);
        assert_true(steps.begins > 20 && steps.hits > 10 && steps.gates > 5 && steps.ties > 5);
        assert_true(steps.impulses > 0);
        for (int i = 0; i < RATE_COUNT; i++) {
            make_game(&pictures, def);
            play_by_pictures(&pictures, RATES[i]);
            assert_int_equal(pictures.before, STEPS);
            assert_int_equal(pictures.after, STEPS);
            assert_int_equal(pictures.begins, steps.begins);
            assert_int_equal(pictures.ends, steps.ends);
            assert_int_equal(pictures.hits, steps.hits);
            assert_int_equal(pictures.gates, steps.gates);
            assert_int_equal(pictures.ties, steps.ties);
            assert_int_equal(pictures.impulses, steps.impulses);
            assert_memory_equal(pictures.told, steps.told, sizeof steps.told);
            assert_true(thud_hash_of(pictures.world) == thud_hash_of(steps.world));
            thud_world_destroy(pictures.world);
        }
        thud_world_destroy(steps.world);
    }
}

/* A query, which applies deferred edits. */
static void ask(thud_world *world) {
    bool found;
    OK(thud_world_closest(world, (thud_pos){0, 0}, 1, NULL, &found, NULL));
}

/* ---- forces ---- */

/* A force gives the velocity force * time / mass, where time is that of its frame, also where the
 * force differs in each frame. */
static void a_force_acts_for_the_time_of_its_picture(void **state) {
    (void)state;
    for (int i = 0; i < RATE_COUNT; i++) {
        thud_world *world = make_world(weightless());
        thud_body_id ball = add_ball(world, 0, 0, 0.5f);
        double mass = (double)state_of(world, ball).mass, given = 0, left = 0, alpha = 0;
        uint64_t seed = 7;
        for (double passed = 0; passed < 2; passed += 1 / RATES[i]) {
            double force = random_in(&seed, -1, 3);
            OK(thud_body_apply_center_force(world, ball, (thud_vec2){(float)force, 0}));
            OK(thud_world_advance(world, 1 / RATES[i], 100, NULL, &alpha));
            given += force / RATES[i];
            left = 3 * alpha / 60; /* at most: the force of the time that is not stepped yet */
        }
        near_to((double)state_of(world, ball).velocity.x, given / mass, left / mass + 1e-5);
        thud_world_destroy(world);
    }
}

/* A force acts on the time that the next call adds, also in the later step in which that time is
 * made; it acts on no time of further calls. */
static void a_force_in_one_call_is_gone_in_the_next(void **state) {
    (void)state;
    thud_world_def def = weightless();
    def.time_step = 1.0 / 64; /* sums of it are exact */
    thud_world *world = make_world(def);
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    double h = def.time_step, mass = (double)state_of(world, ball).mass;
    OK(thud_body_apply_center_force(world, ball, (thud_vec2){1, 0}));
    OK(thud_world_advance(world, 2.5 * h, 9, NULL, NULL));
    near_to((double)state_of(world, ball).velocity.x, 2 * h / mass, 1e-7);
    OK(thud_world_advance(world, 2.5 * h, 9, NULL, NULL));
    near_to((double)state_of(world, ball).velocity.x, 2.5 * h / mass, 1e-7);
    OK(thud_world_advance(world, 2 * h, 9, NULL, NULL));
    near_to((double)state_of(world, ball).velocity.x, 2.5 * h / mass, 1e-7);
    /* A force acts for no longer than its time: neither for time that is dropped (more than the
     * maximum of steps), nor in a call without time. */
    OK(thud_body_apply_center_force(world, ball, (thud_vec2){1, 0}));
    OK(thud_world_advance(world, 10 * h, 1, NULL, NULL));
    near_to((double)state_of(world, ball).velocity.x, 3.5 * h / mass, 1e-7);
    OK(thud_body_apply_center_force(world, ball, (thud_vec2){1, 0}));
    OK(thud_world_advance(world, 0, 1, NULL, NULL));
    OK(thud_world_advance(world, h, 1, NULL, NULL));
    near_to((double)state_of(world, ball).velocity.x, 3.5 * h / mass, 1e-7);
    thud_world_destroy(world);
}

/* A field's force of a frame keeps no body awake, and a disabled body's force is dropped. */
static void forces_leave_alone_who_does_not_heed_them(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id buoy = add_box(world, 0, 0, 0.5f, 0.5f), ball = add_ball(world, 9, 9, 0.5f);
    thud_water water = thud_default_water();
    water.density = 2;
    for (int i = 0; i < 600; i++) {
        OK(thud_body_apply_buoyancy(world, buoy, &water));
        OK(thud_world_advance(world, 1.0 / 30, 9, NULL, NULL));
    }
    assert_false(state_of(world, buoy).awake);
    OK(thud_body_set_transform(world, ball, (thud_pos){9, 9}, 0));
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 0}, 0));
    OK(thud_world_set_gravity(world, (thud_vec2){0, 0}));
    OK(thud_body_apply_center_force(world, ball, (thud_vec2){9, 0}));
    OK(thud_world_advance(world, 0.5 / 60, 9, NULL, NULL));
    OK(thud_body_set_enabled(world, ball, false));
    OK(thud_world_advance(world, 1.0 / 60, 9, NULL, NULL));
    OK(thud_body_set_enabled(world, ball, true));
    OK(thud_world_advance(world, 5.0 / 60, 9, NULL, NULL));
    near_to((double)state_of(world, ball).velocity.x, 0, 0);
    thud_world_destroy(world);
}

/* A body that gets the slot of one that was pushed is not pushed. */
static void forces_are_of_the_body_that_was_pushed(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    OK(thud_world_step(world));
    OK(thud_body_apply_center_force(world, ball, (thud_vec2){9, 0}));
    OK(thud_world_advance(world, 0.5 / 60, 9, NULL, NULL));
    OK(thud_body_destroy(world, ball));
    /* from here on the slot is free, while the rest of the time is not stepped yet */
    OK(thud_world_step(world));
    thud_body_id other = add_ball(world, 0, 0, 0.5f);
    assert_int_equal(other.index1, ball.index1);
    OK(thud_world_advance(world, 2.0 / 60, 9, NULL, NULL));
    near_to((double)state_of(world, other).velocity.x, 0, 0);
    thud_world_destroy(world);
}

/* ---- a force of a contact callback acts in the next step ---- */

/* An epilogue that pushes body b of each contact upward. */
static void push_up(thud_world *world, const thud_contact *contact, void *context) {
    (void)context;
    OK(thud_body_apply_center_force(world, contact->body_b, (thud_vec2){0, 40}));
}

/* Pushes of an epilogue act in the next step alone: four rates of calls, with and without a query
 * in between, end with the same hash. */
static void forces_of_listeners_act_in_one_step(void **state) {
    (void)state;
    uint64_t hash[4];
    for (int i = 0; i < 4; i++) {
        thud_world *world = make_world(thud_default_world_def());
        add_floor(world, NULL);
        for (int k = 0; k < 5; k++) {
            add_ball(world, 3 * k, 0.7 + 0.3 * k, 0.5f);
        }
        set_listeners(world, NULL, push_up, NULL);
        double elapsed = (double[]){1, 1, 3, 0.4}[i] / 60;
        for (int made = 0, steps; made < 200; made += steps) {
            OK(thud_world_advance(world, elapsed, 200 - made, &steps, NULL));
            if (i > 0) {
                ask(world);
            }
        }
        hash[i] = thud_hash_of(world);
        assert_true(hash[i] == hash[0]);
        thud_world_destroy(world);
    }
}

/* ---- events ---- */

static void a_call_that_makes_no_step_tells_nothing(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 0.51, 0.5f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -5}, 0));
    double h = 1.0 / 60;
    OK(thud_world_advance(world, h, 1, NULL, NULL));
    assert_int_equal(thud_events_of(world).begin_count, 1);
    /* Neither a refused call nor a query changes the events. */
    assert_int_equal(thud_world_advance(world, -1, 1, NULL, NULL), THUD_ERROR_INVALID);
    assert_int_equal(thud_events_of(world).begin_count, 1);
    OK(thud_world_advance(world, 0.5 * h, 1, NULL, NULL));
    assert_int_equal(thud_events_of(world).begin_count, 0);
    assert_int_equal(thud_events_of(world).hit_count, 0);
    /* A step of thud_world_step has its own events. */
    OK(thud_body_set_transform(world, ball, (thud_pos){0, 5}, 0));
    OK(thud_world_advance(world, 2.5 * h, 9, NULL, NULL));
    assert_int_equal(thud_events_of(world).end_count, 1);
    OK(thud_world_step(world));
    assert_int_equal(thud_events_of(world).end_count, 0);
    thud_world_destroy(world);
}

/* ---- edits inside of the callbacks of a step ---- */

/* The context of callbacks that edit the world: the last ball made, and a snapshot taken inside. */
typedef struct guest {
    thud_body_id made;
    void *snapshot;
    size_t bytes;
    int calls;
} guest;

/* A callback of a step: it edits the world and takes a snapshot. Stepping, restoring and destroying
 * the world are refused. */
static void visit(thud_world *world, void *context) {
    guest *g = context;
    thud_joint_def joint = thud_default_joint_def(THUD_JOINT_HINGE);
    size_t bytes;
    g->calls++;
    assert_int_equal(thud_world_step(world), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_advance(world, 1, 1, NULL, NULL), THUD_ERROR_LOCKED);
    OK(thud_world_get_snapshot_size(world, &bytes));
    g->snapshot = realloc(g->snapshot, bytes);
    OK(thud_world_snapshot(world, g->snapshot, bytes, &g->bytes));
    assert_int_equal(thud_world_restore(world, g->snapshot, g->bytes), THUD_ERROR_LOCKED);
    thud_world_destroy(world);
    thud_body_id last = g->made;
    g->made = add_ball(world, g->calls, 20, 0.3f);
    joint.body_a = g->made;
    joint.body_b = last;
    OK(thud_joint_create(world, &joint, NULL));
    OK(thud_body_apply_center_force(world, g->made, (thud_vec2){0, 1}));
}

static void calls_may_edit_and_not_step(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    guest g = {.made = add_ball(world, 0, 20, 0.3f)};
    const thud_step_calls calls = {visit, visit, &g};
    OK(thud_world_advance_with(world, 3.5 / 60, 9, &calls, NULL, NULL));
    assert_int_equal(g.calls, 6);
    assert_int_equal(thud_stats_of(world).bodies, 7);
    OK(thud_world_restore(world, g.snapshot, g.bytes));
    OK(thud_world_advance_with(world, 0, 9, &(thud_step_calls){NULL, NULL, NULL}, NULL, NULL));
    free(g.snapshot);
    thud_world_destroy(world);
}

/* ---- snapshots ---- */

static void a_restored_world_goes_on_as_it_did(void **state) {
    (void)state;
    for (int i = 0; i < RATE_COUNT; i++) {
        game g;
        make_game(&g, game_def());
        double elapsed = 1 / RATES[i];
        uint64_t hash[2];
        long begins[2];
        for (int k = 0; k < 100; k++) {
            pull(&g);
            OK(thud_world_advance(g.world, elapsed, 99, NULL, NULL));
        }
        size_t bytes;
        OK(thud_world_get_snapshot_size(g.world, &bytes));
        void *snapshot = malloc(bytes);
        OK(thud_world_snapshot(g.world, snapshot, bytes, NULL));
        for (int time = 0; time < 2; time++) {
            g.begins = 0;
            count_events(&g);
            for (int k = 0; k < 100; k++) {
                OK(thud_world_advance(g.world, elapsed, 99, NULL, NULL));
                count_events(&g);
                pull(&g);
            }
            hash[time] = thud_hash_of(g.world);
            begins[time] = g.begins;
            OK(thud_world_restore(g.world, snapshot, bytes));
        }
        assert_true(hash[0] == hash[1]);
        assert_int_equal(begins[0], begins[1]);
        free(snapshot);
        thud_world_destroy(g.world);
    }
}

/* ---- failing allocations ---- */

/* Plays a frame at a time; a call fails at its first allocation, then at its second and so on,
 * until it succeeds. */
static void play_short_of_memory(game *g, double rate, int *failures) {
    const thud_step_calls calls = {before, after, g};
    double elapsed = game_def().time_step * 60 / rate;
    for (int made = 0, steps = 0; made < STEPS;) {
        pull(g);
        double given = elapsed;
        thud_result result = THUD_ERROR_MEMORY;
        for (int allowed = 0; result != THUD_OK; allowed++) {
            memory_allowed = allowed;
            result = thud_world_advance_with(g->world, given, STEPS - made, &calls, &steps, NULL);
            memory_allowed = -1;
            assert_true(result == THUD_OK || result == THUD_ERROR_MEMORY);
            *failures += result != THUD_OK;
            made += steps;
            if (steps > 0 || result == THUD_OK) {
                count_events(g);
                given = 0; /* the rest of the time is kept, and so are its forces */
            }
        }
    }
}

/* The same game, in worlds whose memory grows, with failing calls and without: it ends the same. */
static void steps_before_one_that_fails_are_told(void **state) {
    (void)state;
    thud_world_def def = game_def();
    def.allocator = hostile_memory();
    game steps, pictures;
    make_game(&steps, def);
    play_by_steps(&steps);
    int failures = 0;
    for (int i = 0; i < RATE_COUNT; i++) {
        make_game(&pictures, def);
        play_short_of_memory(&pictures, RATES[i], &failures);
        assert_int_equal(pictures.before, STEPS);
        assert_int_equal(pictures.begins, steps.begins);
        assert_int_equal(pictures.hits, steps.hits);
        assert_int_equal(pictures.gates, steps.gates);
        assert_memory_equal(pictures.told, steps.told, sizeof steps.told);
        assert_true(thud_hash_of(pictures.world) == thud_hash_of(steps.world));
        thud_world_destroy(pictures.world);
    }
    assert_true(failures > 10 * RATE_COUNT);
    thud_world_destroy(steps.world);
    assert_int_equal(memory_held, 0);
}

/* A ball, and the steps that were begun. */
typedef struct pushed {
    thud_body_id ball;
    int steps;
} pushed;

/* Before the second step: applies a force that is infinite, as the sum of two. */
static void push_to_infinity(thud_world *world, void *context) {
    pushed *p = context;
    for (int i = 0; p->steps == 1 && i < 2; i++) {
        OK(thud_body_apply_center_force(world, p->ball, (thud_vec2){3e38f, -3e38f}));
    }
    p->steps++;
}

/* The ball is quarantined in the last of two steps of a call; no step before had such an event, so
 * that none has reserved memory for it. */
static void first_quarantine_of_a_later_step_is_told(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    pushed p = {add_ball(world, 0, 0, 0.5f), 0};
    thud_step_calls calls = {push_to_infinity, NULL, &p};
    OK(thud_world_advance_with(world, 2.5 / 60, 2, &calls, NULL, NULL));
    assert_int_equal(thud_events_of(world).quarantined_count, 1);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_outcome_is_the_same_at_any_rate),
        cmocka_unit_test(a_force_acts_for_the_time_of_its_picture),
        cmocka_unit_test(a_force_in_one_call_is_gone_in_the_next),
        cmocka_unit_test(forces_leave_alone_who_does_not_heed_them),
        cmocka_unit_test(forces_are_of_the_body_that_was_pushed),
        cmocka_unit_test(forces_of_listeners_act_in_one_step),
        cmocka_unit_test(a_call_that_makes_no_step_tells_nothing),
        cmocka_unit_test(calls_may_edit_and_not_step),
        cmocka_unit_test(a_restored_world_goes_on_as_it_did),
        cmocka_unit_test(steps_before_one_that_fails_are_told),
        cmocka_unit_test(first_quarantine_of_a_later_step_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
