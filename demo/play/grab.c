/* grab.c: see grab.h.
 *
 * The joint's max force is a multiple of the body's weight, so that a light body cannot drag a
 * heavy one that it is joined to, and is not pressed through a wall. */
#include "grab.h"

#include <math.h>

/* Last: the calls of this file are recorded. */
#include <thud/thud_recorded.h>

static const float FREQUENCY = 5, DAMPING = 1; /* Hz and damping ratio: critical */
static const float WEIGHTS = 40;               /* max force, in weights of the body */
/* Min gravity from which that weight is computed, length scales / s^2; for scenes with less or
 * none. */
static const float GRAVITY_LEAST = 10;
static const float CALM = 20; /* rad/s^2: max angular deceleration of a held body */

/* Creates the pin and the joint. False if the world refuses. */
static bool add_joint(grab *g, session *s, const thud_body_state *body) {
    thud_body_def pin = thud_default_body_def();
    thud_joint_def def = thud_default_joint_def(THUD_JOINT_TARGET);
    pin.position = g->from;
    if (thud_body_create(s->world, &pin, &g->pin) != THUD_OK)
        return false;
    float gravity = (float)fmax(hypot(s->scene.gravity_x, s->scene.gravity_y),
                                GRAVITY_LEAST * s->scene.length_scale);
    for (int i = THUD_DIRECTION_ALONG; i <= THUD_DIRECTION_ACROSS; i++) {
        def.drive[i].frequency = FREQUENCY;
        def.drive[i].damping = DAMPING;
        def.drive[i].spring_force = WEIGHTS * gravity * body->mass;
    }
    def.drive[THUD_DIRECTION_TURN].motor_force = CALM * body->inertia;
    def.body_a = g->pin;
    def.body_b = g->body;
    def.frame_b.position = g->local;
    def.collide_connected = true;
    if (thud_joint_create(s->world, &def, &g->joint) == THUD_OK)
        return true;
    thud_body_destroy(s->world, g->pin);
    return false;
}

bool grab_start(grab *g, session *s, thud_pos at, double margin) {
    thud_body_id id;
    thud_body_state body;
    grab_end(g, s);
    if (!session_pick(s, at, margin, THUD_BODY_DYNAMIC, &id) ||
        thud_body_get_state(s->world, id, &body) != THUD_OK)
        return false;
    float dx = (float)(at.x - body.position.x), dy = (float)(at.y - body.position.y);
    thud_vec2 local = {body.cosine * dx + body.sine * dy, body.cosine * dy - body.sine * dx};
    *g = (grab){.body = id, .local = local, .from = at, .target = at};
    g->held = add_joint(g, s, &body);
    return g->held;
}

void grab_move(grab *g, session *s, thud_pos to) {
    if (!g->held)
        return;
    /* The joint of a body that was destroyed is there until the next step. */
    if (!thud_body_is_valid(s->world, g->body) || !thud_joint_is_valid(s->world, g->joint)) {
        grab_end(g, s);
        return;
    }
    if (to.x == g->target.x && to.y == g->target.y)
        return; /* so that a held body at rest may fall asleep */
    thud_joint_frame frame = {{(float)(to.x - g->from.x), (float)(to.y - g->from.y)}, 0};
    if (thud_joint_set_frame(s->world, g->joint, 0, frame) == THUD_OK)
        g->target = to;
}

void grab_end(grab *g, session *s) {
    if (g->held)
        thud_body_destroy(s->world, g->pin); /* destroys the joint as well */
    g->held = false;
}

bool grab_anchor(const grab *g, const session *s, thud_pos *out) {
    thud_body_state body;
    if (!g->held || !thud_body_is_valid(s->world, g->body) ||
        thud_body_get_state(s->world, g->body, &body) != THUD_OK)
        return false;
    const thud_vec2 *p = &g->local;
    *out = (thud_pos){body.position.x + body.cosine * p->x - body.sine * p->y,
                      body.position.y + body.sine * p->x + body.cosine * p->y};
    return true;
}
