/* engine_chipmunk.c: Chipmunk 7, by the interface of engine.h; it computes in double precision.
 * Differences:
 *
 * - An AABB is a box whose body has an infinite moment of inertia.
 * - Terrain is a row of segments, which are solid on both sides.
 * - Friction and restitution are combined as products, so that each shape gets the square root of
 *   its value.
 * - Groups exist only as negative numbers, whose shapes do not collide. */
#include "chipmunk_joints.h"
#include "engine.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { ITERATIONS = 10 };

static const double PI = 3.14159265358979323846, FLAT_HALF_WIDTH = 4096;

typedef struct own_world {
    cpSpace *space;
    const scene *scene;
    double time_step;
    int part_count, shape_count;
    cpBody **bodies;
    cpShape **shapes;
    cpConstraint **parts;
} own_world;

static bool can_build(const scene *s) {
    for (int i = 0; i < s->shape_count; i++)
        if (s->shapes[i].group > 0)
            return false;
    return chipmunk_has_joints(s);
}

/* Gravity scale and damping are taken from the scene's body, which is the user data. */
static void update_velocity(cpBody *body, cpVect gravity, cpFloat damping, cpFloat dt) {
    const scene_body *b = cpBodyGetUserData(body);
    cpBodyUpdateVelocity(body, cpvmult(gravity, b->gravity_scale),
                         damping * exp(-b->linear_damping * dt), dt);
    cpBodySetAngularVelocity(body, cpBodyGetAngularVelocity(body) *
                                       exp((b->linear_damping - b->angular_damping) * dt));
}

static double area_of(const scene_shape *shape) {
    return shape->kind == SCENE_CIRCLE ? PI * shape->hx * shape->hx : 4 * shape->hx * shape->hy;
}

static cpShape *box_of(cpBody *body, const scene_shape *shape) {
    double turn = shape->kind == SCENE_OBB ? shape->angle : 0;
    cpVect x = cpvmult(cpvforangle(turn), shape->hx);
    cpVect y = cpvmult(cpvperp(cpvforangle(turn)), shape->hy);
    cpVect middle = cpv(shape->x, shape->y);
    cpVect corners[4] = {cpvadd(middle, cpvadd(x, y)), cpvadd(middle, cpvsub(y, x)),
                         cpvsub(middle, cpvadd(x, y)), cpvadd(middle, cpvsub(x, y))};
    return cpPolyShapeNewRaw(body, 4, corners, 0);
}

/* Sets a shape's properties and adds it to the space. */
static void keep(own_world *own, const scene_shape *source, cpShape *shape, bool weighs) {
    cpShapeSetFriction(shape, sqrt(source->material.friction));
    cpShapeSetElasticity(shape, sqrt(source->material.restitution));
    cpShapeSetSensor(shape, source->sensor);
    cpShapeSetFilter(shape,
                     cpShapeFilterNew((cpGroup)-source->group, source->category, source->mask));
    if (weighs)
        cpShapeSetDensity(shape, source->material.density);
    own->shapes[own->shape_count++] = cpSpaceAddShape(own->space, shape);
}

static void add_terrain(own_world *own, cpBody *body, const scene_shape *shape) {
    int count = shape->kind == SCENE_TERRAIN_FLAT ? 2 : shape->point_count;
    cpVect before = cpvzero;
    for (int i = 0; i < count; i++) {
        double x = i == 0 ? -FLAT_HALF_WIDTH : FLAT_HALF_WIDTH;
        cpVect here = cpv(x, shape->slope * x);
        if (shape->kind != SCENE_TERRAIN_FLAT) {
            scene_point p = own->scene->points[shape->first_point + i];
            here = cpv(p.x, p.y);
        }
        if (i > 0)
            keep(own, shape, cpSegmentShapeNew(body, before, here, 0), false);
        before = here;
    }
}

static void add_shape(own_world *own, cpBody *body, const scene_shape *shape, bool weighs) {
    if (shape->kind == SCENE_CIRCLE)
        keep(own, shape, cpCircleShapeNew(body, shape->hx, cpv(shape->x, shape->y)), weighs);
    else if (shape->kind == SCENE_AABB || shape->kind == SCENE_OBB)
        keep(own, shape, box_of(body, shape), weighs);
    else
        add_terrain(own, body, shape);
}

static void add_body(own_world *own, int index) {
    const scene *s = own->scene;
    const scene_body *b = &s->bodies[index];
    double mass = 0;
    for (int i = 0; i < b->shape_count; i++)
        mass += s->shapes[b->first_shape + i].material.density *
                area_of(&s->shapes[b->first_shape + i]);
    bool dynamic = b->kind == SCENE_DYNAMIC, weighs = dynamic && !b->fixed_rotation;
    cpBody *body = dynamic                   ? cpBodyNew(weighs ? 0 : mass, weighs ? 0 : INFINITY)
                   : b->kind == SCENE_STATIC ? cpBodyNewStatic()
                                             : cpBodyNewKinematic();
    own->bodies[index] = cpSpaceAddBody(own->space, body);
    for (int i = 0; i < b->shape_count; i++)
        add_shape(own, body, &s->shapes[b->first_shape + i], weighs);
    cpBodySetPosition(body, cpv(b->x, b->y));
    cpBodySetAngle(body, b->angle);
    cpBodySetVelocity(body, cpv(b->vx, b->vy));
    cpBodySetAngularVelocity(body, b->angular_velocity);
    cpBodySetUserData(body, (void *)b);
    if (dynamic)
        cpBodySetVelocityUpdateFunc(body, update_velocity);
    if (!dynamic)
        cpSpaceReindexShapesForBody(own->space, body);
}

