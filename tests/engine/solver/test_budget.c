/* test_budget.c: the time budget of a world, which lowers and raises the number of substeps. Times
 * come from a clock that the test controls. */
#include "engine_support.h"

/* The world's clock: each step takes `fixed` seconds and `per_substep` for each substep, all in the
 * solver's stage. */
typedef struct fake {
    thud_world *world;
    double now, fixed, per_substep;
    int calls;
} fake;

static double read_fake(void *context) {
    fake *f = context;
    if (f->calls++ % (THUD_STAGE_COUNT + 1) == THUD_STAGE_SOLVE + 1) {
        f->now += f->fixed + f->per_substep * thud_stats_of(f->world).substeps;
    }
    return f->now;
}

/* A def with this time budget, and the controlled clock. */
static thud_world_def budget_of(double seconds, int substeps, fake *f) {
    thud_world_def def = thud_default_world_def();
    def.time_budget = seconds;
    def.substeps = substeps;
    def.sleeping = false;
    def.clock = read_fake;
    def.clock_context = f;
    return def;
}

/* The number of substeps after that many steps. */
static int substeps_after(fake *f, int steps) {
    run(f->world, steps);
    return thud_stats_of(f->world).substeps;
}

static void budget_without_a_clock_or_out_of_range_is_refused(void **state) {
    (void)state;
    fake f = {0};
    thud_world *world = NULL;
    thud_world_def def = budget_of(0.01, 4, &f);
    def.clock = NULL;
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    const double bad[] = {-0.001, 1.001, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        def = budget_of(bad[i], 4, &f);
        assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    }
    assert_null(world);
}

static void substeps_halve_until_steps_are_within_the_budget(void **state) {
    (void)state;
    fake f = {.fixed = 1e-3, .per_substep = 1e-3};
    f.world = make_world(budget_of(4e-3, 8, &f));
    assert_int_equal(substeps_after(&f, 1), 8);
    assert_int_equal(substeps_after(&f, 9), 4);
    assert_int_equal(substeps_after(&f, 9), 2);
    assert_int_equal(substeps_after(&f, 200), 2);
    f.per_substep = 1;
    assert_int_equal(substeps_after(&f, 200), 1);
    thud_world_destroy(f.world);
}

static void substeps_rise_again_when_there_is_time_and_not_beyond_the_quality(void **state) {
    (void)state;
    fake f = {.fixed = 0.9e-3, .per_substep = 1e-3};
    f.world = make_world(budget_of(4e-3, 6, &f));
    assert_int_equal(substeps_after(&f, 60), 3);
    f.per_substep = 0.05e-3;
    assert_int_equal(substeps_after(&f, 60), 6);
    thud_world_destroy(f.world);
}

/* A single step over the budget among eight that are within it does not change the substeps. */
static void one_slow_step_changes_nothing(void **state) {
    (void)state;
    fake f = {.fixed = 1e-3};
    f.world = make_world(budget_of(4e-3, 8, &f));
    for (int i = 0; i < 100; i++) {
        f.fixed = i % 9 == 4 ? 0.5 : 1e-3;
        assert_int_equal(substeps_after(&f, 1), 8);
    }
    thud_world_destroy(f.world);
}

/* Where four substeps are 5 % over the budget, with noise, the number changes once and then
 * stays. */
static void load_about_the_budget_does_not_make_quality_flutter(void **state) {
    (void)state;
    uint64_t seed = 3;
    fake f = {.fixed = 0};
    f.world = make_world(budget_of(4e-3, 4, &f));
    int changes = 0, before = 4;
    for (int i = 0; i < 2000; i++) {
        f.per_substep = 1.05e-3 * random_in(&seed, 0.9, 1.1);
        int now = substeps_after(&f, 1);
        changes += now != before;
        before = now;
    }
    assert_int_equal(before, 2);
    assert_int_equal(changes, 1);
    thud_world_destroy(f.world);
}

static void world_without_a_budget_takes_the_time_it_needs(void **state) {
    (void)state;
    fake f = {.per_substep = 1};
    f.world = make_world(budget_of(0, 8, &f));
    assert_int_equal(substeps_after(&f, 100), 8);
    thud_world_destroy(f.world);
}

static double fastest_in(thud_world *world, const thud_body_id *box, int count) {
    double fastest = 0;
    for (int i = 0; i < count; i++) {
        thud_vec2 v = state_of(world, box[i]).velocity;
        fastest = fmax(fastest, hypot((double)v.x, (double)v.y));
    }
    return fastest;
}

/* A stack at rest stays at rest while the budget lowers and raises the substeps. */
static void stack_stays_calm_while_substeps_change(void **state) {
    (void)state;
    fake f = {.per_substep = 1e-4};
    thud_body_id box[5];
    f.world = make_world(budget_of(4e-3, 4, &f));
    add_floor(f.world, NULL);
    for (int i = 0; i < 5; i++) {
        box[i] = add_box(f.world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    assert_int_equal(substeps_after(&f, 120), 4);
    f.per_substep = 1.2e-3; /* 4.8 ms a step: falls to 2 substeps */
    double fastest = 0;
    for (int i = 0; i < 60; i++) {
        run(f.world, 1);
        fastest = fmax(fastest, fastest_in(f.world, box, 5));
        f.per_substep = i == 30 ? 1e-4 : f.per_substep; /* and rises again */
        assert_true(i != 30 || thud_stats_of(f.world).substeps == 2);
    }
    assert_int_equal(thud_stats_of(f.world).substeps, 4);
    /* it settles a little; with impulses scaled for the wrong substep it would jump */
    assert_true(fastest < 0.1);
    thud_world_destroy(f.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(budget_without_a_clock_or_out_of_range_is_refused),
        cmocka_unit_test(substeps_halve_until_steps_are_within_the_budget),
        cmocka_unit_test(substeps_rise_again_when_there_is_time_and_not_beyond_the_quality),
        cmocka_unit_test(one_slow_step_changes_nothing),
        cmocka_unit_test(load_about_the_budget_does_not_make_quality_flutter),
        cmocka_unit_test(world_without_a_budget_takes_the_time_it_needs),
        cmocka_unit_test(stack_stays_calm_while_substeps_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
