/* test_lists.c: lists of a world's bodies, shapes, overlaps and pairs: asleep, disabled, inside
 * callbacks, with too small arrays, and refused calls. */
#include "lists_support.h"
#include "resolution_support.h"

static void empty_world_lists_nothing(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    int count = -1, shapes = -1;
    OK(thud_world_get_bodies(world, NULL, 0, &count));
    assert_int_equal(count, 0);
    OK(thud_world_get_awake_bodies(world, NULL, 0, &count));
    assert_int_equal(count, 0);
    OK(thud_world_get_shapes(world, NULL, 0, &count));
    assert_int_equal(count, 0);
    count = -1;
    OK(thud_world_get_slot_counts(world, &count, &shapes));
    assert_int_equal(count, 0);
    assert_int_equal(shapes, 0);
    OK(thud_world_get_slot_counts(world, NULL, NULL));
    watch w = {0};
    assert_int_equal(look(&w, world), 0);
    thud_world_destroy(world);
}

/* A body leaves the list of awake bodies when it sleeps or is disabled, and returns when it wakes;
 * the list of all bodies keeps it. */
static void sleepers_leave_the_awake_and_come_back(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *world = make_world(thud_default_world_def_of(qualities[q]));
        thud_body_id floor = add_floor(world, NULL),
                     lift = add_body(world, THUD_BODY_KINEMATIC, 9, 9, 0);
        thud_body_id box = add_kind(world, 2, 0, 0.5, NULL);
        assert_true(is_among_awake(world, box)); /* also before its first step */
        assert_false(is_among_awake(world, floor));
        run(world, 150);
        assert_false(is_among_awake(world, box));
        assert_true(is_among_awake(world, lift));
        assert_true(is_among_bodies(world, box) && is_among_bodies(world, floor));
        OK(thud_body_set_velocity(world, box, (thud_vec2){1, 0}, 0));
        assert_true(is_among_awake(world, box));
        OK(thud_body_set_enabled(world, box, false));
        assert_false(is_among_awake(world, box));
        run(world, 1);
        assert_false(is_among_awake(world, box));
        assert_true(is_among_bodies(world, box));
        thud_world_destroy(world);
    }
}

/* ---- inside callbacks ---- */

/* What the prologue made and read. */
typedef struct inside {
    thud_body_id floor, ball, made;
    thud_shape_id sensor, late;
    watch w;
    int asked, sensed;
    thud_pair pair;
} inside;

/* A prologue that edits and asks for lists once: edits of new bodies are seen at once, the others
 * are deferred. */
static bool ask_inside(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *settings, void *context) {
    inside *in = context;
    (void)settings;
    if (in->asked++ == 0) {
        in->made = add_body(world, THUD_BODY_DYNAMIC, 50, 50, 0);
        in->late = add_shape(world, in->made, 0.5f, 0, false, NULL);
        assert_true(is_among_bodies(world, in->made) && is_among_awake(world, in->made));
        assert_true(is_among_shapes(world, in->late));
        in->sensed = sensed_by(world, in->sensor); /* overlaps of the step before */
        OK(thud_body_set_transform(world, in->floor, (thud_pos){0, -1.25}, 0));
        OK(thud_world_get_pair(world, contact->shape_a, contact->shape_b, &in->pair));
        assert_int_equal(look(&in->w, world), 1);
        assert_true(told(&in->w, in->made));
        OK(thud_body_destroy(world, in->made));
        assert_false(is_among_bodies(world, in->made) || is_among_shapes(world, in->late));
        assert_int_equal(look(&in->w, world), 0);
    }
    return true;
}

/* Inside a callback, lists and pairs are of the step in progress: new bodies are listed, overlaps
 * of sensors are those of the last step. */
static void callbacks_read_the_step_under_way(void **state) {
    (void)state;
    inside in = {0};
    thud_shape_def sensor = thud_default_shape_def();
    thud_world *world = make_world_with(&thud_detection_overlap, ask_inside, &in, false);
    sensor.sensor = true;
    in.floor = add_floor(world, NULL);
    in.sensor = add_shape(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), 3, 3, true, &sensor);
    in.ball = add_ball(world, 0, 0.5, 0.5f);
    OK(thud_body_set_user_data(world, in.ball, 7));
    look(&in.w, world);
    run(world, 1);
    assert_true(in.asked > 0);
    assert_int_equal(in.sensed, 0);
    /* two static shapes do not overlap as sensors */
    assert_int_equal(sensed_by(world, in.sensor), 1);
    assert_true(same_body(in.pair.a.body, in.floor) && same_body(in.pair.b.body, in.ball));
    assert_int_equal(in.pair.b.body_data, 7);
    look(&in.w, world);
    assert_false(told(&in.w, in.floor)); /* the edit is deferred */
    run(world, 1);
    look(&in.w, world);
    assert_true(told(&in.w, in.floor));
    thud_world_destroy(world);
}

/* ---- sensors ---- */

/* thud_shape_get_sensor_overlaps lists the shapes in the order of their slots, while bodies sleep
 * as well; destroyed and disabled ones are left out at once. */
