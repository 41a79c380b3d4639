/* test_resting_shapes.c: bodies that fall asleep beside many static shapes, and wake, leave the
 * grid of the shapes at rest as it was sorted; what is found in it is what all pairs find. */
#include "engine_support.h"

#include <thud/thud_queries.h>
#include <thud/thud_reads.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_testing.h>

#include "state/world.h"

#include <stdlib.h>

/* Static tiles, and balls that lie on them, one on every third. */
enum { TILES = 400, BALLS = 130, FOUND_MAX = TILES + BALLS };

/* Bodies fall asleep in one of so many steps (islands/sleep.c). */
enum { STEPS_TO_SLEEP = 8 };

typedef struct yard {
    thud_world *world;
    thud_body_id balls[BALLS];
} yard;

static yard make_yard(const thud_broadphase *broadphase) {
    thud_world_def def = thud_default_world_def();
    def.broadphase = broadphase;
    yard y = {.world = make_world(def)};
    for (int i = 0; i < TILES; i++) {
        thud_body_id tile = add_body(y.world, THUD_BODY_STATIC, i, -0.5, 0);
        add_shape(y.world, tile, 0.5f, 0.5f, true, NULL);
    }
    for (int i = 0; i < BALLS; i++) {
        y.balls[i] = add_ball(y.world, 3 * i + 0.5, 0.25, 0.25f);
    }
    return y;
}

static int by_index(const void *a, const void *b) {
    const thud_shape_id *x = a, *y = b;
    return (x->index1 > y->index1) - (x->index1 < y->index1);
}

/* What a query found. */
typedef struct found {
    thud_shape_id shapes[FOUND_MAX];
    int count;
} found;

static bool note(thud_shape_id shape, void *context) {
    found *f = context;
    assert_true(f->count < FOUND_MAX);
    f->shapes[f->count++] = shape;
    return true;
}

/* The shapes that overlap a box about a point, in the order of their indices. */
static found find(thud_world *world, double x, double half) {
    found f = {.count = 0};
    OK(thud_world_overlap_aabb(world, (thud_pos){x - half, -half}, (thud_pos){x + half, half}, NULL,
                               note, &f));
    qsort(f.shapes, (size_t)f.count, sizeof *f.shapes, by_index);
    return f;
}

/* Both worlds find the same around some places, near and wider than all that there is. */
static void find_the_same(thud_world *a, thud_world *b) {
    const double halves[] = {0.6, 5, 900, 1e5, 1e7};
    for (size_t k = 0; k < sizeof halves / sizeof *halves; k++) {
        for (int i = 0; i < 5; i++) {
            found in_a = find(a, 90 * i, halves[k]), in_b = find(b, 90 * i, halves[k]);
            assert_int_equal(in_a.count, in_b.count);
            for (int at = 0; at < in_a.count; at++) {
                assert_int_equal(in_a.shapes[at].index1, in_b.shapes[at].index1);
            }
        }
    }
}

static int count_of_none(const thud_world *world) {
    int count = 0;
    for (int i = 0; i < world->rest_shapes.ids.count; i++) {
        count += td_int_at(&world->rest_shapes.ids, i) == TD_NONE;
    }
    return count;
}

/* Shapes that stand in no cell: those of the level without a cell width. */
static int strays_of(const thud_world *world) {
    int strays = 0;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &world->rest_shapes.levels[l];
        strays += level->cell == 0 ? level->count : 0;
    }
    return strays;
}

/* Some balls are put to sleep, five at a time, before the others fall asleep by themselves;
 * then every third of them wakes. */
