/* test_ground_impact.c: overlap, time of impact and time of collision of every kind of shape with
 * every kind of terrain, against long double, by the method of test_pairs_impact.c. */
#include "geometry_ground.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases for each pair of kinds in a quick run, without and with rotation; the shortest step of a
 * search is 1/STEPS of the motion. */
enum { QUICK = 6000, QUICK_TURNING = 200, STEPS = 1000 };
/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 16.0

static thud_geometry thicker(const thud_geometry *s, double by) {
    thud_geometry t = *s;
    t.hx += by;
    t.hy += s->kind == THUD_SHAPE_CIRCLE ? 0.0 : by;
    return t;
}

typedef enum answer { NO, YES, EITHER } answer;

/* Whether the shape is in the ground or touches it; EITHER where a few roundings decide. */
static answer in_ground(const ground *g, double slack) {
    thud_geometry more = thicker(&g->shape, slack), less = thicker(&g->shape, -slack);
    return lift_at(g, &less, 0.0L) > 0.0L ? YES : lift_at(g, &more, 0.0L) < 0.0L ? NO : EITHER;
}

static thud_motion draw_motion_over(source *r, const ground *g, bool turning) {
    double size = g->shape.hx + g->shape.hy, speed = exp(draw(r, -2.0, 4.0)) * size;
    thud_motion m = {draw(r, -speed, speed), draw(r, -speed, speed), 0.0};
    if (draw_below(r, 2)) {
        m.dy = -fabs(m.dy) - size;
    }
    if (draw_below(r, 6) == 0) { /* along an axis */
        *(draw_below(r, 2) ? &m.dx : &m.dy) = 0.0;
    }
    m.turn = turning ? draw(r, -6.0, 6.0) : 0.0;
    return m;
}

static double motion_rounding(const ground *g, thud_motion m) {
    double slope = g->terrain.kind == THUD_TERRAIN_FLAT ? fabs(g->terrain.slope) : 0.0;
    return ground_rounding(g) + ROUNDING * (fabs(m.dx) + fabs(m.dy)) * (1.0 + slope);
}

/* Segment i of the ground's outline, relative to the shape's centre; false if there is none. A flat
 * terrain is as long as the motion needs and no longer, since its far ends are rounded, too. */
static bool outline_piece(const ground *g, thud_motion m, int i, solid *out) {
    const thud_terrain *t = &g->terrain;
    const real way = fabsl(m.dx) + fabsl(m.dy) + g->shape.hx + g->shape.hy;
    *out = (solid){.count = 2};
    if (t->kind == THUD_TERRAIN_FLAT) {
        real far = 0.2L + 4.0L * (way + fabsl(line_height(t, &g->shape, 0.0L)));
        out->v[0] = vec_of(-far, line_height(t, &g->shape, -far));
        out->v[1] = vec_of(far, line_height(t, &g->shape, far));
        return i == 0;
    }
    int a = i < t->count ? i : 0, b = i < t->count - 1 ? i + 1 : a;
    out->v[0] = vertex_from(t, &g->shape, a);
    out->v[1] = vertex_from(t, &g->shape, b);
    if (a == b) {
        out->v[1].y = fminl(out->v[1].y, 0.0L) - 1.0L - 4.0L * way;
    }
    return i <= t->count;
}

/* Counts of shapes in the ground, of impacts, and of searches that ended early. */
static int in, hits, stopped_early;

static void check_overlap(const ground *g) {
    answer expected = in_ground(g, BOUND * ground_rounding(g));
    bool overlap = thud_terrain_overlap(&g->terrain, &g->shape);
    CHECK_GROUND(g, expected == EITHER || overlap == (expected == YES));
    in += overlap;
}

/* ---- time of impact ---- */

