/* linkages.c: the extreme "linkages": scissor lifts, doors and sliders under loads that are heavy
 * in comparison with their parts. Measured are the height that a lift loses, joint gaps, and angles
 * beyond limits. */
#include "extremes/tied.h"

#include <math.h>

typedef struct lift {
    int stages;
    double load; /* kg; a bar has a mass of 1 kg */
} lift;

/* Height lost by the load, in % of the lift's height, the largest value in 10 s. */
static tied_outcome height_lost(ledger *l, entrant e, const void *how) {
    const lift *x = how;
    scene s;
    scene_init(&s);
    fill_scissor(&s, x->stages, x->load);
    double worst = INFINITY;
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t) {
        int top = s.body_count - 1;
        double start = s.bodies[top].y;
        worst = 0;
        for (int i = 0; i < (l->quick ? 120 : 600) && trial_step(t); i++)
            worst = tied_worse(worst, fabs(trial_read(t)[top].y - start) / x->stages);
    }
    trial_end(t);
    scene_free(&s);
    return (tied_outcome){{100 * worst}};
}

static void tell_lifts(ledger *l) {
    static const tied_row LOST = {"height lost, %", 1, 0};
    static const struct {
        const char *about;
        lift lift;
    } CASES[] = {{"scissor of 5 stages, load 1 bar", {5, 1}},
                 {"scissor of 20 stages, load 1 bar", {20, 1}},
                 {"scissor of 20 stages, load 100 bars", {20, 100}},
                 {"scissor of 20 stages, load 100 times the lift", {20, 4000}}};
    for (int i = 0; i < 4; i++) {
        ledger_progress(l, "scissor", 0.15 * i);
        tied_tell(l, &LOST, 1, CASES[i].about, height_lost, &CASES[i].lift);
    }
}

/* A scene, of which worst_gaps gives the largest gap (mm), the largest angle error (degrees) and
 * the largest angle beyond a limit (degrees) in a run. */
typedef struct worst_case {
    void (*fill)(scene *s);
    int steps, quick_steps;
} worst_case;

static tied_outcome worst_gaps(ledger *l, entrant e, const void *how) {
    const worst_case *c = how;
    scene s;
    scene_init(&s);
    c->fill(&s);
    tied_outcome o = {{INFINITY, INFINITY, INFINITY}};
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t) {
        joint_gaps gaps = {0};
        for (int i = 0; i < (l->quick ? c->quick_steps : c->steps) && trial_step(t); i++)
            trial_joint_gaps(t, &gaps);
        if (gaps.lost == 0)
            o = (tied_outcome){{1000 * gaps.worst.length, DEGREES * gaps.worst.angle,
                                DEGREES * gaps.worst.beyond_angle}};
    }
    trial_end(t);
    scene_free(&s);
    return o;
}

static tied_outcome overshoot(ledger *l, entrant e, const void *how) {
    return (tied_outcome){{worst_gaps(l, e, how).value[2]}};
}

static void fill_slider_hung(scene *s) {
    fill_slider(s, true);
}

static void fill_slider_hit(scene *s) {
    fill_slider(s, false);
}

static void run(ledger *l) {
    static const tied_row PAST[] = {{"past its limit, degrees", 1, 1e-3}};
    static const tied_row GAPS[] = {{"sideways, mm", 1, 0}, {"turned, degrees", 0.5, 0}};
    static const tied_row GAP[] = {{"worst gap, mm", 1, 0}};
    static const worst_case DOOR = {fill_door, 120, 120}, HUNG = {fill_slider_hung, 600, 120},
                            HIT = {fill_slider_hit, 300, 120}, FOUR_BAR = {fill_four_bar, 600, 180};
    tell_lifts(l);
    ledger_progress(l, "door", 0.6);
    tied_tell(l, PAST, 1, "door with a knob of 100 kg hits its limit", overshoot, &DOOR);
    tied_tell(l, GAPS, 2, "slider, 100 times its mass hung on its corner", worst_gaps, &HUNG);
    tied_tell(l, GAPS, 2, "slider hit by 100 times its mass", worst_gaps, &HIT);
    ledger_progress(l, "four-bar linkage", 0.8);
    tied_tell(l, GAP, 1, "four-bar linkage, rocker 100 times", worst_gaps, &FOUR_BAR);
}

const extreme extreme_linkages = {
    .name = "linkages",
    .title = "Linkages, sliders and limits",
    .about =
        "A scissor lift of crossed bars of 1 kg, whose feet are fixed, under a load for 10 s; a "
        "door of 2 m and 10 kg that reaches its limit at 10 rad/s; a box of 1 kg on a level "
        "slider, loaded, or hit from above at 10 m/s off its centre; a rocker driven by a motor "
        "at one turn a second through a crank and a coupler of 1 kg. Worst of any step.",
    .run = run,
    .also = ON_BOX2D | ON_CHIPMUNK,
};
