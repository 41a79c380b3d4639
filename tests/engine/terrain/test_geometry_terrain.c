/* test_geometry_terrain.c: random ground lines (gentle, rough, straight, with cliffs and spikes,
 * fine and coarse, ending under the shape) against dense sampling: look-up, rays, overlap, time of
 * impact, and the contacts of all segments together. */
#include "geometry_random.h"
#include "terrain/terrain_manifold.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { LINES = 300, PER_LINE = 20, VERTICES = 40, SAMPLES = 800, TIMES = 200 };
#define MARGIN 0.02

typedef struct ground {
    thud_terrain terrain;
    thud_pos points[VERTICES];
} ground;

/* About x = 0; heights within a few units of 0. */
static void draw_ground(source *r, ground *g) {
    int kind = draw_below(r, 8), count = 2 + draw_below(r, VERTICES - 1);
    double spacing = exp(draw(r, -2.5, 0.5)), rough = draw_below(r, 2) ? 1.0 : 0.1;
    double x = -spacing * draw(r, 0.0, 1.0) * count, y = 0.0, slope = draw(r, -1.0, 1.0);
    for (int i = 0; i < count; i++) {
        g->points[i] = (thud_pos){x, y};
        x += draw_below(r, 6) ? spacing * draw(r, 0.3, 2.0) : 1e-4 * spacing;
        y += (kind == 1 ? slope : rough * draw(r, -1.0, 1.0)) * spacing;
    }
    g->terrain = (thud_terrain){.kind = kind == 0   ? THUD_TERRAIN_FLAT
                                        : kind <= 3 ? THUD_TERRAIN_UNIFORM
                                                    : THUD_TERRAIN_IRREGULAR,
                                .slope = slope,
                                .x0 = g->points[0].x,
                                .spacing = spacing,
                                .points = g->points,
                                .count = count};
    assert_int_equal(thud_terrain_check(&g->terrain), THUD_OK);
}

static double vertex_x(const thud_terrain *t, int i) {
    return t->kind == THUD_TERRAIN_UNIFORM ? t->x0 + i * t->spacing : t->points[i].x;
}

static double first_x(const thud_terrain *t) {
    return t->kind == THUD_TERRAIN_FLAT ? -1e9 : vertex_x(t, 0);
}

static double last_x(const thud_terrain *t) {
    return t->kind == THUD_TERRAIN_FLAT ? 1e9 : vertex_x(t, t->count - 1);
}

/* By a scan; -infinity where there is no ground. */
static double height(const thud_terrain *t, double x) {
    if (t->kind == THUD_TERRAIN_FLAT) {
        return t->slope * x;
    }
    for (int i = 0; i + 1 < t->count; i++) {
        double a = vertex_x(t, i), b = vertex_x(t, i + 1);
        if (x >= a && x <= b) {
            double w = (x - a) / (b - a);
            return (1.0 - w) * t->points[i].y + w * t->points[i + 1].y;
        }
    }
    return -INFINITY;
}

static double half_width(const thud_shape_instance *s) {
    return s->kind == THUD_CIRCLE ? s->hx : fabs(s->c) * s->hx + fabs(s->s) * s->hy;
}

/* The lowest point of the shape at one x of it. */
static double underside(const thud_shape_instance *s, double x) {
    double dx = x - s->x, low = INFINITY;
    if (s->kind == THUD_CIRCLE) {
        return s->y - sqrt(fmax(0.0, s->hx * s->hx - dx * dx));
    }
    for (int k = 0; k < 4; k++) {
        thud_pos a = outline(s, 0.25 * k), b = outline(s, 0.25 * ((k + 1) % 4));
        if (fabs(b.x - a.x) > 1e-12 && (dx - a.x) * (dx - b.x) <= 1e-15) {
            low = fmin(low, a.y + (b.y - a.y) * (dx - a.x) / (b.x - a.x));
        }
    }
    return s->y + low;
}

