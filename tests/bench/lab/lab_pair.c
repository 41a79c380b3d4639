/* lab_pair.c: see lab_pair.h. */
#include "lab/lab_pair.h"

#include "progress.h"
#include "series.h"

/* Steps of each world; with WARM_UP, stacks have fallen asleep. */
enum { STEPS = 300, TURN = 10, WARM_UP = 180 };

static bool open_one(const lab_pair *pair, bool with, lab_world *lab) {
    thud_world_def def = lab_settings();
    *lab = (lab_world){0};
    scene_init(&lab->scene);
    pair->fill(with, &lab->scene, &def);
    return lab_open(lab, &def) &&
           (!with || !pair->listeners ||
            thud_world_set_listeners(lab->world, pair->listeners) == THUD_OK);
}

static bool take_turns(const lab_pair *pair, lab_world labs[2], bool quick, lab_price *out) {
    static double seconds[2][STEPS];
    int steps = quick ? 2 * TURN : STEPS;
    for (int k = 0; k < 2; k++)
        if (!lab_run(&labs[k], quick ? 2 : WARM_UP, NULL))
            return false;
    for (int first = 0; first < steps; first += TURN) {
        progress_show(pair->feature, (double)first / steps);
        for (int k = 0; k < 2; k++)
            if (!lab_run(&labs[k], TURN, seconds[k] + first))
                return false;
    }
    *out = (lab_price){series_median(seconds[1], steps), series_median(seconds[0], steps)};
    return true;
}

bool lab_compare(const lab_pair *pair, bool quick, lab_price *out) {
    lab_world labs[2] = {{.world = NULL}, {.world = NULL}};
    scene_init(&labs[1].scene);
    bool ok = open_one(pair, false, &labs[0]) && open_one(pair, true, &labs[1]) &&
              take_turns(pair, labs, quick, out);
    progress_clear();
    lab_close(&labs[0]);
    lab_close(&labs[1]);
    return ok;
}
