/* wide_solve_one.c: the passes of the soft solver (wide_solve.h) for contacts of one point:
 * instances for two moving bodies and for one beside a static body, with and without lever arms. */
#include "solver/wide_bounce.h"

TD_PASS(warm_start_moving, warm_start_blocks, 1, ARMS_ALL, false)
TD_PASS(warm_start_static, warm_start_blocks, 1, ARMS_ALL, true)
TD_PASS(solve_moving, solve_blocks, 1, ARMS_ALL, false)
TD_PASS(solve_static, solve_blocks, 1, ARMS_ALL, true)
TD_PASS(relax_moving, relax_blocks, 1, ARMS_ALL, false)
TD_PASS(relax_static, relax_blocks, 1, ARMS_ALL, true)
TD_PASS(bounce, bounce_blocks, 1)

extern const td_solve_ops TD_WIDE(td_solve_one);
const td_solve_ops TD_WIDE(td_solve_one) = {{warm_start_moving, warm_start_static},
                                            {solve_moving, solve_static},
                                            {relax_moving, relax_static},
                                            bounce,
                                            {NULL, NULL}};

/* Circles about their centres of mass: the normal impulse has no lever arm, the tangent impulse
 * has. */
TD_PASS(solve_armless_moving, solve_blocks, 1, ARMS_NONE, false)
TD_PASS(solve_armless_static, solve_blocks, 1, ARMS_NONE, true)
TD_PASS(relax_round_moving, relax_blocks, 1, ARMS_TANGENT, false)
TD_PASS(relax_round_static, relax_blocks, 1, ARMS_TANGENT, true)

extern const td_solve_ops TD_WIDE(td_solve_round);
const td_solve_ops TD_WIDE(td_solve_round) = {{warm_start_moving, warm_start_static},
                                              {solve_armless_moving, solve_armless_static},
                                              {relax_round_moving, relax_round_static},
                                              bounce,
                                              {NULL, NULL}};

/* Axis-aligned boxes do not turn: no impulse has a lever arm. */
TD_PASS(relax_flat_moving, relax_blocks, 1, ARMS_NONE, false)
TD_PASS(relax_flat_static, relax_blocks, 1, ARMS_NONE, true)

extern const td_solve_ops TD_WIDE(td_solve_flat);
const td_solve_ops TD_WIDE(td_solve_flat) = {{warm_start_moving, warm_start_static},
                                             {solve_armless_moving, solve_armless_static},
                                             {relax_flat_moving, relax_flat_static},
                                             bounce,
                                             {NULL, NULL}};
