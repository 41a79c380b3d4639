/* crowding.c: a crowd that starts in one spot, all overlapping. Without gravity, so that every
 * speed that anything gets comes from being pushed apart. */
#include "random.h"
#include "trial.h"

#include <math.h>

static const double RADIUS = 0.25;

/* The spot is a disc of this radius; 0: all in the very same place. */
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
        figure *speed =
            ledger_add(l, bound_missed(bound_at_most(12, ON_THUD)),
                       "%d circles within %g m: highest speed of any, m/s", bodies, SPOTS[i]);
        figure *left = ledger_add(l, bound_missed(bound_at_most(1, ON_DEFAULT)),
                                  "the same: worst overlap at the end, %% of the size");
        for (entrant e = 0; e < ENTRANTS; e++) {
            if (!ledger_has(l, e))
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
             "must come apart, and not explode. The bound on speed is four times the default "
             "push_speed.",
    .run = run,
};
