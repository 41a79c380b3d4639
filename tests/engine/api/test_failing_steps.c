/* test_failing_steps.c: random worlds of every setting, each with a twin whose allocations never
 * fail. In each step the first allocation fails, then the second, and so on, until the step
 * succeeds. Until then nothing has moved and events are those of the step before; then hash, events
 * and awake bodies are the twin's. Some of the worlds are restored from a snapshot of themselves
 * between one attempt and the next. */
#include "engine_support.h"

#include "hostile_memory.h"
#include "share.h"

#include <thud/thud_joint.h>
#include <thud/thud_snapshot.h>

#include <stdio.h>

/* Bodies at most, and steps of each world. */
enum { BODIES = 400, STEPS = 110 };

/* A world of a pair. */
typedef struct side {
    thud_world *world;
    thud_body_id body[BODIES];
    thud_shape_id line;
    int count;
    int asked; /* calls of callbacks */
} side;

/* A case; the first three are indices of quality, detection and broadphase. */
typedef struct setting {
    int quality, detection, broadphase;
    bool sleeping, terrain, sensors, callbacks, tiles, queries, joints;
    uint64_t seed;
    bool restores;
} setting;

static const thud_detection *const detections[] = {NULL, &thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
static const thud_broadphase *const broadphases[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                     &thud_broadphase_all,
                                                     &thud_broadphase_sweep_both};

/* ---- callbacks that make deferred edits, with memory that does not fail ---- */

static bool prologue(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    side *s = context;
    long allowed = memory_allowed;
    memory_allowed = -1;
    if (++s->asked % 17 == 0) {
        thud_body_set_velocity(world, contact->body_b, (thud_vec2){1, 2}, 0.5f);
    }
    if (s->asked % 331 == 0) {
        thud_shape_destroy(world, contact->shape_b);
    }
    settings->friction = s->asked % 5 ? settings->friction : 0;
    memory_allowed = allowed;
    return s->asked % 13 != 0;
}

static void epilogue(thud_world *world, const thud_contact *contact, void *context) {
    side *s = context;
    long allowed = memory_allowed;
    memory_allowed = -1;
    if (++s->asked % 97 == 0) {
        thud_body_set_transform(world, contact->body_b, (thud_pos){s->asked % 7, 12}, 0);
    } else if (s->asked % 211 == 0) {
        thud_body_set_enabled(world, contact->body_b, false);
    }
    memory_allowed = allowed;
}

static void prologue_all(thud_world *world, const thud_contact *contacts,
                         thud_contact_answer *answers, int count, void *context) {
    for (int i = 0; i < count; i++) {
        answers[i].collide = prologue(world, &contacts[i], &answers[i].settings, context);
    }
}

static void epilogue_all(thud_world *world, const thud_contact *contacts, int count,
                         void *context) {
    for (int i = 0; i < count; i++) {
        epilogue(world, &contacts[i], context);
    }
}

/* ---- random worlds ---- */

/* Joins the last two bodies. Some are far apart, so that the joint pulls hard. */
static void tie(side *s, uint64_t *seed) {
    const thud_joint_kind kinds[] = {THUD_JOINT_HINGE, THUD_JOINT_DISTANCE, THUD_JOINT_WELD,
                                     THUD_JOINT_WHEEL};
    thud_joint_def def = thud_default_joint_def(kinds[(int)random_in(seed, 0, 4)]);
    def.body_a = s->count > 1 ? s->body[s->count - 2] : def.body_a;
    def.body_b = s->body[s->count - 1];
    def.length = 1;
    def.frame_a.position = (thud_vec2){(float)random_in(seed, -0.5, 0.5), 0.3f};
    def.frame_b.position = (thud_vec2){(float)random_in(seed, -0.5, 0.5), -0.3f};
    if (s->count > 1 && thud_body_is_valid(s->world, def.body_a)) {
        thud_result made = thud_joint_create(s->world, &def, NULL);
        assert_true(made == THUD_OK || made == THUD_ERROR_INVALID); /* neither body can move */
    }
}

/* Adds a random body, some of them joined to the one before. */
static void add(side *s, const setting *set, uint64_t *seed) {
    if (s->count == BODIES) {
        return;
    }
    thud_body_def def = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    int what = (int)random_in(seed, 0, 20);
    def.kind = what == 0 ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC;
    def.position = (thud_pos){random_in(seed, -9, 9), random_in(seed, 1, 14)};
    def.velocity = (thud_vec2){(float)random_in(seed, -3, 3), (float)random_in(seed, -9, 1)};
    if (what == 1) {
        def.velocity.x *= 60; /* a fast body */
        def.detection = set->detection ? NULL : detections[(int)random_in(seed, 0, 5)];
    }
    if (def.kind == THUD_BODY_KINEMATIC) {
        def.velocity = (thud_vec2){(float)random_in(seed, -1, 1), 0};
    }
    shape.restitution = what % 4 ? 0 : 0.8f;
    shape.sensor = set->sensors && what == 2;
    OK(thud_body_create(s->world, &def, &s->body[s->count]));
    float hx = (float)random_in(seed, 0.15, 0.7), hy = (float)random_in(seed, 0.15, 0.7);
    int kind = (int)random_in(seed, 0, 3);
    add_shape(s->world, s->body[s->count], hx, kind ? hy : 0, kind == 2, &shape);
    s->count++;
    if (set->joints && s->count % 4) {
        tie(s, seed);
    }
}

/* Creates a world with the setting. */
static void make(side *s, const setting *set, thud_allocator allocator) {
    thud_world_def def = thud_default_world_def_of(qualities[set->quality]);
    uint64_t seed = set->seed;
    *s = (side){.count = 0};
    def.allocator = allocator;
    def.sleeping = set->sleeping;
    def.detection = detections[set->detection];
    def.broadphase = broadphases[set->broadphase];
    s->world = make_world(def);
    if (set->callbacks) {
        bool all = set->seed % 2;
        thud_listeners listeners = {.prologue = all ? NULL : prologue,
                                    .epilogue = all ? NULL : epilogue,
                                    .prologue_all = all ? prologue_all : NULL,
                                    .epilogue_all = all ? epilogue_all : NULL,
                                    .context = s};
        OK(thud_world_set_listeners(s->world, &listeners));
    }
    if (set->tiles) {
        thud_body_id ground = add_body(s->world, THUD_BODY_STATIC, 0, 0, 0);
        thud_shape_def plain = thud_default_shape_def();
        for (int i = -12; i < 12; i++) {
            OK(thud_shape_create_aabb(s->world, ground, &plain, (thud_vec2){(float)i, -0.5f},
                                      (thud_vec2){0.5f, 0.5f}, NULL));
        }
    } else {
        add_floor(s->world, NULL);
    }
    if (set->terrain) {
        thud_pos points[30];
        for (int i = 0; i < 30; i++) {
            points[i] = (thud_pos){-15 + i, random_in(&seed, 0, 0.8)};
        }
        thud_terrain hills = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 30};
        thud_shape_def plain = thud_default_shape_def();
        OK(thud_shape_create_terrain(s->world, add_body(s->world, THUD_BODY_STATIC, 0, 0, 0),
                                     &plain, &hills, &s->line));
    }
    for (int i = 0; i < 12; i++) {
        add(s, set, &seed);
    }
}

