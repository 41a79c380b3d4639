/* wide_solve_two.c: the passes of the soft solver (wide_solve.h) for contacts of two
 * points: boxes on boxes and on terrain. `_moving`, `_static`: wide_solve_one.c. */
#include "solver/wide_solve.h"

TD_PASS(warm_start_moving, warm_start_blocks, 2, ARMS_ALL, false)
TD_PASS(warm_start_static, warm_start_blocks, 2, ARMS_ALL, true)
TD_PASS(solve_moving, solve_blocks, 2, ARMS_ALL, false)
TD_PASS(solve_static, solve_blocks, 2, ARMS_ALL, true)
TD_PASS(relax_moving, relax_blocks, 2, ARMS_ALL, false)
TD_PASS(relax_static, relax_blocks, 2, ARMS_ALL, true)

extern const td_solve_ops TD_WIDE(td_solve_two_points);
const td_solve_ops TD_WIDE(td_solve_two_points) = {
    .warm_start = {warm_start_moving, warm_start_static},
    .solve = {solve_moving, solve_static},
    .relax = {relax_moving, relax_static},
};
