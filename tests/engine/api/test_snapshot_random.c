/* test_snapshot_random.c: a random game that is restored from any of its snapshots and played again
 * is the same. */
#include "snapshot_support.h"

/* The input of a player in step `time`; the same each time that it is played. */
static void play(const yard *y, int time) {
    uint64_t seed = 88172645463325252u + (uint64_t)time * 977;
    for (int i = 0; i < 8; i++) {
        random_in(&seed, 0, 1);
    }
    double x = random_in(&seed, -12, 12), dice = random_in(&seed, 0, 1);
    thud_body_id some = y->heap[(int)random_in(&seed, 0, 11.9)];
    if (dice < 0.2) {
        add_box(y->world, x, 12, 0.4f, 0.3f);
    } else if (dice < 0.3) {
        OK(thud_shape_dig(y->world, y->ground, (thud_pos){x, 0.5}, 0.8));
    } else if (dice < 0.4 && thud_body_is_valid(y->world, some)) {
        OK(thud_body_destroy(y->world, some));
    } else if (dice < 0.7 && thud_body_is_valid(y->world, some)) {
        OK(thud_body_set_velocity(y->world, some, (thud_vec2){(float)x, 6}, 1));
    }
}

static void random_play_rewound_and_repeated_is_the_same(void **state) {
    (void)state;
    enum { TIMES = 160, EVERY = 20 };
    const thud_detection *const detections[] = {NULL, &thud_detection_swept};
    for (int d = 0; d < 2; d++) {
        thud_world_def def = thud_default_world_def();
        def.detection = detections[d];
        yard y = make_yard(&def);
        saved kept[TIMES / EVERY];
        uint64_t digests[TIMES], seed = 1234567;
        for (int time = 0; time < TIMES; time++) {
            if (time % EVERY == 0) {
                kept[time / EVERY] = save(y.world);
            }
            play(&y, time);
            run(y.world, 1);
            digests[time] = digest_of(y.world);
        }
        for (int round = 0; round < 12; round++) {
            int at = (int)random_in(&seed, 0, TIMES / EVERY - 0.1);
            int steps = (int)random_in(&seed, 1, 50);
            back_to(y.world, kept[at]);
            for (int time = at * EVERY; time < TIMES && steps > 0; time++, steps--) {
                play(&y, time);
                run(y.world, 1);
                assert_int_equal(digest_of(y.world), digests[time]);
            }
        }
        for (int i = 0; i < TIMES / EVERY; i++) {
            free(kept[i].bytes);
        }
        thud_world_destroy(y.world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_play_rewound_and_repeated_is_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
