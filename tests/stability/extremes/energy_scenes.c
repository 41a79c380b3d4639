/* energy_scenes.c: no built-in scene gains energy. */
#include "extremes/energy.h"

#include <math.h>

/* Springs hold energy that nobody counts here, and motors give some. */
static bool is_driven(const scene_joint *j) {
    for (int i = 0; i < SCENE_DIRECTIONS; i++)
        if (j->drive[i].frequency > 0 || j->drive[i].motor_force > 0)
            return true;
    return false;
}

/* Something moves, and only by what it started with: no motor, no wind. */
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

/* Hundreds of bodies at most. */
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
    double above_start; /* the most that the scene ever had, over what it started with */
    double rise;        /* the most that it ever had over the least before: what it got back */
} gain;

/* In % of what there was to lose: all that it had above where its lowest body started, or more
 * where it came to lie lower still. What hangs by joints falls from there and comes back: of that,
 * in % of the most that ever was kinetic. */
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
