/* api_minkowski.c: the export that computes the Minkowski sum of two shapes, and the place of the
 * second shape in it. minkowski.ts computes its outline for drawing. */
#include "api.h"

#include <thud/thud_minkowski.h>

static thud_geometry instance(const struct solid *s) {
    return api_placed(api_to_int(s->kind), s->half_extents[0], s->half_extents[1], s->angle);
}

/* Slots in: minkowski_pair. Slots out: minkowski_sum. */
int api_minkowski_sum(void) {
    const struct minkowski_pair *pair = &api_slots.minkowski_pair;
    double distance = 0.0, nx = 0.0, ny = 0.0, x = pair->offset[0], y = pair->offset[1];
    thud_geometry a = instance(&pair->a), b = instance(&pair->b);
    thud_minkowski sum;
    bool overlaps = false;
    thud_result result = thud_minkowski_sum(&a, &b, &sum);
    if (result == THUD_OK)
        result = thud_minkowski_contains(&sum, x, y, &overlaps);
    if (result == THUD_OK)
        result = thud_minkowski_distance(&sum, x, y, &distance, &nx, &ny);
    if (result != THUD_OK)
        return result;
    struct minkowski_sum *s = &api_slots.minkowski_sum;
    s->overlaps = overlaps;
    s->edge[0] = x - nx * distance;
    s->edge[1] = y - ny * distance;
    s->radius = sum.radius;
    s->count = sum.count;
    for (int i = 0; i < sum.count; i++) {
        s->vertices[2 * i] = sum.vertices[i].x;
        s->vertices[2 * i + 1] = sum.vertices[i].y;
    }
    return THUD_OK;
}
