/* collide.c: see collide.h. Each body has two sets of velocities at the impact: its velocity, which
 * the step passes on to the next one, and its motion, by which its trajectory continues to the end
 * of the step. They differ unless the body is in free flight: the solver moves bodies apart that
 * overlap, and its relax pass (solver/solve.c) takes the speed of that correction out of the
 * velocity again. The collision law is applied to the velocities. In free flight the motions are
 * then set to them; else the same law is applied to the motions, without restitution if a body
 * keeps its motion. */
#include "detection/collide.h"

#include "state/body.h"
#include "solver/bounces.h"
#include "solver/friction.h"
#include "contact/contact.h"
#include "geometry/shape_instance.h"

/* In multiples of TD_IMPACT_DISTANCE: a change of `acceleration` (twice the displacement that
 * gravity and forces cause in a step) that is smaller than this does not change times of impact
 * noticeably. Chosen equal to CLOSING_MIN of toi_queue.c, the closing motion below which touching
 * shapes do not collide. */
#define ACCELERATION_MIN 0.01
/* Bound of velocities, length/s or rad/s: below FLT_MAX, 3.4e38, so that the conversion from double
 * to float is finite. */
#define VELOCITY_MAX 3e38
/* Least tangential inverse effective mass Ktt - Knt^2/Knn, as a share of Ktt. The difference
 * cancels where a body's inertia is far below its mass times the square of its lever: down to 1e-12
 * four digits of it are left, at 1e-16 none, so that friction would be any number, or infinite.
 * With the greater value friction stops a part of the sliding only. */
#define TANGENT_MIN 1e-12

/* One of the two bodies. */
typedef struct side {
    td_body_index index;
    td_body *body;
    td_trajectory *trajectory;    /* null: the body is not awake */
    double inv_mass, inv_inertia; /* 0 unless the body is awake and dynamic */
    double x, y;                  /* the impact point, from the centre of mass */
    double velocity[3];           /* at the time of the impact: x, y (length/s), turn (rad/s) */
    double motion[3];             /* velocity of the trajectory at that time: x, y (length/s), turn
                                     (rad/s) */
    bool keeps_motion;            /* its motion does not change; see choose_kept_motion */
} side;

/* Collects a body's state at `time`. w->velocity has the velocity at the end of the step, so that
 * the part that `acceleration` adds from `time` until then is subtracted. The motion is that at
 * `since`, to which `acceleration` adds a part until `time`. */
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
            double acceleration = k < 2 ? f.acceleration[k] : 0.0;
            s.velocity[k] = (double)velocity[k] - acceleration * (1.0 - time) / w->def.time_step;
            s.motion[k] = (f.motion[k] + acceleration * (time - f.since)) / w->def.time_step;
        }
        s.trajectory = td_trajectory_at(w, body->awake);
        if (body->kind == THUD_BODY_DYNAMIC) {
            s.inv_mass = (double)body->inv_mass;
            s.inv_inertia = (double)body->inv_inertia;
        }
    }
    return s;
}

/* Velocity of b at the point relative to a, along (x, y): of the motions or of the velocities. */
static double speed_along(const side *a, const side *b, bool use_motion, double x, double y) {
    const double *va = use_motion ? a->motion : a->velocity;
    const double *vb = use_motion ? b->motion : b->velocity;
    double vx = vb[0] - vb[2] * b->y - va[0] + va[2] * a->y;
    double vy = vb[1] + vb[2] * b->x - va[1] - va[2] * a->x;
    return vx * x + vy * y;
}

/* Whether an impulse changes the body's velocity, or with `use_motion` its motion. Velocities
 * always change; motions do not if the body is held, keeps its motion (choose_kept_motion), or is
 * not awake. */
static bool is_movable(const side *s, bool use_motion) {
    return !use_motion || (s->trajectory && !s->trajectory->held && !s->keeps_motion);
}

