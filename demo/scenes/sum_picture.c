/* sum_picture.c: see sum_picture.h. */
#include "sum_picture.h"

#include <math.h>

static const double TURN = 6.283185307179586;

/* Adds points on a circle about a vertex, from one angle to another, in `lines` equal parts. */
static void add_arc(sum_picture *out, thud_pos center, double radius, double from, double to,
                    int lines) {
    for (int i = 0; i <= lines; i++) {
        double angle = from + (to - from) * i / (lines > 0 ? lines : 1);
        out->outline[out->count++] =
            (thud_pos){center.x + radius * cos(angle), center.y + radius * sin(angle)};
    }
}

/* The angle of the outward normal of the face that begins at a vertex. The sum lists the normals of
 * one half of the faces; those of the other half are opposite. */
static double direction_of(const thud_minkowski *sum, int face) {
    int half = sum->count / 2;
    double sign = face < half ? 1 : -1;
    thud_pos normal = sum->normals[face % half];
    return atan2(sign * normal.y, sign * normal.x);
}

/* Adds the outline: at each vertex an arc between the normals of its two faces. */
static void outline(const thud_minkowski *sum, sum_picture *out) {
    out->count = 0;
    if (sum->count == 1)
        add_arc(out, sum->vertices[0], sum->radius, 0, TURN, SUM_OUTLINE_MAX - 1);
    for (int i = 0; i < sum->count && sum->count > 1; i++) {
        double from = direction_of(sum, (i + sum->count - 1) % sum->count);
        double to = direction_of(sum, i);
        add_arc(out, sum->vertices[i], sum->radius, from, to < from ? to + TURN : to,
                sum->radius > 0 ? SUM_ARC : 0);
    }
}

bool sum_picture_of(const thud_geometry *a, const thud_geometry *b, sum_picture *out) {
    thud_minkowski sum;
    double distance, nx, ny, x = b->x - a->x, y = b->y - a->y;
    if (thud_minkowski_sum(a, b, &sum) != THUD_OK ||
        thud_minkowski_contains(&sum, x, y, &out->overlaps) != THUD_OK ||
        thud_minkowski_distance(&sum, x, y, &distance, &nx, &ny) != THUD_OK)
        return false;
    out->edge = (thud_pos){x - nx * distance, y - ny * distance};
    outline(&sum, out);
    return true;
}
