/* crowding.c: a crowd that starts in one spot, all overlapping. Without gravity, so that every
 * speed that anything gets comes from being pushed apart. */
#include "random.h"
#include "trial.h"

#include <math.h>

static const double RADIUS = 0.25;

/* Every pair parts at push_speed, 3 m/s, and a disc of n circles has sqrt(n / pi) of them from its
 * middle to its rim, each pushed by the one before: the rim may come to that many times 3 m/s. */
static double speed_bound(int bodies) {
    return 3 * sqrt(bodies / acos(-1));
}

/* Box2D keeps a contact of 700 bytes for each of 8 million pairs: more than tests may take. */
static bool is_too_much_for_box2d(int bodies, double spot) {
    return bodies > 1000 && spot < 1;
}

/* The spot is a square twice as wide; 0: all in the very same place. */
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

/* The highest speed at any time, and what still overlaps at the end. */
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
