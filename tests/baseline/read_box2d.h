/* read_box2d.h: Box2D's bodies as every comparison reads them. */
#ifndef THUD_BASELINE_READ_BOX2D_H
#define THUD_BASELINE_READ_BOX2D_H

#include "contender.h"

#include <box2d/box2d.h>
#include <stdio.h>

/* False, after a line on stderr, on a processor that the library was not built for. */
static inline bool box2d_can_run(void) {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2")) {
        fprintf(stderr, "box2d: this processor has no AVX2, which the library was built for\n");
        return false;
    }
#endif
    return true;
}

static inline void read_box2d(const b2BodyId *ids, int count, contender_body *bodies) {
    for (int i = 0; i < count; i++) {
        b2BodyId id = ids[i];
        b2WorldTransform pose = b2Body_GetTransform(id);
        b2Vec2 velocity = b2Body_GetLinearVelocity(id);
        bodies[i] = (contender_body){
            .x = pose.p.x,
            .y = pose.p.y,
            .cosine = pose.q.c,
            .sine = pose.q.s,
            .vx = velocity.x,
            .vy = velocity.y,
            .angular_velocity = b2Body_GetAngularVelocity(id),
            .mass = b2Body_GetMass(id),
            .inertia = b2Body_GetRotationalInertia(id),
            .awake = b2Body_IsAwake(id),
        };
    }
}

#endif
