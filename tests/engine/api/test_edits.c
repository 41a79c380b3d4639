/* test_edits.c: edits of existing bodies and shapes (thud_edits.h): their effects, snapshots right
 * after them, and values out of range, at every quality and detection. */
#include "engine_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_joint.h>
#include <thud/thud_snapshot.h>

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};

typedef struct scene {
    thud_world *world;
    thud_body_id floor, box, ball;
    thud_shape_id floor_shape, box_shape, ball_shape;
} scene;

/* A box on a floor, and a ball on the box; asleep where `rest` is set. */
static scene make_scene(const thud_quality *quality, const thud_detection *detection, bool rest) {
    scene s;
    thud_world_def def = thud_default_world_def_of(quality);
    def.detection = detection;
    s.world = make_world(def);
    s.floor = add_body(s.world, THUD_BODY_STATIC, 0, -1, 0);
    s.floor_shape = add_shape(s.world, s.floor, 20, 1, false, NULL);
    s.box = add_body(s.world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
    s.box_shape = add_shape(s.world, s.box, 0.5f, 0.5f, false, NULL);
    s.ball = add_body(s.world, THUD_BODY_DYNAMIC, 0, 1.25, 0);
    s.ball_shape = add_shape(s.world, s.ball, 0.25f, 0, false, NULL);
    for (int i = 0; i < (rest ? 150 : 20); i++) {
        OK(thud_world_step(s.world));
    }
    return s;
}

static thud_body_state get(const scene *s, thud_body_id body) {
    thud_body_state state;
    OK(thud_body_get_state(s->world, body, &state));
    return state;
}

static void steps(thud_world *world, int count) {
    for (int i = 0; i < count; i++) {
        OK(thud_world_step(world));
    }
}

/* Number of edits in `change`. */
enum { CHANGES = 17 };

/* Makes edit number `which` of the 17. */
static void change(const scene *s, int which) {
    thud_world *w = s->world;
    thud_mass mass = {3, 0.5f, {0.05f, 0}};
    thud_filter filter = {1, 0, 0};
    switch (which) {
    case 0:
        OK(thud_shape_set_filter(w, s->ball_shape, filter));
        return;
    case 1:
        OK(thud_shape_set_friction(w, s->box_shape, 0));
        return;
    case 2:
        OK(thud_shape_set_restitution(w, s->floor_shape, 0.5f));
        return;
    case 3:
        OK(thud_shape_set_surface_speed(w, s->floor_shape, 1));
        return;
    case 4:
        OK(thud_shape_set_density(w, s->box_shape, 1e-3f));
        return;
    case 5:
        OK(thud_shape_set_sensor(w, s->box_shape, true));
        return;
    case 6:
        OK(thud_shape_set_radius(w, s->ball_shape, 0.4f));
        return;
    case 7:
        OK(thud_shape_set_half_extents(w, s->box_shape, (thud_vec2){0.4f, 0.3f}));
        return;
    case 8:
        OK(thud_body_set_kind(w, s->box, THUD_BODY_STATIC));
        return;
    case 9:
        OK(thud_body_set_kind(w, s->box, THUD_BODY_KINEMATIC));
        return;
    case 10:
        OK(thud_body_set_kind(w, s->floor, THUD_BODY_DYNAMIC));
        return;
    case 11:
        OK(thud_body_set_damping(w, s->ball, 1, 2));
        return;
    case 12:
        OK(thud_body_set_gravity_scale(w, s->ball, -1));
        return;
    case 13:
        OK(thud_body_set_fixed_rotation(w, s->box, true));
        return;
    case 14:
        OK(thud_body_set_detection(w, s->ball, &thud_detection_swept));
        return;
    case 15:
        OK(thud_body_set_may_sleep(w, s->box, false));
        return;
    default:
        OK(thud_body_set_mass(w, s->box, &mass));
        return;
    }
}

/* After an edit, a world that is restored from a snapshot of just after it, and one restored from
 * before it and edited again, end with the same bits. */
static void every_change_goes_with_snapshots(void **state) {
    (void)state;
    for (int c = 0; c < CHANGES * QUALITIES * 4 * 2; c++) {
        int which = c % CHANGES, set = c / CHANGES;
        scene s = make_scene(qualities[set % 4], detections[set / 4 % 4], set / 16);
        size_t before_size = 0, size = 0;
        OK(thud_world_get_snapshot_size(s.world, &before_size));
        char *before = malloc(before_size);
        OK(thud_world_snapshot(s.world, before, before_size, NULL));
        change(&s, which);
        OK(thud_world_get_snapshot_size(s.world, &size));
        char *after = malloc(size);
        OK(thud_world_snapshot(s.world, after, size, NULL));
        steps(s.world, 40);
        uint64_t first = thud_hash_of(s.world);
        OK(thud_world_restore(s.world, after, size));
        steps(s.world, 40);
        assert_int_equal(thud_hash_of(s.world), first);
        OK(thud_world_restore(s.world, before, before_size));
        change(&s, which);
        steps(s.world, 40);
        assert_int_equal(thud_hash_of(s.world), first);
        thud_world_destroy(s.world);
        free(before);
        free(after);
    }
}

/* The effect of each edit, at every quality and detection, awake and asleep. */
static void each_change_has_its_effect(void **state) {
    (void)state;
    for (int c = 0; c < CHANGES * QUALITIES * 4 * 2; c++) {
        int which = c % CHANGES, set = c / CHANGES;
        scene s = make_scene(qualities[set % 4], detections[set / 4 % 4], set / 16);
        change(&s, which);
        steps(s.world, 1);
        assert_true(which == 10 || which == 8 || get(&s, s.box).awake || get(&s, s.ball).awake);
        assert_true(fabs((double)get(&s, s.ball).velocity.y) < 1.5);
        steps(s.world, 29);
        double ball = get(&s, s.ball).position.y, box = get(&s, s.box).position.y;
        switch (which) {
        case 0:
            assert_true(ball < 0.5);
            break;
        case 3:
            assert_true(fabs(get(&s, s.box).position.x) > 0.1);
            break;
        case 4:
            assert_true(fabs(box - 0.5) < 0.05);
            break;
        case 5:
            assert_true(box < 0);
            break;
        case 6:
            assert_true(fabs(ball - 1.4) < 0.05);
            break;
        case 7:
            assert_true(fabs(box - 0.3) < 0.03);
            break;
        case 8:
        case 9:
            assert_true(fabs(box - 0.5) < 0.01 && fabs(ball - 1.25) < 0.02);
            break;
        case 10:
            assert_true(get(&s, s.floor).position.y < -1.5);
            break;
        case 12:
            assert_true(ball > 1.8);
            break;
        case 16:
            assert_true(get(&s, s.box).mass == 3 && get(&s, s.box).inertia == 0.5f);
            break;
        default:
            break;
        }
        thud_world_destroy(s.world);
    }
}

static void filters_begin_and_end_contacts(void **state) {
    (void)state;
    scene s = make_scene(&thud_quality_default, NULL, true);
    OK(thud_shape_set_filter(s.world, s.ball_shape, (thud_filter){1, 0, 0}));
    steps(s.world, 1);
    assert_int_equal(thud_events_of(s.world).end_count, 1);
    OK(thud_shape_set_filter(s.world, s.ball_shape, (thud_filter){1, UINT32_MAX, 0}));
    steps(s.world, 1);
    assert_int_equal(thud_events_of(s.world).begin_count, 1);
    thud_world_destroy(s.world);
}

/* A mass that was set stays when rotation is fixed and freed and when a density changes; null
 * restores the mass of the shapes. */
static void given_mass_outlasts_shapes_and_fixing(void **state) {
    (void)state;
    scene s = make_scene(&thud_quality_default, NULL, false);
    thud_mass mass = {3, 0.5f, {0, 0}};
    float own = get(&s, s.box).mass;
    OK(thud_body_set_mass(s.world, s.box, &mass));
    OK(thud_body_set_fixed_rotation(s.world, s.box, true));
    assert_true(get(&s, s.box).inertia == 0);
    OK(thud_shape_set_density(s.world, s.box_shape, 7));
    steps(s.world, 1);
    assert_true(get(&s, s.box).mass == 3);
    OK(thud_body_set_fixed_rotation(s.world, s.box, false));
    assert_true(get(&s, s.box).inertia == 0.5f);
    OK(thud_body_set_mass(s.world, s.box, NULL));
    assert_true(get(&s, s.box).mass == 7 * own);
    thud_world_destroy(s.world);
}

/* An AABB fixes the rotation of its body, also of one whose mass was set, until the last one is
 * destroyed. Then the body turns and takes an angle, as one that never had an AABB. */
static void body_turns_again_without_its_aabbs(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        thud_body_kind kind = k == 2 ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC;
        thud_world *w = make_world(thud_default_world_def());
        thud_shape_def def = thud_default_shape_def();
        thud_body_id body = add_body(w, kind, 0, 20, 0);
        thud_shape_id box[2];
        for (int i = 0; i < 2; i++) {
            OK(thud_shape_create_aabb(w, body, &def, (thud_vec2){(float)i, 0},
                                      (thud_vec2){0.5f, 0.5f}, &box[i]));
        }
        if (k == 1) {
            OK(thud_body_set_mass(w, body, &(thud_mass){3, 0.5f, {0, 0}}));
        }
        OK(thud_shape_destroy(w, box[0]));
        steps(w, 1);
        thud_pos place = {0, 20};
        assert_int_equal(thud_body_set_transform(w, body, place, 0.5), THUD_ERROR_INVALID);
        assert_true(state_of(w, body).inertia == 0);
        OK(thud_shape_destroy(w, box[1]));
        OK(thud_shape_create_circle(w, body, &def, (thud_vec2){0, 0}, 0.5f, NULL));
        OK(thud_body_set_transform(w, body, place, 0.25));
        steps(w, 1);
        assert_true(k != 1 || state_of(w, body).inertia == 0.5f);
        OK(thud_body_set_transform(w, body, place, 0.5));
        OK(thud_body_set_velocity(w, body, (thud_vec2){0, 0}, 3));
        steps(w, 1);
        near_to(state_of(w, body).angle, 0.5 + 3.0 / 60, 1e-5);
        thud_world_destroy(w);
    }
}

