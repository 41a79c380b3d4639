/* engine_box2d.c: Box2D v3.2, by the interface of engine.h. Doubles are rounded to the same floats
 * as in build_thud.c. Differences between both engines:
 *
 * - An AABB is a box whose body has a locked rotation.
 * - Terrain is a chain: one-sided, solid to the left of its direction, so its points go from right
 *   to left. The first and last edges of a chain do not collide, so that each end gets a ghost
 *   point that continues the last edge.
 * - Friction is combined as sqrt(a * b) and restitution as the maximum in both engines. */
#include "box2d_joints.h"
#include "engine.h"
#include "misuse_box2d.h"

#include <box2d/box2d.h>
#include <math.h>
#include <stdlib.h>

/* m: half the length of the segment that represents an endless line. */
#define FLAT_HALF_WIDTH 4096.0

/* m/s: above all speeds of the scenes. */
#define NO_LIMIT_OF_SPEED 1e9f

typedef struct own_world {
    b2WorldId id;
    float time_step;
    int substeps, body_count;
    b2BodyId bodies[];
} own_world;

static void be_silent(const char *message) {
    (void)message;
}

static b2Vec2 vec2(double x, double y) {
    return (b2Vec2){(float)x, (float)y};
}

/* Box2D's b2MakeRot is an approximation with four correct digits. */
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

/* Number of vertices of a terrain; vertex() gives them from left to right. */
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

static bool add_body(own_world *own, const scene *s, int index, const engine_settings *settings) {
    const scene_body *body = &s->bodies[index];
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
    def.isBullet = settings->bullets && body->detection == SCENE_SWEPT;
    b2BodyId id = own->bodies[index] = b2CreateBody(own->id, &def);
    bool ok = B2_IS_NON_NULL(id);
    for (int i = 0; ok && i < body->shape_count; i++)
        ok = add_shape(id, s, &s->shapes[body->first_shape + i], settings->events);
    /* The scene's velocity is that of the centre of mass, which is known only after the shapes are
     * added. */
    if (ok)
        b2Body_SetLinearVelocity(id, vec2(body->vx, body->vy));
    return ok;
}

static void destroy(void *state) {
    own_world *own = state;
    if (own && B2_IS_NON_NULL(own->id))
        b2DestroyWorld(own->id);
    free(own);
}

/* The length scale is a global variable of Box2D: worlds with different scales cannot exist at the
 * same time. */
static void *create(const scene *s, const engine_settings *settings) {
    own_world *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    if (!own)
        return NULL;
    b2SetLogFcn(be_silent);
    b2SetLengthUnitsPerMeter((float)s->length_scale);
    b2WorldDef def = b2DefaultWorldDef();
    def.gravity = vec2(s->gravity_x, s->gravity_y);
    def.enableSleep = settings->sleeping;
    def.workerCount = 1;
    if (settings->contact_hertz > 0)
        def.contactHertz = (float)settings->contact_hertz;
    if (settings->bullets)
        def.maximumLinearSpeed = NO_LIMIT_OF_SPEED;
    own->id = b2CreateWorld(&def);
    own->time_step = (float)settings->time_step;
    own->substeps = settings->substeps;
    own->body_count = s->body_count;
    bool ok = B2_IS_NON_NULL(own->id);
    for (int i = 0; ok && i < s->body_count; i++)
        ok = add_body(own, s, i, settings);
    if (ok && box2d_add_joints(own->id, s, own->bodies, settings))
        return own;
    destroy(own);
    return NULL;
}

static bool step(void *state) {
    own_world *own = state;
    b2World_Step(own->id, own->time_step, own->substeps);
    return true;
}

static void read_bodies(void *state, engine_body *bodies) {
    own_world *own = state;
    for (int i = 0; i < own->body_count; i++) {
        b2BodyId id = own->bodies[i];
        b2WorldTransform pose = b2Body_GetTransform(id);
        b2Vec2 velocity = b2Body_GetLinearVelocity(id);
        bodies[i] = (engine_body){
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

/* Box2D counts the bytes of all its worlds; comparisons have only one at a time. */
static uint64_t bytes(void *state) {
    own_world *own = state;
    return (uint64_t)b2World_GetCounters(own->id).byteCount;
}

static engine_events events(void *state) {
    own_world *own = state;
    b2ContactEvents contact = b2World_GetContactEvents(own->id);
    b2SensorEvents sensor = b2World_GetSensorEvents(own->id);
    return (engine_events){contact.beginCount, contact.endCount, contact.hitCount,
                           sensor.beginCount, sensor.endCount};
}

static bool set_time_step(void *state, double seconds) {
    own_world *own = state;
    own->time_step = (float)seconds;
    return true;
}

static void read_pose(void *state, int body, double x, double y, float out[4]) {
    own_world *own = state;
    b2WorldTransform pose = b2Body_GetTransform(own->bodies[body]);
    out[0] = (float)(pose.p.x - x), out[1] = (float)(pose.p.y - y);
    out[2] = pose.q.c, out[3] = pose.q.s;
}

/* Destroys a body and creates a dynamic circle in its place. */
static bool renew(void *state, const scene *s, int body) {
    own_world *own = state;
    const scene_body *from = &s->bodies[body];
    b2BodyDef def = b2DefaultBodyDef();
    b2ShapeDef shape = b2DefaultShapeDef();
    b2Circle circle = {{0, 0}, (float)s->shapes[from->first_shape].hx};
    def.type = b2_dynamicBody;
    def.position = vec2(from->x, from->y);
    b2DestroyBody(own->bodies[body]);
    own->bodies[body] = b2CreateBody(own->id, &def);
    return B2_IS_NON_NULL(b2CreateCircleShape(own->bodies[body], &shape, &circle));
}

static bool misuse_body(void *state, int body, misuse call, double value) {
    own_world *own = state;
    misuse_box2d(own->id, own->bodies[body], call, value);
    return false;
}

const physics_engine engine_box2d = {
    .name = "box2d",
    .needs_avx2 = true,
    .can_build = box2d_has_joints,
    .create = create,
    .destroy = destroy,
    .step = step,
    .read = read_bodies,
    .bytes = bytes,
    .events = events,
    .set_time_step = set_time_step,
    .pose = read_pose,
    .renew = renew,
    .misuse = misuse_body,
};
