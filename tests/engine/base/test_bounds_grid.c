/* test_bounds_grid.c: searches of a grid of boxes find what a comparison with each box finds: for
 * boxes of like and of very different sizes, spread and crowded, across the seam at which bounds
 * wrap around, and with boxes and searches without bounds. */
#include "engine_support.h"
#include "share.h"

#include "base/bounds_grid.h"

enum { BOXES_MAX = 300, SEARCHES = 60, ROUNDS = 300 };

/* A whole number in [-half, half]. */
static int32_t within(uint64_t *seed, double half) {
    return (int32_t)random_in(seed, -half, half);
}

/* A box about a place near `center`, of sides that differ by up to a factor of e^spread. */
static td_bounds random_box(uint64_t *seed, int32_t center, double area, double side,
                            double spread) {
    double width = side * exp(random_in(seed, 0, spread)), height = side * random_in(seed, 0, 1);
    int32_t x = td_wrap_add(center, within(seed, area)), y = within(seed, area);
    return (td_bounds){x, y, td_wrap_add(x, (int32_t)width), td_wrap_add(y, (int32_t)height)};
}

/* Fails unless `found` has each id once that a comparison of all boxes finds. Returns how many. */
static int compare(const td_bounds *boxes, const bool *everywhere, int count, const td_bounds *b,
                   td_array *found) {
    int next = 0;
    td_sort_ints(found);
    for (int i = 0; i < count; i++) {
        if (!b || everywhere[i] || td_bounds_overlap(&boxes[i], b)) {
            if (next >= found->count || td_int_at(found, next) != i) {
                fail_msg("box %d of %d is not found once", i, count);
            }
            next++;
        }
    }
    assert_int_equal(next, found->count);
    return next;
}

static void searches_find_what_overlaps(void **state) {
    (void)state;
    td_memory memory = td_memory_make((thud_allocator){0});
    td_bounds_grid grid = {.boxes = {.stride = sizeof(td_boxed)}, .ends = {.stride = sizeof(int)}};
    td_array found = {.stride = sizeof(int)};
    td_bounds boxes[BOXES_MAX];
    bool everywhere[BOXES_MAX];
    uint64_t seed = 42;
    long hits = 0, narrow = 0;
    assert_true(td_array_reserve(&memory, &found, BOXES_MAX));
    for (int round = 0; round < share_of(ROUNDS); round++) {
        int count = (int)random_in(&seed, 0, BOXES_MAX + 1);
        int32_t center = round % 3 == 0 ? INT32_MAX : within(&seed, 2e9);
        double side = exp(random_in(&seed, 0, 16)), area = side * exp(random_in(&seed, 0, 5));
        double spread = round % 2 ? 0 : random_in(&seed, 0, 4);
        area = fmin(area, 2.1e9);
        assert_true(td_bounds_grid_reserve(&memory, &grid, count));
        for (int i = 0; i < count; i++) {
            boxes[i] = random_box(&seed, center, area, side, spread);
            everywhere[i] = round % 5 == 0 && i % 40 == 0;
            td_bounds_grid_add(&grid, everywhere[i] ? NULL : &boxes[i], i);
        }
        td_bounds_grid_build(&grid);
        for (int k = 0; k < SEARCHES; k++) {
            td_bounds b = random_box(&seed, center, area, side, k % 4 ? 0 : 4);
            found.count = 0;
            td_bounds_grid_find(&grid, k ? &b : NULL, &found);
            int here = compare(boxes, everywhere, count, k ? &b : NULL, &found);
            hits += k ? here : 0;
            narrow += k && here > 0 && here < count / 4;
        }
    }
    /* The boxes were neither all apart nor all in one place. */
    assert_true(hits > 0 && narrow > 0);
    td_array_free(&memory, &found);
    td_array_free(&memory, &grid.boxes);
    td_array_free(&memory, &grid.ends);
    assert_int_equal(memory.bytes, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(searches_find_what_overlaps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