/* The random edits of a step. Every 45 steps many bodies are created at once; in between islands
 * fall asleep. */
static void deeds(side *s, const setting *set, uint64_t seed, int step) {
    if (step % 45 == 0) {
        for (int i = 0; i < 25; i++) {
            add(s, set, &seed);
        }
    }
    if (random_in(&seed, 0, 1) < 0.05) {
        thud_body_id body = s->body[(int)random_in(&seed, 0, s->count)];
        int what = (int)random_in(&seed, 0, 5);
        if (!thud_body_is_valid(s->world, body)) {
            return;
        }
        if (what == 0) {
            OK(thud_body_destroy(s->world, body));
        } else if (what == 1) {
            OK(thud_body_set_transform(s->world, body, (thud_pos){random_in(&seed, -5, 5), 6}, 0));
        } else if (what == 2) {
            OK(thud_body_set_enabled(s->world, body, random_in(&seed, 0, 1) < 0.5));
        } else if (what == 3 && set->terrain) {
            OK(thud_shape_dig(s->world, s->line, (thud_pos){random_in(&seed, -9, 9), 0.3}, 1));
        } else {
            /* the result is ignored, as some bodies cannot wake */
            (void)thud_body_set_awake(s->world, body, true);
        }
    }
}

/* A query that applies deferred edits; its result is not used. */
static void ask(side *s) {
    thud_world_cast_ray(s->world, &(thud_ray){(thud_pos){-10, 1}, 20, 0, NULL}, NULL, NULL);
}

