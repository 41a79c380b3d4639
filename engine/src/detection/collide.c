/* collide.c: see collide.h. */
#include "detection/collide.h"

#include "state/body.h"
#include "solver/bounces.h"
#include "solver/friction.h"
#include "contact/contact.h"
#include "geometry/shape_instance.h"

/* A fall of so little in a step is none; a multiple of TD_MEET, as in toi_queue.c. */
#define NOTHING 0.01
/* In any unit: what single precision holds. */
#define VELOCITY_MOST 3e38

/* One of the two bodies, at the point where they meet. */
typedef struct side {
    td_body_index index;
    td_body *body;
    td_trajectory *trajectory; /* null where nothing moves it */
    double inv_mass, inv_inertia;
    double x, y;        /* the point, from the centre of mass */
    double velocity[3]; /* now */
    double motion[3];   /* per second of the rest of the step */
    bool stays;         /* keeps its motion */
} side;

static side side_of(thud_world *w, td_body_index index, const td_impact_point *at, double time) {
    td_body *body = td_body_at(w, index);
    td_trajectory f = td_trajectory_of(w, index);
    side s = {.index = index,
              .body = body,
              .x = at->x - (double)(f.place.x - at->origin.x) / w->to_fixed,
              .y = at->y - (double)(f.place.y - at->origin.y) / w->to_fixed};
    if (body->awake.at > 0) {
        const float *velocity = td_row(&w->velocity, body->awake);
        for (int k = 0; k < 3; k++) {
            double fall = k < 2 ? f.fall[k] : 0.0;
            s.velocity[k] = (double)velocity[k] - fall * (1.0 - time) / w->def.time_step;
            s.motion[k] = (f.motion[k] + fall * (time - f.since)) / w->def.time_step;
        }
        s.trajectory = td_trajectory_at(w, body->awake);
        if (body->kind == THUD_DYNAMIC) {
            s.inv_mass = (double)body->inv_mass;
            s.inv_inertia = (double)body->inv_inertia;
        }
    }
    return s;
}

/* Speed of b's point against a's along (x, y). */
static double speed_along(const side *a, const side *b, bool of_motion, double x, double y) {
    const double *va = of_motion ? a->motion : a->velocity;
    const double *vb = of_motion ? b->motion : b->velocity;
    double vx = vb[0] - vb[2] * b->y - va[0] + va[2] * a->y;
    double vy = vb[1] + vb[2] * b->x - va[1] - va[2] * a->x;
    return vx * x + vy * y;
}

/* A body that is held does not move, whatever its velocity. */
static bool gives_way(const side *s, bool of_motion) {
    return !of_motion || (s->trajectory && !s->trajectory->held && !s->stays);
}

/* Speed along (tx, ty) that a unit of impulse along (x, y) gives. */
static double softness(const side *a, const side *b, bool of_motion, double x, double y, double tx,
                       double ty) {
    double along = x * tx + y * ty;
    double turn_a = (a->x * y - a->y * x) * (a->x * ty - a->y * tx);
    double turn_b = (b->x * y - b->y * x) * (b->x * ty - b->y * tx);
    double soft_a = a->inv_mass * along + a->inv_inertia * turn_a;
    double soft_b = b->inv_mass * along + b->inv_inertia * turn_b;
    return (gives_way(a, of_motion) ? soft_a : 0.0) + (gives_way(b, of_motion) ? soft_b : 0.0);
}

static void push(side *s, bool of_motion, double x, double y) {
    double *v = of_motion ? s->motion : s->velocity;
    if (!gives_way(s, of_motion)) {
        return;
    }
    v[0] += s->inv_mass * x;
    v[1] += s->inv_mass * y;
    v[2] += s->inv_inertia * (s->x * y - s->y * x);
}

/* How gravity speeds b up against a along (x, y): lengths a step, in a step. */
static double fall_along(const side *a, const side *b, double x, double y) {
    double fx = (b->trajectory ? b->trajectory->fall[0] : 0.0) -
                (a->trajectory ? a->trajectory->fall[0] : 0.0);
    double fy = (b->trajectory ? b->trajectory->fall[1] : 0.0) -
                (a->trajectory ? a->trajectory->fall[1] : 0.0);
    return fx * x + fy * y;
}

static void look_at(thud_world *w, const td_toi_candidate *e, td_impact_point *at, double time) {
    side a = side_of(w, e->body[0], at, time), b = side_of(w, e->body[1], at, time);
    double rest = 1.0 - time;
    at->speed = -speed_along(&a, &b, true, at->nx, at->ny) * w->def.time_step;
    at->closing = (at->speed - 0.5 * fall_along(&a, &b, at->nx, at->ny) * rest) * rest;
}

