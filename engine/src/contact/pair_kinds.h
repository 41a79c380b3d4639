/* pair_kinds.h: the table of pair kinds (which shapes make a pair of which kind, and the functions
 * that find and solve its contacts), and the numbers of all kinds of constraints, those of joints
 * too.
 *
 * The rows are in groups. The functions of a group are in one wide file, which defines their tables
 * by TD_DEFINE_PAIR. A world gets the groups that a kind of shape needs with its first shape of
 * that kind (state/kind_*.c), so that a program links no others. */
#ifndef TD_PAIR_KINDS_H
#define TD_PAIR_KINDS_H

#include "constraint/constraint_ops.h"
#include "thud/thud_geometry.h"

/* ROW(pair kind, name of its table, form of its blocks, sift, collide, collide_world, solver,
 * solver for runs without a block that has offsets), as in td_constraint_ops. The name of a pair
 * gives the kinds of a and b in this order. Side b is never static; blocks in which a is static are
 * marked as such. */

/* wide_circle.c */
#define TD_CIRCLE_PAIRS(ROW)                                                                    \
    ROW(TD_PAIR_CIRCLE_CIRCLE, td_pair_circle_circle, TD_FORM_ONE, sift_circles, circle_circle, \
        NULL, td_solve_one_point, td_solve_circles)

/* wide_circle.c; the circle is a only where its body is static. */
#define TD_BOX_CIRCLE_PAIRS(ROW)                                                                \
    ROW(TD_PAIR_BOX_CIRCLE, td_pair_box_circle, TD_FORM_ONE, sift_box_circle, box_circle, NULL, \
        td_solve_one_point, td_solve_one_point)                                                 \
    ROW(TD_PAIR_CIRCLE_BOX, td_pair_circle_box, TD_FORM_ONE, sift_circle_box, circle_box, NULL, \
        td_solve_one_point, td_solve_one_point)

/* wide_aabb.c */
#define TD_AABB_PAIRS(ROW)                                                              \
    ROW(TD_PAIR_AABB_AABB, td_pair_aabb_aabb, TD_FORM_ONE, sift_aabbs, aabb_aabb, NULL, \
        td_solve_aabbs, td_solve_aabbs)

/* wide_box.c; one of the two boxes may be an AABB. */
#define TD_OBB_PAIRS(ROW)                                                                \
    ROW(TD_PAIR_BOX_BOX, td_pair_box_box, TD_FORM_TWO_CACHED, sift_boxes, box_box, NULL, \
        td_solve_two_points, td_solve_two_points)

/* wide_terrain.c; the vertices of a terrain are not in its shape proxy, so that its kernels are
 * given the world (collide_world), and there is no sift. */
#define TD_TERRAIN_PAIRS(ROW)                                                                  \
    ROW(TD_PAIR_TERRAIN_CIRCLE, td_pair_terrain_circle, TD_FORM_ONE_CACHED, NULL, NULL,        \
        terrain_circle, td_solve_one_point, td_solve_one_point)                                \
    ROW(TD_PAIR_TERRAIN_BOX, td_pair_terrain_box, TD_FORM_TWO_CACHED, NULL, NULL, terrain_box, \
        td_solve_two_points, td_solve_two_points)

/* Snapshots have these numbers: a new pair kind comes last. */
#define TD_ALL_PAIRS(ROW)    \
    TD_CIRCLE_PAIRS(ROW)     \
    TD_BOX_CIRCLE_PAIRS(ROW) \
    TD_AABB_PAIRS(ROW)       \
    TD_OBB_PAIRS(ROW)        \
    TD_TERRAIN_PAIRS(ROW)

#define TD_PAIR_ENUMERATOR(kind, ...) kind,

typedef enum td_pair_kind {
    TD_ALL_PAIRS(TD_PAIR_ENUMERATOR) /* of solid shapes */
    TD_PAIR_SENSOR                   /* of a sensor and another shape; has no blocks */
} td_pair_kind;

enum { TD_PAIR_TOUCH_COUNT = TD_PAIR_SENSOR, TD_PAIR_COUNT = TD_PAIR_SENSOR + 1 };

/* The kinds of all constraints (constraint/constraint.h): the pair kinds, which are those of
 * contacts, and behind them the parts of joints. They share one range since each is an index into
 * thud_world.kinds, .bins and .waiting. */