/* Relative velocity along (tx, ty) per unit of impulse along (x, y): the element of the inverse
 * effective mass matrix, 1/kg. */
static double inverse_mass_along(const side *a, const side *b, bool use_motion, double x, double y,
                                 double tx, double ty) {
    double along = x * tx + y * ty;
    double turn_a = (a->x * y - a->y * x) * (a->x * ty - a->y * tx);
    double turn_b = (b->x * y - b->y * x) * (b->x * ty - b->y * tx);
    double soft_a = a->inv_mass * along + a->inv_inertia * turn_a;
    double soft_b = b->inv_mass * along + b->inv_inertia * turn_b;
    return (is_movable(a, use_motion) ? soft_a : 0.0) + (is_movable(b, use_motion) ? soft_b : 0.0);
}

/* Applies an impulse (x, y) at the point to a body's motion or velocity. */
static void apply_impulse(side *s, bool use_motion, double x, double y) {
    double *v = use_motion ? s->motion : s->velocity;
    if (!is_movable(s, use_motion)) {
        return;
    }
    v[0] += s->inv_mass * x;
    v[1] += s->inv_mass * y;
    v[2] += s->inv_inertia * (s->x * y - s->y * x);
}

/* The relative `acceleration` of b against a along (x, y): change of the relative motion in a step,
 * lengths. */
static double relative_acceleration_along(const side *a, const side *b, double x, double y) {
    double fx = (b->trajectory ? b->trajectory->acceleration[0] : 0.0) -
                (a->trajectory ? a->trajectory->acceleration[0] : 0.0);
    double fy = (b->trajectory ? b->trajectory->acceleration[1] : 0.0) -
                (a->trajectory ? a->trajectory->acceleration[1] : 0.0);
    return fx * x + fy * y;
}

/* Sets at->speed, and at->closing_distance = (speed - acceleration r / 2) r, where r = 1 - time is
 * the rest of the step, and `acceleration` is the relative acceleration along the normal. */
static void measure_closing(thud_world *w, const td_toi_candidate *e, td_impact_point *at,
                            double time) {
    side a = side_of(w, e->body[0], at, time), b = side_of(w, e->body[1], at, time);
    double remaining = 1.0 - time;
    at->speed = -speed_along(&a, &b, true, at->nx, at->ny) * w->def.time_step;
    at->closing_distance =
        (at->speed - 0.5 * relative_acceleration_along(&a, &b, at->nx, at->ny) * remaining) *
        remaining;
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
        measure_closing(w, e, &points[k], time);
    }
    if (f.contacts.count == 0) {
        return false;
    }
    bool second = f.contacts.count == 2 && points[1].closing_distance > points[0].closing_distance;
    *at = points[second];
    if (f.contacts.count == 2 && points[!second].closing_distance > 0.5 * at->closing_distance) {
        at->x = 0.5 * (points[0].x + points[1].x);
        at->y = 0.5 * (points[0].y + points[1].y);
    }
    return true;
}

/* The normal and the material of both surfaces at the impact point. */
typedef struct surface {
    double nx, ny;      /* normal, from a to b */
    double friction;    /* coefficient */
    double restitution; /* coefficient */
    double speed; /* of b against a along (ny, -nx), to which friction drives it: a conveyor belt;
                     length/s */
    double bounce_speed; /* no restitution at a closing speed up to this, length/s */
} surface;

/* The impulses of an impact along the normal and along (ny, -nx), and whether restitution was
 * applied. */
typedef struct outcome {
    double normal, tangent;
    bool bounced;
} outcome;

