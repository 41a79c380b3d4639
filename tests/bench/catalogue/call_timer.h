/* call_timer.h: nanoseconds of a call that takes only a few of them. */
#ifndef THUD_BENCH_CALL_TIMER_H
#define THUD_BENCH_CALL_TIMER_H

#include <stdbool.h>

/* Makes `count` calls, the i-th on the i-th of its prepared inputs, from the first again after the
 * last. Gives something back that every answer has a part in, so that no call is optimised away. */
typedef double call_fn(const void *inputs, int count);

/* Of one call: the least of several batches, each long enough for the clock; whatever else the
 * machine does can only add. */
double call_timer_ns(call_fn *fn, const void *inputs, bool quick);

#endif
