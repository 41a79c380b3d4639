/* test_buoyancy.c: thud_body_apply_buoyancy (thud_fields.h) and thud_geometry_area_below, the area
 * and centroid of the part of a shape below a line. */
#include "engine_support.h"

#include <thud/thud_fields.h>

/* thud_geometry_area_below with the arguments of a water def. */
static thud_result below(const thud_geometry *shape, thud_pos point, thud_vec2 normal, double *area,
                         thud_pos *centroid) {
    return thud_geometry_area_below(shape,
                                    (thud_half_plane){point.x, point.y, (double)normal.x,
                                                      (double)normal.y},
                                    area, &centroid->x, &centroid->y);
}

static const double pi = 3.14159265358979323846;

/* ---- area and centroid ---- */

/* Reference: sums over slices parallel to the line, each as wide as the shape is there. */
static void sum_slices(const thud_geometry *shape, double height, double nx, double ny,
                       double *area, thud_pos *centroid) {
    enum { SLICES = 20000 };
    double reach = shape->hx + shape->hy, sum[3] = {0};
    double top = fmin(reach, -height), thick = (top + reach) / SLICES;
    for (int i = 0; i < SLICES && thick > 0; i++) {
        double h = -reach + (i + 0.5) * thick, from = -2 * reach, to = 2 * reach;
        if (shape->kind == THUD_SHAPE_CIRCLE) {
            double half = shape->hx * shape->hx - h * h;
            to = half > 0 ? sqrt(half) : -1;
            from = -to;
        } else {
            for (int axis = 0; axis < 2; axis++) {
                /* On the slice, |h n + t across| along each axis of the box is at most its half
                 * extent. */
                double ax = axis ? -shape->s : shape->c, ay = axis ? shape->c : shape->s;
                double along = h * (nx * ax + ny * ay), per = -ny * ax + nx * ay;
                double half = axis ? shape->hy : shape->hx;
                double a = (-half - along) / per, b = (half - along) / per;
                from = fmax(from, fmin(a, b));
                to = fmin(to, fmax(a, b));
            }
        }
        if (to > from) {
            double t = 0.5 * (from + to), piece = thick * (to - from);
            sum[0] += piece;
            sum[1] += piece * (h * nx - t * ny);
            sum[2] += piece * (h * ny + t * nx);
        }
    }
    *area = sum[0];
    *centroid = (thud_pos){shape->x + (sum[0] > 0 ? sum[1] / sum[0] : 0),
                           shape->y + (sum[0] > 0 ? sum[2] / sum[0] : 0)};
}

/* Area and centroid of the part below a line, of random shapes and lines, agree with the sums over
 * slices. */
static void parts_are_as_slices_sum_them(void **state) {
    (void)state;
    uint64_t seed = 7;
    for (int i = 0; i < 600; i++) {
        thud_geometry shape = {.kind = (thud_shape_kind)(i % 3), .c = 1};
        double angle = random_in(&seed, 0, 2 * pi), up = random_in(&seed, 0, 2 * pi);
        shape.x = random_in(&seed, -5, 5);
        shape.y = random_in(&seed, -5, 5);
        shape.hx = random_in(&seed, 0.2, 2);
        shape.hy = shape.kind == THUD_SHAPE_CIRCLE ? 0 : random_in(&seed, 0.2, 2);
        if (shape.kind == THUD_SHAPE_OBB) {
            shape.c = cos(angle);
            shape.s = sin(angle);
        }
        thud_vec2 normal = {(float)cos(up), (float)sin(up)};
        double length = hypot((double)normal.x, (double)normal.y);
        double nx = (double)normal.x / length, ny = (double)normal.y / length;
        double height = random_in(&seed, -1.2, 1.2) * (shape.hx + shape.hy), area, wanted;
        thud_pos point = {shape.x - height * nx, shape.y - height * ny}, centroid, middle;
        OK(below(&shape, point, normal, &area, &centroid));
        sum_slices(&shape, height, nx, ny, &wanted, &middle);
        near_to(area, wanted, 2e-4);
        if (wanted > 1e-3) {
            near_to(centroid.x, middle.x, 1e-3);
            near_to(centroid.y, middle.y, 1e-3);
        }
    }
}

