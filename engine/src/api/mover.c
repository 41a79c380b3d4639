/* mover.c: a character's move, from beginning to end: ride, make room, walk or fly, push. */
#include "api/mover.h"

#include "state/body.h"
#include "state/handles.h"
#include "geometry/shape_instance.h"
#include "api/query.h"
#include "base/trig.h"

thud_mover thud_default_mover(thud_shape_instance shape) {
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

/* Where the point of the ground that it stood on has gone since the last move. */
static td_way ridden(const td_move *m, const thud_body_state *ground) {
    const thud_mover *mover = &m->mover;
    double c = (double)mover->ground_cosine, s = (double)mover->ground_sine;
    double dx = mover->ground_point.x - mover->ground_place.x;
    double dy = mover->ground_point.y - mover->ground_place.y;
    td_way gone = {ground->position.x - mover->ground_place.x,
                   ground->position.y - mover->ground_place.y};
    if (ground->cosine != mover->ground_cosine || ground->sine != mover->ground_sine) {
        double to_c = (double)ground->cosine, to_s = (double)ground->sine;
        double turn_c = to_c * c + to_s * s, turn_s = to_s * c - to_c * s;
        double size = __builtin_sqrt(turn_c * turn_c + turn_s * turn_s);
        turn_c /= size;
        turn_s /= size;
        gone.x += turn_c * dx - turn_s * dy - dx;
        gone.y += turn_s * dx + turn_c * dy - dy;
    }
    return gone;
}

/* False once it is gone from under its feet. */
static bool find_ground(const td_move *m, thud_body_state *ground) {
    return thud_shape_is_valid(m->world, m->mover.ground_shape) &&
           thud_body_get(m->world, m->mover.ground_body, ground) == THUD_OK;
}

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
    if (td_mover_go(m, ridden(m, &ground), &hit, &left)) {
        td_mover_note(m, &hit);
    }
}

/* Notes where the ground stands, for the next ride, and how fast its point moves. */
static void note_ground(td_move *m) {
    thud_mover *mover = &m->mover;
    thud_body_state ground;
    if (!mover->on_ground || !thud_body_is_valid(m->world, mover->ground_body)) {
        mover->on_ground = false;
        return;
    }
    thud_body_get(m->world, mover->ground_body, &ground);
    mover->ground_place = ground.position;
    mover->ground_cosine = ground.cosine;
    mover->ground_sine = ground.sine;
    double dx = mover->ground_point.x - ground.center.x;
    double dy = mover->ground_point.y - ground.center.y;
    double spin = (double)ground.angular_velocity;
    m->report.ground_velocity = (thud_vec2){(float)((double)ground.velocity.x - spin * dy),
                                            (float)((double)ground.velocity.y + spin * dx)};
}

/* ---- what is in the way ---- */

/* At most the impulse that takes a body up to the mover's speed at the point that it pushes. */
static void push(td_move *m, const thud_mover_hit *hit) {
    thud_body_state body;
    td_way n = td_mover_normal(hit);
    if (!thud_body_is_valid(m->world, hit->body) ||
        thud_body_get(m->world, hit->body, &body) != THUD_OK || body.kind != THUD_DYNAMIC ||
        td_dot(n, td_up(m)) >= m->walkable) {
        return;
    }
    double rx = hit->point.x - body.center.x, ry = hit->point.y - body.center.y;
    double spin = (double)body.angular_velocity, arm = rx * n.y - ry * n.x;
    td_way apart = {(double)body.velocity.x - spin * ry - (double)m->velocity.x,
                    (double)body.velocity.y + spin * rx - (double)m->velocity.y};
    double closing = td_dot(apart, n);
    double inertia = (double)body.inertia;
    double give = 1.0 / (double)body.mass + (inertia > 0.0 ? arm * arm / inertia : 0.0);
    double impulse = closing / give, most = m->mover.push_force * m->dt;
    impulse = impulse < most ? impulse : most;
    if (impulse > 0.0) {
        thud_vec2 value = {(float)(-n.x * impulse), (float)(-n.y * impulse)};
        m->result = thud_body_apply_impulse(m->world, hit->body, value, hit->point);
    }
}

