/* yardstick.c: see yardstick.h. States are scored by the oracle's meter (tests/oracle); errors that
 * engines report themselves are not used. */
#include "yardstick.h"

#include "linkage.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

struct yardstick {
    const tradeoff_case *c;
    const scene *scene;
    oracle_meter *meter;
    linkage *linkage; /* null: the case has no linkage */
    engine_body *expected;
    double fall; /* J: energy that all bodies release when they fall by a metre */
    oracle_score start;
    double kinetic_most, energy_most;
    double penetration_worst, penetration_sum; /* m; the sum is over all touching pairs and all
                                                  steps */
    double touching;                           /* number of touching pairs in all steps */
    double folded; /* the largest, the sum or the last of the steps' errors so far */
    double time;   /* s: time of the linkage */
    long steps;
    int lost;
};

/* The mass of a body with one shape, kg. */
static double mass_of(const scene_shape *shape) {
    double area =
        shape->kind == SCENE_CIRCLE ? PI * shape->hx * shape->hx : 4 * shape->hx * shape->hy;
    return shape->material.density * area;
}

yardstick *yardstick_create(const tradeoff_case *c, const scene *s) {
    yardstick *y = calloc(1, sizeof *y);
    if (!y)
        return NULL;
    y->c = c;
    y->scene = s;
    y->meter = oracle_meter_create(s);
    if (c->has_linkage) {
        y->linkage = linkage_create(s, 0);
        y->expected = calloc((size_t)s->body_count, sizeof *y->expected);
    }
    if (!y->meter || (c->has_linkage && !(y->linkage && y->expected))) {
        yardstick_destroy(y);
        return NULL;
    }
    for (int i = 0; i < s->body_count; i++)
        if (s->bodies[i].kind == SCENE_DYNAMIC)
            y->fall += hypot(s->gravity_x, s->gravity_y) * s->length_scale *
                       mass_of(&s->shapes[s->bodies[i].first_shape]);
    return y;
}

void yardstick_destroy(yardstick *y) {
    if (!y)
        return;
    oracle_meter_destroy(y->meter);
    linkage_destroy(y->linkage);
    free(y->expected);
    free(y);
}

bool yardstick_begin(yardstick *y, const engine_body *bodies) {
    bool ok = oracle_measure(y->meter, bodies, &y->start);
    y->energy_most = y->start.energy;
    y->kinetic_most = y->start.kinetic_energy;
    return ok;
}

bool yardstick_look(yardstick *y, const engine_body *bodies, double time) {
    sighting now = {
        .scene = y->scene,
        .bodies = bodies,
        .time = time,
        .start = &y->start,
    };
    y->steps++;
    if (y->linkage) {
        if (!linkage_advance(y->linkage, time - y->time))
            return false;
        linkage_read(y->linkage, y->expected);
        now.expected = y->expected;
        y->time = time;
    }
    if (!oracle_measure(y->meter, bodies, &now.score))
        return false;
    if (now.score.lost > 0) {
        y->lost = now.score.lost > y->lost ? now.score.lost : y->lost;
        return true;
    }
    y->penetration_worst = fmax(y->penetration_worst, now.score.penetration_max);
    y->penetration_sum += now.score.penetration_mean * now.score.touching;
    y->touching += now.score.touching;
    y->energy_most = fmax(y->energy_most, now.score.energy);
    y->kinetic_most = fmax(y->kinetic_most, now.score.kinetic_energy);
    double error = y->c->error_of(&now);
    y->folded = y->c->fold == CASE_WORST  ? fmax(y->folded, error)
                : y->c->fold == CASE_MEAN ? y->folded + error
                                          : error;
    return true;
}

errors yardstick_conclude(const yardstick *y) {
    double error = y->c->fold == CASE_MEAN ? y->folded / (double)y->steps : y->folded;
    return (errors){
        .error = y->lost > 0 ? INFINITY : error,
        .penetration_worst = y->penetration_worst,
        .penetration_mean = y->touching > 0 ? y->penetration_sum / y->touching : 0,
        .energy_gained = (y->energy_most - y->start.energy) / fmax(y->fall, y->kinetic_most),
        .lost = y->lost,
    };
}
