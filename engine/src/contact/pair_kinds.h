/* pair_kinds.h: the table of pair kinds: which shapes meet in which of them, with what; and the
 * numbers of all kinds of constraints, joints too.
 *
 * A row names what finds a pair's contacts and solves them. Rows stand in groups, for each of which
 * one wide file defines the operations (TD_DEFINE_PAIR) and which a kind of shape plugs into a
 * world when it is first used (state/kind_*.c), so that a program links no others. */
#ifndef TD_PAIR_KINDS_H
#define TD_PAIR_KINDS_H

#include "constraint/constraint_ops.h"
#include "thud/thud_shapes.h"

/* ROW(pair kind, its operations, form of its blocks, sift, collide, collide_world, solver, solver
 * of blocks of which none is armed), as td_constraint_ops has them. The names of a pair say (a, b),
 * b always moves, and where a is static its blocks are marked so. */

/* wide_circle.c */
#define TD_CIRCLE_PAIRS(ROW)                                                                    \
    ROW(TD_PAIR_CIRCLE_CIRCLE, td_pair_circle_circle, TD_FORM_ONE, sift_circles, circle_circle, \
        NULL, td_solve_one, td_solve_round)

/* wide_circle.c; a circle comes before a box only where the circle is static. */
#define TD_BOX_CIRCLE_PAIRS(ROW)                                                                \
    ROW(TD_PAIR_BOX_CIRCLE, td_pair_box_circle, TD_FORM_ONE, sift_box_circle, box_circle, NULL, \
        td_solve_one, td_solve_one)                                                             \
    ROW(TD_PAIR_CIRCLE_BOX, td_pair_circle_box, TD_FORM_ONE, sift_circle_box, circle_box, NULL, \
        td_solve_one, td_solve_one)

/* wide_aabb.c */
#define TD_AABB_PAIRS(ROW)                                                              \
    ROW(TD_PAIR_AABB_AABB, td_pair_aabb_aabb, TD_FORM_ONE, sift_aabbs, aabb_aabb, NULL, \
        td_solve_flat, td_solve_flat)

/* wide_box.c; one of the two may be an AABB. */
#define TD_OBB_PAIRS(ROW)                                                                \
    ROW(TD_PAIR_BOX_BOX, td_pair_box_box, TD_FORM_TWO_CACHED, sift_boxes, box_box, NULL, \
        td_solve_two, td_solve_two)

/* wide_terrain.c; the geometry of lines does not lie in the records of shapes, and their pairs are
 * sifted by segments. */
#define TD_TERRAIN_PAIRS(ROW)                                                                  \
    ROW(TD_PAIR_TERRAIN_CIRCLE, td_pair_terrain_circle, TD_FORM_ONE_CACHED, NULL, NULL,        \
        terrain_circle, td_solve_one, td_solve_one)                                            \
    ROW(TD_PAIR_TERRAIN_BOX, td_pair_terrain_box, TD_FORM_TWO_CACHED, NULL, NULL, terrain_box, \
        td_solve_two, td_solve_two)

/* Snapshots keep contacts by the number of their pair kind: new ones come last. */
#define TD_ALL_PAIRS(ROW)    \
    TD_CIRCLE_PAIRS(ROW)     \
    TD_BOX_CIRCLE_PAIRS(ROW) \
    TD_AABB_PAIRS(ROW)       \
    TD_OBB_PAIRS(ROW)        \
    TD_TERRAIN_PAIRS(ROW)

#define TD_PAIR_ENUMERATOR(kind, ...) kind,

typedef enum td_pair_kind {
    TD_ALL_PAIRS(TD_PAIR_ENUMERATOR) /* of shapes that push each other apart */
    TD_PAIR_SENSOR                   /* overlap only; has no blocks */
} td_pair_kind;

enum { TD_PAIR_TOUCH_COUNT = TD_PAIR_SENSOR, TD_PAIR_COUNT = TD_PAIR_SENSOR + 1 };

