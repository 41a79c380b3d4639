/* test_event_ledger.c: random worlds whose bodies come, go, jump and sleep at any time, also inside
 * callbacks, keep books of their events: whatever begins ends once, and nothing begins twice. */
#include "engine_support.h"

enum { BODIES = 48, STEPS = 240, OPEN_MAX = 4096 };

/* ---- the books: pairs that have begun and not ended ---- */

typedef struct ledger {
    thud_contact_event open[OPEN_MAX];
    int count, begun;
} ledger;

static bool same(const thud_contact_event *a, const thud_contact_event *b) {
    return memcmp(a, b, sizeof *a) == 0;
}

static int find(const ledger *l, const thud_contact_event *pair) {
    int i = 0;
    while (i < l->count && !same(&l->open[i], pair)) {
        i++;
    }
    return i;
}

static bool closes(ledger *l, const thud_contact_event *pair) {
    int i = find(l, pair);
    if (i == l->count) {
        return false;
    }
    l->open[i] = l->open[--l->count];
    return true;
}

/* Ends of what was open come first; what is left of them must be of what begins. */
static void book(ledger *l, const thud_contact_event *begin, int begins,
                 const thud_contact_event *end, int ends) {
    bool *late = calloc((size_t)ends + 1, sizeof *late);
    for (int i = 0; i < ends; i++) {
        late[i] = !closes(l, &end[i]);
    }
    for (int i = 0; i < begins; i++) {
        if (find(l, &begin[i]) < l->count) {
            fail_msg("shapes %u and %u begin twice", begin[i].shape_a.index1,
                     begin[i].shape_b.index1);
        }
        assert_true(l->count < OPEN_MAX);
        l->open[l->count++] = begin[i];
        l->begun++;
    }
    for (int i = 0; i < ends; i++) {
        if (late[i] && !closes(l, &end[i])) {
            fail_msg("shapes %u and %u end and had not begun", end[i].shape_a.index1,
                     end[i].shape_b.index1);
        }
    }
    free(late);
}

/* ---- a world that changes all the time ---- */

typedef struct chaos {
    thud_world *world;
    thud_body_id bodies[BODIES], ground;
    thud_shape_id line;
    uint64_t seed;
    ledger touches, sensed;
    int edits_inside; /* made by callbacks */
    bool quiet;       /* callbacks leave the world alone */
} chaos;

static int pick(chaos *c, int count) {
    return (int)random_in(&c->seed, 0, (double)count);
}

static void fine_or_gone(thud_result result) {
    assert_true(result == THUD_OK || result == THUD_ERROR_STALE);
}

static void add_random_shape(chaos *c, thud_body_id body) {
    thud_shape_def def = thud_default_shape_def();
    def.sensor = pick(c, 5) == 0;
    def.restitution = pick(c, 3) == 0 ? 0.8f : 0.0f;
    float x = (float)random_in(&c->seed, 0.1, 0.6), y = (float)random_in(&c->seed, 0.1, 0.6);
    add_shape(c->world, body, x, pick(c, 3) == 0 ? 0 : y, false, &def);
}

static void add_random_body(chaos *c, int i) {
    thud_body_kind kind = pick(c, 8) ? THUD_DYNAMIC : (thud_body_kind)pick(c, 2);
    c->bodies[i] = add_body(c->world, kind, random_in(&c->seed, -8, 8), random_in(&c->seed, 0, 6),
                            random_in(&c->seed, -1, 1));
    for (int shapes = pick(c, 3); shapes >= 0; shapes--) {
        add_random_shape(c, c->bodies[i]);
    }
    if (kind == THUD_KINEMATIC) {
        thud_vec2 v = {(float)random_in(&c->seed, -1, 1), 0};
        OK(thud_body_set_velocity(c->world, c->bodies[i], v, 0.5f));
    }
}

/* What falls through the ground that a prologue has taken away lands here. */
static void add_pit(chaos *c) {
    thud_body_id pit = add_body(c->world, THUD_STATIC, 0, 0, 0);
    thud_shape_def def = thud_default_shape_def();
    OK(thud_shape_create_aabb(c->world, pit, &def, (thud_vec2){0, -4}, (thud_vec2){12, 1}, NULL));
    OK(thud_shape_create_aabb(c->world, pit, &def, (thud_vec2){-11, 5}, (thud_vec2){1, 9}, NULL));
    OK(thud_shape_create_aabb(c->world, pit, &def, (thud_vec2){11, 5}, (thud_vec2){1, 9}, NULL));
}

