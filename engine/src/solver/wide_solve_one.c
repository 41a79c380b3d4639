/* wide_solve_one.c: the passes of the soft solver (wide_solve.h) for contacts of one point:
 * instances for two moving bodies and for one beside a static body, with and without lever arms. */
#include "solver/wide_bounce.h"

TD_PASS(warm_start_moving, warm_start_blocks, 1, ARMS_ALL, false)
TD_PASS(warm_start_fixed, warm_start_blocks, 1, ARMS_ALL, true)
TD_PASS(solve_moving, solve_blocks, 1, ARMS_ALL, false)
TD_PASS(solve_fixed, solve_blocks, 1, ARMS_ALL, true)
TD_PASS(relax_moving, relax_blocks, 1, ARMS_ALL, false)
TD_PASS(relax_fixed, relax_blocks, 1, ARMS_ALL, true)
TD_PASS(bounce, bounce_blocks, 1)

extern const td_solve_ops TD_WIDE(td_solve_one);
const td_solve_ops TD_WIDE(td_solve_one) = {{warm_start_moving, warm_start_fixed},
                                            {solve_moving, solve_fixed},
                                            {relax_moving, relax_fixed},
                                            bounce,
                                            {NULL, NULL}};

/* Circles about their centres of mass: the normal impulse has no lever arm, the tangent impulse
 * has. */
TD_PASS(solve_centres_moving, solve_blocks, 1, ARMS_NONE, false)
TD_PASS(solve_centres_fixed, solve_blocks, 1, ARMS_NONE, true)
TD_PASS(relax_round_moving, relax_blocks, 1, ARMS_TANGENT, false)
TD_PASS(relax_round_fixed, relax_blocks, 1, ARMS_TANGENT, true)

extern const td_solve_ops TD_WIDE(td_solve_round);
const td_solve_ops TD_WIDE(td_solve_round) = {{warm_start_moving, warm_start_fixed},
                                              {solve_centres_moving, solve_centres_fixed},
                                              {relax_round_moving, relax_round_fixed},
                                              bounce,
                                              {NULL, NULL}};

/* Axis-aligned boxes do not turn: no impulse has a lever arm. */
TD_PASS(relax_flat_moving, relax_blocks, 1, ARMS_NONE, false)
TD_PASS(relax_flat_fixed, relax_blocks, 1, ARMS_NONE, true)

extern const td_solve_ops TD_WIDE(td_solve_flat);
const td_solve_ops TD_WIDE(td_solve_flat) = {{warm_start_moving, warm_start_fixed},
                                             {solve_centres_moving, solve_centres_fixed},
                                             {relax_flat_moving, relax_flat_fixed},
                                             bounce,
                                             {NULL, NULL}};
