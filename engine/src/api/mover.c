/* mover.c: thud_mover_move: the order of a move, and what it does to the world. The parts are
 * explained in mover.h. A move
 *
 *     1. rides: repeats the motion of the ground point that the mover stands on,
 *     2. resolves overlap with static and kinematic shapes,
 *     3. walks along the ground, or flies,
 *     4. pushes the dynamic bodies that it hit,
 *     5. sets the velocity of the mover's own kinematic body, if it has one.
 *
 * 1 to 3 change a copy of the mover only; the world is locked meanwhile, so that the callback
 * `pass` cannot change it between two casts. */
#include "api/mover.h"

#include "state/body.h"
#include "state/handles.h"
#include "geometry/shape_instance.h"
#include "api/query.h"
#include "base/trig.h"

thud_mover thud_default_mover(thud_geometry shape) {
    double half = td_kind_half_y(shape.kind, shape.hx, shape.hy);
    return (thud_mover){.shape = shape,
                        .up = {0.0f, 1.0f},
                        .skin = 0.02 * (half < shape.hx ? half : shape.hx),
                        .max_slope = 0.9,
                        .step_height = 0.6 * half,
                        .snap_distance = 0.6 * half,
                        .filter = thud_default_query_filter()};
}

/* ---- the ground's own motion ---- */

/* The displacement since the last move of the ground point that the mover stands on: the
 * translation of the ground's origin, and the rotation of the point about it. */
static td_way ground_motion(const td_move *m, const thud_body_state *ground) {
    const thud_mover *mover = &m->mover;
    double c = (double)mover->ground_cosine, s = (double)mover->ground_sine;
    double dx = mover->ground_point.x - mover->ground_place.x;
    double dy = mover->ground_point.y - mover->ground_place.y;
    td_way motion = {ground->position.x - mover->ground_place.x,
                     ground->position.y - mover->ground_place.y};
    if (ground->cosine != mover->ground_cosine || ground->sine != mover->ground_sine) {
        double to_c = (double)ground->cosine, to_s = (double)ground->sine;
        double turn_c = to_c * c + to_s * s, turn_s = to_s * c - to_c * s;
        double size = __builtin_sqrt(turn_c * turn_c + turn_s * turn_s);
        turn_c /= size;
        turn_s /= size;
        motion.x += turn_c * dx - turn_s * dy - dx;
        motion.y += turn_s * dx + turn_c * dy - dy;
    }
    return motion;
}

/* The state of the body that the mover stands on. False if its shape or body has been destroyed. */
static bool find_ground(const td_move *m, thud_body_state *ground) {
    return thud_shape_is_valid(m->world, m->mover.ground_shape) &&
           thud_body_get_state(m->world, m->mover.ground_body, ground) == THUD_OK;
}

/* Moves the mover with the ground that it stands on. */
static void ride(td_move *m) {
    thud_body_state ground;
    if (!m->mover.on_ground) {
        return;
    }
    if (!find_ground(m, &ground)) {
        m->mover.on_ground = false;
        return;
    }
    thud_mover_hit hit;
    td_way left;
    if (td_mover_go(m, ground_motion(m, &ground), &hit, &left)) {
        td_mover_note(m, &hit);
    }
}

/* Stores the pose of the ground, for the next ride, and reports the velocity of the ground at the
 * point that the mover stands on: v + w x r. */
static void store_ground(td_move *m) {
    thud_mover *mover = &m->mover;
    thud_body_state ground;
    if (!mover->on_ground || !thud_body_is_valid(m->world, mover->ground_body)) {
        mover->on_ground = false;
        return;
    }
    thud_body_get_state(m->world, mover->ground_body, &ground);
    mover->ground_place = ground.position;
    mover->ground_cosine = ground.cosine;
    mover->ground_sine = ground.sine;
    double dx = mover->ground_point.x - ground.center.x;
    double dy = mover->ground_point.y - ground.center.y;
    double spin = (double)ground.angular_velocity;
    m->report.ground_velocity = (thud_vec2){(float)((double)ground.velocity.x - spin * dy),
                                            (float)((double)ground.velocity.y + spin * dx)};
}

/* ---- bodies that the mover pushes ---- */

