/* test_field_scenes.c: at every quality, the scenes of buoyancy, wind and explosions behave as
 * their descriptions say: boats float, flags follow the wind, and walls shield crates from a
 * blast. */
#include "stage.h"

#include <thud/thud_fields.h>

/* ---- boats ---- */

/* The mass in kg of the water that the body displaces. */
static double displaced(const stage *t, int index) {
    const scene_fields *f = &t->scene.fields;
    const scene_body *from = &t->scene.bodies[index];
    thud_body_state b = body(t, index);
    double sum = 0;
    for (int i = 0; i < from->shape_count; i++) {
        const scene_shape *shape = &t->scene.shapes[from->first_shape + i];
        double c = cos(shape->angle), s = sin(shape->angle), area;
        thud_geometry placed = {.kind = shape->kind == SCENE_CIRCLE ? THUD_SHAPE_CIRCLE
                                                                    : THUD_SHAPE_OBB,
                                .x = b.position.x + b.cosine * shape->x - b.sine * shape->y,
                                .y = b.position.y + b.sine * shape->x + b.cosine * shape->y,
                                .c = b.cosine * c - b.sine * s,
                                .s = b.sine * c + b.cosine * s,
                                .hx = shape->hx,
                                .hy = shape->hy};
        double x, y;
        OK(thud_geometry_area_below(&placed, (thud_half_plane){0, f->water_level, 0, 1}, &area, &x,
                                    &y));
        sum += f->water_density * area;
    }
    return sum;
}

/* Asserts that the bodies first..end-1 together displace as much mass of water as they have: the
 * water alone carries them. */
static void expect_afloat(const stage *t, int first, int end) {
    double water = 0, mass = 0;
    for (int i = first; i < end; i++) {
        water += displaced(t, i);
        mass += (double)body(t, i).mass;
    }
    if (!(fabs(water - mass) < 0.01 * mass + 0.01))
        fail_msg("bodies %d to %d have mass %g and displace %g of water", first, end - 1, mass,
                 water);
}

static void boats_float_at_their_draught_with_their_cargo(void **state) {
    (void)state;
    /* Indices of bodies: land and jetty, then the hulls, each with its cargo behind it. */
    enum { BARGE = 2, SAILING = 10, TUG = 14, LOG = 15, ANCHOR = 16, CRATES = 26 };
    for (int q = 0; q < QUALITIES; q++) {
        stage t = open_stage("boats", 3, qualities[q]);
        double deck = body(&t, BARGE).position.y;
        run_whole(&t, 1500);
        expect_afloat(&t, BARGE, SAILING);
        expect_afloat(&t, SAILING, TUG);
        expect_afloat(&t, TUG, LOG);
        expect_afloat(&t, LOG, ANCHOR);
        for (int i = 0; i < 3; i++)
            expect_afloat(&t, CRATES + i, CRATES + i + 1);
        assert_true(body(&t, BARGE).position.y < deck - 0.2);
        for (int i = BARGE; i < LOG; i++) /* hulls are upright, and their cargo is still on board */
            if (i == BARGE || i == SAILING || i == TUG)
                assert_true(fabs(atan2(body(&t, i).sine, body(&t, i).cosine)) < 0.15);
            else
                assert_true(displaced(&t, i) < 0.05 * (double)body(&t, i).mass);
        assert_true(body(&t, CRATES + 3).position.y < -4); /* heavier than water: it sank */
        close_stage(&t);
    }
}

/* ---- flags ---- */

/* Each flag has three stripes of seven plates. The bodies before the plates are land, scenery, and
 * last the poles. */
enum { FLAGS = 4, STRIPES = 3, PLATES = 7, FIRST_PLATE = 1 + FLAGS + 1 + FLAGS };

/* Mean distance of the stripes' free ends to the right of their poles, over stripes and steps, in
 * lengths of a stripe. */
