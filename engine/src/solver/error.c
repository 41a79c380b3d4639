/* error.c: sums of the error statistics; see error.h. */
#include "solver/error.h"

#include "state/kinds.h"
#include "constraint/lanes.h"
#include "state/handles.h"

static void resum_kinetic(thud_world *w) {
    double kinetic = TD_PICK_WIDE(w, td_kinetic_energy)(w);
    w->errors.energy_change += kinetic - w->kinetic;
    w->kinetic = kinetic;
}

/* The kinetic energy at the end of the last step is stale where a body has woken, fallen asleep or
 * been edited since. */
static void begin(thud_world *w) {
    if (w->kinetic_stale) {
        resum_kinetic(w);
    }
    w->errors =
        (td_errors){.energy_change = -w->kinetic, .energy_decided = w->errors.energy_decided};
}

static void add_tally(thud_world *w, const td_tally *tally) {
    td_errors *e = &w->errors;
    for (int i = 0; i < TD_LANES; i++) {
        e->points += tally->points[i];
        e->overlaps += tally->overlaps[i];
        e->deepest = td_max_float(e->deepest, -tally->min_distance[i]);
        e->residual = td_max_float(e->residual, -tally->min_speed[i]);
    }
    e->depth += tally->depth[0] + tally->depth[1] + tally->depth[2] + tally->depth[3];
}

/* td_errors_recount, of contacts and of joints. What detection has found of this step, such as the
 * shortfall, is not known yet and begins at 0. */
static void recount(thud_world *w) {
    td_tally tally = {0};
    td_tally_context context = {.skin = w->skin,
                                .overlap = td_overlap_depth_min(w),
                                .to_fixed = w->to_fixed};
    w->errors = (td_errors){.energy_change = w->errors.energy_change,
                            .energy_decided = w->errors.energy_decided};
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        td_block *const *blocks = (td_block *const *)w->scratch.blocks.data + run->first;
        int points = td_form_points(w->kinds[run->kind]->form);
        if (run->kind < TD_PAIR_COUNT) {
            w->error_hooks->tally[w->wide](&tally, blocks, run->count, points, &context);
            w->error_hooks->speeds[w->wide](&tally, blocks, run->count, points, w->velocity.data,
                                            (float)(w->substeps / w->def.time_step));
            continue;
        }
        for (int k = 0; k < run->count; k++) {
            w->kinds[run->kind]->lanes->count(w, blocks[k]);
        }
    }
    add_tally(w, &tally);
}

const td_error_hooks td_error_report = {.begin = begin,
                                        .tally = TD_BOTH_WIDE(td_tally_points),
                                        .speeds = TD_BOTH_WIDE(td_tally_speeds),
                                        .add = add_tally,
                                        .resum_kinetic = resum_kinetic,
                                        .recount = recount};

thud_result thud_world_use_step_error(thud_world *w) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "use step error: not inside a callback");
    }
    w->error_hooks = &td_error_report;
    return THUD_OK;
}