static void what_is_out_of_range_changes_nothing(void **state) {
    (void)state;
    scene s = make_scene(&thud_quality_default, NULL, true);
    thud_world *w = s.world;
    uint64_t before = thud_hash_of(w);
    thud_mass wrong[] = {{0, 1, {0, 0}}, {1, -1, {0, 0}}, {1, 1, {NAN, 0}}, {INFINITY, 1, {0, 0}}};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(thud_body_set_mass(w, s.box, &wrong[i]), THUD_ERROR_INVALID);
    }
    float bad[] = {NAN, -1, INFINITY};
    for (int i = 0; i < 3; i++) {
        assert_int_equal(thud_shape_set_friction(w, s.box_shape, bad[i]), THUD_ERROR_INVALID);
        assert_int_equal(thud_shape_set_restitution(w, s.box_shape, bad[i]), THUD_ERROR_INVALID);
        assert_int_equal(thud_shape_set_density(w, s.box_shape, bad[i]), THUD_ERROR_INVALID);
        assert_int_equal(thud_shape_set_radius(w, s.ball_shape, bad[i]), THUD_ERROR_INVALID);
        assert_int_equal(thud_shape_set_half_extents(w, s.box_shape, (thud_vec2){1, bad[i]}),
                         THUD_ERROR_INVALID);
        assert_int_equal(thud_body_set_damping(w, s.box, 0, bad[i]), THUD_ERROR_INVALID);
    }
    assert_int_equal(thud_shape_set_surface_speed(w, s.box_shape, 2e6f), THUD_ERROR_INVALID);
    assert_int_equal(thud_shape_set_radius(w, s.box_shape, 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_body_set_gravity_scale(w, s.box, NAN), THUD_ERROR_INVALID);
    assert_int_equal(thud_body_set_kind(w, s.box, THUD_BODY_KIND_COUNT), THUD_ERROR_INVALID);
    assert_int_equal(thud_body_set_mass(w, s.floor, NULL), THUD_ERROR_INVALID);
    assert_int_equal(thud_body_set_kind(NULL, s.box, THUD_BODY_STATIC), THUD_ERROR_NULL);
    steps(w, 1);
    assert_int_equal(thud_hash_of(w), before);
    assert_false(get(&s, s.box).awake);
    thud_world_destroy(w);
}