static double leeward(double wind, int quality) {
    stage t = open_stage("flags", FLAGS, qualities[quality]);
    t.scene.fields.wind = wind;
    run_whole(&t, 300); /* until a gust has reached every flag */
    double sum = 0;
    for (int step = 0; step < 300; step++) {
        run_whole(&t, 1);
        for (int k = 0; k < STRIPES * FLAGS; k++) {
            int plate = FIRST_PLATE + PLATES * k;
            double pole = t.scene.bodies[FIRST_PLATE - FLAGS + k % FLAGS].x;
            sum += body(&t, plate + PLATES - 1).position.x - pole;
        }
    }
    close_stage(&t);
    return sum / (300 * STRIPES * FLAGS) / (2 * 0.3 * PLATES);
}

static void flags_blow_to_leeward_and_hang_in_a_calm(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        double blown = leeward(9, q), other = leeward(-9, q), calm = leeward(0, q);
        assert_true(blown > 0.6 && blown < 1);
        assert_true(other < -0.6 && other > -1);
        assert_true(fabs(calm) < 0.15);
        assert_true(leeward(3, q) < blown - 0.2);
    }
}

static void gusts_come_from_the_wind_and_never_turn_it(void **state) {
    (void)state;
    scene_fields fields = {.wind = 10, .wind_origin = -3};
    double least = 1e9, most = 0;
    for (int step = 0; step < 5000; step++) {
        double here = scene_wind_at(&fields, step, 2);
        least = fmin(least, here);
        most = fmax(most, here);
        /* A gust travels 5 m in 20 steps. */
        assert_true(scene_wind_at(&fields, step + 20, 7) == here);
        assert_true(fabs(scene_wind_at(&fields, step + 1, 2) - here) < 0.35);
    }
    assert_true(least > 1.9 && least < 4 && most > 16 && most < 18.1);
    fields.wind = -10;
    assert_true(scene_wind_at(&fields, 40, 7) == scene_wind_at(&fields, 60, 2));
}

/* ---- explosions ---- */

static double speed(const stage *t, int index) {
    thud_body_state b = body(t, index);
    return hypot(b.velocity.x, b.velocity.y);
}

static void crates_behind_the_wall_are_slower_than_their_twins(void **state) {
    (void)state;
    enum { FIRST = 3, PAIRS = 20, ROWS = 4 };
    for (int q = 0; q < QUALITIES; q++) {
        stage t = open_stage("explosion", 2 * PAIRS, qualities[q]);
        run_whole(&t, t.scene.fields.blasts[0].step + 1);
        double open = 0, covered = 0;
        for (int i = 0; i < PAIRS; i++) {
            double left = speed(&t, FIRST + 2 * i), right = speed(&t, FIRST + 2 * i + 1);
            assert_true(right < 0.5);
            if (i < ROWS) /* no wall covers the left crate of the lower rows */
                assert_true(left > 4 && left > 20 * right);
            open += left;
            covered += right;
        }
        assert_true(open > 30 * covered);
        run_whole(&t, t.scene.fields.blasts[1].step - t.scene.fields.blasts[0].step);
        /* the second blast is above the wall, which does not cover the right crates from it */
        double thrown = 0;
        for (int i = 0; i < PAIRS; i++)
            thrown = fmax(thrown, speed(&t, FIRST + 2 * i + 1));
        assert_true(thrown > 4);
        run_whole(&t, 900);
        close_stage(&t);
    }
}

/* ---- all scenes of fields ---- */

static void restored_scene_goes_on_with_its_fields(void **state) {
    (void)state;
    static const char *const names[] = {"boats", "flags", "explosion"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++)
        restored_goes_on(names[n], 200, 60);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boats_float_at_their_draught_with_their_cargo),
        cmocka_unit_test(flags_blow_to_leeward_and_hang_in_a_calm),
        cmocka_unit_test(gusts_come_from_the_wind_and_never_turn_it),
        cmocka_unit_test(crates_behind_the_wall_are_slower_than_their_twins),
        cmocka_unit_test(restored_scene_goes_on_with_its_fields),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
