/* test_capsules.c: capsules against shapes, each other and terrain: by figures worked out by hand,
 * against long double, and against points along the capsule. THUD_CASES of the environment sets the
 * number of random cases of each pair. */
#include "geometry_exact.h"
#include "geometry_random.h"
#include "thud/thud_capsule.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { CASES = 20000, GROUNDS = 4000, VERTICES = 9, ALONG = 400, TIMES = 40 };

#define OK(call) assert_int_equal(call, THUD_OK)
#define INVALID(call) assert_int_equal(call, THUD_ERROR_INVALID)

static const thud_motion STILL = {0, 0, 0};

static void near(double value, double expected, double tolerance) {
    if (!(fabs(value - expected) <= tolerance)) {
        fail_msg("%.15g is not %.15g within %g", value, expected, tolerance);
    }
}

static void is(const thud_closest *c, double distance, double nx, double ny, double ax, double ay) {
    near(c->distance, distance, 1e-12);
    near(c->nx, nx, 1e-12);
    near(c->ny, ny, 1e-12);
    near(c->ax, ax, 1e-12);
    near(c->ay, ay, 1e-12);
    near(c->bx, ax + distance * nx, 1e-12);
    near(c->by, ay + distance * ny, 1e-12);
}

/* ---- by hand ---- */

static void distances_are_those_worked_out_by_hand(void **state) {
    (void)state;
    const thud_capsule level = {0, 0, 4, 0, 1}, cross_a = {-2, 0, 2, 0, 0.5},
                       cross_b = {0, -1, 0, 3, 0.25}, dot_at = {1, 1, 1, 1, 0.5};
    const double diagonal = sqrt(2.0);
    thud_geometry ball = thud_circle_at(2, 3, 0.5);
    thud_closest c;
    OK(thud_capsule_closest(&level, &ball, &c));
    is(&c, 1.5, 0, 1, 2, 1);
    ball = thud_circle_at(7, 4, 1); /* beyond the end, 3 and 4 away */
    OK(thud_capsule_closest(&level, &ball, &c));
    is(&c, 3, 0.6, 0.8, 4.6, 0.8);
    ball = thud_circle_at(1, 0.5, 0.25); /* its centre in the capsule */
    OK(thud_capsule_closest(&level, &ball, &c));
    is(&c, -0.75, 0, 1, 1, 1);
    OK(thud_capsule_closest(&dot_at, &ball, &c)); /* a segment without length is a circle */
    is(&c, -0.25, 0, -1, 1, 0.5);
    thud_geometry box = thud_aabb_at(0, 5, 1, 1);
    OK(thud_capsule_closest(&cross_a, &box, &c));
    near(c.distance, 3.5, 1e-12);
    near(c.ny, 1, 1e-12);
    box = thud_obb_at(0, 5, 1, 1, 0.785398163397448);
    OK(thud_capsule_closest(&cross_a, &box, &c));
    is(&c, 4.5 - diagonal, 0, 1, 0, 0.5);
    box = thud_aabb_at(0, 0, 4, 2); /* around the capsule: out through the side that is 2 away */
    OK(thud_capsule_closest(&cross_a, &box, &c));
    near(c.distance, -2.5, 1e-12);
    near(fabs(c.ny), 1, 1e-12);
    OK(thud_capsules_closest(&cross_a, &cross_b, &c)); /* they cross: b leaves upwards by 1 */
    is(&c, -1.75, 0, 1, c.ax, 0.5);
    const thud_capsule beside = {5, -3, 5, 7, 0.5};
    OK(thud_capsules_closest(&level, &beside, &c));
    is(&c, -0.5, 1, 0, 5, 0);
}

