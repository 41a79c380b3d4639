/* test_geometry_shapes.c: distance, overlap, rays and time of impact of random pairs of shapes,
 * against dense sampling, in the families in which geometry code fails: touching, one inside the
 * other, parallel, corner to corner, needles, and far from the origin. */
#include "geometry_random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Random pairs; samples of an outline; random rays and samples of each; random motions and samples
 * of each. */
enum { PAIRS = 12000, OUTLINE = 256, RAYS = 20000, MARCH = 400, MOTIONS = 2500, TIMES = 300 };

typedef struct pair {
    thud_geometry a, b;
    double scale; /* rounding of the coordinates in use */
} pair;

/* Moves the pair far away, and its tolerance with it. */
static void shift(pair *p, double x, double y) {
    p->a.x += x, p->b.x += x;
    p->a.y += y, p->b.y += y;
    p->scale = 1e-9;
}

/* Moves b along the line between the closest points until the shapes touch. */
static void bring_together(pair *p) {
    thud_closest c;
    assert_int_equal(thud_geometry_closest(&p->a, &p->b, &c), THUD_OK);
    p->b.x -= c.nx * c.distance;
    p->b.y -= c.ny * c.distance;
}

/* A random pair of a family (0: any place). */
static pair draw_pair(source *r, int family) {
    pair p = {draw_shape(r), draw_shape(r), 1e-12};
    switch (family) {
    case 1:
        bring_together(&p);
        break;
    case 2: /* one in the other */
        p.b.x = p.a.x + draw(r, -1.0, 1.0) * 0.1;
        p.b.y = p.a.y + draw(r, -1.0, 1.0) * 0.1;
        break;
    case 3: /* the same centre */
        p.b.x = p.a.x;
        p.b.y = p.a.y;
        break;
    case 4: /* parallel */
        p.b.kind = p.a.kind = THUD_SHAPE_OBB;
        p.a.hy = p.b.hy = 0.5;
        set_angle(&p.a, draw(r, -4.0, 4.0));
        p.b.c = p.a.c;
        p.b.s = p.a.s;
        break;
    case 5: { /* corner to corner */
        p.a.kind = p.b.kind = THUD_SHAPE_OBB;
        p.a.hy = 0.3;
        p.b.hy = 0.7;
        set_angle(&p.a, draw(r, -4.0, 4.0));
        set_angle(&p.b, draw(r, -4.0, 4.0));
        thud_pos i = outline(&p.a, 0.25 * draw_below(r, 4));
        thud_pos j = outline(&p.b, 0.25 * draw_below(r, 4));
        p.b.x = p.a.x + i.x - j.x;
        p.b.y = p.a.y + i.y - j.y;
        break;
    }
    case 6: /* far from the origin */
        shift(&p, 1e6 * draw(r, -1.0, 1.0), 1e6 * draw(r, -1.0, 1.0));
        break;
    default:
        break;
    }
    return p;
}

/* The least distance of a's sampled outline from b: too large by no more than the samples'
 * spacing. */
static double sampled_distance(const pair *p) {
    double best = 1e300;
    for (int i = 0; i < OUTLINE; i++) {
        thud_pos o = outline(&p->a, (double)i / OUTLINE);
        best = fmin(best, point_distance(&p->b, p->a.x - p->b.x + o.x, p->a.y - p->b.y + o.y));
    }
    return best;
}

/* Asserts that both points are on the outlines, and the distance apart along a unit normal. */
static void check_points(const pair *p, const thud_closest *c) {
    double on_a = point_distance(&p->a, c->ax - p->a.x, c->ay - p->a.y);
    double on_b = point_distance(&p->b, c->bx - p->b.x, c->by - p->b.y);
    assert_true(fabs(c->nx * c->nx + c->ny * c->ny - 1.0) < 1e-12);
    assert_true(fabs(on_a) < p->scale * 10.0);
    assert_true(fabs(on_b) < p->scale * 10.0);
    assert_true(fabs(c->bx - c->ax - c->nx * c->distance) < p->scale * 10.0);
    assert_true(fabs(c->by - c->ay - c->ny * c->distance) < p->scale * 10.0);
}

/* Moving b along the normal by the depth separates the shapes; moving it by less does so in no
 * direction. */
