/* grab.c: see grab.h.
 *
 * The wanted velocity of the point is its way to the target times RATE. The impulse P at offset r
 * from the centre of mass changes the point's velocity by K P with the 2x2 matrix
 * K = 1/m + (1/I) [ry ry, -rx ry; -rx ry, rx rx] (the constraint's inverse effective mass, as in
 * Catto: Soft Constraints, 2011). Solving for P takes the point to the wanted velocity at once,
 * whatever the body's mass. */
#include "grab.h"

#include <math.h>

static const float RATE = 12;         /* 1/s: the gap closes by a factor e in 1/12 s */
static const float FASTEST = 60;      /* length scales per second */
static const float SPIN_KEPT = 0.95f; /* of the turning, per step: a held body calms down */

bool grab_start(grab *g, session *s, thud_pos at, double margin) {
    thud_body_id id;
    thud_body_state body;
    if (!session_pick(s, at, margin, THUD_DYNAMIC, &id) ||
        thud_body_get(s->world, id, &body) != THUD_OK)
        return false;
    float dx = (float)(at.x - body.position.x), dy = (float)(at.y - body.position.y);
    thud_vec2 local = {body.cosine * dx + body.sine * dy, body.cosine * dy - body.sine * dx};
    *g = (grab){.held = true, .body = id, .local = local, .target = at};
    return true;
}

void grab_move(grab *g, thud_pos to) {
    g->target = to;
}

void grab_end(grab *g) {
    g->held = false;
}

static thud_pos anchor_of(const grab *g, const thud_body_state *body) {
    return (thud_pos){body->position.x + body->cosine * g->local.x - body->sine * g->local.y,
                      body->position.y + body->sine * g->local.x + body->cosine * g->local.y};
}

bool grab_anchor(const grab *g, const session *s, thud_pos *out) {
    thud_body_state body;
    if (!g->held || thud_body_get(s->world, g->body, &body) != THUD_OK)
        return false;
    *out = anchor_of(g, &body);
    return true;
}

static thud_vec2 wanted_velocity(const grab *g, thud_pos anchor, float fastest) {
    thud_vec2 v = {RATE * (float)(g->target.x - anchor.x), RATE * (float)(g->target.y - anchor.y)};
    float speed = hypotf(v.x, v.y);
    if (speed > fastest) {
        v.x *= fastest / speed;
        v.y *= fastest / speed;
    }
    return v;
}

void grab_pull(grab *g, session *s) {
    thud_body_state body;
    if (!g->held)
        return;
    if (thud_body_get(s->world, g->body, &body) != THUD_OK || body.mass <= 0) {
        g->held = false;
        return;
    }
    /* Frames are not steps: one impulse for every step that has been made, or it would add up. */
    uint64_t step = thud_world_stats(s->world).steps + 1;
    if (s->paused || step == g->pulled_step)
        return;
    g->pulled_step = step;
    thud_pos anchor = anchor_of(g, &body);
    thud_vec2 wanted = wanted_velocity(g, anchor, FASTEST * (float)s->scene.length_scale);
    float spin = SPIN_KEPT * body.angular_velocity;
    thud_body_set_velocity(s->world, g->body, body.velocity, spin);
    float rx = (float)(anchor.x - body.center.x), ry = (float)(anchor.y - body.center.y);
    float ex = wanted.x - (body.velocity.x - spin * ry);
    float ey = wanted.y - (body.velocity.y + spin * rx);
    float inverse_mass = 1 / body.mass, inverse_inertia = body.inertia > 0 ? 1 / body.inertia : 0;
    float k11 = inverse_mass + inverse_inertia * ry * ry;
    float k22 = inverse_mass + inverse_inertia * rx * rx;
    float k12 = -inverse_inertia * rx * ry;
    float determinant = k11 * k22 - k12 * k12;
    thud_vec2 impulse = {(k22 * ex - k12 * ey) / determinant, (k11 * ey - k12 * ex) / determinant};
    thud_body_apply_impulse(s->world, g->body, impulse, anchor);
}
