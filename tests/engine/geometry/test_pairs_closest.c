/* test_pairs_closest.c: overlap and closest features of every pair of kinds against long double,
 * within eight roundings of the lengths that go into the answer. Far from the origin the distance
 * is as exact; points are as coarse as their coordinates. */
#include "geometry_pairs.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases of a quick run for each pair of kinds. */
enum { QUICK = 20000 };
/* Tolerance, in roundings of those lengths. Chosen. */
#define BOUND 8.0

static bool on_outline(const solid *s, const thud_geometry *origin, double x, double y,
                       double slack) {
    vec p = {(real)x - origin->x, (real)y - origin->y};
    return fabsl(solid_distance(s, p)) <= slack;
}

static void check_closest(const pair *p) {
    double slack = BOUND * pair_rounding(p), coarse = BOUND * place_rounding(p);
    solid a = solid_of(&p->a, p->a.x, p->a.y), b = solid_of(&p->b, p->a.x, p->a.y);
    real exact = solids_distance(&a, &b);
    thud_closest c;
    assert_int_equal(thud_geometry_closest(&p->a, &p->b, &c), THUD_OK);
    CHECK_PAIR(p, fabsl(c.distance - exact) <= slack);
    vec n = {c.nx, c.ny};
    CHECK_PAIR(p, fabsl(length_of(n) - 1.0L) <= BOUND * ROUNDING);
    CHECK_PAIR(p, fabsl(gap_along(&a, &b, unit(n)) - exact) <= slack);
    CHECK_PAIR(p, on_outline(&a, &p->a, c.ax, c.ay, coarse));
    CHECK_PAIR(p, on_outline(&b, &p->a, c.bx, c.by, coarse));
    CHECK_PAIR(p, fabs(c.bx - c.ax - c.nx * c.distance) <= coarse);
    CHECK_PAIR(p, fabs(c.by - c.ay - c.ny * c.distance) <= coarse);
}

static void check_overlap(const pair *p) {
    solid a = solid_of(&p->a, p->a.x, p->a.y), b = solid_of(&p->b, p->a.x, p->a.y);
    real exact = solids_distance(&a, &b);
    if (fabsl(exact) > BOUND * pair_rounding(p)) {
        CHECK_PAIR(p, thud_geometry_overlap(&p->a, &p->b) == (exact < 0.0L));
        CHECK_PAIR(p, thud_geometry_overlap(&p->b, &p->a) == (exact < 0.0L));
    }
}

static void check_either_way_round(const pair *p) {
    thud_closest there, back;
    assert_int_equal(thud_geometry_closest(&p->a, &p->b, &there), THUD_OK);
    assert_int_equal(thud_geometry_closest(&p->b, &p->a, &back), THUD_OK);
    CHECK_PAIR(p, fabs(there.distance - back.distance) <= BOUND * pair_rounding(p));
}

/* Calls `check` for every pair of kinds and family. */
static void each_pair(uint64_t seed, void check(const pair *p)) {
    int count = case_count(QUICK);
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {seed + kinds};
        for (int i = 0; i < count; i++) {
            pair p = draw_pair_of(&r, kinds, (pair_family)(i % FAMILIES));
            check(&p);
        }
    }
}

static void closest_of_every_pair_is_that_of_long_double(void **state) {
    (void)state;
    each_pair(21, check_closest);
}

static void closest_of_every_pair_has_one_distance_either_way_round(void **state) {
    (void)state;
    each_pair(31, check_either_way_round);
}

static void overlap_of_every_pair_is_that_of_long_double(void **state) {
    (void)state;
    each_pair(41, check_overlap);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_of_every_pair_is_that_of_long_double),
        cmocka_unit_test(closest_of_every_pair_has_one_distance_either_way_round),
        cmocka_unit_test(overlap_of_every_pair_is_that_of_long_double),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
