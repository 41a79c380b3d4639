/* api_minkowski.c: Minkowski sums of two shapes; what is drawn of one, JavaScript works out. */
#include "api.h"

#include <thud/thud_minkowski.h>

/* Slots in: 0 kind  1, 2 half extents  3 angle of a, 4 to 7 the same of b, 8, 9 from a's centre to
 * b's. Slots out: 0 whether they share a point  1, 2 the nearest place on the edge of the sum
 * 3 radius of its rounding  4 count of its vertices  5... they, two numbers each, relative to a's
 * centre. */
int api_minkowski_sum(void) {
    double *s = api_slots, distance = 0.0, nx = 0.0, ny = 0.0, x = s[8], y = s[9];
    thud_shape_instance a = api_placed(api_to_int(s[0]), s[1], s[2], s[3]);
    thud_shape_instance b = api_placed(api_to_int(s[4]), s[5], s[6], s[7]);
    thud_minkowski sum;
    bool overlaps = false;
    thud_result result = thud_minkowski_sum(&a, &b, &sum);
    if (result == THUD_OK)
        result = thud_minkowski_contains(&sum, x, y, &overlaps);
    if (result == THUD_OK)
        result = thud_minkowski_distance(&sum, x, y, &distance, &nx, &ny);
    if (result != THUD_OK)
        return result;
    s[0] = overlaps;
    s[1] = x - nx * distance;
    s[2] = y - ny * distance;
    s[3] = sum.radius;
    s[4] = sum.count;
    for (int i = 0; i < sum.count; i++) {
        s[5 + 2 * i] = sum.vertices[i].x;
        s[6 + 2 * i] = sum.vertices[i].y;
    }
    return THUD_OK;
}
