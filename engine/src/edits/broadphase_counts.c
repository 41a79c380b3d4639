/* broadphase_counts.c: thud_world_get_broadphase_counts. */
#include "state/world.h"

#include <thud/thud_reads.h>

thud_result thud_world_get_broadphase_counts(const thud_world *w, thud_broadphase_counts *out) {
    if (!w || !out) {
        return THUD_ERROR_NULL;
    }
    const td_broadphase_counts *step = &w->broadphase;
    *out = (thud_broadphase_counts){.moved = step->moved,
                                    .tested = step->tested,
                                    .found = step->found,
                                    .sort_moves = step->sort_moves};
    /* With another broadphase than the grid all levels are empty. */
    const td_proxy_set *grid = &w->awake_shapes;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (!level->count) {
            continue;
        }
        const int32_t *starts = (const int32_t *)grid->starts.data + level->starts;
        for (uint32_t c = 0; c <= level->mask; c++) {
            int shapes = starts[c + 1] - starts[c];
            out->cells += shapes > 0;
            out->cell_shapes += shapes;
            out->cell_shapes_max = shapes > out->cell_shapes_max ? shapes : out->cell_shapes_max;
        }
    }
    return THUD_OK;
}
