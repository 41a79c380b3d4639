/* test_limits.c: tests each limit of thud_limits.h at the field or argument that it bounds
 * (limits.h): the value at the limit is accepted, and the next number beyond it is refused with a
 * message. */
#include "limits.h"
#include "limits_place.h"

#include <thud/thud_textured.h>
#include <thud/thud_threads.h>

#include <string.h>

#include <thud/thud_prediction.h>
#include <thud/thud_recording.h>

typedef struct row row;
typedef thud_result try_fn(place *p, const row *r, double x);

struct row {
    const char *where, *what, *low_text, *high_text, *how;
    double low, high;
    char type; /* of the value: f float, d double, i int */
    size_t at; /* offset of the field */
    try_fn *give;
    bool is_field, has_log;
};

/* Writes the value into the row's field. */
static void put(void *struct_, const row *r, double x) {
    char *field = (char *)struct_ + r->at;
    if (r->type == 'f') {
        memcpy(field, &(float){(float)x}, sizeof(float));
    } else if (r->type == 'd') {
        memcpy(field, &x, sizeof x);
    } else {
        memcpy(field, &(int){(int)x}, sizeof(int));
    }
}

/* ---- how fields are given to the engine ---- */

static thud_result open_and_close(const thud_world_def *def) {
    thud_world *world = NULL;
    thud_result result = thud_world_create(def, &world);
    thud_world_destroy(world);
    return result;
}

static thud_result world(place *p, const row *r, double x) {
    thud_world_def def = def_of(p);
    def.clock = no_time;
    put(&def, r, x);
    return open_and_close(&def);
}

static thud_result jobs(place *p, const row *r, double x) {
    thud_world_def def = def_of(p);
    def.job_system.run = each;
    put(&def.job_system, r, x);
    return open_and_close(&def);
}

static thud_result quality(place *p, const row *r, double x) {
    thud_quality one = thud_quality_default;
    put(&one, r, x);
    thud_world_def def = def_of(p);
    def.quality = &one;
    return open_and_close(&def);
}

static thud_result body(place *p, const row *r, double x) {
    thud_body_def def = thud_default_body_def();
    put(&def, r, x);
    return thud_body_create(p->world, &def, NULL);
}

static thud_result mass(place *p, const row *r, double x) {
    thud_mass one = {1, 1, {0, 0}};
    put(&one, r, x);
    return thud_body_set_mass(p->world, p->ball, &one);
}

static thud_result circle_of(place *p, thud_body_id of, float offset, float radius) {
    return thud_shape_create_circle(p->world, of, &p->shape, (thud_vec2){0, offset}, radius, NULL);
}

static thud_result shape(place *p, const row *r, double x) {
    put(&p->shape, r, x);
    return circle_of(p, p->slab, 0, 1);
}

static thud_result settings(place *p, const row *r, double x) {
    thud_contact_settings wanted = {0, 0, 0};
    put(&wanted, r, x);
    p->settings = &wanted;
    p->heard = THUD_OK;
    OK(thud_world_step(p->world));
    p->settings = NULL;
    return p->heard;
}

static thud_result water(place *p, const row *r, double x) {
    thud_water one = thud_default_water();
    put(&one, r, x);
    return thud_body_apply_buoyancy(p->world, p->ball, &one);
}

static thud_result explosion(place *p, const row *r, double x) {
    thud_explosion one = thud_default_explosion();
    one.center = (thud_pos){0, 1e3 * p->scale};
    (r->at == offsetof(thud_explosion, radius) ? &one.falloff : &one.radius)[0] = p->scale;
    put(&one, r, x);
    return thud_world_explode(p->world, &one, NULL);
}

static thud_joint_def joint_def(const place *p, thud_joint_kind kind) {
    thud_joint_def def = thud_default_joint_def(kind);
    def.body_a = p->slab;
    def.body_b = p->ball;
    return def;
}

static thud_result drive(place *p, const row *r, double x, thud_joint_kind kind,
                         thud_direction direction, float most) {
    thud_joint_def def = joint_def(p, kind);
    thud_drive *one = &def.drive[direction];
    one->limited = true;
    one->lower = -most;
    one->upper = most;
    put(one, r, x);
    return thud_joint_create(p->world, &def, NULL);
}

static thud_result drive_along(place *p, const row *r, double x) {
    return drive(p, r, x, THUD_JOINT_SLIDER, THUD_DIRECTION_ALONG,
                 THUD_JOINT_LENGTH_MAX * (float)p->scale);
}

static thud_result drive_turn(place *p, const row *r, double x) {
    return drive(p, r, x, THUD_JOINT_HINGE, THUD_DIRECTION_TURN, THUD_JOINT_ANGLE_MAX);
}

