/* call_timer.h: measures functions that take only some nanoseconds a call. */
#ifndef THUD_BENCH_CALL_TIMER_H
#define THUD_BENCH_CALL_TIMER_H

#include <stdbool.h>

/* Makes `count` calls; the i-th has the i-th of its prepared inputs, which repeat after the last
 * one. Returns a number that depends on every result, so that the compiler removes no call. */
typedef double call_fn(const void *inputs, int count);

/* Nanoseconds of a call: the minimum over several batches, each long enough for the clock. The
 * minimum, because other load of the machine can only make a batch slower. */
double call_timer_ns(call_fn *fn, const void *inputs, bool quick);

#endif
