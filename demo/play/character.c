/* character.c: see character.h.
 *
 * Lengths are in length scales of the scene. As is usual in platform games, a jump still succeeds
 * shortly after the character has left the ground (coyote time), and a jump key that is pressed
 * shortly before it lands counts (jump buffering). */
#include "character.h"

#include <math.h>

/* Last: the calls of this file are recorded. */
#include <thud/thud_recorded.h>

/* Half extents of the character. */
static const double HALF_WIDTH = 0.35, HALF_HEIGHT = 0.75;
static const float RUN_SPEED = 8; /* max speed, length scales / s */
static const float RUN_GAIN = 60; /* acceleration on the ground, length scales / s^2 */
static const float AIR_GAIN = 35; /* acceleration in the air, length scales / s^2 */
static const float JUMP_HEIGHT = 3.2f;
/* Multiple of the world's gravity; with 1 jumps feel slow. Chosen. */
static const float GRAVITY_MORE = 1.6f;
/* Max speed downwards, length scales / s. */
static const float FALL_SPEED = 25;
/* Factor of the upward speed when the jump key is released while the character rises. */
static const float CUT_SHORT = 0.45f;
static const double KINDNESS = 0.1; /* coyote time and jump buffering, s */
static const double PUSH = 60;      /* max force on bodies in its way, for bodies of density 1 */
enum { ONE_WAY_CATEGORY = 2 };

/* Depth below the start at which the character counts as lost and is placed at the start again. */
static const double LOST_BELOW = 200;

static void place_at_start(character *c) {
    c->mover.shape.x = c->before.x = c->start_x;
    c->mover.shape.y = c->before.y = c->start_y;
    c->mover.on_ground = false;
    c->velocity = (thud_vec2){0, 0};
}

void character_start(character *c, session *s) {
    const scene *from = &s->scene;
    character_keys keys = c->keys;
    *c = (character){.present = from->character, .keys = keys, .facing = 1, .since_jump_key = 1};
    if (!c->present)
        return;
    double unit = from->length_scale;
    c->mover = thud_default_mover((thud_geometry){
        .kind = THUD_SHAPE_AABB, .c = 1, .hx = HALF_WIDTH * unit, .hy = HALF_HEIGHT * unit});
    c->mover.push_force = PUSH * unit * unit * unit;
    c->mover.pass = thud_mover_passes_one_way;
    c->one_way.categories = ONE_WAY_CATEGORY;
    c->gravity = GRAVITY_MORE * (float)hypot(from->gravity_x, from->gravity_y);
    c->start_x = from->spawn_x;
    c->start_y = from->spawn_y;
    place_at_start(c);
    /* A kinematic body at the character's place, with which other moving bodies collide. */
    thud_body_def body = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    body.kind = THUD_BODY_KINEMATIC;
    body.position = c->before;
    thud_vec2 zero = {0, 0}, half = {(float)c->mover.shape.hx, (float)c->mover.shape.hy};
    if (thud_body_create(s->world, &body, &c->mover.body) != THUD_OK ||
        thud_shape_create_aabb(s->world, c->mover.body, &shape, zero, half, NULL) != THUD_OK)
        c->present = false;
}

/* `from`, moved towards `to` by at most `by`. */
static float approach(float from, float to, float by) {
    return from < to ? fminf(from + by, to) : fmaxf(from - by, to);
}

/* Applies the horizontal keys and gravity to the velocity. */
static void steer(character *c, float unit, float dt) {
    float wanted = (float)(c->keys.right - c->keys.left) * RUN_SPEED * unit;
    float gain = (c->mover.on_ground ? RUN_GAIN : AIR_GAIN) * unit * dt;
    c->velocity.x = approach(c->velocity.x, wanted, gain);
    if (wanted != 0)
        c->facing = wanted < 0 ? -1 : 1;
    c->velocity.y = fmaxf(c->velocity.y - c->gravity * dt, -FALL_SPEED * unit);
}

