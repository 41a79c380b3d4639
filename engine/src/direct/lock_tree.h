/* lock_tree.h: the motion of bodies that hinges and welds join into a tree, solved exactly in time
 * that grows with the number of bodies: a rope, a chain, a pendulum.
 *
 * One body, the root, may also be locked to a body outside of the tree. Every other body i hangs
 * from a body p, its parent, by an anchor, whose velocity in the two bodies differs by the speed t
 * at which the joint's gap closes:
 *
 *     u = v_i + w_i x r_i = v_p + w_p x r_p + t,
 *
 * where v and w are the velocity of a centre of mass and the rate of turning, and r the lever arm.
 * Bodies are eliminated from the ends of the tree towards its root. With all that hangs from it,
 * the body answers a force F at its anchor as a body with the symmetric 3 x 3 matrix A of masses
 * and the momentum g:
 *
 *     A (u, w_i) = g + (F, 0).
 *
 * A hinge leaves w_i free, so that it can be eliminated, and F = M u - m for
 *
 *     M = A_uu - A_uw A_wu / A_ww,   m = g_u - A_uw g_w / A_ww.
 *
 * The parent gets M, and m - M t, at its end of the lever arm. (R. Featherstone, "The calculation
 * of robot dynamics using articulated-body inertias", 1983; here in the plane, and with the bodies'
 * own velocities in place of joint coordinates, so that gaps can be closed.) A weld, which also
 * locks the rotation, passes A and g on as they are. */
#ifndef TD_LOCK_TREE_H
#define TD_LOCK_TREE_H

#include "base/indices.h"

#include <stdbool.h>

/* A body, with the joint by which it hangs from its parent. Vectors are in world axes. The
 * joint's gap and its impulse are those of the body relative to its parent. Lengths, masses and
 * times are in the caller's units, angles in radians. */
typedef struct td_lock_body {
    /* ---- the tree: set once ---- */
    int parent;             /* a smaller index; TD_NONE: the root */
    int number, link;       /* numbers of the body and of the joint's constraint in their island */
    struct td_block *block; /* the joint's lane (constraint/block.h) ... */
    int lane;
    double sign;       /* ... and 1 if the body is its side b, -1 if it is side a */
    bool joined;       /* it has a joint: false for a root that is joined to nothing outside */
    bool weld;         /* the joint locks rotation as well */
    bool turns;        /* false: rotation is locked by the caller; its lever arms are 0 */
    bool sweeps;       /* its rotation moves an anchor */
    double mass;       /* without what hangs from it */
    double inertia;    /* 1 where `turns` is false */
    double outside[3]; /* of the root: the velocity of the body to which it is joined */
    double arm[2];     /* from the centre of mass to the anchor, at the start of the step */
    double holder[2];  /* the lever arm of the parent likewise */
    double axis[2];    /* of the joint's frame, along which gaps close: joint.h */
    double gap[2], turn_gap; /* at the start of the step; turn_gap of a weld, rad */

    /* ---- a part of the step ---- */
    double velocity[3];                     /* x, y, turn */
    double before[3];                       /* velocity at the start of the part */
    double gain[3];                         /* what forces add to the velocity in a part */
    double moved[3];                        /* motion since the start of the step */
    double arm_before[2], holder_before[2]; /* lever arms at the start of the part */
    double rotation[2];                     /* cosine and sine by which they are turned */
    double closing[2], turn_closing;        /* speed that the joint shall have: it closes the gap */
    double impulse[2], turn_impulse;        /* on the body; -impulse acts on the parent */
    double kept[3]; /* impulses that stay while further ones are solved for */
    double stiff;   /* the geometric stiffness, while it is summed up */
    double turned;  /* rate of turning in the iteration before, rad/s */

    /* ---- one solution ---- */
    double arm_now[2], holder_now[2]; /* lever arms of the rows */
    double turning;                   /* moment of inertia, with the geometric stiffness */
    double momentum[3];               /* without the impulses of joints */
    double target[2], turn_target;    /* speeds of the joint */
    double a[6];        /* A at the centre of mass: xx, xy, yy, xw, yw, ww; then at the anchor */
    double g[3];        /* g likewise */
    double per_turning; /* 1 / A_ww of a hinge */
} td_lock_body;

/* The result of a step: what is written to the world of a body and of the joint by which it hangs.
 * Impulses are those of a substep, along and across the joint's frame and its turn. */
typedef struct td_lock_result {
    float velocity[3], moved[3];
    float impulse[3];
    float separation[2], turn_gap; /* at the end of the step */
    td_awake_slot slot;
    int lane;
    struct td_block *block; /* null: the body has no joint of its own */
} td_lock_result;

/* A body of an island by its number there. The island's list is made breadth first, so that in a
 * tree every body but the first has one joint to a body that is listed before it. */
typedef struct td_listed_body {
    int before, link; /* that body, and the number of that joint's constraint in the island */
    int place;        /* the body's index in the tree */
} td_listed_body;

/* Solves for the velocities and the impulses of the joints, with the lever arms, momenta and
 * targets that are set. False where a number is not finite, or a rate of turning is above
 * THUD_ANGULAR_SPEED_MAX. */
bool td_lock_tree_solve(td_lock_body *bodies, int count);

/* The greatest speed by which a joint misses its target, a length per second; of a weld's rotation,
 * radians per second. */
double td_lock_tree_residual(const td_lock_body *bodies, int count);

#endif
