/* level.c: reads a Tiled map: its own values, its groups and layers. */
#include "level.h"

#include "reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void read_layers(level_reader *r, const level_layer *parent);

/* Reads a layer, or a group with the layers in it. */
static void read_layer(level_reader *r, const level_layer *parent, const cJSON *json) {
    const cJSON *name = level_field(json, "name");
    const cJSON *type = level_field(json, "type");
    level_layer layer = {.json = json, .chain = parent->chain};
    layer.name = cJSON_IsString(name) ? name->valuestring : "unnamed";
    const char *kind = cJSON_IsString(type) ? type->valuestring : "";
    if (strcmp(kind, "imagelayer") == 0)
        return;
    if (layer.chain.count > LEVEL_DEEPEST) {
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': too deep inside groups", layer.name);
        return;
    }
    layer.chain.links[layer.chain.count++] = json;
    level_values v = {.report = r->report, .chain = &layer.chain, .where = layer.name};
    const double far = 1e9; /* pixels, as LEVEL_FAR */
    if (level_field(json, "offsetx"))
        layer.ox = level_required(&v, json, "offsetx", -far, far);
    if (level_field(json, "offsety"))
        layer.oy = level_required(&v, json, "offsety", -far, far);
    layer.ox = parent->ox + layer.ox;
    layer.oy = parent->oy + layer.oy;
    level_note_unknown(r->report, json, 0, layer.name, LEVEL_ANY_JOINT);
    if (v.bad)
        return;
    if (strcmp(kind, "objectgroup") == 0)
        level_read_objects(r, &layer);
    else if (strcmp(kind, "tilelayer") == 0)
        level_read_tiles(r, &layer);
    else if (strcmp(kind, "group") == 0)
        read_layers(r, &layer);
    else
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': its type '%.20s' is not known", layer.name, kind);
}

static void read_layers(level_reader *r, const level_layer *parent) {
    const cJSON *layers = level_field(parent->json, "layers");
    if (!cJSON_IsArray(layers)) {
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT, "'%.40s' has no list of layers",
                          parent->name);
        return;
    }
    const cJSON *json;
    cJSON_ArrayForEach(json, layers)
        read_layer(r, parent, json);
}

/* Sets the name, title and description of a scene. They are copied into memory of the scene, since
 * the JSON that they are in is freed. */
static void set_texts(scene *s, const char *name, const char *title, const char *about) {
    const char *texts[] = {name, title, about};
    const char **fields[] = {&s->name, &s->title, &s->about};
    size_t total = 0;
    for (int i = 0; i < 3; i++)
        total += strlen(texts[i]) + 1;
    char *at = s->owned_text = malloc(total);
    if (!at) {
        s->failed = true;
        return;
    }
    for (int i = 0; i < 3; i++) {
        size_t size = strlen(texts[i]) + 1;
        memcpy(at, texts[i], size);
        *fields[i] = at;
        at += size;
    }
}

/* The greatest power of two that is not above x > 0. */
static double power_below(double x) {
    double power = 1;
    while (power > x)
        power *= 0.5;
    while (power * 2 <= x)
        power *= 2;
    return power;
}

/* Reads the map's own values. False if one is wrong, which is fatal, as every object depends on
 * them. */
static bool read_map_values(level_reader *r, const level_layer *map, const char *name) {
    scene *s = r->s;
    level_values v = {.report = r->report, .chain = &map->chain, .where = "map"};
    double columns = level_required(&v, map->json, "width", 1, 1e6);
    double rows = level_required(&v, map->json, "height", 1, 1e6);
    r->tile_width = level_required(&v, map->json, "tilewidth", 1e-3, 1e6);
    r->tile_height = level_required(&v, map->json, "tileheight", 1e-3, 1e6);
    r->map_height = rows * r->tile_height;
    r->pixels_per_unit = level_number(&v, "pixels_per_unit", r->tile_width, 1e-3, 1e6);
    s->length_scale = level_number(&v, "length_scale", 1, 1e-3, 1e3);
    r->unit = power_below((float)s->length_scale);
    s->gravity_x = level_number(&v, "gravity_x", 0, -1e6, 1e6);
    s->gravity_y = level_number(&v, "gravity_y", -10, -1e6, 1e6);
    double width = columns * r->tile_width / r->pixels_per_unit;
    double height = r->map_height / r->pixels_per_unit;
    s->camera_x = level_number(&v, "camera_x", 0.5 * width, -1e9, 1e9);
    s->camera_y = level_number(&v, "camera_y", 0.5 * height, -1e9, 1e9);
    s->camera_height = level_number(&v, "camera_height", height, 1e-3, 1e9);
    s->character = level_flag(&v, "character", false);
    s->spawn_x = s->camera_x;
    s->spawn_y = s->camera_y;
    const char *title = level_text(&v, "title", name);
    const char *about = level_text(&v, "about", "");
    if (v.bad)
        return false;
    set_texts(s, name, title, about);
    return true;
}

