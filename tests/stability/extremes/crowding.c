/* crowding.c: the extreme (extreme.h) "crowding": circles that overlap each other in one spot at
 * the start. There is no gravity, so that every speed comes from the separation of overlaps.
 * Measured are the largest speed of the run and the overlap at its end. */
#include "random.h"
#include "trial.h"

#include <math.h>

static const double PI = 3.14159265358979323846;
static const double RADIUS = 0.25;  /* of each circle, m */
static const double PUSH_SPEED = 3; /* default of thud_world_def.push_speed, m/s */

/* Bound of the overlap at the end, % of a circle's diameter. All circles come apart: 0 % was
 * measured in every case at full length (docs/stability.md). The 1 % is chosen, 5 mm. */
static const double FINAL_OVERLAP_MAX = 1;

/* Steps of 1/60 s: 10 s, and 2 s in a quick run. */
enum { STEPS = 600, QUICK_STEPS = 120, BODIES = 4000, QUICK_BODIES = 200 };

/* Upper bound of the speed in thud, m/s: the solver separates an overlapping pair at no more than
 * push_speed. A disc of n circles has sqrt(n / pi) circles from its centre to its rim, each pushed
 * by the one before it, so that the rim may reach sqrt(n / pi) times that speed. */
static double speed_bound(int bodies) {
    return PUSH_SPEED * sqrt(bodies / PI);
}

/* Box2D is left out where nearly all pairs of a full run touch: it keeps a contact of some 700
 * bytes for each of the 8 million pairs of 4,000 circles, 5.6 GB. In a square of half width 1 m at
 * most pi 0.5^2 / 2^2 of the pairs touch, a fifth. */
static bool is_too_large_for_box2d(int bodies, double half_width) {
    return bodies == BODIES && half_width < 1;
}

/* Circles with their centres in a square of this half width, m; 0: all in the same place. */
static void fill(scene *s, int bodies, double half_width) {
    scene_init(s);
    s->gravity_y = 0;
    scene_random random = {7};
    for (int i = 0; i < bodies; i++) {
        double x = scene_random_range(&random, -half_width, half_width);
        double y = scene_random_range(&random, -half_width, half_width);
        scene_dynamic_circle(s, x, y, RADIUS);
    }
}

/* Runs the scene in one engine and writes its largest speed and its overlap at the end. Where the
 * world cannot be created or a step is refused, the ledger has failed, and with it the test. */
static void measure_entrant(ledger *l, entrant e, const scene *s, figure *speed, figure *overlap) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return;
    double fastest = 0;
    penetration at_end = {0};
    int steps = l->quick ? QUICK_STEPS : STEPS;
    for (int step = 0; step < steps && trial_step(t); step++)
        fastest = fmax(fastest, trial_speed(t));
    trial_penetration(t, &at_end);
    figure_tell(speed, e, fastest);
    figure_tell(overlap, e, 100 * at_end.worst / (2 * RADIUS));
    trial_end(t);
}

static void run(ledger *l) {
    static const struct {
        const char *where;
        double half_width; /* m */
    } CASES[] = {{"all in one place", 0}, {"within 0.01 m", 0.01}, {"within 1 m", 1}};
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    int bodies = l->quick ? QUICK_BODIES : BODIES;
    for (int i = 0; i < CASE_COUNT; i++) {
        scene s;
        fill(&s, bodies, CASES[i].half_width);
        figure *speed = ledger_add(l, bound_at_most(speed_bound(bodies), ON_THUD),
                                   "%s: highest speed, m/s", CASES[i].where);
        figure *overlap =
            ledger_add(l, bound_at_most(FINAL_OVERLAP_MAX, ON_THUD),
                       "%s: worst overlap at the end, %% of the size", CASES[i].where);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, speed->what, (i + (double)e / ENTRANTS) / CASE_COUNT);
            if (ledger_has(l, e) &&
                !(e == ENTRANT_BOX2D && is_too_large_for_box2d(bodies, CASES[i].half_width)))
                measure_entrant(l, e, &s, speed, overlap);
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