static void add_ground(chaos *c) {
    thud_pos points[21];
    for (int i = 0; i < 21; i++) {
        points[i] = (thud_pos){i - 10.0, random_in(&c->seed, -0.3, 0.3)};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 21};
    thud_shape_def def = thud_default_shape_def();
    c->ground = add_body(c->world, THUD_STATIC, 0, 0, 0);
    OK(thud_shape_create_terrain(c->world, c->ground, &def, &line, &c->line));
}

static void edit(chaos *c) {
    thud_world *w = c->world;
    int i = pick(c, BODIES), shapes;
    thud_body_id body = c->bodies[i];
    thud_shape_id shape;
    thud_vec2 v = {(float)random_in(&c->seed, -30, 30), (float)random_in(&c->seed, -5, 15)};
    thud_pos at = {random_in(&c->seed, -8, 8), random_in(&c->seed, 0, 6)};
    switch (pick(c, 9)) {
    case 0:
        fine_or_gone(thud_body_destroy(w, body));
        break;
    case 1:
        if (!thud_body_is_valid(w, body)) {
            add_random_body(c, i);
        }
        break;
    case 2:
        fine_or_gone(thud_body_set_transform(w, body, at, 0));
        break;
    case 3:
        if (thud_body_is_valid(w, body) && state_of(w, body).kind == THUD_DYNAMIC) {
            OK(thud_body_set_velocity(w, body, v, 1));
        }
        break;
    case 4:
    case 5:
        if (thud_body_is_valid(w, body) && state_of(w, body).kind == THUD_DYNAMIC) {
            OK(thud_body_set_awake(w, body, pick(c, 4) == 0));
        }
        break;
    case 6:
        if (thud_body_is_valid(w, body) && state_of(w, body).shape_count < 4) {
            add_random_shape(c, body);
        }
        break;
    case 7:
        fine_or_gone(thud_body_set_enabled(w, body, pick(c, 3) != 0));
        break;
    default:
        if (thud_body_is_valid(w, body)) {
            OK(thud_body_shapes(w, body, &shape, 1, &shapes));
            if (shapes > 1) {
                OK(thud_shape_destroy(w, shape));
            }
        }
    }
}

static void edit_ground(chaos *c) {
    double x = random_in(&c->seed, -8, 8);
    if (pick(c, 6) == 0) {
        OK(thud_body_destroy(c->world, c->ground));
        add_ground(c);
    } else if (pick(c, 2)) {
        OK(thud_shape_dig(c->world, c->line, (thud_pos){x, 0.3}, 0.5));
    } else {
        OK(thud_shape_raise(c->world, c->line, x, 1.0, 0.3));
    }
}

static void edit_inside(chaos *c, int one_in) {
    bool hit;
    if (!c->quiet && pick(c, one_in) == 0) {
        c->edits_inside++;
        edit(c);
        OK(thud_world_cast_ray(c->world, (thud_pos){-9, 0.5}, 18, 0, NULL, &hit, NULL));
    }
}

static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                void *context) {
    (void)settings;
    (void)world;
    (void)contact;
    edit_inside(context, 20);
    return ((const chaos *)context)->quiet || pick(context, 10) != 0;
}

static void tell(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    (void)contact;
    edit_inside(context, 20);
}

static bool look(thud_shape_id shape, void *context) {
    (void)shape;
    edit_inside(context, 5);
    return true;
}

/* A query applies the edits made so far, long before the step that tells their events. */
static void query(chaos *c) {
    bool hit;
    OK(thud_world_cast_ray(c->world, (thud_pos){-9, 1}, 18, 0, NULL, &hit, NULL));
    OK(thud_world_overlap_circle(c->world, (thud_pos){0, 1}, 3, NULL, look, c));
}

static void step(chaos *c) {
    run(c->world, 1);
    thud_events e = thud_world_events(c->world);
    book(&c->touches, e.begin, e.begin_count, e.end, e.end_count);
    book(&c->sensed, e.sensor_begin, e.sensor_begin_count, e.sensor_end, e.sensor_end_count);
}

static int slept_in_all; /* bodies times steps */

