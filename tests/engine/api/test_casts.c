/* test_casts.c: casts with a callback for each hit, many casts at once, and queries of a single
 * shape, in scenes whose answers are known by hand. */
#include "engine_support.h"

#include <thud/thud_casts.h>

/* Six balls of radius 0.4 on the x axis, at 1 to 6, created from the farthest on. */
typedef struct row {
    thud_world *world;
    thud_body_id body[7];
    thud_shape_id shape[7];
    int told; /* errors in the log */
} row;

/* The log: counts errors. */
static void listen(thud_result result, const char *message, void *context) {
    (void)message;
    ((row *)context)->told += result == THUD_ERROR_INVALID;
}

/* Creates the row, with a log that counts errors in it. */
static void make_row(row *r, thud_job_system jobs) {
    thud_world_def def = weightless();
    def.job_system = jobs;
    def.log = listen;
    def.log_context = r;
    memset(r, 0, sizeof *r);
    r->world = make_world(def);
    for (int i = 6; i >= 1; i--) {
        r->body[i] = add_body(r->world, THUD_BODY_DYNAMIC, i, 0, 0);
        r->shape[i] = add_shape(r->world, r->body[i], 0.4f, 0, false, NULL);
    }
}

/* A cast's callback: the answers that it gives, and the balls that it met, by number. */
typedef struct story {
    row *row;
    int count;
    double answers[7], met[7];
    void (*act)(row *r, int count);
} story;

/* The cast's callback: notes the ball that was hit, and gives the next answer. */
static double listener(const thud_ray_hit *hit, void *context) {
    story *s = context;
    double answer = s->answers[s->count];
    s->met[s->count++] = round(hit->point.x + 0.4);
    if (s->act) {
        s->act(s->row, s->count);
    }
    return answer;
}

/* Casts a ray along the row; returns how many hits the callback was given, in order. */
static int told(row *r, story *s) {
    s->row = r;
    s->count = 0;
    OK(thud_world_cast_ray_each(r->world, &(thud_ray){(thud_pos){0, 0}, 10, 0, NULL}, listener, s));
    for (int i = 1; i < s->count; i++) {
        assert_true(s->met[i] > s->met[i - 1]);
    }
    return s->count;
}

/* What the callback's answer does: continue, ignore the hit, shorten the ray to a fraction, or end
 * the cast. NaN is logged and counts as continue. */
static void a_callback_goes_on_ignores_clips_and_ends(void **state) {
    (void)state;
    row r;
    make_row(&r, (thud_job_system){0});
    const double on = THUD_CAST_ON, skip = THUD_CAST_IGNORE, end = THUD_CAST_END;
    assert_int_equal(told(&r, &(story){.answers = {on, skip, on, 5, skip, on}}), 6);
    assert_int_equal(told(&r, &(story){.answers = {skip, skip, end, on}}), 3);
    /* the ray ends at the first hit */
    assert_int_equal(told(&r, &(story){.answers = {0.06, on, on}}), 1);
    /* the ray ends shortly behind the second ball */
    assert_int_equal(told(&r, &(story){.answers = {0.161, on, on}}), 2);
    assert_int_equal(told(&r, &(story){.answers = {0.5, 0.3, 0.9, on}}), 3);
    assert_int_equal(r.told, 0);
    assert_int_equal(told(&r, &(story){.answers = {NAN, on, end}}), 3);
    assert_int_equal(r.told, 1);
    thud_world_destroy(r.world);
}

/* What the callback does after its second hit: it destroys ball 4, moves ball 5 away and creates a
 * new one. The edits are deferred, so a cast inside the callback still meets ball 1 first. */
static void destroy_next(row *r, int count) {
    thud_ray_hit hit;
    bool any = false;
    if (count == 2) {
        OK(thud_body_destroy(r->world, r->body[4]));
        OK(thud_body_set_transform(r->world, r->body[5], (thud_pos){5, 9}, 0));
        add_ball(r->world, 3.7, 0, 0.4f);
        assert_int_equal(thud_world_step(r->world), THUD_ERROR_LOCKED);
    }
    OK(thud_world_cast_ray(r->world, &(thud_ray){(thud_pos){0, 0}, 10, 0, NULL}, &any, &hit));
    assert_true(any && hit.shape.index1 == r->shape[1].index1);
}

/* The callback destroys and moves balls ahead of the ray: the destroyed one is not reported any
 * more, the moved one still is in this cast, as the edit is deferred. */
static void edits_of_a_callback_wait_and_what_it_destroys_is_told_no_more(void **state) {
    (void)state;
    row r;
    make_row(&r, (thud_job_system){0});
    story s = {.answers = {1, 1, 1, 1, 1, 1}, .act = destroy_next};
    assert_int_equal(told(&r, &s), 5);
    assert_true(s.met[2] == 3 && s.met[3] == 5 && s.met[4] == 6);
    s.act = NULL;
    /* edits are applied by now: ball 5 has moved away, and a new ball is between 3 and 6 */
    assert_int_equal(told(&r, &s), 5);
    assert_true(s.met[4] == 6);
    thud_world_destroy(r.world);
}

/* ---- many casts at once ---- */

