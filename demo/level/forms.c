/* forms.c: reads the outlines of objects as forms, moves them as their objects are rotated, flipped
 * and scaled, and adds bodies with their shapes to the scene. */
#include "reader.h"

#include <thud/thud_limits.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Radians per degree. */
static const double RADIANS = 0.017453292519943295;

/* Min and max of the half extents that are read, and max of a shape's offset from its body, in
 * length scales: within the engine's (THUD_SIZE_MIN, THUD_SIZE_MAX), with a margin for rounding to
 * float. */
static const double SMALLEST = 2e-4;
static const double LARGEST = 16000;

/* Equal to a relative tolerance of 1e-3, since the editor rounds what it writes. */
static bool nearly_equal(double a, double b) {
    return fabs(a - b) <= 1e-3 * fmax(fabs(a), fabs(b));
}

void level_forms_free(level_forms *forms) {
    for (int i = 0; i < forms->count; i++)
        free(forms->items[i].points);
    free(forms->items);
    *forms = (level_forms){0};
}

level_form *level_forms_add(level_forms *forms, level_form_kind kind, level_form *spare) {
    level_form *form = spare;
    level_form *grown = realloc(forms->items, (size_t)(forms->count + 1) * sizeof *grown);
    if (grown) {
        forms->items = grown;
        form = &grown[forms->count++];
    } else {
        forms->failed = true;
    }
    *form = (level_form){.kind = kind};
    return form;
}

bool level_form_points(level_forms *forms, level_form *form, int count) {
    form->points = malloc((size_t)count * sizeof *form->points);
    form->count = form->points ? count : 0;
    forms->failed = forms->failed || !form->points;
    return form->points != NULL;
}

/* ---- reading ---- */

/* Reads the points of a line or polygon into memory from malloc. Null after a report, or if memory
 * runs out. */
static scene_point *read_points(level_values *v, const cJSON *list, int count, level_forms *forms) {
    scene_point *points = malloc((size_t)count * sizeof *points);
    forms->failed = forms->failed || !points;
    int i = 0;
    const cJSON *item;
    cJSON_ArrayForEach(item, list) {
        double x = level_required(v, item, "x", -LEVEL_FAR, LEVEL_FAR);
        double y = level_required(v, item, "y", -LEVEL_FAR, LEVEL_FAR);
        if (!points || v->bad)
            break;
        points[i++] = (scene_point){x, y};
    }
    if (i == count)
        return points;
    free(points);
    return NULL;
}

/* Reads the points of a line, or of a polygon if `closed`. False after a report. */
static bool read_line(level_values *v, const cJSON *list, bool closed, level_forms *forms) {
    int count = cJSON_IsArray(list) ? cJSON_GetArraySize(list) : 0, least = closed ? 3 : 2;
    if (count < least) {
        level_complain(v, LEVEL_SKIP, "a %s needs %s points at least", closed ? "polygon" : "line",
                       closed ? "three" : "two");
        return false;
    }
    scene_point *points = read_points(v, list, count, forms);
    if (!points)
        return false;
    if (closed) {
        level_read_polygon(points, count, forms);
    } else {
        level_form spare, *form = level_forms_add(forms, LEVEL_LINE, &spare);
        if (form != &spare && level_form_points(forms, form, count))
            memcpy(form->points, points, (size_t)count * sizeof *points);
    }
    free(points);
    return true;
}

bool level_read_forms(level_values *v, const cJSON *object, level_forms *forms) {
    if (level_field(object, "polyline"))
        return read_line(v, level_field(object, "polyline"), false, forms);
    if (level_field(object, "polygon"))
        return read_line(v, level_field(object, "polygon"), true, forms);
    double width = level_optional(v, object, "width", 0, 0, LEVEL_FAR);
    double height = level_optional(v, object, "height", 0, 0, LEVEL_FAR);
    if (v->bad)
        return false;
    bool round = cJSON_IsTrue(level_field(object, "ellipse"));
    if (round && !nearly_equal(width, height)) {
        level_complain(v, LEVEL_SKIP,
                       "an ellipse of unequal axes, %g by %g, cannot be modelled; only circles",
                       width, height);
        return false;
    }
    level_form spare, *form = level_forms_add(forms, round ? LEVEL_CIRCLE : LEVEL_BOX, &spare);
    form->x = form->hx = width * 0.5;
    form->y = form->hy = height * 0.5;
    return true;
}

