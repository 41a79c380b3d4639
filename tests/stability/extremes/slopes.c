/* slopes.c: the extreme "slopes": boxes and discs that slide, roll or stay on slopes, compared with
 * the formulas of mechanics.
 *
 * On a slope of angle a, with gravity g and friction coefficient u, a box slides with the
 * acceleration g (sin a - u cos a) if u < tan a, otherwise it stays. A disc of radius r rolls with
 * 2/3 g sin a if u >= tan a / 3; otherwise it slips with the box's acceleration, and its angular
 * velocity grows by 2 u g cos a / r per second. */
#include "trial.h"

#include <math.h>

#define DEGREE 0.017453292519943295
static const double GRAVITY = 10, HALF = 0.5;

typedef enum rider { RIDER_BOX = 0, RIDER_UPRIGHT, RIDER_DISC } rider;

typedef struct slope {
    rider rider;
    double degrees, friction;
    bool line; /* the ground is a terrain line; otherwise a turned box */
    int count; /* number of riders stacked on each other */
} slope;

/* The unit vector down the slope, which descends to the right. */
static scene_point downhill(const slope *c) {
    return (scene_point){cos(c->degrees * DEGREE), -sin(c->degrees * DEGREE)};
}

static void add_ground(scene *s, const slope *c) {
    enum { REACH = 100 };
    scene_point d = downhill(c);
    if (c->line) {
        const scene_point ends[] = {{-REACH * d.x, -REACH * d.y}, {REACH * d.x, REACH * d.y}};
        scene_add_body(s, SCENE_STATIC, 0, 0);
        scene_add_irregular(s, ends, 2);
    } else {
        scene_add_body(s, SCENE_STATIC, d.y, -d.x)->angle = -c->degrees * DEGREE;
        scene_add_obb(s, REACH, 1);
    }
}

/* Body 0 is the ground, whose surface goes through (0, 0); the riders follow, from the lowest to
 * the highest. */
static void fill(scene *s, const slope *c) {
    scene_init(s);
    s->gravity_y = -GRAVITY;
    s->material.friction = c->friction;
    add_ground(s, c);
    scene_point d = downhill(c);
    double lean = c->degrees * DEGREE;
    for (int i = 0; i < c->count; i++) {
        /* An AABB stands on its lower left corner. */
        double height =
            c->rider == RIDER_UPRIGHT ? HALF * (cos(lean) + sin(lean)) : HALF * (2 * i + 1);
        scene_body *b = scene_add_body(s, SCENE_DYNAMIC, -height * d.y, height * d.x);
        if (c->rider == RIDER_DISC)
            scene_add_circle(s, HALF);
        else if (c->rider == RIDER_UPRIGHT)
            scene_add_aabb(s, HALF, HALF);
        else
            scene_add_obb(s, HALF, HALF);
        if (c->rider == RIDER_BOX)
            b->angle = -lean;
    }
}

/* Whether a disc rolls without slipping: friction is at least a third of the slope. */
static bool rolls(const slope *c) {
    return c->rider == RIDER_DISC && 3 * c->friction >= tan(c->degrees * DEGREE);
}

/* The analytic acceleration downhill, m/s². */
static double acceleration_of(const slope *c) {
    double sine = sin(c->degrees * DEGREE), cosine = cos(c->degrees * DEGREE);
    return rolls(c) ? 2.0 / 3 * GRAVITY * sine : GRAVITY * (sine - c->friction * cosine);
}

/* The angular acceleration, positive clockwise, as a disc turns down the slope. */
static double spin_gain_of(const slope *c) {
    return rolls(c) ? acceleration_of(c) / HALF
                    : 2 * c->friction * GRAVITY * cos(c->degrees * DEGREE) / HALF;
}

typedef struct motion {
    double speed, spin; /* speed down the slope; angular velocity, positive clockwise */
} motion;

/* The larger of two errors; NaN counts as infinite. */
static double worse(double a, double b) {
    return a >= b ? a : b >= a ? b : INFINITY;
}

/* The rider's speed downhill and its angular speed in the direction of rolling. */
static motion motion_of(trial *t, const slope *c) {
    const engine_body *b = &trial_read(t)[1];
    scene_point d = downhill(c);
    return (motion){b->vx * d.x + b->vy * d.y, -b->angular_velocity};
}

/* The error of the acceleration and, for discs, of the angular acceleration, in %, the larger of
 * both. Measured from half a second on, when the contact has settled. */
