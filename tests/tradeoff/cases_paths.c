/* cases_paths.c: cases whose exact motion is known in closed form (sliding, rolling, elastic
 * impacts); the error is the distance from it. */
#include "case.h"

#include <math.h>

static const double GRAVITY = 10; /* m/s^2: the default of scenes */

/* The unit vector downhill is (run, -rise); the angle is in rad. */
typedef struct incline {
    double run, rise, angle;
} incline;

static const incline INCLINES[] = {
    {0.98480775301220806, 0.17364817766693035, 0.17453292519943295}, /* 10 degrees */
    {0.93969262078590839, 0.34202014332566873, 0.34906585039886590}, /* 20 */
    {0.86602540378443865, 0.5, 0.52359877559829887},                 /* 30 */
    {0.76604444311897804, 0.64278760968653933, 0.69813170079773179}, /* 40 */
};

static const double HALF = 0.5, FRICTION = 0.5;

/* Adds an incline, a straight terrain line, and returns the centre of a body of half extent HALF
 * that stands on it at rest. Incline and body are bodies 2 i and 2 i + 1. */
static scene_point add_incline(scene *s, int i, const incline *d) {
    const scene_point line[] = {{-10 * d->run, 10 * d->rise}, {60 * d->run, -60 * d->rise}};
    double x = 100.0 * i;
    s->material.friction = FRICTION;
    scene_add_body(s, SCENE_STATIC, x, 0);
    scene_add_irregular(s, line, 2);
    return (scene_point){x + HALF * d->rise, HALF * d->run};
}

static bool fill_slope(scene *s, int size) {
    for (int i = 0; i < size; i++) {
        scene_point place = add_incline(s, i, &INCLINES[i]);
        scene_dynamic_box(s, place.x, place.y, HALF, HALF)->angle = -INCLINES[i].angle;
    }
    return !s->failed;
}

static bool fill_rolling(scene *s, int size) {
    for (int i = 0; i < size; i++) {
        scene_point place = add_incline(s, i, &INCLINES[i]);
        scene_dynamic_circle(s, place.x, place.y, HALF);
    }
    return !s->failed;
}

/* The largest distance of a body from its exact place, m: it starts at rest and moves down its
 * incline with constant acceleration. */
static double off_path(const sighting *now, double (*acceleration)(const incline *)) {
    double worst = 0;
    for (int i = 0; 2 * i < now->scene->body_count; i++) {
        const scene_body *start = &now->scene->bodies[2 * i + 1];
        const engine_body *body = &now->bodies[2 * i + 1];
        double way = 0.5 * acceleration(&INCLINES[i]) * now->time * now->time;
        worst = fmax(worst, hypot(body->x - start->x - way * INCLINES[i].run,
                                  body->y - start->y + way * INCLINES[i].rise));
    }
    return worst;
}

/* Coulomb friction: the box stays if friction can hold it. */
static double sliding(const incline *d) {
    return fmax(0, GRAVITY * (d->rise - FRICTION * d->run));
}

/* A disc (inertia m r^2 / 2) that rolls without slipping, since tan(angle) is below three times the
 * friction on all inclines. */
static double rolling(const incline *d) {
    return 2.0 / 3.0 * GRAVITY * d->rise;
}

static double off_sliding_path(const sighting *now) {
    return off_path(now, sliding);
}

static double off_rolling_path(const sighting *now) {
    return off_path(now, rolling);
}

/* The scene has rows in which 1, 2 and 3 balls fly in; bodies 0 and 1 are walls. At the last step
 * as many balls must have left at the other side with the same speed, and not have reached the
 * wall. Returns the largest velocity error over that speed. */
static double speed_off(const sighting *now) {
    const double speed = 5;
    int length = (now->scene->body_count - 2) / 3;
    double worst = 0;
    for (int row = 0; row < 3; row++) {
        for (int i = 0; i < length; i++) {
            const engine_body *ball = &now->bodies[2 + row * length + i];
            double expected = i >= length - 1 - row ? speed : 0;
            worst = fmax(worst, hypot(ball->vx - expected, ball->vy) / speed);
        }
    }
    return worst;
}

const tradeoff_case case_slope = {
    .name = "slope",
    .title = "Slope with friction",
    .about =
        "Boxes with friction 0.5 on slopes of 10, 20, 30 and 40 degrees, for 4 s: the steep two "
        "slide.",
    .error = "furthest off the analytic path",
    .unit = "m",
    .size = 4,
    .quick_size = 4,
    .steps = 240,
    .quick_steps = 60,
    .floor = 1e-4,
    .chance = 1,
    .fold = CASE_WORST,
    .fill = fill_slope,
    .error_of = off_sliding_path,
};

const tradeoff_case case_rolling = {
    .name = "rolling",
    .title = "Rolling",
    .about = "Discs roll from rest down slopes of 10, 20, 30 and 40 degrees, for 4 s.",
    .error = "furthest off the analytic path",
    .unit = "m",
    .size = 4,
    .quick_size = 4,
    .steps = 240,
    .quick_steps = 60,
    .floor = 1e-4,
    .chance = 1,
    .fold = CASE_WORST,
    .fill = fill_rolling,
    .error_of = off_rolling_path,
};

const tradeoff_case case_cradle = {
    .name = "cradle",
    .title = "Newton's cradle",
    .about = "One, two and three elastic balls fly at 5 m/s into rows that rest; as many leave.",
    .error = "speed wrong, of what should leave",
    .unit = "",
    .size = 5,
    .quick_size = 5,
    .steps = 120,
    .quick_steps = 120,
    .floor = 1e-6,
    .chance = 1,
    .fold = CASE_LAST,
    .built_in = &scene_cradle,
    .error_of = speed_off,
};