/* How deep the shape reaches into the ground, straight down; negative above it. */
static double sampled_depth(const thud_terrain *t, const thud_shape_instance *s) {
    double half = half_width(s), depth = -INFINITY;
    double from = fmax(s->x - half, first_x(t)), to = fmin(s->x + half, last_x(t));
    for (int i = 0; i <= SAMPLES && from <= to; i++) {
        double x = from + (to - from) * i / SAMPLES;
        depth = fmax(depth, height(t, x) - underside(s, x));
    }
    for (int i = 0; t->kind != THUD_TERRAIN_FLAT && i < t->count; i++) {
        double x = vertex_x(t, i);
        if (x >= from && x <= to) {
            depth = fmax(depth, t->points[i].y - underside(s, x));
        }
    }
    return depth;
}

static thud_shape_instance draw_over(source *r, const thud_terrain *t) {
    thud_shape_instance s = draw_shape(r);
    s.hx = fmax(s.hx, 0.05);
    double from = fmax(first_x(t), -3.0), to = fmin(last_x(t), 3.0);
    s.x = from < to ? draw(r, from - 0.5, to + 0.5) : draw(r, -1.0, 1.0);
    double top = height(t, s.x);
    s.y = (top > -1e9 ? top : 0.0) + draw(r, -1.0, 3.0) * (s.hx + s.hy);
    return s;
}

static void sample_of_random_ground_agrees_with_a_scan(void **state) {
    (void)state;
    source r = {11};
    ground g;
    for (int i = 0; i < LINES; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE * 5; k++) {
            double x = k < g.terrain.count && g.terrain.kind != THUD_TERRAIN_FLAT
                           ? vertex_x(&g.terrain, k)
                           : draw(&r, -20.0, 20.0);
            x = i % 2 ? x : nextafter(x, -1e9);
            double expected = height(&g.terrain, x);
            thud_terrain_sample s;
            thud_result result = thud_terrain_sample_at(&g.terrain, x, &s);
            assert_int_equal(result == THUD_OK, expected > -1e9);
            if (result == THUD_OK) {
                assert_true(fabs(s.height - expected) < 1e-12);
                assert_true(g.terrain.kind == THUD_TERRAIN_FLAT ||
                            (x >= vertex_x(&g.terrain, s.segment) &&
                             (x < vertex_x(&g.terrain, s.segment + 1) ||
                              s.segment == g.terrain.count - 2)));
                assert_true(fabs(s.weight[0] + s.weight[1] - 1.0) < 1e-15 * (1.0 + fabs(x)));
                assert_true(s.ny > 0.0 && fabs(s.nx * s.nx + s.ny * s.ny - 1.0) < 1e-12);
            }
        }
    }
}

static void segments_of_random_intervals_are_those_that_touch(void **state) {
    (void)state;
    source r = {12};
    ground g;
    for (int i = 0; i < LINES; i++) {
        draw_ground(&r, &g);
        const thud_terrain *t = &g.terrain;
        for (int k = 0; k < PER_LINE && t->kind != THUD_TERRAIN_FLAT; k++) {
            double a = draw(&r, -9.0, 9.0), b = a + draw(&r, 0.0, 3.0);
            a = k % 4 ? a : vertex_x(t, draw_below(&r, t->count));
            b = b < a ? a : b;
            int first, last;
            thud_terrain_segments(t, a, b, &first, &last);
            for (int j = 0; j + 1 < t->count; j++) {
                bool touches = vertex_x(t, j) <= b && vertex_x(t, j + 1) >= a;
                assert_int_equal(touches, j >= first && j <= last);
            }
        }
    }
}

