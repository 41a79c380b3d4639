/* far_away.c: the same scene at the origin and far from it, bit for bit. Cells are whole units. */
#include "scenes.h"
#include "stack.h"

#include <math.h>
#include <string.h>

/* Runs the scene at the place and at the origin. How many bodies differ in any bit of pose or
 * velocity; infinite when one is lost. */
static double bodies_that_differ(ledger *l, entrant e, const scene_info *info, int size,
                                 double away, double *penetration_away) {
    scene here, there;
    double differ = NAN;
    trial *a = NULL, *b = NULL;
    int steps = l->quick ? 60 : 600;
    bool filled = scenes_fill(info, size, &here) & (int)scenes_fill(info, size, &there);
    scene_shift(&there, away, -away);
    trial_settings settings = {.origin_x = away, .origin_y = -away};
    if (filled && (a = trial_begin(l, e, &here, (trial_settings){0})) && trial_steps(a, steps) &&
        (b = trial_begin(l, e, &there, settings)) && trial_steps(b, steps)) {
        differ = 0;
        for (int i = 0; i < here.body_count; i++) {
            thud_pose pose[2];
            trial_pose(a, i, &pose[0]);
            trial_pose(b, i, &pose[1]);
            differ += memcmp(&pose[0], &pose[1], sizeof pose[0]) != 0;
        }
        const contender_body *bodies = trial_read(b);
        for (int i = 0; i < here.body_count; i++)
            if (!isfinite(bodies[i].x) || !isfinite(bodies[i].y))
                differ = INFINITY;
        penetration seen[2] = {0};
        trial_penetration(a, &seen[0]);
        trial_penetration(b, &seen[1]);
        *penetration_away = seen[1].worst - seen[0].worst;
    }
    trial_end(a);
    trial_end(b);
    scene_free(&here);
    scene_free(&there);
    return differ;
}

static void run(ledger *l) {
    static const struct {
        const scene_info *info;
        int size;
    } SCENES[] = {{&scene_pyramid, 10},
                  {&scene_circle_pit, 200},
                  {&scene_mixed_terrain, 200},
                  {&scene_bullets, 0}};
    static const double AWAY[] = {1e3, 1e5, 1e7};
    enum { SCENE_COUNT = 4, PLACES = 3 };
    for (int i = 0; i < SCENE_COUNT; i++) {
        for (int place = 0; place < PLACES; place++) {
            /* One scene is enough to see from where on Box2D gives way. */
            if (place + 1 < PLACES && (l->quick || i > 0))
                continue;
            const char *name = SCENES[i].info->name;
            int power = (int)round(log10(AWAY[place]));
            figure *differ = ledger_add(l, bound_at_most(0, ON_THUD),
                                        "%s 10^%d away: bodies that differ in a bit", name, power);
            figure *deeper = ledger_add(l, bound_at_most(1e-6, ON_THUD),
                                        "%s 10^%d away: worst penetration, less that at the origin",
                                        name, power);
            for (entrant e = 0; e < ENTRANTS; e++) {
                ledger_progress(l, differ->what,
                                (double)(i * PLACES + place) / (SCENE_COUNT * PLACES));
                if (!ledger_has(l, e))
                    continue;
                double penetration_away = NAN;
                figure_tell(differ, e,
                            bodies_that_differ(l, e, SCENES[i].info, SCENES[i].size, AWAY[place],
                                               &penetration_away));
                figure_tell(deeper, e, fabs(penetration_away));
            }
        }
    }
}

const extreme extreme_far_away = {
    .name = "far-away",
    .title = "Far from the origin",
    .about = "Scenes run for 10 s at the origin, and shifted by so many units to the right and "
             "down, of which one box is one.",
    .run = run,
};