static int sleepers(const chaos *c) {
    int count = 0;
    for (int i = 0; i < BODIES; i++) {
        thud_body_state state = {.awake = true};
        thud_body_get(c->world, c->bodies[i], &state);
        count += state.kind == THUD_DYNAMIC && !state.awake;
    }
    return count;
}

static void run_chaos(const thud_detection *detection, const thud_broadphase *broadphase,
                      uint64_t seed) {
    chaos *c = calloc(1, sizeof *c);
    thud_world_def def = thud_default_world_def();
    def.detection = detection;
    def.broadphase = broadphase;
    def.prologue = ask;
    def.epilogue = tell;
    def.callback_context = c;
    c->seed = seed;
    c->world = make_world(def);
    add_pit(c);
    add_ground(c);
    for (int i = 0; i < BODIES; i++) {
        add_random_body(c, i);
    }
    for (int i = 0; i < STEPS; i++) {
        c->quiet = i % 120 > 40; /* long enough for islands to fall asleep */
        for (int edits = c->quiet ? 0 : pick(c, 3); edits > 0; edits--) {
            edit(c);
        }
        if (!c->quiet && pick(c, 8) == 0) {
            edit_ground(c);
        }
        if (pick(c, 2)) {
            query(c);
        }
        step(c);
        slept_in_all += sleepers(c);
    }
    assert_true(c->edits_inside > 20);
    assert_true(c->touches.begun > 100);
    assert_true(c->sensed.begun > 20);
    c->quiet = true;
    OK(thud_body_destroy(c->world, c->ground));
    for (int i = 0; i < BODIES; i++) {
        fine_or_gone(thud_body_destroy(c->world, c->bodies[i]));
    }
    query(c);
    step(c);
    assert_int_equal(c->touches.count, 0);
    assert_int_equal(c->sensed.count, 0);
    thud_world_destroy(c->world);
    free(c);
}

static void every_begin_has_its_end_whatever_is_edited_and_where(void **state) {
    (void)state;
    const thud_detection *detections[] = {&thud_detection_overlap, &thud_detection_continuous,
                                          &thud_detection_bisect, &thud_detection_swept};
    const thud_broadphase *broadphases[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                            &thud_broadphase_all};
    for (int d = 0; d < 4; d++) {
        for (int b = 0; b < 3; b++) {
            for (uint64_t seed = 1; seed <= 4; seed++) {
                run_chaos(detections[d], broadphases[b], seed * 7919);
            }
        }
    }
    assert_true(slept_in_all > 1000);
}

/* Where the edit is seen first by a query, its end comes with the next step, as without one. */
static void end_of_what_an_edit_took_away_survives_a_query(void **state) {
    (void)state;
    for (int how = 0; how < 4; how++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_shape_def sensor = thud_default_shape_def();
        sensor.sensor = true;
        add_floor(world, NULL);
        thud_body_id zone = add_body(world, THUD_STATIC, 0, 0, 0);
        add_shape(world, zone, 1, 1, true, &sensor);
        thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
        run(world, how & 1 ? 120 : 5);
        assert_int_equal(state_of(world, ball).awake, !(how & 1));
        if (how < 2) {
            OK(thud_body_destroy(world, ball));
        } else {
            OK(thud_body_set_transform(world, ball, (thud_pos){0, 40}, 0));
        }
        bool hit;
        OK(thud_world_cast_ray(world, (thud_pos){0, 9}, 0, -20, NULL, &hit, NULL));
        assert_int_equal(thud_world_events(world).end_count, 0); /* still those of the last step */
        run(world, 1);
        assert_int_equal(thud_world_events(world).end_count, 1);
        assert_int_equal(thud_world_events(world).sensor_end_count, 1);
        thud_world_destroy(world);
    }
}

/* Nobody steps into or out of a room that goes away with a sleeper in it. */
static void sensor_that_moves_away_from_a_sleeper_ends(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    add_floor(world, NULL);
    thud_body_id zone = add_body(world, THUD_STATIC, 0, 0, 0);
    add_shape(world, zone, 1, 1, true, &sensor);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    run(world, 120);
    assert_false(state_of(world, ball).awake);
    OK(thud_body_set_transform(world, zone, (thud_pos){40, 0}, 0));
    run(world, 1);
    assert_int_equal(thud_world_events(world).sensor_end_count, 1);
    thud_world_destroy(world);
}

/* Two shapes of any kind and size side by side, nearer to each other than contacts reach, that
 * drift together and creep past each other: their fat bounds part and meet again, they touch all
 * along. */