/* Starts a jump, or cuts it short when the key is released. */
static void jump(character *c, float unit, double dt) {
    thud_vec2 ground = c->ground_velocity;
    c->since_ground = c->mover.on_ground ? 0 : c->since_ground + dt;
    c->since_jump_key = c->keys.jump && !c->jump_was_down ? 0 : c->since_jump_key + dt;
    c->jump_was_down = c->keys.jump;
    if (c->since_jump_key <= KINDNESS && c->since_ground <= KINDNESS) {
        c->velocity.y = sqrtf(2 * c->gravity * JUMP_HEIGHT * unit) + fmaxf(ground.y, 0);
        c->velocity.x += ground.x;
        c->since_jump_key = c->since_ground = 1;
        c->jump_held = true;
    } else if (c->jump_held && !c->keys.jump && c->velocity.y > 0) {
        c->velocity.y *= CUT_SHORT;
        c->jump_held = false;
    }
}

/* Reverses a lift's velocity if a static shape, sensors included, is within two steps ahead of it.
 */
static void turn_lift(thud_world *world, thud_body_id lift, thud_shape_id id, double dt) {
    thud_body_state body;
    thud_shape_state shape;
    if (thud_body_get_state(world, lift, &body) != THUD_OK ||
        thud_shape_get_state(world, id, &shape) != THUD_OK)
        return;
    thud_geometry placed = {.kind = shape.kind,
                            .c = 1,
                            .hx = (double)shape.half_extents.x,
                            .hy = (double)shape.half_extents.y};
    thud_query_filter filter = thud_default_query_filter();
    thud_ray_hit hits[16];
    int count = 0;
    filter.sensors = true;
    double ahead_x = 2 * dt * (double)body.velocity.x, ahead_y = 2 * dt * (double)body.velocity.y;
    thud_world_cast_shape_all(world,
                              &(thud_shape_cast){body.position, placed, ahead_x, ahead_y, &filter},
                              hits, 16, &count);
    for (int i = 0; i < count && i < 16; i++) {
        thud_shape_state met;
        thud_body_state other;
        bool ahead = (double)hits[i].normal.x * ahead_x + (double)hits[i].normal.y * ahead_y < 0;
        if (ahead && thud_shape_get_state(world, hits[i].shape, &met) == THUD_OK &&
            thud_body_get_state(world, met.body, &other) == THUD_OK &&
            other.kind == THUD_BODY_STATIC) {
            thud_vec2 back = {-body.velocity.x, -body.velocity.y};
            thud_body_set_velocity(world, lift, back, 0);
            return;
        }
    }
}

/* Turns lifts: kinematic bodies with one AABB. */
static void turn_lifts(session *s, double dt) {
    for (int i = 0; i < s->body_count; i++) {
        const session_body *body = &s->bodies[i];
        const session_shape *shape = &s->shapes[body->first_shape];
        if (body->kind == THUD_BODY_KINEMATIC && body->shape_count == 1 &&
            shape->kind == THUD_SHAPE_AABB)
            turn_lift(s->world, body->id, shape->id, dt);
    }
}

void character_step(character *c, session *s) {
    if (!c->present)
        return;
    thud_mover_report report;
    double dt = s->time_step;
    float unit = (float)s->scene.length_scale;
    turn_lifts(s, dt);
    c->before = (thud_pos){c->mover.shape.x, c->mover.shape.y};
    c->one_way.drop = c->keys.down;
    c->mover.context = &c->one_way;
    steer(c, unit, (float)dt);
    jump(c, unit, dt);
    if (thud_mover_move(s->world, &c->mover, c->velocity, dt, &report) != THUD_OK)
        return; /* log_message has stored the message */
    c->velocity = report.velocity;
    c->ground_velocity = report.ground_velocity;
    if (c->mover.shape.y < c->start_y - LOST_BELOW * (double)unit)
        place_at_start(c);
}

bool character_moves(const character *c) {
    return c->before.x != c->mover.shape.x || c->before.y != c->mover.shape.y;
}

thud_pos character_place(const character *c, double alpha) {
    return (thud_pos){c->before.x + alpha * (c->mover.shape.x - c->before.x),
                      c->before.y + alpha * (c->mover.shape.y - c->before.y)};
}
