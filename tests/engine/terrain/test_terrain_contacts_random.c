/* test_terrain_contacts_random.c: the contacts of a shape with all segments of random ground
 * together: they exist where the shape is in the ground, lead out of it, and are not deeper than it
 * is. */
#include "ground_random.h"

/* ---- contacts of all segments together ---- */

/* The deepest contact: how many there were, its separation and its normal. */
typedef struct deepest {
    int count;
    double separation, nx, ny;
} deepest;

static void segment_normal(const thud_terrain *t, int i, double *nx, double *ny) {
    if (t->kind == THUD_TERRAIN_FLAT) {
        *nx = -t->slope;
        *ny = 1.0;
    } else if (i < 0 || i + 1 >= t->count) { /* the vertical sides at the ends */
        *nx = i < 0 ? -1.0 : 1.0;
        *ny = 0.0;
    } else {
        *nx = t->points[i].y - t->points[i + 1].y;
        *ny = vertex_x(t, i + 1) - vertex_x(t, i);
    }
    double length = sqrt(*nx * *nx + *ny * *ny);
    *nx /= length;
    *ny /= length;
}

/* From the left side to the right side normals turn clockwise, so their angles are in order. */
static bool within_neighbours(const thud_terrain *t, int i, double nx, double ny) {
    double low = 4.0, high = -4.0, angle = atan2(ny + 0.0, nx); /* adding 0 turns -0 into +0 */
    for (int j = i - 1; j <= i + 1; j++) {
        double x, y;
        segment_normal(t, t->kind == THUD_TERRAIN_FLAT ? 0 : j, &x, &y);
        double at = atan2(y, x);
        low = fmin(low, at);
        high = fmax(high, at);
    }
    return angle >= low - 1e-9 && angle <= high + 1e-9;
}

/* The deepest contact of the shape with any segment near it. */
static deepest meet(const thud_terrain *t, const thud_geometry *s) {
    deepest d = {0, 1e300, 0.0, 1.0};
    double reach = half_width(s) + MARGIN;
    int first, last;
    thud_terrain_segments(t, s->x - reach, s->x + reach, &first, &last);
    for (int i = first; i <= last; i++) {
        td_terrain_manifold m;
        td_terrain_segment_manifold(t, i, s, 0, MARGIN, &m);
        if (m.count) {
            assert_true(fabs(m.nx * m.nx + m.ny * m.ny - 1.0) < 1e-12);
            assert_true(within_neighbours(t, i, m.nx, m.ny));
        }
        for (int k = 0; k < m.count; k++) {
            d.count++;
            assert_true(m.point[k].separation <= MARGIN);
            if (m.point[k].separation < d.separation) {
                d.separation = m.point[k].separation;
                d.nx = m.nx;
                d.ny = m.ny;
            }
        }
    }
    return d;
}

/* A shape that is neither a needle nor wider than half the ground, with its centre above or in the
 * ground. */
static thud_geometry draw_body_over(source *r, const thud_terrain *t) {
    double width = last_x(t) - first_x(t);
    thud_geometry s = draw_over(r, t);
    s.hy = s.kind == THUD_SHAPE_CIRCLE ? 0.0 : fmax(s.hy, 0.05);
    while (half_width(&s) > 0.25 * width) {
        s.hx *= 0.5;
        s.hy *= 0.5;
    }
    s.x = fmin(fmax(s.x, first_x(t)), last_x(t));
    return s;
}

/* Whether at most half of the shape's extent is in the ground, as in a world with reasonable
 * steps. */
static bool shallow(const thud_terrain *t, thud_geometry s) {
    s.hx *= 0.5;
    s.hy *= 0.5;
    return !thud_terrain_overlap(t, &s);
}

static void contacts_exist_whenever_a_shape_is_in_the_ground(void **state) {
    (void)state;
    source r = {16};
    ground g;
    int in[2] = {0}, missed[2] = {0};
    for (int i = 0; i < LINES * 4; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE; k++) {
            thud_geometry s = draw_body_over(&r, &g.terrain), less = s;
            bool deep = !shallow(&g.terrain, s);
            less.hx -= 1e-6;
            less.hy -= s.kind == THUD_SHAPE_CIRCLE ? 0.0 : 1e-6;
            if (thud_terrain_overlap(&g.terrain, &less)) {
                deepest d = meet(&g.terrain, &s);
                in[deep]++;
                missed[deep] += !(d.count > 0 && d.separation < 0.0);
            }
        }
    }
    assert_true(in[0] > LINES && in[1] > LINES);
    /* Contacts are missed only where a peak or an end of the ground runs through a box from face to
     * face: then no corner is in the ground, and no vertex in the box. */
    assert_true(missed[0] * 500 < in[0]);
    assert_true(missed[1] * 500 < in[1]);
}

static void contacts_followed_out_leave_the_ground(void **state) {
    (void)state;
    source r = {17};
    ground g;
    int in[2] = {0}, stuck[2] = {0};
    for (int i = 0; i < LINES * 4; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE; k++) {
            thud_geometry s = draw_body_over(&r, &g.terrain);
            bool deep = !shallow(&g.terrain, s);
            if (!thud_terrain_overlap(&g.terrain, &s)) {
                continue;
            }
            in[deep]++;
            int steps = 0;
            for (; steps < 200 && thud_terrain_overlap(&g.terrain, &s); steps++) {
                deepest d = meet(&g.terrain, &s);
                double out = 1e-4 - (d.count ? d.separation : 0.0);
                s.x += d.nx * out;
                s.y += d.ny * out;
            }
            stuck[deep] += steps == 200;
        }
    }
    assert_true(in[0] > LINES && in[1] > LINES);
    /* Again except for boxes that the ground runs through. */
    assert_true(stuck[0] * 500 < in[0]);
    assert_true(stuck[1] * 200 < in[1]);
}

static void contacts_of_parted_shapes_are_no_nearer_than_the_ground(void **state) {
    (void)state;
    source r = {18};
    ground g;
    int near = 0;
    for (int i = 0; i < LINES * 4; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE; k++) {
            thud_geometry s = draw_over(&r, &g.terrain), more = s;
            if (thud_terrain_overlap(&g.terrain, &s)) {
                continue;
            }
            deepest d = meet(&g.terrain, &s);
            near += d.count > 0;
            assert_true(d.count == 0 || d.separation >= -1e-9);
            /* Beyond the margin there are no contacts. */
            more.hx += 1.5 * MARGIN;
            more.hy += s.kind == THUD_SHAPE_CIRCLE ? 0.0 : 1.5 * MARGIN;
            assert_false(d.count > 0 && !thud_terrain_overlap(&g.terrain, &more));
        }
    }
    assert_true(near > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_exist_whenever_a_shape_is_in_the_ground),
        cmocka_unit_test(contacts_followed_out_leave_the_ground),
        cmocka_unit_test(contacts_of_parted_shapes_are_no_nearer_than_the_ground),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
