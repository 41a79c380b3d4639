/* box2d_joints.c: creates a scene's joints in Box2D v3.2. Differences between both:
 *
 * - Limits and motors of a distance joint need an enabled spring in Box2D; with frequency 0 it has
 *   no force.
 * - A target is a motor joint, whose two linear directions share one spring and one motor.
 * - Box2D reports that a joint's force exceeds its threshold, but does not break the joint. */
#include "box2d_joints.h"

#include <math.h>

bool box2d_has_joints(const scene *s) {
    for (int i = 0; i < s->joint_count; i++)
        if (s->joints[i].kind == SCENE_GEAR)
            return false;
    return true;
}

static bool is_driven(const scene_drive *d) {
    return d->limited || d->frequency > 0 || d->motor_force > 0;
}

static b2Transform frame_of(const scene_joint *j, int side) {
    double angle = j->angle[side];
    return (b2Transform){{(float)j->x[side], (float)j->y[side]},
                         {(float)cos(angle), (float)sin(angle)}};
}

static void fill_base(b2JointDef *base, const scene_joint *j, const b2BodyId *bodies,
                      const engine_settings *settings) {
    base->bodyIdA = bodies[j->body[0]];
    base->bodyIdB = bodies[j->body[1]];
    base->localFrameA = frame_of(j, 0);
    base->localFrameB = frame_of(j, 1);
    base->collideConnected = j->collide_connected;
    if (settings->joint_hertz > 0)
        base->constraintHertz = (float)settings->joint_hertz;
    if (settings->joint_damping > 0)
        base->constraintDampingRatio = (float)settings->joint_damping;
}

static b2JointId add_distance(b2WorldId world, const scene_joint *j, b2JointDef base) {
    const scene_drive *d = &j->drive[SCENE_ALONG];
    b2DistanceJointDef def = b2DefaultDistanceJointDef();
    def.base = base;
    def.enableSpring = is_driven(d);
    def.length = (float)(def.enableSpring ? d->target : j->length);
    def.hertz = (float)d->frequency;
    def.dampingRatio = (float)d->damping;
    def.upperSpringForce = (float)d->spring_force;
    def.lowerSpringForce = -def.upperSpringForce;
    def.enableLimit = d->limited;
    if (d->limited) {
        def.minLength = (float)d->lower;
        def.maxLength = (float)d->upper;
    }
    def.enableMotor = d->motor_force > 0;
    def.maxMotorForce = (float)d->motor_force;
    def.motorSpeed = (float)d->motor_speed;
    return b2CreateDistanceJoint(world, &def);
}

static b2JointId add_hinge(b2WorldId world, const scene_joint *j, b2JointDef base) {
    const scene_drive *d = &j->drive[SCENE_TURN];
    b2RevoluteJointDef def = b2DefaultRevoluteJointDef();
    def.base = base;
    def.enableSpring = d->frequency > 0;
    def.targetAngle = (float)d->target;
    def.hertz = (float)d->frequency;
    def.dampingRatio = (float)d->damping;
    def.enableLimit = d->limited;
    def.lowerAngle = (float)d->lower;
    def.upperAngle = (float)d->upper;
    def.enableMotor = d->motor_force > 0;
    def.maxMotorTorque = (float)d->motor_force;
    def.motorSpeed = (float)d->motor_speed;
    return b2CreateRevoluteJoint(world, &def);
}

static b2JointId add_slider(b2WorldId world, const scene_joint *j, b2JointDef base) {
    const scene_drive *d = &j->drive[SCENE_ALONG];
    b2PrismaticJointDef def = b2DefaultPrismaticJointDef();
    def.base = base;
    def.enableSpring = d->frequency > 0;
    def.targetTranslation = (float)d->target;
    def.hertz = (float)d->frequency;
    def.dampingRatio = (float)d->damping;
    def.enableLimit = d->limited;
    def.lowerTranslation = (float)d->lower;
    def.upperTranslation = (float)d->upper;
    def.enableMotor = d->motor_force > 0;
    def.maxMotorForce = (float)d->motor_force;
    def.motorSpeed = (float)d->motor_speed;
    return b2CreatePrismaticJoint(world, &def);
}

static b2JointId add_weld(b2WorldId world, const scene_joint *j, b2JointDef base) {
    b2WeldJointDef def = b2DefaultWeldJointDef();
    def.base = base;
    def.linearHertz = (float)j->drive[SCENE_ALONG].frequency;
    def.linearDampingRatio = (float)j->drive[SCENE_ALONG].damping;
    def.angularHertz = (float)j->drive[SCENE_TURN].frequency;
    def.angularDampingRatio = (float)j->drive[SCENE_TURN].damping;
    return b2CreateWeldJoint(world, &def);
}

static b2JointId add_wheel(b2WorldId world, const scene_joint *j, b2JointDef base) {
    const scene_drive *along = &j->drive[SCENE_ALONG], *turn = &j->drive[SCENE_TURN];
    b2WheelJointDef def = b2DefaultWheelJointDef();
    def.base = base;
    def.enableSpring = along->frequency > 0;
    def.hertz = (float)along->frequency;
    def.dampingRatio = (float)along->damping;
    def.enableLimit = along->limited;
    def.lowerTranslation = (float)along->lower;
    def.upperTranslation = (float)along->upper;
    def.enableMotor = turn->motor_force > 0;
    def.maxMotorTorque = (float)turn->motor_force;
    def.motorSpeed = (float)turn->motor_speed;
    return b2CreateWheelJoint(world, &def);
}

static b2JointId add_target(b2WorldId world, const scene_joint *j, b2JointDef base) {
    const scene_drive *along = &j->drive[SCENE_ALONG], *across = &j->drive[SCENE_ACROSS],
                      *turn = &j->drive[SCENE_TURN];
    b2MotorJointDef def = b2DefaultMotorJointDef();
    def.base = base;
    def.linearVelocity = (b2Vec2){(float)along->motor_speed, (float)across->motor_speed};
    def.maxVelocityForce = (float)along->motor_force;
    def.angularVelocity = (float)turn->motor_speed;
    def.maxVelocityTorque = (float)turn->motor_force;
    def.linearHertz = (float)along->frequency;
    def.linearDampingRatio = (float)along->damping;
    def.maxSpringForce = (float)along->spring_force;
    def.angularHertz = (float)turn->frequency;
    def.angularDampingRatio = (float)turn->damping;
    def.maxSpringTorque = (float)turn->spring_force;
    return b2CreateMotorJoint(world, &def);
}

static b2JointId add_filter(b2WorldId world, const scene_joint *j, b2JointDef base) {
    (void)j;
    b2FilterJointDef def = b2DefaultFilterJointDef();
    def.base = base;
    return b2CreateFilterJoint(world, &def);
}

bool box2d_add_joints(b2WorldId world, const scene *s, const b2BodyId *bodies,
                      const engine_settings *settings) {
    static b2JointId (*const ADD[])(b2WorldId, const scene_joint *, b2JointDef) = {
        [SCENE_DISTANCE] = add_distance, [SCENE_HINGE] = add_hinge, [SCENE_SLIDER] = add_slider,
        [SCENE_WELD] = add_weld,         [SCENE_WHEEL] = add_wheel, [SCENE_TARGET] = add_target,
        [SCENE_FILTER] = add_filter,
    };
    for (int i = 0; i < s->joint_count; i++) {
        const scene_joint *j = &s->joints[i];
        b2JointDef base = b2DefaultWeldJointDef().base;
        fill_base(&base, j, bodies, settings);
        if (B2_IS_NULL(ADD[j->kind](world, j, base)))
            return false;
    }
    return true;
}
