/* mass_ratio.c: the extreme "mass-ratio": a heavy box on light ones. Measured is the largest
 * penetration of any step, in % of the size of a light box. */
#include "extremes/stack.h"

#include <math.h>

/* One heavy box on a column of `light` ones of the same size. */
static void fill_column(scene *s, int light, double ratio) {
    stack_init(s, light + 1, 1);
    s->shapes[light + 1].material.density = ratio;
}

/* A box that is 100 times as wide as the two boxes that it stands on; `ratio` is its mass over that
 * of one of them. */
static void fill_table(scene *s, double ratio) {
    scene_init(s);
    scene_static_box(s, 0, -1, 200, 1);
    scene_dynamic_box(s, -30, 0.5, 0.5, 0.5);
    scene_dynamic_box(s, 30, 0.5, 0.5, 0.5);
    scene_dynamic_box(s, 0, 51, 50, 50);
    s->shapes[3].material.density = ratio / 1e4;
}

static bool has_fallen(trial *t) {
    const engine_body *now = trial_read(t);
    const scene *s = trial_scene(t);
    for (int i = 1; i < s->body_count; i++)
        if (!(hypot(now[i].x - s->bodies[i].x, now[i].y - s->bodies[i].y) <= 0.5))
            return true;
    return false;
}

/* In % of the small box's size, which is 1 m; infinite if the structure fell. */
static double worst_penetration(ledger *l, entrant e, const scene *s) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return NAN;
    penetration seen = {0};
    int steps = l->quick ? 120 : 1200;
    for (int i = 0; i < steps && trial_step(t); i++)
        trial_penetration(t, &seen);
    double worst = has_fallen(t) ? INFINITY : 100 * seen.worst;
    trial_end(t);
    return worst;
}

static bound bound_of(double ratio) {
    if (ratio == 1e3)
        return bound_at_most(1, ON_DEFAULT);
    return ratio == 1e5 ? bound_at_most(0.1, ON_EXACT) : bound_none();
}

static void run(ledger *l) {
    static const struct {
        const char *what;
        int light; /* number of light boxes; 0: the wide box on two small ones */
    } CASES[] = {{"one box", 1},
                 {"a column of ten boxes", 10},
                 {"two boxes, and 100 times as big", 0}};
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0], POWERS = 4 };
    for (int i = 0; i < CASE_COUNT; i++) {
        for (int power = 0; power < POWERS; power++) {
            double ratio = pow(10, power + 2);
            scene s;
            if (CASES[i].light > 0)
                fill_column(&s, CASES[i].light, ratio);
            else
                fill_table(&s, ratio);
            figure *f = ledger_add(l, bound_of(ratio), "10^%d times as heavy on %s", power + 2,
                                   CASES[i].what);
            for (entrant e = 0; e < ENTRANTS; e++) {
                ledger_progress(l, f->what, (double)(i * POWERS + power) / (CASE_COUNT * POWERS));
                if (ledger_has(l, e))
                    figure_tell(f, e, worst_penetration(l, e, &s));
            }
            scene_free(&s);
        }
    }
}

const extreme extreme_mass_ratio = {
    .name = "mass-ratio",
    .title = "Mass ratio",
    .about = "A heavy box put on light ones, for 20 s. Figures: the worst penetration of any step, "
             "in % of the light box's size.",
    .run = run,
};