static void rays_at_random_ground_agree_with_marching(void **state) {
    (void)state;
    source r = {13};
    ground g;
    int hits = 0;
    for (int i = 0; i < LINES; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE; k++) {
            double ox = draw(&r, -4.0, 4.0), oy = draw(&r, -2.0, 4.0);
            double dx = k % 5 ? draw(&r, -6.0, 6.0) : 0.0, dy = draw(&r, -6.0, 3.0), f, nx, ny;
            bool hit = thud_terrain_cast_ray(&g.terrain, ox, oy, dx, dy, &f, &nx, &ny);
            /* Down through the line between two samples. */
            double first = 2.0, above = oy - height(&g.terrain, ox);
            bool below = above < 0.0;
            for (int s = 1; s <= SAMPLES && !below; s++) {
                double t = (double)s / SAMPLES;
                double now = oy + t * dy - height(&g.terrain, ox + t * dx);
                if (above > 1e-9 && now < -1e-9 && above < 1e9) {
                    first = t;
                    break;
                }
                above = now;
            }
            assert_false(below && hit);
            assert_false(first <= 1.0 && !hit);
            if (hit) {
                hits++;
                thud_terrain_sample sample;
                assert_true(f >= 0.0 && f <= 1.0 && f <= first);
                assert_true(nx * dx + ny * dy < 0.0);
                double x = fmin(fmax(ox + f * dx, first_x(&g.terrain)), last_x(&g.terrain));
                assert_int_equal(thud_terrain_sample_at(&g.terrain, x, &sample), THUD_OK);
                /* On the line, as steep as it may be. */
                assert_true(fabs(oy + f * dy - sample.height) * ny < 1e-9);
            }
        }
    }
    assert_true(hits > LINES);
}

static void overlap_with_random_ground_agrees_with_sampled_depth(void **state) {
    (void)state;
    source r = {14};
    ground g;
    int in = 0;
    for (int i = 0; i < LINES; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE; k++) {
            thud_shape_instance s = draw_over(&r, &g.terrain);
            double depth = sampled_depth(&g.terrain, &s);
            bool overlap = thud_terrain_overlap(&g.terrain, &s);
            in += overlap;
            assert_false(depth > 1e-7 && !overlap);
            if (overlap && depth < -1e-7) {
                /* Between two samples, or in the side alone: bigger by a little, it shows. */
                thud_shape_instance more = s;
                double step = 2.0 * half_width(&s) / SAMPLES;
                more.hx += 1.5 * step + 1e-9;
                more.hy += s.kind == THUD_CIRCLE ? 0.0 : 1.5 * step + 1e-9;
                more.y -= 0.5 * step;
                assert_true(sampled_depth(&g.terrain, &more) > -8.0 * step);
            }
        }
    }
    assert_true(in > LINES && in < LINES * PER_LINE);
}

static void impact_on_random_ground_agrees_with_sampled_times(void **state) {
    (void)state;
    source r = {15};
    ground g;
    int hits = 0, exact = 0;
    for (int i = 0; i < LINES; i++) {
        draw_ground(&r, &g);
        for (int k = 0; k < PER_LINE / 2; k++) {
            thud_shape_instance s = draw_over(&r, &g.terrain);
            thud_motion m = {draw(&r, -3.0, 3.0), draw(&r, -8.0, 1.0),
                             k % 2 ? draw(&r, -5.0, 5.0) : 0.0};
            double time, first = 2.0;
            bool hit;
            assert_int_equal(thud_terrain_time_of_impact(&g.terrain, &s, m, 0.0, &hit, &time),
                             THUD_OK);
            for (int j = 0; j <= TIMES && first > 1.0; j++) {
                thud_shape_instance at = s;
                double t = (double)j / TIMES;
                at.x += m.dx * t;
                at.y += m.dy * t;
                if (s.kind == THUD_OBB) {
                    set_angle(&at, atan2(s.s, s.c) + m.turn * t);
                }
                /* A hair smaller: touching is left to rounding. */
                at.hx -= 1e-9;
                at.hy -= s.kind == THUD_CIRCLE ? 0.0 : 1e-9;
                first = thud_terrain_overlap(&g.terrain, &at) ? t : 2.0;
            }
            assert_false(first <= 1.0 && !hit);
            assert_true(hit ? time <= first : time == 1.0);
            if (hit) {
                thud_shape_instance at = s;
                at.x += m.dx * time;
                at.y += m.dy * time;
                if (s.kind == THUD_OBB) {
                    set_angle(&at, atan2(s.s, s.c) + m.turn * time);
                }
                at.hx += 1e-8;
                at.hy += s.kind == THUD_CIRCLE ? 0.0 : 1e-8;
                hits++;
                exact += thud_terrain_overlap(&g.terrain, &at);
            }
        }
    }
    assert_true(hits > LINES);
    assert_true(exact > hits * 98 / 100);
}