/* Restores the world from a snapshot of its present state. */
static void restore(side *s) {
    size_t bytes;
    OK(thud_world_get_snapshot_size(s->world, &bytes));
    void *snapshot = malloc(bytes);
    assert_non_null(snapshot);
    OK(thud_world_snapshot(s->world, snapshot, bytes, NULL));
    OK(thud_world_restore(s->world, snapshot, bytes));
    free(snapshot);
}

/* ---- comparison ---- */

/* Appends events to the text. */
static void note(char *text, size_t size, const char *what, const thud_contact_event *e,
                 int count) {
    for (int i = 0; i < count; i++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s %u %u\n", what, e[i].shape_a.index1,
                 e[i].shape_b.index1);
    }
}

/* Writes all events of the last step, in their order, to `text`. */
static const char *told(const side *s, char *text, size_t size) {
    thud_events e = thud_events_of(s->world);
    text[0] = 0;
    note(text, size, "begin", e.begin, e.begin_count);
    note(text, size, "end", e.end, e.end_count);
    note(text, size, "in", e.sensor_begin, e.sensor_begin_count);
    note(text, size, "out", e.sensor_end, e.sensor_end_count);
    for (int i = 0; i < e.hit_count; i++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "hit %u %u at %a %a by %a\n", e.hit[i].shape_a.index1,
                 e.hit[i].shape_b.index1, e.hit[i].point.x, e.hit[i].point.y,
                 (double)e.hit[i].speed);
    }
    return text;
}

/* Writes the statistics and which bodies are awake to `text`. */
static const char *awake(const side *s, char *text, size_t size) {
    thud_stats stats = thud_stats_of(s->world);
    snprintf(text, size,
             "bodies %d shapes %d awake %d pairs %d contacts %d impacts %d held %d:", stats.bodies,
             stats.shapes, stats.awake_bodies, stats.pairs, stats.contacts, stats.impacts,
             stats.held_bodies);
    for (int i = 0; i < s->count; i++) {
        size_t used = strlen(text);
        thud_body_state body = {0};
        if (thud_body_is_valid(s->world, s->body[i])) {
            OK(thud_body_get_state(s->world, s->body[i], &body));
        }
        snprintf(text + used, size - used, body.awake ? "1" : "0");
    }
    return text;
}