static void check_depth(const pair *p, const thud_closest *c) {
    thud_geometry moved = p->b;
    double out = -c->distance + p->scale * 10.0;
    moved.x += c->nx * out;
    moved.y += c->ny * out;
    assert_false(thud_geometry_overlap(&p->a, &moved));
    for (int i = 0; i < 16 && c->distance < -p->scale * 100.0; i++) {
        double angle = i * 0.39269908169872414, less = -c->distance * 0.999;
        moved = p->b;
        moved.x += less * cos(angle);
        moved.y += less * sin(angle);
        assert_true(thud_geometry_overlap(&p->a, &moved));
    }
}

static void closest_of_random_pairs_agrees_with_sampled_outlines(void **state) {
    (void)state;
    source r = {1};
    for (int i = 0; i < PAIRS; i++) {
        pair p = draw_pair(&r, i % 7);
        thud_closest c, back;
        assert_int_equal(thud_geometry_closest(&p.a, &p.b, &c), THUD_OK);
        assert_int_equal(thud_geometry_closest(&p.b, &p.a, &back), THUD_OK);
        assert_true(fabs(c.distance - back.distance) < p.scale);
        assert_int_equal(thud_geometry_overlap(&p.a, &p.b), c.distance <= 0.0);
        check_points(&p, &c);
        double sampled = sampled_distance(&p);
        if (c.distance > 0.0) {
            assert_true(sampled >= c.distance - p.scale);
            assert_true(sampled <= c.distance + outline_length(&p.a) / OUTLINE);
        } else {
            check_depth(&p, &c);
        }
        assert_false(sampled < -p.scale && c.distance > 0.0);
    }
}

static void touching_pairs_overlap_within_rounding(void **state) {
    (void)state;
    source r = {2};
    for (int i = 0; i < PAIRS; i++) {
        pair p = draw_pair(&r, 1);
        thud_closest c;
        assert_int_equal(thud_geometry_closest(&p.a, &p.b, &c), THUD_OK);
        assert_true(fabs(c.distance) < 1e-12);
    }
}

static void rays_at_random_shapes_agree_with_marching(void **state) {
    (void)state;
    source r = {3};
    int hits = 0;
    for (int i = 0; i < RAYS; i++) {
        thud_geometry shape = draw_shape(&r);
        double far = i % 4 ? 0.0 : 1e6 * draw(&r, -1.0, 1.0), f, nx, ny;
        double eps = far != 0.0 ? 1e-8 : 1e-11;
        shape.x += far;
        double ox = shape.x + draw(&r, -4.0, 4.0), oy = shape.y + draw(&r, -4.0, 4.0);
        double dx = draw(&r, -6.0, 6.0), dy = i % 8 == 1 ? 0.0 : draw(&r, -6.0, 6.0);
        if (i % 2) { /* towards the shape */
            dx = 2.0 * (shape.x - ox) + draw(&r, -1.0, 1.0);
        }
        bool hit = thud_geometry_cast_ray(&shape, (thud_segment){ox, oy, dx, dy}, &f, &nx, &ny);
        double x = ox - shape.x, y = oy - shape.y, length = sqrt(dx * dx + dy * dy);
        bool inside = point_distance(&shape, x, y) < -eps;
        double first = 2.0;
        for (int k = 0; k <= MARCH && first > 1.0; k++) {
            double t = (double)k / MARCH;
            first = point_distance(&shape, x + t * dx, y + t * dy) < -eps ? t : 2.0;
        }
        assert_false(inside && hit);
        assert_false(!inside && first <= 1.0 && !hit);
        if (hit) {
            hits++;
            assert_true(f >= 0.0 && f <= 1.0 && f <= first);
            assert_true(fabs(point_distance(&shape, x + f * dx, y + f * dy)) < eps);
            assert_true(nx * dx + ny * dy <= 1e-9 * length);
            /* The normal points outward: a little along it, the distance from the shape is greater
             * by that much. */
            double out = point_distance(&shape, x + f * dx + 1e-6 * nx, y + f * dy + 1e-6 * ny);
            assert_true(fabs(out - 1e-6) < 1e-8);
        }
    }
    assert_true(hits > RAYS / 10 && hits < RAYS);
}

