/* polygon.c: polygons for which the engine has shapes: those that boxes make up, and ground, which
 * becomes a terrain line; and polygons that shapes approximate. */
#include "reader.h"

#include <thud/thud_approximate.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Max corners of a polygon that is cut into boxes. Chosen: outlines with more corners are something
 * else. */
enum { MOST_CORNERS = 64 };

/* The larger of a polygon's width and height. */
static double extent(const scene_point *p, int count) {
    double x0 = p[0].x, x1 = x0, y0 = p[0].y, y1 = y0;
    for (int i = 1; i < count; i++) {
        x0 = fmin(x0, p[i].x);
        x1 = fmax(x1, p[i].x);
        y0 = fmin(y0, p[i].y);
        y1 = fmax(y1, p[i].y);
    }
    return fmax(x1 - x0, y1 - y0);
}

/* Computed by an iteration, since the atan2 of different languages may differ in the last bits.
 * From the nearest quarter turn, each step adds the sine of the remaining angle e, which leaves e^3
 * / 6. */
double level_direction(double x, double y) {
    double length = sqrt(x * x + y * y), c, s;
    double degrees = fabs(x) >= fabs(y) ? (x > 0 ? 0 : 180) : y > 0 ? 90 : -90;
    for (int i = 0; i < 6; i++) {
        level_turn(degrees, &c, &s);
        degrees += (c * y - s * x) / length / 0.017453292519943295;
    }
    return level_turn(degrees, &c, &s);
}

/* Reads a polygon of four corners with right angles as a box, in any rotation. False if it is none.
 */
static bool read_turned_box(const scene_point *p, int count, double near, level_forms *forms) {
    if (count != 4)
        return false;
    double ax = p[1].x - p[0].x, ay = p[1].y - p[0].y;
    double bx = p[2].x - p[1].x, by = p[2].y - p[1].y;
    double a = sqrt(ax * ax + ay * ay), b = sqrt(bx * bx + by * by);
    bool closes = fabs(p[0].x + bx - p[3].x) <= near && fabs(p[0].y + by - p[3].y) <= near;
    if (!closes || a <= near || b <= near || fabs(ax * bx + ay * by) > 1e-3 * (a * b))
        return false;
    level_form spare, *form = level_forms_add(forms, LEVEL_BOX, &spare);
    form->x = (p[0].x + p[2].x) * 0.5;
    form->y = (p[0].y + p[2].y) * 0.5;
    form->hx = a * 0.5;
    form->hy = b * 0.5;
    form->rotation = level_direction(ax, ay);
    return true;
}

/* Sorts numbers and removes those at most `near` above the one before. Returns how many are left.
 */
static int sort(double *values, int count, double near) {
    for (int i = 1; i < count; i++) {
        double value = values[i];
        int j = i;
        for (; j > 0 && values[j - 1] > value; j--)
            values[j] = values[j - 1];
        values[j] = value;
    }
    int kept = 0;
    for (int i = 0; i < count; i++)
        if (kept == 0 || values[i] - values[kept - 1] > near)
            values[kept++] = values[i];
    return kept;
}

/* Adds a box, or extends the box of equal width directly above it. */
static void add_slab(level_forms *forms, int first, double x0, double x1, double y0, double y1,
                     double near) {
    double x = (x0 + x1) * 0.5, hx = (x1 - x0) * 0.5;
    for (int i = first; i < forms->count; i++) {
        level_form *above = &forms->items[i];
        double top = above->y - above->hy;
        if (fabs(above->x - x) <= near && fabs(above->hx - hx) <= near &&
            fabs(above->y + above->hy - y0) <= near) {
            above->y = (top + y1) * 0.5;
            above->hy = (y1 - top) * 0.5;
            return;
        }
    }
    level_form spare, *form = level_forms_add(forms, LEVEL_BOX, &spare);
    form->x = x;
    form->hx = hx;
    form->y = (y0 + y1) * 0.5;
    form->hy = (y1 - y0) * 0.5;
}

/* Reads a polygon of horizontal and vertical edges as boxes: it is cut at the height of each corner
 * into slabs, and equal slabs that lie on top of each other are merged. False if it is none. */
static bool read_upright_boxes(const scene_point *p, int count, double near, level_forms *forms) {
    if (count > MOST_CORNERS)
        return false;
    double heights[MOST_CORNERS], walls[MOST_CORNERS];
    for (int i = 0; i < count; i++) {
        const scene_point *q = &p[(i + 1) % count];
        if (fabs(q->x - p[i].x) > near && fabs(q->y - p[i].y) > near)
            return false;
        heights[i] = p[i].y;
    }
    int first = forms->count, levels = sort(heights, count, near);
    for (int k = 0; k + 1 < levels; k++) {
        double middle = (heights[k] + heights[k + 1]) * 0.5;
        int crossed = 0;
        for (int i = 0; i < count; i++) {
            const scene_point *q = &p[(i + 1) % count];
            if ((p[i].y < middle) != (q->y < middle))
                walls[crossed++] = p[i].x;
        }
        sort(walls, crossed, -1);
        for (int i = 0; i + 1 < crossed; i += 2)
            if (walls[i + 1] - walls[i] > near)
                add_slab(forms, first, walls[i], walls[i + 1], heights[k], heights[k + 1], near);
    }
    return forms->count > first;
}

