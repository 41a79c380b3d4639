/* api_approximate.c: the export that approximates a polygon by circles and boxes. */
#include "api.h"

#include <thud/thud_approximate.h>

/* The shapes that were found last. */
static struct placed shapes[THUD_APPROXIMATE_SHAPES_MAX];

/* `most`: the greatest count of shapes; `kinds`: a thud_approximate_kind; `distance`: the error
 * that is good enough, a length. Slots out: approximation; where the points are no polygon, only
 * its `reason`. */
int api_approximate(const thud_pos *points, int count, double most, int kinds, double distance) {
    thud_geometry found[THUD_APPROXIMATE_SHAPES_MAX];
    thud_approximation errors;
    thud_approximate_options options = {.shapes_max = api_to_int(most),
                                        .kinds = (thud_approximate_kind)kinds,
                                        .distance = distance};
    const char *reason = NULL;
    thud_result result = thud_polygon_check(points, count, &reason);
    if (result == THUD_OK)
        result = thud_approximate(points, count, &options, found, &errors);
    api_slots.approximation.reason = (double)(uintptr_t)reason;
    if (result != THUD_OK)
        return result;
    for (int i = 0; i < errors.count; i++) {
        const thud_geometry *one = &found[i];
        double angle = 0.0;
        thud_angle_of(one->s, one->c, &angle);
        shapes[i] = (struct placed){{one->kind, {one->hx, one->hy}, angle}, {one->x, one->y}};
    }
    api_slots.approximation = (struct approximation){
        .shapes = {(double)(uintptr_t)shapes, errors.count},
        .missed = errors.missed,
        .extra = errors.extra,
        .overlap = errors.overlap,
        .distance = errors.distance,
    };
    return THUD_OK;
}
