/* cover_lines.c: areas of a polygon and shapes, along horizontal lines; see cover.h.
 *
 * The intersection of a line with a polygon or a convex shape consists of intervals, whose lengths
 * are exact, so that only the vertical direction is sampled. Strips begin and end at the polygon's
 * horizontal edges, where the length of the intersection jumps. */
#include "geometry/cover.h"

/* Insertion sort: there are few numbers, and most are already in order. */
static void sort(double *values, int count) {
    for (int i = 1; i < count; i++) {
        double value = values[i];
        int j = i;
        for (; j > 0 && values[j - 1] > value; j--) {
            values[j] = values[j - 1];
        }
        values[j] = value;
    }
}

static void sort_intervals(td_interval *list, int count) {
    for (int i = 1; i < count; i++) {
        td_interval one = list[i];
        int j = i;
        for (; j > 0 && list[j - 1].from > one.from; j--) {
            list[j] = list[j - 1];
        }
        list[j] = one;
    }
}

/* The intervals of the horizontal line at y inside the polygon; a corner on the line counts as
 * above it. */
static int cut_polygon(const thud_pos *points, int count, double y, td_interval *out) {
    double *crossings = &out[0].from; /* the intervals as an array of numbers, which is sorted */
    int crossed = 0;
    for (int i = 0; i < count; i++) {
        thud_pos p = points[i], q = points[i + 1 < count ? i + 1 : 0];
        if ((p.y < y) != (q.y < y)) {
            crossings[crossed++] = p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y));
        }
    }
    sort(crossings, crossed);
    return crossed / 2;
}

/* The lowest and the highest y of a shape. */
static td_interval height_of(const thud_geometry *shape) {
    double half = td_half_along(shape, 0.0, 1.0);
    return (td_interval){shape->y - half, shape->y + half};
}

/* The interval of the horizontal line at y inside a shape; y is between the shape's lowest and
 * highest y. */
static td_interval cut_shape(const thud_geometry *shape, double y) {
    double v = y - shape->y;
    if (td_kind_is_round(shape->kind)) {
        double half = __builtin_sqrt(td_max_double(shape->hx * shape->hx - v * v, 0.0));
        return (td_interval){shape->x - half, shape->x + half};
    }
    /* Solves |c x + s v| <= hx and |c v - s x| <= hy for x, relative to the shape's centre. Sides
     * that are nearly horizontal do not bound x. */
    double c = shape->c, s = shape->s, from = -4.0, to = 4.0;
    if (td_abs(c) > 1e-9) {
        double a = (-shape->hx - s * v) / c, b = (shape->hx - s * v) / c;
        from = td_max_double(from, a < b ? a : b);
        to = td_min_double(to, a < b ? b : a);
    }
    if (td_abs(s) > 1e-9) {
        double a = (c * v - shape->hy) / s, b = (c * v + shape->hy) / s;
        from = td_max_double(from, a < b ? a : b);
        to = td_min_double(to, a < b ? b : a);
    }
    return (td_interval){shape->x + from, shape->x + td_max_double(from, to)};
}

/* ---- lines for comparing shapes ---- */

int td_cover_lines(const thud_pos *points, int count, double *ys, td_cover_line *lines) {
    double low = points[0].y, high = low;
    int bounds = 0;
    for (int i = 0; i < count; i++) {
        thud_pos p = points[i], q = points[i + 1 < count ? i + 1 : 0];
        low = td_min_double(low, p.y);
        high = td_max_double(high, p.y);
        if (td_abs(q.y - p.y) < 1e-9) {
            ys[bounds++] = p.y;
        }
    }
    ys[bounds++] = low;
    ys[bounds++] = high;
    sort(ys, bounds);
    double height_max = (high - low) / TD_COVER_LINES;
    int made = 0;
    for (int i = 0; i + 1 < bounds; i++) {
        double height = ys[i + 1] - ys[i];
        int strips = height > 1e-9 ? (int)(height / height_max + 0.999) : 0;
        for (int k = 0; k < strips; k++) {
            td_cover_line *line = &lines[made++];
            line->y0 = ys[i] + height * k / strips;
            line->y1 = ys[i] + height * (k + 1) / strips;
            line->open_count = cut_polygon(points, count, 0.5 * (line->y0 + line->y1), line->open);
            line->taken_count = 0;
        }
    }
    return made;
}

/* Strips for the part of a shape that extends above or below all lines. Chosen. */
enum { STRIPS_BEYOND = 6 };

/* The length of the intersection of an interval and a list of intervals. */
static double common(const td_interval *list, int count, td_interval with) {
    double sum = 0.0;
    for (int i = 0; i < count && list[i].from < with.to; i++) {
        double from = td_max_double(list[i].from, with.from),
               to = td_min_double(list[i].to, with.to);
        sum += to > from ? to - from : 0.0;
    }
    return sum;
}

/* The height of the part of the strip over which the shape extends, and the interval in its
 * middle. */
static double cut_strip(const td_cover_line *line, const thud_geometry *shape, td_interval height,
                        td_interval *out) {
    double y0 = td_max_double(line->y0, height.from), y1 = td_min_double(line->y1, height.to);
    if (!(y1 > y0)) {
        return 0.0;
    }
    *out = cut_shape(shape, 0.5 * (y0 + y1));
    return y1 - y0;
}

/* The area of the part of a shape between two heights outside of all lines. */
static double area_between(const thud_geometry *shape, double y0, double y1) {
    double sum = 0.0;
    for (int i = 0; i < STRIPS_BEYOND && y1 > y0; i++) {
        td_interval at = cut_shape(shape, y0 + (y1 - y0) * (i + 0.5) / STRIPS_BEYOND);
        sum += (at.to - at.from) * (y1 - y0) / STRIPS_BEYOND;
    }
    return sum;
}