static void check_translating(const ground *g, thud_motion m, double target) {
    double slack = BOUND * (motion_rounding(g, m) + ROUNDING * target), time;
    bool hit;
    assert_int_equal(thud_terrain_time_of_impact(&g->terrain, &g->shape, m, target, &hit, &time),
                     THUD_OK);
    CHECK_GROUND(g, hit || time == 1.0);
    answer start = in_ground(g, slack);
    if (start != NO) {
        CHECK_GROUND(g, start == EITHER || (hit && time == 0.0));
        return;
    }
    solid shape = solid_of(&g->shape, g->shape.x, g->shape.y), piece;
    real early = NEVER, late = NEVER, found = hit ? (real)time : NEVER;
    for (int i = 0; outline_piece(g, m, i, &piece); i++) {
        sum h = sum_of(&shape, &piece);
        early = fminl(early, enters(&h, h.radius + target + slack, vec_of(m.dx, m.dy)));
        late = fminl(late, enters(&h, h.radius + target - slack, vec_of(m.dx, m.dy)));
    }
    CHECK_GROUND(g, found >= early - BOUND * ROUNDING && found <= late + BOUND * ROUNDING);
    hits += hit;
}

/* Distance of the shape from the ground's outline after the share t of the motion. */
static real ground_distance(const ground *g, thud_motion m, real t) {
    solid shape = solid_after(&g->shape, m, t, g->shape.x, g->shape.y), piece;
    real least = HUGE_VALL, reach = (real)g->shape.hx + g->shape.hy;
    vec center = {m.dx * t, m.dy * t};
    for (int i = 0; outline_piece(g, m, i, &piece); i++) {
        if (segment_distance(piece.v[0], piece.v[1], center) - reach < least) {
            least = fminl(least, solids_distance(&piece, &shape));
        }
    }
    return least;
}

/* Whether the shape stays at least `least` from the ground until `end`. */
static bool apart_until(const ground *g, thud_motion m, real least, real end) {
    real reach = g->shape.kind == THUD_SHAPE_OBB ? hypotl(g->shape.hx, g->shape.hy) : 0.0L;
    real speed = hypotl(m.dx, m.dy) + fabsl(m.turn) * reach;
    for (real t = 0.0L; t < end;) {
        real distance = ground_distance(g, m, t);
        if (distance < least) {
            return false;
        }
        t += fmaxl((distance - least) / speed, 1.0L / STEPS);
    }
    return true;
}

/* The longest straight segment of the outline that a motion may meet, on which the engine's
 * tolerance depends: a segment, a vertical side at an end, or the part of a flat slope along the
 * motion. */
static double longest_piece(const ground *g, thud_motion m, double reach) {
    const thud_terrain *t = &g->terrain;
    if (t->kind == THUD_TERRAIN_FLAT) {
        return (fabs(m.dx) + 2.0 * reach) * sqrt(1.0 + t->slope * t->slope);
    }
    double longest = 0.0, low = fmin(m.dy, 0.0) - reach;
    for (int i = 0; i < t->count; i++) {
        vec p = vertex_from(t, &g->shape, i);
        if (i + 1 < t->count) {
            longest = fmax(longest, (double)length_of(minus(vertex_from(t, &g->shape, i + 1), p)));
        }
        longest = i == 0 || i + 1 == t->count ? fmax(longest, (double)p.y - low) : longest;
    }
    return longest;
}

static void check_turning(const ground *g, thud_motion m, double target) {
    double size = g->shape.hx + g->shape.hy, time;
    double longest = longest_piece(g, m, size + target);
    double slack =
        1.1e-10 * (size + longest + fabs(m.dx) + fabs(m.dy)) + BOUND * motion_rounding(g, m);
    bool hit;
    assert_int_equal(thud_terrain_time_of_impact(&g->terrain, &g->shape, m, target, &hit, &time),
                     THUD_OK);
    CHECK_GROUND(g, time >= 0.0 && time <= 1.0 && (hit || time == 1.0));
    if (in_ground(g, slack) != NO) {
        return;
    }
    CHECK_GROUND(g, apart_until(g, m, target - slack, time));
    if (hit) {
        real distance = ground_distance(g, m, time);
        CHECK_GROUND(g, time == 0.0 || distance >= target - slack);
        stopped_early += distance > target + slack;
        hits++;
    }
}

/* ---- time of collision ---- */

