/* test_terrain_lookup.c: terrain look-up: how many vertices it reads, texture coordinates, and a
 * foot placed on the ground. */
#define _DEFAULT_SOURCE
#include "engine_support.h"

#include <thud/thud_terrain.h>

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#define NEAR(a, b) near_to((a), (b), 1e-12)

/* Up to a peak at 2, down to a valley at 6, up again. */
static const thud_pos hills[] = {{0, 0}, {2, 2}, {6, -2}, {10, 0}};
static const thud_terrain irregular = {.kind = THUD_TERRAIN_IRREGULAR, .points = hills, .count = 4};

static const thud_pos steps[] = {{0, 1}, {0, 1}, {0, 3}, {0, 1}};
static const thud_terrain uniform = {
    .kind = THUD_TERRAIN_UNIFORM, .x0 = -2, .spacing = 2, .points = steps, .count = 4};

static const thud_terrain flat = {.kind = THUD_TERRAIN_FLAT, .slope = 0.75};

/* ---- reads of a look-up: points are in protected memory, and each page that is touched is counted
 * ---- */

enum { VERTICES = 100000 };

/* Points of the terrain in protected memory, and the pages that were touched. */
static thud_pos *watched;
static size_t watched_bytes, page_bytes;
static volatile sig_atomic_t pages_read;

/* Signal handler: makes the touched page accessible, and counts it. */
static void open_page(int signal_number, siginfo_t *info, void *context) {
    (void)context;
    char *at = info->si_addr, *start = (char *)watched;
    if (at < start || at >= start + watched_bytes) {
        signal(signal_number, SIG_DFL);
        return;
    }
    pages_read++;
    mprotect(start + (size_t)(at - start) / page_bytes * page_bytes, page_bytes, PROT_READ);
}

/* Makes the protected vertices, from x = 0 on, one to two apart, on a parabola. */
static int make_watched(void **state) {
    (void)state;
    uint64_t seed = 7;
    page_bytes = (size_t)sysconf(_SC_PAGESIZE);
    watched_bytes = VERTICES * sizeof(thud_pos);
    watched = mmap(NULL, watched_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (watched == MAP_FAILED) {
        return 1;
    }
    for (int i = 0; i < VERTICES; i++) {
        double x = i ? watched[i - 1].x + random_in(&seed, 1.0, 2.0) : 0.0;
        watched[i] = (thud_pos){x, 1e-6 * x * x};
    }
    return 0;
}

static int free_watched(void **state) {
    (void)state;
    return munmap(watched, watched_bytes);
}

/* How many pages of vertices one look-up reads. */
static int pages_read_for(const thud_terrain *terrain, double x) {
    struct sigaction counting = {.sa_sigaction = open_page, .sa_flags = SA_SIGINFO};
    struct sigaction segv, bus; /* which signal it is depends on the system */
    thud_terrain_sample sample = {0};
    assert_int_equal(sigaction(SIGSEGV, &counting, &segv) | sigaction(SIGBUS, &counting, &bus), 0);
    assert_int_equal(mprotect(watched, watched_bytes, PROT_NONE), 0);
    pages_read = 0;
    thud_result result = thud_terrain_sample_at(terrain, x, &sample);
    int pages = pages_read;
    assert_int_equal(mprotect(watched, watched_bytes, PROT_READ), 0);
    assert_int_equal(sigaction(SIGSEGV, &segv, NULL) | sigaction(SIGBUS, &bus, NULL), 0);
    assert_int_equal(result, THUD_OK);
    if (terrain->kind == THUD_TERRAIN_IRREGULAR) {
        assert_true(watched[sample.segment].x <= x && x < watched[sample.segment + 1].x);
    }
    return pages;
}

/* A binary search of 100,000 makes 17 comparisons; then both ends of the line and of the segment
 * are read. */
static void irregular_lookup_among_100000_vertices_reads_20_at_most(void **state) {
    (void)state;
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = watched, .count = VERTICES};
    uint64_t seed = 11;
    double end = watched[VERTICES - 1].x;
    for (int i = 0; i < 200; i++) {
        assert_in_range(pages_read_for(&line, random_in(&seed, 0.0, end)), 1, 20);
    }
}