static void drift(uint64_t *seed, bool with_skin, bool on_line) {
    chaos *c = calloc(1, sizeof *c);
    thud_world_def def = weightless();
    def.detection = with_skin ? &thud_detection_swept : &thud_detection_continuous;
    c->seed = *seed;
    c->world = make_world(def);
    float size[2][2];
    for (int i = 0; i < 4; i++) {
        size[i / 2][i % 2] = (float)random_in(seed, 0.01, 0.25);
    }
    double gap = random_in(seed, 0.001, 0.02), turn = random_in(seed, -3, 3);
    double x = size[0][0] + size[1][0] + gap;
    thud_vec2 along = {(float)random_in(seed, -0.5, 0.5), (float)random_in(seed, -0.5, 0.5)};
    for (int i = 0; i < 2; i++) {
        if (on_line && i == 0) {
            thud_pos points[] = {{-40, 0}, {-0.1, 0}, {0.1, 0}, {40, 0}};
            thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
            thud_shape_def shape = thud_default_shape_def();
            c->ground = add_body(c->world, THUD_STATIC, 0, 0, 0);
            OK(thud_shape_create_terrain(c->world, c->ground, &shape, &line, NULL));
            turn = 0.5 * 3.14159265358979323846;
            x = size[1][0] + gap;
            along.y = 0.002f * along.y;
            continue;
        }
        bool box = pick(c, 2);
        double angle = on_line ? 0 : turn;
        c->bodies[i] =
            add_body(c->world, THUD_DYNAMIC, i * x * cos(turn), i * x * sin(turn), angle);
        add_shape(c->world, c->bodies[i], size[i][0], box ? size[i][box && on_line ? 0 : 1] : 0,
                  false, NULL);
        thud_vec2 v = {along.x + (float)random_in(seed, -0.01, 0.01),
                       along.y + (float)random_in(seed, -0.002, 0.002)};
        OK(thud_body_set_velocity(c->world, c->bodies[i], v, 0));
    }
    for (int i = 0; i < 240; i++) {
        step(c);
        assert_true(thud_world_stats(c->world).pairs <= (on_line ? 3 : 1)); /* a segment each */
    }
    thud_world_destroy(c->world);
    free(c);
}

static void pair_that_drifts_within_reach_begins_once(void **state) {
    (void)state;
    uint64_t seed = 77;
    for (int i = 0; i < 400; i++) {
        drift(&seed, i % 2, i % 4 == 3);
    }
}

/* A line is one shape: what rolls from segment to segment touches it once. */
static void ball_that_rolls_over_many_segments_begins_once(void **state) {
    (void)state;
    for (int sensor = 0; sensor < 2; sensor++) {
        chaos *c = calloc(1, sizeof *c);
        c->world = make_world(thud_default_world_def());
        thud_pos points[41];
        for (int i = 0; i < 41; i++) {
            points[i] = (thud_pos){0.25 * i, -0.01 * i};
        }
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 41};
        thud_shape_def def = thud_default_shape_def();
        c->ground = add_body(c->world, THUD_STATIC, 0, 0, 0);
        OK(thud_shape_create_terrain(c->world, c->ground, &def, &line, NULL));
        thud_body_id ball = add_body(c->world, THUD_DYNAMIC, 0.5, 0.45, 0);
        add_shape(c->world, ball, 0.5f, 0, false, NULL);
        def.sensor = true;
        if (sensor) {
            add_shape(c->world, ball, 0.6f, 0, false, &def);
        }
        OK(thud_body_set_velocity(c->world, ball, (thud_vec2){4, 0}, 0));
        for (int i = 0; i < 90; i++) {
            step(c);
        }
        assert_true(state_of(c->world, ball).position.x > 4);
        assert_int_equal(c->touches.begun, 1);
        assert_int_equal(c->touches.count, 1);
        assert_int_equal(c->sensed.begun, sensor);
        thud_world_destroy(c->world);
        free(c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_begin_has_its_end_whatever_is_edited_and_where),
        cmocka_unit_test(end_of_what_an_edit_took_away_survives_a_query),
        cmocka_unit_test(sensor_that_moves_away_from_a_sleeper_ends),
        cmocka_unit_test(pair_that_drifts_within_reach_begins_once),
        cmocka_unit_test(ball_that_rolls_over_many_segments_begins_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