td_cover_gain td_cover_gain_of(const td_cover_line *lines, int count, const thud_geometry *shape) {
    td_cover_gain gain = {0.0, 0.0, 0.0};
    td_interval height = height_of(shape), at;
    gain.outside = area_between(shape, height.from, td_min_double(height.to, lines[0].y0)) +
                   area_between(shape, td_max_double(height.from, lines[count - 1].y1), height.to);
    for (int i = 0; i < count && lines[i].y0 < height.to; i++) {
        double part = cut_strip(&lines[i], shape, height, &at);
        if (part > 0.0) {
            double inside = common(lines[i].open, lines[i].open_count, at);
            double again = common(lines[i].taken, lines[i].taken_count, at);
            gain.inside += part * inside;
            gain.again += part * again;
            gain.outside += part * td_max_double(at.to - at.from - inside - again, 0.0);
        }
    }
    return gain;
}

/* Subtracts an interval from a list, which has room for one more. Returns the new count. */
static int take_away(td_interval *list, int count, td_interval gone) {
    td_interval rest = {0.0, 0.0};
    int kept = 0;
    bool split = false;
    for (int i = 0; i < count; i++) {
        td_interval one = list[i];
        if (one.to <= gone.from || one.from >= gone.to) {
            list[kept++] = one;
            continue;
        }
        if (one.from < gone.from && one.to > gone.to) {
            split = true;
            rest = (td_interval){gone.to, one.to};
        }
        if (one.from < gone.from) {
            list[kept++] = (td_interval){one.from, gone.from};
        } else if (one.to > gone.to) {
            list[kept++] = (td_interval){gone.to, one.to};
        }
    }
    if (split) {
        list[kept++] = rest;
        sort_intervals(list, kept);
    }
    return kept;
}

/* Joins the intervals of a list that overlap. Returns the new count. */
static int join(td_interval *list, int count) {
    sort_intervals(list, count);
    int kept = 0;
    for (int i = 0; i < count; i++) {
        if (kept > 0 && list[i].from <= list[kept - 1].to) {
            list[kept - 1].to = td_max_double(list[kept - 1].to, list[i].to);
        } else {
            list[kept++] = list[i];
        }
    }
    return kept;
}

void td_cover_add(td_cover_line *lines, int count, const thud_geometry *shape) {
    td_interval height = height_of(shape), at;
    for (int i = 0; i < count; i++) {
        td_cover_line *line = &lines[i];
        if (cut_strip(line, shape, height, &at) > 0.5 * (line->y1 - line->y0)) {
            line->open_count = take_away(line->open, line->open_count, at);
            line->taken[line->taken_count++] = at;
            line->taken_count = join(line->taken, line->taken_count);
        }
    }
}

/* ---- areas ---- */

/* Minimum number of strips over the whole height. Chosen: areas are then exact to about 1e-4. */
enum { STRIPS = 256 };

/* Half the distance between the two points of Gauss quadrature, in a strip of height 1: 1 /
 * sqrt(12). */
static const double GAUSS = 0.28867513459481287;

/* Adds the lengths on the line at `y`, times `weight`, the height for which the line stands, to the
 * areas. */
static void measure_line(const thud_pos *points, int count, const thud_geometry *shapes,
                         int shape_count, double y, double weight, td_interval *intervals,
                         td_cover_areas *sum) {
    int in = cut_polygon(points, count, y, intervals), taken = 0;
    td_interval *list = intervals + count;
    for (int i = 0; i < shape_count; i++) {
        td_interval height = height_of(&shapes[i]);
        if (y > height.from && y < height.to) {
            list[taken++] = cut_shape(&shapes[i], y);
        }
    }
    taken = join(list, taken);
    double polygon = 0.0, covered = 0.0, both = 0.0;
    for (int i = 0; i < in; i++) {
        polygon += intervals[i].to - intervals[i].from;
        both += common(list, taken, intervals[i]);
    }
    for (int i = 0; i < taken; i++) {
        covered += list[i].to - list[i].from;
    }
    sum->missed += weight * td_max_double(polygon - both, 0.0);
    sum->extra += weight * td_max_double(covered - both, 0.0);
    sum->covered += weight * covered;
}

td_cover_areas td_cover_measure(const thud_pos *points, int count, const thud_geometry *shapes,
                                int shape_count, double *ys, td_interval *intervals) {
    int corners = 0;
    for (int i = 0; i < count; i++) {
        ys[corners++] = points[i].y;
    }
    for (int i = 0; i < shape_count; i++) {
        if (td_kind_is_round(shapes[i].kind)) {
            ys[corners++] = shapes[i].y - shapes[i].hx;
            ys[corners++] = shapes[i].y + shapes[i].hx;
            continue;
        }
        for (int k = 0; k < 4; k++) {
            double x;
            td_corner(&shapes[i], k, &x, &ys[corners++]);
        }
    }
    sort(ys, corners);
    double height_max = (ys[corners - 1] - ys[0]) / STRIPS;
    td_cover_areas sum = {0.0, 0.0, 0.0};
    for (int i = 0; i + 1 < corners; i++) {
        double gap = ys[i + 1] - ys[i];
        int strips = td_max_int((int)(gap / height_max + 0.999), 1);
        for (int k = 0; k < strips && gap > 1e-13; k++) {
            double height = gap / strips, middle = ys[i] + (k + 0.5) * height;
            measure_line(points, count, shapes, shape_count, middle - GAUSS * height, 0.5 * height,
                         intervals, &sum);
            measure_line(points, count, shapes, shape_count, middle + GAUSS * height, 0.5 * height,
                         intervals, &sum);
        }
    }
    return sum;
}
