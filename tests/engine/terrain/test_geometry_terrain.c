/* test_geometry_terrain.c: random terrains (gentle, rough, straight, with cliffs and spikes, fine
 * and coarse, ending under the shape) against dense sampling: look-up, rays, overlap and time of
 * impact. */
#include "ground_random.h"

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
            bool hit =
                thud_terrain_cast_ray(&g.terrain, (thud_segment){ox, oy, dx, dy}, &f, &nx, &ny);
            /* The ray goes down through the line between two samples. */
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
                /* The hit is on the line, within a tolerance that allows for its steepness. */
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
            thud_geometry s = draw_over(&r, &g.terrain);
            double depth = sampled_depth(&g.terrain, &s);
            bool overlap = thud_terrain_overlap(&g.terrain, &s);
            in += overlap;
            assert_false(depth > 1e-7 && !overlap);
            if (overlap && depth < -1e-7) {
                /* Samples may miss an overlap between them, or with the side alone: a shape that is
                 * a little larger shows it. */
                thud_geometry more = s;
                double step = 2.0 * half_width(&s) / SAMPLES;
                more.hx += 1.5 * step + 1e-9;
                more.hy += s.kind == THUD_SHAPE_CIRCLE ? 0.0 : 1.5 * step + 1e-9;
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
            thud_geometry s = draw_over(&r, &g.terrain);
            thud_motion m = {draw(&r, -3.0, 3.0), draw(&r, -8.0, 1.0),
                             k % 2 ? draw(&r, -5.0, 5.0) : 0.0};
            double time, first = 2.0;
            bool hit;
            assert_int_equal(thud_terrain_time_of_impact(&g.terrain, &s, m, 0.0, &hit, &time),
                             THUD_OK);
            for (int j = 0; j <= TIMES && first > 1.0; j++) {
                thud_geometry at = s;
                double t = (double)j / TIMES;
                at.x += m.dx * t;
                at.y += m.dy * t;
                if (s.kind == THUD_SHAPE_OBB) {
                    set_angle(&at, atan2(s.s, s.c) + m.turn * t);
                }
                /* Smaller by 1e-9: whether touching counts depends on rounding. */
                at.hx -= 1e-9;
                at.hy -= s.kind == THUD_SHAPE_CIRCLE ? 0.0 : 1e-9;
                first = thud_terrain_overlap(&g.terrain, &at) ? t : 2.0;
            }
            assert_false(first <= 1.0 && !hit);
            assert_true(hit ? time <= first : time == 1.0);
            if (hit) {
                thud_geometry at = s;
                at.x += m.dx * time;
                at.y += m.dy * time;
                if (s.kind == THUD_SHAPE_OBB) {
                    set_angle(&at, atan2(s.s, s.c) + m.turn * time);
                }
                at.hx += 1e-8;
                at.hy += s.kind == THUD_SHAPE_CIRCLE ? 0.0 : 1e-8;
                hits++;
                exact += thud_terrain_overlap(&g.terrain, &at);
            }
        }
    }
    assert_true(hits > LINES);
    assert_true(exact > hits * 98 / 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sample_of_random_ground_agrees_with_a_scan),
        cmocka_unit_test(segments_of_random_intervals_are_those_that_touch),
        cmocka_unit_test(rays_at_random_ground_agree_with_marching),
        cmocka_unit_test(overlap_with_random_ground_agrees_with_sampled_depth),
        cmocka_unit_test(impact_on_random_ground_agrees_with_sampled_times),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