static void parts_of_circles_are_exact(void **state) {
    (void)state;
    for (int i = -1000; i <= 1000; i++) {
        double h = i / 1000.0, area;
        thud_geometry circle = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 1};
        thud_pos centroid;
        OK(below(&circle, (thud_pos){3, -h}, (thud_vec2){0, 1}, &area, &centroid));
        double half = sqrt((1 - h) * (1 + h));
        near_to(area, atan2(half, h) - h * half, 3e-15);
        assert_true(centroid.y <= 0 && centroid.y >= -1 && (area == 0 || centroid.y <= -h));
        near_to(area * centroid.y, area > 0 ? -2.0 / 3 * half * half * half : 0, 3e-15);
        assert_true(centroid.x == 0);
    }
}

static void wrong_lines_are_refused(void **state) {
    (void)state;
    const thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 1};
    const thud_geometry none = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = -1};
    const thud_vec2 no_direction[] = {{0, 0}, {0, 1.01f}, {0.99f, 0}, {NAN, 1}, {INFINITY, 0}};
    thud_pos here = {0, 0}, centroid = {7, 7};
    double area = 7;
    for (int i = 0; i < 5; i++) {
        assert_int_equal(below(&disc, here, no_direction[i], &area, &centroid), THUD_ERROR_INVALID);
    }
    thud_vec2 up = {0, 1};
    assert_int_equal(below(&none, here, up, &area, &centroid), THUD_ERROR_INVALID);
    assert_int_equal(below(&disc, (thud_pos){0, NAN}, up, &area, &centroid), THUD_ERROR_INVALID);
    assert_int_equal(below(&disc, (thud_pos){4e15, 0}, up, &area, &centroid), THUD_ERROR_INVALID);
    assert_int_equal(below(NULL, here, up, &area, &centroid), THUD_ERROR_NULL);
    assert_int_equal(below(&disc, here, up, NULL, &centroid), THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_area_below(&disc, (thud_half_plane){0, 0, 0, 1}, &area, NULL,
                                              &area),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_area_below(&disc, (thud_half_plane){0, 0, 0, 1}, &area, &area,
                                              NULL),
                     THUD_ERROR_NULL);
    assert_true(area == 7 && centroid.x == 7 && centroid.y == 7);
}

/* ---- floating bodies ---- */

/* Steps the world with buoyancy on the body. */
static void float_for(thud_world *world, thud_body_id body, const thud_water *water, int steps) {
    for (int i = 0; i < steps; i++) {
        OK(thud_body_apply_buoyancy(world, body, water));
        OK(thud_world_step(world));
    }
}

/* A box, or a circle where hy is 0, with this density; y = 0 is the water level. */
static thud_body_id add_floating(thud_world *world, double y, double angle, float hx, float hy,
                                 float density) {
    thud_shape_def def = thud_default_shape_def();
    def.density = density;
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, y, angle);
    add_shape(world, body, hx, hy, false, &def);
    return body;
}

/* Asserts that the body falls asleep. Sleeping is on for this alone, since a body may fall asleep
 * before it is quite at its draught. */
static void falls_asleep(thud_world *world, thud_body_id body, const thud_water *water) {
    OK(thud_world_set_sleeping(world, true));
    float_for(world, body, water, 120);
    assert_false(state_of(world, body).awake);
    OK(thud_world_set_sleeping(world, false));
}

static void boxes_and_circles_float_at_their_draught_and_sleep_there(void **state) {
    (void)state;
    const float density[] = {0.25f, 0.5f, 0.75f};
    for (int i = 0; i < QUALITIES * 3; i++) {
        thud_world_def def = thud_default_world_def_of(qualities[i / 3]);
        def.sleeping = false;
        thud_world *world = make_world(def);
        thud_water water = thud_default_water();
        water.point.y = 7;
        float d = density[i % 3];
        thud_body_id box = add_floating(world, 7.3, 0.5, 1.5f, 0.25f, d);
        float_for(world, box, &water, 3600);
        thud_body_state s = state_of(world, box);
        near_to(s.position.y, 7 + 0.25 - 0.5 * (double)d, 1e-5);
        near_to(s.angle, 0, 1e-4);
        falls_asleep(world, box, &water);
        OK(thud_body_destroy(world, box));
        thud_body_id ball = add_floating(world, 8, 0, 0.5f, 0, d);
        float_for(world, ball, &water, 1200);
        s = state_of(world, ball);
        thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .y = s.position.y, .c = 1, .hx = 0.5};
        double area;
        thud_pos centroid;
        OK(below(&disc, water.point, water.normal, &area, &centroid));
        near_to(area, (double)d * pi * 0.25, 1e-5);
        falls_asleep(world, ball, &water);
        thud_world_destroy(world);
    }
}

