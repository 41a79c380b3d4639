/* test_swept.c: tests that a world that chooses swept detection errs no more than the same world
 * under continuous detection, in every case of the trade-off and at every quality. Exact is swept
 * by itself. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "yardstick.h"

#include <thud/thud_detection.h>
#include <thud/thud_quality.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where swept errs more: the largest error, rounded up, and why. Bodies that joints tie together
 * are held where one of them meets something in the step, and joints open by what they then
 * lack. */
static const struct known_miss {
    const char *name;
    const thud_quality *quality;
    double error;
} KNOWN_MISSES[] = {
    {"ragdolls", &thud_quality_default, 6e-3},
    {"cars", &thud_quality_high, 3e-5},
};

/* The error of a whole run of a case. */
static double error_of_run(const tradeoff_case *c, const thud_quality *quality,
                           const thud_detection *detection) {
    scene s;
    assert_true(case_fill(c, false, &s));
    engine_settings with = {.quality = quality,
                            .detection = detection,
                            .time_step = ENGINE_TIME_STEP};
    void *world = engine_create(&engine_thud, &s, with);
    engine_body *bodies = calloc((size_t)s.body_count, sizeof *bodies);
    yardstick *y = yardstick_create(c, &s);
    assert_non_null(world);
    assert_non_null(bodies);
    assert_non_null(y);
    engine_thud.read(world, bodies);
    assert_true(yardstick_begin(y, bodies));
    for (int step = 1; step <= c->steps; step++) {
        assert_true(engine_thud.step(world));
        engine_thud.read(world, bodies);
        assert_true(yardstick_look(y, bodies, step * ENGINE_TIME_STEP));
    }
    double error = yardstick_conclude(y).error;
    yardstick_destroy(y);
    free(bodies);
    engine_thud.destroy(world);
    scene_free(&s);
    return error;
}

/* The error that swept may have: that of continuous, or the one that counts as none; where motion
 * is chaotic, a fifth more. */
static double allowed(const tradeoff_case *c, const thud_quality *quality) {
    for (size_t i = 0; i < sizeof KNOWN_MISSES / sizeof KNOWN_MISSES[0]; i++) {
        if (!strcmp(KNOWN_MISSES[i].name, c->name) && KNOWN_MISSES[i].quality == quality)
            return KNOWN_MISSES[i].error;
    }
    return fmax(c->floor, c->chance * error_of_run(c, quality, &thud_detection_continuous));
}

static void swept_errs_no_more_than_continuous(void **state) {
    const thud_quality *quality = *state;
    for (int i = 0; i < cases_count(); i++) {
        const tradeoff_case *c = cases_at(i);
        double error = error_of_run(c, quality, &thud_detection_swept);
        double most = allowed(c, quality);
        if (!(error <= most))
            fail_msg("%s at %s: %g under swept, of %g", c->name, quality->name, error, most);
    }
}

#define AT(quality)                                                                            \
    {                                                                                          \
        "swept_errs_no_more_than_continuous_at_" #quality, swept_errs_no_more_than_continuous, \
            NULL, NULL, (void *)(uintptr_t)&thud_quality_##quality                             \
    }

int main(void) {
    const struct CMUnitTest tests[] = {AT(draft), AT(default), AT(high)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