static void uniform_lookup_reads_the_two_vertices_of_the_segment(void **state) {
    (void)state;
    thud_terrain line = {.kind = THUD_TERRAIN_UNIFORM,
                         .spacing = 0.5,
                         .points = watched,
                         .count = VERTICES};
    uint64_t seed = 13;
    for (int i = 0; i < 200; i++) {
        double x = random_in(&seed, 0.0, 0.5 * (VERTICES - 1));
        assert_in_range(pages_read_for(&line, x), 1, 2);
    }
}

/* ---- texture coordinates ---- */

static thud_uv texture(const thud_terrain *terrain, double x, const thud_uv *uv, int count) {
    thud_terrain_sample sample;
    thud_uv out;
    OK(thud_terrain_sample_at(terrain, x, &sample));
    OK(thud_terrain_texture_at(&sample, uv, count, &out));
    return out;
}

static void texture_is_interpolated_between_the_vertices_on_both_sides(void **state) {
    (void)state;
    const thud_uv uv[] = {{0, 1}, {0.5, 0}, {2.5, 1}, {3, 3}};
    thud_uv at = texture(&irregular, 5, uv, 4); /* three quarters of the way from 1 to 2 */
    NEAR(at.u, 2.0);
    NEAR(at.v, 0.75);
    at = texture(&irregular, 10, uv, 4);
    NEAR(at.u, 3.0);
    NEAR(at.v, 3.0);
    at = texture(&uniform, -1.5, uv, 4);
    NEAR(at.u, 0.125);
    NEAR(at.v, 0.75);
}

static void texture_of_flat_ground_is_linear_in_x_everywhere(void **state) {
    (void)state;
    const thud_uv uv[] = {{0.25, 7}, {0.75, 7}};
    for (int x = -40; x <= 40; x++) {
        thud_uv at = texture(&flat, x, uv, 2);
        NEAR(at.u, 0.25 + 0.5 * x);
        NEAR(at.v, 7.0);
    }
}

