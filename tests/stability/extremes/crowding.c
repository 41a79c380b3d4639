/* crowding.c: the extreme "crowding": circles that all begin overlapped in one spot. Without
 * gravity, so that each speed comes from being pushed apart. Measured are the largest speed and the
 * overlap that is left. */
#include "random.h"
#include "trial.h"

#include <math.h>

static const double RADIUS = 0.25;

/* Upper bound of the speed, m/s: each pair separates at push_speed, 3 m/s. A disc of n circles has
 * sqrt(n / pi) circles from its centre to its rim, each pushed by the one before it, so the rim may
 * reach sqrt(n / pi) times 3 m/s. */
static double speed_bound(int bodies) {
    return 3 * sqrt(bodies / acos(-1));
}

/* Box2D allocates a contact of 700 bytes for each of 8 million pairs, more memory than a test may
 * take. */
static bool is_too_much_for_box2d(int bodies, double spot) {
    return bodies > 1000 && spot < 1;
}

/* The centres are in a square of half width `spot`; 0: all in the same place. */
static void fill(scene *s, int bodies, double spot) {
    scene_init(s);
    s->gravity_y = 0;
    scene_random random = {7};
    for (int i = 0; i < bodies; i++) {
        double x = scene_random_range(&random, -spot, spot);
        double y = scene_random_range(&random, -spot, spot);
        scene_dynamic_circle(s, x, y, RADIUS);
    }
}

/* Measures the largest speed of the run, and the overlap at its end. */
static void come_apart(ledger *l, entrant e, const scene *s, figure *speed, figure *left) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return;
    double fastest = 0;
    penetration seen = {0};
    int steps = l->quick ? 120 : 600;
    for (int step = 0; step < steps && trial_step(t); step++)
        fastest = fmax(fastest, trial_speed(t));
    trial_penetration(t, &seen);
    figure_tell(speed, e, fastest);
    figure_tell(left, e, 100 * seen.worst / (2 * RADIUS));
    trial_end(t);
}

static void run(ledger *l) {
    static const struct {
        const char *where;
        double spot;
    } CASES[] = {{"all in one place", 0}, {"within 0.01 m", 0.01}, {"within 1 m", 1}};
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    int bodies = l->quick ? 200 : 4000;
    for (int i = 0; i < CASE_COUNT; i++) {
        scene s;
        fill(&s, bodies, CASES[i].spot);
        figure *speed = ledger_add(l, bound_at_most(speed_bound(bodies), ON_THUD),
                                   "%s: highest speed, m/s", CASES[i].where);
        figure *left = ledger_add(l, bound_at_most(1, ON_THUD),
                                  "%s: worst overlap at the end, %% of the size", CASES[i].where);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, speed->what, (i + (double)e / ENTRANTS) / CASE_COUNT);
            if (ledger_has(l, e) &&
                !(e == ENTRANT_BOX2D && is_too_much_for_box2d(bodies, CASES[i].spot)))
                come_apart(l, e, &s, speed, left);
        }
        scene_free(&s);
    }
}

const extreme extreme_crowding = {
    .name = "crowding",
    .title = "Crowding",
    .about = "4,000 circles of radius 0.25 m started in one spot, without gravity, for 10 s: they "
             "must come apart, and not explode. The bound on speed is push_speed, 3 m/s, times the "
             "number of circles from the middle to the rim of a disc of them.",
    .run = run,
};