static double slide(ledger *l, entrant e, const slope *c) {
    int seconds = l->quick ? 1 : 3;
    double wrong = INFINITY;
    scene s;
    fill(&s, c);
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t && trial_steps(t, 30)) {
        motion before = motion_of(t, c);
        if (trial_steps(t, 60 * seconds)) {
            motion after = motion_of(t, c);
            double gained = (after.speed - before.speed) / seconds;
            double turned = (after.spin - before.spin) / seconds;
            wrong = 100 * fabs(gained / acceleration_of(c) - 1);
            if (c->rider == RIDER_DISC)
                wrong = worse(wrong, 100 * fabs(turned / spin_gain_of(c) - 1));
        }
    }
    trial_end(t);
    scene_free(&s);
    return wrong;
}

/* The largest distance that a rider moves after the first second, in mm. */
static double creep(ledger *l, entrant e, const slope *c) {
    int seconds = l->quick ? 10 : 600;
    double furthest = INFINITY;
    scene s;
    fill(&s, c);
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t && trial_steps(t, 60)) {
        engine_body start[4];
        for (int i = 1; i <= c->count; i++)
            start[i] = trial_read(t)[i];
        if (trial_steps(t, 60 * seconds)) {
            const engine_body *now = trial_read(t);
            furthest = 0;
            for (int i = 1; i <= c->count; i++)
                furthest =
                    worse(furthest, 1000 * hypot(now[i].x - start[i].x, now[i].y - start[i].y));
        }
    }
    trial_end(t);
    scene_free(&s);
    return furthest;
}

typedef double measure(ledger *l, entrant e, const slope *c);

/* The larger error of both kinds of ground. */
static double worst_of(measure *m, ledger *l, entrant e, slope c) {
    c.line = false;
    double on_box = m(l, e, &c);
    c.line = true;
    return worse(on_box, m(l, e, &c));
}

static void run_slides(ledger *l) {
    static const struct {
        const char *what;
        rider rider;
        double degrees, friction;
    } CASES[] = {
        {"box slides", RIDER_BOX, 30, 0},
        {"box slides", RIDER_BOX, 20, 0.1},
        {"box slides", RIDER_BOX, 30, 0.3},
        {"box slides", RIDER_BOX, 40, 0.5},
        {"upright box slides", RIDER_UPRIGHT, 30, 0.3},
        {"disc rolls", RIDER_DISC, 10, 0.6},
        {"disc rolls", RIDER_DISC, 30, 0.6},
        {"disc rolls", RIDER_DISC, 45, 0.6},
        {"disc slips", RIDER_DISC, 45, 0.1},
        {"disc slips", RIDER_DISC, 60, 0.3},
    };
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    for (int i = 0; i < CASE_COUNT; i++) {
        slope c = {CASES[i].rider, CASES[i].degrees, CASES[i].friction, .count = 1};
        figure *f = ledger_add(l, bound_at_most(0.1, ON_DEFAULT | ON_EXACT),
                               "%s at %g degrees, friction %g: acceleration, %% off", CASES[i].what,
                               c.degrees, c.friction);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, f->what, 0.1 * i / CASE_COUNT);
            if (ledger_has(l, e))
                figure_tell(f, e, worst_of(slide, l, e, c));
        }
    }
}

static void run_creeps(ledger *l) {
    static const struct {
        const char *what;
        rider rider;
        double degrees;
        int count;
    } CASES[] = {
        {"box", RIDER_BOX, 10, 1},
        {"box", RIDER_BOX, 20, 1},
        {"box", RIDER_BOX, 30, 1},
        {"upright box", RIDER_UPRIGHT, 30, 1},
        {"stack of three boxes", RIDER_BOX, 10, 3},
    };
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    for (int i = 0; i < CASE_COUNT; i++) {
        slope c = {CASES[i].rider, CASES[i].degrees, 0.6, .count = CASES[i].count};
        figure *f =
            ledger_add(l, bound_at_most(1, ON_DEFAULT | ON_EXACT),
                       "%s at %g degrees, friction 0.6: creep, mm", CASES[i].what, c.degrees);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, f->what, 0.1 + 0.9 * i / CASE_COUNT);
            if (ledger_has(l, e))
                figure_tell(f, e, worst_of(creep, l, e, c));
        }
    }
}

static void run(ledger *l) {
    run_slides(l);
    run_creeps(l);
}

const extreme extreme_slopes = {
    .name = "slopes",
    .title = "Slopes",
    .about =
        "Boxes of 1 m and discs on slopes, both a turned box and a line: those that slide or roll "
        "for 3 s, after half a second to settle, and those that friction holds for 10 minutes. "
        "Figures: how far the acceleration, of discs also that of the spin, is off the formula; "
        "and how far what should stay has moved. The worse of the two grounds.",
    .run = run,
};
