/* test_log.c: the log of refused calls: when it is set, its default, and that each message names
 * the wrong field. */
#include "engine_support.h"

#include <thud/thud_casts.h>
#include <thud/thud_fields.h>
#include <thud/thud_joint.h>
#include <thud/thud_make.h>
#include <thud/thud_mover.h>

#include <math.h>
#include <stdio.h>

/* What the log was given last, and how many messages there were. */
typedef struct heard {
    thud_result result;
    char message[200];
    int count;
} heard;

static void hear(thud_result result, const char *message, void *context) {
    heard *h = context;
    h->result = result;
    snprintf(h->message, sizeof h->message, "%s", message);
    h->count++;
}

/* Asserts that there was one message, with this result and word. */
static void expect(heard *h, thud_result result, const char *word) {
    if (h->count != 1 || h->result != result || !strstr(h->message, word)) {
        fail_msg("%d messages, the last %d: %s; wanted %s", h->count, (int)h->result, h->message,
                 word);
    }
    h->count = 0;
}

static void a_log_is_set_on_any_world(void **state) {
    (void)state;
    heard h = {.count = 0};
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    OK(thud_world_set_log(world, hear, &h));
    assert_int_equal(thud_world_set_time_step(world, -1), THUD_ERROR_INVALID);
    expect(&h, THUD_ERROR_INVALID, "time step");
    OK(thud_world_set_log(world, NULL, NULL));
    assert_int_equal(thud_world_set_time_step(world, -1), THUD_ERROR_INVALID);
    assert_int_equal(h.count, 0);
    assert_int_equal(thud_world_set_log(NULL, hear, &h), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

/* Tests are compiled with the same NDEBUG as the library. */
static void without_NDEBUG_worlds_write_to_stderr(void **state) {
    (void)state;
#if defined(NDEBUG)
    assert_true(thud_default_world_def().log == NULL);
#else
    assert_true(thud_default_world_def().log == thud_log_to_stderr);
#endif
    char line[200] = "";
    FILE *file = freopen("test_log.txt", "w+", stderr);
    assert_non_null(file);
    thud_log_to_stderr(THUD_ERROR_INVALID, "a reason", NULL);
    rewind(file);
    assert_non_null(fgets(line, sizeof line, file));
    assert_string_equal(line, "thud: refused: a reason\n");
    remove("test_log.txt");
}

/* ---- messages ---- */

static void worlds_name_the_field(void **state) {
    (void)state;
    static const struct {
        size_t at;
        const char *name;
    } fields[] = {{offsetof(thud_world_def, contact_damping), "contact_damping"},
                  {offsetof(thud_world_def, push_speed), "push_speed"},
                  {offsetof(thud_world_def, restitution_threshold), "restitution_threshold"},
                  {offsetof(thud_world_def, hit_speed), "hit_speed"},
                  {offsetof(thud_world_def, maximum_speed), "maximum_speed"}};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        heard h = {.count = 0};
        thud_world *world = NULL;
        thud_world_def def = thud_default_world_def();
        const float wrong = -1;
        memcpy((char *)&def + fields[i].at, &wrong, sizeof wrong);
        def.log = hear;
        def.log_context = &h;
        assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
        expect(&h, THUD_ERROR_INVALID, fields[i].name);
    }
}

/* A drive that is refused, and a part of the message. */
typedef struct drive_case {
    thud_joint_kind kind;
    int direction;
    thud_drive drive;
    const char *word;
} drive_case;

/* A joint with a wrong drive is refused with a message that names the field, its value and its
 * range. */
static void drives_name_the_field(void **state) {
    (void)state;
    const drive_case cases[] = {
        {THUD_JOINT_HINGE,
         THUD_DIRECTION_TURN,
         {.limited = true, .lower = 1, .upper = -1},
         "lower is above"},
        {THUD_JOINT_HINGE,
         THUD_DIRECTION_TURN,
         {.limited = true, .upper = 90},
         "upper is 90, not in [-3.141593, 3.141593]"},
        {THUD_JOINT_SLIDER,
         THUD_DIRECTION_ALONG,
         {.limited = true, .upper = 1e9f},
         "upper is 1e9, not in [-1000000, 1000000]"},
        {THUD_JOINT_DISTANCE,
         THUD_DIRECTION_ALONG,
         {.limited = true, .lower = -1},
         "lower is -1, not in [0, 1000000]"},
        {THUD_JOINT_HINGE,
         THUD_DIRECTION_TURN,
         {.frequency = -1},
         "frequency is -1, not in [0, 10000]"},
        {THUD_JOINT_HINGE,
         THUD_DIRECTION_TURN,
         {.damping = NAN},
         "damping is NaN, not in [0, 1000]"},
        {THUD_JOINT_HINGE, THUD_DIRECTION_TURN, {.target = 90}, "target is 90"},
        {THUD_JOINT_HINGE,
         THUD_DIRECTION_TURN,
         {.spring_force = -1},
         "spring_force is -1, not in [0, 1e30]"},
        {THUD_JOINT_HINGE, THUD_DIRECTION_TURN, {.motor_speed = 1e9f}, "motor_speed is 1e9"},
        {THUD_JOINT_SLIDER, THUD_DIRECTION_ALONG, {.motor_speed = NAN}, "motor_speed is NaN"},
        {THUD_JOINT_HINGE, THUD_DIRECTION_TURN, {.motor_force = -1}, "motor_force is -1"},
        /* In a direction that the kind of joint cannot drive. */
        {THUD_JOINT_HINGE, THUD_DIRECTION_ALONG, {.frequency = 2}, "no drive along"},
        {THUD_JOINT_SLIDER, THUD_DIRECTION_TURN, {.motor_force = 2}, "no drive of turn"},
        {THUD_JOINT_FILTER, THUD_DIRECTION_ACROSS, {.limited = true}, "no drive across"},
    };
    heard h = {.count = 0};
    thud_world_def world_def = thud_default_world_def();
    world_def.log = hear;
    world_def.log_context = &h;
    thud_world *world = make_world(world_def);
    thud_joint_id joint;
    thud_body_id a = add_ball(world, 0, 0, 0.5f), b = add_ball(world, 2, 0, 0.5f);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        thud_joint_def def = thud_default_joint_def(cases[i].kind);
        def.body_a = a;
        def.body_b = b;
        def.drive[cases[i].direction] = cases[i].drive;
        assert_int_equal(thud_joint_create(world, &def, &joint), THUD_ERROR_INVALID);
        expect(&h, THUD_ERROR_INVALID, cases[i].word);
    }
    /* A motor without force is created, with a message. */
    thud_joint_def def = thud_default_joint_def(THUD_JOINT_HINGE);
    def.body_a = a;
    def.body_b = b;
    def.drive[THUD_DIRECTION_TURN].motor_speed = 3;
    OK(thud_joint_create(world, &def, &joint));
    expect(&h, THUD_OK, "motor_speed without");
    OK(thud_joint_set_drive(world, joint, THUD_DIRECTION_TURN, &def.drive[THUD_DIRECTION_TURN]));
    expect(&h, THUD_OK, "motor_speed without");
    /* So is a joint with limits that are not switched on; turning them off later is no mistake. */
    def = thud_default_joint_def(THUD_JOINT_HINGE);
    def.body_a = a;
    def.body_b = b;
    thud_drive *turn = &def.drive[THUD_DIRECTION_TURN];
    turn->lower = -1;
    OK(thud_joint_create(world, &def, &joint));
    expect(&h, THUD_OK, "without `limited`");
    turn->limited = true;
    OK(thud_joint_create(world, &def, &joint));
    turn->limited = false;
    OK(thud_joint_set_drive(world, joint, THUD_DIRECTION_TURN, turn));
    assert_int_equal(h.count, 0);
    thud_world_destroy(world);
}