static void times_are_those_worked_out_by_hand(void **state) {
    (void)state;
    const thud_capsule level = {0, 0, 4, 0, 1}, upright = {0, 0, 0, 4, 0.5},
                       bar = {8, 1, 10, 1, 0.5};
    const thud_geometry ball = thud_circle_at(2, 8, 1), box = thud_aabb_at(2, 8, 9, 1);
    bool hit;
    double time;
    OK(thud_capsule_time_of_impact(&level, (thud_motion){0, 10, 0}, &ball, STILL, 0, &hit, &time));
    assert_true(hit);
    near(time, 0.6, 1e-12);
    OK(thud_capsule_time_of_impact(&level, STILL, &box, (thud_motion){0, -12, 0}, 3, &hit, &time));
    assert_true(hit);
    near(time, 0.25, 1e-12); /* 6 apart, of which 3 are the target */
    OK(thud_capsules_time_of_impact(&upright, (thud_motion){4, 0, 0}, &bar, (thud_motion){-4, 0, 0},
                                    0, &hit, &time));
    assert_true(hit);
    near(time, 0.875, 1e-12);
    OK(thud_capsules_time_of_impact(&upright, (thud_motion){-4, 0, 0}, &bar, STILL, 0, &hit,
                                    &time));
    assert_false(hit);
    assert_true(time == 1.0);
}

static void ground_is_met_as_worked_out_by_hand(void **state) {
    (void)state;
    const thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    const thud_pos points[] = {{-5, 0}, {0, 3}, {5, 0}};
    const thud_terrain hill = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 3};
    const thud_capsule leaning = {0, 2, 3, 4, 0.5}, over = {-2, 5, 2, 5, 0.5},
                       low = {0, 0.25, 3, 4, 0.5};
    thud_closest c;
    bool hit;
    double time;
    OK(thud_terrain_capsule_closest(&flat, &leaning, &c));
    is(&c, 1.5, 0, 1, 0, 0);
    OK(thud_terrain_capsule_closest(&flat, &low, &c));
    is(&c, -0.25, 0, 1, 0, 0);
    OK(thud_terrain_capsule_closest(&hill, &over, &c));
    is(&c, 1.5, 0, 1, 0, 3);
    OK(thud_terrain_capsule_time_of_impact(&flat, &leaning, (thud_motion){7, -6, 0}, 0, &hit,
                                           &time));
    assert_true(hit);
    near(time, 0.25, 1e-12);
    OK(thud_terrain_capsule_time_of_impact(&hill, &over, (thud_motion){0, -3, 0}, 0.75, &hit,
                                           &time));
    assert_true(hit);
    near(time, 0.25, 1e-12);
    OK(thud_terrain_capsule_time_of_impact(&flat, &low, (thud_motion){0, 9, 0}, 0, &hit, &time));
    assert_true(hit && time == 0.0);
    OK(thud_terrain_capsule_time_of_impact(&flat, &leaning, (thud_motion){0, -1, 0}, 0, &hit,
                                           &time));
    assert_false(hit);
}

/* ---- random pairs ---- */

static thud_capsule draw_capsule(source *r) {
    thud_capsule c = {draw(r, -2, 2), draw(r, -2, 2), draw(r, -2, 2), draw(r, -2, 2),
                      exp(draw(r, -3.0, 0.0))};
    switch (draw_below(r, 6)) {
    case 0: /* no length */
        c.x2 = c.x1;
        c.y2 = c.y1;
        break;
    case 1: /* level */
        c.y2 = c.y1;
        break;
    case 2: /* upright */
        c.x2 = c.x1;
        break;
    default:
        break;
    }
    return c;
}

static solid solid_of_capsule(const thud_capsule *c) {
    solid s = {.v = {{c->x1, c->y1}, {c->x2, c->y2}}, .count = 2, .radius = c->radius};
    s.count = c->x1 == c->x2 && c->y1 == c->y2 ? 1 : 2;
    return s;
}

/* The other side of a pair: a shape, or a capsule. */
typedef struct other {
    bool is_capsule;
    thud_geometry shape;
    thud_capsule capsule;
    solid exact;
} other;

static other draw_other(source *r) {
    other o = {.is_capsule = draw_below(r, 4) == 0};
    o.capsule = draw_capsule(r);
    o.shape = draw_shape_of(r, (thud_shape_kind)draw_below(r, 3));
    o.exact = o.is_capsule ? solid_of_capsule(&o.capsule) : solid_of(&o.shape, 0, 0);
    return o;
}

static void closest_to(const thud_capsule *a, const other *b, thud_closest *c) {
    OK(b->is_capsule ? thud_capsules_closest(a, &b->capsule, c)
                     : thud_capsule_closest(a, &b->shape, c));
}

/* Distance and points of random pairs are those of long double: the points are on the surfaces, and
 * a shift by the distance along the normal makes the shapes touch. */