/* Makes one step with failing allocations; returns how many attempts failed. */
static long step_with_failures(side *s, const setting *set) {
    static char before[1 << 17], after[1 << 17];
    uint64_t hash = thud_hash_of(s->world), steps = thud_stats_of(s->world).steps;
    told(s, before, sizeof before);
    for (long failures = 0;; failures++) {
        memory_allowed = failures;
        memory_refused = 0;
        thud_result result = thud_world_step(s->world);
        memory_allowed = -1;
        if (result == THUD_OK) {
            /* a step does not succeed with a refused allocation */
            assert_int_equal(memory_refused, 0);
            return failures;
        }
        assert_int_equal(result, THUD_ERROR_MEMORY);
        if (set->callbacks && failures == 0) {
            hash = thud_hash_of(s->world); /* deferred edits are applied by now */
        }
        assert_true(thud_hash_of(s->world) == hash && thud_stats_of(s->world).steps == steps);
        assert_string_equal(told(s, after, sizeof after), before);
        if (set->queries) {
            ask(s);
        }
        if (set->restores) {
            restore(s);
        }
    }
}

/* Runs both worlds with the same edits and compares them after each step; returns how many attempts
 * failed. */
static long compare(const setting *set) {
    static char a[1 << 17], b[1 << 17];
    side here, twin;
    long failures = 0;
    memory_allowed = -1;
    make(&here, set, hostile_memory());
    make(&twin, set, (thud_allocator){0});
    for (int i = 0; i < STEPS; i++) {
        uint64_t seed = set->seed * 1000003 + (uint64_t)i * 7919 + 1;
        deeds(&here, set, seed, i);
        deeds(&twin, set, seed, i);
        if (set->queries) {
            ask(&twin);
        }
        OK(thud_world_step(twin.world));
        assert_int_equal(thud_events_of(twin.world).quarantined_count, 0);
        failures += step_with_failures(&here, set);
        bool same = thud_hash_of(here.world) == thud_hash_of(twin.world) &&
                    strcmp(told(&here, a, sizeof a), told(&twin, b, sizeof b)) == 0;
        if (!same || strcmp(awake(&here, a, sizeof a), awake(&twin, b, sizeof b)) != 0) {
            fail_msg("step %d of seed %d, quality %d, detection %d, broadphase %d differs:\n%s\n%s",
                     i, (int)set->seed, set->quality, set->detection, set->broadphase, a, b);
        }
    }
    thud_world_destroy(here.world);
    thud_world_destroy(twin.world);
    assert_int_equal(memory_held, 0);
    return failures;
}

static void steps_that_ran_out_of_memory_end_as_if_they_had_not(void **state) {
    (void)state;
    const char *wanted = getenv("THUD_CASES");
    long failures = 0;
    uint64_t seed = 88172645463325252ull;
    /* Every quality under every detection three times, or once where tests run a share. */
    int worlds = wanted ? atoi(wanted) : TEST_SHARE == 1 ? 60 : 20;
    for (int i = 0; i < worlds; i++) {
        setting set = {i % 4,
                       i / 4 % 5,
                       (int)random_in(&seed, 0, 3),
                       random_in(&seed, 0, 1) < 0.8,
                       random_in(&seed, 0, 1) < 0.5,
                       random_in(&seed, 0, 1) < 0.5,
                       random_in(&seed, 0, 1) < 0.3,
                       random_in(&seed, 0, 1) < 0.5,
                       random_in(&seed, 0, 1) < 0.3,
                       random_in(&seed, 0, 1) < 0.5,
                       (uint64_t)i + 1,
                       i % 3 == 0};
        failures += compare(&set);
    }
    print_message("%ld allocations failed in %d worlds\n", failures, worlds);
    assert_true(failures > 10 * worlds);
}

/* ---- advancing ---- */

