/* trial.c: runs a scene by one entrant, and measures it alike for all. */
#include "trial.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct trial {
    ledger *ledger;
    const physics_engine *engine;
    const scene *scene;
    double origin_x, origin_y;
    void *world;
    engine_body *bodies;
    penetration_meter *meter;
};

static const thud_quality *const QUALITIES[ENTRANTS] = {
    [ENTRANT_DRAFT] = &thud_quality_draft,
    [ENTRANT_DEFAULT] = &thud_quality_default,
    [ENTRANT_HIGH] = &thud_quality_high,
    [ENTRANT_EXACT] = &thud_quality_exact,
};

trial *trial_begin(ledger *l, entrant e, const scene *s, engine_settings settings) {
    settings.quality = QUALITIES[e];
    settings.baseline_simd = l->baseline_simd;
    trial *t = calloc(1, sizeof *t);
    if (t) {
        const physics_engine *engine = engine_find(e == ENTRANT_BOX2D ? "box2d" : "thud");
        *t = (trial){.ledger = l, .engine = engine, .scene = s};
        t->bodies = calloc((size_t)s->body_count + 1, sizeof *t->bodies);
        t->world = engine ? engine_create(engine, s, settings) : NULL;
    }
    if (!t || !t->bodies || !t->world) {
        fprintf(stderr, "stability: %s could not make a world of %d bodies\n", entrant_name(e),
                s->body_count);
        l->failed = true;
        trial_end(t);
        return NULL;
    }
    return t;
}

void trial_end(trial *t) {
    if (!t)
        return;
    if (t->world)
        t->engine->destroy(t->world);
    penetration_meter_destroy(t->meter);
    free(t->bodies);
    free(t);
}

void trial_look_from(trial *t, double x, double y) {
    t->origin_x = x;
    t->origin_y = y;
}

bool trial_step(trial *t) {
    bool stepped = t->engine->step(t->world);
    if (!stepped)
        t->ledger->failed = true;
    return stepped;
}

bool trial_steps(trial *t, int count) {
    for (int i = 0; i < count; i++)
        if (!trial_step(t))
            return false;
    return true;
}

bool trial_set_time_step(trial *t, double seconds) {
    return t->engine->set_time_step(t->world, seconds);
}

bool trial_renew(trial *t, int body) {
    bool renewed = t->engine->renew(t->world, t->scene, body);
    if (!renewed)
        t->ledger->failed = true;
    return renewed;
}

bool trial_misuse(trial *t, int body, misuse call, double value) {
    return t->engine->misuse(t->world, body, call, value);
}

const engine_body *trial_read(trial *t) {
    t->engine->read(t->world, t->bodies);
    for (int i = 0; i < t->scene->body_count; i++) {
        t->bodies[i].x -= t->origin_x;
        t->bodies[i].y -= t->origin_y;
    }
    return t->bodies;
}

void trial_pose(trial *t, int body, float out[4]) {
    t->engine->pose(t->world, body, t->origin_x, t->origin_y, out);
}

void trial_penetration(trial *t, penetration *seen) {
    if (!t->meter)
        t->meter = penetration_meter_create(t->scene);
    if (!t->meter) {
        seen->worst = INFINITY;
        return;
    }
    t->engine->read(t->world, t->bodies); /* not relative: the meter knows where the ground is */
    penetration_sample(t->meter, t->bodies, seen);
    if (seen->lost > 0)
        seen->worst = INFINITY;
}

double trial_energy(trial *t, double floor) {
    const engine_body *bodies = trial_read(t);
    const scene *s = t->scene;
    double energy = 0;
    for (int i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_DYNAMIC)
            continue;
        const engine_body *b = &bodies[i];
        double gx = s->gravity_x * s->bodies[i].gravity_scale;
        double gy = s->gravity_y * s->bodies[i].gravity_scale;
        energy += 0.5 * b->mass * (b->vx * b->vx + b->vy * b->vy) +
                  0.5 * b->inertia * b->angular_velocity * b->angular_velocity -
                  b->mass * (gx * b->x + gy * (b->y - floor));
    }
    return energy;
}

double trial_speed(trial *t) {
    const engine_body *bodies = trial_read(t);
    double fastest = 0;
    for (int i = 0; i < t->scene->body_count; i++) {
        double speed = hypot(bodies[i].vx, bodies[i].vy);
        if (!isfinite(speed) || !isfinite(bodies[i].x) || !isfinite(bodies[i].y))
            return INFINITY;
        fastest = speed > fastest ? speed : fastest;
    }
    return fastest;
}

uint64_t trial_bytes(trial *t) {
    return t->engine->bytes(t->world);
}

uint64_t trial_allocations(trial *t) {
    return t->engine->allocations ? t->engine->allocations(t->world) : 0;
}

const scene *trial_scene(const trial *t) {
    return t->scene;
}
