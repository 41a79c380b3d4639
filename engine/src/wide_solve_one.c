/* wide_solve_one.c: solver passes for contacts of one point: whatever meets a circle, and boxes
 * that do not rotate. */
#include "wide_solve.h"

TD_SOLVE_PASSES(1)

extern const td_solve_ops TD_WIDE(td_solve_one);
const td_solve_ops TD_WIDE(td_solve_one) = TD_SOLVE_TABLE;