static void sensor_lists_by_slot_what_it_overlaps_now(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def def = thud_default_shape_def();
    thud_pos points[9];
    thud_shape_id ground, sensor, balls[6], list[8] = {0};
    thud_body_id bodies[6];
    int count;
    for (int i = 0; i < 9; i++) {
        points[i] = (thud_pos){0.5 * (i - 4), 0};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 9};
    for (int i = 0; i < 6; i++) {
        bodies[i] = add_body(world, THUD_BODY_DYNAMIC, 0.6 * i - 1.5, 0.3, 0);
        balls[i] = add_shape(world, bodies[i], 0.25f, 0, false, NULL);
    }
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 &ground));
    def.sensor = true;
    thud_body_id carrier = add_body(world, THUD_BODY_KINEMATIC, 0, 0, 0);
    sensor = add_shape(world, carrier, 2, 1, true, &def);
    assert_int_equal(sensed_by(world, sensor), 0); /* no step has been made since it was created */
    for (int asleep = 0; asleep < 2; asleep++) {
        run(world, asleep ? 200 : 1);
        assert_int_equal(state_of(world, bodies[0]).awake, !asleep);
        OK(thud_shape_get_sensor_overlaps(world, sensor, list, 8, &count));
        assert_int_equal(count, 7); /* all segments of the terrain are one shape */
        for (int i = 0; i < 6; i++) {
            assert_true(same_shape(list[i], balls[i]));
        }
        assert_true(same_shape(list[6], ground));
        for (int room = 0; room < 7; room++) {
            memset(list, 0, sizeof list);
            OK(thud_shape_get_sensor_overlaps(world, sensor, list, room, &count));
            assert_int_equal(count, 7);
            for (int i = 0; i < 8; i++) {
                assert_int_equal(list[i].index1, i < room ? balls[i].index1 : 0);
            }
        }
    }
    OK(thud_body_destroy(world, bodies[1]));
    OK(thud_shape_destroy(world, balls[2]));
    OK(thud_body_set_enabled(world, bodies[4], false));
    for (int step = 0; step < 2; step++) {
        OK(thud_shape_get_sensor_overlaps(world, sensor, list, 8, &count));
        assert_int_equal(count, 4);
        assert_true(same_shape(list[1], balls[3]) && same_shape(list[2], balls[5]));
        run(world, 1);
    }
    OK(thud_body_set_enabled(world, carrier, false));
    assert_int_equal(sensed_by(world, sensor), 0);
    thud_world_destroy(world);
}

/* A terrain as a sensor: a box lies over five of its segments, and a ball over two. */
static void line_that_senses_lists_each_shape_once(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    thud_pos points[9];
    thud_shape_id sensor, list[4];
    int count;
    for (int i = 0; i < 9; i++) {
        points[i] = (thud_pos){0.5 * (i - 4), 0};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 9};
    def.sensor = true;
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 &sensor));
    thud_shape_id box =
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, -0.5, 0, 0), 1, 0.2f, false, NULL);
    thud_shape_id ball =
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, 1, 0, 0), 0.3f, 0, false, NULL);
    run(world, 2);
    OK(thud_shape_get_sensor_overlaps(world, sensor, list, 4, &count));
    assert_int_equal(count, 2);
    assert_true(same_shape(list[0], box) && same_shape(list[1], ball));
    thud_world_destroy(world);
}

/* ---- pairs ---- */

static bool side_is(thud_pair_side side, thud_body_id body, uint64_t body_data,
                    uint64_t shape_data) {
    return same_body(side.body, body) && side.body_data == body_data &&
           side.shape_data == shape_data;
}

/* thud_world_get_pair tells the bodies and user data of an event's shapes; for a shape that was
 * destroyed it tells nothing, also where its slot is used again. */
static void pair_tells_whose_shapes_met_and_what_is_gone(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def def = thud_default_shape_def();
    thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 3, 0);
    thud_pair pair;
    def.user_data = 11;
    add_shape(world, floor, 10, 1, true, &def);
    def.user_data = 22;
    add_shape(world, ball, 0.5f, 0, false, &def);
    OK(thud_body_set_user_data(world, floor, 1));
    OK(thud_body_set_user_data(world, ball, 2));
    thud_events e = thud_events_of(world);
    for (int i = 0; i < 120 && !e.hit_count; i++) {
        run(world, 1);
        e = thud_events_of(world);
    }
    assert_int_equal(e.hit_count, 1);
    assert_int_equal(e.begin_count, 1);
    OK(thud_world_get_pair(world, e.begin[0].shape_a, e.begin[0].shape_b, &pair));
    assert_true(side_is(pair.a, floor, 1, 11) && side_is(pair.b, ball, 2, 22));
    assert_false(pair.a.sensor || pair.b.sensor);
    OK(thud_world_get_pair(world, e.hit[0].shape_b, e.hit[0].shape_a, &pair));
    assert_true(side_is(pair.a, ball, 2, 22) && side_is(pair.b, floor, 1, 11));
    OK(thud_body_destroy(world, ball));
    run(world, 1);
    e = thud_events_of(world);
    assert_int_equal(e.end_count, 1);
    def.user_data = 33;
    def.sensor = true;
    add_shape(world, add_body(world, THUD_BODY_DYNAMIC, 0, 9, 0), 0.5f, 0, false, &def);
    OK(thud_world_get_pair(world, e.end[0].shape_a, e.end[0].shape_b, &pair));
    /* the new shape in the slot is not taken for the destroyed one */
    assert_true(side_is(pair.a, floor, 1, 11));
    assert_true(side_is(pair.b, (thud_body_id){0, 0}, 0, 0));
    thud_shape_id young = {0};
    OK(thud_world_get_shape_at(world, (int)e.end[0].shape_b.index1 - 1, &young));
    OK(thud_world_get_pair(world, young, (thud_shape_id){77, 77}, &pair));
    assert_true(pair.a.shape_data == 33 && pair.a.sensor && pair.b.body.index1 == 0);
    thud_world_destroy(world);
}