static void push_all(td_move *m) {
    for (int i = 0; i < m->report.hit_count && m->result == THUD_OK; i++) {
        bool again = false;
        for (int k = 0; k < i; k++) {
            again = again || m->report.hits[k].body.index1 == m->report.hits[i].body.index1;
        }
        if (!again) {
            push(m, &m->report.hits[i]);
        }
    }
}

/* However short a time is, velocities stay numbers. */
static float lead_speed(const td_move *m, double way) {
    double speed = way / m->dt, most = 1e30;
    return (float)(speed > most ? most : speed < -most ? -most : speed);
}

/* The body is where the mover is at the end of the next step. */
static thud_result lead_body(const td_move *m) {
    thud_body_state body;
    thud_result result = thud_body_get(m->world, m->mover.body, &body);
    thud_vec2 velocity = {lead_speed(m, m->mover.shape.x - body.position.x),
                          lead_speed(m, m->mover.shape.y - body.position.y)};
    return result != THUD_OK ? result
                             : thud_body_set_velocity(m->world, m->mover.body, velocity, 0.0f);
}

/* ---- the move ---- */

/* Whether it stays in the world however it goes. What it asks on its way is refused otherwise, when
 * the edits that wait are in effect already. */
static bool stays_in_world(const td_move *m) {
    const thud_mover *mover = &m->mover;
    thud_body_state ground;
    double reach = td_size((td_way){(double)m->velocity.x, (double)m->velocity.y}) * m->dt +
                   mover->step_height + mover->snap_distance + 2.0 * mover->skin;
    if (mover->on_ground && find_ground(m, &ground)) {
        reach += td_size(ridden(m, &ground));
    }
    return td_place_valid(m->world, td_abs(mover->shape.x) + reach, td_abs(mover->shape.y) + reach);
}

static thud_result check_mover(const thud_world *w, const thud_mover *mover) {
    const thud_shape_instance *s = &mover->shape;
    td_way way = {(double)mover->up.x, (double)mover->up.y};
    double up = td_dot(way, way);
    double least = td_kind_half_thickness(s->kind, s->hx, s->hy);
    if (td_query_check(w, (thud_pos){0.0, 0.0}, s) != THUD_OK) {
        return td_refuse(w, THUD_ERROR_INVALID, "mover: the shape or its place is invalid");
    }
    if (!(up == 0.0 || td_abs(up - 1.0) < THUD_UNIT_ERROR)) {
        return td_refuse(w, THUD_ERROR_INVALID, "mover: up is neither of length 1 nor zero");
    }
    td_reason why;
    if (!td_above_0(&why, "mover: skin", mover->skin, least) ||
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
    result = thud_body_get(w, mover->body, &body);
    return result != THUD_OK || body.kind == THUD_KINEMATIC
               ? result
               : td_refuse(w, THUD_ERROR_INVALID, "mover: its body is not kinematic");
}

static void move(td_move *m) {
    td_way up = td_up(m);
    td_way way = td_scaled((td_way){(double)m->velocity.x, (double)m->velocity.y}, m->dt);
    double rising = td_dot(way, up);
    ride(m);
    td_mover_separate(m);
    bool walking = m->mover.on_ground && rising <= 0.0;
    m->mover.on_ground = walking;
    double rate = 1.0 / m->dt; /* beyond all numbers for the shortest of times */
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
    note_ground(m);
}

thud_result thud_mover_move(thud_world *w, thud_mover *mover, thud_vec2 velocity, double dt,
                            thud_mover_report *report) {
    TD_IN_OWN_MODE;
    if (!w || !mover) {
        return td_refuse(w, THUD_ERROR_NULL, "mover: world or mover is null");
    }
    td_way asked = {(double)velocity.x, (double)velocity.y};
    thud_result result = td_check_above_0(w, "mover: dt", dt, THUD_TIME_STEP_MAX);
    if (result == THUD_OK) {
        result = td_check(w, "mover: length of velocity, times dt,", td_size(asked) * dt, 0.0,
                          THUD_MOVER_WAY_MAX);
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
    /* From its beginning to its end it meets the same world, whatever `pass` asks for. */
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
        m.result = lead_body(&m);
    }
    if (m.result != THUD_OK) {
        return m.result;
    }
    *mover = m.mover;
    if (report) {
        *report = m.report;
    }
    return THUD_OK;
}
