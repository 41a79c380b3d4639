/* test_volumes.c: bounding volumes of random shapes, motions, points and terrains: against samples
 * of what they enclose, against the smallest volume by brute force, and against each other.
 * Everything enclosed must be inside, also within rounding: those checks have no tolerance.
 * THUD_CASES of the environment sets the number of cases for each pair. */
#include "geometry_pairs.h"
#include "thud/thud_volumes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases for each pair of kinds; kinds of volumes; points of a cloud at most; angles of the search
 * for the smallest box. */
enum { CASES = 20000, KINDS = THUD_SHAPE_OBB + 1, CLOUD = 40, ANGLES = 720 };

#define OK(call) assert_int_equal(call, THUD_OK)

/* Whether volumes overlap, which must not depend on their order. */
static bool overlap(const thud_volume *a, const thud_volume *b) {
    bool yes, back;
    OK(thud_volumes_overlap(a, b, &yes));
    OK(thud_volumes_overlap(b, a, &back));
    assert_int_equal(yes, back);
    return yes;
}

static bool contains(const thud_volume *outer, const thud_volume *inner) {
    bool yes;
    OK(thud_volume_contains(outer, inner, &yes));
    return yes;
}

static bool holds(const thud_volume *volume, double x, double y) {
    bool yes;
    OK(thud_volume_contains_point(volume, x, y, &yes));
    return yes;
}

static double area(const thud_volume *v) {
    return v->kind == THUD_SHAPE_CIRCLE ? 3.141592653589793 * v->hx * v->hx : 4.0 * v->hx * v->hy;
}

/* A bound of rounding errors at the shape's place. */
static double rounding(const thud_geometry *shape) {
    return 1e-14 * (1.0 + fabs(shape->x) + fabs(shape->y) + shape->hx + shape->hy);
}

static thud_volume around_shape(thud_shape_kind kind, const thud_geometry *shape) {
    thud_volume v;
    OK(thud_volume_around_shape(kind, shape, &v));
    assert_int_equal(v.kind, kind);
    return v;
}

/* Calls `check` for every pair of kinds, every family and that many cases. */
static void each_pair(uint64_t seed, int cases, void (*check)(source *r, const pair *p)) {
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {seed + kinds};
        for (int i = 0; i < cases; i++) {
            pair p = draw_pair_of(&r, kinds, (pair_family)(i % FAMILIES));
            check(&r, &p);
        }
    }
}

/* ---- tests ---- */

static real exact_distance(const pair *p) {
    solid a = solid_of(&p->a, p->a.x, p->a.y), b = solid_of(&p->b, p->a.x, p->a.y);
    return solids_distance(&a, &b);
}

static void check_overlap(source *r, const pair *p) {
    (void)r;
    real exact = exact_distance(p);
    CHECK_PAIR(p,
               overlap(&p->a, &p->b) == (exact <= 0.0L) || fabsl(exact) <= 8.0 * pair_rounding(p));
}

static void overlap_of_every_pair_is_that_of_long_double(void **state) {
    (void)state;
    each_pair(1, case_count(CASES), check_overlap);
}

/* Where shapes overlap, volumes of every kind around them overlap. */
static void check_no_miss(source *r, const pair *p) {
    (void)r;
    bool touch = exact_distance(p) <= 0.0L;
    for (int i = 0; i < KINDS * KINDS && touch; i++) {
        thud_volume v = around_shape((thud_shape_kind)(i / KINDS), &p->a);
        thud_volume w = around_shape((thud_shape_kind)(i % KINDS), &p->b);
        CHECK_PAIR(p, overlap(&v, &w));
    }
}

static void volumes_of_overlapping_pairs_overlap(void **state) {
    (void)state;
    each_pair(2, case_count(CASES), check_no_miss);
}

static void check_contains(source *r, const pair *p) {
    const thud_geometry *a = &p->a, *b = &p->b;
    bool inside = contains(a, b);
    double eps = rounding(a) + rounding(b), most = -1e300;
    /* How far b extends beyond a at most: at a corner, or on the far side of a circle. */
    for (int i = 0; i < 64; i++) {
        thud_pos o = outline(b, i / 64.0);
        most = fmax(most, point_distance(a, b->x - a->x + o.x, b->y - a->y + o.y));
    }
    assert_true(!inside || most < eps);
    if (b->kind != THUD_SHAPE_CIRCLE) {
        assert_true(inside || most > -eps);
    } else {
        assert_true(inside || most > -0.002 * b->hx - eps);
    }
    double x = b->x + draw(r, -1.0, 1.0), y = b->y + draw(r, -1.0, 1.0);
    double distance = point_distance(b, x - b->x, y - b->y);
    assert_true(holds(b, x, y) == (distance <= 0.0) || fabs(distance) < eps);
}