bool td_impact_point_of(thud_world *w, const td_toi_candidate *e, double time,
                        td_impact_point *at) {
    td_features f;
    td_impact_point points[2];
    td_toi_candidate_features(w, e, time, &f);
    for (int k = 0; k < f.contacts.count; k++) {
        const thud_closest *c = &f.contacts.point[k];
        points[k] = (td_impact_point){
            f.origin,    c->nx, c->ny, 0.5 * (c->ax + c->bx), 0.5 * (c->ay + c->by),
            c->distance, 0.0,   0.0};
        look_at(w, e, &points[k], time);
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

/* What an impact did: impulses along the normal and along (ny, -nx), and whether the two part. */
typedef struct outcome {
    double normal, tangent;
    bool bounced;
} outcome;

/* Takes the approach out of the velocities or out of the motions, after A. Chatterjee and A. Ruina,
 * "A New Algebraic Rigid-Body Collision Law Based on Impulse Space Considerations" (1998), without
 * tangential restitution: (1 + e) times the impulse that stops the approach without friction, and
 * of the one that from there stops the sliding as much as the friction cone allows. It obeys e and
 * Coulomb's law, and where friction and normal act on each other through the turn, no impact gains
 * energy. */
static outcome bounce(side *a, side *b, bool of_motion, const surface *u) {
    double closing = -speed_along(a, b, of_motion, u->nx, u->ny);
    double tx = u->ny, ty = -u->nx;
    double soft = softness(a, b, of_motion, u->nx, u->ny, u->nx, u->ny);
    if (!(closing > 0.0 && soft > 0.0)) {
        return (outcome){0.0, 0.0, false};
    }
    bool bounced = u->restitution > 0.0 && closing > u->bounce_speed;
    double stop = closing / soft, normal = (1.0 + (bounced ? u->restitution : 0.0)) * stop;
    double mixed = softness(a, b, of_motion, u->nx, u->ny, tx, ty);
    double slide = speed_along(a, b, of_motion, tx, ty) - u->speed + mixed * stop;
    double tangent = -slide / (softness(a, b, of_motion, tx, ty, tx, ty) - mixed * mixed / soft);
    double along = -tangent * mixed / soft; /* keeps the normal speed as it is */
    double part = 1.0, ratio = td_friction_ratio(u->friction, slide);
    if (td_abs(tangent) > ratio * (normal + along)) {
        part = ratio * normal / (td_abs(tangent) - ratio * along);
    }
    normal += part * along;
    tangent *= part;
    double x = normal * u->nx + tangent * tx, y = normal * u->ny + tangent * ty;
    push(a, of_motion, -x, -y);
    push(b, of_motion, x, y);
    return (outcome){normal, tangent, bounced};
}

/* What did not part does not fall on into each other: each bears as much as the other falls less.
 * Where that bends the way of a body by more than NOTHING, `bent` says so. */
static void bear(const thud_world *w, const side *a, const side *b, const surface *u,
                 bool bent[2]) {
    double nothing = NOTHING * (double)(TD_MEET * w->unit);
    double x = u->nx, y = u->ny;
    double fall_a = a->trajectory ? a->trajectory->fall[0] * x + a->trajectory->fall[1] * y : 0.0;
    double fall_b = b->trajectory ? b->trajectory->fall[0] * x + b->trajectory->fall[1] * y : 0.0;
    double less_a = fall_a - td_max_double(fall_b, 0.0);
    double less_b = fall_b - td_min_double(fall_a, 0.0);
    if (a->trajectory && less_a > 0.0) {
        td_trajectory_bear(w, a->trajectory, less_a * x, less_a * y);
        bent[0] = less_a > nothing;
    }
    if (b->trajectory && less_b < 0.0) {
        td_trajectory_bear(w, b->trajectory, less_b * x, less_b * y);
        bent[1] = -less_b > nothing;
    }
}

static void write_back(const thud_world *w, const side *s) {
    td_trajectory *f = s->trajectory;
    if (!f || s->body->kind != THUD_DYNAMIC) {
        return;
    }
    float *velocity = td_row(&w->velocity, s->body->awake);
    for (int k = 0; k < 3; k++) {
        double fall = k < 2 ? f->fall[k] : 0.0;
        double ends = s->velocity[k] + fall * (1.0 - f->since) / w->def.time_step;
        velocity[k] = (float)td_clamp(ends, -VELOCITY_MOST, VELOCITY_MOST);
        f->motion[k] =
            s->stays ? f->motion[k] : td_motion_held(w, k, s->motion[k] * w->def.time_step);
    }
    f->changed = true;
    if (s->stays) {
        f->free = false;
        return;
    }
    f->impacts++;
}

/* From here on the body moves as its velocity says. */
static bool is_free(const side *s) {
    return !s->trajectory || s->trajectory->free || s->body->kind != THUD_DYNAMIC;
}

static void move_as_velocity(side *s) {
    for (int k = 0; k < 3; k++) {
        s->motion[k] = s->velocity[k];
    }
}

/* The speed of approach below which a pair does not bounce: see bounces.h. */
static double bounce_speed(const thud_world *w, const side *a, const side *b, const surface *u) {
    double slow = (double)(w->def.restitution_threshold * w->unit), dt = w->def.time_step;
    bool elastic = u->restitution >= 1.0;
    if (td_detection_of(w, a->index, b->index)->rank != TD_RANK_SWEPT) {
        return slow;
    }
    if (is_free(a) && is_free(b)) {
        double rest = TD_BOUNCE_REST * td_abs(fall_along(a, b, u->nx, u->ny)) / dt;
        return elastic ? td_min_double(rest, slow) : td_max_double(rest, slow);
    }
    double x = (double)w->def.gravity.x, y = (double)w->def.gravity.y;
    double rest = TD_BOUNCE_BORNE * __builtin_sqrt(x * x + y * y) * dt;
    return elastic ? td_min_double(rest, slow) : slow;
}

thud_contact td_impact_view(const thud_world *w, const td_toi_candidate *e,
                            const td_impact_point *at) {
    td_position place = {at->origin.x + td_round64(at->x * w->to_fixed),
                         at->origin.y + td_round64(at->y * w->to_fixed)};
    int a = e->shape[0], b = e->shape[1];
    td_pair_of(w, &a, &b); /* callers see them in the order of a contact */
    double sign = a == e->shape[0] ? 1.0 : -1.0;
    thud_vec2 normal = {(float)(sign * at->nx), (float)(sign * at->ny)};
    return td_contact_between(w, a, b, place, normal, at->distance);
}

/* Others lean on it, or it on them; more than one where the pair bounces, or it would gain by
 * giving way to itself. */
static bool is_in_touch(const side *s, bool pair_touches, bool bounces) {
    return s->trajectory && s->trajectory->touching > pair_touches + bounces;
}

/* A body in touch with others would hand its new motion on to them at once, and they to others: a
 * heap would collide with itself for as long as the step lasts. It keeps its motion, which the
 * solver made with all of them in sight, and what met it gives way; its new velocity is for the
 * next step to hand on. Of two such bodies the one that gave way already keeps what it has, or else
 * the slower one. */
static void choose_who_stays(side *a, side *b, bool pair_touches, const surface *u) {
    bool bounces = u->restitution > 0.0;
    bool touch_a = is_in_touch(a, pair_touches, bounces);
    bool touch_b = is_in_touch(b, pair_touches, bounces);
    bool fixed =
        !gives_way(a, true) || !gives_way(b, true) || a->inv_mass == 0.0 || b->inv_mass == 0.0;
    if (fixed || (!touch_a && !touch_b)) {
        return;
    }
    bool b_stays = touch_b;
    if (touch_a && touch_b) {
        double speed_a = td_abs(a->motion[0] * u->nx + a->motion[1] * u->ny);
        double speed_b = td_abs(b->motion[0] * u->nx + b->motion[1] * u->ny);
        bool yielded_a = a->trajectory->yielded, yielded_b = b->trajectory->yielded;
        b_stays = yielded_a == yielded_b ? speed_b < speed_a : yielded_b;
    }
    a->stays = !b_stays;
    b->stays = b_stays;
}

/* What gives way does not fall on: gravity and forces give it no speed in the rest of the step.
 * That is taken out once, of the whole rest from the first time on: a body that gives way to eight
 * others in a step would leave it at eight times that speed, upwards. */
static void give_back(const thud_world *w, side *s, double time) {
    const float *push = td_row(&w->push, s->body->awake);
    for (int k = 0; k < 2 && !s->trajectory->yielded; k++) {
        double given = w->substeps * (1.0 - time) * (double)push[k];
        s->velocity[k] -= td_gain_held(w, k, given);
    }
    s->trajectory->yielded = true;
}

void td_impact_resolve(thud_world *w, const td_toi_candidate *e, const td_impact_point *at,
                       double time, const thud_contact_settings *settings, td_impact *impact) {
    surface u = {.nx = at->nx,
                 .ny = at->ny,
                 .friction = (double)settings->friction,
                 .restitution = (double)settings->restitution,
                 .speed = (double)settings->surface_speed};
    side a = side_of(w, e->body[0], at, time), b = side_of(w, e->body[1], at, time);
    bool free = is_free(&a) && is_free(&b);
    u.bounce_speed = bounce_speed(w, &a, &b, &u);
    impact->approach = (float)-speed_along(&a, &b, false, u.nx, u.ny);
    if (u.restitution < 1.0) {
        choose_who_stays(&a, &b, impact->touching, &u);
        impact->stayed[0] = a.stays;
        impact->stayed[1] = b.stays;
    }
    outcome done = bounce(&a, &b, false, &u);
    impact->seen.normal_impulse = (float)done.normal;
    impact->seen.tangent_impulse = (float)done.tangent;
    if (a.stays || b.stays) {
        side *yields = a.stays ? &b : &a;
        give_back(w, yields, time);
        if (is_free(yields)) {
            move_as_velocity(yields);
        }
        u.restitution = 0.0;
        bounce(&a, &b, true, &u);
    } else if (free) {
        move_as_velocity(&a);
        move_as_velocity(&b);
    } else {
        bounce(&a, &b, true, &u);
    }
    write_back(w, &a);
    write_back(w, &b);
    if (!done.bounced) {
        bear(w, &a, &b, &u, impact->bent);
    }
}
