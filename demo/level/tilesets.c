/* tilesets.c: finds the tile of a tile number, and reads the shapes that the tile collides with. */
#include "reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool level_list_tilesets(level_tilesets *tilesets, const cJSON *list, const char *path) {
    *tilesets = (level_tilesets){0};
    int count = cJSON_IsArray(list) ? cJSON_GetArraySize(list) : 0;
    if (count == 0)
        return true;
    tilesets->items = calloc((size_t)count, sizeof *tilesets->items);
    if (!tilesets->items)
        return false;
    const cJSON *json;
    cJSON_ArrayForEach(json, list) {
        const cJSON *first = level_field(json, "firstgid");
        if (!cJSON_IsNumber(first) || !(first->valuedouble >= 1))
            continue;
        tilesets->items[tilesets->count++] =
            (level_tileset){.first = floor(first->valuedouble), .json = json, .path = path};
    }
    return true;
}

/* The tileset's own JSON, from its file if it is in one. Null after a report. */
static const cJSON *content_of(const level_reader *r, const level_tileset *tileset) {
    const cJSON *source = level_field(tileset->json, "source");
    const char *path;
    if (!source)
        return tileset->json;
    return level_library_open(r->library, r->report, tileset->path,
                              cJSON_IsString(source) ? source->valuestring : "", "tileset", &path);
}

/* The entry of a tile in its tileset, or null: only tiles with properties, shapes or an image of
 * their own have one. */
static const cJSON *entry_of(const cJSON *tileset, double number) {
    const cJSON *tile;
    cJSON_ArrayForEach(tile, level_field(tileset, "tiles")) {
        const cJSON *id = level_field(tile, "id");
        if (cJSON_IsNumber(id) && id->valuedouble == number)
            return tile;
    }
    return NULL;
}

/* A length in pixels, from 1e-3 to 1e6; 0 if it is missing or out of range. */
static double length_of(const cJSON *json, const char *name) {
    const cJSON *value = level_field(json, name);
    bool good = cJSON_IsNumber(value) && value->valuedouble >= 1e-3 && value->valuedouble <= 1e6;
    return good ? value->valuedouble : 0;
}

/* The width or height of a tile: of the part of an image that it shows, of an image of its own, or
 * of the tileset's tiles, in this order. 0 if none is given. */
static double side_of(const level_tile *tile, const char *part, const char *picture,
                      const char *piece) {
    double length = length_of(tile->json, part);
    if (length == 0)
        length = length_of(tile->json, picture);
    if (length == 0)
        length = length_of(level_field(tile->json, "image"), part);
    return length == 0 ? length_of(tile->tileset, piece) : length;
}

/* A coordinate of the tileset's drawing offset, pixels; 0 if it has none. */
static double shift_of(const cJSON *tileset, const char *axis) {
    const cJSON *value = level_field(level_field(tileset, "tileoffset"), axis);
    bool good = cJSON_IsNumber(value) && fabs(value->valuedouble) <= 1e6;
    return good ? value->valuedouble : 0;
}

level_tile level_find_tile(const level_reader *r, const level_tilesets *tilesets, uint32_t gid) {
    level_tile tile = {0};
    const level_tileset *best = NULL;
    uint32_t number = gid & LEVEL_NUMBER;
    for (int i = 0; i < tilesets->count; i++) {
        const level_tileset *one = &tilesets->items[i];
        if (one->first <= number && (!best || one->first > best->first))
            best = one;
    }
    if (!best)
        return tile;
    tile.tileset = content_of(r, best);
    tile.json = entry_of(tile.tileset, number - best->first);
    tile.width = side_of(&tile, "width", "imagewidth", "tilewidth");
    tile.height = side_of(&tile, "height", "imageheight", "tileheight");
    tile.offset_x = shift_of(tile.tileset, "x");
    tile.offset_y = shift_of(tile.tileset, "y");
    const char *anchor = level_field_text(tile.tileset, "objectalignment", "bottomleft");
    tile.anchor_x = strstr(anchor, "left") ? 0 : strstr(anchor, "right") ? 1 : 0.5;
    tile.anchor_y = strstr(anchor, "top") ? 0 : strstr(anchor, "bottom") ? 1 : 0.5;
    if (strcmp(anchor, "unspecified") == 0) {
        tile.anchor_x = 0;
        tile.anchor_y = 1;
    }
    tile.fills_cell = strcmp(level_field_text(tile.tileset, "tilerendersize", ""), "grid") == 0;
    tile.keeps_aspect =
        strcmp(level_field_text(tile.tileset, "fillmode", ""), "preserve-aspect-fit") == 0;
    if (tile.tileset && (tile.width == 0 || tile.height == 0)) {
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "tileset '%.40s': tile %g has no size",
                          level_field_text(tile.tileset, "name", ""), number - best->first);
        tile.tileset = NULL;
    }
    return tile;
}

