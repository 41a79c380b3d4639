/* levels.c: see levels.h. Each pair goes through the volumes one after the other, as a pipeline
 * would have it, by the engine's own public tests. */
#include "levels.h"

#include <stdlib.h>

enum { VOLUMES = 3 };

static const thud_shape_kind KINDS[VOLUMES] = {THUD_CIRCLE, THUD_AABB, THUD_OBB};

typedef struct wrapped {
    thud_volume volumes[VOLUMES];
} wrapped;

static int passed(const wrapped *a, const wrapped *b) {
    for (int k = 0; k < VOLUMES; k++) {
        bool overlap = false;
        thud_volumes_overlap(&a->volumes[k], &b->volumes[k], &overlap);
        if (!overlap)
            return k;
    }
    return VOLUMES;
}

static bool wrap(const thud_placed *shape, wrapped *out) {
    for (int k = 0; k < VOLUMES; k++)
        if (thud_volume_around_shape(KINDS[k], shape, &out->volumes[k]) != THUD_OK)
            return false;
    return true;
}

bool levels_count(const thud_placed *shapes, const bool *movable, int count, levels *sum) {
    wrapped *all = calloc((size_t)count + 1, sizeof *all);
    bool ok = all != NULL;
    for (int i = 0; ok && i < count; i++)
        ok = wrap(&shapes[i], &all[i]);
    for (int i = 0; ok && i < count; i++)
        for (int k = 0; k < i; k++) {
            if (!movable[i] && !movable[k])
                continue;
            int depth = passed(&all[i], &all[k]);
            sum->pairs++;
            sum->circles += depth >= 1;
            sum->boxes += depth >= 2;
            sum->oriented += depth >= 3;
            sum->exact += depth == VOLUMES && thud_shapes_overlap(&shapes[i], &shapes[k]);
        }
    free(all);
    return ok;
}
