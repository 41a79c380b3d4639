/* measure.h: plays the game of cars.h over a simulated network, and measures what its delay costs:
 * the work of rollbacks, bytes, and how wrong each way of bridging the delay shows the other
 * bodies. */
#ifndef THUD_NETWORK_MEASURE_H
#define THUD_NETWORK_MEASURE_H

#include "wire.h"

/* The largest delay of an input that the rollbacks bridge, steps. */
enum { MEASURE_DEPTH = 60 };

/* A network apart from its delay. */
typedef struct measure_line {
    const char *name;
    double jitter, loss, duplicates, held, held_for; /* as in wire_options */
} measure_line;

typedef struct measure_plan {
    const measure_line *line;
    double delay; /* ms, one way */
    int players, steps, repetitions;
} measure_plan;

/* Ways of showing bodies whose data is old: at their last known place, by free flight from there,
 * by swept prediction, and by running the steps again. */
typedef enum measure_way { WAY_LAST, WAY_FLIGHT, WAY_SWEPT, WAY_ROLLBACK, WAY_COUNT } measure_way;

extern const char *const MEASURE_WAYS[WAY_COUNT];

/* Of distances or of angles, over all frames, players and bodies that are not the player's own. */
typedef struct measure_spread {
    double mean, p99, max;
} measure_spread;

typedef struct measure_errors {
    measure_spread place, angle;           /* from what is shown to the truth: lengths, degrees */
    measure_spread place_jump, angle_jump; /* the largest change of that from frame to frame, of all
                                              bodies: what is seen as a correction */
} measure_errors;

typedef struct measure_result {
    double replayed;          /* steps run again, a second and player */
    double replayed_max;      /* in one frame */
    double waits;             /* share of frames in which a player waited for the others */
    double ms_median, ms_p99; /* of thud_rollback_advance, the new step included */
    double ms_step;           /* median of a step alone, without a rollback */
    double bytes;             /* sent by a player in a second, inputs alone */
    double bytes_in_all;      /* with the heads of UDP and IP */
    double bytes_states;      /* received by a player who is sent packed states instead */
    wire_counts wire;         /* of inputs */
    measure_errors of[WAY_COUNT];
} measure_result;

/* False where memory is short, or if a player's confirmed state is not that of the truth. */
bool measure_run(const measure_plan *plan, measure_result *out);

#endif