static void distances_of_random_pairs_are_exact(void **state) {
    (void)state;
    source r = {31};
    for (int i = 0; i < case_count(CASES); i++) {
        thud_capsule a = draw_capsule(&r);
        other b = draw_other(&r);
        solid of_a = solid_of_capsule(&a);
        thud_closest c;
        closest_to(&a, &b, &c);
        near(c.distance, (double)solids_distance(&of_a, &b.exact), 1e-13);
        near(hypot(c.nx, c.ny), 1.0, 1e-13);
        near(c.bx - c.ax, c.distance * c.nx, 1e-13);
        near(c.by - c.ay, c.distance * c.ny, 1e-13);
        if (c.distance > 0.0) {
            near((double)solid_distance(&of_a, vec_of(c.ax, c.ay)), 0.0, 1e-13);
            near((double)solid_distance(&b.exact, vec_of(c.bx, c.by)), 0.0, 1e-13);
        }
        solid moved = b.exact;
        for (int k = 0; k < moved.count; k++) {
            moved.v[k].x -= (real)c.distance * c.nx;
            moved.v[k].y -= (real)c.distance * c.ny;
        }
        near((double)solids_distance(&of_a, &moved), 0.0, 1e-12);
    }
}

static void times_of_random_pairs_are_exact(void **state) {
    (void)state;
    source r = {32};
    int hits = 0;
    for (int i = 0; i < case_count(CASES); i++) {
        thud_capsule a = draw_capsule(&r);
        other b = draw_other(&r);
        thud_motion by_a = {draw(&r, -4, 4), draw(&r, -4, 4), 0},
                    by_b = {draw(&r, -4, 4), draw(&r, -4, 4), 0};
        double target = i % 3 ? 0.0 : draw(&r, 0.0, 0.5), time;
        bool hit;
        OK(b.is_capsule
               ? thud_capsules_time_of_impact(&a, by_a, &b.capsule, by_b, target, &hit, &time)
               : thud_capsule_time_of_impact(&a, by_a, &b.shape, by_b, target, &hit, &time));
        solid of_a = solid_of_capsule(&a);
        sum h = sum_of(&of_a, &b.exact);
        vec way = {(real)by_a.dx - by_b.dx, (real)by_a.dy - by_b.dy};
        real early = enters(&h, h.radius + target + 1e-13L, way);
        real late = enters(&h, h.radius + target - 1e-13L, way);
        real found = hit ? (real)time : NEVER;
        assert_true(found >= early - 1e-14L && found <= late + 1e-14L);
        hits += hit && time > 0.0;
    }
    assert_true(hits > case_count(CASES) / 10);
}

/* A shape at rest is hit by a moving circle exactly where it overlaps the circle's capsule. */
static void a_capsule_is_the_way_of_a_circle(void **state) {
    (void)state;
    source r = {33};
    for (int i = 0; i < case_count(CASES); i++) {
        thud_geometry circle = draw_shape_of(&r, THUD_SHAPE_CIRCLE);
        thud_geometry rest = draw_shape_of(&r, (thud_shape_kind)draw_below(&r, 3));
        thud_motion way = {draw(&r, -4, 4), draw(&r, -4, 4), 0};
        thud_capsule capsule;
        thud_closest c;
        bool hit;
        double time;
        OK(thud_capsule_of_motion(&circle, way, &capsule));
        OK(thud_capsule_closest(&capsule, &rest, &c));
        OK(thud_geometry_time_of_impact(&circle, way, &rest, STILL, 0, &hit, &time));
        assert_true(hit == (c.distance <= 0.0) || fabs(c.distance) < 1e-13);
    }
}

/* ---- random ground ---- */

/* The signed distance of a point from a line of vertices and the ground below it: negative by the
 * height below the line, which only its sign is used of. */
static double from_ground(const thud_terrain *t, double x, double y) {
    double least = 1e300;
    const thud_pos *p = t->points;
    int last = t->count - 1;
    for (int i = 0; i < last; i++) {
        vec a = {p[i].x, p[i].y}, b = {p[i + 1].x, p[i + 1].y};
        if (x >= p[i].x && x <= p[i + 1].x) {
            double line = p[i].y + (x - p[i].x) * (p[i + 1].y - p[i].y) / (p[i + 1].x - p[i].x);
            if (y <= line) {
                return y - line;
            }
        }
        least = fmin(least, (double)segment_distance(a, b, vec_of(x, y)));
    }
    for (int i = 0; i < 2; i++) {
        thud_pos end = p[i ? last : 0];
        double down = fmax(y - end.y, 0.0);
        least = fmin(least, hypot(x - end.x, down));
    }
    return least;
}