static thud_motion draw_motion(source *r) {
    double speed = draw_below(r, 3) ? 4.0 : 0.1;
    return (thud_motion){draw(r, -speed, speed), draw(r, -speed, speed),
                         draw_below(r, 2) ? draw(r, -6.0, 6.0) : 0.0};
}

static thud_geometry moved_by(const thud_geometry *shape, thud_motion m, double t) {
    thud_geometry p = *shape;
    p.x += m.dx * t;
    p.y += m.dy * t;
    if (p.kind == THUD_SHAPE_OBB) {
        double c = cos(m.turn * t), s = sin(m.turn * t);
        p.c = shape->c * c - shape->s * s;
        p.s = shape->s * c + shape->c * s;
    }
    return p;
}

static double distance_at(const pair *p, thud_motion ma, thud_motion mb, double t) {
    thud_geometry a = moved_by(&p->a, ma, t), b = moved_by(&p->b, mb, t);
    thud_closest c;
    assert_int_equal(thud_geometry_closest(&a, &b, &c), THUD_OK);
    return c.distance;
}

static void time_of_impact_of_random_motions_agrees_with_sampled_times(void **state) {
    (void)state;
    source r = {4};
    int hits = 0, exact = 0;
    for (int i = 0; i < MOTIONS; i++) {
        pair p = draw_pair(&r, i % 4 ? 0 : 6);
        p.b.x += draw(&r, -3.0, 3.0);
        p.b.y += draw(&r, -3.0, 3.0);
        thud_motion ma = draw_motion(&r), mb = draw_motion(&r);
        double target = draw_below(&r, 2) ? 0.0 : 0.05, time, first = 2.0;
        bool hit;
        assert_int_equal(thud_geometry_time_of_impact(&p.a, ma, &p.b, mb, target, &hit, &time),
                         THUD_OK);
        for (int k = 0; k <= TIMES && first > 1.0; k++) {
            double t = (double)k / TIMES;
            first = distance_at(&p, ma, mb, t) < target - p.scale ? t : 2.0;
        }
        assert_false(first <= 1.0 && !hit);
        assert_true(hit || time == 1.0);
        if (hit) {
            double distance = distance_at(&p, ma, mb, time);
            hits++;
            assert_true(time >= 0.0 && time <= first);
            assert_true(time == 0.0 || distance >= target - 10.0 * p.scale);
            exact += distance <= target + 1e-8;
        }
    }
    assert_true(hits > MOTIONS / 5 && hits < MOTIONS);
    /* The search may stop early only where a long shape rotates close to a contact. */
    assert_true(exact > hits * 99 / 100);
}

static void fast_shapes_never_pass_a_needle(void **state) {
    (void)state;
    source r = {5};
    for (int i = 0; i < PAIRS; i++) {
        thud_geometry wall = {.kind = THUD_SHAPE_OBB, .c = 1.0, .hx = 2.0, .hy = 1e-7};
        set_angle(&wall, draw(&r, -4.0, 4.0));
        thud_geometry shape = draw_shape(&r);
        /* From one side of the wall to the other, through a point of it. */
        double along = draw(&r, -1.9, 1.9), way = draw(&r, 5.0, 5000.0), skew = draw(&r, -1.2, 1.2);
        double nx = -wall.s, ny = wall.c;
        double dx = way * (cos(skew) * nx + sin(skew) * ny);
        double dy = way * (cos(skew) * ny - sin(skew) * nx);
        double back = draw(&r, 0.2, 0.8);
        shape.x = along * wall.c - dx * back;
        shape.y = along * wall.s - dy * back;
        thud_motion m = {dx, dy, draw(&r, -3.0, 3.0)};
        bool hit;
        double time;
        assert_int_equal(thud_geometry_time_of_impact(&shape, m, &wall, (thud_motion){0}, 0.0, &hit,
                                                      &time),
                         THUD_OK);
        assert_true(hit);
        assert_true(time <= back);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_of_random_pairs_agrees_with_sampled_outlines),
        cmocka_unit_test(touching_pairs_overlap_within_rounding),
        cmocka_unit_test(rays_at_random_shapes_agree_with_marching),
        cmocka_unit_test(time_of_impact_of_random_motions_agrees_with_sampled_times),
        cmocka_unit_test(fast_shapes_never_pass_a_needle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
