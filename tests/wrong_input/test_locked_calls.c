/* test_locked_calls.c: tests calls inside callbacks. An edit in a callback takes effect at the
 * start of the next step: a village whose callback makes it must behave exactly like one in which
 * it is made between the two steps. Calls that cannot be deferred are refused with a message. */
#include "share.h"
#include "village.h"

#include <thud/thud_draw.h>
#include <thud/thud_fields.h>
#include <thud/thud_rollback.h>
#include <thud/thud_snapshot.h>

/* ---- edits that are deferred to the next step ---- */

static void move(village *v) {
    OK(thud_body_set_transform(v->world, v->box, (thud_pos){-3, 2}, 0.5));
}

/* Sets a velocity. */
static void hurry(village *v) {
    OK(thud_body_set_velocity(v->world, v->plank, (thud_vec2){3, 4}, 0));
}

static void hit(village *v) {
    OK(thud_body_apply_impulse(v->world, v->box, (thud_vec2){2, 1}, (thud_pos){3, 1}));
}

static void pull(village *v) {
    OK(thud_body_apply_center_force(v->world, v->ball, (thud_vec2){50, 0}));
    OK(thud_body_apply_torque(v->world, v->ball, 1));
}

/* Puts a body to sleep. */
static void lull(village *v) {
    OK(thud_body_set_awake(v->world, v->plank, false));
}

static void switch_off(village *v) {
    OK(thud_body_set_enabled(v->world, v->box, false));
}

static void switch_on(village *v) {
    OK(thud_body_set_enabled(v->world, v->switched_off, true));
}

static void destroy_body(village *v) {
    OK(thud_body_destroy(v->world, v->ball));
    assert_false(thud_body_is_valid(v->world, v->ball));
    assert_int_equal(thud_body_destroy(v->world, v->ball), THUD_ERROR_STALE);
}

static void destroy_floor(village *v) {
    OK(thud_body_destroy(v->world, v->floor));
}

static void destroy_shape(village *v) {
    OK(thud_shape_destroy(v->world, v->box_shape));
}

static void destroy_line(village *v) {
    OK(thud_shape_destroy(v->world, v->hill));
}

static void create(village *v) {
    add_ball(v->world, -9, 3, 0.25f);
    add_box(v->world, 3, 6, 0.5f, 0.25f);
}

static void create_hundreds(village *v) {
    for (int i = 0; i < 300; i++) {
        add_ball(v->world, 60 + i, 3, 0.25f);
    }
}

/* Bodies with detections that no other body of the world has. */
static void create_sharp_sighted(village *v) {
    const thud_detection *const sharp[] = {&thud_detection_continuous, &thud_detection_bisect,
                                           &thud_detection_swept};
    for (int i = 0; i < 3; i++) {
        thud_body_def def = thud_default_body_def();
        thud_body_id body;
        def.kind = THUD_BODY_DYNAMIC;
        def.position = (thud_pos){-9 + 2 * i, 5};
        def.velocity.y = -300;
        def.detection = sharp[i];
        OK(thud_body_create(v->world, &def, &body));
        add_shape(v->world, body, 0.25f, 0, false, NULL);
    }
}

static void add_to_body(village *v) {
    add_shape(v->world, v->ball, 0.75f, 0, false, NULL);
}

/* Each added shape moves the centre of mass; impulses before it act on the body without the shape.
 */
static void add_off_centre(village *v) {
    thud_shape_def def = thud_default_shape_def();
    OK(thud_body_apply_impulse(v->world, v->plank, (thud_vec2){1, 0}, (thud_pos){3, 2}));
    OK(thud_shape_create_circle(v->world, v->plank, &def, (thud_vec2){1, 0.5f}, 0.5f, NULL));
    OK(thud_body_apply_impulse(v->world, v->plank, (thud_vec2){0, 1}, (thud_pos){4, 2}));
    OK(thud_shape_create_obb(v->world, v->plank, &def, (thud_vec2){-1, 0}, (thud_vec2){0.5f, 0.25f},
                             0.5, NULL));
}