enum {
    TD_CONSTRAINT_ROD = TD_PAIR_COUNT, /* locks the distance of two anchors */
    TD_CONSTRAINT_LOCK,                /* locks directions (along, across, turn) of a frame */
    TD_CONSTRAINT_DRIVE_LINE,          /* limit, spring and motor of the distance of two anchors */
    TD_CONSTRAINT_DRIVE_AXIS,          /* limit, spring and motor along an axis of a frame */
    TD_CONSTRAINT_DRIVE_TURN,          /* limit, spring and motor of the relative rotation */
    TD_CONSTRAINT_GEAR,                /* couples the coordinates of two joints */
    TD_CONSTRAINT_KINDS
};

/* Defines the table of functions of a row; used in a wide file below the functions that the row
 * names. */
#define TD_DEFINE_PAIR(kind, ops, form, sift, collide, collide_world, solve, solve_centered) \
    extern const td_solve_ops TD_WIDE(solve), TD_WIDE(solve_centered);                       \
    extern const td_constraint_ops TD_WIDE(ops);                                             \
    const td_constraint_ops TD_WIDE(ops) = {                                                 \
        form, NULL, sift, collide, collide_world, &TD_WIDE(solve), &TD_WIDE(solve_centered)};

/* Values in the table of td_pairing_of beside pair kinds. */
enum {
    TD_PAIR_SWAPS =
        0x80, /* added to a pair kind: the two shapes are swapped, unless one of them is static */
    TD_PAIR_NEVER = TD_PAIR_SENSOR /* no such pair: a terrain is never side b, nor meets another */
};

/* The td_pair_kind of shapes of kind a and b in this order, and TD_PAIR_SWAPS where the other order
 * is wanted. Two shapes of the same kind are ordered by their indices. */
static inline unsigned td_pairing_of(thud_shape_kind a, thud_shape_kind b) {
    static const uint8_t of[][THUD_SHAPE_KIND_COUNT] = {
        [THUD_SHAPE_CIRCLE] = {[THUD_SHAPE_CIRCLE] = TD_PAIR_CIRCLE_CIRCLE,
                               [THUD_SHAPE_AABB] = TD_PAIR_CIRCLE_BOX | TD_PAIR_SWAPS,
                               [THUD_SHAPE_OBB] = TD_PAIR_CIRCLE_BOX | TD_PAIR_SWAPS,
                               [THUD_SHAPE_TERRAIN] = TD_PAIR_NEVER | TD_PAIR_SWAPS},
        [THUD_SHAPE_AABB] = {[THUD_SHAPE_CIRCLE] = TD_PAIR_BOX_CIRCLE,
                             [THUD_SHAPE_AABB] = TD_PAIR_AABB_AABB,
                             [THUD_SHAPE_OBB] = TD_PAIR_BOX_BOX | TD_PAIR_SWAPS,
                             [THUD_SHAPE_TERRAIN] = TD_PAIR_NEVER | TD_PAIR_SWAPS},
        [THUD_SHAPE_OBB] = {[THUD_SHAPE_CIRCLE] = TD_PAIR_BOX_CIRCLE,
                            [THUD_SHAPE_AABB] = TD_PAIR_BOX_BOX,
                            [THUD_SHAPE_OBB] = TD_PAIR_BOX_BOX,
                            [THUD_SHAPE_TERRAIN] = TD_PAIR_NEVER | TD_PAIR_SWAPS},
        [THUD_SHAPE_TERRAIN] = {[THUD_SHAPE_CIRCLE] = TD_PAIR_TERRAIN_CIRCLE,
                                [THUD_SHAPE_AABB] = TD_PAIR_TERRAIN_BOX,
                                [THUD_SHAPE_OBB] = TD_PAIR_TERRAIN_BOX,
                                [THUD_SHAPE_TERRAIN] = TD_PAIR_NEVER}};
    _Static_assert(sizeof of / sizeof *of == 4 && THUD_SHAPE_KIND_COUNT == 4,
                   "a new kind of shape needs a row and a column here");
    return of[a][b];
}

/* Whether side a is a terrain, of which the contact has one segment. */
TD_INLINE_SMALL bool td_pair_is_on_line(td_pair_kind kind) {
    switch (kind) {
    case TD_PAIR_TERRAIN_CIRCLE:
    case TD_PAIR_TERRAIN_BOX:
        return true;
    case TD_PAIR_CIRCLE_CIRCLE:
    case TD_PAIR_BOX_CIRCLE:
    case TD_PAIR_CIRCLE_BOX:
    case TD_PAIR_AABB_AABB:
    case TD_PAIR_BOX_BOX:
    case TD_PAIR_SENSOR:
        return false;
    }
    return false;
}

#endif
