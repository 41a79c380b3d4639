/* test_pairs_contacts.c: contact points of every pair of kinds. The first must be at the closest
 * features; for the second, the faces are clipped against each other in long double. */
#include "geometry_pairs.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { QUICK = 30000 };
/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 16.0
/* Sine of the angle up to which faces are parallel for the engine; up to ten times more, either
 * answer is accepted. */
#define ALIGNED 3e-8

/* A place in the frame of the normal: along the face, and above it. */
typedef struct spot {
    real along, above;
} spot;

/* The place p in the frame of the normal n. */
static spot spot_of(vec n, vec p) {
    return (spot){n.x * p.y - n.y * p.x, dot(n, p)};
}

/* By how much the side's outward normal differs from the direction n, as a sine; 2 where it points
 * away from n. */
static real off_normal(const solid *s, int side, vec n) {
    vec d = unit(minus(s->v[(side + 1) % 4], s->v[side]));
    return cross(n, d) > 0.0L ? fabsl(dot(n, d)) : 2.0L;
}

/* Whether the engine's second point, or its absence (null), is explained by clipping the other
 * box's side `over` to the side `side` of `face`, whose normal is n. */
static bool explains(const solid *face, int side, const solid *other, int over, vec n, vec first,
                     real margin, real slack, const vec *second) {
    spot p = spot_of(n, minus(face->v[side], first));
    spot q = spot_of(n, minus(face->v[(side + 1) % 4], first));
    spot u = spot_of(n, minus(other->v[over], first));
    spot v = spot_of(n, minus(other->v[(over + 1) % 4], first));
    real low = fminl(p.along, q.along), high = fmaxl(p.along, q.along);
    spot ends[2] = {u, v};
    for (int i = 0; i < 2; i++) {
        real along = fminl(fmaxl(ends[i].along, low), high), across = v.along - u.along;
        real part = across != 0.0L ? (along - u.along) / across : 0.0L;
        part = fminl(fmaxl(part, 0.0L), 1.0L);
        ends[i] = (spot){along, u.above + part * (v.above - u.above)};
    }
    real further = fmaxl(fabsl(ends[0].along), fabsl(ends[1].along));
    for (int i = 0; i < 2; i++) {
        if (fabsl(ends[i].along) < further - slack) {
            continue;
        }
        if (!second && (ends[i].above > margin - slack || further <= 1e-8L)) {
            return true;
        }
        spot found = second ? spot_of(n, minus(*second, first)) : (spot){1e300L, 0.0L};
        if (fabsl(found.along - ends[i].along) <= slack &&
            fabsl(found.above - ends[i].above) <= slack) {
            return true;
        }
    }
    return false;
}

/* Tries all sides that may be the face and the one opposite. n points away from `face`; `first` is
 * a point on it. */
static bool some_side_explains(const solid *face, const solid *other, vec n, vec first, real margin,
                               real slack, const vec *second) {
    vec back = {-n.x, -n.y};
    real least = 3.0L;
    for (int i = 0; i < 4; i++) {
        least = fminl(least, off_normal(other, i, back));
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            if (off_normal(face, i, n) <= 10.0L * ALIGNED &&
                off_normal(other, j, back) <= least + 1e-9L &&
                explains(face, i, other, j, n, first, margin, slack, second)) {
                return true;
            }
        }
    }
    return false;
}

/* Whether a side of the box has the normal n. */
static bool has_face_along(const solid *s, vec n, real slack) {
    for (int i = 0; i < 4 && s->count == 4; i++) {
        if (off_normal(s, i, n) <= slack) {
            return true;
        }
    }
    return false;
}

/* Asserts that the second point, or its absence, is explained by clipping some face. */
static void check_second(const pair *p, const thud_contacts *c, real margin, real slack) {
    const thud_closest *one = &c->point[0], *two = &c->point[1];
    double x = p->a.x, y = p->a.y;
    solid a = solid_of(&p->a, x, y), b = solid_of(&p->b, x, y);
    vec n = {one->nx, one->ny}, back = {-one->nx, -one->ny};
    vec on_a = {(real)one->ax - x, (real)one->ay - y},
        on_b = {(real)one->bx - x, (real)one->by - y};
    vec far_a = {(real)two->ax - x, (real)two->ay - y},
        far_b = {(real)two->bx - x, (real)two->by - y};
    bool second = c->count > 1, boxes = a.count == 4 && b.count == 4;
    if (second) {
        CHECK_PAIR(p, boxes && fabs(two->nx - one->nx) + fabs(two->ny - one->ny) < 2e-7);
        CHECK_PAIR(p, two->distance <= margin);
        CHECK_PAIR(p, fabsl(solid_distance(&a, far_a)) <= slack);
        CHECK_PAIR(p, fabsl(solid_distance(&b, far_b)) <= slack);
        CHECK_PAIR(p, fabs(two->bx - two->ax - two->nx * two->distance) <= slack);
        CHECK_PAIR(p, fabs(two->by - two->ay - two->ny * two->distance) <= slack);
    }
    if (second ||
        (boxes && (has_face_along(&a, n, ALIGNED) || has_face_along(&b, back, ALIGNED)))) {
        CHECK_PAIR(p, some_side_explains(&a, &b, n, on_a, margin, slack, second ? &far_b : NULL) ||
                          some_side_explains(&b, &a, back, on_b, margin, slack,
                                             second ? &far_a : NULL));
    }
}

/* How many pairs had a second point. */
static int seconds;

static void check_contacts(const pair *p, double margin) {
    double slack = BOUND * place_rounding(p);
    thud_closest closest;
    thud_contacts c;
    assert_int_equal(thud_geometry_closest(&p->a, &p->b, &closest), THUD_OK);
    assert_int_equal(thud_geometry_contacts(&p->a, &p->b, margin, &c), THUD_OK);
    if (fabs(closest.distance - margin) > slack) {
        CHECK_PAIR(p, (c.count > 0) == (closest.distance <= margin));
    }
    if (c.count > 0) {
        CHECK_PAIR(p, fabs(c.point[0].distance - closest.distance) <= slack);
        CHECK_PAIR(p, c.count == 1 || c.point[1].distance >= closest.distance - slack);
        check_second(p, &c, margin, slack);
        seconds += c.count > 1;
    }
}

static void contacts_of_every_pair_are_those_of_clipped_faces(void **state) {
    (void)state;
    int count = case_count(QUICK);
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {51 + kinds};
        seconds = 0;
        for (int i = 0; i < count; i++) {
            pair p = draw_pair_of(&r, kinds, (pair_family)(i % FAMILIES));
            check_contacts(&p, i % 3 ? 0.02 : i % 2 ? 0.0 : 10.0);
        }
        assert_true(kinds < 3 ? seconds == 0 : seconds > count / 8);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_of_every_pair_are_those_of_clipped_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
