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

static void run(ledger *l) {
    static const double SPOTS[] = {0, 0.01, 1};
    enum { SPOT_COUNT = sizeof SPOTS / sizeof SPOTS[0] };
    int bodies = l->quick ? 200 : 4000, steps = l->quick ? 120 : 1200;
    for (int i = 0; i < SPOT_COUNT; i++) {
        scene s;
        fill(&s, bodies, SPOTS[i]);
        bound speed_limit = bound_at_most(speed_bound(bodies), ON_THUD);
        if (SPOTS[i] == 0)
            speed_limit = bound_missed(speed_limit);
        figure *speed = ledger_add(
            l, speed_limit, "%d circles within %g m: highest speed of any, m/s", bodies, SPOTS[i]);
        figure *left = ledger_add(l, bound_at_most(1, ON_THUD),
                                  "the same: worst overlap at the end, %% of the size");
        for (entrant e = 0; e < ENTRANTS; e++) {
            if (!ledger_has(l, e) ||
                (e == ENTRANT_BOX2D && is_too_much_for_box2d(bodies, SPOTS[i])))
                continue;
            trial *t = trial_begin(l, e, &s, (trial_settings){0});
            if (!t)
                continue;
            double fastest = 0;
            penetration seen = {0};
            for (int step = 0; step < steps && trial_step(t); step++) {
                fastest = fmax(fastest, trial_speed(t));
                if (step % 10 == 0)
                    ledger_progress(l, speed->what,
                                    (i + (e + (double)step / steps) / ENTRANTS) / SPOT_COUNT);
            }
            trial_penetration(t, &seen);
            figure_tell(speed, e, fastest);
            figure_tell(left, e, 100 * seen.worst / (2 * RADIUS));
            trial_end(t);
        }
        scene_free(&s);
    }
}

const extreme extreme_crowding = {
    .name = "crowding",
    .title = "Crowding",
    .about = "4,000 circles of radius 0.25 m started in one spot, without gravity, for 20 s: they "
             "must come apart, and not explode. The bound on speed is push_speed, 3 m/s, times the "
             "number of circles from the middle to the rim of a disc of them.",
    .run = run,
};
