/* joint_support.h: helpers with which tests create worlds with joints, and read joints. */
#ifndef JOINT_SUPPORT_H
#define JOINT_SUPPORT_H

#include "island_support.h"

#include <thud/thud_joint.h>

#define PI 3.14159265358979323846

/* A world of a quality without floor and without sleeping. */
static inline thud_world *world_at(const thud_quality *quality) {
    thud_world_def def = def_of(quality);
    def.sleeping = false;
    return make_world(def);
}

/* The def of a joint with anchors at_a and at_b in the bodies' own coordinates. */
static inline thud_joint_def between(thud_joint_kind kind, thud_body_id a, thud_body_id b,
                                     thud_vec2 at_a, thud_vec2 at_b) {
    thud_joint_def def = thud_default_joint_def(kind);
    def.body_a = a;
    def.body_b = b;
    def.frame_a.position = at_a;
    def.frame_b.position = at_b;
    return def;
}

static inline thud_joint_id make(thud_world *world, thud_joint_def def) {
    thud_joint_id id;
    OK(thud_joint_create(world, &def, &id));
    return id;
}

static inline thud_joint_state joint_of(const thud_world *world, thud_joint_id id) {
    thud_joint_state state;
    OK(thud_joint_get_state(world, id, &state));
    return state;
}

#endif