/* Pushes a dynamic body that the mover hit, unless the mover can stand on it. With n the hit's
 * normal (out of the body), r the arm from its centre of mass to the point, v its velocity at the
 * point relative to the mover's:
 *
 *     impulse = min(v . n / (1 / m + (r x n)^2 / I), push_force * dt), along -n
 *
 * The first is the impulse after which the point moves at the mover's speed along n. */
static void push(td_move *m, const thud_mover_hit *hit) {
    thud_body_state body;
    td_way n = td_mover_normal(hit);
    if (!thud_body_is_valid(m->world, hit->body) ||
        thud_body_get_state(m->world, hit->body, &body) != THUD_OK ||
        body.kind != THUD_BODY_DYNAMIC || td_dot(n, td_up(m)) >= m->walkable) {
        return;
    }
    double rx = hit->point.x - body.center.x, ry = hit->point.y - body.center.y;
    double spin = (double)body.angular_velocity, arm = rx * n.y - ry * n.x;
    td_way relative = {(double)body.velocity.x - spin * ry - (double)m->velocity.x,
                       (double)body.velocity.y + spin * rx - (double)m->velocity.y};
    double closing_speed = td_dot(relative, n);
    double inertia = (double)body.inertia;
    double inverse_mass = 1.0 / (double)body.mass + (inertia > 0.0 ? arm * arm / inertia : 0.0);
    double impulse = closing_speed / inverse_mass, max = m->mover.push_force * m->dt;
    impulse = impulse < max ? impulse : max;
    if (impulse > 0.0) {
        thud_vec2 value = {(float)(-n.x * impulse), (float)(-n.y * impulse)};
        m->result = thud_body_apply_impulse(m->world, hit->body, value, hit->point);
    }
}

/* Pushes each body of the report's hits once, at its first hit. */
static void push_all(td_move *m) {
    for (int i = 0; i < m->report.hit_count && m->result == THUD_OK; i++) {
        bool pushed = false;
        for (int k = 0; k < i; k++) {
            pushed = pushed || m->report.hits[k].body.index1 == m->report.hits[i].body.index1;
        }
        if (!pushed) {
            push(m, &m->report.hits[i]);
        }
    }
}

/* One component of the velocity by which the body covers `distance` in dt, length/s, held to +-1e30
 * so that it is finite in single precision however short dt is. */
static float body_speed(const td_move *m, double distance) {
    double speed = distance / m->dt, max = 1e30;
    return (float)(speed > max ? max : speed < -max ? -max : speed);
}

/* Sets the velocity by which the mover's kinematic body reaches the mover's place at the end of the
 * next step. */
static thud_result set_body_velocity(const td_move *m) {
    thud_body_state body;
    thud_result result = thud_body_get_state(m->world, m->mover.body, &body);
    thud_vec2 velocity = {body_speed(m, m->mover.shape.x - body.position.x),
                          body_speed(m, m->mover.shape.y - body.position.y)};
    return result != THUD_OK ? result
                             : thud_body_set_velocity(m->world, m->mover.body, velocity, 0.0f);
}

/* ---- the move ---- */

/* Whether every place that the move can reach is within the world. It is checked before the move,
 * because a query that is refused halfway would leave it half done. */
static bool stays_in_world(const td_move *m) {
    const thud_mover *mover = &m->mover;
    thud_body_state ground;
    double reach = td_size((td_way){(double)m->velocity.x, (double)m->velocity.y}) * m->dt +
                   mover->step_height + mover->snap_distance + 2.0 * mover->skin;
    if (mover->on_ground && find_ground(m, &ground)) {
        reach += td_size(ground_motion(m, &ground));
    }
    return td_place_valid(m->world, td_abs(mover->shape.x) + reach, td_abs(mover->shape.y) + reach);
}