/* ---- moving ---- */

void level_form_turn(level_form *form, double x, double y, double degrees) {
    double c, s;
    level_turn(degrees, &c, &s);
    double fx = form->x, fy = form->y;
    form->x = x + (c * fx - s * fy);
    form->y = y + (s * fx + c * fy);
    if (form->points) {
        for (int i = 0; i < form->count; i++) {
            scene_point p = form->points[i];
            form->points[i] = (scene_point){c * p.x - s * p.y, s * p.x + c * p.y};
        }
    } else {
        form->rotation = level_turn(form->rotation + degrees, &c, &s);
    }
}

/* Changes the sign of a form's rotation. */
static void mirror(level_form *form) {
    double c, s;
    form->rotation = level_turn(0.0 - form->rotation, &c, &s);
}

static void swap(double *a, double *b) {
    double kept = *a;
    *a = *b;
    *b = kept;
}

void level_form_flip(level_form *form, uint32_t gid, double *width, double *height) {
    if (gid & LEVEL_FLIP_TURN) {
        swap(&form->x, &form->y);
        swap(&form->hx, &form->hy);
        swap(width, height);
        mirror(form);
        for (int i = 0; i < form->count; i++)
            swap(&form->points[i].x, &form->points[i].y);
    }
    if (gid & LEVEL_FLIP_X) {
        form->x = *width - form->x;
        mirror(form);
        for (int i = 0; i < form->count; i++)
            form->points[i].x = 0.0 - form->points[i].x;
    }
    if (gid & LEVEL_FLIP_Y) {
        form->y = *height - form->y;
        mirror(form);
        for (int i = 0; i < form->count; i++)
            form->points[i].y = 0.0 - form->points[i].y;
    }
}

bool level_form_scale(const level_values *v, level_form *form, double sx, double sy) {
    bool across = form->rotation == 90 || form->rotation == -90;
    bool along = form->rotation == 0 || form->rotation == -180;
    bool evenly = nearly_equal(sx, sy);
    if (!form->points && !evenly && (form->kind == LEVEL_CIRCLE || !(along || across))) {
        level_complain(v, LEVEL_SKIP,
                       "a tile drawn %g times as wide and %g times as high turns its %s", sx, sy,
                       form->kind == LEVEL_CIRCLE ? "circle into an ellipse" : "box askew");
        return false;
    }
    form->x *= sx;
    form->y *= sy;
    form->hx *= across ? sy : sx;
    form->hy *= form->kind == LEVEL_CIRCLE || across ? sx : sy;
    for (int i = 0; i < form->count; i++) {
        form->points[i].x *= sx;
        form->points[i].y *= sy;
    }
    return true;
}

/* ---- limits of the engine ---- */

bool level_place_fits(const level_reader *r, double x, double y) {
    return fabs(x) <= THUD_PLACE_MAX * r->unit && fabs(y) <= THUD_PLACE_MAX * r->unit;
}

/* Whether the size of a box or circle, and its offset from its body, are in the engine's range.
 * False after a report. */
static bool size_fits(const level_reader *r, const level_values *v, const level_form *form) {
    double hx = form->hx / r->pixels_per_unit, hy = form->hy / r->pixels_per_unit;
    double x = form->x / r->pixels_per_unit, y = form->y / r->pixels_per_unit;
    double low = SMALLEST * r->unit, high = LARGEST * r->unit;
    bool fits = hx >= low && hy >= low && hx <= high && hy <= high;
    if (!fits)
        level_complain(v, LEVEL_SKIP, "its size, %g by %g units, is out of range", 2 * hx, 2 * hy);
    else if (fabs(x) > high || fabs(y) > high)
        level_complain(v, LEVEL_SKIP, "a shape is further from its body than 16000 length scales");
    else
        return true;
    return false;
}