/* The least distance of points along the capsule's segment, less the radius; the true one is less
 * by at most *step. */
static double sampled(const thud_terrain *t, const thud_capsule *c, double *step) {
    double least = 1e300;
    for (int i = 0; i <= ALONG; i++) {
        double f = (double)i / ALONG;
        least =
            fmin(least, from_ground(t, c->x1 + f * (c->x2 - c->x1), c->y1 + f * (c->y2 - c->y1)));
    }
    *step = 0.5 * hypot(c->x2 - c->x1, c->y2 - c->y1) / ALONG;
    return least - c->radius;
}

/* Ground about the origin, not all of it below the capsules of draw_capsule. */
static thud_terrain draw_ground(source *r, thud_pos points[VERTICES]) {
    double x = draw(r, -4.0, -1.0);
    for (int i = 0; i < VERTICES; i++) {
        points[i] = (thud_pos){x, draw(r, -3.0, 0.5)};
        x += draw(r, 0.1, 1.5);
    }
    return (thud_terrain){.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = VERTICES};
}

static void distances_from_random_ground_are_those_of_points_along(void **state) {
    (void)state;
    source r = {34};
    int apart = 0, inside = 0;
    for (int i = 0; i < case_count(GROUNDS); i++) {
        thud_pos points[VERTICES];
        thud_terrain ground = draw_ground(&r, points);
        thud_capsule capsule = draw_capsule(&r);
        thud_closest c;
        double step, distance;
        OK(thud_terrain_capsule_closest(&ground, &capsule, &c));
        distance = sampled(&ground, &capsule, &step);
        if (distance > -capsule.radius + step) { /* the segment is outside */
            assert_true(c.distance <= distance + 1e-12 && c.distance >= distance - step - 1e-12);
            near(from_ground(&ground, c.ax + 1e-9 * c.nx, c.ay + 1e-9 * c.ny), 1e-9, 1e-11);
            apart++;
        } else if (distance < -capsule.radius) {
            assert_true(c.distance <= -capsule.radius + 1e-12);
            inside++;
        }
        near(hypot(c.nx, c.ny), 1.0, 1e-12);
        near(c.bx - c.ax, c.distance * c.nx, 1e-12);
    }
    assert_true(apart > 100 && inside > 100);
}

/* At the time of impact the capsule touches the ground, and before it does not. */
static void times_on_random_ground_are_the_first(void **state) {
    (void)state;
    source r = {35};
    int hits = 0;
    for (int i = 0; i < case_count(GROUNDS); i++) {
        thud_pos points[VERTICES];
        thud_terrain ground = draw_ground(&r, points);
        thud_capsule capsule = draw_capsule(&r), at = capsule;
        thud_motion way = {draw(&r, -3, 3), draw(&r, -4, 1), 0};
        double target = i % 2 ? 0.0 : 0.2, time;
        bool hit;
        thud_closest c;
        OK(thud_terrain_capsule_time_of_impact(&ground, &capsule, way, target, &hit, &time));
        for (int k = 0; k <= TIMES; k++) {
            double now = time * k / TIMES;
            at = (thud_capsule){capsule.x1 + now * way.dx, capsule.y1 + now * way.dy,
                                capsule.x2 + now * way.dx, capsule.y2 + now * way.dy,
                                capsule.radius};
            OK(thud_terrain_capsule_closest(&ground, &at, &c));
            assert_true(c.distance > target - 1e-9 || time == 0.0);
        }
        assert_true(!hit || c.distance < target + 1e-9);
        hits += hit && time > 0.0;
    }
    assert_true(hits > 100);
}

/* ---- refused ---- */