/* Applies the collision law to the velocities or to the motions of both bodies, after A. Chatterjee
 * and A. Ruina, "A New Algebraic Rigid-Body Collision Law Based on Impulse Space Considerations"
 * (1998), without tangential restitution. With normal n, tangent t, closing speed c, restitution e
 * and the inverse effective masses K:
 *   P1 = c / Knn                               along n: stops the approach without friction
 *   T = -(slide + Knt P1) / (Ktt - Knt^2/Knn)  along t: then stops the sliding, while
 *   A = -T Knt / Knn                           along n: keeps the normal speed
 * In the code: Knn inverse_mass, Knt mixed, Ktt across, P1 stop, T tangent, A along.
 * The impulse is (1 + e) P1 along n, and the share of (A, T) that keeps |tangent| <= friction x
 * normal. No impact gains energy, even if normal and friction impulses are coupled by the rotation
 * of the bodies (Knt != 0). */
static outcome apply_collision(side *a, side *b, bool use_motion, const surface *u) {
    double closing = -speed_along(a, b, use_motion, u->nx, u->ny);
    double tx = u->ny, ty = -u->nx;
    double inverse_mass = inverse_mass_along(a, b, use_motion, u->nx, u->ny, u->nx, u->ny);
    if (!(closing > 0.0 && inverse_mass > 0.0)) {
        return (outcome){0.0, 0.0, false};
    }
    bool bounced = u->restitution > 0.0 && closing > u->bounce_speed;
    double stop = closing / inverse_mass, normal = (1.0 + (bounced ? u->restitution : 0.0)) * stop;
    double mixed = inverse_mass_along(a, b, use_motion, u->nx, u->ny, tx, ty);
    double slide = speed_along(a, b, use_motion, tx, ty) - u->speed + mixed * stop;
    double across = inverse_mass_along(a, b, use_motion, tx, ty, tx, ty);
    double tangent =
        -slide / td_max_double(across - mixed * mixed / inverse_mass, TANGENT_MIN * across);
    double along = -tangent * mixed / inverse_mass; /* A */
    double part = 1.0, ratio = td_friction_ratio(u->friction, slide);
    if (td_abs(tangent) > ratio * (normal + along)) {
        part = ratio * normal / (td_abs(tangent) - ratio * along);
    }
    normal += part * along;
    tangent *= part;
    double x = normal * u->nx + tangent * tx, y = normal * u->ny + tangent * ty;
    apply_impulse(a, use_motion, -x, -y);
    apply_impulse(b, use_motion, x, y);
    return (outcome){normal, tangent, bounced};
}

/* Keeps gravity from closing a pair that did not bounce in the rest of the step. Let Fa and Fb be
 * the `acceleration` of both bodies along the normal from a to b: Fa is reduced to at most max(Fb,
 * 0), and Fb raised to at least min(Fa, 0). Sets acceleration_reduced[i] if the acceleration of
 * body i changed by more than ACCELERATION_MIN. */
static void stop_mutual_acceleration(const thud_world *w, const side *a, const side *b,
                                     const surface *u, bool acceleration_reduced[2]) {
    double acceleration_min = ACCELERATION_MIN * (double)(TD_IMPACT_DISTANCE * w->length_scale);
    double x = u->nx, y = u->ny;
    double acceleration_a =
        a->trajectory ? a->trajectory->acceleration[0] * x + a->trajectory->acceleration[1] * y
                      : 0.0;
    double acceleration_b =
        b->trajectory ? b->trajectory->acceleration[0] * x + b->trajectory->acceleration[1] * y
                      : 0.0;
    double reduction_a = acceleration_a - td_max_double(acceleration_b, 0.0);
    double reduction_b = acceleration_b - td_min_double(acceleration_a, 0.0);
    if (a->trajectory && reduction_a > 0.0) {
        td_trajectory_reduce_acceleration(w, a->trajectory, reduction_a * x, reduction_a * y);
        acceleration_reduced[0] = reduction_a > acceleration_min;
    }
    if (b->trajectory && reduction_b < 0.0) {
        td_trajectory_reduce_acceleration(w, b->trajectory, reduction_b * x, reduction_b * y);
        acceleration_reduced[1] = -reduction_b > acceleration_min;
    }
}