/* Whether the shape is in the ground after the share t of the motion. */
static answer in_ground_after(const ground *g, thud_motion m, double t, double slack) {
    ground moved = *g;
    thud_geometry *s = &moved.shape;
    moved.terrain.points = moved.points;
    s->x += m.dx * t;
    s->y += m.dy * t;
    if (s->kind == THUD_SHAPE_OBB) {
        double c = cos(m.turn * t), si = sin(m.turn * t);
        s->c = g->shape.c * c - g->shape.s * si;
        s->s = g->shape.s * c + g->shape.c * si;
    }
    return in_ground(&moved, slack);
}

static void check_collision(const ground *g, thud_motion m, double tolerance) {
    double slack = BOUND * (motion_rounding(g, m) + spot_rounding(g)), time;
    bool collided;
    assert_int_equal(thud_terrain_time_of_collision(&g->terrain, &g->shape, m, tolerance, &collided,
                                                    &time),
                     THUD_OK);
    answer before = in_ground(g, slack), after = in_ground_after(g, m, 1.0, slack);
    if (before != EITHER && after != EITHER) {
        CHECK_GROUND(g, collided == (before == NO && after == YES));
    }
    CHECK_GROUND(g, collided || time == 1.0);
    if (collided) {
        CHECK_GROUND(g, time >= 0.0 && time < 1.0);
        CHECK_GROUND(g, in_ground_after(g, m, time, slack) != YES);
        /* Halving the motion leaves an interval that is a power of two. */
        double left = exp2(floor(log2(tolerance)));
        CHECK_GROUND(g, in_ground_after(g, m, time + left, slack) != NO);
        hits++;
    }
}

/* ---- the tests ---- */

typedef struct totals {
    int cases, in, hits, stopped_early;
} totals;

static totals each_ground(uint64_t seed, int count, void check(const ground *g, source *r, int i)) {
    in = hits = stopped_early = 0;
    for (int kind = 0; kind < 3; kind++) {
        for (int shape = 0; shape < 3; shape++) {
            source r = {seed + 3 * kind + shape};
            for (int i = 0; i < count; i++) {
                ground g;
                draw_ground_of(&r, &g, (thud_terrain_kind)kind, (thud_shape_kind)shape, i);
                check(&g, &r, i);
            }
        }
    }
    return (totals){9 * count, in, hits, stopped_early};
}

static void overlap_case(const ground *g, source *r, int i) {
    (void)r;
    (void)i;
    check_overlap(g);
}

static void translating_case(const ground *g, source *r, int i) {
    check_translating(g, draw_motion_over(r, g, false), i % 3 ? 0.0 : 0.05);
}

static void turning_case(const ground *g, source *r, int i) {
    check_turning(g, draw_motion_over(r, g, true), i % 3 ? 0.0 : 0.05);
}

static void collision_case(const ground *g, source *r, int i) {
    check_collision(g, draw_motion_over(r, g, i % 2), i % 3 ? 1e-6 : i % 5 ? 0.1 : 1e-15);
}

static void overlap_of_ground_is_that_of_long_double(void **state) {
    (void)state;
    totals t = each_ground(141, case_count(QUICK), overlap_case);
    assert_true(t.in > t.cases / 5 && t.in < t.cases * 4 / 5);
}

static void impact_on_ground_without_turning_is_that_of_long_double(void **state) {
    (void)state;
    totals t = each_ground(151, case_count(QUICK), translating_case);
    assert_true(t.hits > t.cases / 10);
}

static void impact_on_ground_with_turning_comes_no_later_and_no_earlier(void **state) {
    (void)state;
    totals t = each_ground(161, case_count(QUICK_TURNING), turning_case);
    assert_true(t.hits > t.cases / 10);
    assert_true(t.stopped_early * 20000 <= t.hits);
}

static void collision_with_ground_is_between_apart_and_together(void **state) {
    (void)state;
    totals t = each_ground(171, case_count(QUICK), collision_case);
    assert_true(t.hits > t.cases / 50);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(overlap_of_ground_is_that_of_long_double),
        cmocka_unit_test(impact_on_ground_without_turning_is_that_of_long_double),
        cmocka_unit_test(impact_on_ground_with_turning_comes_no_later_and_no_earlier),
        cmocka_unit_test(collision_with_ground_is_between_apart_and_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