/* A tall box falls on its side, a box of lead sinks, and a flow carries bodies with it. */
static void tall_boxes_fall_over_and_the_flow_carries(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_water water = thud_default_water();
    thud_body_id tall = add_floating(world, 0, 0.05, 0.25f, 1.5f, 0.5f);
    water.flow = (thud_vec2){2, 0};
    float_for(world, tall, &water, 1800);
    thud_body_state s = state_of(world, tall);
    near_to(fabs(s.angle), pi / 2, 1e-2);
    near_to((double)s.velocity.x, 2, 1e-3);
    thud_body_id lead = add_floating(world, 5, 0, 0.5f, 0.5f, 3);
    float_for(world, lead, &water, 600);
    assert_true(state_of(world, lead).position.y < -10);
    thud_world_destroy(world);
}

/* Energy of a body of one shape, and of the water that it displaces. */
static double energy_of(thud_world *world, thud_body_id body, const thud_geometry *shape,
                        const thud_water *water) {
    thud_body_state s = state_of(world, body);
    thud_geometry placed = *shape;
    thud_measure m = thud_measure_of(world);
    thud_pos centroid;
    double area;
    placed.x = s.position.x;
    placed.y = s.position.y;
    placed.c = cos(s.angle);
    placed.s = sin(s.angle);
    OK(below(&placed, water->point, water->normal, &area, &centroid));
    return m.kinetic_energy + m.potential_energy - area * 10 * centroid.y;
}

/* Lift is that of the middle of the step, so that a body which bobs without drag keeps its energy;
 * each ten seconds reach the same greatest energy. */
static void what_bobs_keeps_its_energy(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES * 2; i++) {
        thud_world_def def = thud_default_world_def_of(qualities[i / 2]);
        def.sleeping = false;
        thud_world *world = make_world(def);
        thud_water water = thud_default_water();
        water.linear_drag = water.angular_drag = 0;
        float hy = i % 2 ? 0.3f : 0;
        thud_body_id body = add_floating(world, 0.2, 0.2, 1, hy, 0.5f);
        thud_geometry shape = {.kind = i % 2 ? THUD_SHAPE_OBB : THUD_SHAPE_CIRCLE,
                               .hx = 1,
                               .hy = (double)hy};
        double most[6] = {0};
        for (int k = 0; k < 3600; k++) {
            float_for(world, body, &water, 1);
            most[k / 600] = fmax(most[k / 600], energy_of(world, body, &shape, &water));
        }
        for (int k = 1; k < 6; k++) {
            near_to(most[k], most[0], 2e-5 * most[0]);
        }
        thud_world_destroy(world);
    }
}

/* Drag in still water takes kinetic energy and adds none, at any time step and coefficient. */
static void drag_only_brakes(void **state) {
    (void)state;
    uint64_t seed = 3;
    for (int i = 0; i < 300; i++) {
        thud_world_def def = weightless();
        def.time_step = i % 2 ? 1 : 1.0 / 60;
        thud_world *world = make_world(def);
        thud_water water = thud_default_water();
        water.linear_drag = (float)pow(10, random_in(&seed, -2, 6));
        water.angular_drag = (float)pow(10, random_in(&seed, -2, 6));
        thud_body_id body =
            add_floating(world, random_in(&seed, -1, 1), 0.3, 1, i % 3 ? 0.5f : 0, 0.5f);
        thud_vec2 v = {(float)random_in(&seed, -9, 9), (float)random_in(&seed, -9, 9)};
        OK(thud_body_set_velocity(world, body, v, (float)random_in(&seed, -9, 9)));
        double before = thud_measure_of(world).kinetic_energy;
        for (int k = 0; k < 5; k++) {
            float_for(world, body, &water, 1);
            double after = thud_measure_of(world).kinetic_energy;
            assert_true(after <= before * (1 + 1e-5) + 1e-9);
            before = after;
        }
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_as_slices_sum_them),
        cmocka_unit_test(parts_of_circles_are_exact),
        cmocka_unit_test(wrong_lines_are_refused),
        cmocka_unit_test(boxes_and_circles_float_at_their_draught_and_sleep_there),
        cmocka_unit_test(tall_boxes_fall_over_and_the_flow_carries),
        cmocka_unit_test(what_bobs_keeps_its_energy),
        cmocka_unit_test(drag_only_brakes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