/* ---- collision shapes ---- */

/* What an object in the collision editor is, if that cannot be a collision shape; else null. */
static const char *no_shape(const cJSON *object) {
    return level_field(object, "gid")        ? "a tile"
           : level_field(object, "template") ? "an object from a template"
           : level_field(object, "text")     ? "a text"
           : level_field(object, "capsule")  ? "a capsule"
           : level_field(object, "point")    ? "a point"
                                             : NULL;
}

/* Adds the forms of one collision shape, flipped and scaled as the tile is. */
static void read_shape(level_values *v, const cJSON *object, uint32_t gid, const level_tile *tile,
                       double width, double height, level_forms *forms) {
    const char *what = no_shape(object);
    if (what) {
        level_complain(v, LEVEL_SKIP, "%s is no collision shape that can be modelled", what);
        return;
    }
    double x = level_required(v, object, "x", -LEVEL_FAR, LEVEL_FAR);
    double y = level_required(v, object, "y", -LEVEL_FAR, LEVEL_FAR);
    double degrees = level_optional(v, object, "rotation", 0, -LEVEL_DEGREES, LEVEL_DEGREES);
    level_physics physics = level_read_physics(v);
    int first = forms->count, kept = first;
    if (v->bad || !level_read_forms(v, object, forms))
        return;
    for (int i = first; i < forms->count; i++) {
        level_form *form = &forms->items[i];
        double w = tile->width, h = tile->height;
        level_form_turn(form, x, y, degrees);
        level_form_flip(form, gid, &w, &h);
        if (!level_form_scale(v, form, width / w, height / h)) {
            free(form->points);
            continue;
        }
        form->x = form->x - width * 0.5;
        form->y = form->y - height * 0.5;
        form->physics = physics;
        forms->items[kept++] = *form;
    }
    forms->count = kept;
}

/* The chain (JSON objects in which properties are looked up, the last first) with a collision shape
 * of a tile inserted at index `at`. So a property of the shape overrides the same property of its
 * tile, and one of a tile object, which comes after it, overrides both. */
static level_chain insert(const level_chain *chain, int at, const cJSON *json) {
    level_chain longer = *chain;
    for (int i = longer.count++; i > at; i--)
        longer.links[i] = longer.links[i - 1];
    longer.links[at] = json;
    return longer;
}

/* The property that says whether a tile is solid: that of the tile object, else of the layer, the
 * tile, the tileset. Null if none has it. */
static const cJSON *solid_of(const level_chain *chain, const level_tile *tile, int outer) {
    const cJSON *solid = NULL;
    for (int i = chain->count - 1; i >= outer && !solid; i--)
        solid = level_own_property(chain->links[i], "solid");
    int layer = outer - (tile->json ? 3 : 2);
    if (!solid)
        solid = level_own_property(chain->links[layer], "solid");
    if (!solid)
        solid = level_own_property(tile->json, "solid");
    return solid ? solid : level_own_property(tile->tileset, "solid");
}

level_solid level_read_tile_forms(level_reader *r, const level_values *v, const level_tile *tile,
                                  uint32_t gid, double width, double height, int outer,
                                  level_physics *physics, level_forms *forms) {
    int solid = level_flag_of(solid_of(v->chain, tile, outer));
    if (solid == 0)
        return LEVEL_OPEN;
    bool is_object = v->chain->count > outer;
    bool has_body =
        level_property(v->chain, "body") != NULL || level_property(v->chain, "bodyType") != NULL;
    const cJSON *object, *objects = level_field(level_field(tile->json, "objectgroup"), "objects");
    bool has_shapes = cJSON_IsArray(objects) && objects->child;
    if (!has_shapes && solid < 0 && !(is_object && has_body) && !r->all_solid)
        return LEVEL_UNMARKED;
    level_values whole = *v;
    *physics = level_read_physics(&whole);
    if (whole.bad)
        return LEVEL_SOLID;
    if (has_shapes) {
        cJSON_ArrayForEach(object, objects) {
            level_chain chain = insert(v->chain, outer, object);
            level_values own = *v;
            own.chain = &chain;
            read_shape(&own, object, gid, tile, width, height, forms);
        }
        return LEVEL_SOLID;
    }
    level_form spare, *form = level_forms_add(forms, LEVEL_BOX, &spare);
    form->hx = width * 0.5;
    form->hy = height * 0.5;
    form->physics = *physics;
    return LEVEL_SOLID;
}
