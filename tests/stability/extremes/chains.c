/* chains.c: the extreme "chains": bodies connected by hinges and welds in a row (chains, beams,
 * bridges, pendulums). Measured are the stretch (the sum of all joint gaps over the chain's
 * length), the angle of a beam's tip, the sag of a bridge and the energy of a pendulum, over the
 * load. */
#include "extremes/tied.h"

#include <math.h>

/* The largest stretch in %, in the second half of the run for a hanging chain, in the whole run for
 * a swinging one. Infinite if a body is lost. */
static double stretch_of(ledger *l, entrant e, const chain_scene *c) {
    scene s;
    scene_init(&s);
    fill_chain(&s, c);
    double worst = INFINITY;
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t) {
        int steps = l->quick ? 120 : 600;
        worst = 0;
        for (int i = 0; isfinite(worst) && i < steps && trial_step(t); i++) {
            double open = joint_gaps_sum(&s, trial_read(t)) / chain_length(c);
            if (c->level || 2 * i >= steps || !isfinite(open))
                worst = tied_worse(worst, open);
        }
    }
    trial_end(t);
    scene_free(&s);
    return 100 * worst;
}

static tied_outcome tell_stretch(ledger *l, entrant e, const void *how) {
    return (tied_outcome){{stretch_of(l, e, how)}};
}

/* The largest of the weights for which the stretch stays below 1 %; the search ends at the first
 * that exceeds it. */
static tied_outcome greatest_weight(ledger *l, entrant e, const void *how) {
    static const double WEIGHTS[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};
    chain_scene c = *(const chain_scene *)how;
    double greatest = 0;
    for (size_t i = 0; i < sizeof WEIGHTS / sizeof WEIGHTS[0]; i++) {
        c.weight = WEIGHTS[i];
        if (!(stretch_of(l, e, &c) < 1))
            break;
        greatest = c.weight;
    }
    return (tied_outcome){{greatest}};
}

static void tell_chains(ledger *l) {
    static const tied_row GREATEST = {"greatest weight under 1 % stretch, links", 0, 0};
    static const tied_row STRETCH[] = {{"stretch, %", 1, 0}, {"stretch, %", 1, 1e-3}};
    static const struct {
        const char *about;
        chain_scene chain;
        bool long_only;
    } CASES[] = {
        {"chain of 10, hung", {10, 0, false}, true},
        {"chain of 10, swinging", {10, 0, true}, true},
        {"chain of 30, hung", {30, 0, false}, true},
        {"chain of 30, swinging", {30, 0, true}, true},
        {"chain of 100, hung", {100, 0, false}, true},
        {"chain of 100, swinging", {100, 0, true}, true},
        {"chain of 30 with 10^3 at its end, hung", {30, 1e3, false}, false},
        {"chain of 30 with 10^3 at its end, swinging", {30, 1e3, true}, false},
        {"chain of 100 with 10^4 at its end, hung", {100, 1e4, false}, false},
        {"chain of 100 with 10^4 at its end, swinging", {100, 1e4, true}, false},
    };
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    for (int i = 0; i < CASE_COUNT; i++) {
        ledger_progress(l, CASES[i].about, 0.7 * i / CASE_COUNT);
        if (l->quick && CASES[i].long_only)
            continue;
        bool heavy = CASES[i].chain.weight > 0, heaviest = CASES[i].chain.weight > 1e3;
        tied_tell(l, heavy ? &STRETCH[heaviest] : &GREATEST, 1, CASES[i].about,
                  heavy ? tell_stretch : greatest_weight, &CASES[i].chain);
    }
}

typedef struct beam {
    int boxes;
    double tip;
} beam;

/* The largest angle of the last box in the second half of the run, degrees. */
static tied_outcome tip_angle(ledger *l, entrant e, const void *how) {
    const beam *b = how;
    scene s;
    scene_init(&s);
    fill_cantilever(&s, b->boxes, b->tip);
    double worst = INFINITY;
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    int steps = l->quick ? 120 : 600;
    if (t && trial_steps(t, steps / 2)) {
        worst = 0;
        for (int i = 0; i < steps / 2 && trial_step(t); i++) {
            const engine_body *last = &trial_read(t)[s.body_count - 1];
            worst = tied_worse(worst, DEGREES * fabs(atan2(last->sine, last->cosine)));
        }
    }
    trial_end(t);
    scene_free(&s);
    return (tied_outcome){{worst}};
}