static thud_result frame(place *p, const row *r, double x) {
    thud_joint_def def = joint_def(p, THUD_JOINT_HINGE);
    put(&def.frame_b, r, x);
    return thud_joint_create(p->world, &def, NULL);
}

static thud_result rod(place *p, const row *r, double x) {
    thud_joint_def def = joint_def(p, THUD_JOINT_DISTANCE);
    put(&def, r, x);
    return thud_joint_create(p->world, &def, NULL);
}

static thud_result gear(place *p, const row *r, double x) {
    thud_joint_def hinge = joint_def(p, THUD_JOINT_HINGE),
                   def = thud_default_joint_def(THUD_JOINT_GEAR);
    OK(thud_joint_create(p->world, &hinge, &def.gear[0]));
    hinge.body_b = p->stone;
    OK(thud_joint_create(p->world, &hinge, &def.gear[1]));
    put(&def, r, x);
    return thud_joint_create(p->world, &def, NULL);
}

static thud_result recorder(place *p, const row *r, double x) {
    thud_recorder_options one = {0};
    thud_recorder *made = NULL;
    put(&one, r, x);
    thud_result result = thud_recorder_begin(p->world, &one, &made);
    thud_recorder_end(made);
    return result;
}

/* A rollback step without an effect. */
static thud_result stand_still(thud_world *world, const uint64_t *inputs, void *state) {
    (void)world, (void)inputs, (void)state;
    return THUD_OK;
}

static thud_result rollback(place *p, const row *r, double x) {
    thud_rollback_options one = {.step = stand_still, .depth = 1};
    thud_rollback *made = NULL;
    put(&one, r, x);
    thud_result result = thud_rollback_create(p->world, &one, &made);
    thud_rollback_destroy(made);
    return result;
}

static const thud_vec2 grip_axis = {1, 0};

static thud_result threads(int workers) {
    thud_threads *made = NULL;
    thud_result result = thud_threads_create(workers, NULL, &made);
    thud_threads_destroy(made);
    return result;
}

static thud_result mover(place *p, const row *r, double x) {
    put(&p->mover, r, x);
    return thud_mover_move(p->world, &p->mover, (thud_vec2){0, 0}, 1.0 / 60, NULL);
}

static thud_result instance(place *p, const row *r, double x) {
    put(&p->box, r, x);
    return thud_geometry_check(&p->box);
}

static thud_result motion(place *p, const row *r, double x) {
    thud_motion one = {0};
    put(&one, r, x);
    return thud_geometry_time_of_impact(&p->box, one, &p->box, p->rest, 0, &p->hit, &p->x);
}

static thud_result below(place *p, double x, double ny) {
    return thud_geometry_area_below(&p->box, (thud_half_plane){x, 0, 0, ny}, &p->x, &p->y, &p->z);
}

static thud_result sum(place *p, const row *r, double x) {
    put(&p->sum, r, x);
    return thud_minkowski_contains(&p->sum, 0, 0, &p->hit);
}

static const thud_pos level[] = {{0, 0}, {1, 0}};

static thud_result plane(place *p, const row *r, double x) {
    (void)p;
    thud_terrain line = {.kind = THUD_TERRAIN_FLAT};
    put(&line, r, x);
    return thud_terrain_check(&line);
}

static thud_result grid(place *p, const row *r, double x) {
    (void)p;
    thud_terrain line = {THUD_TERRAIN_UNIFORM, 0, 0, 1, level, 2};
    put(&line, r, x);
    return thud_terrain_check(&line);
}

/* Only the vertices at x = 0 are read, so that points need not have as many elements as the count
 * says. */
static thud_result vertices(place *p, const row *r, double x) {
    (void)p;
    thud_terrain line = {THUD_TERRAIN_UNIFORM, 0, 0, 1, level, 2};
    thud_terrain_sample sample;
    put(&line, r, x);
    return thud_terrain_sample_at(&line, 0.5, &sample);
}

static thud_result vertex_at(double y) {
    thud_pos points[] = {{0, y}, {1, 0}};
    thud_terrain line = {THUD_TERRAIN_IRREGULAR, 0, 0, 0, points, 2};
    return thud_terrain_check(&line);
}

static const float even[] = {0.5f};

/* The friction of a texture whose first vertex has the value `x`: a friction, or with a table a
 * texture coordinate. */
static thud_result textured(double x, const float *table) {
    const double values[] = {x, 0.5};
    const thud_terrain_sample sample = {.weight = {0.5, 0.5}};
    float friction;
    return thud_texture_friction_at(&(thud_texture){.vertices = values,
                                                    .count = 2,
                                                    .table = table,
                                                    .table_count = table != NULL},
                                    &sample, &friction);
}

