/* springs.c: the extreme "springs": a body on a spring without gravity, compared with the solution
 * of the damped harmonic oscillator. Measured are the errors of frequency and damping ratio. */
#include "extremes/tied.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

typedef struct spring {
    scene_joint_kind kind;
    double frequency, damping;
} spring;

/* Reads the displacement from rest (m or rad), and the speed. */
static void see(trial *t, const spring *x, double *off, double *speed) {
    const engine_body *b = &trial_read(t)[1];
    bool turns = x->kind == SCENE_HINGE;
    double rest = 0.25 + (x->kind == SCENE_DISTANCE ? 2 : 0);
    *off = (turns ? atan2(b->sine, b->cosine) : b->x) - rest;
    *speed = turns ? b->angular_velocity : b->vx;
}

/* The frequency's error in %, from the times of zero crossings, and the error of the damping ratio,
 * from the energy at these times. */
static tied_outcome oscillate(ledger *l, entrant e, const void *how) {
    const spring *x = how;
    scene s;
    scene_init(&s);
    fill_spring(&s, x->kind, x->frequency, x->damping);
    tied_outcome o = {{INFINITY, INFINITY}};
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double first = 0, last = 0, first_speed = 0, last_speed = 0, before, speed_before, off, speed;
    int passes = 0, steps = (int)((l->quick ? 4 : 10) * 60 / x->frequency);
    if (t)
        see(t, x, &before, &speed_before);
    for (int i = 0; t && i < steps && trial_step(t); i++) {
        see(t, x, &off, &speed);
        if ((before < 0) != (off < 0)) {
            double part = before / (before - off);
            last = (i + part) * ENGINE_TIME_STEP;
            /* The speed at the crossing follows from the energy, because speeds are known at the
             * ends of steps only. */
            double way = 2 * PI * x->frequency * off;
            last_speed = hypot(speed, way);
            if (passes++ == 0)
                first = last, first_speed = last_speed;
        }
        before = off;
    }
    if (passes > 2) {
        double passed = (passes - 1) * PI;
        double seen = passed / (2 * PI * (last - first));
        double expected = x->frequency * sqrt(1 - x->damping * x->damping);
        double decay = log(first_speed / last_speed) / passed; /* zeta / sqrt(1 - zeta^2), per
                                                                  radian */
        o = (tied_outcome){
            {100 * fabs(seen / expected - 1), fabs(decay / sqrt(1 + decay * decay) - x->damping)}};
    }
    trial_end(t);
    scene_free(&s);
    return o;
}

static void run(ledger *l) {
    static const tied_row ROWS[] = {{"frequency off, %", 0, 0}, {"damping ratio off", 0, 0}};
    static const struct {
        const char *about;
        spring spring;
    } CASES[] = {{"slider, 1 Hz", {SCENE_SLIDER, 1, 0}},
                 {"slider, 5 Hz", {SCENE_SLIDER, 5, 0}},
                 {"slider, 5 Hz, damping ratio 0.1", {SCENE_SLIDER, 5, 0.1}},
                 {"slider, 10 Hz", {SCENE_SLIDER, 10, 0}},
                 {"distance, 5 Hz", {SCENE_DISTANCE, 5, 0}},
                 {"hinge, 5 Hz", {SCENE_HINGE, 5, 0}}};
    for (int i = 0; i < 6; i++) {
        ledger_progress(l, CASES[i].about, i / 6.0);
        tied_tell(l, ROWS, 2, CASES[i].about, oscillate, &CASES[i].spring);
    }
}

const extreme extreme_springs = {
    .name = "springs",
    .title = "Springs against their formulas",
    .about = "A body of 1 kg on a spring that starts stretched, undamped unless said otherwise: "
             "frequency and damping ratio as they come out over ten periods.",
    .run = run,
    .also = ON_BOX2D | ON_CHIPMUNK,
};
