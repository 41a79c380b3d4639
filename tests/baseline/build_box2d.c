/* build_box2d.c: reads a scene, writes a Box2D world. The same doubles are rounded to the same
 * floats as in build_thud.c. What needs translation:
 *
 * - An AABB is a box whose body is locked against turning.
 * - Terrain is a chain: one-sided, solid to the left of its direction of travel, so its points go
 *   from right to left. A chain's first and last edge do not collide, so that each end gets a
 *   ghost point that continues the last edge.
 * - Friction mixes as sqrt(a * b) and restitution as the larger in both engines. */
#include "build_box2d.h"

#include <math.h>
#include <stdlib.h>

/* Half the width of what stands in for an endless line, in metres. */
#define FLAT_HALF_WIDTH 4096.0

static void be_silent(const char *message) {
    (void)message;
}

static b2Vec2 vec2(double x, double y) {
    return (b2Vec2){(float)x, (float)y};
}

/* Box2D's own b2MakeRot is an approximation, good to four digits. */
static b2Rot rotation(double angle) {
    return (b2Rot){(float)cos(angle), (float)sin(angle)};
}

static b2BodyType body_type(scene_body_kind kind) {
    return kind == SCENE_STATIC      ? b2_staticBody
           : kind == SCENE_KINEMATIC ? b2_kinematicBody
                                     : b2_dynamicBody;
}

static b2Filter filter_of(const scene_shape *shape) {
    return (b2Filter){shape->category, shape->mask, shape->group};
}

/* The terrain's vertices from left to right. */
static int vertex_count(const scene_shape *shape) {
    return shape->kind == SCENE_TERRAIN_FLAT ? 2 : shape->point_count;
}

static scene_point vertex(const scene *s, const scene_shape *shape, int index) {
    if (shape->kind != SCENE_TERRAIN_FLAT)
        return s->points[shape->first_point + index];
    double x = index == 0 ? -FLAT_HALF_WIDTH : FLAT_HALF_WIDTH;
    return (scene_point){x, shape->slope * x};
}

static bool add_terrain(b2BodyId body, const scene *s, const scene_shape *shape, bool events) {
    int count = vertex_count(shape);
    b2Vec2 *points = malloc((size_t)(count + 2) * sizeof *points);
    if (!points)
        return false;
    for (int i = 0; i < count; i++) {
        scene_point p = vertex(s, shape, count - 1 - i);
        points[i + 1] = vec2(p.x, p.y);
    }
    points[0] = b2Sub(b2MulSV(2, points[1]), points[2]);
    points[count + 1] = b2Sub(b2MulSV(2, points[count]), points[count - 1]);
    b2SurfaceMaterial material = b2DefaultSurfaceMaterial();
    material.friction = (float)shape->material.friction;
    material.restitution = (float)shape->material.restitution;
    b2ChainDef def = b2DefaultChainDef();
    def.points = points;
    def.count = count + 2;
    def.materials = &material;
    def.materialCount = 1;
    def.filter = filter_of(shape);
    def.enableSensorEvents = events;
    b2ChainId chain = b2CreateChain(body, &def);
    free(points);
    return B2_IS_NON_NULL(chain);
}

static bool add_shape(b2BodyId body, const scene *s, const scene_shape *shape, bool events) {
    b2ShapeDef def = b2DefaultShapeDef();
    def.density = (float)shape->material.density;
    def.material.friction = (float)shape->material.friction;
    def.material.restitution = (float)shape->material.restitution;
    def.filter = filter_of(shape);
    def.isSensor = shape->sensor;
    def.enableContactEvents = events;
    def.enableHitEvents = events;
    def.enableSensorEvents = events;
    b2Vec2 offset = vec2(shape->x, shape->y);
    switch (shape->kind) {
    case SCENE_CIRCLE: {
        b2Circle circle = {offset, (float)shape->hx};
        return B2_IS_NON_NULL(b2CreateCircleShape(body, &def, &circle));
    }
    case SCENE_AABB:
    case SCENE_OBB: {
        b2Rot turn = rotation(shape->kind == SCENE_OBB ? shape->angle : 0);
        b2Polygon box = b2MakeOffsetBox((float)shape->hx, (float)shape->hy, offset, turn);
        return B2_IS_NON_NULL(b2CreatePolygonShape(body, &def, &box));
    }
    case SCENE_TERRAIN_FLAT:
    case SCENE_TERRAIN_UNIFORM:
    case SCENE_TERRAIN_IRREGULAR:
        return add_terrain(body, s, shape, events);
    }
    return false;
}

static bool add_body(b2WorldId world, const scene *s, const scene_body *body, bool events,
                     b2BodyId *out) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = body_type(body->kind);
    def.position = vec2(body->x, body->y);
    def.rotation = rotation(body->angle);
    def.angularVelocity = (float)body->angular_velocity;
    def.gravityScale = (float)body->gravity_scale;
    def.linearDamping = (float)body->linear_damping;
    def.angularDamping = (float)body->angular_damping;
    def.motionLocks.angularZ = body->fixed_rotation;
    def.enableSleep = body->may_sleep;
    *out = b2CreateBody(world, &def);
    bool ok = B2_IS_NON_NULL(*out);
    for (int i = 0; ok && i < body->shape_count; i++)
        ok = add_shape(*out, s, &s->shapes[body->first_shape + i], events);
    /* Only now is the centre of mass known, whose velocity a scene gives. */
    if (ok)
        b2Body_SetLinearVelocity(*out, vec2(body->vx, body->vy));
    return ok;
}

bool scene_build_box2d(const scene *s, box2d_settings settings, b2WorldId *out, b2BodyId *bodies) {
    *out = b2_nullWorldId;
    if (s->failed)
        return false;
    b2SetLogFcn(be_silent);
    b2SetLengthUnitsPerMeter((float)s->length_scale);
    b2WorldDef def = b2DefaultWorldDef();
    def.gravity = vec2(s->gravity_x, s->gravity_y);
    def.enableSleep = settings.sleeping;
    def.workerCount = 1;
    b2WorldId world = b2CreateWorld(&def);
    bool ok = !B2_IS_NULL(world);
    for (int i = 0; ok && i < s->body_count; i++)
        ok = add_body(world, s, &s->bodies[i], settings.events, &bodies[i]);
    if (!ok) {
        if (!B2_IS_NULL(world))
            b2DestroyWorld(world);
        return false;
    }
    *out = world;
    return true;
}