/* Refuses a mover with a field out of its range, and a body that is not kinematic. */
static thud_result check_mover(const thud_world *w, const thud_mover *mover) {
    const thud_geometry *s = &mover->shape;
    td_way way = {(double)mover->up.x, (double)mover->up.y};
    double up = td_dot(way, way);
    double max_skin = td_kind_half_thickness(s->kind, s->hx, s->hy);
    if (td_query_check(w, (thud_pos){0.0, 0.0}, s) != THUD_OK) {
        return td_refuse(w, THUD_ERROR_INVALID, "mover: the shape or its place is invalid");
    }
    if (!(up == 0.0 || td_abs(up - 1.0) < THUD_UNIT_ERROR)) {
        return td_refuse(w, THUD_ERROR_INVALID, "mover: up is neither of length 1 nor zero");
    }
    td_reason why;
    if (!td_above_0(&why, "mover: skin", mover->skin, max_skin) ||
        !td_in(&why, "mover: max_slope", mover->max_slope, 0.0, THUD_MOVER_SLOPE_MAX) ||
        !td_in(&why, "mover: step_height", mover->step_height, 0.0, THUD_MOVER_STEP_MAX) ||
        !td_in(&why, "mover: snap_distance", mover->snap_distance, 0.0, THUD_MOVER_STEP_MAX) ||
        !td_in(&why, "mover: push_force", mover->push_force, 0.0, THUD_MOVER_FORCE_MAX)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    thud_body_state body;
    thud_result result = td_query_check_filter(w, &mover->filter);
    if (result != THUD_OK || mover->body.index1 == 0) {
        return result;
    }
    result = thud_body_get_state(w, mover->body, &body);
    return result != THUD_OK || body.kind == THUD_BODY_KINEMATIC
               ? result
               : td_refuse(w, THUD_ERROR_INVALID, "mover: its body is not kinematic");
}

/* Steps 1 to 3 of a move, and the report of them. */
static void move(td_move *m) {
    td_way up = td_up(m);
    td_way way = td_scaled((td_way){(double)m->velocity.x, (double)m->velocity.y}, m->dt);
    double rising = td_dot(way, up);
    ride(m);
    td_mover_separate(m);
    bool walking = m->mover.on_ground && rising <= 0.0;
    m->mover.on_ground = walking;
    double rate = 1.0 / m->dt; /* infinite for the smallest dt */
    m->left = td_finite(rate) ? td_scaled(way, rate)
                              : (td_way){(double)m->velocity.x, (double)m->velocity.y};
    if (walking) {
        td_mover_walk(m, td_plus(way, up, -rising));
        m->mover.on_ground = td_mover_settle(m);
        way = td_scaled(up, rising);
    }
    if (!m->mover.on_ground) {
        td_mover_fly(m, way);
    }
    td_way left = m->left;
    if (m->mover.on_ground) {
        left = m->stopped ? (td_way){0.0, 0.0} : td_plus(left, up, -td_dot(left, up));
    }
    m->report.velocity = (thud_vec2){(float)left.x, (float)left.y};
    td_mover_sense(m, (td_way){0.0, 0.0});
    store_ground(m);
}

thud_result thud_mover_move(thud_world *w, thud_mover *mover, thud_vec2 velocity, double dt,
                            thud_mover_report *out_report) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !mover) {
        return td_refuse(w, THUD_ERROR_NULL, "mover: world or mover is null");
    }
    td_way asked = {(double)velocity.x, (double)velocity.y};
    thud_result result = td_check_above_0(w, "mover: dt", dt, THUD_TIME_STEP_MAX);
    if (result == THUD_OK) {
        result = td_check(w, "mover: length of velocity, times dt,", td_size(asked) * dt, 0.0,
                          THUD_MOVER_DISTANCE_MAX);
    }
    result = result == THUD_OK ? check_mover(w, mover) : result;
    if (result != THUD_OK) {
        return result;
    }
    double sine;
    td_move m = {.world = w, .mover = *mover, .velocity = velocity, .dt = dt};
    td_sincos(mover->max_slope, &sine, &m.walkable);
    if (!stays_in_world(&m)) {
        return td_refuse(w, THUD_ERROR_INVALID, "mover: it may get out of the world");
    }
    m.solid = mover->filter;
    m.solid.sensors = false;
    /* All casts of the move see the edits made so far. None sees an edit that the callback `pass`
     * makes. */
    if (!td_query_prepare(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "mover: out of memory");
    }
    bool was_locked = w->locked;
    w->locked = true;
    move(&m);
    w->locked = was_locked;
    if (m.result != THUD_OK) {
        return m.result;
    }
    push_all(&m);
    if (m.result == THUD_OK && mover->body.index1 != 0) {
        m.result = set_body_velocity(&m);
    }
    if (m.result != THUD_OK) {
        return m.result;
    }
    *mover = m.mover;
    if (out_report) {
        *out_report = m.report;
    }
    return THUD_OK;
}