void level_read_polygon(const scene_point *points, int count, level_forms *forms) {
    double near = 1e-3 * extent(points, count);
    if (read_upright_boxes(points, count, near, forms) ||
        read_turned_box(points, count, near, forms))
        return;
    level_form spare, *form = level_forms_add(forms, LEVEL_POLYGON, &spare);
    if (form != &spare && level_form_points(forms, form, count))
        memcpy(form->points, points, (size_t)count * sizeof *points);
}

/* ---- ground ---- */

/* The direction of an edge: 1 to the right, -1 to the left, 0 vertical within `near`. */
static int way(const scene_point *p, int count, int edge, double near) {
    double dx = p[(edge + 1) % count].x - p[edge % count].x;
    return dx > near ? 1 : dx < -near ? -1 : 0;
}

/* The number of consecutive edges from `edge` on that have this direction. */
static int run_of(const scene_point *p, int count, int edge, int which, double near) {
    int length = 0;
    while (length < count && way(p, count, edge + length, near) == which)
        length++;
    return length;
}

static void reverse(scene_point *p, int count) {
    for (int a = 0, b = count - 1; a < b; a++, b--) {
        scene_point kept = p[a];
        p[a] = p[b];
        p[b] = kept;
    }
}

/* Seen once around, the polygon has to consist of an upper side of edges to the right, a vertical
 * wall or none, a lower side of edges to the left, and a vertical wall or none. */
bool level_form_to_ground(level_form *form) {
    scene_point *p = form->points;
    int count = form->count;
    double near = 1e-3 * extent(p, count), area = 0;
    for (int i = 0; i < count; i++) {
        const scene_point *q = &p[(i + 1) % count];
        area += p[i].x * q->y - q->x * p[i].y;
    }
    if (area < 0)
        reverse(p, count);
    int first = 0;
    while (first < count &&
           !(way(p, count, first, near) == 1 && way(p, count, first + count - 1, near) != 1))
        first++;
    int upper = run_of(p, count, first, 1, near);
    int right = run_of(p, count, first + upper, 0, near);
    int lower = run_of(p, count, first + upper + right, -1, near);
    int left = run_of(p, count, first + upper + right + lower, 0, near);
    scene_point *line =
        first < count && upper < count ? malloc((size_t)(upper + 1) * sizeof *line) : NULL;
    if (!line || lower == 0 || upper + right + lower + left != count) {
        free(line);
        return false;
    }
    form->foot = p[(first + upper + right) % count].y;
    for (int i = 0; i <= lower; i++)
        form->foot = fmin(form->foot, p[(first + upper + right + i) % count].y);
    for (int i = 0; i <= upper; i++)
        line[i] = p[(first + i) % count];
    free(p);
    form->kind = LEVEL_LINE;
    form->ground = true;
    form->points = line;
    form->count = upper + 1;
    return true;
}

/* ---- polygons that are approximated ---- */

/* The count of points is not bounded here: thud_polygon_check refuses too many. */
static thud_result approximate(const level_form *form, thud_geometry *shapes,
                               thud_approximation *found, const char **reason) {
    thud_pos *points = malloc((size_t)form->count * sizeof *points);
    for (int i = 0; points && i < form->count; i++)
        points[i] = (thud_pos){form->points[i].x, form->points[i].y};
    thud_approximate_options options = {.shapes_max = form->physics.approximate};
    thud_result result =
        points ? thud_polygon_check(points, form->count, reason) : THUD_ERROR_MEMORY;
    if (result == THUD_OK)
        result = thud_approximate(points, form->count, &options, shapes, found);
    free(points);
    return result;
}

/* The shapes overlap, so that the density is reduced to give them the polygon's mass. */
void level_approximate(const level_values *v, level_forms *forms, int index, double smallest) {
    const level_form polygon = forms->items[index];
    thud_geometry shapes[THUD_APPROXIMATE_SHAPES_MAX];
    thud_approximation found;
    const char *reason = "";
    thud_result result = approximate(&polygon, shapes, &found, &reason);
    if (result != THUD_OK) {
        forms->failed = forms->failed || result == THUD_ERROR_MEMORY;
        level_complain(v, LEVEL_SKIP, "%s, so that it cannot be approximated", reason);
        return;
    }
    int kept = 0;
    for (int i = 0; i < found.count; i++) {
        const thud_geometry *shape = &shapes[i];
        bool round = shape->kind == THUD_SHAPE_CIRCLE;
        double hy = round ? shape->hx : shape->hy, angle = 0, c, s;
        if (shape->hx < smallest || hy < smallest)
            continue;
        kept++;
        thud_angle_of(shape->s, shape->c, &angle);
        level_form spare, *form = level_forms_add(forms, round ? LEVEL_CIRCLE : LEVEL_BOX, &spare);
        form->x = polygon.x + shape->x;
        form->y = polygon.y + shape->y;
        form->hx = shape->hx;
        form->hy = hy;
        form->rotation = level_turn(angle / 0.017453292519943295, &c, &s);
        form->physics = polygon.physics;
        form->physics.material.density /= 1 + found.overlap + found.extra - found.missed;
    }
    if (kept == 0)
        level_complain(v, LEVEL_SKIP, "its polygon is smaller than any shape");
    else
        level_complain(v, LEVEL_NOTE, "its polygon is approximated by %d shapes", kept);
}