static void destroy(void *state) {
    own_world *own = state;
    if (!own)
        return;
    for (int i = 0; i < own->part_count; i++)
        if (own->parts[i]) {
            cpSpaceRemoveConstraint(own->space, own->parts[i]);
            cpConstraintFree(own->parts[i]);
        }
    for (int i = 0; i < own->shape_count; i++) {
        cpSpaceRemoveShape(own->space, own->shapes[i]);
        cpShapeFree(own->shapes[i]);
    }
    for (int i = 0; own->bodies && i < own->scene->body_count; i++)
        if (own->bodies[i]) {
            cpSpaceRemoveBody(own->space, own->bodies[i]);
            cpBodyFree(own->bodies[i]);
        }
    if (own->space)
        cpSpaceFree(own->space);
    free(own->bodies);
    free(own->shapes);
    free(own->parts);
    free(own);
}

/* In a debug build, such as Debian's, the first space prints a greeting to stdout, where programs
 * write JSON; stdout is redirected meanwhile. */
static cpSpace *make_space(void) {
    static bool greeted;
    if (greeted)
        return cpSpaceNew();
    greeted = true;
    fflush(stdout);
    int own = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
    if (own >= 0 && nowhere >= 0)
        dup2(nowhere, STDOUT_FILENO);
    cpSpace *space = cpSpaceNew();
    fflush(stdout);
    if (own >= 0 && nowhere >= 0)
        dup2(own, STDOUT_FILENO);
    if (nowhere >= 0)
        close(nowhere);
    if (own >= 0)
        close(own);
    return space;
}

static void *create(const scene *s, const engine_settings *settings) {
    own_world *own = calloc(1, sizeof *own);
    if (!own)
        return NULL;
    own->scene = s;
    own->time_step = settings->time_step;
    own->space = make_space();
    own->bodies = calloc((size_t)s->body_count + 1, sizeof(cpBody *));
    own->shapes = calloc((size_t)(s->shape_count + s->point_count) + 1, sizeof(cpShape *));
    own->parts = calloc((size_t)s->joint_count * CHIPMUNK_PARTS + 1, sizeof(cpConstraint *));
    if (!own->space || !own->bodies || !own->shapes || !own->parts) {
        destroy(own);
        return NULL;
    }
    cpSpaceSetGravity(own->space, cpv(s->gravity_x, s->gravity_y));
    cpSpaceSetIterations(own->space, settings->iterations > 0 ? settings->iterations : ITERATIONS);
    cpSpaceSetSleepTimeThreshold(own->space, settings->sleeping ? 0.5 : INFINITY);
    for (int i = 0; i < s->body_count; i++)
        add_body(own, i);
    for (int i = 0; i < s->joint_count; i++, own->part_count += CHIPMUNK_PARTS)
        chipmunk_add_joint(own->space, &s->joints[i], own->bodies, own->parts + own->part_count);
    return own;
}

static bool step(void *state) {
    own_world *own = state;
    cpSpaceStep(own->space, own->time_step);
    return true;
}

static void read_bodies(void *state, engine_body *bodies) {
    own_world *own = state;
    for (int i = 0; i < own->scene->body_count; i++) {
        cpBody *b = own->bodies[i];
        cpVect at = cpBodyGetPosition(b), turn = cpBodyGetRotation(b), v = cpBodyGetVelocity(b);
        bool dynamic = cpBodyGetType(b) == CP_BODY_TYPE_DYNAMIC;
        bodies[i] = (engine_body){.x = at.x,
                                  .y = at.y,
                                  .cosine = turn.x,
                                  .sine = turn.y,
                                  .vx = v.x,
                                  .vy = v.y,
                                  .angular_velocity = cpBodyGetAngularVelocity(b),
                                  .mass = dynamic ? cpBodyGetMass(b) : 0,
                                  .inertia = dynamic ? cpBodyGetMoment(b) : 0,
                                  .awake = !cpBodyIsSleeping(b)};
    }
}

/* Chipmunk does not report its memory. */
static uint64_t bytes(void *state) {
    (void)state;
    return 0;
}

static void read_pose(void *state, int body, double x, double y, float out[4]) {
    own_world *own = state;
    cpVect at = cpBodyGetPosition(own->bodies[body]), turn = cpBodyGetRotation(own->bodies[body]);
    out[0] = (float)(at.x - x), out[1] = (float)(at.y - y);
    out[2] = (float)turn.x, out[3] = (float)turn.y;
}

const physics_engine engine_chipmunk = {
    .name = "chipmunk",
    .only_by_name = true,
    .can_build = can_build,
    .create = create,
    .destroy = destroy,
    .step = step,
    .read = read_bodies,
    .bytes = bytes,
    .pose = read_pose,
};
