/* submerged.c: area and centroid of the part of a circle or box below a line, in closed form; and
 * thud_geometry_area_below. */
#include "fields/submerged.h"

#include "base/trig.h"

/* The angle in [0, pi] with this cosine and this sine; the sine must be >= 0. Starts from a
 * rational approximation with an error of at most 0.08 rad, and iterates
 * angle += sin(true - angle). An error e becomes e
 * - sin e, about e^3 / 6: 1e-4, then 1e-13, then the error of td_sincos. */
static double angle_of(double cosine, double sine) {
    double part = 0.5 * TD_PI * sine / (td_abs(cosine) + sine);
    double angle = cosine < 0.0 ? TD_PI - part : part;
    for (int i = 0; i < 3; i++) {
        double s, c;
        td_sincos(angle, &s, &c);
        angle += sine * c - cosine * s;
    }
    return angle;
}

/* The part of a circle whose centre is at `height` above the line: a circular segment, of area
 * r^2 angle - height * half, where `half` is half the chord, with its centroid 2/3 half^3 / area
 * below the centre. */
static td_submerged_part part_of_circle(const thud_geometry *circle, double height, thud_pos up) {
    double r = circle->hx;
    td_submerged_part part = {0.0, circle->x, circle->y};
    if (height >= r) {
        return part;
    }
    if (height <= -r) {
        part.area = TD_PI * r * r;
        return part;
    }
    double half = __builtin_sqrt((r - height) * (r + height)); /* half the chord */
    part.area = td_max_double(r * r * angle_of(height / r, half / r) - height * half, 0.0);
    double moment = 2.0 / 3.0 * half * half * half;
    double depth = moment < r * part.area ? td_max_double(moment / part.area, height) : r;
    part.x -= depth * up.x;
    part.y -= depth * up.y;
    return part;
}

/* The part of a box: cuts the box at the line (Sutherland and Hodgman's clipping), to at most five
 * corners, and sums over the triangles from the first corner. */
static td_submerged_part part_of_box(const thud_geometry *box, double height, thud_pos up) {
    thud_geometry own = *box;
    thud_pos corner[4], left[5];
    double above[4];
    int count = 0;
    own.x = own.y = 0.0;
    for (int i = 0; i < 4; i++) {
        td_corner(&own, i, &corner[i].x, &corner[i].y);
        above[i] = height + up.x * corner[i].x + up.y * corner[i].y;
    }
    for (int i = 0; i < 4; i++) {
        int j = (i + 1) % 4;
        if (above[i] <= 0.0 && count < 5) {
            left[count++] = corner[i];
        }
        if ((above[i] < 0.0 && above[j] > 0.0) || (above[i] > 0.0 && above[j] < 0.0)) {
            double t = above[i] / (above[i] - above[j]);
            if (count < 5) {
                left[count++] = (thud_pos){corner[i].x + t * (corner[j].x - corner[i].x),
                                           corner[i].y + t * (corner[j].y - corner[i].y)};
            }
        }
    }
    double twice = 0.0, sum_x = 0.0, sum_y = 0.0;
    for (int i = 2; i < count; i++) {
        thud_pos p = {left[i - 1].x - left[0].x, left[i - 1].y - left[0].y};
        thud_pos q = {left[i].x - left[0].x, left[i].y - left[0].y};
        double cross = p.x * q.y - p.y * q.x;
        twice += cross;
        sum_x += cross * (p.x + q.x);
        sum_y += cross * (p.y + q.y);
    }
    if (!(twice > 0.0)) {
        return (td_submerged_part){0.0, box->x, box->y};
    }
    return (td_submerged_part){0.5 * twice, box->x + left[0].x + sum_x / (3.0 * twice),
                               box->y + left[0].y + sum_y / (3.0 * twice)};
}

td_submerged_part td_submerged_part_of(const thud_geometry *shape, double height, thud_pos up) {
    return shape->kind == THUD_SHAPE_CIRCLE ? part_of_circle(shape, height, up)
                                            : part_of_box(shape, height, up);
}

bool td_line_normal(double x, double y, thud_pos *up) {
    double length = __builtin_sqrt(x * x + y * y);
    *up = (thud_pos){x / length, y / length};
    return td_abs(length - 1.0) <= THUD_NORMAL_ERROR;
}

thud_result thud_geometry_area_below(const thud_geometry *shape, thud_half_plane below,
                                     double *out_area, double *out_center_x, double *out_center_y) {
    if (!shape || !out_area || !out_center_x || !out_center_y) {
        return THUD_ERROR_NULL;
    }
    thud_pos up;
    if (thud_geometry_check(shape) != THUD_OK || !td_line_normal(below.nx, below.ny, &up) ||
        !(td_abs(below.x) <= THUD_COORDINATE_MAX && td_abs(below.y) <= THUD_COORDINATE_MAX)) {
        return THUD_ERROR_INVALID;
    }
    td_submerged_part part =
        td_submerged_part_of(shape, up.x * (shape->x - below.x) + up.y * (shape->y - below.y), up);
    *out_area = part.area;
    *out_center_x = part.x;
    *out_center_y = part.y;
    return THUD_OK;
}
