/* levels.c: see levels.h. Each pair goes through the tests in order, as in a collision pipeline,
 * with the engine's public functions. */
#include "catalogue/levels.h"

#include <thud/thud_minkowski.h>

#include <math.h>
#include <stdlib.h>

enum { VOLUMES = 3 };

static const thud_shape_kind KINDS[VOLUMES] = {THUD_SHAPE_CIRCLE, THUD_SHAPE_AABB, THUD_SHAPE_OBB};

typedef struct wrapped {
    thud_volume volumes[VOLUMES];
} wrapped;

/* The number of volumes that overlap before the first that does not. */
static int passed(const wrapped *a, const wrapped *b) {
    for (int k = 0; k < VOLUMES; k++) {
        bool overlap = false;
        thud_volumes_overlap(&a->volumes[k], &b->volumes[k], &overlap);
        if (!overlap)
            return k;
    }
    return VOLUMES;
}

/* Computes the bounding volumes of each kind around a shape; false if the shape is invalid. */
static bool wrap(const thud_geometry *shape, wrapped *out) {
    for (int k = 0; k < VOLUMES; k++)
        if (thud_volume_around_shape(KINDS[k], shape, &out->volumes[k]) != THUD_OK)
            return false;
    return true;
}

/* The separation of two boxes along the normals of their sides (separating axis theorem), by their
 * Minkowski sum. It is at most the exact distance, which is larger between two corners. */
static double distance_along_axes(const thud_geometry *a, const thud_geometry *b) {
    thud_minkowski sum;
    double most = -INFINITY;
    if (thud_minkowski_sum(a, b, &sum) != THUD_OK)
        return most;
    for (int i = 0; i < sum.count / 2; i++) {
        double along = sum.normals[i].x * (b->x - a->x) + sum.normals[i].y * (b->y - a->y);
        most = fmax(most, fabs(along) - sum.offsets[i]);
    }
    return most;
}

static void count_near(const thud_geometry *a, const thud_geometry *b, double margin, levels *sum) {
    /* Upper bound of the distance of centres for pairs within the margin along each axis; others
     * are skipped. */
    double reach = hypot(a->hx, a->hy) + hypot(b->hx, b->hy) + 2 * margin;
    thud_closest closest;
    if (hypot(b->x - a->x, b->y - a->y) >= reach ||
        thud_geometry_closest(a, b, &closest) != THUD_OK)
        return;
    bool boxes = a->kind != THUD_SHAPE_CIRCLE && b->kind != THUD_SHAPE_CIRCLE;
    sum->sieved += (boxes ? distance_along_axes(a, b) : closest.distance) < margin;
    sum->near += closest.distance < margin;
}

bool levels_count(const thud_geometry *shapes, const bool *movable, int count, double margin,
                  levels *sum) {
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
            count_near(&shapes[i], &shapes[k], margin, sum);
            sum->exact += depth == VOLUMES && thud_geometry_overlap(&shapes[i], &shapes[k]);
        }
    free(all);
    return ok;
}