/* Shapes of every kind on moving and resting bodies. */
static void add_to_all(village *v) {
    const thud_body_id bodies[] = {v->floor, v->ball, v->box, v->plank, v->lift, v->bare};
    const thud_pos points[] = {{-20, 4}, {20, 5}};
    const thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 2};
    thud_shape_def def = thud_default_shape_def();
    for (int i = 0; i < 6; i++) {
        def.sensor = i % 2;
        OK(thud_shape_create_circle(v->world, bodies[i], &def, (thud_vec2){0, 0.75f}, 0.25f, NULL));
        OK(thud_shape_create_obb(v->world, bodies[i], &def, (thud_vec2){-3, 0},
                                 (thud_vec2){0.25f, 2}, 0.5, NULL));
    }
    OK(thud_shape_create_terrain(v->world, v->floor, &def, &line, NULL));
}

static void create_and_destroy(village *v) {
    thud_body_id body = add_ball(v->world, -9, 3, 0.25f);
    OK(thud_body_set_velocity(v->world, body, (thud_vec2){1, 1}, 1));
    OK(thud_body_destroy(v->world, body));
}

static void rename_body(village *v) {
    OK(thud_body_set_user_data(v->world, v->box, 77));
}

typedef struct village_edit {
    const char *name;
    void (*make)(village *v);
} village_edit;

static const village_edit edits[] = {
    {"transform", move},
    {"velocity", hurry},
    {"impulse", hit},
    {"force", pull},
    {"sleep", lull},
    {"disable", switch_off},
    {"enable", switch_on},
    {"destroy body", destroy_body},
    {"destroy floor", destroy_floor},
    {"destroy shape", destroy_shape},
    {"destroy line", destroy_line},
    {"create", create},
    {"create hundreds", create_hundreds},
    {"create with detections", create_sharp_sighted},
    {"add to a body", add_to_body},
    {"add off-centre", add_off_centre},
    {"add to all", add_to_all},
    {"create and destroy", create_and_destroy},
    {"user data", rename_body},
};
enum { EDITS = sizeof edits / sizeof *edits };

/* ---- calls that are refused ---- */

static void never(thud_vec2 p, thud_style style, void *context) {
    (void)p, (void)style, (void)context;
    fail_msg("%s", "drawn inside a callback");
}

static thud_result never_played(thud_world *world, const uint64_t *inputs, void *state) {
    (void)world, (void)inputs, (void)state;
    return THUD_ERROR_INVALID;
}