static void containment_of_every_pair_agrees_with_sampled_outlines(void **state) {
    (void)state;
    each_pair(3, case_count(CASES / 4), check_contains);
}

static void check_around_shape(source *r, const pair *p) {
    (void)r;
    const thud_geometry *a = &p->a;
    thud_volume circle = around_shape(THUD_SHAPE_CIRCLE, a),
                upright = around_shape(THUD_SHAPE_AABB, a);
    thud_volume oriented = around_shape(THUD_SHAPE_OBB, a);
    double eps = rounding(a), width = 0.0, height = 0.0, far = 0.0;
    assert_true(contains(&circle, a) && contains(&upright, a) && contains(&oriented, a));
    for (int i = 0; i < 64; i++) {
        thud_pos o = outline(a, i / 64.0);
        width = fmax(width, fabs(o.x));
        height = fmax(height, fabs(o.y));
        far = fmax(far, sqrt(o.x * o.x + o.y * o.y));
    }
    /* The shape touches all of them, so none could be smaller about the same centre. */
    assert_true(fabs(upright.hx - width) < eps && fabs(upright.hy - height) < eps);
    assert_true(fabs(circle.hx - far) < eps);
    double smallest = a->kind == THUD_SHAPE_CIRCLE ? 4.0 * a->hx * a->hx : area(a);
    assert_true(fabs(area(&oriented) - smallest) < 8.0 * eps * (a->hx + a->hy));
}

static void volumes_of_every_shape_are_the_smallest(void **state) {
    (void)state;
    each_pair(4, case_count(CASES / 4), check_around_shape);
}

/* A random motion, with up to some turns of rotation. */
static thud_motion draw_motion(source *r) {
    const double turns[] = {0.0, 0.1, 1.5, 4.0, 30.0};
    double reach = draw_below(r, 4) ? 3.0 : 0.0, turn = turns[draw_below(r, 5)];
    return (thud_motion){draw(r, -reach, reach), draw(r, -reach, reach), draw(r, -turn, turn)};
}

/* Volumes around a motion contain the shape at sampled times, and are not much larger. */
static void check_around_motion(source *r, const pair *both) {
    const thud_geometry *shape = &both->a;
    thud_motion m = draw_motion(r);
    thud_volume v[KINDS];
    double width = 0.0, height = 0.0, eps = 8.0 * rounding(shape);
    for (int kind = 0; kind < KINDS; kind++) {
        OK(thud_volume_around_motion((thud_shape_kind)kind, shape, m, &v[kind]));
    }
    for (int i = 0; i <= 32; i++) {
        double t = i < 16 ? i / 15.0 : draw(r, 0.0, 1.0), angle = m.turn * t;
        thud_geometry p = *shape;
        if (p.kind == THUD_SHAPE_OBB) {
            p.c = shape->c * cos(angle) - shape->s * sin(angle);
            p.s = shape->s * cos(angle) + shape->c * sin(angle);
        }
        p.x += m.dx * t;
        p.y += m.dy * t;
        for (int kind = 0; kind < KINDS; kind++) {
            /* The sampled place is rounded far from the origin, and the check itself has no
             * tolerance: the sample is made smaller by that. */
            thud_geometry middle = p;
            middle.hx -= fmin(eps, 0.5 * p.hx);
            middle.hy -= fmin(eps, 0.5 * p.hy);
            assert_true(contains(&v[kind], &middle));
        }
        thud_volume now = around_shape(THUD_SHAPE_AABB, &p);
        width = fmax(width, now.hx);
        height = fmax(height, now.hy);
    }
    assert_true(v[THUD_SHAPE_AABB].hx >= width + 0.5 * fabs(m.dx) - eps);
    assert_true(area(&v[THUD_SHAPE_OBB]) <= area(&v[THUD_SHAPE_AABB]) + eps);
    if (fabs(m.turn) < 0.1) { /* sampled densely enough to find the greatest width within 1 % */
        double thick = shape->hx + shape->hy;
        assert_true(v[THUD_SHAPE_AABB].hx <= width + 0.5 * fabs(m.dx) + 0.01 * thick + eps);
        assert_true(v[THUD_SHAPE_AABB].hy <= height + 0.5 * fabs(m.dy) + 0.01 * thick + eps);
    }
}

static void volumes_of_random_motions_hold_every_place_on_the_way(void **state) {
    (void)state;
    each_pair(5, case_count(CASES / 20), check_around_motion);
}