/* Writes velocity and motion of a side to its body. The velocity is that at the end of the step,
 * including what `acceleration` adds until then; the motion is per step. For a body that keeps its
 * motion, the impact is not counted. */
static void write_back(const thud_world *w, const side *s) {
    td_trajectory *f = s->trajectory;
    if (!f || s->body->kind != THUD_BODY_DYNAMIC) {
        return;
    }
    float *velocity = td_row(&w->velocity, s->body->awake);
    for (int k = 0; k < 3; k++) {
        double acceleration = k < 2 ? f->acceleration[k] : 0.0;
        double ends = s->velocity[k] + acceleration * (1.0 - f->since) / w->def.time_step;
        velocity[k] = (float)td_clamp(ends, -VELOCITY_MAX, VELOCITY_MAX);
        f->motion[k] =
            s->keeps_motion ? f->motion[k] : td_motion_held(w, k, s->motion[k] * w->def.time_step);
    }
    f->changed = true;
    if (s->keeps_motion) {
        f->free = false;
        return;
    }
    f->impacts++;
}

/* Whether the body's motion follows its velocity from here on: it is in free flight, or no impulse
 * changes it. */
static bool moves_by_velocity(const side *s) {
    return !s->trajectory || s->trajectory->free || s->body->kind != THUD_BODY_DYNAMIC;
}

/* Sets the motion to the velocity. */
static void set_motion_from_velocity(side *s) {
    for (int k = 0; k < 3; k++) {
        s->motion[k] = s->velocity[k];
    }
}

/* The closing speed, length/s, up to which the pair does not bounce: the restitution threshold of
 * the world, and for swept pairs, whose bounces would follow each other in ever shorter times, also
 * a multiple of the speed that gravity gives in a step (solver/bounces.h). Of these two, elastic
 * pairs take the lesser, and pairs in free flight that are not elastic the greater; other pairs
 * take the threshold. */
static double bounce_speed(const thud_world *w, const side *a, const side *b, const surface *u) {
    double threshold = (double)(w->def.restitution_threshold * w->length_scale),
           dt = w->def.time_step;
    bool elastic = u->restitution >= 1.0;
    if (td_detection_of(w, a->index, b->index)->rank != TD_RANK_SWEPT) {
        return threshold;
    }
    if (moves_by_velocity(a) && moves_by_velocity(b)) {
        double resting =
            TD_BOUNCE_REST * td_abs(relative_acceleration_along(a, b, u->nx, u->ny)) / dt;
        return elastic ? td_min_double(resting, threshold) : td_max_double(resting, threshold);
    }
    double x = (double)w->def.gravity.x, y = (double)w->def.gravity.y;
    double resting = TD_BOUNCE_BORNE * __builtin_sqrt(x * x + y * y) * dt;
    return elastic ? td_min_double(resting, threshold) : threshold;
}

thud_contact td_impact_view(const thud_world *w, const td_toi_candidate *e,
                            const td_impact_point *at) {
    td_position place = {at->origin.x + td_round64(at->x * w->to_fixed),
                         at->origin.y + td_round64(at->y * w->to_fixed)};
    int a = e->shape[0], b = e->shape[1];
    td_pair_of(w, &a, &b); /* callers see the shapes in the order of a contact */
    double sign = a == e->shape[0] ? 1.0 : -1.0;
    thud_vec2 normal = {(float)(sign * at->nx), (float)(sign * at->ny)};
    return td_contact_between(w, a, b, place, normal, at->distance);
}

/* Whether the body touches other bodies than the one of this pair. If the pair may bounce, one
 * contact more is needed: with a single other contact, a body that keeps its motion would gain
 * energy. */
static bool touches_others(const side *s, bool pair_touches, bool bounces) {
    return s->trajectory && s->trajectory->contact_count > pair_touches + bounces;
}

