/* energy_scenes.c: measures for each built-in scene without motors how much energy it gains in a
 * run; it should gain none. */
#include "extremes/energy.h"

#include <math.h>

/* Springs store energy that is not measured here, and motors add energy. */
static bool is_driven(const scene_joint *j) {
    for (int i = 0; i < SCENE_DIRECTIONS; i++)
        if (j->drive[i].frequency > 0 || j->drive[i].motor_force > 0)
            return true;
    return false;
}

/* Whether something moves, and nothing adds energy: no driven joint, no field, no moving kinematic
 * body. */
static bool is_closed(const scene *s) {
    bool moves = false;
    if (scene_has_fields(s))
        return false;
    for (int i = 0; i < s->joint_count; i++)
        if (is_driven(&s->joints[i]))
            return false;
    for (int i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_KINEMATIC)
            return false;
        moves = moves || s->bodies[i].kind == SCENE_DYNAMIC;
    }
    return moves;
}

/* The scene's size that gives at most some hundreds of bodies; 0: its default. */
static int small_size(const scene_info *info) {
    return info->default_size > 1000 ? 500 : info->default_size > 50 ? 20 : 0;
}

static double lowest_start(const scene *s) {
    double lowest = INFINITY;
    for (int i = 0; i < s->body_count; i++)
        if (s->bodies[i].kind == SCENE_DYNAMIC)
            lowest = fmin(lowest, s->bodies[i].y);
    return lowest;
}

typedef struct gain {
    double above_start; /* largest energy of the run, minus that at the start */
    double rise;        /* largest difference of the energy and the lowest before it, that is,
                           energy gained back */
} gain;

/* Gains of energy, in % of the energy that could be lost: the potential energy above the place of
 * the lowest body at the start, or above its lowest place later. Bodies on joints fall and swing
 * back; for them, in % of the largest kinetic energy. */
static gain most_gained(ledger *l, entrant e, const scene *s) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return (gain){NAN, NAN};
    double floor = lowest_start(s), start = trial_energy(t, floor), least = start;
    gain g = {0, 0};
    double kinetic = 0;
    int steps = l->quick ? 30 : 600;
    for (int i = 0; i < steps && trial_step(t); i++) {
        double now = trial_energy(t, floor);
        if (!isfinite(now))
            now = INFINITY;
        g.above_start = fmax(g.above_start, now - start);
        g.rise = fmax(g.rise, now - least);
        least = fmin(least, now);
        kinetic = s->joint_count > 0 ? fmax(kinetic, trial_kinetic_energy(t)) : 0;
    }
    trial_end(t);
    double scale = fmax(kinetic, fmax(start, start - least));
    if (scale > 0)
        return (gain){100 * g.above_start / scale, 100 * g.rise / scale};
    return g.rise > 0 ? (gain){INFINITY, INFINITY} : g;
}

void energy_of_scenes(ledger *l) {
    for (int i = 0; i < scenes_count(); i++) {
        const scene_info *info = scenes_at(i);
        scene s;
        if (!scenes_fill(info, small_size(info), &s)) {
            l->failed = true;
            continue;
        }
        if (is_closed(&s)) {
            figure *above = ledger_add(l, bound_at_most(0.01, ON_THUD),
                                       "%s: energy above its start, %%", info->name);
            figure *rise = ledger_add(l, bound_at_most(0.1, ON_THUD),
                                      "%s: energy above its lowest before, %%", info->name);
            for (entrant e = 0; e < ENTRANTS; e++) {
                ledger_progress(l, above->what, 0.5 + 0.5 * i / scenes_count());
                if (!ledger_has(l, e) || !trial_is_possible(e, &s))
                    continue;
                gain g = most_gained(l, e, &s);
                figure_tell(above, e, g.above_start);
                figure_tell(rise, e, g.rise);
            }
        }
        scene_free(&s);
    }
}