/* Merged volumes contain both. */
static void check_merge(source *r, const pair *p) {
    (void)r;
    const thud_geometry *a = &p->a, *b = &p->b;
    double eps = rounding(a) + rounding(b);
    for (int i = 0; i < KINDS * KINDS; i++) {
        thud_volume v = around_shape((thud_shape_kind)(i / KINDS), a);
        thud_volume w = around_shape((thud_shape_kind)(i % KINDS), b);
        thud_volume both[KINDS];
        for (int kind = 0; kind < KINDS; kind++) {
            OK(thud_volume_merge((thud_shape_kind)kind, &v, &w, &both[kind]));
            assert_true(contains(&both[kind], &v) && contains(&both[kind], &w));
        }
        assert_true(area(&both[THUD_SHAPE_OBB]) <= area(&both[THUD_SHAPE_AABB]) + 100.0 * eps);
        if (i == 0) {
            double apart = hypot(w.x - v.x, w.y - v.y);
            double smallest = fmax(fmax(v.hx, w.hx), 0.5 * (apart + v.hx + w.hx));
            assert_true(fabs(both[THUD_SHAPE_CIRCLE].hx - smallest) < eps);
        }
        double left = fmin(v.x - v.hx, w.x - w.hx), right = fmax(v.x + v.hx, w.x + w.hx);
        if (v.kind != THUD_SHAPE_OBB && w.kind != THUD_SHAPE_OBB) {
            assert_true(fabs(2.0 * both[THUD_SHAPE_AABB].hx - (right - left)) < 8.0 * eps);
        }
    }
}

static void merged_volumes_of_random_pairs_hold_both(void **state) {
    (void)state;
    each_pair(6, case_count(CASES / 8), check_merge);
}

/* Random points: anywhere, in one place, on a line, on a ring, on a grid, in a needle, or far
 * away. */
static int draw_cloud(source *r, int family, thud_pos *points) {
    int count = 1 + draw_below(r, CLOUD);
    double angle = draw(r, -4.0, 4.0), c = cos(angle), s = sin(angle);
    double far_x = family == 6 ? draw(r, -1e7, 1e7) : 0.0, far_y = 0.3 * far_x;
    for (int i = 0; i < count; i++) {
        double u = draw(r, -1.0, 1.0), v = draw(r, -1.0, 1.0), turn = draw(r, 0.0, 7.0);
        switch (family) {
        case 1:
            u = v = 0.25;
            break;
        case 2:
            v = 0.0;
            break;
        case 3:
            u = cos(turn);
            v = sin(turn);
            break;
        case 4:
            u = draw_below(r, 4);
            v = draw_below(r, 3);
            break;
        case 5:
            v *= 1e-6;
            break;
        default:
            break;
        }
        points[i] = (thud_pos){c * u - s * v + far_x, s * u + c * v + far_y};
    }
    return count;
}

/* By brute force: of the circles through two or three of the points that contain all, the
 * smallest. */
static double smallest_radius(const thud_pos *p, int count) {
    double best = count > 1 ? 1e300 : 0.0;
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < i; j++) {
            for (int k = 0; k <= j; k++) {
                double qx = p[j].x - p[i].x, qy = p[j].y - p[i].y, x = 0.5 * qx, y = 0.5 * qy;
                double rx = p[k].x - p[i].x, ry = p[k].y - p[i].y;
                double cross = 2.0 * (qx * ry - qy * rx);
                if (k < j) {
                    x = (ry * (qx * qx + qy * qy) - qy * (rx * rx + ry * ry)) / cross;
                    y = (qx * (rx * rx + ry * ry) - rx * (qx * qx + qy * qy)) / cross;
                }
                double radius = 0.0;
                for (int l = 0; l < count && radius < best; l++) {
                    radius = fmax(radius, hypot(p[l].x - p[i].x - x, p[l].y - p[i].y - y));
                }
                best = k < j && cross == 0.0 ? best : fmin(best, radius);
            }
        }
    }
    return best;
}

/* The smallest area of a box around the points, over ANGLES angles. */
static double smallest_sampled_area(const thud_pos *p, int count) {
    double best = 1e300;
    for (int i = 0; i < ANGLES; i++) {
        double angle = i * (1.5707963267948966 / ANGLES), c = cos(angle), s = sin(angle);
        double u_min = 0.0, u_max = 0.0, v_min = 0.0, v_max = 0.0;
        for (int j = 1; j < count; j++) {
            double x = p[j].x - p[0].x, y = p[j].y - p[0].y, u = c * x + s * y, v = c * y - s * x;
            u_min = fmin(u_min, u), u_max = fmax(u_max, u);
            v_min = fmin(v_min, v), v_max = fmax(v_max, v);
        }
        best = fmin(best, (u_max - u_min) * (v_max - v_min));
    }
    return best;
}