static void tell_beams(ledger *l) {
    static const tied_row TIP = {"tip angle, degrees", 0.5, 1e-3};
    static const struct {
        const char *about;
        beam beam;
    } CASES[] = {{"cantilever of 10", {10, 0}},
                 {"cantilever of 10, 10 kg at the tip", {10, 10}},
                 {"cantilever of 10, 100 kg", {10, 100}},
                 {"cantilever of 20", {20, 0}},
                 {"cantilever of 20, 10 kg", {20, 10}},
                 {"cantilever of 20, 100 kg", {20, 100}}};
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    for (int i = 0; i < CASE_COUNT; i++) {
        ledger_progress(l, "cantilever", 0.7 + 0.1 * i / CASE_COUNT);
        tied_tell(l, &TIP, 1, CASES[i].about, tip_angle, &CASES[i].beam);
    }
}

/* How far the lowest hinge between planks is below the posts, m. */
static double sag_of(const scene *s, const engine_body *bodies, int planks) {
    double lowest = 0;
    for (int i = 0; i < planks; i++) {
        const scene_joint *j = &s->joints[i];
        const engine_body *b = &bodies[j->body[1]];
        lowest = fmin(lowest, b->y + b->sine * j->x[1] + b->cosine * j->y[1]);
    }
    return isfinite(bodies[s->body_count / 2].y) ? -lowest : INFINITY;
}

/* Sag beyond the exact one, in % of it, and the largest gap in mm. */
static tied_outcome sag_and_gap(ledger *l, entrant e, const void *how) {
    const bridge_scene *b = how;
    scene s;
    scene_init(&s);
    fill_bridge(&s, b);
    tied_outcome o = {{INFINITY, INFINITY}};
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t) {
        joint_gaps gaps = {0};
        double sag = 0, truth = bridge_sag(b);
        for (int i = 0; i < (l->quick ? 120 : 1200) && trial_step(t); i++) {
            trial_joint_gaps(t, &gaps);
            sag = tied_worse(sag, sag_of(&s, trial_read(t), b->planks));
        }
        if (gaps.lost == 0)
            o = (tied_outcome){{100 * fabs(sag / truth - 1), 1000 * gaps.worst.length}};
    }
    trial_end(t);
    scene_free(&s);
    return o;
}

static void tell_bridges(ledger *l) {
    static const tied_row ROWS[] = {{"sag beyond the truth, %", 1, 0}, {"worst gap, mm", 1, 0}};
    static const bridge_scene LIGHT = {50, 48, 20, 40}, HEAVY = {50, 48, 20, 400};
    ledger_progress(l, "bridge", 0.8);
    tied_tell(l, ROWS, 2, "bridge of 50 planks, 20 of 40 kg", sag_and_gap, &LIGHT);
    tied_tell(l, ROWS, 2, "bridge of 50 planks, 20 of 400 kg", sag_and_gap, &HEAVY);
}

/* How far the mean energy of the last two seconds is from that at the start, in % of the energy
 * that the bars release when they fall by half of the pendulum's length. */
static tied_outcome energy_off(ledger *l, entrant e, const void *how) {
    int bars = *(const int *)how, steps = l->quick ? 600 : 3600, last = 120;
    scene s;
    scene_init(&s);
    fill_pendulum(&s, bars);
    double off = INFINITY;
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double start = t ? trial_energy(t, 0) : 0, sum = 0;
    if (t && trial_steps(t, steps - last)) {
        for (int i = 0; i < last && trial_step(t); i++)
            sum += trial_energy(t, 0) / last;
        off = fabs(sum - start) / (-0.5 * s.gravity_y * bars * bars);
    }
    trial_end(t);
    scene_free(&s);
    return (tied_outcome){{100 * off}};
}

static void tell_pendulums(ledger *l) {
    static const tied_row ENERGY = {"energy off after 60 s, %", 1, 1e-3};
    static const tied_row DOUBLE = {"energy off after 60 s, %", 0, 0};
    static const int ONE = 1, TWO = 2, TEN = 10;
    ledger_progress(l, "pendulum", 0.9);
    tied_tell(l, &ENERGY, 1, "pendulum", energy_off, &ONE);
    tied_tell(l, &DOUBLE, 1, "double pendulum", energy_off, &TWO);
    tied_tell(l, &DOUBLE, 1, "pendulum of ten bars", energy_off, &TEN);
}

static void run(ledger *l) {
    tell_chains(l);
    tell_beams(l);
    tell_bridges(l);
    tell_pendulums(l);
}

const extreme extreme_chains = {
    .name = "chains",
    .title = "Chains, beams and bridges",
    .about =
        "Hinges and welds in a row. A chain's stretch is the sum of its gaps over its length, hung "
        "from its fifth second on, swinging from level over ten; a link is 0.5 m. Cantilevers are "
        "of boxes of 0.5 m and 0.25 kg. The bridge spans 48 m with planks of 1 m and 5 kg, starts "
        "in equilibrium, and is held for 20 s. A pendulum's bars are of 1 m, and start level.",
    .run = run,
    .also = ON_BOX2D | ON_CHIPMUNK,
};