static thud_result capsule(place *p, const row *r, double x) {
    thud_capsule one = {0, 0, 1, 1, 1};
    (void)p;
    put(&one, r, x);
    return thud_capsule_check(&one);
}

static thud_result polygon_at(double x) {
    const thud_pos points[] = {{x, 0}, {0, THUD_POLYGON_PLACE_MAX}, {0, -THUD_POLYGON_PLACE_MAX}};
    return thud_polygon_check(points, 3, NULL);
}

static thud_result approximation(place *p, const row *r, double x) {
    const thud_pos points[] = {{0, 0}, {1, 0}, {0, 1}};
    static thud_geometry shapes[THUD_APPROXIMATE_SHAPES_MAX];
    thud_approximate_options options = {.shapes_max = 1};
    thud_approximation found;
    (void)p;
    put(&options, r, x);
    return thud_approximate(points, 3, &options, shapes, &found);
}

/* ---- the table ---- */

#define OPEN(x) (x)
#define LENGTHS(x) (x)
#define NOTHING(...)
#define FUNCTION(function, argument, low, high, call)                                  \
    static thud_result try_##function##_##argument(place *p, const row *r, double x) { \
        (void)p, (void)r;                                                              \
        return call;                                                                   \
    }
#define TYPE_OF(struct, member) _Generic(((struct *)0)->member, float: 'f', double: 'd', int: 'i')
#define FIELD_ROW(struct, field, member, low, high, how) \
    {#struct,                                            \
     #field,                                             \
     #low,                                               \
     #high,                                              \
     #how,                                               \
     (double)(low),                                      \
     (double)(high),                                     \
     TYPE_OF(struct, member),                            \
     offsetof(struct, member),                           \
     how,                                                \
     true,                                               \
     HAS_LOG},
#define CALL_ROW(function, argument, low, high, call)                         \
    {#function,     #argument,      #low, #high, #call,                       \
     (double)(low), (double)(high), 'd',  0,     try_##function##_##argument, \
     false,         HAS_LOG},
#define ALL_LIMITS(FIELD, CALL) \
    WORLD_LIMITS(FIELD, CALL)   \
    BODY_LIMITS(FIELD, CALL)    \
    SHAPE_LIMITS(FIELD, CALL)   \
    PUSH_LIMITS(FIELD, CALL)    \
    JOINT_LIMITS(FIELD, CALL)   \
    QUERY_LIMITS(FIELD, CALL)

ALL_LIMITS(NOTHING, FUNCTION)
GEOMETRY_LIMITS(NOTHING, FUNCTION)

static const row rows[] = {
#define HAS_LOG true
    ALL_LIMITS(FIELD_ROW, CALL_ROW)
#undef HAS_LOG
#define HAS_LOG false /* geometry without a world */
        GEOMETRY_LIMITS(FIELD_ROW, CALL_ROW)};
enum { ROWS = sizeof rows / sizeof *rows };

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

/* The next number of the value's type in a direction. */
static double next(const row *r, double x, double towards) {
    if (r->type == 'i' || strstr(r->how, "(int)x")) {
        return x + (towards > x ? 1 : -1);
    }
    bool single = r->type == 'f' || strstr(r->how, "(float)x");
    return single ? (double)nextafterf((float)x, (float)towards) : nextafter(x, towards);
}

/* Whether the message contains "NAME is X, not in [LOW, HIGH]"; for a field the name must be that
 * of the field. */
static bool tells(const row *r, const char *message, double x) {
    const char *is = strstr(message, " is ");
    const char *named = strstr(message, r->what);
    if (!is || !strstr(is, ", not in ") || (r->is_field && (!named || named > is))) {
        return false;
    }
    double told = strtod(is + 4, NULL);
    /* A mover reports the length of its path. */
    x = strcmp(r->where, "thud_mover_move") == 0 ? fabs(x) : x;
    return x != x ? told != told : told == x || fabs(told - x) <= 1e-6 * fabs(x);
}

/* Gives the value to the engine and checks result and message. */
static void try_it(const row *r, double scale, double x, thud_result wanted) {
    place p;
    place_make(&p, scale);
    p.message[0] = 0;
    thud_result result = r->give(&p, r, x);
    thud_world_destroy(p.world);
    if (result != wanted) {
        fail_msg("%s, %s: %.17g gives \"%s\" at length scale %g", r->where, r->what, x,
                 thud_result_text(result), scale);
    }
    if (wanted != THUD_OK && p.message[0] && !tells(r, p.message, x)) {
        fail_msg("%s, %s: %.17g is refused with \"%s\"", r->where, r->what, x, p.message);
    }
    if (wanted != THUD_OK && !p.message[0] && r->has_log) {
        fail_msg("%s, %s: %.17g is refused without a word", r->where, r->what, x);
    }
}