/* ---- what is refused ---- */

static void hear(thud_result result, const char *message, void *context) {
    (void)message;
    *(thud_result *)context = result;
}

#define REFUSED(wanted, call)            \
    do {                                 \
        heard = THUD_OK;                 \
        assert_int_equal(call, wanted);  \
        assert_int_equal(heard, wanted); \
        assert_int_equal(count, -1);     \
    } while (0)

static void wrong_questions_are_refused(void **state) {
    (void)state;
    thud_result heard = THUD_OK;
    thud_world_def def = weightless();
    def.log = hear;
    def.log_context = &heard;
    thud_world *world = make_world(def);
    thud_body_id ball = add_ball(world, 0, 0, 0.5f), body;
    thud_shape_id shape, list[1], gone;
    thud_body_seen seen[1] = {0};
    thud_pair pair;
    int count = -1;
    OK(thud_body_get_shapes(world, ball, &shape, 1, NULL));
    gone = add_shape(world, ball, 1, 0, false, NULL);
    OK(thud_shape_destroy(world, gone));

    assert_int_equal(thud_world_get_bodies(NULL, &body, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_awake_bodies(NULL, &body, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_shapes(NULL, list, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_slot_counts(NULL, &count, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_body_at(NULL, 0, &body), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_shape_at(NULL, 0, list), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_moved_bodies(NULL, seen, 1, &body, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_shape_get_sensor_overlaps(NULL, shape, list, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_pair(NULL, shape, shape, &pair), THUD_ERROR_NULL);

    REFUSED(THUD_ERROR_NULL, thud_world_get_bodies(world, NULL, 1, &count));
    REFUSED(THUD_ERROR_NULL, thud_world_get_bodies(world, &body, 1, NULL));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_bodies(world, &body, -1, &count));
    REFUSED(THUD_ERROR_NULL, thud_world_get_awake_bodies(world, NULL, 1, &count));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_awake_bodies(world, &body, -1, &count));
    REFUSED(THUD_ERROR_NULL, thud_world_get_shapes(world, NULL, 1, &count));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_shapes(world, list, -1, &count));
    REFUSED(THUD_ERROR_NULL, thud_world_get_moved_bodies(world, NULL, 1, &body, 1, &count));
    REFUSED(THUD_ERROR_NULL, thud_world_get_moved_bodies(world, seen, 1, NULL, 1, &count));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_moved_bodies(world, seen, -1, &body, 1, &count));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_moved_bodies(world, seen, 1, &body, -1, &count));
    REFUSED(THUD_ERROR_NULL, thud_shape_get_sensor_overlaps(world, shape, NULL, 1, &count));
    REFUSED(THUD_ERROR_INVALID, thud_shape_get_sensor_overlaps(world, shape, list, -1, &count));
    REFUSED(THUD_ERROR_INVALID, thud_shape_get_sensor_overlaps(world, shape, list, 1, &count));
    REFUSED(THUD_ERROR_STALE, thud_shape_get_sensor_overlaps(world, gone, list, 1, &count));
    REFUSED(THUD_ERROR_NULL, thud_world_get_body_at(world, 0, NULL));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_body_at(world, -1, &body));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_body_at(world, 1, &body));
    REFUSED(THUD_ERROR_NULL, thud_world_get_shape_at(world, 0, NULL));
    REFUSED(THUD_ERROR_INVALID, thud_world_get_shape_at(world, 2, list));
    REFUSED(THUD_ERROR_NULL, thud_world_get_pair(world, shape, shape, NULL));
    assert_int_equal(seen[0].body.index1, 0);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_world_lists_nothing),
        cmocka_unit_test(sleepers_leave_the_awake_and_come_back),
        cmocka_unit_test(callbacks_read_the_step_under_way),
        cmocka_unit_test(sensor_lists_by_slot_what_it_overlaps_now),
        cmocka_unit_test(line_that_senses_lists_each_shape_once),
        cmocka_unit_test(line_that_senses_lists_each_shape_once),
        cmocka_unit_test(pair_tells_whose_shapes_met_and_what_is_gone),
        cmocka_unit_test(wrong_questions_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