/* Reads the map's values, then its layers; joins bodies by the joints at the end. Errors are
 * reported. */
static void read_map(level_reader *r, const cJSON *json, const char *name) {
    const cJSON *type = level_field(json, "type");
    const cJSON *orientation = level_field(json, "orientation");
    if (!cJSON_IsString(type) || strcmp(type->valuestring, "map") != 0) {
        level_problem_add(r->report, LEVEL_FATAL, LEVEL_NO_OBJECT,
                          "this is not a Tiled map: no \"type\": \"map\"");
        return;
    }
    if (cJSON_IsString(orientation) && strcmp(orientation->valuestring, "orthogonal") != 0) {
        level_problem_add(r->report, LEVEL_FATAL, LEVEL_NO_OBJECT,
                          "the map is %.20s; only orthogonal maps are read",
                          orientation->valuestring);
        return;
    }
    level_layer map = {.json = json, .name = "map", .chain = {.links = {json}, .count = 1}};
    r->s->failed = !level_list_tilesets(&r->tilesets, level_field(json, "tilesets"), "");
    level_note_unknown(r->report, json, 0, "map", LEVEL_ANY_JOINT);
    if (!read_map_values(r, &map, name)) {
        level_problem_add(r->report, LEVEL_FATAL, LEVEL_NO_OBJECT,
                          "the map's own values cannot be used");
        return;
    }
    read_layers(r, &map);
    level_tie_joints(r);
}

/* Max number of cells that are read of a map, over all its layers. Chosen: 4096 by 4096; their
 * numbers take 64 MiB, and as much again while they are unpacked. */
static const double MOST_CELLS = 1 << 24;

/* Reads the map into an empty scene. True if nothing in it collides, but it has tiles that would if
 * all tiles did. */
static bool read_once(level_library *library, const cJSON *json, const char *name, bool all_solid,
                      scene *s, level_report *report) {
    scene_init(s);
    level_reader reader = {.s = s,
                           .report = report,
                           .library = library,
                           .cells = MOST_CELLS,
                           .parts = LEVEL_PARTS,
                           .all_solid = all_solid};
    read_map(&reader, json, name);
    free(reader.tilesets.items);
    free(reader.placed);
    free(reader.joints);
    return s->body_count == 0 && reader.unmarked > 0 && report->fatal == 0 && !s->failed;
}

/* Reads the map; if nothing in it collides, reads it again with all tiles solid. */
static void read_document(level_library *library, const cJSON *json, const char *name, scene *s,
                          level_report *report) {
    if (!read_once(library, json, name, false, s, report))
        return;
    scene_free(s);
    level_report_free(report);
    level_library_forget_reports(library);
    level_problem_add(report, LEVEL_NOTE, LEVEL_NO_OBJECT,
                      "nothing in this map says what collides, so every tile does: 'solid' says it "
                      "for a layer, a tileset, a tile or a tile object");
    read_once(library, json, name, true, s, report);
}

bool level_read_with(const char *name, const char *text, size_t length, const level_opener *opener,
                     bool skip_unsupported, scene *s, level_report *report) {
    scene_init(s);
    *report = (level_report){0};
    char trouble[120];
    cJSON *json = level_document(text, length, trouble, sizeof trouble);
    level_library *library = level_library_create(opener);
    if (!json)
        level_problem_add(report, LEVEL_FATAL, LEVEL_NO_OBJECT, "%s", trouble);
    else if (library)
        read_document(library, json, name, s, report);
    if (s->failed || !library)
        level_problem_add(report, LEVEL_FATAL, LEVEL_NO_OBJECT, "out of memory");
    cJSON_Delete(json);
    level_library_free(library);
    if (report->fatal > 0 || (report->skipped > 0 && !skip_unsupported)) {
        scene_free(s);
        return false;
    }
    return true;
}

bool level_read(const char *name, const char *text, size_t length, bool skip_unsupported, scene *s,
                level_report *report) {
    return level_read_with(name, text, length, NULL, skip_unsupported, s, report);
}
