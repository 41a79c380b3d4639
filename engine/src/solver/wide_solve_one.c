/* wide_solve_one.c: the passes of the soft solver (wide_solve.h) for contacts of one
 * point, specialised by what they can leave out: side a where it is static, lever arms that are 0.
 * Instances `_moving` are for a dynamic or kinematic body a, `_static` for a static one.
 *
 * The warm start, one pass a step, is not specialised by lever arms: all three tables share it.
 * Contacts have no pass of bracing (td_solve_ops.brace). */
#include "solver/wide_solve.h"

TD_PASS(warm_start_moving, warm_start_blocks, 1, ARMS_ALL, false)
TD_PASS(warm_start_static, warm_start_blocks, 1, ARMS_ALL, true)
TD_PASS(solve_moving, solve_blocks, 1, ARMS_ALL, false)
TD_PASS(solve_static, solve_blocks, 1, ARMS_ALL, true)
TD_PASS(relax_moving, relax_blocks, 1, ARMS_ALL, false)
TD_PASS(relax_static, relax_blocks, 1, ARMS_ALL, true)

/* The tables are declared here and, where a pair kind names them, by TD_DEFINE_PAIR
 * (contact/pair_kinds.h): no header has their names. */
extern const td_solve_ops TD_WIDE(td_solve_one_point);
const td_solve_ops TD_WIDE(td_solve_one_point) = {
    .warm_start = {warm_start_moving, warm_start_static},
    .solve = {solve_moving, solve_static},
    .relax = {relax_moving, relax_static},
};

/* Two circles, each about its body's centre of mass: normal impulses pass through both centres and
 * have no lever arm; friction, which only the relax pass solves, has one. */
TD_PASS(solve_armless_moving, solve_blocks, 1, ARMS_NONE, false)
TD_PASS(solve_armless_static, solve_blocks, 1, ARMS_NONE, true)
TD_PASS(relax_circles_moving, relax_blocks, 1, ARMS_TANGENT, false)
TD_PASS(relax_circles_static, relax_blocks, 1, ARMS_TANGENT, true)

extern const td_solve_ops TD_WIDE(td_solve_circles);
const td_solve_ops TD_WIDE(td_solve_circles) = {
    .warm_start = {warm_start_moving, warm_start_static},
    .solve = {solve_armless_moving, solve_armless_static},
    .relax = {relax_circles_moving, relax_circles_static},
};

/* Two axis-aligned boxes: their bodies do not turn, so that no impulse has a lever arm. */
TD_PASS(relax_aabbs_moving, relax_blocks, 1, ARMS_NONE, false)
TD_PASS(relax_aabbs_static, relax_blocks, 1, ARMS_NONE, true)

extern const td_solve_ops TD_WIDE(td_solve_aabbs);
const td_solve_ops TD_WIDE(td_solve_aabbs) = {
    .warm_start = {warm_start_moving, warm_start_static},
    .solve = {solve_armless_moving, solve_armless_static},
    .relax = {relax_aabbs_moving, relax_aabbs_static},
};