/* Messages print numbers with as many digits as they need. */
static void numbers_are_told_as_they_were_written(void **state) {
    (void)state;
    const struct {
        double value;
        const char *text;
    } cases[] = {
        {-0.1, "is -0.1, not in [0, 1e9]"},
        {-12.5, "is -12.5,"},
        {(double)-0.3f, "is -0.3,"},
        {-1234567, "is -1234567,"},
        {-123456789, "is -1.234568e8,"},
        {-3.25e-7, "is -0.000000325,"},
        {-1.5e-12, "is -1.5e-12,"},
        {-5e-324, "is -4.940656e-324,"},
        {1e300, "is 1e300,"},
        {1.7976931348623157e308, "is 1.797693e308,"},
        {INFINITY, "is infinity,"},
        {-INFINITY, "is -infinity,"},
        {NAN, "is NaN,"},
    };
    heard h = {.count = 0};
    thud_world *world = make_world(thud_default_world_def());
    OK(thud_world_set_log(world, hear, &h));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(thud_world_set_max_error(world, cases[i].value), THUD_ERROR_INVALID);
        expect(&h, THUD_ERROR_INVALID, cases[i].text);
    }
    assert_int_equal(thud_world_set_time_step(world, 0), THUD_ERROR_INVALID);
    expect(&h, THUD_ERROR_INVALID, "time_step is 0, not in (0, 1]");
    thud_world_destroy(world);
}