/* Whether the vertices of a line are in the engine's range. False after a report. */
static bool vertices_fit(const level_reader *r, const level_values *v, const level_form *form) {
    for (int i = 0; i < form->count; i++) {
        double x = form->points[i].x / r->pixels_per_unit;
        double y = form->points[i].y / r->pixels_per_unit;
        if (fabs(x) <= THUD_TERRAIN_PLACE_MAX && fabs(y) <= THUD_TERRAIN_PLACE_MAX)
            continue;
        level_complain(v, LEVEL_SKIP,
                       "its line is too long: no vertex may be further from its object's place "
                       "than 1e9 units");
        return false;
    }
    return true;
}

/* Reverses a line that runs from right to left. False, after a report, if its x do not increase
 * strictly. */
static bool line_fits(const level_reader *r, const level_values *v, level_form *form) {
    scene_point *points = form->points;
    int count = form->count;
    if (points[count - 1].x < points[0].x) {
        for (int a = 0, b = count - 1; a < b; a++, b--) {
            scene_point kept = points[a];
            points[a] = points[b];
            points[b] = kept;
        }
    }
    for (int i = 1; i < count; i++) {
        if (!(points[i].x / r->pixels_per_unit > points[i - 1].x / r->pixels_per_unit)) {
            level_complain(v, LEVEL_SKIP,
                           "its line turns back: terrain must go on from left to right "
                           "(vertices %d and %d of %d, from the left)",
                           i, i + 1, count);
            return false;
        }
    }
    return true;
}

/* Whether the ground line that a polygon has become reaches down to `lowest` with all of its lower
 * side, whose highest point is `foot`. y points down. */
static bool reaches_down(const level_form *form, double lowest) {
    return form->y + form->foot >= lowest;
}

/* Whether a polygon has to be approximated: its properties say so, and it is no ground. */
static bool is_approximated(const level_physics *physics, level_forms *forms, int index,
                            double degrees, double lowest) {
    level_form copy = forms->items[index];
    if (copy.kind != LEVEL_POLYGON || copy.physics.approximate == 0)
        return false;
    if (!level_form_points(forms, &copy, copy.count))
        return false;
    memcpy(copy.points, forms->items[index].points, (size_t)copy.count * sizeof *copy.points);
    level_form_turn(&copy, 0, 0, degrees);
    bool ground =
        physics->kind == SCENE_STATIC && level_form_to_ground(&copy) && reaches_down(&copy, lowest);
    free(copy.points);
    return !ground;
}

/* The smallest half extent that the engine takes, pixels. */
static double smallest(const level_reader *r) {
    return SMALLEST * r->unit * r->pixels_per_unit;
}

/* Prepares one form, see level_forms_settle. False if the form has to be removed. */
static bool settle(const level_reader *r, const level_values *v, const level_physics *physics,
                   level_form *form, double degrees, double lowest) {
    if (!form->points)
        return size_fits(r, v, form);
    level_form_turn(form, 0, 0, degrees);
    if (form->kind == LEVEL_POLYGON && !level_form_to_ground(form)) {
        level_complain(v, LEVEL_SKIP,
                       "a polygon that neither boxes make up nor a ground line cannot be modelled; "
                       "with the property 'approximate' shapes cover it");
        return false;
    }
    if (form->ground && !reaches_down(form, lowest)) {
        level_complain(v, LEVEL_SKIP,
                       "a polygon is ground only if it reaches down to the map's lower edge: all "
                       "below a line is solid; with the property 'approximate' shapes cover it");
        return false;
    }
    if (physics->kind != SCENE_STATIC) {
        level_complain(v, LEVEL_SKIP, "a line is terrain, which is static");
        return false;
    }
    return vertices_fit(r, v, form) && line_fits(r, v, form);
}

void level_forms_settle(const level_reader *r, const level_values *v, const level_physics *physics,
                        level_forms *forms, double degrees, double lowest) {
    int kept = 0, count = forms->count;
    for (int i = 0; i < count; i++) {
        bool approximated = is_approximated(physics, forms, i, degrees, lowest);
        if (approximated)
            level_approximate(v, forms, i, smallest(r));
        if (!approximated && settle(r, v, physics, &forms->items[i], degrees, lowest))
            forms->items[kept++] = forms->items[i];
        else
            free(forms->items[i].points);
    }
    for (int i = count; i < forms->count; i++)
        if (size_fits(r, v, &forms->items[i]))
            forms->items[kept++] = forms->items[i];
    forms->count = kept;
}

