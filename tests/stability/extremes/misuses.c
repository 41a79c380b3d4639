/* misuses.c: the extreme "wrong-input": calls with invalid arguments that concern one body of a
 * scene, and their effect on all other bodies. Each call is made in a process of its own, which may
 * crash. */
#include "trial.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const struct {
    misuse call;
    double value;
} CALLS[] = {
    {MISUSE_POSITION, NAN},      {MISUSE_POSITION, INFINITY},
    {MISUSE_ANGLE, NAN},         {MISUSE_ANGLE, INFINITY},
    {MISUSE_VELOCITY, NAN},      {MISUSE_VELOCITY, INFINITY},
    {MISUSE_SPIN, NAN},          {MISUSE_SPIN, INFINITY},
    {MISUSE_FORCE, NAN},         {MISUSE_FORCE, INFINITY},
    {MISUSE_TORQUE, NAN},        {MISUSE_TORQUE, INFINITY},
    {MISUSE_IMPULSE, NAN},       {MISUSE_IMPULSE, INFINITY},
    {MISUSE_IMPULSE_POINT, NAN}, {MISUSE_IMPULSE_POINT, INFINITY},
    {MISUSE_NEW_BODY, NAN},      {MISUSE_NEW_BODY, INFINITY},
    {MISUSE_RADIUS, NAN},        {MISUSE_RADIUS, INFINITY},
    {MISUSE_RADIUS, -1},         {MISUSE_DENSITY, NAN},
    {MISUSE_DENSITY, INFINITY},  {MISUSE_DENSITY, -100},
    {MISUSE_FRICTION, NAN},      {MISUSE_FRICTION, -1},
    {MISUSE_GRAVITY, NAN},       {MISUSE_GRAVITY, INFINITY},
    {MISUSE_TIME_STEP, NAN},     {MISUSE_TIME_STEP, INFINITY},
    {MISUSE_TIME_STEP, -1},      {MISUSE_RAY, NAN},
    {MISUSE_RAY, INFINITY},      {MISUSE_GONE, 0},
    {MISUSE_NOBODY, 0},
};

/* VICTIM, the body that the call concerns, is the second box of the stack; all other bodies count
 * as others. */
enum { CALL_COUNT = sizeof CALLS / sizeof CALLS[0], BODIES = 8, VICTIM = 2 };

/* A floor, a stack of five boxes, and two balls that roll far away from it. */
static void fill(scene *s) {
    scene_init(s);
    scene_static_box(s, 0, -1, 100, 1);
    for (int i = 0; i < 5; i++)
        scene_dynamic_box(s, 0, 0.5 + i, 0.5, 0.5);
    for (int i = 0; i < 2; i++)
        scene_dynamic_circle(s, 20 + 5 * i, 0.5, 0.5)->vx = 1 - 2 * i;
}

/* Bits of the exit code of the process: the call reported no error, other bodies changed, a body
 * was lost, or nothing could be measured. */
enum { SEEN_UNTOLD = 1, SEEN_AFFECTED = 2, SEEN_LOST = 4, SEEN_NOTHING_OF_IT = 8 };

/* Whether a pose or velocity is not finite. */
static bool is_lost(const engine_body *b) {
    return !isfinite(b->x + b->y + b->cosine + b->sine + b->vx + b->vy + b->angular_velocity);
}

static bool is_untouched(const engine_body *a, const engine_body *b) {
    return a->x == b->x && a->y == b->y && a->cosine == b->cosine && a->sine == b->sine &&
           a->vx == b->vx && a->vy == b->vy && a->angular_velocity == b->angular_velocity;
}

/* Runs two seconds with the invalid call and without it, in two worlds one after the other. Bodies
 * that the call does not affect have the same state bit for bit in both. */
static int see(ledger *l, entrant e, int which) {
    scene s;
    int seen = 0;
    engine_body without[BODIES];
    fill(&s);
    for (int wrong = 0; wrong < 2; wrong++) {
        trial *t = trial_begin(l, e, &s, (engine_settings){0});
        if (!t || !trial_steps(t, 30))
            return SEEN_NOTHING_OF_IT;
        if (wrong && !trial_misuse(t, VICTIM, CALLS[which].call, CALLS[which].value))
            seen |= SEEN_UNTOLD;
        if (!trial_steps(t, 120))
            return SEEN_NOTHING_OF_IT;
        const engine_body *now = trial_read(t);
        for (int i = 0; i < BODIES; i++)
            if (wrong && i != VICTIM) {
                seen |= is_untouched(&now[i], &without[i]) ? 0 : SEEN_AFFECTED;
                seen |= is_lost(&now[i]) ? SEEN_LOST : 0;
            }
        memcpy(without, now, sizeof without);
        trial_end(t);
    }
    scene_free(&s);
    return seen;
}

/* Calls `see` in a child process. If that does not exit normally, everything counts as lost. */
static int see_from_outside(ledger *l, entrant e, int which) {
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        alarm(20);
        if (!freopen("/dev/null", "w", stderr)) /* refusals are printed there */
            _exit(SEEN_NOTHING_OF_IT);
        _exit(see(l, e, which));
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child)
        return SEEN_NOTHING_OF_IT;
    return WIFEXITED(status) ? WEXITSTATUS(status) : SEEN_LOST | SEEN_AFFECTED | SEEN_UNTOLD;
}

static void run(ledger *l) {
    static const struct {
        const char *what;
        int seen;
    } FIGURES[] = {
        {"that end the program, or make other bodies not finite", SEEN_LOST},
        {"that affect other bodies", SEEN_AFFECTED},
        {"that give no result code", SEEN_UNTOLD},
    };
    enum { FIGURE_COUNT = sizeof FIGURES / sizeof FIGURES[0] };
    figure *figures[FIGURE_COUNT];
    for (int k = 0; k < FIGURE_COUNT; k++)
        figures[k] = ledger_add(l, bound_at_most(0, ON_THUD), "of %d wrong calls those %s",
                                CALL_COUNT, FIGURES[k].what);
    for (entrant e = 0; e < ENTRANTS; e++) {
        int counts[FIGURE_COUNT] = {0};
        if (!ledger_has(l, e))
            continue;
        for (int i = 0; i < CALL_COUNT; i++) {
            ledger_progress(l, "wrong calls", (double)(e * CALL_COUNT + i) / ENTRANTS / CALL_COUNT);
            int seen = see_from_outside(l, e, i);
            if (seen & SEEN_NOTHING_OF_IT) {
                fprintf(stderr, "stability: wrong call %d could not be tried\n", i);
                l->failed = true;
            }
            for (int k = 0; k < FIGURE_COUNT; k++)
                counts[k] += (seen & FIGURES[k].seen) != 0;
        }
        for (int k = 0; k < FIGURE_COUNT; k++)
            figure_tell(figures[k], e, counts[k]);
    }
}

const extreme extreme_wrong_input = {
    .name = "wrong-input",
    .title = "Wrong input",
    .about =
        "One of a stack of five gets a value that is not a number, infinite or negative: place, "
        "velocity, force, size, density and so on, or a call names nobody; both engines in "
        "release builds. Others are affected where two seconds later any of them is not, to "
        "the bit, as without the call.",
    .run = run,
};
