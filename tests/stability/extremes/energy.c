/* energy.c: the extreme "energy": elastic bodies must keep their energy, and no built-in scene may
 * gain any (energy_scenes.c). */
#include "extremes/energy.h"

#include <math.h>

/* An elastic ball of radius 0.5, dropped from 5 m above the floor: the height that corresponds to
 * its energy after 60 s, in % of that at the start. */
static double ball_height(ledger *l, entrant e) {
    scene s;
    scene_init(&s);
    s.material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    scene_static_box(&s, 0, -1, 10, 1);
    scene_dynamic_circle(&s, 0, 5.5, 0.5);
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double kept = NAN;
    if (t) {
        double start = trial_energy(t, 0.5);
        kept =
            trial_steps(t, l->quick ? 300 : 3600) ? 100 * trial_energy(t, 0.5) / start : INFINITY;
    }
    trial_end(t);
    scene_free(&s);
    return kept;
}

/* 100 elastic circles between walls: the largest change of their energy within a minute, in % of
 * that at the start. */
static double gas_drift(ledger *l, entrant e, bool falling) {
    scene s;
    scenes_fill(&scene_gas, 100, &s);
    double floor = -scene_gas_half(100);
    if (falling) {
        s.gravity_y = -10;
        for (int i = 0; i < s.body_count; i++)
            s.bodies[i].gravity_scale = 1;
    }
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double drift = NAN;
    if (t) {
        double start = trial_energy(t, floor);
        drift = 0;
        int steps = l->quick ? 120 : 3600;
        for (int i = 0; i < steps && trial_step(t); i++)
            drift = fmax(drift, 100 * fabs(trial_energy(t, floor) / start - 1));
    }
    trial_end(t);
    scene_free(&s);
    return drift;
}

/* `flying` of five circles hit the others at rest. Returns the momentum of the slowest of as many
 * circles at the far end after the impact, in % of that of a circle before it. */
static double cradle_momentum(ledger *l, entrant e, int flying) {
    enum { CIRCLES = 5 };
    scene s;
    scenes_fill(&scene_cradle, CIRCLES, &s);
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double slowest = NAN;
    if (t) {
        /* The impact is at 1.2 s, and the circles would reach the wall at 2.4 s. */
        bool ok = trial_steps(t, 108);
        const engine_body *bodies = trial_read(t);
        const engine_body *row = &bodies[2 + CIRCLES * (flying - 1)];
        slowest = INFINITY;
        for (int i = CIRCLES - flying; i < CIRCLES; i++)
            slowest = fmin(slowest, row[i].vx);
        slowest = ok ? 100 * slowest / 5 : INFINITY;
    }
    trial_end(t);
    scene_free(&s);
    return slowest;
}

static void run(ledger *l) {
    figure *ball =
        ledger_add(l, bound_at_least(99.9, ON_EXACT), "elastic ball, 60 s: height kept, %%");
    figure *gas =
        ledger_add(l, bound_at_most(0.01, ON_EXACT), "elastic gas of 100, 60 s: energy drift, %%");
    figure *rain =
        ledger_add(l, bound_at_most(0.01, ON_EXACT), "the same under gravity: energy drift, %%");
    figure *cradle[2];
    for (int i = 0; i < 2; i++)
        cradle[i] = ledger_add(l, bound_at_least(99.9, ON_EXACT),
                               "cradle of five, %s in: momentum of the last %s, %%",
                               i == 0 ? "one" : "two", i == 0 ? "one" : "two");
    for (entrant e = 0; e < ENTRANTS; e++) {
        if (!ledger_has(l, e))
            continue;
        ledger_progress(l, entrant_name(e), 0.5 * e / ENTRANTS);
        figure_tell(ball, e, ball_height(l, e));
        figure_tell(gas, e, gas_drift(l, e, false));
        figure_tell(rain, e, gas_drift(l, e, true));
        for (int i = 0; i < 2; i++)
            figure_tell(cradle[i], e, cradle_momentum(l, e, i + 1));
    }
    energy_of_scenes(l);
}

const extreme extreme_energy = {
    .name = "energy",
    .title = "Energy",
    .about =
        "Elastic bodies keep it, for a minute; and no built-in scene gains any in 10 s: neither "
        "above what it started with, nor back from what it has lost; in % of all that it could "
        "lose by falling to its lowest point and stopping. Being pushed out of an overlap lifts "
        "what rests, hence the 0.1 %. Scenes with motors are left out.",
    .run = run,
};
