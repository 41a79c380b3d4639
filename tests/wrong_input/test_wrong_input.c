/* test_wrong_input.c: calls every function of the public API with invalid arguments. Each must
 * return a result code, log a message, and change neither its outputs nor any body. The calls are
 * in the tables wrong_*.c. */
#include "wrong_input.h"

#include <stdio.h>

wrong_outputs wrong_out;
int wrong_total;

static void fill_outputs(void) {
    memset(&wrong_out, 0x5a, sizeof wrong_out);
}

static bool outputs_are_untouched(void) {
    const unsigned char *bytes = (const unsigned char *)&wrong_out;
    for (size_t i = 0; i < sizeof wrong_out; i++) {
        if (bytes[i] != 0x5a) {
            return false;
        }
    }
    return true;
}

static void make_villages(wrong_pair *p) {
    village_make(&p->here, thud_default_world_def());
    village_make(&p->twin, thud_default_world_def());
    village_make(&p->other, thud_default_world_def());
    fill_outputs();
}

int wrong_setup(void **state) {
    *state = calloc(1, sizeof(wrong_pair));
    make_villages(*state);
    return 0;
}

int wrong_teardown(void **state) {
    wrong_pair *p = *state;
    int complaints = p->complaints;
    wrong_total += p->refused;
    village_free(&p->here);
    village_free(&p->twin);
    village_free(&p->other);
    free(p);
    return complaints;
}

/* Prints the first line in which two texts differ. */
static void show_difference(const char *a, const char *b) {
    for (; *a && *b; a += strcspn(a, "\n") + 1, b += strcspn(b, "\n") + 1) {
        size_t n = strcspn(a, "\n"), m = strcspn(b, "\n");
        if (n != m || strncmp(a, b, n) != 0) {
            print_error("here: %.*s\ntwin: %.*s\n", (int)n, a, (int)m, b);
            return;
        }
    }
}

static bool villages_are_alike(const wrong_pair *p) {
    char *here = village_text(&p->here), *twin = village_text(&p->twin);
    bool alike = strcmp(here, twin) == 0;
    if (!alike) {
        show_difference(here, twin);
    }
    free(here);
    free(twin);
    return alike;
}

/* What is wrong about the way in which a call was refused; null if it was refused correctly.
 * `told`: expected number of log messages. */
static const char *complaint(wrong_pair *p, thud_result got, thud_result wanted, int told) {
    if (got != wanted) {
        return thud_result_text(got);
    }
    if (p->here.told != told) {
        return told ? "the log was not told, or more than once" : "the log was told";
    }
    if (!outputs_are_untouched()) {
        return "an output was written";
    }
    if (!villages_are_alike(p)) {
        return "the world has changed";
    }
    village_step(&p->here);
    village_step(&p->twin);
    if (!villages_are_alike(p)) {
        return "the world goes on differently";
    }
    return p->here.told != told ? "the world complains later" : NULL;
}

void wrong_check(wrong_pair *p, thud_result got, thud_result wanted, int told, const char *call,
                 const char *file, int line) {
    const char *wrong = complaint(p, got, wanted, told);
    p->refused++;
    p->here.told = 0;
    if (wrong) {
        const char *name = strrchr(file, '/');
        print_error("%s:%d: %s: %s\n", name ? name + 1 : file, line, call, wrong);
        p->complaints++;
        fill_outputs();
        assert_in_range(p->complaints, 0, 20);
    }
}

static void tables_hold_hundreds_of_wrong_calls(void **state) {
    (void)state;
    print_message("%d wrong calls refused\n", wrong_total);
    assert_true(wrong_total >= 300);
}

#define TABLE(name) cmocka_unit_test_setup_teardown(name, wrong_setup, wrong_teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        TABLE(wrong_worlds),
        TABLE(wrong_settings),
        TABLE(wrong_bodies),
        TABLE(wrong_body_edits),
        TABLE(wrong_shapes),
        TABLE(wrong_terrains),
        TABLE(wrong_terrain_edits),
        TABLE(wrong_handles),
        TABLE(wrong_rays_and_casts),
        TABLE(wrong_overlaps_and_closest),
        TABLE(wrong_casts_hit_by_hit),
        TABLE(wrong_many_casts),
        TABLE(wrong_questions_to_a_shape),
        TABLE(wrong_explosions),
        TABLE(wrong_fields),
        TABLE(wrong_movers),
        TABLE(wrong_drawings),
        TABLE(wrong_geometry),
        TABLE(wrong_ground_geometry),
        TABLE(wrong_volumes),
        TABLE(wrong_sums),
        cmocka_unit_test(tables_hold_hundreds_of_wrong_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