/* A body with a joint may change between kinematic and dynamic alone, and its joint stays. */
static void joints_follow_the_kind(void **state) {
    (void)state;
    for (int c = 0; c < QUALITIES * 4; c++) {
        scene s = make_scene(qualities[c / 4], detections[c % 4], c % 2);
        thud_body_id hung = add_body(s.world, THUD_BODY_DYNAMIC, 0, 5, 0);
        add_shape(s.world, hung, 0.2f, 0.2f, false, NULL);
        thud_joint_def def = thud_default_joint_def(THUD_JOINT_WELD);
        def.body_a = s.box;
        def.body_b = hung;
        def.frame_a.position.y = 4.5f;
        OK(thud_joint_create(s.world, &def, NULL));
        steps(s.world, 1);
        assert_int_equal(thud_body_set_kind(s.world, s.box, THUD_BODY_STATIC), THUD_ERROR_INVALID);
        OK(thud_body_set_kind(s.world, s.box, THUD_BODY_KINEMATIC));
        assert_int_equal(thud_body_set_kind(s.world, hung, THUD_BODY_KINEMATIC),
                         THUD_ERROR_INVALID);
        steps(s.world, 20);
        assert_true(fabs(get(&s, hung).position.y - get(&s, s.box).position.y - 4.5) < 0.1);
        OK(thud_body_set_kind(s.world, s.box, THUD_BODY_DYNAMIC));
        steps(s.world, 20);
        assert_true(hypot(get(&s, hung).position.x - get(&s, s.box).position.x,
                          get(&s, hung).position.y - get(&s, s.box).position.y) < 4.7);
        thud_world_destroy(s.world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_change_goes_with_snapshots),
        cmocka_unit_test(each_change_has_its_effect),
        cmocka_unit_test(filters_begin_and_end_contacts),
        cmocka_unit_test(given_mass_outlasts_shapes_and_fixing),
        cmocka_unit_test(body_turns_again_without_its_aabbs),
        cmocka_unit_test(what_is_out_of_range_changes_nothing),
        cmocka_unit_test(joints_follow_the_kind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
