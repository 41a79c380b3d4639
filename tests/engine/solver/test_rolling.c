/* test_rolling.c: discs that roll down slopes, against mechanics: a disc of inertia m r^2 / 2 that
 * does not slip accelerates by 2/3 g sin(a). No quality deviates more than a lower one. */
#include "engine_support.h"

enum { SECONDS = 4 };

/* Deviation of the disc's position after SECONDS, and its slip velocity. */
typedef struct off {
    double way, slip;
} off;

/* Rolls a disc down a slope, and measures its deviation. */
static off roll(const thud_quality *quality, double degrees) {
    double angle = degrees * 3.14159265358979323846 / 180, c = cos(angle), s = sin(angle);
    thud_world_def def = thud_default_world_def();
    thud_shape_def rough = thud_default_shape_def();
    def.quality = quality;
    def.sleeping = false;
    rough.friction = 0.5f;
    thud_world *world = make_world(def);
    add_shape(world, add_body(world, THUD_BODY_STATIC, 0, 0, -angle), 200, 0.5f, false, &rough);
    thud_body_id disc = add_body(world, THUD_BODY_DYNAMIC, s, c, 0);
    add_shape(world, disc, 0.5f, 0, false, &rough);
    run(world, 60 * SECONDS);
    thud_body_state end = state_of(world, disc);
    double way = 0.5 * (2.0 / 3.0) * 10 * s * SECONDS * SECONDS;
    double speed = (double)end.velocity.x * c - (double)end.velocity.y * s;
    off o = {hypot(end.position.x - s - way * c, end.position.y - c + way * s),
             fabs(speed + 0.5 * (double)end.angular_velocity)};
    thud_world_destroy(world);
    return o;
}

static void disc_rolls_no_further_off_at_a_higher_quality(void **state) {
    (void)state;
    for (int degrees = 10; degrees <= 40; degrees += 10) {
        off last = {1, 1};
        for (int i = 0; i < QUALITIES; i++) {
            off now = roll(qualities[i], degrees);
            if (now.way > last.way + 1e-4 || now.slip > last.slip + 1e-4) {
                fail_msg("%d degrees, quality %d: off by %g after %g, slips %g after %g", degrees,
                         i, now.way, last.way, now.slip, last.slip);
            }
            last = now;
        }
        assert_true(last.way < 1e-4 && last.slip < 1e-4);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(disc_rolls_no_further_off_at_a_higher_quality),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
