/* test_textured.c: ground with a texture: what texture_at gives for a place, and that a walker's
 * feet grip and slip by the friction of the texture's row. */
#include "engine_support.h"

#include "build_thud.h"
#include "scenes.h"
#include "texture.h"

#include <thud/thud_forces.h>

#include <math.h>

static const thud_pos POINTS[] = {{0, 0}, {3, 4}, {4, 4}};
static const thud_terrain LINE = {.kind = THUD_TERRAIN_IRREGULAR, .points = POINTS, .count = 3};

/* Texture row, coordinates and weights at places along the line. */
static void texture_goes_along_the_line_by_its_weights(void **state) {
    (void)state;
    texture_place at;
    assert_true(texture_at(&LINE, 2, 1.5, &at));
    assert_string_equal(at.row->name, "ice");
    assert_true(fabs(at.uv.u - 2.5) < 1e-12 && at.uv.v == 2.5);
    assert_true(at.sample.weight[0] == 0.5 && at.sample.weight[1] == 0.5);
    assert_true(texture_at(&LINE, 0, 3.25, &at));
    assert_true(fabs(at.uv.u - 5.25) < 1e-12);
    assert_true(at.sample.segment == 1 && at.sample.weight[1] == 0.25);
}

static void place_beside_the_line_is_its_end_and_another_line_has_none(void **state) {
    (void)state;
    texture_place at;
    assert_true(texture_at(&LINE, 1, 4.01, &at));
    assert_true(fabs(at.uv.u - 6) < 1e-12);
    assert_true(texture_at(&LINE, 1, -0.01, &at));
    assert_true(at.uv.u == 0);
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    assert_false(texture_at(&flat, 1, 0, &at));
}

/* The texture row at x, or -1 within 1.9 m of the next band, where friction goes over from one row
 * to the other. The scene repeats bands of 6 m of each row from the left end on; the row is derived
 * from the place and not from the friction, so that a wrong friction is found. */
static int row_at(const scene *s, double x) {
    double left = s->points[s->shapes[0].first_point].x;
    int band = (int)((x - left) / 6);
    double along = x - left - 6 * band;
    return along > 1.9 && along < 4.1 ? band % TEXTURE_ROWS : -1;
}

/* Sets, for each row, the mean speed in m/s at which pressed feet slide along the ground. */
static void walk(double slip[TEXTURE_ROWS]) {
    scene s;
    thud_world *world;
    thud_body_id bodies[64];
    int count[TEXTURE_ROWS] = {0};
    assert_true(scenes_fill(scenes_find("textured"), 0, &s));
    assert_true(s.textured && s.body_count <= 64);
    OK(scene_build_thud(&s, NULL, &world, bodies, NULL));
    for (int row = 0; row < TEXTURE_ROWS; row++)
        slip[row] = 0;
    for (int step = 0; step < 1200; step++) {
        thud_manifold feet[16];
        int found = 0;
        run(world, 1);
        OK(thud_body_get_contacts(world, bodies[0], feet, 16, &found));
        for (int i = 0; i < found && i < 16; i++) {
            const thud_manifold *m = &feet[i];
            if (m->point_count == 0 || !(m->normal_impulse[0] > 0))
                continue;
            thud_vec2 v;
            OK(thud_body_get_velocity_at(world, m->body_b, m->point[0], &v));
            int row = row_at(&s, m->point[0].x);
            if (row < 0)
                continue;
            slip[row] += fabs((double)v.x * m->normal.y - (double)v.y * m->normal.x);
            count[row]++;
        }
    }
    for (int row = 0; row < TEXTURE_ROWS; row++) {
        assert_true(count[row] > 25);
        slip[row] /= count[row];
    }
    thud_world_destroy(world);
    scene_free(&s);
}

/* Each band has the friction of its row in its middle, and at its ends the mean with its
 * neighbour's: it is continuous from band to band. */
static void friction_is_the_row_s_and_goes_over_to_the_next_band(void **state) {
    (void)state;
    scene s;
    thud_world *world;
    thud_body_id bodies[64];
    thud_shape_id shapes[32];
    int count = 0;
    assert_true(scenes_fill(scenes_find("textured"), 0, &s));
    OK(scene_build_thud(&s, NULL, &world, bodies, NULL));
    OK(thud_body_get_shapes(world, bodies[0], shapes, 32, &count));
    assert_in_range(count, 12, 32);
    float last = -1;
    for (int i = 0; i < count; i++) {
        thud_terrain line;
        thud_shape_id band = shapes[count - 1 - i]; /* the list begins with the last one made */
        OK(thud_shape_get_terrain(world, band, &line));
        assert_true(line.points[0].x == s.points[s.shapes[i].first_point].x);
        double from = line.points[0].x, to = line.points[line.count - 1].x;
        float first, middle;
        OK(thud_shape_get_friction_at(world, band, from, &first));
        OK(thud_shape_get_friction_at(world, band, (from + to) / 2, &middle));
        near_to((double)middle, TEXTURE[i % TEXTURE_ROWS].friction, 1e-6);
        if (i > 0)
            near_to((double)first, (double)last, 1e-6);
        OK(thud_shape_get_friction_at(world, band, to, &last));
    }
    thud_world_destroy(world);
    scene_free(&s);
}

static void feet_grip_on_rock_and_slip_on_ice(void **state) {
    (void)state;
    double slip[TEXTURE_ROWS]; /* of rock, grass, ice and sand */
    walk(slip);
    /* Measured: at default 0.02 and 0.30; at high and exact, and at half to an eighth of the time
     * step, 0.01 to 0.04 and 0.25 to 0.41, in each 7 to 33 times as much on ice. */
    assert_true(slip[0] < 0.1);
    assert_true(slip[2] > 0.2 && slip[2] > 5 * slip[0]);
    assert_true(slip[3] < slip[2]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texture_goes_along_the_line_by_its_weights),
        cmocka_unit_test(place_beside_the_line_is_its_end_and_another_line_has_none),
        cmocka_unit_test(friction_is_the_row_s_and_goes_over_to_the_next_band),
        cmocka_unit_test(feet_grip_on_rock_and_slip_on_ice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