/* The kinds of all constraints (constraint/constraint.h): first the pair kinds, which are those of
 * contacts, and then a number for each kind of joint. They are one range because each is an index
 * into thud_world.kinds, .bins and .waiting. */
enum {
    TD_CONSTRAINT_ROD = TD_PAIR_COUNT, /* a distance, locked */
    TD_CONSTRAINT_HOLD,                /* other directions, locked */
    TD_CONSTRAINT_DRIVE_LINE,          /* a distance, driven */
    TD_CONSTRAINT_DRIVE_AXIS,          /* a direction, driven */
    TD_CONSTRAINT_DRIVE_TURN,
    TD_CONSTRAINT_GEAR, /* two joints against each other */
    TD_CONSTRAINT_KINDS
};

/* Stands in a wide file, below the functions that a row names, and defines the operations of that
 * row. */
#define TD_DEFINE_PAIR(kind, ops, form, sift, collide, collide_world, solve, solve_unarmed) \
    extern const td_solve_ops TD_WIDE(solve), TD_WIDE(solve_unarmed);                       \
    extern const td_constraint_ops TD_WIDE(ops);                                            \
    const td_constraint_ops TD_WIDE(ops) = {                                                \
        form, NULL, sift, collide, collide_world, &TD_WIDE(solve), &TD_WIDE(solve_unarmed)};

/* What stands in the table of td_pairing_of beside pair kinds. */
enum {
    TD_PAIR_SWAPS = 0x80, /* beside a pair kind: where neither is static, they change places */
    TD_PAIR_NEVER = TD_PAIR_SENSOR /* a line gives way to nothing: it never comes second, and never
                                      meets another */
};

/* The td_pair_kind of shapes of kind `a` and `b` in this order, and whether it is to be the other
 * one. A static shape comes first. Two shapes of one kind are told apart by their numbers, and swap
 * by those alone. */
static inline unsigned td_pairing_of(thud_shape_kind a, thud_shape_kind b) {
    static const uint8_t of[][THUD_SHAPE_KIND_COUNT] = {
        [THUD_CIRCLE] = {[THUD_CIRCLE] = TD_PAIR_CIRCLE_CIRCLE,
                         [THUD_AABB] = TD_PAIR_CIRCLE_BOX | TD_PAIR_SWAPS,
                         [THUD_OBB] = TD_PAIR_CIRCLE_BOX | TD_PAIR_SWAPS,
                         [THUD_TERRAIN] = TD_PAIR_NEVER | TD_PAIR_SWAPS},
        [THUD_AABB] = {[THUD_CIRCLE] = TD_PAIR_BOX_CIRCLE,
                       [THUD_AABB] = TD_PAIR_AABB_AABB,
                       [THUD_OBB] = TD_PAIR_BOX_BOX | TD_PAIR_SWAPS,
                       [THUD_TERRAIN] = TD_PAIR_NEVER | TD_PAIR_SWAPS},
        [THUD_OBB] = {[THUD_CIRCLE] = TD_PAIR_BOX_CIRCLE,
                      [THUD_AABB] = TD_PAIR_BOX_BOX,
                      [THUD_OBB] = TD_PAIR_BOX_BOX,
                      [THUD_TERRAIN] = TD_PAIR_NEVER | TD_PAIR_SWAPS},
        [THUD_TERRAIN] = {[THUD_CIRCLE] = TD_PAIR_TERRAIN_CIRCLE,
                          [THUD_AABB] = TD_PAIR_TERRAIN_BOX,
                          [THUD_OBB] = TD_PAIR_TERRAIN_BOX,
                          [THUD_TERRAIN] = TD_PAIR_NEVER}};
    _Static_assert(sizeof of / sizeof *of == 4 && THUD_SHAPE_KIND_COUNT == 4,
                   "a new kind of shape needs a row and a column here");
    return of[a][b];
}

/* Side a is a line, of which the contact has one segment. */
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