/* ---- adding ---- */

/* Adds a body without shapes at (x, y) pixels. `rotation` is in degrees, clockwise. */
static scene_body *add_body(level_reader *r, const level_physics *physics, uint32_t id, double x,
                            double y, double rotation) {
    scene_body *body = scene_add_body(r->s, physics->kind, x / r->pixels_per_unit,
                                      (r->map_height - y) / r->pixels_per_unit);
    body->angle = 0.0 - rotation * RADIANS;
    body->id = id;
    level_apply_body(physics, body);
    if (id != 0)
        level_place_body(r, id, rotation);
    return body;
}

/* Whether a body at (x, y) pixels may have a form. If it may, the form is counted. */
static level_added admit(level_reader *r, const level_form *form, double x, double y) {
    double parts = 1.0 + form->count;
    if (!level_place_fits(r, x / r->pixels_per_unit, (r->map_height - y) / r->pixels_per_unit))
        return LEVEL_LEFT_FAR;
    if (parts > r->parts)
        return LEVEL_LEFT_MANY;
    r->parts -= parts;
    return LEVEL_ADDED;
}

/* Adds the body of a line; (x, y) is the place of the object's body. */
static void add_line(level_reader *r, const level_physics *physics, uint32_t id,
                     const level_form *form, double x, double y) {
    double ppu = r->pixels_per_unit;
    scene_point *points = malloc((size_t)form->count * sizeof *points);
    if (!points) {
        r->s->failed = true;
        return;
    }
    for (int i = 0; i < form->count; i++)
        points[i] = (scene_point){form->points[i].x / ppu, 0.0 - form->points[i].y / ppu};
    add_body(r, physics, id, x + form->x, y + form->y, 0);
    level_apply_shape(&form->physics, scene_add_irregular(r->s, points, form->count));
    free(points);
}

/* Adds a box or circle to the latest body. A box that can never rotate becomes an AABB. */
static void add_box_or_circle(level_reader *r, const level_physics *physics, const level_form *form,
                              double rotation) {
    double ppu = r->pixels_per_unit;
    double hx = form->hx / ppu, hy = form->hy / ppu;
    bool upright = rotation == 0 && form->rotation == 0 &&
                   (physics->kind == SCENE_STATIC || physics->fixed_rotation);
    scene_shape *shape = NULL;
    switch (form->kind) {
    case LEVEL_CIRCLE:
        shape = scene_add_circle(r->s, hx);
        break;
    case LEVEL_BOX:
        shape = upright ? scene_add_aabb(r->s, hx, hy) : scene_add_obb(r->s, hx, hy);
        shape->angle = 0.0 - form->rotation * RADIANS;
        break;
    case LEVEL_LINE: /* both have points: level_add_body adds them as lines */
    case LEVEL_POLYGON:
        return;
    }
    shape->x = form->x / ppu;
    shape->y = 0.0 - form->y / ppu;
    level_apply_shape(&form->physics, shape);
}

level_added level_add_body(level_reader *r, const level_physics *physics, uint32_t id,
                           const level_forms *forms, bool solid_below, double x, double y,
                           double degrees) {
    double c, s, rotation = level_turn(degrees, &c, &s);
    bool any = false;
    level_added all = LEVEL_ADDED;
    for (int i = 0; i < forms->count; i++) {
        const level_form *form = &forms->items[i];
        level_added added = form->points ? LEVEL_ADDED : admit(r, form, x, y);
        all = added == LEVEL_ADDED ? all : added;
        if (form->points || added != LEVEL_ADDED)
            continue;
        if (!any)
            add_body(r, physics, id, x, y, rotation);
        any = true;
        add_box_or_circle(r, physics, form, rotation);
    }
    for (int i = 0; i < forms->count; i++) {
        const level_form *form = &forms->items[i];
        if (!form->points || (form->ground && !solid_below))
            continue;
        level_added added = admit(r, form, x + form->x, y + form->y);
        all = added == LEVEL_ADDED ? all : added;
        if (added == LEVEL_ADDED)
            add_line(r, physics, id, form, x, y);
    }
    return all;
}
