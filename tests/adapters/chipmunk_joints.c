/* chipmunk_joints.c: creates a scene's joints in Chipmunk 7, which has a constraint for each
 * direction:
 *
 * - a distance is a pin joint, a slide joint if it has limits, and a damped spring if it has a
 *   frequency;
 * - a hinge is a pivot joint, with a rotary limit, a rotary spring and a motor as needed;
 * - a weld is a pivot joint and a gear of ratio 1, which locks the rotation;
 * - a slider is a groove joint with such a gear, and a wheel the groove joint alone, with a motor.
 *   A force along the groove is that of a spring anchored far away along the axis.
 *
 * Stiffness and damping of springs are computed from frequency and damping ratio with the bodies'
 * masses, without lever arms. */
#include "chipmunk_joints.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* m: length of a groove without limits to each side; distance of the anchor of its spring. */
static const double FAR = 1000, BEHIND = 100;

bool chipmunk_has_joints(const scene *s) {
    for (int i = 0; i < s->joint_count; i++)
        if (s->joints[i].kind == SCENE_GEAR || s->joints[i].kind == SCENE_TARGET)
            return false;
    return true;
}

typedef struct maker {
    cpSpace *space;
    cpBody *a, *b;
    cpVect at_a, at_b;
    const scene_joint *joint;
    cpConstraint **parts;
    int count;
} maker;

static cpConstraint *add(maker *m, cpConstraint *part) {
    cpConstraintSetCollideBodies(part, m->joint->collide_connected);
    return m->parts[m->count++] = cpSpaceAddConstraint(m->space, part);
}

/* The reduced mass of two bodies; 0 means static. */
static double together(double one, double other) {
    return 1 / ((one > 0 ? 1 / one : 0) + (other > 0 ? 1 / other : 0));
}

static double mass_of(cpBody *b) {
    return cpBodyGetType(b) == CP_BODY_TYPE_DYNAMIC ? cpBodyGetMass(b) : 0;
}

static double moment_of(cpBody *b) {
    return cpBodyGetType(b) == CP_BODY_TYPE_DYNAMIC ? cpBodyGetMoment(b) : 0;
}

/* Stiffness and damping of a spring with this frequency and damping ratio at a mass. */
static void soften(const scene_drive *d, double mass, double *stiffness, double *damping) {
    double omega = 2 * PI * d->frequency;
    *stiffness = mass * omega * omega;
    *damping = 2 * mass * omega * d->damping;
}

static void add_spring(maker *m, const scene_drive *d, cpVect from, double length) {
    double stiffness, damping;
    soften(d, together(mass_of(m->a), mass_of(m->b)), &stiffness, &damping);
    add(m, cpDampedSpringNew(m->a, m->b, from, m->at_b, length, stiffness, damping));
}

static void add_turn(maker *m, const scene_drive *d) {
    double start = m->joint->angle[1] - m->joint->angle[0];
    if (d->limited)
        add(m, cpRotaryLimitJointNew(m->a, m->b, d->lower - start, d->upper - start));
    if (d->frequency > 0) {
        double stiffness, damping;
        soften(d, together(moment_of(m->a), moment_of(m->b)), &stiffness, &damping);
        /* Chipmunk measures the angle of a relative to b. */
        add(m, cpDampedRotarySpringNew(m->a, m->b, start - d->target, stiffness, damping));
    }
    if (d->motor_force > 0)
        cpConstraintSetMaxForce(add(m, cpSimpleMotorNew(m->a, m->b, -d->motor_speed)),
                                d->motor_force);
}

/* Keeps the relative angle of the bodies. */
static void lock_turn(maker *m) {
    add(m, cpGearJointNew(m->a, m->b, m->joint->angle[0] - m->joint->angle[1], 1));
}

/* A slider along the first frame's axis, with its limits and spring. */
static void add_groove(maker *m, const scene_drive *d) {
    cpVect axis = cpvforangle(m->joint->angle[0]);
    double lower = d->limited ? d->lower : -FAR, upper = d->limited ? d->upper : FAR;
    add(m, cpGrooveJointNew(m->a, m->b, cpvadd(m->at_a, cpvmult(axis, lower)),
                            cpvadd(m->at_a, cpvmult(axis, upper)), m->at_b));
    if (d->frequency > 0)
        add_spring(m, d, cpvsub(m->at_a, cpvmult(axis, BEHIND)), BEHIND + d->target);
}

static void add_distance(maker *m, const scene_drive *d) {
    if (d->limited)
        add(m, cpSlideJointNew(m->a, m->b, m->at_a, m->at_b, d->lower, d->upper));
    if (d->frequency > 0)
        add_spring(m, d, m->at_a, d->target);
    if (m->count == 0)
        cpPinJointSetDist(add(m, cpPinJointNew(m->a, m->b, m->at_a, m->at_b)), m->joint->length);
}

void chipmunk_add_joint(cpSpace *space, const scene_joint *j, cpBody *const *bodies,
                        cpConstraint *parts[CHIPMUNK_PARTS]) {
    maker m = {.space = space,
               .a = bodies[j->body[0]],
               .b = bodies[j->body[1]],
               .at_a = {j->x[0], j->y[0]},
               .at_b = {j->x[1], j->y[1]},
               .joint = j,
               .parts = parts};
    const scene_drive *along = &j->drive[SCENE_ALONG], *turn = &j->drive[SCENE_TURN];
    if (j->kind == SCENE_DISTANCE)
        add_distance(&m, along);
    if (j->kind == SCENE_SLIDER || j->kind == SCENE_WHEEL)
        add_groove(&m, along);
    if (j->kind == SCENE_HINGE || j->kind == SCENE_WELD)
        add(&m, cpPivotJointNew2(m.a, m.b, m.at_a, m.at_b));
    if (j->kind == SCENE_SLIDER || j->kind == SCENE_WELD)
        lock_turn(&m);
    if (j->kind == SCENE_HINGE || j->kind == SCENE_WHEEL)
        add_turn(&m, turn);
    /* A motor without force, which keeps the shapes from colliding. */
    if (j->kind == SCENE_FILTER)
        cpConstraintSetMaxForce(add(&m, cpSimpleMotorNew(m.a, m.b, 0)), 0);
}
