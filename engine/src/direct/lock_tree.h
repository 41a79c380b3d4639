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
 * the body answers an impulse F at its anchor as one body with the symmetric 3 x 3 matrix A of
 * masses and, without F, the momentum g:
 *
 *     A (u, w_i) = g + (F, 0).
 *
 * A hinge leaves w_i free, so that it can be eliminated, and F = M u - m for
 *
 *     M = A_uu - A_uw A_wu / A_ww,   m = g_u - A_uw g_w / A_ww.
 *
 * M and m - M t, shifted from the anchor to the parent's centre, are added to its A and g. (R.
 * Featherstone, "The calculation of robot dynamics using articulated-body inertias", 1983; here in
 * the plane, and with the bodies' own velocities in place of joint coordinates, so that gaps can be
 * closed.) A weld, which also locks the rotation, passes A and g on as they are.
 *
 * Trees of the same shape (as many bodies, each with the same parent and the same kind of joint)
 * are solved side by side in the lanes of vectors. No lane depends on another, so that the result
 * of a tree is the same, whichever trees are solved beside it. */
#ifndef TD_LOCK_TREE_H
#define TD_LOCK_TREE_H

#include "base/indices.h"
#include "direct/reals.h"

/* A body of each tree, with the joint by which it hangs from its parent. Vectors are in world axes.
 * The joint's gap and its impulse are those of the body relative to its parent. Lengths, masses and
 * times are in the caller's units, angles in radians. */
typedef struct td_lock_body {
    /* ---- the trees: set once ---- */
    int parent;          /* a smaller index; TD_NONE: the root */
    bool joined;         /* it has a joint: false for a root that is joined to nothing outside */
    bool weld;           /* the joint locks rotation as well */
    bool turns;          /* false: rotation is locked by the caller; its lever arms are 0 */
    td_reals mass;       /* of the body alone, without the bodies that hang from it */
    td_reals inertia;    /* 1 where `turns` is false */
    td_reals outside[3]; /* of the root: the velocity of the body to which it is joined */
    td_reals arm[2];     /* from the centre of mass to the anchor, at the start of the step */
    td_reals holder[2];  /* from the parent's centre of mass to the anchor, or from that of the body
                            outside */
    td_reals axis[2];    /* of the joint's frame, along which gaps close: joint.h */
    td_reals sweeps;     /* 1 where the body's rotation moves an anchor, else 0 */
    td_reals gap[2], turn_gap; /* at the start of the step; turn_gap of a weld, rad */
    td_reals gain[3];          /* what forces, damping and known impulses of contacts add to the
                                  mean velocity of the step: half of what they add to the velocity
                                  by its end */

    /* ---- a part of the step ---- */
    td_reals velocity[3];                     /* x, y, turn */
    td_reals before[3];                       /* velocity at the start of the part */
    td_reals moved[3];                        /* motion since the start of the step */
    td_reals arm_before[2], holder_before[2]; /* lever arms at the start of the part */
    td_reals rotation[2];                     /* cosine and sine of the rotation by which the lever
                                                 arms of the rows are turned: to the end of the
                                                 part, or averaged over it (rotation_of,
                                                 wide_lock_tree_parts.c) */
    td_reals turn_momentum;            /* angular momentum without the impulses of joints, and
                                          without their stiffness */
    td_reals impulse[2], turn_impulse; /* on the body; -impulse acts on the parent */
    td_reals stiff; /* geometric stiffness of the joints to the body's children, while it is summed
                       up; else 0 */

    /* ---- one solution ---- */
    td_reals arm_now[2], holder_now[2]; /* lever arms of the rows */
    td_reals turning;                   /* moment of inertia, with the geometric stiffness */
    td_reals momentum[3];               /* without the impulses of joints */
    td_reals target[2], turn_target;    /* speeds that the joint has to reach: those that close its
                                           gap, or 0 at the end of a part */
    td_reals a[6];        /* A at the centre of mass: xx, xy, yy, xw, yw, ww; then at the anchor; 0
                             before and after a solution */
    td_reals g[3];        /* g, at the same points */
    td_reals per_turning; /* 1 / A_ww of a hinge */
} td_lock_body;

/* Settings of the world for the step of trees. Speeds are in length/s. */
typedef struct td_lock_step {
    const struct thud_world *world;
    const struct td_island *island; /* one of the islands */
    double time;                    /* the step, s */
    double tolerance;               /* td_island_tolerance */
    double enough;                  /* residual at which Newton's method ends */
    double end_enough;              /* speed along locked directions up to which the velocities at
                                       the end of a part stay as they are: TD_END_ERROR_MAX g h */
    double speed_max;               /* of a body */
    double gravity_speed;           /* td_gravity_speed */
} td_lock_step;

/* Trees of the same shape. */
typedef struct td_lock_trees {
    td_lock_body *bodies;
    int count;                /* bodies of a tree */
    int factorings[TD_TREES]; /* out: solutions for each tree */
    bool solved[TD_TREES];    /* out: the result is good */
    bool used[TD_TREES];      /* in: false for lanes without a tree */
    td_reals closing;         /* in: greatest speed at which a gap may be closed */
    td_reals share;           /* out: length of the last part, as a share of the step */
    td_reals residual;        /* out: greatest speed along a locked direction of a joint at the end
                                 of the step */
} td_lock_trees;

/* The result of a step for one body, which td_lock_tree_write writes to the world, and for the
 * joint by which the body hangs from its parent. `velocity` and `moved`: x, y and rotation.
 * `impulse`: of one substep, along the x and the y axis of the joint's frame, and the angular
 * impulse. */
typedef struct td_lock_result {
    float velocity[3], moved[3];
    float impulse[3];
    float separation[2], turn_gap; /* at the end of the step; turn_gap of a weld */
    td_awake_slot slot;
    int lane;
    struct td_block *block; /* null: the body has no joint of its own */
} td_lock_result;

/* The bodies of an island as a tree. The island's list is made breadth first, so that in a tree
 * every body but the first has one joint to a body that is listed before it. */
typedef struct td_listed_body {
    /* Of the body with this number in the island: */
    int before, link; /* that body, and the number of that joint's constraint in the island */
    int place;        /* the body's index in the tree */
    /* Of the body at this index in the tree: */
    int number, parent;     /* the body's number in the island, and the index of its parent */
    int joint;              /* number of the joint to its parent, or to the outside; or TD_NONE */
    struct td_block *block; /* the joint's lane (constraint/block.h), or null ... */
    int lane;
    double sign;              /* ... and 1 if the body is its side b, -1 if it is side a */
    bool turns, weld, sweeps; /* sweeps: the body's rotation moves an anchor; see td_lock_body */
    double mass, inertia, velocity[3], gain[3], outside[3];
    double arm[2], holder[2], axis[2], gap[2], turn_gap, impulse[3];
} td_listed_body;

/* joints/wide_lock_tree_parts.c: solves all parts of the step. */
typedef void td_lock_tree_parts_fn(td_lock_trees *trees, const td_lock_step *step);
TD_DECLARE_WIDE(td_lock_tree_parts_fn, td_lock_tree_parts);

#endif
