/* trial.c: see trial.h. */
#include "trial.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

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

static const char *engine_of(entrant e) {
    return e >= ENTRANT_CHIPMUNK ? "chipmunk" : e >= ENTRANT_BOX2D ? "box2d" : "thud";
}

/* Hz: above any stiffness; Box2D lowers it to the maximum for its substeps. */
static const double MOST_HERTZ = 1000;

bool trial_is_possible(entrant e, const scene *s) {
    const physics_engine *engine = engine_find(engine_of(e));
    return !engine || engine_can_build(engine, s);
}

trial *trial_begin(ledger *l, entrant e, const scene *s, engine_settings settings) {
    settings.quality = QUALITIES[e];
    if (e == ENTRANT_BOX2D_STIFF) {
        settings.substeps = 16;
        settings.contact_hertz = settings.joint_hertz = MOST_HERTZ;
        settings.joint_damping = 10;
    }
    settings.iterations = e == ENTRANT_CHIPMUNK_160 ? 160 : 0;
    settings.baseline_simd = l->baseline_simd;
    trial *t = calloc(1, sizeof *t);
    if (t) {
        const physics_engine *engine = engine_find(engine_of(e));
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
    t->engine->read(t->world,
                    t->bodies); /* absolute positions: the meter knows where the ground is */
    penetration_sample(t->meter, t->bodies, seen);
    if (seen->lost > 0)
        seen->worst = INFINITY;
}

void trial_joint_gaps(trial *t, joint_gaps *seen) {
    joint_gaps_sample(t->scene, trial_read(t), seen);
}

static double kinetic_of(const engine_body *b) {
    return 0.5 * b->mass * (b->vx * b->vx + b->vy * b->vy) +
           0.5 * b->inertia * b->angular_velocity * b->angular_velocity;
}

double trial_kinetic_energy(trial *t) {
    const engine_body *bodies = trial_read(t);
    double energy = 0;
    for (int i = 0; i < t->scene->body_count; i++)
        if (t->scene->bodies[i].kind == SCENE_DYNAMIC)
            energy += kinetic_of(&bodies[i]);
    return energy;
}

/* The centre of mass in the body's frame. */
static scene_point center_of(const scene *s, const scene_body *body) {
    scene_point sum = {0, 0};
    double mass = 0;
    for (int i = 0; i < body->shape_count; i++) {
        const scene_shape *shape = &s->shapes[body->first_shape + i];
        double area =
            shape->kind == SCENE_CIRCLE ? PI * shape->hx * shape->hx : 4 * shape->hx * shape->hy;
        double kg = shape->material.density * area;
        mass += kg;
        sum.x += kg * shape->x;
        sum.y += kg * shape->y;
    }
    return mass > 0 ? (scene_point){sum.x / mass, sum.y / mass} : sum;
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
        scene_point center = center_of(s, &s->bodies[i]);
        double x = b->x + b->cosine * center.x - b->sine * center.y;
        double y = b->y + b->sine * center.x + b->cosine * center.y;
        energy += kinetic_of(b) - b->mass * (gx * x + gy * (y - floor));
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
