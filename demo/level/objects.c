/* objects.c: reads an object layer; adds one body with one shape for each object. */
#include "reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Pixels beyond which a map is absurd, and the same for degrees. */
static const double FAR = 1e9;
static const double DEGREES = 1e6;

/* Sizes, in length scales, between which the engine takes them with room to spare for rounding. */
static const double SMALLEST = 2e-4;
static const double LARGEST = 16000;

typedef struct placement {
    double x, y, width, height; /* as in the file, but with the layer's offset */
    double c, s, rotation;      /* rotation in [-180, 180) */
} placement;

static double field_or(level_values *v, const cJSON *json, const char *name, double fallback,
                       double low, double high) {
    return level_field(json, name) ? level_required(v, json, name, low, high) : fallback;
}

static placement read_placement(level_values *v, const level_layer *layer, const cJSON *object) {
    placement p;
    p.x = layer->ox + level_required(v, object, "x", -FAR, FAR);
    p.y = layer->oy + level_required(v, object, "y", -FAR, FAR);
    p.width = field_or(v, object, "width", 0, 0, FAR);
    p.height = field_or(v, object, "height", 0, 0, FAR);
    p.rotation = level_turn(field_or(v, object, "rotation", 0, -DEGREES, DEGREES), &p.c, &p.s);
    return p;
}

/* The class of an object: `type`, but `class` in files of Tiled 1.9. */
static const char *class_of(const cJSON *object) {
    const cJSON *type = level_field(object, "type");
    if (!type)
        type = level_field(object, "class");
    return cJSON_IsString(type) ? type->valuestring : "";
}

static bool size_in_range(const level_reader *r, level_values *v, double hx, double hy) {
    double low = SMALLEST * r->s->length_scale, high = LARGEST * r->s->length_scale;
    if (hx >= low && hy >= low && hx <= high && hy <= high)
        return true;
    level_problem_add(r->report, LEVEL_SKIP, v->object, "its size, %g by %g units, is out of range",
                      2 * hx, 2 * hy);
    return false;
}

static void add_box_or_circle(level_reader *r, level_values *v, const placement *p, bool circle) {
    double hw = p->width * 0.5, hh = p->height * 0.5;
    double dx = p->c * hw - p->s * hh;
    double dy = p->s * hw + p->c * hh;
    double hx = hw / r->pixels_per_unit, hy = hh / r->pixels_per_unit;
    level_physics physics = level_read_physics(v);
    if (v->bad || !size_in_range(r, v, hx, hy))
        return;
    scene_body *body = scene_add_body(r->s, physics.kind, (p->x + dx) / r->pixels_per_unit,
                                      (r->map_height - (p->y + dy)) / r->pixels_per_unit);
    body->angle = 0.0 - p->rotation * 0.017453292519943295;
    body->id = v->object;
    bool upright = p->rotation == 0 && (physics.kind == SCENE_STATIC || physics.fixed_rotation);
    scene_shape *shape = circle    ? scene_add_circle(r->s, hx)
                         : upright ? scene_add_aabb(r->s, hx, hy)
                                   : scene_add_obb(r->s, hx, hy);
    level_apply_physics(&physics, body, shape);
}

/* Two axes count as equal within a thousandth: the editor rounds what it writes. */
static void add_ellipse(level_reader *r, level_values *v, const placement *p) {
    double larger = p->width > p->height ? p->width : p->height;
    if (fabs(p->width - p->height) > 1e-3 * larger)
        level_problem_add(r->report, LEVEL_SKIP, v->object,
                          "an ellipse of unequal axes, %g by %g, cannot be modelled; only circles",
                          p->width, p->height);
    else
        add_box_or_circle(r, v, p, true);
}

/* Reads the points, from left to right; false after a report. */
static bool read_polyline(level_reader *r, level_values *v, const placement *p, const cJSON *line,
                          scene_point *points, int count) {
    int i = 0;
    const cJSON *item;
    cJSON_ArrayForEach(item, line) {
        double x = level_required(v, item, "x", -FAR, FAR);
        double y = level_required(v, item, "y", -FAR, FAR);
        if (v->bad)
            return false;
        points[i++] = (scene_point){(p->c * x - p->s * y) / r->pixels_per_unit,
                                    0.0 - (p->s * x + p->c * y) / r->pixels_per_unit};
    }
    if (points[count - 1].x < points[0].x) {
        for (int a = 0, b = count - 1; a < b; a++, b--) {
            scene_point swap = points[a];
            points[a] = points[b];
            points[b] = swap;
        }
    }
    for (i = 1; i < count; i++) {
        if (!(points[i].x > points[i - 1].x)) {
            level_problem_add(r->report, LEVEL_SKIP, v->object,
                              "its line turns back: terrain must go on from left to right "
                              "(vertices %d and %d of %d, from the left)",
                              i, i + 1, count);
            return false;
        }
    }
    return true;
}