/* A job system with a single thread, which counts its calls. */
static void one_after_the_other(thud_task_fn *task, void *argument, int workers, void *context) {
    *(int *)context += 1;
    for (int i = 0; i < workers; i++) {
        task(argument);
    }
}

/* Many rays, and their hits when they are cast outside of a callback. */
static thud_ray rays[80];
static thud_ray_hit outside[80];

/* A cast's callback that casts many rays itself; their hits must equal those outside of a
 * callback. */
static double ask_many(const thud_ray_hit *hit, void *context) {
    thud_ray_hit inside[80];
    (void)hit;
    OK(thud_world_cast_rays(context, rays, 80, inside));
    for (int i = 0; i < 80; i++) {
        assert_int_equal(inside[i].shape.index1, outside[i].shape.index1);
        assert_true(inside[i].fraction == outside[i].fraction);
    }
    return THUD_CAST_END;
}

/* The job system is called once for 80 rays, not at all for 63, and not inside a callback, where
 * the rays are cast in the calling thread. */
static void the_job_system_is_asked_once_for_many_and_never_inside_a_callback(void **state) {
    (void)state;
    row r;
    int calls = 0;
    make_row(&r, (thud_job_system){.run = one_after_the_other, .context = &calls, .workers = 3});
    for (int i = 0; i < 80; i++) {
        rays[i] = (thud_ray){{0.1 * i, 3}, 0, -6, NULL};
    }
    OK(thud_world_cast_rays(r.world, rays, 63, outside));
    assert_int_equal(calls, 0);
    OK(thud_world_cast_rays(r.world, rays, 80, outside));
    assert_int_equal(calls, 1);
    assert_true(outside[10].shape.index1 == r.shape[1].index1);
    assert_int_equal(outside[0].shape.index1, 0);
    assert_true(outside[0].fraction == 1 && outside[0].point.x == 0 && outside[0].point.y == -3);
    OK(thud_world_cast_ray_each(r.world, &(thud_ray){(thud_pos){0, 0}, 10, 0, NULL}, ask_many,
                                r.world));
    assert_int_equal(calls, 1);
    OK(thud_world_cast_rays(r.world, NULL, 0, NULL));
    thud_world_destroy(r.world);
}

/* ---- long rays and crowds ---- */

/* A ray of 2.5e9 length scales, and one through 17,000 shapes: the single hit, the callback and the
 * list agree. */
static void long_ways_and_crowds_are_told_as_in_a_list(void **state) {
    (void)state;
    enum { CROWD = 17000, TOLD = 40 };
    thud_world *world = make_world(weightless());
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_def def = thud_default_shape_def();
    uint64_t seed = 3;
    for (int i = 0; i < CROWD; i++) {
        thud_vec2 at = {(float)random_in(&seed, -3, 3), (float)random_in(&seed, -3, 3)};
        OK(thud_shape_create_circle(world, ground, &def, at, 0.01f, NULL));
    }
    thud_terrain line = {.kind = THUD_TERRAIN_FLAT};
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0.5, 0), &def, &line,
                                 NULL));
    const thud_ray ways[] = {{{-4, 1}, 8, -1, NULL}, {{-9e8, 9e8}, 1.8e9, -1.8e9, NULL}};
    for (int k = 0; k < 2; k++) {
        thud_ray_hit all[TOLD], first;
        int count = 0;
        OK(thud_world_cast_ray_all(world, &(thud_ray){ways[k].origin, ways[k].dx, ways[k].dy, NULL},
                                   all, TOLD, &count));
        assert_true(count > 1);
        OK(thud_world_cast_rays(world, &ways[k], 1, &first));
        assert_true(first.fraction == all[0].fraction);
        assert_int_equal(first.shape.index1, all[0].shape.index1);
        story s = {.answers = {1, 1, 1, 1, 1, 1, THUD_CAST_END}};
        OK(thud_world_cast_ray_each(world,
                                    &(thud_ray){ways[k].origin, ways[k].dx, ways[k].dy, NULL},
                                    listener, &s));
        for (int i = 0; i < s.count; i++) {
            assert_true(s.met[i] == round(all[i].point.x + 0.4));
        }
        assert_int_equal(s.count, count < 7 ? count : 7);
    }
    thud_world_destroy(world);
}

/* ---- queries of a single shape ---- */

static void check_bounds(thud_world *world, thud_shape_id shape, thud_pos low, thud_pos high) {
    thud_pos lower, upper;
    OK(thud_shape_get_bounds(world, shape, &lower, &upper));
    near_to(lower.x, low.x, 1e-6);
    near_to(lower.y, low.y, 1e-6);
    near_to(upper.x, high.x, 1e-6);
    near_to(upper.y, high.y, 1e-6);
}

static bool contains(thud_world *world, thud_shape_id shape, double x, double y) {
    bool inside = false;
    OK(thud_shape_contains_point(world, shape, (thud_pos){x, y}, &inside));
    return inside;
}

/* Bounds, point containment, ray and closest point of a single shape, near the origin and at 1e7,
 * also of a sensor and of a disabled body. */
