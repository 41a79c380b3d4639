/* wide_solve_two.c: solver passes for contacts of two points: boxes on boxes and on terrain. */
#include "wide_solve.h"

TD_SOLVE_PASSES(2)

extern const td_solve_ops TD_WIDE(td_solve_two);
const td_solve_ops TD_WIDE(td_solve_two) = TD_SOLVE_TABLE;
