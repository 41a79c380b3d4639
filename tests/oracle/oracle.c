/* oracle.c: the reference simulation, see oracle.h. A step ends at the next impact, or at its
 * maximum length, and uses Moreau's midpoint rule: half of the motion with the old velocities, the
 * contact laws for the new velocities at the midpoint, and the other half with the new velocities
 * (J. J. Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988). Under
 * constant forces the rule is exact; otherwise it is of second order, and of first order if a body
 * turns about a corner. */
#include "oracle.h"

#include "sim/sim.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTINGS = 8, MOST_EVENTS = 2000 };

/* An approach that gravity causes within this number of steps is not treated as an impact, unless
 * it bounces. */
static const double SLOW_STEPS = 4;

oracle_settings oracle_default_settings(void) {
    return (oracle_settings){.step = 1.0 / 1920, .restitution_threshold = 0.01};
}

static void place_bodies(oracle *o) {
    const scene *s = o->model.scene;
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const model_body *body = &o->model.bodies[i];
        double c = cos(b->angle), sine = sin(b->angle);
        o->places[i] = (motion){b->x + body->center_x * c - body->center_y * sine,
                                b->y + body->center_x * sine + body->center_y * c, b->angle};
        if (b->kind != SCENE_STATIC)
            o->velocities[i] = (motion){b->vx, b->vy, b->fixed_rotation ? 0 : b->angular_velocity};
        o->masses[i] = (inverse_mass){body->inverse_mass, body->inverse_inertia};
    }
}

static bool is_sound(const oracle_settings *s) {
    return isfinite(s->step) && s->step > 0 && isfinite(s->restitution_threshold) &&
           s->restitution_threshold >= 0;
}

oracle *oracle_create(const scene *s, const oracle_settings *settings) {
    oracle_settings chosen = settings ? *settings : oracle_default_settings();
    oracle *o = !s->failed && is_sound(&chosen) ? calloc(1, sizeof *o) : NULL;
    if (!o)
        return NULL;
    o->settings = chosen;
    if (!model_init(&o->model, s)) {
        free(o);
        return NULL;
    }
    size_t bodies = (size_t)s->body_count + 1;
    o->solver = contact_solver_create(s->body_count);
    o->masses = calloc(bodies, sizeof *o->masses);
    o->places = calloc(bodies, sizeof *o->places);
    o->velocities = calloc(bodies, sizeof *o->velocities);
    o->scratch = calloc(bodies, sizeof *o->scratch);
    o->margins = calloc((size_t)o->model.shape_count + 1, sizeof *o->margins);
    if (!o->solver || !o->masses || !o->places || !o->velocities || !o->scratch || !o->margins ||
        !near_pairs_init(&o->near, &o->model)) {
        oracle_destroy(o);
        return NULL;
    }
    o->tiny = 1e-6 * s->length_scale;
    o->slow = fmax(SLOW_STEPS * hypot(s->gravity_x, s->gravity_y) * chosen.step, o->tiny);
    place_bodies(o);
    return o;
}

void oracle_destroy(oracle *o) {
    if (!o)
        return;
    model_free(&o->model);
    near_pairs_free(&o->near);
    contact_solver_destroy(o->solver);
    free(o->masses);
    free(o->places);
    free(o->velocities);
    free(o->scratch);
    free(o->margins);
    free(o->found.contacts);
    free(o->active.contacts);
    free(o->chosen.contacts);
    free(o->forces);
    free(o);
}

/* Moves all bodies by their velocities. */
static void drift(oracle *o, double time) {
    for (int i = 0; i < o->model.scene->body_count; i++) {
        o->places[i].x += time * o->velocities[i].x;
        o->places[i].y += time * o->velocities[i].y;
        o->places[i].turn += time * o->velocities[i].turn;
    }
}

/* The mean of exp(-rate t) over the time: the factor of an acceleration under linear damping. */
static double damped_share(double rate, double time) {
    return rate > 0 ? -expm1(-rate * time) / (rate * time) : 1;
}

/* Applies gravity and damping to the velocities, with the exact solution for constant forces. */
static void apply_forces(oracle *o, double time) {
    const scene *s = o->model.scene;
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        motion *v = &o->velocities[i];
        if (!o->model.bodies[i].dynamic)
            continue;
        double keep = exp(-b->linear_damping * time);
        double gain = time * b->gravity_scale * damped_share(b->linear_damping, time);
        v->x = v->x * keep + gain * s->gravity_x;
        v->y = v->y * keep + gain * s->gravity_y;
        v->turn *= exp(-b->angular_damping * time);
    }
}

/* Copies contacts from `found` at the midpoint to `active`: those that can close within the step. A
 * fast contact that does not arrive is left to the impact that ends this step or a later one. */