static void try_what_cannot_wait(village *v) {
    const double height = 3;
    const thud_pos point = {1, 3};
    const thud_debug_draw draw = {.flags = 0xff, .upper = {9, 9}, .point = never};
    int told = v->told;
    assert_int_equal(thud_world_step(v->world), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_advance(v->world, 1, 5, NULL, NULL), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_advance(v->world, 1e-4, 5, NULL, NULL), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_advance_with(v->world, 1, 5, NULL, NULL, NULL), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_draw(v->world, &draw), THUD_ERROR_LOCKED);
    assert_int_equal(thud_shape_set_heights(v->world, v->dunes, 1, &height, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_shape_dig(v->world, v->hill, (thud_pos){200, 3}, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_shape_raise(v->world, v->hill, 200, 3, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_shape_replace_range(v->world, v->hill, 0, 2, &point, 1),
                     THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_gravity(v->world, (thud_vec2){5, 10}), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_time_step(v->world, 1.0 / 30), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_quality(v->world, &thud_quality_high), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_max_error(v->world, 0.01), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_sleeping(v->world, false), THUD_ERROR_LOCKED);
    thud_water water = thud_default_water();
    thud_vec2 wind = {1, 0};
    assert_int_equal(thud_body_apply_buoyancy(v->world, v->ball, &water), THUD_ERROR_LOCKED);
    assert_int_equal(thud_body_apply_wind(v->world, v->ball, wind, 1, 1, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_body_apply_rolling_resistance(v->world, v->ball, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_body_apply_grip(v->world, v->ball, wind, wind, 0, 1), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_save(v->world, "locked", NULL, 0), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_load(v->world, "locked", NULL, 0), THUD_ERROR_LOCKED);
    thud_rollback_options rollback = {.step = never_played};
    thud_rollback *made = NULL;
    assert_int_equal(thud_rollback_create(v->world, &rollback, &made), THUD_ERROR_LOCKED);
    assert_int_equal(thud_world_set_listeners(v->world, NULL), THUD_ERROR_LOCKED);
    thud_world_destroy(v->world); /* refused: the world still exists */
    assert_int_equal(v->told, told + 23);
    v->told = told;
}

/* ---- calls that are allowed, and change nothing ---- */

static bool count_shape(thud_shape_id shape, void *context) {
    (void)shape;
    (*(int *)context)++;
    return true;
}

/* Queries of every kind. Their results on the ground are known, because it does not move. */
static void ask_everything(village *v) {
    thud_world *w = v->world;
    const thud_pos high = {200, 9};
    thud_ray_hit hit_, hits[8];
    thud_closest_hit nearest;
    thud_volume volume;
    bool found = false;
    int count = 0, touching = 0;
    OK(thud_world_cast_ray(w, &(thud_ray){(thud_pos){190, 9}, 0, -20, NULL}, &found, &hit_));
    assert_true(found && hit_.shape.index1 == v->hill.index1);
    OK(thud_world_cast_ray_all(w, &(thud_ray){(thud_pos){-50, 9}, 0, -20, NULL}, hits, 8, &count));
    assert_int_equal(count, 1);
    OK(thud_world_cast_shape_all(w,
                                 &(thud_shape_cast){high, thud_circle_at(0, 0, 1), -9, -20, NULL},
                                 hits, 8, &count));
    assert_true(count >= 1);
    OK(thud_world_overlap_aabb(w, (thud_pos){-99, -1}, (thud_pos){99, 0.25}, NULL, count_shape,
                               &touching));
    assert_true(touching >= 3);
    OK(thud_world_closest(w, (thud_pos){185, 1}, 50, NULL, &found, &nearest));
    assert_true(found && nearest.shape.index1 == v->hill.index1);
    OK(thud_body_get_volume(w, v->floor, THUD_SHAPE_CIRCLE, high, &volume));
    assert_true(thud_measure_of(w).kinetic_energy > 0);
    (void)thud_events_of(w);
}

/* ---- the callbacks ---- */

typedef enum site { SITE_PROLOGUE = 0, SITE_EPILOGUE, SITE_OVERLAP, SITE_PASS } site;

typedef struct caller {
    village v;
    void (*edit)(village *v); /* edit that the next callback makes; null: none */
    site site;
    int asked;
} caller;

/* Called by all callbacks: makes the edit if this is the caller's site. */
static void call(caller *c, site s) {
    if (s == c->site) {
        c->asked++;
        if (c->edit) {
            void (*edit)(village *) = c->edit;
            c->edit = NULL;
            edit(&c->v);
        }
    }
}

static bool prologue(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    (void)world;
    (void)contact;
    (void)settings;
    call(context, SITE_PROLOGUE);
    return true;
}

static void epilogue(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    (void)contact;
    call(context, SITE_EPILOGUE);
}

static bool overlap(thud_shape_id shape, void *context) {
    (void)shape;
    call(context, SITE_OVERLAP);
    return true;
}

static bool pass(const thud_mover *mover, const thud_mover_hit *hit_, thud_vec2 velocity,
                 void *context) {
    (void)mover;
    (void)hit_;
    (void)velocity;
    call(context, SITE_PASS);
    return false;
}

/* A step, a query and a mover's move, each of which calls its callback. */
static void go_on(caller *c) {
    village_step(&c->v);
    OK(thud_world_overlap_shape(c->v.world, (thud_pos){3, 1}, thud_circle_at(0, 0, 3), NULL,
                                overlap, c));
}

static void make_caller(caller *c, site s, const thud_detection *detection) {
    thud_world_def def = thud_default_world_def();
    *c = (caller){.site = s};
    def.detection = detection;
    village_make(&c->v, def);
    set_listeners(c->v.world, prologue, epilogue, c);
    c->v.mover.pass = pass;
    c->v.mover.context = c;
    for (int i = 0; i < 30; i++) { /* until the mover stands on the ground */
        go_on(c);
    }
}

/* Fails if the two worlds differ in hash, statistics or events. */
static void alike(const caller *a, const caller *b, const char *name, int step) {
    const thud_world *one = a->v.world, *other = b->v.world;
    thud_stats s = thud_stats_of(one), t = thud_stats_of(other);
    thud_events e = thud_events_of(one), f = thud_events_of(other);
    if (thud_hash_of(one) != thud_hash_of(other) || s.bodies != t.bodies || s.shapes != t.shapes ||
        s.contacts != t.contacts || s.awake_bodies != t.awake_bodies ||
        e.begin_count != f.begin_count || e.end_count != f.end_count) {
        fail_msg("%s in callback %d: step %d differs from that after the same edit between steps",
                 name, (int)a->site, step);
    }
}

/* Makes an edit inside a callback in one world and between two steps in another; both must agree.
 */
static void edit_in(site s, const village_edit *edit, const thud_detection *detection) {
    caller inside, between;
    make_caller(&inside, s, detection);
    make_caller(&between, s, detection);
    inside.edit = edit->make;
    go_on(&inside);
    assert_null(inside.edit); /* the callback was called and has made the edit */
    go_on(&between);
    edit->make(&between.v);
    for (int step = 0; step < 90; step++) {
        go_on(&inside);
        go_on(&between);
        alike(&inside, &between, edit->name, step);
    }
    if (inside.v.told != between.v.told) {
        fail_msg("%s in callback %d: %d messages, not %d", edit->name, (int)s, inside.v.told,
                 between.v.told);
    }
    village_free(&inside.v);
    village_free(&between.v);
}

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum { DETECTIONS = 4 };

static void edits_inside_callbacks_wait_for_the_next_step(void **state) {
    (void)state;
    for (site s = SITE_PROLOGUE; s <= SITE_PASS; s++) {
        /* Where one case of seven runs, each edit still runs at one of the four sites. */
        for (int i = (int)s % TEST_SHARE; i < EDITS * DETECTIONS; i += TEST_SHARE) {
            edit_in(s, &edits[i / DETECTIONS], detections[i % DETECTIONS]);
        }
    }
}

static void what_cannot_wait_is_refused_inside_every_locked_callback(void **state) {
    (void)state;
    for (site s = SITE_PROLOGUE; s <= SITE_PASS; s++) {
        caller c, untouched;
        make_caller(&c, s, &thud_detection_swept);
        make_caller(&untouched, s, &thud_detection_swept);
        for (int step = 0; step < 30; step++) {
            c.edit = try_what_cannot_wait;
            go_on(&c);
            go_on(&untouched);
            assert_null(c.edit);
            alike(&c, &untouched, "what is refused", step);
        }
        village_free(&c.v);
        village_free(&untouched.v);
    }
}

static void questions_inside_callbacks_are_answered_and_change_nothing(void **state) {
    (void)state;
    for (site s = SITE_PROLOGUE; s <= SITE_PASS; s++) {
        for (int i = 0; i < DETECTIONS; i++) {
            caller c, untouched;
            make_caller(&c, s, detections[i]);
            make_caller(&untouched, s, detections[i]);
            for (int step = 0; step < 60; step++) {
                c.edit = ask_everything;
                c.asked = untouched.asked = 0;
                go_on(&c);
                go_on(&untouched);
                alike(&c, &untouched, "a question", step);
                assert_int_equal(c.asked, untouched.asked);
            }
            assert_null(c.edit);
            village_free(&c.v);
            village_free(&untouched.v);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edits_inside_callbacks_wait_for_the_next_step),
        cmocka_unit_test(questions_inside_callbacks_are_answered_and_change_nothing),
        cmocka_unit_test(what_cannot_wait_is_refused_inside_every_locked_callback),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