static void volumes_of_random_points_hold_all_and_are_the_smallest(void **state) {
    (void)state;
    source r = {7};
    int cases = case_count(CASES);
    for (int i = 0; i < cases; i++) {
        thud_pos p[CLOUD];
        int family = i % 7, count = draw_cloud(&r, family, p);
        double eps = family == 6 ? 1e-7 : 1e-11;
        thud_volume v[KINDS];
        for (int kind = 0; kind < KINDS; kind++) {
            OK(thud_volume_around_points((thud_shape_kind)kind, p, count, &v[kind]));
            for (int j = 0; j < count; j++) {
                assert_true(holds(&v[kind], p[j].x, p[j].y));
            }
        }
        double left = p[0].x, right = p[0].x;
        for (int j = 1; j < count; j++) {
            left = fmin(left, p[j].x), right = fmax(right, p[j].x);
        }
        assert_true(fabs(2.0 * v[THUD_SHAPE_AABB].hx - (right - left)) < eps);
        if (i % 4 == 0 && count <= 12) {
            assert_true(fabs(v[THUD_SHAPE_CIRCLE].hx - smallest_radius(p, count)) < eps);
        }
        if (i % 16 == 1) {
            assert_true(area(&v[THUD_SHAPE_OBB]) <= smallest_sampled_area(p, count) + eps);
        }
        if (family == 1 || family == 2) { /* a point and a line have no area */
            assert_true(v[THUD_SHAPE_OBB].hy < eps || v[THUD_SHAPE_OBB].hx < eps);
        }
    }
}

static void volumes_of_random_ground_hold_every_height(void **state) {
    (void)state;
    source r = {8};
    int cases = case_count(CASES / 8);
    for (int i = 0; i < cases; i++) {
        thud_pos p[CLOUD];
        int count = 2 + draw_below(&r, CLOUD - 1);
        double spacing = draw(&r, 0.1, 2.0), far = i % 5 ? 0.0 : 1e7, slope = draw(&r, -3.0, 3.0);
        for (int j = 0; j < count; j++) {
            p[j] = (thud_pos){far + j + draw(&r, 0.0, 0.9), draw(&r, -2.0, 2.0) + slope * j};
        }
        thud_terrain t = {(thud_terrain_kind)(i % 3), slope, far, spacing, p, count};
        double low = far + draw(&r, -2.0, 10.0), high = low + draw(&r, 0.0, 1.0) * (i % 4) * 10.0;
        for (int kind = 0; kind < KINDS; kind++) {
            thud_volume v = {.hx = -1.0};
            thud_result result =
                thud_volume_around_terrain((thud_shape_kind)kind, &t, low, high, &v);
            int seen = 0;
            double least = 1e300, most = -1e300;
            for (int k = 0; k <= 200; k++) {
                thud_terrain_sample at;
                double x = low + (high - low) * k / 200.0;
                if (thud_terrain_sample_at(&t, x, &at) == THUD_OK) {
                    assert_int_equal(result, THUD_OK);
                    seen++;
                    least = fmin(least, at.height);
                    most = fmax(most, at.height);
                    /* Between vertices, the height differs from the straight line by rounding. */
                    thud_volume v_near = v;
                    v_near.hx += 1e-13 + 4e-16 * far;
                    v_near.hy += 1e-13 + 4e-16 * far;
                    assert_true(holds(&v_near, x, at.height));
                }
            }
            assert_true(result == THUD_OK || (seen == 0 && v.hx == -1.0));
            if (result == THUD_OK && kind == THUD_SHAPE_AABB && seen == 201) {
                /* Between two samples the line rises by no more than its steepest segment
                 * allows. */
                double steep = (high - low) / 200.0 * (t.kind == THUD_TERRAIN_FLAT ? 0.0 : 90.0);
                assert_true(fabs(v.hx - 0.5 * (high - low)) < 1e-7);
                assert_true(fabs(v.hy - 0.5 * (most - least)) < steep + 1e-7);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(overlap_of_every_pair_is_that_of_long_double),
        cmocka_unit_test(volumes_of_overlapping_pairs_overlap),
        cmocka_unit_test(containment_of_every_pair_agrees_with_sampled_outlines),
        cmocka_unit_test(volumes_of_every_shape_are_the_smallest),
        cmocka_unit_test(volumes_of_random_motions_hold_every_place_on_the_way),
        cmocka_unit_test(merged_volumes_of_random_pairs_hold_both),
        cmocka_unit_test(volumes_of_random_points_hold_all_and_are_the_smallest),
        cmocka_unit_test(volumes_of_random_ground_hold_every_height),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