static void texture_with_bad_input_is_refused_and_writes_nothing(void **state) {
    (void)state;
    const thud_uv uv[] = {{0, 0}, {1, NAN}, {2, 0}, {3, 0}};
    thud_terrain_sample sample, before = {.segment = -1, .weight = {1, 0}};
    thud_uv out = {5, 6};
    OK(thud_terrain_sample_at(&irregular, 8, &sample));
    assert_int_equal(thud_terrain_texture_at(NULL, uv, 4, &out), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_texture_at(&sample, NULL, 4, &out), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_texture_at(&sample, uv, 4, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_texture_at(&sample, uv, 3, &out), THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_texture_at(&sample, uv, -1, &out), THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_texture_at(&before, uv, 4, &out), THUD_ERROR_INVALID);
    OK(thud_terrain_sample_at(&irregular, 3, &sample));
    assert_int_equal(thud_terrain_texture_at(&sample, uv, 4, &out), THUD_ERROR_INVALID);
    assert_true(out.u == 5 && out.v == 6);
}

/* ---- a foot ---- */

static void foot_is(const thud_terrain *terrain, double x, double width, thud_foot wanted) {
    thud_foot foot;
    OK(thud_terrain_place_foot(terrain, x, width, &foot));
    NEAR(foot.height, wanted.height);
    NEAR(foot.x, wanted.x);
    NEAR(foot.nx, wanted.nx);
    NEAR(foot.ny, wanted.ny);
}

static void foot_on_a_slope_stands_on_its_upper_end(void **state) {
    (void)state;
    foot_is(&flat, 4, 2, (thud_foot){3.75, 5, -0.6, 0.8});
    foot_is(&irregular, 4, 1, (thud_foot){0.5, 3.5, sqrt(0.5), sqrt(0.5)});
}

static void foot_without_width_stands_on_the_sample(void **state) {
    (void)state;
    foot_is(&flat, 4, 0, (thud_foot){3, 4, -0.6, 0.8});
    foot_is(&irregular, 0, 0, (thud_foot){0, 0, -sqrt(0.5), sqrt(0.5)});
    foot_is(&irregular, 10, 0, (thud_foot){0, 10, -1 / sqrt(5), 2 / sqrt(5)});
}

static void foot_astride_a_peak_stands_on_it_and_leans_with_both_sides(void **state) {
    (void)state;
    foot_is(&irregular, 2, 2, (thud_foot){2, 2, 0, 1});
    /* From height 1.5 at 1.5 to 0 at 4. */
    foot_is(&irregular, 2.75, 2.5, (thud_foot){2, 2, 1.5 / hypot(1.5, 2.5), 2.5 / hypot(1.5, 2.5)});
}

static void foot_across_a_valley_stands_on_the_higher_side(void **state) {
    (void)state;
    foot_is(&irregular, 6, 4, (thud_foot){0, 4, 1 / sqrt(17), 4 / sqrt(17)});
}

static void foot_on_level_ground_stands_under_its_middle(void **state) {
    (void)state;
    foot_is(&uniform, -1.2, 0.8, (thud_foot){1, -1.2, 0, 1});
}

static void foot_beyond_an_end_counts_what_is_over_the_line(void **state) {
    (void)state;
    foot_is(&irregular, -0.5, 2, (thud_foot){0.5, 0.5, -sqrt(0.5), sqrt(0.5)});
    foot_is(&irregular, -1, 2, (thud_foot){0, 0, -sqrt(0.5), sqrt(0.5)});
    foot_is(&uniform, 4, 1, (thud_foot){1.5, 3.5, sqrt(0.5), sqrt(0.5)});
}

static void foot_is_never_under_the_ground_and_touches_it(void **state) {
    (void)state;
    uint64_t seed = 5;
    thud_pos points[60];
    for (int i = 0; i < 60; i++) {
        points[i] = (thud_pos){(i ? points[i - 1].x : 0) + random_in(&seed, 0.01, 2),
                               random_in(&seed, -3, 3)};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 60};
    for (int k = 0; k < 2000; k++) {
        double width = random_in(&seed, 0, 5), x = random_in(&seed, 3, points[59].x - 3);
        thud_foot foot;
        thud_terrain_sample sample;
        OK(thud_terrain_place_foot(&line, x, width, &foot));
        for (int i = 0; i <= 40; i++) {
            OK(thud_terrain_sample_at(&line, x + width * (i / 40.0 - 0.5), &sample));
            assert_true(sample.height <= foot.height + 1e-12);
        }
        OK(thud_terrain_sample_at(&line, foot.x, &sample));
        NEAR(sample.height, foot.height);
        assert_true(fabs(foot.x - x) <= 0.5 * width + 1e-12);
        NEAR(hypot(foot.nx, foot.ny), 1.0);
    }
}

static void foot_with_bad_input_is_refused_and_writes_nothing(void **state) {
    (void)state;
    thud_terrain none = {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1, .count = 3};
    thud_foot out = {1, 2, 3, 4};
    assert_int_equal(thud_terrain_place_foot(NULL, 0, 1, &out), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_place_foot(&none, 0, 1, &out), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_place_foot(&flat, 0, 1, NULL), THUD_ERROR_NULL);
    const double bad[][2] = {{NAN, 1}, {INFINITY, 1}, {0, NAN}, {0, INFINITY},
                             {0, -1},  {-1, 1.9},     {11, 1.9}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(thud_terrain_place_foot(&irregular, bad[i][0], bad[i][1], &out),
                         THUD_ERROR_INVALID);
    }
    assert_true(out.height == 1 && out.x == 2 && out.nx == 3 && out.ny == 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(irregular_lookup_among_100000_vertices_reads_20_at_most,
                                        make_watched, free_watched),
        cmocka_unit_test_setup_teardown(uniform_lookup_reads_the_two_vertices_of_the_segment,
                                        make_watched, free_watched),
        cmocka_unit_test(texture_is_interpolated_between_the_vertices_on_both_sides),
        cmocka_unit_test(texture_of_flat_ground_is_linear_in_x_everywhere),
        cmocka_unit_test(texture_with_bad_input_is_refused_and_writes_nothing),
        cmocka_unit_test(foot_on_a_slope_stands_on_its_upper_end),
        cmocka_unit_test(foot_without_width_stands_on_the_sample),
        cmocka_unit_test(foot_astride_a_peak_stands_on_it_and_leans_with_both_sides),
        cmocka_unit_test(foot_across_a_valley_stands_on_the_higher_side),
        cmocka_unit_test(foot_on_level_ground_stands_under_its_middle),
        cmocka_unit_test(foot_beyond_an_end_counts_what_is_over_the_line),
        cmocka_unit_test(foot_is_never_under_the_ground_and_touches_it),
        cmocka_unit_test(foot_with_bad_input_is_refused_and_writes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