static bool activate(oracle *o, double time) {
    o->active.count = 0;
    for (int i = 0; i < o->found.count; i++) {
        contact c = o->found.contacts[i];
        double approach = -contact_normal_speed(&c, o->velocities);
        if (c.gap > 0 && approach > sim_least_impact(o, &c) && c.gap > 0.4 * approach * time)
            continue;
        c.bias = fmax(0, c.gap) / time;
        if (!sim_list_add(&o->active, &c))
            return false;
    }
    return true;
}

/* Finds the contacts, and corrects overlaps, until there are none; at most PARTINGS times. */
static bool look(oracle *o, double time) {
    bool moved = true;
    for (int i = 0; moved && i < PARTINGS; i++)
        if (!sim_find_contacts(o, time) || !sim_part_overlaps(o, &moved))
            return false;
    return !moved || sim_find_contacts(o, time);
}

/* Makes one step of at most `limit` seconds; *taken is its length. */
static bool step(oracle *o, double limit, bool heed_impacts, double *taken) {
    long before = o->report.impacts;
    if (!look(o, limit) || !sim_impacts(o))
        return false;
    /* Bodies that have bounced have new velocities, so contacts are found anew. */
    if (o->report.impacts > before && !sim_find_contacts(o, limit))
        return false;
    double time = heed_impacts ? sim_time_to_impact(o, limit) : limit;
    drift(o, 0.5 * time);
    if (!sim_find_contacts(o, time) || !activate(o, time))
        return false;
    apply_forces(o, time);
    contact_solution solution =
        contact_solve(o->solver, o->active.contacts, o->active.count, o->masses, o->velocities);
    if (!solution.ok)
        return false;
    drift(o, 0.5 * time);
    o->last_step = *taken = time;
    o->report.steps++;
    o->report.time += time;
    o->report.hard_solves += solution.hard;
    o->report.residual_max = fmax(o->report.residual_max, solution.residual);
    return true;
}

/* Advances by `duration` in one step, or in several that end at impacts. After MOST_EVENTS steps
 * impacts are no longer looked for. */
static bool steps(oracle *o, double duration) {
    double left = duration, shortest = 1e-15 * (1 + o->report.time);
    for (int event = 0; left > shortest; event++) {
        double taken;
        if (!step(o, left, event < MOST_EVENTS, &taken))
            return false;
        left -= taken;
    }
    return true;
}

bool oracle_advance(oracle *o, double seconds) {
    if (!isfinite(seconds) || seconds < 0)
        return false;
    double count = ceil(seconds / o->settings.step * (1 - 1e-9));
    for (double i = 0; i < count; i++)
        if (!steps(o, seconds / count))
            return false;
    return true;
}

void oracle_read(const oracle *o, engine_body *bodies) {
    for (int i = 0; i < o->model.scene->body_count; i++) {
        const model_body *body = &o->model.bodies[i];
        const motion *at = &o->places[i], *v = &o->velocities[i];
        double c = cos(at->turn), s = sin(at->turn);
        bodies[i] = (engine_body){
            .x = at->x - body->center_x * c + body->center_y * s,
            .y = at->y - body->center_x * s - body->center_y * c,
            .cosine = c,
            .sine = s,
            .vx = v->x,
            .vy = v->y,
            .angular_velocity = v->turn,
            .mass = body->mass,
            .inertia = body->inertia,
            .awake = body->dynamic,
        };
    }
}

oracle_report oracle_get_report(const oracle *o) {
    return o->report;
}

const oracle_force *oracle_forces(oracle *o, int *count) {
    *count = 0;
    oracle_force *forces = realloc(o->forces, ((size_t)o->active.count + 1) * sizeof *forces);
    if (!forces)
        return NULL;
    o->forces = forces;
    for (int i = 0; i < o->active.count; i++) {
        const contact *c = &o->active.contacts[i];
        if (c->normal > 0)
            forces[(*count)++] = (oracle_force){c->body_a,
                                                c->body_b,
                                                c->x,
                                                c->y,
                                                c->normal_x,
                                                c->normal_y,
                                                c->normal / o->last_step,
                                                c->tangent / o->last_step};
    }
    return forces;
}

bool oracle_run(const scene *s, const oracle_settings *settings, const double *times, int count,
                engine_body *samples, oracle_report *report) {
    oracle *o = oracle_create(s, settings);
    bool good = o != NULL;
    double now = 0;
    for (int i = 0; good && i < count; i++) {
        good = oracle_advance(o, times[i] - now);
        now = times[i];
        if (good)
            oracle_read(o, &samples[(size_t)i * (size_t)s->body_count]);
    }
    if (good && report)
        *report = oracle_get_report(o);
    oracle_destroy(o);
    return good;
}
