/* test_islands_forces.c: contact forces of bodies at rest, in islands that are solved directly,
 * against those of the oracle, an independent reference simulation. */
#include "engine_support.h"

#include "build_thud.h"
#include "oracle.h"
#include "scenes.h"

#define STEP (1.0 / 60)

enum { PAIRS_MOST = 64 };

/* The force of a pair of bodies; body_a is the one with the lower number. */
typedef struct force {
    int body_a, body_b;
    double x, y; /* N, on b */
} force;

typedef struct forces {
    force at[PAIRS_MOST];
    int count;
} forces;

/* Adds a force on b to that of the pair. */
static void add_force(forces *f, int a, int b, double x, double y) {
    int sign = a < b ? 1 : -1, low = a < b ? a : b, high = a < b ? b : a, i = 0;
    while (i < f->count && (f->at[i].body_a != low || f->at[i].body_b != high)) {
        i++;
    }
    if (i == f->count) {
        assert_in_range(i, 0, PAIRS_MOST - 1);
        f->at[f->count++] = (force){.body_a = low, .body_b = high};
    }
    f->at[i].x += sign * x;
    f->at[i].y += sign * y;
}

/* A world numbers its bodies in the order of the scene. */
static void note(thud_world *world, const thud_contact *c, void *context) {
    (void)world;
    double n = (double)c->normal_impulse / STEP, t = (double)c->tangent_impulse / STEP;
    double x = (double)c->normal.x, y = (double)c->normal.y;
    add_force(context, (int)c->body_a.index1 - 1, (int)c->body_b.index1 - 1, n * x + t * y,
              n * y - t * x);
}

/* The contact forces in one step after 180 steps, when the scene is at rest. */
static forces forces_of_thud(const scene *s, const thud_quality *quality) {
    forces found = {.count = 0};
    thud_world_def def = thud_default_world_def();
    thud_world *world;
    def.quality = quality;
    def.sleeping = false;
    OK(scene_build_thud(s, &def, &world, NULL, NULL));
    set_listeners(world, NULL, note, &found);
    run(world, 180);
    found.count = 0;
    memset(found.at, 0, sizeof found.at);
    run(world, 1);
    assert_int_equal(thud_stats_of(world).soft_islands, 0);
    assert_true(thud_stats_of(world).direct_islands > 0);
    thud_world_destroy(world);
    return found;
}

/* The oracle's contact forces after one second. */
static forces forces_of_oracle(const scene *s) {
    forces found = {.count = 0};
    oracle *o = oracle_create(s, &(oracle_settings){1.0 / 240, 0.01});
    assert_non_null(o);
    assert_true(oracle_advance(o, 1));
    int count;
    const oracle_force *at = oracle_forces(o, &count);
    assert_non_null(at);
    for (int i = 0; i < count; i++) {
        add_force(&found, at[i].body_a, at[i].body_b,
                  at[i].normal * at[i].normal_x + at[i].tangent * at[i].normal_y,
                  at[i].normal * at[i].normal_y - at[i].tangent * at[i].normal_x);
    }
    oracle_destroy(o);
    return found;
}

/* Asserts that the forces between each two bodies agree within a thousandth of the greatest. */
static void assert_same_forces(const scene *s) {
    const thud_quality *const direct[] = {&thud_quality_high, &thud_quality_exact};
    forces right = forces_of_oracle(s);
    for (int q = 0; q < 2; q++) {
        forces ours = forces_of_thud(s, direct[q]);
        double most = 0;
        for (int i = 0; i < right.count; i++) {
            most = fmax(most, hypot(right.at[i].x, right.at[i].y));
        }
        assert_true(most > 0);
        assert_int_equal(ours.count, right.count);
        for (int i = 0; i < right.count; i++) {
            const force *f = &right.at[i];
            add_force(&ours, f->body_a, f->body_b, -f->x, -f->y);
        }
        assert_int_equal(ours.count, right.count);
        for (int i = 0; i < ours.count; i++) {
            near_to(hypot(ours.at[i].x, ours.at[i].y) / most, 0, 1e-3);
        }
    }
}

static void islands_press_as_in_the_oracle_in_a_column(void **state) {
    (void)state;
    for (int size = 1; size <= 40; size += 13) {
        scene s;
        assert_true(scenes_fill(&scene_tall_stack, size, &s));
        assert_same_forces(&s);
        scene_free(&s);
    }
}

static void islands_press_as_in_the_oracle_where_heavy_is_on_light(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(&scene_heavy_on_light, 1, &s));
    for (int i = 0; i < s.shape_count; i++) {
        s.shapes[i].material.density = s.shapes[i].material.density > 1 ? 1e5 : 1;
    }
    assert_same_forces(&s);
    scene_free(&s);
}

/* A plank on two static balls, with a load off its centre. */
static void islands_press_as_in_the_oracle_under_a_plank(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_add_body(&s, SCENE_STATIC, -1, -0.5);
    scene_add_circle(&s, 0.5);
    scene_add_body(&s, SCENE_STATIC, 1.5, -0.5);
    scene_add_circle(&s, 0.5);
    scene_dynamic_box(&s, 0, 0.5, 2, 0.5);
    scene_dynamic_box(&s, 0.75, 1.5, 0.5, 0.5);
    s.shapes[3].material.density = 3;
    assert_same_forces(&s);
    scene_free(&s);
}

/* One ball on two in a groove of 90 degrees; without friction, since with it the forces would not
 * be unique. */
static void islands_press_as_in_the_oracle_in_a_wedge(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    s.material.friction = 0;
    const scene_point groove[] = {{-8, 8}, {0, 0}, {8, 8}};
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_irregular(&s, groove, 3);
    /* A wall at 45 degrees touches a circle of radius 1 at x = 1 where it is at 1 + sqrt(2). */
    scene_dynamic_circle(&s, -1, 0, 1)->y = 1 + sqrt(2);
    scene_dynamic_circle(&s, 1, 0, 1)->y = 1 + sqrt(2);
    scene_dynamic_circle(&s, 0, 0, 1)->y = 1 + sqrt(2) + sqrt(3);
    assert_same_forces(&s);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(islands_press_as_in_the_oracle_in_a_column),
        cmocka_unit_test(islands_press_as_in_the_oracle_where_heavy_is_on_light),
        cmocka_unit_test(islands_press_as_in_the_oracle_under_a_plank),
        cmocka_unit_test(islands_press_as_in_the_oracle_in_a_wedge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
