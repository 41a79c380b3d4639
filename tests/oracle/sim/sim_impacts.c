/* sim_impacts.c: finds the time of the next impact, and solves impacts.
 *
 * In an impact the contacts that approach are solved together (Newton's restitution for each
 * contact), then those that approach as a result, until there is none: in this way a row of
 * touching balls transfers momentum to its end. Contacts without restitution are brought to rest
 * together. */
#include "sim/sim.h"

#include "touch.h"

#include <math.h>
#include <string.h>

/* A sequence of elastic impacts at one time is cut off after this number. Chosen. */
enum { MOST_BOUNCES = 10000 };

/* The smallest t > 0 with gap = approach t + acceleration t^2 / 2, and the approach at that time;
 * infinite if there is none. */
static double time_to_close(double gap, double approach, double acceleration, double *speed) {
    *speed = 0;
    double discriminant = approach * approach + 2 * acceleration * gap;
    if (discriminant < 0)
        return HUGE_VAL;
    *speed = sqrt(discriminant);
    double divisor = approach + *speed;
    return divisor > 0 ? 2 * gap / divisor : HUGE_VAL;
}

/* The acceleration of b relative to a against the normal that gravity causes. */
static double gravity_approach(const oracle *o, int body_a, int body_b, double normal_x,
                               double normal_y) {
    const scene *s = o->model.scene;
    double of_a = o->model.bodies[body_a].dynamic ? s->bodies[body_a].gravity_scale : 0;
    double of_b = o->model.bodies[body_b].dynamic ? s->bodies[body_b].gravity_scale : 0;
    return -(of_b - of_a) * (s->gravity_x * normal_x + s->gravity_y * normal_y);
}

double sim_least_impact(const oracle *o, const contact *c) {
    return c->restitution > 0 ? fmax(o->settings.restitution_threshold, o->tiny) : o->slow;
}

/* Whether the gap is small enough to count as closed. */
static bool is_closed(const contact *c) {
    return c->gap <= SIM_CLOSED * c->size;
}

/* Two boxes that approach corner to corner have no contact points, but cannot collide before the
 * separation along the best axis is closed. If rotation dominates, the step is limited by contact
 * points that are found in time. */
static double time_between_boxes(const oracle *o, near_pair pair, double limit) {
    const model_shape *a = &o->model.shapes[pair.a], *b = &o->model.shapes[pair.b];
    touch_point points[2];
    touch_axis axis;
    touch_pair(&a->solid, &b->solid, HUGE_VAL, points, &axis);
    const motion *va = &o->velocities[a->body], *vb = &o->velocities[b->body];
    double approach = -(vb->x - va->x) * axis.normal_x - (vb->y - va->y) * axis.normal_y;
    double turning = fabs(va->turn) * a->reach + fabs(vb->turn) * b->reach;
    double size = fmin(a->size, b->size);
    if (axis.separation <= SIM_CLOSED * size || approach < turning || approach * limit < 0.1 * size)
        return limit;
    double speed, gravity = gravity_approach(o, a->body, b->body, axis.normal_x, axis.normal_y);
    return fmin(limit, time_to_close(axis.separation, approach + turning, gravity, &speed));
}

/* Over a line with several segments a step ends after a tenth of the body's size, so that contacts
 * are found anew. */
static double time_over_ground(const oracle *o, near_pair pair, double limit) {
    const model_shape *a = &o->model.shapes[pair.a], *b = &o->model.shapes[pair.b];
    const motion *v = &o->velocities[b->body];
    double speed = hypot(v->x, v->y);
    return a->line.count > 2 && speed * limit > 0.1 * b->size ? 0.1 * b->size / speed : limit;
}

double sim_time_to_impact(oracle *o, double limit) {
    double time = limit;
    for (int i = 0; i < o->found.count; i++) {
        const contact *c = &o->found.contacts[i];
        if (is_closed(c))
            continue;
        double speed, approach = -contact_normal_speed(c, o->velocities);
        double gravity = gravity_approach(o, c->body_a, c->body_b, c->normal_x, c->normal_y);
        double t = time_to_close(c->gap, approach, gravity, &speed);
        if (t < time && speed > sim_least_impact(o, c))
            time = t;
    }
    for (int i = 0; i < o->near.count; i++) {
        near_pair pair = o->near.pairs[i];
        const model_shape *a = &o->model.shapes[pair.a], *b = &o->model.shapes[pair.b];
        if (a->ground)
            time = time_over_ground(o, pair, time);
        else if (!a->solid.circle && !b->solid.circle)
            time = time_between_boxes(o, pair, time);
    }
    return time;
}

/* Solves the chosen contacts and updates the report; false if there is no solution. */
static bool solve_chosen(oracle *o) {
    contact_solution solution =
        contact_solve(o->solver, o->chosen.contacts, o->chosen.count, o->masses, o->velocities);
    o->report.residual_max = fmax(o->report.residual_max, solution.residual);
    o->report.hard_solves += solution.hard;
    return solution.ok;
}

/* Copies contacts that bounce to `chosen`. */
static bool choose_bouncing(oracle *o) {
    o->chosen.count = 0;
    for (int i = 0; i < o->found.count; i++) {
        contact c = o->found.contacts[i];
        double approach = -contact_normal_speed(&c, o->velocities);
        if (!is_closed(&c) || c.restitution <= 0 || approach <= sim_least_impact(o, &c))
            continue;
        c.bias = -c.restitution * approach;
        c.state = CONTACT_STICK;
        if (!sim_list_add(&o->chosen, &c))
            return false;
    }
    return true;
}

/* Copies all closed contacts to `chosen`; *needed tells whether one of them approaches. */
static bool choose_resting(oracle *o, bool *needed) {
    o->chosen.count = 0;
    *needed = false;
    for (int i = 0; i < o->found.count; i++) {
        contact c = o->found.contacts[i];
        if (!is_closed(&c))
            continue;
        c.bias = 0;
        *needed = *needed || -contact_normal_speed(&c, o->velocities) > o->slow;
        if (!sim_list_add(&o->chosen, &c))
            return false;
    }
    return true;
}

bool sim_impacts(oracle *o) {
    bool any = false, needed;
    for (int i = 0; i < MOST_BOUNCES; i++) {
        if (!choose_bouncing(o))
            return false;
        if (o->chosen.count == 0)
            break;
        any = true;
        if (!solve_chosen(o))
            return false;
    }
    if (!choose_resting(o, &needed) || (needed && !solve_chosen(o)))
        return false;
    o->report.impacts += any || needed;
    return true;
}

bool sim_part_overlaps(oracle *o, bool *moved) {
    *moved = false;
    o->chosen.count = 0;
    for (int i = 0; i < o->found.count; i++) {
        contact c = o->found.contacts[i];
        *moved = *moved || c.gap < -10 * SIM_CLOSED * c.size;
        c.bias = c.gap;
        c.friction = 0;
        c.state = c.gap < 0 ? CONTACT_STICK : CONTACT_OPEN;
        if (!sim_list_add(&o->chosen, &c))
            return false;
    }
    if (!*moved)
        return true;
    int bodies = o->model.scene->body_count;
    memset(o->scratch, 0, (size_t)bodies * sizeof *o->scratch);
    if (!contact_solve(o->solver, o->chosen.contacts, o->chosen.count, o->masses, o->scratch).ok)
        return false;
    for (int i = 0; i < bodies; i++) {
        o->places[i].x += o->scratch[i].x;
        o->places[i].y += o->scratch[i].y;
        o->places[i].turn += o->scratch[i].turn;
    }
    return true;
}