/* Chooses a body of the pair that keeps its motion in this step, if one touches others. With a new
 * motion it would meet those at once, and they their neighbours, so that a heap would have impacts
 * within itself for the rest of the step. Its motion comes from the solver, which solved all its
 * contacts together, and is kept; only its velocity changes, and the solver of the next step passes
 * that on. The other body takes the whole change of motion. If both touch others, the body that has
 * taken such a change before (`deflected`) keeps its motion, or else the one that is slower along
 * the normal. */
static void choose_kept_motion(side *a, side *b, bool pair_touches, const surface *u) {
    bool bounces = u->restitution > 0.0;
    bool touch_a = touches_others(a, pair_touches, bounces);
    bool touch_b = touches_others(b, pair_touches, bounces);
    bool immovable =
        !is_movable(a, true) || !is_movable(b, true) || a->inv_mass == 0.0 || b->inv_mass == 0.0;
    if (immovable || (!touch_a && !touch_b)) {
        return;
    }
    bool keep_b = touch_b;
    if (touch_a && touch_b) {
        double speed_a = td_abs(a->motion[0] * u->nx + a->motion[1] * u->ny);
        double speed_b = td_abs(b->motion[0] * u->nx + b->motion[1] * u->ny);
        bool deflected_a = a->trajectory->deflected, deflected_b = b->trajectory->deflected;
        keep_b = deflected_a == deflected_b ? speed_b < speed_a : deflected_b;
    }
    a->keeps_motion = !keep_b;
    b->keeps_motion = keep_b;
}

/* For the body that takes the change of motion for both: removes from its velocity the part that
 * gravity and forces give in the rest of the step, since the other body carries it there. This is
 * done only once a step: a body that meets eight others would otherwise end the step with eight
 * times that speed, upwards. */
static void remove_remaining_gain(const thud_world *w, side *s, double time) {
    const float *substep_gain = td_row(&w->substep_gain, s->body->awake);
    for (int k = 0; k < 2 && !s->trajectory->deflected; k++) {
        double gain = w->substeps * (1.0 - time) * (double)substep_gain[k];
        s->velocity[k] -= td_gain_clamped(w, k, gain);
    }
    s->trajectory->deflected = true;
}

void td_impact_resolve(thud_world *w, const td_toi_candidate *e, const td_impact_point *at,
                       double time, const thud_contact_settings *settings, td_impact *impact) {
    surface u = {.nx = at->nx,
                 .ny = at->ny,
                 .friction = (double)settings->friction,
                 .restitution = (double)settings->restitution,
                 .speed = (double)settings->surface_speed};
    side a = side_of(w, e->body[0], at, time), b = side_of(w, e->body[1], at, time);
    bool free = moves_by_velocity(&a) && moves_by_velocity(&b);
    u.bounce_speed = bounce_speed(w, &a, &b, &u);
    impact->closing_speed = (float)-speed_along(&a, &b, false, u.nx, u.ny);
    if (u.restitution < 1.0) {
        choose_kept_motion(&a, &b, impact->touching, &u);
        impact->kept_motion[0] = a.keeps_motion;
        impact->kept_motion[1] = b.keeps_motion;
    }
    outcome result = apply_collision(&a, &b, false, &u);
    impact->seen.normal_impulse = (float)result.normal;
    impact->seen.tangent_impulse = (float)result.tangent;
    if (a.keeps_motion || b.keeps_motion) {
        side *other = a.keeps_motion ? &b : &a;
        remove_remaining_gain(w, other, time);
        if (moves_by_velocity(other)) {
            set_motion_from_velocity(other);
        }
        u.restitution = 0.0;
        apply_collision(&a, &b, true, &u);
    } else if (free) {
        set_motion_from_velocity(&a);
        set_motion_from_velocity(&b);
    } else {
        apply_collision(&a, &b, true, &u);
    }
    write_back(w, &a);
    write_back(w, &b);
    if (!result.bounced) {
        stop_mutual_acceleration(w, &a, &b, &u, impact->acceleration_reduced);
    }
}
