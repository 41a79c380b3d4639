/* api_minkowski.c: the export that computes the Minkowski sum of shape a and the reflected shape b,
 * and where the centre of b lies relative to the sum: whether in it or on its edge, where the
 * shapes overlap, and the nearest point of its edge. From the vertices and the radius minkowski.ts
 * computes the outline of the sum for drawing. */
#include "api.h"

#include <thud/thud_minkowski.h>

/* The shape with its centre at the origin; a sum does not depend on the places of its shapes. */
static thud_geometry geometry_of(const struct solid *shape) {
    return api_placed(api_to_int(shape->kind), shape->half_extents[0], shape->half_extents[1],
                      shape->angle);
}

/* Slots in: minkowski_pair. Slots out: minkowski_sum; after an error they are as they were. */
int api_minkowski_sum(void) {
    const struct minkowski_pair *pair = &api_slots.minkowski_pair;
    double distance = 0.0, nx = 0.0, ny = 0.0, x = pair->offset[0], y = pair->offset[1];
    thud_geometry a = geometry_of(&pair->a), b = geometry_of(&pair->b);
    thud_minkowski sum;
    bool overlaps = false;
    thud_result result = thud_minkowski_sum(&a, &b, &sum);
    if (result == THUD_OK)
        result = thud_minkowski_contains(&sum, x, y, &overlaps);
    if (result == THUD_OK)
        result = thud_minkowski_distance(&sum, x, y, &distance, &nx, &ny);
    if (result != THUD_OK)
        return result;
    struct minkowski_sum *out = &api_slots.minkowski_sum;
    out->overlaps = overlaps;
    /* The distance is negative inside, and the normal (nx, ny) points out of the sum. */
    out->edge[0] = x - nx * distance;
    out->edge[1] = y - ny * distance;
    out->radius = sum.radius;
    out->count = sum.count;
    for (int i = 0; i < sum.count; i++) {
        out->vertices[2 * i] = sum.vertices[i].x;
        out->vertices[2 * i + 1] = sum.vertices[i].y;
    }
    return THUD_OK;
}