/* A terrain with a wrong field is refused with a message that names the field. */
static void lines_name_the_field(void **state) {
    (void)state;
    thud_pos points[] = {{0, 0}, {1, 0}}, falling[] = {{0, 0}, {-1, 0}};
    const struct {
        thud_terrain line;
        const char *word;
    } cases[] = {
        {{.kind = THUD_TERRAIN_FLAT, .slope = NAN}, "slope"},
        {{.kind = THUD_TERRAIN_UNIFORM, .points = points, .count = 2}, "spacing is not above 0"},
        {{.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 1}, "count"},
        {{.kind = THUD_TERRAIN_IRREGULAR, .count = 2}, "points is null"},
        {{.kind = THUD_TERRAIN_IRREGULAR, .points = falling, .count = 2}, "x does not rise"},
        {{.kind = (thud_terrain_kind)7, .points = points, .count = 2}, "kind"},
    };
    heard h = {.count = 0};
    thud_world *world = make_world(thud_default_world_def());
    OK(thud_world_set_log(world, hear, &h));
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_def def = thud_default_shape_def();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        thud_result result = thud_shape_create_terrain(world, ground, &def, &cases[i].line, NULL);
        assert_int_not_equal(result, THUD_OK);
        expect(&h, result, cases[i].word);
    }
    assert_int_equal(thud_body_make(world, thud_circle_at(0, 0, -1), NULL).index1, 0);
    expect(&h, THUD_ERROR_INVALID, "radius");
    thud_world_destroy(world);
}

static double keep_on(const thud_ray_hit *hit, void *context) {
    (void)hit, (void)context;
    return THUD_CAST_ON;
}

static bool none(thud_shape_id shape, void *context) {
    (void)shape, (void)context;
    return true;
}

/* A filter that was zeroed and not begun from its default, and an explosion without a size. */
static void what_meets_nobody_is_refused(void **state) {
    (void)state;
    heard h = {.count = 0};
    thud_world *world = make_world(thud_default_world_def());
    OK(thud_world_set_log(world, hear, &h));
    add_ball(world, 0, 0, 0.5f);
    const thud_query_filter zero = {0};
    const thud_pos at = {-3, 0};
    thud_geometry ball = thud_circle_at(0, 0, 1);
    thud_ray_hit hit;
    thud_mover mover = thud_default_mover(ball);
    mover.filter = zero;
    thud_explosion blast = thud_default_explosion(), pointed = blast;
    blast.radius = 1;
    blast.filter = zero;
    const thud_ray ray = {.dx = 6, .filter = &zero};
    const thud_shape_cast cast = {.shape = ball, .dx = 6, .filter = &zero};
    const struct {
        thud_result result;
        const char *word;
    } refused[] = {
#define FILTER(call) {call, "category and mask"}
        FILTER(thud_world_cast_ray(world, &(thud_ray){at, 6, 0, &zero}, NULL, NULL)),
        FILTER(thud_world_cast_ray_all(world, &(thud_ray){at, 6, 0, &zero}, NULL, 0, NULL)),
        FILTER(thud_world_cast_ray_each(world, &(thud_ray){at, 6, 0, &zero}, keep_on, NULL)),
        FILTER(thud_world_cast_rays(world, &ray, 1, &hit)),
        FILTER(thud_world_cast_shape(world, &(thud_shape_cast){at, ball, 6, 0, &zero}, NULL, NULL)),
        FILTER(thud_world_cast_shape_each(world, &(thud_shape_cast){at, ball, 6, 0, &zero}, keep_on,
                                          NULL)),
        FILTER(thud_world_cast_shapes(world, &cast, 1, &hit)),
        FILTER(thud_world_closest(world, at, 6, &zero, NULL, NULL)),
        FILTER(thud_world_overlap_shape(world, at, thud_circle_at(0, 0, 1), &zero, none, NULL)),
        FILTER(thud_mover_move(world, &mover, (thud_vec2){0, 0}, 0.1, NULL)),
        FILTER(thud_world_explode(world, &blast, NULL)),
#undef FILTER
        {thud_world_explode(world, &pointed, NULL), "radius and falloff are 0"},
    };
    enum { CALLS = sizeof refused / sizeof *refused };
    for (int i = 0; i < CALLS; i++) {
        assert_int_equal(refused[i].result, THUD_ERROR_INVALID);
    }
    assert_int_equal(h.count, CALLS);
    h.count = 1;
    expect(&h, THUD_ERROR_INVALID, refused[CALLS - 1].word);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_log_is_set_on_any_world),
        cmocka_unit_test(worlds_name_the_field),
        cmocka_unit_test(drives_name_the_field),
        cmocka_unit_test(numbers_are_told_as_they_were_written),
        cmocka_unit_test(lines_name_the_field),
        cmocka_unit_test(what_meets_nobody_is_refused),
        cmocka_unit_test(without_NDEBUG_worlds_write_to_stderr), /* the last: it takes stderr */
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
