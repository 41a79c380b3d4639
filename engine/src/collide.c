/* collide.c: see collide.h. */
#include "collide.h"

#include "body.h"
#include "contact.h"
#include "placed.h"

/* One of the two bodies, at the point where they meet. */
typedef struct side {
    td_body *body;
    td_flight *flight; /* null where nothing moves it */
    double inv_mass, inv_inertia;
    double x, y;         /* the point, from the centre of mass */
    double velocity[3];  /* now */
    double motion[3];    /* per second of the rest of the step */
} side;

static side side_of(thud_world *w, int index, const td_impact_point *at)
{
    td_body *body = td_body_at(w, index);
    td_flight f = td_flight_of(w, index);
    side s = {.body = body,
              .x = at->x - (double)(f.place.x - at->origin.x) / w->to_fixed,
              .y = at->y - (double)(f.place.y - at->origin.y) / w->to_fixed};
    if (body->awake > 0) {
        const float *velocity = td_row(&w->velocity, body->awake);
        for (int k = 0; k < 3; k++) {
            s.velocity[k] = (double)velocity[k];
            s.motion[k] = f.motion[k] / w->def.time_step;
        }
        s.flight = td_flight_at(w, body->awake);
        if (body->kind == THUD_DYNAMIC) {
            s.inv_mass = (double)body->inv_mass;
            s.inv_inertia = (double)body->inv_inertia;
        }
    }
    return s;
}

/* Speed of b's point against a's along (x, y). */
static double speed_along(const side *a, const side *b, bool of_motion, double x, double y)
{
    const double *va = of_motion ? a->motion : a->velocity;
    const double *vb = of_motion ? b->motion : b->velocity;
    double vx = vb[0] - vb[2] * b->y - va[0] + va[2] * a->y;
    double vy = vb[1] + vb[2] * b->x - va[1] - va[2] * a->x;
    return vx * x + vy * y;
}

/* What is held does not move, whatever its velocity. */
static bool gives_way(const side *s, bool of_motion)
{
    return !of_motion || (s->flight && !s->flight->held);
}

/* Speed along (x, y) that a unit of impulse along it gives. */
static double softness(const side *a, const side *b, bool of_motion, double x, double y)
{
    double ca = a->x * y - a->y * x, cb = b->x * y - b->y * x;
    double soft_a = a->inv_mass + a->inv_inertia * ca * ca;
    double soft_b = b->inv_mass + b->inv_inertia * cb * cb;
    return (gives_way(a, of_motion) ? soft_a : 0.0) + (gives_way(b, of_motion) ? soft_b : 0.0);
}

static void push(side *s, bool of_motion, double x, double y)
{
    double *v = of_motion ? s->motion : s->velocity;
    if (!gives_way(s, of_motion)) {
        return;
    }
    v[0] += s->inv_mass * x;
    v[1] += s->inv_mass * y;
    v[2] += s->inv_inertia * (s->x * y - s->y * x);
}

static double closing_at(thud_world *w, const td_encounter *e, const td_impact_point *at,
                         double time)
{
    side a = side_of(w, e->body[0], at), b = side_of(w, e->body[1], at);
    return -speed_along(&a, &b, true, at->nx, at->ny) * w->def.time_step * (1.0 - time);
}

bool td_impact_point_of(thud_world *w, const td_encounter *e, double time, td_impact_point *at)
{
    td_features f;
    td_impact_point points[2];
    td_encounter_features(w, e, time, &f);
    for (int k = 0; k < f.contacts.count; k++) {
        const thud_closest *c = &f.contacts.point[k];
        points[k] = (td_impact_point){f.origin, c->nx, c->ny, 0.5 * (c->ax + c->bx),
                                      0.5 * (c->ay + c->by), c->distance, 0.0};
        points[k].closing = closing_at(w, e, &points[k], time);
    }
    if (f.contacts.count == 0) {
        return false;
    }
    bool second = f.contacts.count == 2 && points[1].closing > points[0].closing;
    *at = points[second];
    if (f.contacts.count == 2 && points[!second].closing > 0.5 * at->closing) {
        at->x = 0.5 * (points[0].x + points[1].x);
        at->y = 0.5 * (points[0].y + points[1].y);
    }
    return true;
}

typedef struct surface {
    double nx, ny, friction, restitution, speed, bounce_speed;
} surface;

/* Takes the approach out of the velocities or out of the motions; returns normal impulse and, in
 * *tangent, that along (ny, -nx). */
static double bounce(side *a, side *b, bool of_motion, const surface *u, double *tangent)
{
    double closing = speed_along(a, b, of_motion, u->nx, u->ny);
    double soft = softness(a, b, of_motion, u->nx, u->ny);
    *tangent = 0.0;
    if (!(closing < 0.0 && soft > 0.0)) {
        return 0.0;
    }
    double leaving = -closing > u->bounce_speed ? u->restitution : 0.0;
    double normal = -(1.0 + leaving) * closing / soft, most = u->friction * normal;
    double tx = u->ny, ty = -u->nx;
    double slide = speed_along(a, b, of_motion, tx, ty) - u->speed;
    *tangent = td_clamp(-slide / softness(a, b, of_motion, tx, ty), -most, most);
    double x = normal * u->nx + *tangent * tx, y = normal * u->ny + *tangent * ty;
    push(a, of_motion, -x, -y);
    push(b, of_motion, x, y);
    return normal;
}

static void write_back(const thud_world *w, const side *s)
{
    if (!s->flight || s->body->kind != THUD_DYNAMIC) {
        return;
    }
    float *velocity = td_row(&w->velocity, s->body->awake);
    for (int k = 0; k < 3; k++) {
        velocity[k] = (float)s->velocity[k];
        s->flight->motion[k] = s->motion[k] * w->def.time_step;
    }
    s->flight->changed = true;
    s->flight->impacts++;
}

thud_contact td_impact_view(const thud_world *w, const td_encounter *e, const td_impact_point *at)
{
    td_place place = {at->origin.x + td_round64(at->x * w->to_fixed),
                      at->origin.y + td_round64(at->y * w->to_fixed)};
    int a = e->shape[0], b = e->shape[1];
    td_pair_of(w, &a, &b); /* callers see them in the order of a contact */
    double sign = a == e->shape[0] ? 1.0 : -1.0;
    thud_vec2 normal = {(float)(sign * at->nx), (float)(sign * at->ny)};
    return td_contact_between(w, a, b, place, normal, at->distance);
}

void td_impact_resolve(thud_world *w, const td_encounter *e, const td_impact_point *at,
                       const thud_contact_settings *settings, td_impact *impact)
{
    surface u = {.nx = at->nx,
                 .ny = at->ny,
                 .friction = (double)settings->friction,
                 .restitution = (double)settings->restitution,
                 .speed = (double)settings->surface_speed,
                 .bounce_speed = (double)(w->def.restitution_threshold * w->unit)};
    side a = side_of(w, e->body[0], at), b = side_of(w, e->body[1], at);
    double tangent, unused;
    impact->approach = (float)-speed_along(&a, &b, false, u.nx, u.ny);
    impact->seen.normal_impulse = (float)bounce(&a, &b, false, &u, &tangent);
    impact->seen.tangent_impulse = (float)tangent;
    bounce(&a, &b, true, &u, &unused);
    write_back(w, &a);
    write_back(w, &b);
}