static void add_terrain(level_reader *r, level_values *v, const placement *p, const cJSON *line) {
    int count = cJSON_IsArray(line) ? cJSON_GetArraySize(line) : 0;
    if (count < 2) {
        level_problem_add(r->report, LEVEL_SKIP, v->object, "a line needs two points at least");
        return;
    }
    level_physics physics = level_read_physics(v);
    if (!v->bad && physics.kind != SCENE_STATIC) {
        level_problem_add(r->report, LEVEL_SKIP, v->object, "a line is terrain, which is static");
        return;
    }
    scene_point *points = malloc((size_t)count * sizeof *points);
    if (!points) {
        r->s->failed = true;
        return;
    }
    if (!v->bad && read_polyline(r, v, p, line, points, count)) {
        scene_body *body = scene_add_body(r->s, SCENE_STATIC, p->x / r->pixels_per_unit,
                                          (r->map_height - p->y) / r->pixels_per_unit);
        body->id = v->object;
        level_apply_physics(&physics, body, scene_add_irregular(r->s, points, count));
    }
    free(points);
}

static void read_point(level_reader *r, level_values *v, const placement *p, const cJSON *object) {
    if (strcmp(class_of(object), "spawn") == 0) {
        r->s->spawn_x = p->x / r->pixels_per_unit;
        r->s->spawn_y = (r->map_height - p->y) / r->pixels_per_unit;
    } else {
        level_problem_add(r->report, LEVEL_NOTE, v->object,
                          "a point has no meaning here, unless its class is 'spawn'");
    }
}

/* What an object is that no shape of the engine can be; null if it is nothing of the kind. */
static const char *unsupported(const cJSON *object) {
    return level_field(object, "template")  ? "an object from a template"
           : level_field(object, "gid")     ? "a tile object"
           : level_field(object, "text")    ? "a text"
           : level_field(object, "polygon") ? "a polygon"
           : level_field(object, "capsule") ? "a capsule"
                                            : NULL;
}

static void read_object(level_reader *r, const level_layer *layer, const cJSON *object) {
    const cJSON *id = level_field(object, "id");
    if (!cJSON_IsNumber(id) || !(id->valuedouble >= 1 && id->valuedouble <= UINT32_MAX)) {
        level_problem_add(r->report, LEVEL_SKIP, 0, "layer '%.40s': an object has no valid id",
                          layer->name);
        return;
    }
    level_chain chain = layer->chain;
    chain.links[chain.count++] = object;
    level_values v = {.report = r->report, .chain = &chain, .object = (uint32_t)id->valuedouble};
    level_note_unknown(r->report, object, v.object, "");
    const char *what = unsupported(object);
    if (what) {
        level_problem_add(r->report, LEVEL_SKIP, v.object, "%s cannot be modelled", what);
        return;
    }
    placement p = read_placement(&v, layer, object);
    if (v.bad)
        return;
    if (cJSON_IsTrue(level_field(object, "point")))
        read_point(r, &v, &p, object);
    else if (level_field(object, "polyline"))
        add_terrain(r, &v, &p, level_field(object, "polyline"));
    else if (cJSON_IsTrue(level_field(object, "ellipse")))
        add_ellipse(r, &v, &p);
    else
        add_box_or_circle(r, &v, &p, false);
}

void level_read_objects(level_reader *r, const level_layer *layer) {
    const cJSON *objects = level_field(layer->json, "objects");
    if (!cJSON_IsArray(objects)) {
        level_problem_add(r->report, LEVEL_SKIP, 0, "layer '%.40s': has no list of objects",
                          layer->name);
        return;
    }
    const cJSON *object;
    cJSON_ArrayForEach(object, objects) read_object(r, layer, object);
}
