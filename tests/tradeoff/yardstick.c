/* yardstick.c: see yardstick.h. Masses are computed from the scene, places and velocities are read
 * back through each engine's public API: nothing that an engine says of its own errors counts. */
#include "yardstick.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

typedef struct inertial {
    double mass, inertia; /* about the centre of mass, which is the origin: one shape, centred */
} inertial;

struct yardstick {
    const tradeoff_case *c;
    const scene *scene;
    penetration_meter *meter;
    inertial *inertial;
    double floor_y, energy_start, energy_most, kinetic_most;
    penetration overlap;
    double folded; /* so far: the worst, the sum or the last of the steps' errors */
    long steps;
    int lost;
};

static inertial inertial_of(const scene_shape *shape) {
    bool circle = shape->kind == SCENE_CIRCLE;
    double area = circle ? PI * shape->hx * shape->hx : 4 * shape->hx * shape->hy;
    double square = circle ? 0.5 * shape->hx * shape->hx
                           : (shape->hx * shape->hx + shape->hy * shape->hy) / 3;
    double mass = shape->material.density * area;
    return (inertial){mass, mass * square};
}

yardstick *yardstick_create(const tradeoff_case *c, const scene *s) {
    yardstick *y = calloc(1, sizeof *y);
    if (!y)
        return NULL;
    y->c = c;
    y->scene = s;
    y->meter = penetration_meter_create(s);
    y->inertial = calloc((size_t)s->body_count + 1, sizeof *y->inertial);
    if (!y->meter || !y->inertial) {
        yardstick_destroy(y);
        return NULL;
    }
    y->floor_y = INFINITY;
    for (int i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_DYNAMIC)
            continue;
        y->inertial[i] = inertial_of(&s->shapes[s->bodies[i].first_shape]);
        y->floor_y = fmin(y->floor_y, s->bodies[i].y);
    }
    return y;
}

void yardstick_destroy(yardstick *y) {
    if (!y)
        return;
    penetration_meter_destroy(y->meter);
    free(y->inertial);
    free(y);
}

typedef struct energy {
    double kinetic, potential; /* J; potential above the lowest start */
} energy;

static energy energy_of(const yardstick *y, const contender_body *bodies) {
    const scene *s = y->scene;
    energy sum = {0};
    for (int i = 0; i < s->body_count; i++) {
        const contender_body *b = &bodies[i];
        const inertial *m = &y->inertial[i];
        if (m->mass == 0)
            continue;
        double turning = s->bodies[i].fixed_rotation ? 0 : b->angular_velocity;
        sum.kinetic += 0.5 * m->mass * (b->vx * b->vx + b->vy * b->vy) +
                       0.5 * m->inertia * turning * turning;
        sum.potential -= s->bodies[i].gravity_scale * m->mass *
                         (s->gravity_x * b->x + s->gravity_y * (b->y - y->floor_y));
    }
    return sum;
}

void yardstick_begin(yardstick *y, const contender_body *bodies) {
    energy e = energy_of(y, bodies);
    y->energy_start = y->energy_most = e.kinetic + e.potential;
    y->kinetic_most = e.kinetic;
}

static int count_lost(const yardstick *y, const contender_body *bodies) {
    int lost = 0;
    for (int i = 0; i < y->scene->body_count; i++) {
        const contender_body *b = &bodies[i];
        lost += !isfinite(b->x + b->y + b->cosine + b->sine + b->vx + b->vy + b->angular_velocity);
    }
    return lost;
}

void yardstick_look(yardstick *y, const contender_body *bodies, double time) {
    y->steps++;
    int lost = count_lost(y, bodies);
    if (lost > 0) {
        y->lost = lost > y->lost ? lost : y->lost;
        return;
    }
    energy e = energy_of(y, bodies);
    sighting now = {
        .scene = y->scene,
        .bodies = bodies,
        .time = time,
        .energy = e.kinetic + e.potential,
        .energy_start = y->energy_start,
    };
    penetration_sample(y->meter, bodies, &now.overlap);
    y->overlap.worst = fmax(y->overlap.worst, now.overlap.worst);
    y->overlap.sum += now.overlap.sum;
    y->overlap.pairs += now.overlap.pairs;
    y->energy_most = fmax(y->energy_most, now.energy);
    y->kinetic_most = fmax(y->kinetic_most, e.kinetic);
    double error = y->c->error_of(&now);
    y->folded = y->c->fold == CASE_WORST  ? fmax(y->folded, error)
                : y->c->fold == CASE_MEAN ? y->folded + error
                                          : error;
}

errors yardstick_conclude(const yardstick *y) {
    double turned_over = fmax(y->energy_start, y->kinetic_most);
    double error = y->c->fold == CASE_MEAN ? y->folded / (double)y->steps : y->folded;
    return (errors){
        .error = y->lost > 0 ? INFINITY : error,
        .penetration_worst = y->overlap.worst,
        .penetration_mean = penetration_mean(&y->overlap),
        .energy_gained = turned_over > 0 ? (y->energy_most - y->energy_start) / turned_over : 0,
        .lost = y->lost,
    };
}
