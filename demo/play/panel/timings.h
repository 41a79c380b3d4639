/* timings.h: a stacked graph of the time that each stage of the last steps took. */
#ifndef THUD_PLAY_TIMINGS_H
#define THUD_PLAY_TIMINGS_H

#include "draw/canvas.h"

#include <thud/thud.h>

/* Number of steps that the graph shows. */
enum { TIMINGS_KEPT = 180 };

typedef struct timings {
    float seconds[TIMINGS_KEPT][THUD_STAGE_COUNT]; /* a ring buffer of steps */
    int count, next;
} timings;

void timings_clear(timings *t);
void timings_add(timings *t, const thud_stats *stats);
void timings_draw(const timings *t, canvas *c, float footer); /* in the lower right corner */

#endif