static void what_is_no_capsule_is_refused_and_changes_nothing(void **state) {
    (void)state;
    const thud_capsule bad[] = {{NAN, 0, 1, 1, 1}, {0, INFINITY, 1, 1, 1}, {0, 0, 4e15, 1, 1},
                                {0, 0, 1, NAN, 1}, {0, 0, 1, 1, 0},        {0, 0, 1, 1, -1},
                                {0, 0, 1, 1, NAN}, {0, 0, 1, 1, 4e15}};
    const thud_capsule good = {0, 0, 1, 1, 1};
    const thud_geometry ball = thud_circle_at(5, 0, 1), box = thud_aabb_at(0, 0, 1, 1),
                        flat_box = thud_aabb_at(0, 0, 1, 0);
    const thud_terrain ground = {.kind = THUD_TERRAIN_FLAT}, steep = {.slope = 1e9};
    const thud_motion turning = {0, 0, 1}, broken = {NAN, 0, 0};
    thud_closest c = {.distance = 77};
    thud_capsule out = {.radius = 77};
    bool hit = true;
    double time = 77;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        INVALID(thud_capsule_check(&bad[i]));
        INVALID(thud_capsule_closest(&bad[i], &ball, &c));
        INVALID(thud_capsules_closest(&bad[i], &good, &c));
        INVALID(thud_capsules_closest(&good, &bad[i], &c));
        INVALID(thud_terrain_capsule_closest(&ground, &bad[i], &c));
        INVALID(thud_capsule_time_of_impact(&bad[i], STILL, &ball, STILL, 0, &hit, &time));
        INVALID(thud_capsules_time_of_impact(&bad[i], STILL, &good, STILL, 0, &hit, &time));
        INVALID(thud_capsules_time_of_impact(&good, STILL, &bad[i], STILL, 0, &hit, &time));
        INVALID(thud_terrain_capsule_time_of_impact(&ground, &bad[i], STILL, 0, &hit, &time));
    }
    INVALID(thud_capsule_closest(&good, &flat_box, &c));
    INVALID(thud_terrain_capsule_closest(&steep, &good, &c));
    INVALID(thud_capsule_time_of_impact(&good, turning, &ball, STILL, 0, &hit, &time));
    INVALID(thud_capsule_time_of_impact(&good, STILL, &ball, broken, 0, &hit, &time));
    INVALID(thud_capsule_time_of_impact(&good, STILL, &flat_box, STILL, 0, &hit, &time));
    INVALID(thud_capsule_time_of_impact(&good, STILL, &ball, STILL, -1, &hit, &time));
    INVALID(thud_capsules_time_of_impact(&good, STILL, &good, turning, 0, &hit, &time));
    INVALID(thud_capsules_time_of_impact(&good, STILL, &good, STILL, NAN, &hit, &time));
    INVALID(thud_terrain_capsule_time_of_impact(&ground, &good, turning, 0, &hit, &time));
    INVALID(thud_terrain_capsule_time_of_impact(&steep, &good, STILL, 0, &hit, &time));
    INVALID(thud_terrain_capsule_time_of_impact(&ground, &good, STILL, INFINITY, &hit, &time));
    INVALID(thud_capsule_of_motion(&box, STILL, &out));
    INVALID(thud_capsule_of_motion(&ball, broken, &out));
    INVALID(thud_capsule_of_motion(&ball, (thud_motion){THUD_COORDINATE_MAX, 0, 0}, &out));
    assert_int_equal(thud_capsule_check(NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_capsule_closest(NULL, &ball, &c), THUD_ERROR_NULL);
    assert_int_equal(thud_capsules_closest(&good, NULL, &c), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_capsule_closest(NULL, &good, &c), THUD_ERROR_NULL);
    assert_int_equal(thud_capsule_of_motion(NULL, STILL, &out), THUD_ERROR_NULL);
    assert_int_equal(thud_capsule_time_of_impact(&good, STILL, &ball, STILL, 0, NULL, &time),
                     THUD_ERROR_NULL);
    assert_true(c.distance == 77 && out.radius == 77 && time == 77 && hit);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_are_those_worked_out_by_hand),
        cmocka_unit_test(times_are_those_worked_out_by_hand),
        cmocka_unit_test(ground_is_met_as_worked_out_by_hand),
        cmocka_unit_test(distances_of_random_pairs_are_exact),
        cmocka_unit_test(times_of_random_pairs_are_exact),
        cmocka_unit_test(a_capsule_is_the_way_of_a_circle),
        cmocka_unit_test(distances_from_random_ground_are_those_of_points_along),
        cmocka_unit_test(times_on_random_ground_are_the_first),
        cmocka_unit_test(what_is_no_capsule_is_refused_and_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
