/* test_guarantees.c: runs every guarantee on combinations of settings. `./run test` draws some of
 * them by a seed, THUD_GUARANTEES=full runs all combinations, THUD_GUARANTEES=SEED draws by another
 * seed, and THUD_GUARANTEES=full:SEED runs all combinations with other random scenes.
 *
 *   --share I/N                 runs every N-th case, beginning with the I-th; 1 is the first
 *   --only NAME                 runs that guarantee alone
 *   --settings DIMENSION=VALUE,...   with --only: runs that case alone
 *   --list, --draws             prints guarantees with the values they leave out; prints each case
 */
#include "draws.h"
#include "share.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <time.h>

#include <cmocka.h>

enum { FIRST_SEED = 15, FAULTS_TOLD = 3 };

static struct options {
    bool full;
    uint64_t seed;
    int share, shares;
    const char *only;
    const char *settings;
} options = {.seed = FIRST_SEED, .share = 1, .shares = 1};

/* ---- cases ---- */

/* Fills `out` with the settings to run, by the options, and returns their number. */
static int cases_of(const guarantee *g, settings *out) {
    settings one;
    int count = 0;
    if (options.settings) {
        out[0] = settings_read(options.settings, &one) ? one : (settings){{0}};
        return 1;
    }
    if (!options.full) {
        return share_of(draws_of(g, options.seed, out));
    }
    for (int i = 0; i < settings_count(); i++) {
        settings s = settings_at(i);
        if (guarantee_covers(g, &s)) {
            out[count++] = s;
        }
    }
    return count;
}

static settings *room_for_cases(void) {
    int count = settings_count() > DRAWS_MAX ? settings_count() : DRAWS_MAX;
    settings *room = calloc((size_t)count, sizeof *room);
    assert_non_null(room);
    return room;
}

/* Runs one case. Returns 1 and prints the command that repeats it if it failed, else 0. */
static int try_case(const guarantee *g, const settings *s) {
    char text[SETTINGS_TEXT];
    trial *t = malloc(sizeof *t);
    assert_non_null(t);
    trial_begin(t, s, options.seed);
    g->check(t);
    trial_end(t);
    bool failed = trial_failed(t);
    if (failed) {
        settings_write(s, text);
        print_error("%s: %s\n  THUD_GUARANTEES=%llu build/release/tests/guarantees/test_guarantees "
                    "--only %s --settings %s\n",
                    g->name, t->fault, (unsigned long long)options.seed, g->name, text);
    }
    free(t);
    return failed;
}

/* The test of one guarantee: all of its cases in this share must pass. */
static void holds(void **state) {
    const guarantee *g = *state;
    settings *cases = room_for_cases();
    int count = cases_of(g, cases), failed = 0;
    for (int i = options.share - 1; i < count; i += options.shares) {
        failed += failed < FAULTS_TOLD ? try_case(g, &cases[i]) : 0;
    }
    free(cases);
    if (failed) {
        fail_msg("%s does not hold", g->name);
    }
}

/* ---- --list and --draws ---- */

static void list_guarantee(const guarantee *g) {
    printf("%s\t", g->name);
    for (int i = 0; i < EXCEPTIONS_MAX && g->except[i].reason; i++) {
        const exception *e = &g->except[i];
        const char *before = i ? "; not " : "not ";
        for (int v = 0; v < dimensions[e->dimension].count; v++) {
            if (e->values & BIT(v)) {
                printf("%s%s", before, dimensions[e->dimension].values[v]);
                before = ", ";
            }
        }
        printf(": %s", e->reason);
    }
    printf("%s\n", g->except[0].reason ? "" : "all");
}

static void list_cases(const guarantee *g) {
    char text[SETTINGS_TEXT];
    settings *cases = room_for_cases();
    int count = cases_of(g, cases);
    for (int i = 0; i < count; i++) {
        settings_write(&cases[i], text);
        printf("%s\t%s\n", g->name, text);
    }
    free(cases);
}

static int usage(void) {
    fprintf(stderr, "usage: test_guarantees [--share I/N] [--only NAME [--settings SETTINGS]]\n"
                    "       test_guarantees --list | --draws\n");
    return 2;
}

static bool read_environment(void) {
    const char *wanted = getenv("THUD_GUARANTEES");
    char *end = NULL;
    if (!wanted || !*wanted) {
        return true;
    }
    options.full = strncmp(wanted, "full", 4) == 0;
    wanted += options.full ? 4 + (wanted[4] == ':') : 0;
    if (*wanted) {
        options.seed = strtoull(wanted, &end, 10);
    }
    return !*wanted || *end == 0;
}

static bool is_wanted(const guarantee *g) {
    return !options.only || strcmp(options.only, g->name) == 0;
}

int main(int argc, char **argv) {
    const guarantee *all[GUARANTEES_MAX];
    struct CMUnitTest tests[GUARANTEES_MAX];
    int count = guarantees_all(all), wanted = 0;
    void (*list)(const guarantee *) = NULL;
    settings read;
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--list") == 0 || strcmp(argv[i], "--draws") == 0) {
            list = argv[i][2] == 'l' ? list_guarantee : list_cases;
        } else if (strcmp(argv[i], "--only") == 0) {
            options.only = argv[++i];
        } else if (strcmp(argv[i], "--settings") == 0 && settings_read(value, &read)) {
            options.settings = argv[++i];
        } else if (strcmp(argv[i], "--share") == 0 &&
                   sscanf(value, "%d/%d", &options.share, &options.shares) == 2 &&
                   options.share >= 1 && options.share <= options.shares) {
            i++;
        } else {
            return usage();
        }
    }
    for (int i = 0; i < count; i++) {
        if (is_wanted(all[i])) {
            tests[wanted++] = (struct CMUnitTest){.name = all[i]->name,
                                                  .test_func = holds,
                                                  .initial_state = (void *)all[i]};
        }
    }
    if (!read_environment() || wanted == 0 || (options.settings && !options.only)) {
        return usage();
    }
    for (int i = 0; i < count && list; i++) {
        list(all[i]);
    }
    return list ? 0 : _cmocka_run_group_tests("guarantees", tests, (size_t)wanted, NULL, NULL);
}
