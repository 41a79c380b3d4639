/* objects.c: reads an object layer, and adds a body, a joint or the spawn point for each object. */
#include "reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An object, with the values that it inherits from its template. */
typedef struct thing {
    const cJSON *json; /* its fields, and those of its template that it does not have itself */
    cJSON *merged;     /* the same, owned by this struct, if it has a template; else null */
    const level_tilesets *tiles; /* the tilesets in which its tile number is looked up */
    level_tilesets template_tiles;
} thing;

static void thing_free(thing *o) {
    cJSON_Delete(o->merged);
    free(o->template_tiles.items);
}

/* A copy of the template's object, in which the fields of `object` replace its own. Null if memory
 * runs out. */
static cJSON *merge(const cJSON *template_object, const cJSON *object) {
    cJSON *merged = cJSON_Duplicate(template_object, true);
    const cJSON *field;
    cJSON_ArrayForEach(field, object) {
        cJSON *copy = merged ? cJSON_Duplicate(field, true) : NULL;
        cJSON_DeleteItemFromObjectCaseSensitive(merged, field->string);
        if (!copy || !cJSON_AddItemToObject(merged, field->string, copy)) {
            cJSON_Delete(copy);
            cJSON_Delete(merged);
            return NULL;
        }
    }
    return merged;
}

/* Looks up the template of an object, if it has one. False after a report. */
static bool resolve(level_reader *r, level_values *v, const cJSON *object, level_chain *chain,
                    thing *o) {
    const cJSON *source = level_field(object, "template");
    *o = (thing){.json = object, .tiles = &r->tilesets};
    if (!source)
        return true;
    const char *path;
    const cJSON *file =
        level_library_open(r->library, r->report, "", level_field_text(object, "template", ""),
                           "template", &path);
    const cJSON *template_object = level_field(file, "object");
    if (!file || !cJSON_IsObject(template_object) || level_field(template_object, "template")) {
        level_complain(v, LEVEL_SKIP,
                       file ? "its template has no object of its own"
                            : "its template cannot be used");
        return false;
    }
    chain->links[chain->count - 1] = template_object;
    chain->links[chain->count++] = object;
    o->merged = merge(template_object, object);
    /* A tile number in the template refers to the template's own tileset. */
    cJSON *list = cJSON_CreateArray();
    const cJSON *tileset = level_field(file, "tileset");
    if (list && tileset)
        cJSON_AddItemReferenceToArray(list, (cJSON *)(uintptr_t)tileset);
    bool listed = list && level_list_tilesets(&o->template_tiles, list, path);
    for (int i = 0; listed && i < o->template_tiles.count; i++)
        o->template_tiles.items[i].json = tileset;
    cJSON_Delete(list);
    if (!o->merged || !listed) {
        r->s->failed = true;
        thing_free(o);
        return false;
    }
    o->json = o->merged;
    if (!level_field(object, "gid"))
        o->tiles = &o->template_tiles;
    return true;
}

/* The class of an object: its field `type`, which Tiled 1.9 calls `class`. */
static const char *class_of(const cJSON *object) {
    return level_field_text(object, "type", level_field_text(object, "class", ""));
}

/* Reads a point that is no joint: the spawn point, or nothing. */
static void read_point(level_reader *r, const level_values *v, const cJSON *object, double x,
                       double y) {
    double ux = x / r->pixels_per_unit, uy = (r->map_height - y) / r->pixels_per_unit;
    if (strcmp(class_of(object), "spawn") != 0) {
        level_complain(v, LEVEL_NOTE, "a point has no meaning here, unless its class is 'spawn'");
    } else if (!level_place_fits(r, ux, uy)) {
        level_complain(v, LEVEL_SKIP, "its place is " LEVEL_TOO_FAR);
    } else {
        r->s->spawn_x = ux;
        r->s->spawn_y = uy;
    }
}

/* The depth below `y` to which a polygon has to reach to count as ground, pixels: the top of
 * the map's lowest row of cells. No body can fall through between there and the map's lower edge.
 */
static double lowest_below(const level_reader *r, double y) {
    return r->map_height - r->tile_height - y;
}