static void one_shape_has_bounds_points_and_a_surface_wherever_it_stands(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        double x = k ? 1e7 : 0;
        thud_world *world = make_world(weightless());
        thud_shape_def sensor = thud_default_shape_def();
        sensor.sensor = true;
        sensor.filter.mask = 0; /* the query does not use its filter */
        thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, x, 2, 0);
        thud_shape_id box = add_shape(world, body, 2, 1, false, &sensor);
        OK(thud_body_set_transform(world, body, (thud_pos){x, 2}, acos(0.6)));
        check_bounds(world, box, (thud_pos){x - 2, -0.2}, (thud_pos){x + 2, 4.2});
        assert_true(contains(world, box, x + 1.1, 3.5) && !contains(world, box, x + 1.5, 1.5));
        OK(thud_body_set_enabled(world, body, false));
        bool hit = false;
        thud_ray_hit ray;
        OK(thud_shape_cast_ray(world, box, (thud_pos){x, 9}, 0, -14, &hit, &ray));
        assert_true(hit && ray.shape.index1 == box.index1);
        near_to(ray.fraction, (9 - 2 - 1 / 0.6) / 14, 1e-7);
        OK(thud_shape_cast_ray(world, box, (thud_pos){x, 9}, 0, 3, &hit, &ray));
        assert_false(hit);
        thud_shape_id ball =
            add_shape(world, add_body(world, THUD_BODY_STATIC, x + 8, 2, 0), 1.5f, 0, false, NULL);
        thud_closest_hit closest;
        OK(thud_shape_closest_point(world, ball, (thud_pos){x + 4, 5}, &closest));
        near_to(closest.distance, 3.5, 1e-8);
        near_to(closest.point.x - x, 8 - 1.2, 1e-8);
        near_to((double)closest.normal.y, 0.6, 1e-6);
        check_bounds(world, ball, (thud_pos){x + 6.5, 0.5}, (thud_pos){x + 9.5, 3.5});
        thud_world_destroy(world);
    }
}

/* Bounds of a terrain are those of its line; its ground is solid below the line and ends with it. A
 * flat terrain has no bounds. */
static void a_terrain_has_the_bounds_of_its_line_and_is_solid_below(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    const thud_pos points[] = {{0, 1}, {2, 3}, {5, -1}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 3};
    thud_shape_def def = thud_default_shape_def();
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 10, 20, 0);
    thud_shape_id hill, plain;
    OK(thud_shape_create_terrain(world, body, &def, &line, &hill));
    check_bounds(world, hill, (thud_pos){10, 19}, (thud_pos){15, 23});
    line.kind = THUD_TERRAIN_UNIFORM;
    line.x0 = -4;
    line.spacing = 3;
    OK(thud_shape_create_terrain(world, body, &def, &line, &plain));
    check_bounds(world, plain, (thud_pos){6, 19}, (thud_pos){12, 23});
    assert_true(contains(world, hill, 12, 22.9) && !contains(world, hill, 12, 23.1));
    assert_true(contains(world, hill, 12, -50) && !contains(world, hill, 9.9, 0));
    line = (thud_terrain){.kind = THUD_TERRAIN_FLAT};
    OK(thud_shape_create_terrain(world, body, &def, &line, &plain));
    thud_pos lower = {7, 7}, upper = {7, 7};
    assert_int_equal(thud_shape_get_bounds(world, plain, &lower, &upper), THUD_ERROR_INVALID);
    assert_true(lower.x == 7 && upper.y == 7);
    thud_world_destroy(world);
}

/* A cast's callback that creates a shape; it has no bounds before the edit is applied. */
static double make_and_ask(const thud_ray_hit *hit, void *context) {
    thud_pos lower, upper;
    row *r = context;
    (void)hit;
    thud_body_id body = add_body(r->world, THUD_BODY_STATIC, 1, 5, 0);
    thud_shape_id made = add_shape(r->world, body, 1, 0, false, NULL);
    assert_int_equal(thud_shape_get_bounds(r->world, made, &lower, &upper), THUD_ERROR_LOCKED);
    OK(thud_shape_get_bounds(r->world, r->shape[2], &lower, &upper));
    return THUD_CAST_END;
}

static void shapes_made_inside_a_callback_have_no_place_yet(void **state) {
    (void)state;
    row r;
    make_row(&r, (thud_job_system){0});
    OK(thud_world_cast_ray_each(r.world, &(thud_ray){(thud_pos){0, 0}, 10, 0, NULL}, make_and_ask,
                                &r));
    thud_world_destroy(r.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_callback_goes_on_ignores_clips_and_ends),
        cmocka_unit_test(edits_of_a_callback_wait_and_what_it_destroys_is_told_no_more),
        cmocka_unit_test(the_job_system_is_asked_once_for_many_and_never_inside_a_callback),
        cmocka_unit_test(long_ways_and_crowds_are_told_as_in_a_list),
        cmocka_unit_test(one_shape_has_bounds_points_and_a_surface_wherever_it_stands),
        cmocka_unit_test(a_terrain_has_the_bounds_of_its_line_and_is_solid_below),
        cmocka_unit_test(shapes_made_inside_a_callback_have_no_place_yet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