/* ---- contacts of all segments together ---- */

typedef struct deepest {
    int count;
    double separation, nx, ny;
} deepest;

static void segment_normal(const thud_terrain *t, int i, double *nx, double *ny) {
    if (t->kind == THUD_TERRAIN_FLAT) {
        *nx = -t->slope;
        *ny = 1.0;
    } else if (i < 0 || i + 1 >= t->count) { /* the upright sides */
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

/* Normals turn clockwise from the left side's to the right side's, so an angle orders them. */
static bool within_neighbours(const thud_terrain *t, int i, double nx, double ny) {
    double low = 4.0, high = -4.0, angle = atan2(ny + 0.0, nx); /* no -0 */
    for (int j = i - 1; j <= i + 1; j++) {
        double x, y;
        segment_normal(t, t->kind == THUD_TERRAIN_FLAT ? 0 : j, &x, &y);
        double at = atan2(y, x);
        low = fmin(low, at);
        high = fmax(high, at);
    }
    return angle >= low - 1e-9 && angle <= high + 1e-9;
}

static deepest meet(const thud_terrain *t, const thud_shape_instance *s) {
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

/* Neither a needle nor wider than half the ground, its centre over or in the ground. */
static thud_shape_instance draw_body_over(source *r, const thud_terrain *t) {
    double width = last_x(t) - first_x(t);
    thud_shape_instance s = draw_over(r, t);
    s.hy = s.kind == THUD_CIRCLE ? 0.0 : fmax(s.hy, 0.05);
    while (half_width(&s) > 0.25 * width) {
        s.hx *= 0.5;
        s.hy *= 0.5;
    }
    s.x = fmin(fmax(s.x, first_x(t)), last_x(t));
    return s;
}

/* No more than half of the shape is in the ground: what a world with sane steps may see. */
static bool shallow(const thud_terrain *t, thud_shape_instance s) {
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
            thud_shape_instance s = draw_body_over(&r, &g.terrain), less = s;
            bool deep = !shallow(&g.terrain, s);
            less.hx -= 1e-6;
            less.hy -= s.kind == THUD_CIRCLE ? 0.0 : 1e-6;
            if (thud_terrain_overlap(&g.terrain, &less)) {
                deepest d = meet(&g.terrain, &s);
                in[deep]++;
                missed[deep] += !(d.count > 0 && d.separation < 0.0);
            }
        }
    }
    assert_true(in[0] > LINES && in[1] > LINES);
    /* Only a plank that a peak or an end of the ground runs through, from face to face, may go
     * unseen: no corner is in the ground then, and no vertex in the plank. */
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
            thud_shape_instance s = draw_body_over(&r, &g.terrain);
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
    /* Again but for planks that are run through. */
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
            thud_shape_instance s = draw_over(&r, &g.terrain), more = s;
            if (thud_terrain_overlap(&g.terrain, &s)) {
                continue;
            }
            deepest d = meet(&g.terrain, &s);
            near += d.count > 0;
            assert_true(d.count == 0 || d.separation >= -1e-9);
            /* Not within the margin: nothing at all. */
            more.hx += 1.5 * MARGIN;
            more.hy += s.kind == THUD_CIRCLE ? 0.0 : 1.5 * MARGIN;
            assert_false(d.count > 0 && !thud_terrain_overlap(&g.terrain, &more));
        }
    }
    assert_true(near > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sample_of_random_ground_agrees_with_a_scan),
        cmocka_unit_test(segments_of_random_intervals_are_those_that_touch),
        cmocka_unit_test(rays_at_random_ground_agree_with_marching),
        cmocka_unit_test(overlap_with_random_ground_agrees_with_sampled_depth),
        cmocka_unit_test(impact_on_random_ground_agrees_with_sampled_times),
        cmocka_unit_test(contacts_exist_whenever_a_shape_is_in_the_ground),
        cmocka_unit_test(contacts_followed_out_leave_the_ground),
        cmocka_unit_test(contacts_of_parted_shapes_are_no_nearer_than_the_ground),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