/* Adds the bodies of an object's forms, or reports why not. */
static void add_forms(level_reader *r, const level_values *v, const level_physics *physics,
                      const level_forms *forms, double x, double y, double degrees) {
    level_added added = level_add_body(r, physics, v->object, forms, true, x, y, degrees);
    if (added == LEVEL_LEFT_FAR)
        level_complain(v, LEVEL_SKIP, "its place is " LEVEL_TOO_FAR);
    else if (added == LEVEL_LEFT_MANY)
        level_complain(v, LEVEL_SKIP, LEVEL_TOO_MANY);
}

/* Adds the body of a rectangle, ellipse, polygon or line. */
static void add_shape(level_reader *r, level_values *v, const cJSON *object, double x, double y,
                      double degrees) {
    level_forms forms = {0};
    bool read = level_read_forms(v, object, &forms);
    level_physics physics = {0};
    if (read)
        physics = level_read_physics(v);
    if (read && !v->bad) {
        for (int i = 0; i < forms.count; i++)
            forms.items[i].physics = physics;
        bool single = forms.count == 1 && !forms.items[0].points;
        if (single) {
            level_form *form = &forms.items[0];
            level_form_turn(form, x, y, degrees);
            x = form->x;
            y = form->y;
            degrees = form->rotation;
            form->x = form->y = form->rotation = 0;
        }
        level_forms_settle(r, v, &physics, &forms, degrees, lowest_below(r, y));
        add_forms(r, v, &physics, &forms, x, y, degrees);
    }
    r->s->failed = r->s->failed || forms.failed;
    level_forms_free(&forms);
}

/* ---- tile objects ---- */

/* The chain with the tileset and the tile's entry inserted before the last `own` links, those of
 * the tile object. *outer becomes the number of links before these. */
static level_chain chain_of_tile(const level_chain *chain, int own, const level_tile *tile,
                                 int *outer) {
    level_chain longer = *chain;
    int at = chain->count - own, more = tile->json ? 2 : 1;
    for (int i = 0; i < own; i++)
        longer.links[at + more + i] = chain->links[at + i];
    longer.links[at] = tile->tileset;
    if (tile->json)
        longer.links[at + 1] = tile->json;
    longer.count += more;
    *outer = at + more;
    return longer;
}

/* The tile number of a tile object. v->bad is set, after a report, if it is missing or invalid. */
static uint32_t gid_of(level_values *v, const cJSON *object) {
    return (uint32_t)level_required(v, object, "gid", 1, UINT32_MAX);
}

/* The size of a tile object in pixels; `length`, that of its tile, if it has none of its own. */
static double drawn(level_values *v, const cJSON *object, const char *name, double length) {
    double wanted = level_optional(v, object, name, 0, 0, LEVEL_FAR);
    return wanted > 0 ? wanted : length;
}

/* Adds the body of a tile object. */
static level_solid add_tile(level_reader *r, level_values *v, const thing *o, int own, double x,
                            double y, double degrees) {
    uint32_t gid = gid_of(v, o->json);
    level_tile tile = level_find_tile(r, o->tiles, gid);
    if (v->bad || !tile.tileset) {
        if (!v->bad)
            level_complain(v, LEVEL_SKIP, "its tile is of no tileset that can be used");
        return LEVEL_OPEN;
    }
    int outer;
    level_chain chain = chain_of_tile(v->chain, own, &tile, &outer);
    double width = drawn(v, o->json, "width", tile.width);
    double height = drawn(v, o->json, "height", tile.height);
    if (v->bad)
        return LEVEL_OPEN;
    level_values of_tile = *v;
    of_tile.chain = &chain;
    level_forms forms = {0};
    level_physics physics = {0};
    level_solid solid =
        level_read_tile_forms(r, &of_tile, &tile, gid, width, height, outer, &physics, &forms);
    if (forms.count > 0) {
        double c, s;
        level_turn(degrees, &c, &s);
        double dx = (0.5 - tile.anchor_x) * width + tile.offset_x * (width / tile.width);
        double dy = (0.5 - tile.anchor_y) * height + tile.offset_y * (height / tile.height);
        x = x + (c * dx - s * dy);
        y = y + (s * dx + c * dy);
        level_forms_settle(r, &of_tile, &physics, &forms, degrees, lowest_below(r, y));
        add_forms(r, v, &physics, &forms, x, y, degrees);
    }
    r->s->failed = r->s->failed || forms.failed;
    level_forms_free(&forms);
    return solid;
}

