/* call_timer.c: see call_timer.h. */
#include "catalogue/call_timer.h"

#include "lab/lab_world.h"

#include <math.h>

enum { BATCHES = 7, QUICK_BATCHES = 3, LEAST_CALLS = 256, MOST_CALLS = 1 << 24 };

/* Duration of a batch in seconds: thousands of the clock's ticks. Chosen. */
static const double BATCH = 2e-3, QUICK_BATCH = 2e-4;

static volatile double answers;

static double seconds_of(call_fn *fn, const void *inputs, int count) {
    double start = lab_now(NULL);
    answers = fn(inputs, count);
    return lab_now(NULL) - start;
}

double call_timer_ns(call_fn *fn, const void *inputs, bool quick) {
    double least = INFINITY;
    int count = LEAST_CALLS, batches = quick ? QUICK_BATCHES : BATCHES;
    while (seconds_of(fn, inputs, count) < (quick ? QUICK_BATCH : BATCH) && count < MOST_CALLS)
        count *= 2;
    for (int i = 0; i < batches; i++)
        least = fmin(least, seconds_of(fn, inputs, count));
    return least / count * 1e9;
}
