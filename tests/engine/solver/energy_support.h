/* energy_support.h: worlds with elastic or rough bodies, a closed room for them, and the sum of
 * their energy, for tests of energy under `swept`. */
#ifndef ENERGY_SUPPORT_H
#define ENERGY_SUPPORT_H

#include "engine_support.h"

/* Kinds of bodies (circle, AABB, OBB); bodies at most; steps of a minute. */
enum { CIRCLE, UPRIGHT, TURNED, KINDS, MOST_BODIES = 100, MINUTE = 3600 };

/* A world and its bodies. */
typedef struct bodies {
    thud_world *world;
    thud_body_id id[MOST_BODIES];
    int count;
    double gravity; /* along y, in m/s^2 */
} bodies;

static inline bodies make_bodies(double gravity, int substeps) {
    thud_world_def def = weightless();
    def.gravity.y = (float)gravity;
    def.substeps = substeps;
    def.detection = &thud_detection_swept;
    return (bodies){.world = make_world(def), .gravity = gravity};
}

static inline thud_shape_def surface(float restitution, float friction) {
    thud_shape_def def = thud_default_shape_def();
    def.restitution = restitution;
    def.friction = friction;
    return def;
}

/* Adds a body of a kind. hx: the radius of a circle, or the half extent of a square. */
static inline thud_body_id add(bodies *b, int kind, double x, double y, float hx,
                               const thud_shape_def *def) {
    thud_body_id id = add_body(b->world, THUD_BODY_DYNAMIC, x, y, 0);
    add_shape(b->world, id, hx, kind == CIRCLE ? 0 : hx, kind == UPRIGHT, def);
    return b->id[b->count++] = id;
}

/* Kinetic and potential energy of the bodies; potential energy is 0 at y = 0. */
static inline double energy_of(const bodies *b) {
    double energy = 0;
    for (int i = 0; i < b->count; i++) {
        thud_body_state s = state_of(b->world, b->id[i]);
        double x = (double)s.velocity.x, y = (double)s.velocity.y, w = (double)s.angular_velocity;
        energy += 0.5 * ((double)s.mass * (x * x + y * y) + (double)s.inertia * w * w) -
                  (double)s.mass * b->gravity * s.center.y;
    }
    return energy;
}

/* Walls around a square room, whose half width is `half`. */
static inline void add_room(bodies *b, double half, const thud_shape_def *def) {
    thud_body_id walls = add_body(b->world, THUD_BODY_STATIC, 0, 0, 0);
    for (int side = 0; side < 4; side++) {
        float out = (side < 2 ? 1 : -1) * (float)(half + 1), length = (float)half + 2;
        OK(thud_shape_create_aabb(b->world, walls, def,
                                  (thud_vec2){side % 2 ? out : 0, side % 2 ? 0 : out},
                                  (thud_vec2){side % 2 ? 1 : length, side % 2 ? length : 1}, NULL));
    }
}

#endif