static void bodies_fall_asleep_and_wake_without_a_sort(void **state) {
    (void)state;
    enum { ROUNDS = 3, SOME = 5, NAPS = ROUNDS * SOME, EVERY = 3 };
    yard grid = make_yard(&thud_broadphase_grid), all = make_yard(&thud_broadphase_all);
    yard *yards[] = {&grid, &all};
    for (int y = 0; y < 2; y++) {
        for (int i = NAPS; i < BALLS; i++) {
            OK(thud_body_destroy(yards[y]->world, yards[y]->balls[i]));
        }
        run(yards[y]->world, 2);
    }
    for (int round = 0; round < ROUNDS; round++) {
        for (int y = 0; y < 2; y++) {
            for (int i = round * SOME; i < (round + 1) * SOME; i++) {
                OK(thud_body_set_awake(yards[y]->world, yards[y]->balls[i], false));
            }
            run(yards[y]->world, STEPS_TO_SLEEP);
        }
        assert_true(grid.world->rest_shapes.valid);
        assert_int_equal(strays_of(grid.world), (round + 1) * SOME);
    }
    find_the_same(grid.world, all.world);
    for (int y = 0; y < 2; y++) {
        for (int i = 0; i < NAPS; i += EVERY) {
            OK(thud_body_set_awake(yards[y]->world, yards[y]->balls[i], true));
        }
        run(yards[y]->world, 1);
    }
    assert_true(grid.world->rest_shapes.valid);
    assert_int_equal(count_of_none(grid.world), SOME);
    find_the_same(grid.world, all.world);
    assert_true(thud_hash_of(grid.world) == thud_hash_of(all.world));
    thud_world_destroy(grid.world);
    thud_world_destroy(all.world);
}

/* Bodies fall asleep and wake at random, are pushed and removed. Halfway a snapshot is taken, from
 * which another world goes on with the same counts of what is tested. */
static void random_naps_find_what_all_pairs_find(void **state) {
    (void)state;
    enum { STEPS = 120 };
    yard grid = make_yard(&thud_broadphase_grid), all = make_yard(&thud_broadphase_all);
    yard other = make_yard(&thud_broadphase_grid), *yards[] = {&grid, &all, &other};
    int kept = 0, most_strays = 0, sorts = 0;
    uint64_t seed = 7;
    for (int step = 0; step < STEPS; step++) {
        if (step == STEPS / 2) {
            size_t bytes;
            OK(thud_world_get_snapshot_size(grid.world, &bytes));
            void *snapshot = malloc(bytes);
            OK(thud_world_snapshot(grid.world, snapshot, bytes, &bytes));
            OK(thud_world_restore(other.world, snapshot, bytes));
            memcpy(other.balls, grid.balls, sizeof other.balls);
            free(snapshot);
        }
        for (int k = 0; k < 4; k++) {
            int i = (int)random_in(&seed, 0, BALLS), what = (int)random_in(&seed, 0, 9);
            for (int y = 0; y < 3; y++) {
                thud_body_id ball = yards[y]->balls[i];
                if (what < 8 || !thud_body_is_valid(yards[y]->world, ball)) {
                    (void)thud_body_set_awake(yards[y]->world, ball, what > 4);
                } else if (step % 16 == 0) {
                    OK(thud_body_destroy(yards[y]->world, ball));
                } else {
                    OK(thud_body_set_velocity(yards[y]->world, ball, (thud_vec2){1, 2}, 0));
                }
            }
        }
        for (int y = 0; y < 3; y++) {
            run(yards[y]->world, 1);
        }
        assert_true(thud_hash_of(grid.world) == thud_hash_of(all.world));
        kept += grid.world->rest_shapes.valid;
        sorts += strays_of(grid.world) == 0;
        most_strays = strays_of(grid.world) > most_strays ? strays_of(grid.world) : most_strays;
        if (step >= STEPS / 2) {
            thud_broadphase_counts a, b;
            OK(thud_world_get_broadphase_counts(grid.world, &a));
            OK(thud_world_get_broadphase_counts(other.world, &b));
            assert_true(thud_hash_of(grid.world) == thud_hash_of(other.world));
            assert_int_equal(a.tested, b.tested);
        }
        if (step % 10 == 9) {
            find_the_same(grid.world, all.world);
        }
    }
    assert_true(kept > STEPS / 2);
    assert_true(most_strays > TD_STRAYS_MAX / 2);
    assert_true(sorts > 1);
    for (int y = 0; y < 3; y++) {
        thud_world_destroy(yards[y]->world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_fall_asleep_and_wake_without_a_sort),
        cmocka_unit_test(random_naps_find_what_all_pairs_find),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