static void values_are_taken_at_each_limit_and_refused_beyond(void **state) {
    (void)state;
    for (int i = 0; i < 2 * ROWS; i++) {
        const row *r = &rows[i / 2];
        double scale = i % 2 ? 8 : 1;
        double low = r->low * (begins(r->low_text, "LENGTHS") ? scale : 1);
        double high = r->high * (begins(r->high_text, "LENGTHS") ? scale : 1);
        bool open = begins(r->low_text, "OPEN");
        try_it(r, scale, open ? low : next(r, low, -INFINITY), THUD_ERROR_INVALID);
        try_it(r, scale, open ? next(r, low, INFINITY) : low, THUD_OK);
        try_it(r, scale, high, THUD_OK);
        try_it(r, scale, next(r, high, INFINITY), THUD_ERROR_INVALID);
        if (r->type != 'i') {
            try_it(r, scale, NAN, THUD_ERROR_INVALID);
            try_it(r, scale, INFINITY, THUD_ERROR_INVALID);
        }
    }
    print_message("%d limits\n", (int)ROWS);
}

static void directions_are_of_length_1_within_their_limit(void **state) {
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        place p;
        place_make(&p, 1);
        double near = sign * 0.49 * THUD_UNIT_ERROR, far = sign * 0.51 * THUD_UNIT_ERROR;
        thud_geometry box = {THUD_SHAPE_OBB, 0, 0, 0, 1 + near, 1, 1};
        assert_int_equal(thud_geometry_check(&box), THUD_OK);
        assert_int_equal(thud_volume_check(&box), THUD_OK);
        box.s = 1 + far;
        assert_int_equal(thud_geometry_check(&box), THUD_ERROR_INVALID);
        assert_int_equal(thud_volume_check(&box), THUD_ERROR_INVALID);
        p.mover.up = (thud_vec2){0, (float)(1 + sign * 0.4 * THUD_UNIT_ERROR)};
        OK(thud_mover_move(p.world, &p.mover, (thud_vec2){0, 0}, 0.1, NULL));
        p.mover.up.y = (float)(1 + sign * 0.6 * THUD_UNIT_ERROR);
        assert_int_equal(thud_mover_move(p.world, &p.mover, (thud_vec2){0, 0}, 0.1, NULL),
                         THUD_ERROR_INVALID);
        assert_int_equal(below(&p, 0, 1 + sign * 0.99 * THUD_NORMAL_ERROR), THUD_OK);
        assert_int_equal(below(&p, 0, 1 + sign * 1.01 * THUD_NORMAL_ERROR), THUD_ERROR_INVALID);
        thud_world_destroy(p.world);
    }
}

static void polygons_have_points_and_area_within_their_limits(void **state) {
    (void)state;
    static thud_pos points[THUD_POLYGON_POINTS_MAX + 1];
    const int most = THUD_POLYGON_POINTS_MAX;
    for (int i = 0; i <= most; i++) {
        points[i] = (thud_pos){i, 0.125 * i * i};
    }
    assert_int_equal(thud_polygon_check(points, most, NULL), THUD_OK);
    assert_int_equal(thud_polygon_check(points, most + 1, NULL), THUD_ERROR_INVALID);
    assert_int_equal(thud_polygon_check(points, 3, NULL), THUD_OK);
    assert_int_equal(thud_polygon_check(points, 2, NULL), THUD_ERROR_INVALID);
    for (int sign = -1; sign <= 1; sign += 2) {
        const double height = THUD_POLYGON_AREA_MIN * (1 + sign * 1e-9);
        const thud_pos box[] = {{0, 0}, {1, 0}, {1, height}, {0, height}};
        assert_int_equal(thud_polygon_check(box, 4, NULL), sign < 0 ? THUD_ERROR_INVALID : THUD_OK);
    }
}

static void steps_hold_what_turns_to_the_limit(void **state) {
    (void)state;
    place p;
    place_make(&p, 1);
    thud_body_state s;
    OK(thud_body_set_velocity(p.world, p.lift, (thud_vec2){0, 0}, 2 * THUD_ANGULAR_SPEED_MAX));
    OK(thud_world_step(p.world));
    OK(thud_body_get_state(p.world, p.lift, &s));
    assert_true(s.angular_velocity == THUD_ANGULAR_SPEED_MAX);
    thud_world_destroy(p.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_taken_at_each_limit_and_refused_beyond),
        cmocka_unit_test(polygons_have_points_and_area_within_their_limits),
        cmocka_unit_test(steps_hold_what_turns_to_the_limit),
        cmocka_unit_test(directions_are_of_length_1_within_their_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