/* ---- layers ---- */

/* The kind of joint that an object is. An object with a joint's class that refers to no other
 * object by `a` or `b` is a joint only if it is a point, as shapes may have the class "wheel". */
static int joint_of(const level_values *v, const cJSON *object) {
    int kind = level_joint_kind(class_of(object));
    bool refers = level_property(v->chain, "a") || level_property(v->chain, "b");
    return refers || cJSON_IsTrue(level_field(object, "point")) ? kind : LEVEL_NO_JOINT;
}

/* Reads an object with its template's values. `own` is the number of its links in the chain,
 * `joint` what joint_of returned. */
static level_solid read_thing(level_reader *r, level_values *v, const thing *o,
                              const level_layer *layer, int own, int joint) {
    const char *what = level_field(o->json, "text")      ? "a text"
                       : level_field(o->json, "capsule") ? "a capsule"
                                                         : NULL;
    if (what) {
        level_complain(v, LEVEL_SKIP, "%s cannot be modelled", what);
        return LEVEL_OPEN;
    }
    double x = layer->ox + level_required(v, o->json, "x", -LEVEL_FAR, LEVEL_FAR);
    double y = layer->oy + level_required(v, o->json, "y", -LEVEL_FAR, LEVEL_FAR);
    double degrees = level_optional(v, o->json, "rotation", 0, -LEVEL_DEGREES, LEVEL_DEGREES);
    if (v->bad)
        return LEVEL_OPEN;
    if (joint >= 0) {
        level_read_joint(r, v, o->json, joint, x, y, degrees);
        return LEVEL_OPEN;
    }
    if (level_joint_kind(class_of(o->json)) >= 0)
        level_complain(v, LEVEL_NOTE, "without a or b it is no joint, but what it is drawn as");
    if (level_field(o->json, "gid"))
        return add_tile(r, v, o, own, x, y, degrees);
    if (cJSON_IsTrue(level_field(o->json, "point")))
        read_point(r, v, o->json, x, y);
    else
        add_shape(r, v, o->json, x, y, degrees);
    return LEVEL_OPEN;
}

/* Reads one object of a layer. */
static level_solid read_object(level_reader *r, const level_layer *layer, const cJSON *object) {
    const cJSON *id = level_field(object, "id");
    if (!cJSON_IsNumber(id) || !(id->valuedouble >= 1 && id->valuedouble <= UINT32_MAX)) {
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': an object has no valid id", layer->name);
        return LEVEL_OPEN;
    }
    level_chain chain = layer->chain;
    chain.links[chain.count++] = object;
    level_values v = {.report = r->report, .chain = &chain, .object = (uint32_t)id->valuedouble};
    thing o;
    if (!resolve(r, &v, object, &chain, &o)) {
        level_note_unknown(r->report, object, v.object, "", LEVEL_ANY_JOINT);
        return LEVEL_OPEN;
    }
    int joint = joint_of(&v, o.json);
    level_note_unknown(r->report, object, v.object, "", joint);
    level_solid solid = read_thing(r, &v, &o, layer, chain.count - layer->chain.count, joint);
    thing_free(&o);
    return solid;
}

void level_read_objects(level_reader *r, const level_layer *layer) {
    const cJSON *objects = level_field(layer->json, "objects");
    if (!cJSON_IsArray(objects)) {
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': has no list of objects", layer->name);
        return;
    }
    int unmarked = 0;
    const cJSON *object;
    cJSON_ArrayForEach(object, objects)
        unmarked += read_object(r, layer, object) == LEVEL_UNMARKED;
    r->unmarked += unmarked;
    if (unmarked > 0)
        level_problem_add(r->report, LEVEL_NOTE, LEVEL_NO_OBJECT,
                          "layer '%.40s': of %d tile objects nothing says that they are solid",
                          layer->name, unmarked);
}
