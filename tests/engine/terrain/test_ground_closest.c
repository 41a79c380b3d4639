/* test_ground_closest.c: distance of a shape from the ground, and the shortest way out of it,
 * against long double.
 *
 * Where a shape fits a gap exactly, rounding decides whether it has to climb out or falls in. So
 * the way out is bounded by those of a shape that is a few roundings thicker and thinner. */
#include "geometry_ground.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases for each pair of kinds in a quick run; samples and refinements of the search for a way
 * out. */
enum { QUICK = 2000, SAMPLES = 48, REFINEMENTS = 40 };
/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 16.0

static thud_geometry thicker(const thud_geometry *s, double by) {
    thud_geometry t = *s;
    t.hx += by;
    t.hy += s->kind == THUD_SHAPE_CIRCLE ? 0.0 : by;
    return t;
}

/* Squared length of the way out that leads over the outline at x; where there is no ground it is
 * straight sideways. */
static real way_out(const ground *g, const thud_geometry *s, real x) {
    real lift = lift_at(g, s, x);
    return x * x + (lift > 0.0L ? lift * lift : 0.0L);
}

/* The shortest way out that a search finds: at least as long as the shortest way. */
static real searched_way_out(const ground *g, const thud_geometry *s, real within) {
    real step = 2.0L * within / SAMPLES, best = way_out(g, s, 0.0L), at = 0.0L;
    for (int i = 0; i <= SAMPLES; i++) {
        real x = i * step - within, way = way_out(g, s, x);
        at = way < best ? x : at;
        best = fminl(best, way);
    }
    real low = at - step, high = at + step;
    for (int i = 0; i < REFINEMENTS; i++) {
        real a = low + 0.382L * (high - low), b = high - 0.382L * (high - low);
        real way_a = way_out(g, s, a), way_b = way_out(g, s, b);
        best = fminl(best, fminl(way_a, way_b));
        low = way_a < way_b ? low : a;
        high = way_a < way_b ? b : high;
    }
    return sqrtl(best);
}

/* The normal leads out of the ground from the place on it: a step of many roundings along it is
 * outside. Far from the origin such a step would be longer than the ground's features, and is not
 * tested. */
static void check_normal(const ground *g, const thud_closest *c, real coarse) {
    const real step = 1e3L * coarse;
    vec out = {(real)c->ax - g->shape.x + step * c->nx, (real)c->ay - g->shape.y + step * c->ny};
    real slack = BOUND * coarse * steepest(&g->terrain);
    CHECK_GROUND(g, step > 1e-9L || line_height(&g->terrain, &g->shape, out.x) <= out.y + slack);
}

/* Shapes in the ground, and shapes apart from it. */
static int ways, parted;

static void check_closest(const ground *g) {
    const thud_geometry *s = &g->shape;
    double slack = BOUND * ground_rounding(g), coarse = BOUND * spot_rounding(g);
    solid shape = solid_of(s, s->x, s->y);
    thud_geometry more = thicker(s, slack), less = thicker(s, -slack);
    thud_closest c;
    assert_int_equal(thud_terrain_closest(&g->terrain, s, &c), THUD_OK);
    CHECK_GROUND(g, fabs(c.nx * c.nx + c.ny * c.ny - 1.0) <= BOUND * ROUNDING);
    CHECK_GROUND(g, fabs(c.bx - c.ax - c.nx * c.distance) <= coarse);
    CHECK_GROUND(g, fabs(c.by - c.ay - c.ny * c.distance) <= coarse);
    vec on_shape = {(real)c.bx - s->x, (real)c.by - s->y};
    solid on_ground = {.count = 1, .v = {{(real)c.ax - s->x, (real)c.ay - s->y}}};
    CHECK_GROUND(g, fabsl(solid_distance(&shape, on_shape)) <= coarse);
    CHECK_GROUND(g, fabsl(outline_distance(g, &on_ground)) <= coarse);
    check_normal(g, &c, coarse);
    if (c.distance >= 0.0) {
        CHECK_GROUND(g, lift_at(g, &less, 0.0L) <= 0.0L);
        CHECK_GROUND(g, fabsl(fmaxl(outline_distance(g, &shape), 0.0L) - c.distance) <= slack);
        parted += c.distance > slack;
    } else {
        CHECK_GROUND(g, lift_at(g, &more, 0.0L) >= 0.0L);
        real x = -c.nx * (real)c.distance, y = -c.ny * (real)c.distance;
        CHECK_GROUND(g, lift_at(g, &less, x) <= y);
        real searched = searched_way_out(g, &more, -1.1L * c.distance);
        CHECK_GROUND(g, -c.distance <= searched + slack);
        ways += c.distance < -slack;
    }
}

static void each_ground(thud_terrain_kind kind) {
    int count = case_count(QUICK);
    ways = parted = 0;
    for (int shape = 0; shape < 3; shape++) {
        source r = {61 + 3 * kind + shape};
        for (int i = 0; i < count; i++) {
            ground g;
            check_closest(draw_ground_of(&r, &g, kind, (thud_shape_kind)shape, i));
        }
    }
    assert_true(ways > count / 2 && parted > count / 2);
}

static void closest_of_flat_ground_is_that_of_long_double(void **state) {
    (void)state;
    each_ground(THUD_TERRAIN_FLAT);
}

static void closest_of_uniform_ground_is_that_of_long_double(void **state) {
    (void)state;
    each_ground(THUD_TERRAIN_UNIFORM);
}

static void closest_of_irregular_ground_is_that_of_long_double(void **state) {
    (void)state;
    each_ground(THUD_TERRAIN_IRREGULAR);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_of_flat_ground_is_that_of_long_double),
        cmocka_unit_test(closest_of_uniform_ground_is_that_of_long_double),
        cmocka_unit_test(closest_of_irregular_ground_is_that_of_long_double),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
