/* misuse_box2d.c: makes each invalid call in Box2D, in a release build without assertions. None of
 * these functions returns a result. */
#include "misuse_box2d.h"

static void add_circle(b2BodyId body, float radius, float density, float friction) {
    b2ShapeDef def = b2DefaultShapeDef();
    b2Circle circle = {{0, 0}, radius};
    def.density = density;
    def.material.friction = friction;
    b2CreateCircleShape(body, &def, &circle);
}

static b2BodyId create_at(b2WorldId world, float x) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = b2_dynamicBody;
    def.position = (b2Vec2){x, x};
    return b2CreateBody(world, &def);
}

/* Sets the velocity of a destroyed body. */
static void push_gone(b2WorldId world) {
    b2BodyId gone = create_at(world, 0);
    b2DestroyBody(gone);
    b2Body_SetLinearVelocity(gone, (b2Vec2){1, 0});
}

void misuse_box2d(b2WorldId world, b2BodyId body, misuse call, double x) {
    const float f = (float)x;
    const b2Vec2 here = {0, 0}, there = {f, f};
    switch (call) {
    case MISUSE_POSITION:
        b2Body_SetTransform(body, there, b2Rot_identity);
        break;
    case MISUSE_ANGLE:
        b2Body_SetTransform(body, here, b2MakeRot(f));
        break;
    case MISUSE_VELOCITY:
        b2Body_SetLinearVelocity(body, there);
        break;
    case MISUSE_SPIN:
        b2Body_SetAngularVelocity(body, f);
        break;
    case MISUSE_FORCE:
        b2Body_ApplyForceToCenter(body, there, true);
        break;
    case MISUSE_TORQUE:
        b2Body_ApplyTorque(body, f, true);
        break;
    case MISUSE_IMPULSE:
        b2Body_ApplyLinearImpulse(body, there, here, true);
        break;
    case MISUSE_IMPULSE_POINT:
        b2Body_ApplyLinearImpulse(body, (b2Vec2){0.01f, 0}, there, true);
        break;
    case MISUSE_NEW_BODY:
        create_at(world, f);
        break;
    case MISUSE_RADIUS:
        add_circle(body, f, 1, 0.6f);
        break;
    case MISUSE_DENSITY:
        add_circle(body, 0.1f, f, 0.6f);
        break;
    case MISUSE_FRICTION:
        add_circle(body, 0.1f, 1, f);
        break;
    case MISUSE_GRAVITY:
        b2World_SetGravity(world, there);
        break;
    case MISUSE_TIME_STEP:
        b2World_Step(world, f, 4);
        break;
    case MISUSE_RAY:
        b2World_CastRayClosest(world, there, (b2Vec2){1, 0}, b2DefaultQueryFilter());
        break;
    case MISUSE_GONE:
        push_gone(world);
        break;
    case MISUSE_NOBODY:
        b2Body_SetLinearVelocity(b2_nullBodyId, (b2Vec2){1, 0});
        break;
    }
}