static void advance_out_of_memory_tells_how_many_steps_it_made(void **state) {
    (void)state;
    thud_world_def def = weightless();
    def.allocator = hostile_memory();
    memory_allowed = -1;
    thud_world *world = make_world(def);
    double h = def.time_step, alpha = -1;
    int steps = -1;
    add_ball(world, 0, 0, 0.5f);
    memory_allowed = 0; /* fails at once: the time is not kept */
    assert_int_equal(thud_world_advance(world, 2.5 * h, 5, &steps, &alpha), THUD_ERROR_MEMORY);
    assert_int_equal(steps, 0);
    near_to(alpha, 0, 0);
    memory_allowed = -1;
    OK(thud_world_advance(world, 2.5 * h, 5, &steps, &alpha));
    assert_int_equal(steps, 2);
    near_to(alpha, 0.5, 1e-9);
    /* A pair that comes near in the third step from here needs an allocation, which fails. */
    thud_body_def fast = thud_default_body_def();
    thud_body_id body;
    fast.kind = THUD_BODY_DYNAMIC;
    fast.position = (thud_pos){5.3, 0};
    fast.velocity = (thud_vec2){-100, 0};
    OK(thud_body_create(world, &fast, &body));
    add_shape(world, body, 0.5f, 0, false, NULL);
    OK(thud_world_step(world));
    memory_allowed = 0;
    thud_result result = thud_world_advance(world, 5.5 * h, 9, &steps, &alpha);
    memory_allowed = -1;
    assert_int_equal(result, THUD_ERROR_MEMORY);
    assert_in_range(steps, 1, 5);
    assert_true(alpha >= 0 && alpha < 1);
    int first = steps;
    OK(thud_world_advance(world, 0, 9, &steps, &alpha));
    assert_int_equal(first + steps, 6); /* with the half step that was left over */
    near_to(alpha, 0, 1e-9);
    thud_world_destroy(world);
}

/* Workers that a single thread plays one after the other. */
static void one_after_the_other(thud_task_fn *task, void *argument, int workers, void *context) {
    (void)context;
    for (int i = 0; i < workers; i++) {
        task(argument);
    }
}

/* A heap of circles that fall on each other, of several places (TD_PLACE_SLOTS), with workers. */
static void make_large(side *s, thud_allocator allocator) {
    enum { COLUMNS = 50, ROWS = 50 };
    thud_world_def def = thud_default_world_def();
    thud_shape_def shape = thud_default_shape_def();
    def.allocator = allocator;
    def.job_system = (thud_job_system){.run = one_after_the_other, .workers = 3};
    *s = (side){.world = make_world(def)};
    add_floor(s->world, NULL);
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        double x = 0.99 * (i % COLUMNS - COLUMNS / 2), y = 0.51 + 0.99 * (i / COLUMNS);
        thud_body_id body = add_body(s->world, THUD_BODY_DYNAMIC, x, y, 0);
        add_shape(s->world, body, 0.5f, 0, false, &shape);
    }
}

/* Makes one step with so many attempts that each allocation but the first fails once. */
static long step_by_single_allocations(side *s) {
    uint64_t hash = thud_hash_of(s->world);
    for (long failures = 0;; failures++) {
        memory_allowed = 1;
        thud_result result = thud_world_step(s->world);
        memory_allowed = -1;
        if (result == THUD_OK) {
            return failures;
        }
        assert_int_equal(result, THUD_ERROR_MEMORY);
        assert_true(thud_hash_of(s->world) == hash);
    }
}

static void large_worlds_with_workers_run_out_of_memory_too(void **state) {
    (void)state;
    side here, twin;
    long failures = 0;
    memory_allowed = -1;
    make_large(&here, hostile_memory());
    make_large(&twin, (thud_allocator){0});
    for (int i = 0; i < 12; i++) {
        OK(thud_world_step(twin.world));
        failures += step_by_single_allocations(&here);
        assert_true(thud_hash_of(here.world) == thud_hash_of(twin.world));
    }
    assert_true(thud_stats_of(here.world).contacts > 4000);
    assert_true(failures > 40);
    thud_world_destroy(here.world);
    thud_world_destroy(twin.world);
    assert_int_equal(memory_held, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_that_ran_out_of_memory_end_as_if_they_had_not),
        cmocka_unit_test(advance_out_of_memory_tells_how_many_steps_it_made),
        cmocka_unit_test(large_worlds_with_workers_run_out_of_memory_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
