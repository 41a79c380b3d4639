/* tiles.c: reads a tile layer; adds one static AABB for every solid tile.
 *
 * The property `solid` of the layer decides for all its tiles; where it has none, that of the tile
 * decides, then that of its tileset; without any a tile is decoration. */
#include "reader.h"

#include <math.h>

enum { MOST_CELLS = 1 << 26 };

/* The upper bits of a cell tell how the tile is flipped, which a box does not show. */
static const uint32_t GID_BITS = 0x0FFFFFFF;

/* The tileset that a tile number belongs to, or null. */
static const cJSON *tileset_of(const level_reader *r, uint32_t gid, uint32_t *local) {
    const cJSON *best = NULL, *tileset;
    double best_first = 0;
    cJSON_ArrayForEach(tileset, r->tilesets) {
        const cJSON *first = level_field(tileset, "firstgid");
        if (cJSON_IsNumber(first) && first->valuedouble >= 1 && first->valuedouble <= gid &&
            first->valuedouble > best_first) {
            best = tileset;
            best_first = first->valuedouble;
        }
    }
    *local = gid - (uint32_t)best_first;
    return best;
}

/* The entry of a tile in its tileset, which only tiles with something to say have; or null. */
static const cJSON *tile_of(const cJSON *tileset, uint32_t local) {
    const cJSON *tile;
    cJSON_ArrayForEach(tile, level_field(tileset, "tiles")) {
        const cJSON *id = level_field(tile, "id");
        if (cJSON_IsNumber(id) && id->valuedouble == local)
            return tile;
    }
    return NULL;
}

/* What one tile number stands for; looked up again only when the number changes. */
typedef struct tile_kind {
    uint32_t gid;
    bool known, solid, bad;
    level_physics physics;
} tile_kind;

static tile_kind read_kind(level_reader *r, const level_layer *layer, uint32_t gid) {
    tile_kind kind = {.gid = gid};
    uint32_t local;
    const cJSON *tileset = tileset_of(r, gid, &local);
    if (!tileset || level_field(tileset, "source"))
        return kind;
    kind.known = true;
    const cJSON *tile = tile_of(tileset, local);
    const cJSON *solid = level_own_property(layer->json, "solid");
    if (!solid && tile)
        solid = level_own_property(tile, "solid");
    if (!solid)
        solid = level_own_property(tileset, "solid");
    kind.solid = cJSON_IsTrue(solid);
    if (!kind.solid)
        return kind;
    level_chain chain = layer->chain;
    chain.links[chain.count++] = tileset;
    if (tile)
        chain.links[chain.count++] = tile;
    level_values v = {.report = r->report, .chain = &chain, .where = layer->name};
    kind.physics = level_read_physics(&v);
    kind.physics.kind = SCENE_STATIC;
    kind.bad = v.bad;
    const cJSON *width = level_field(tileset, "tilewidth");
    const cJSON *height = level_field(tileset, "tileheight");
    if (!cJSON_IsNumber(width) || !cJSON_IsNumber(height) || width->valuedouble != r->tile_width ||
        height->valuedouble != r->tile_height) {
        level_problem_add(r->report, LEVEL_SKIP, 0,
                          "layer '%.40s': its tiles are not of the size of the map's cells",
                          layer->name);
        kind.bad = true;
    }
    return kind;
}

static void add_tile(level_reader *r, const level_layer *layer, const tile_kind *kind, int column,
                     int row) {
    double ppu = r->pixels_per_unit;
    double x = (layer->ox + (column + 0.5) * r->tile_width) / ppu;
    double y = (r->map_height - (layer->oy + (row + 0.5) * r->tile_height)) / ppu;
    scene_body *body = scene_add_body(r->s, SCENE_STATIC, x, y);
    scene_shape *shape =
        scene_add_aabb(r->s, (r->tile_width * 0.5) / ppu, (r->tile_height * 0.5) / ppu);
    level_apply_physics(&kind->physics, body, shape);
}

/* Adds the tiles; `width` and the length of `data` have been checked. */
static void read_cells(level_reader *r, const level_layer *layer, const cJSON *data, int width) {
    tile_kind kind = {0};
    int index = 0, used = 0, solid = 0, unknown = 0, malformed = 0;
    const cJSON *cell;
    cJSON_ArrayForEach(cell, data) {
        int at = index++;
        if (!cJSON_IsNumber(cell) || !(cell->valuedouble >= 0 && cell->valuedouble <= UINT32_MAX)) {
            malformed++;
            continue;
        }
        uint32_t gid = (uint32_t)cell->valuedouble & GID_BITS;
        if (gid == 0)
            continue;
        used++;
        if (gid != kind.gid)
            kind = read_kind(r, layer, gid);
        unknown += !kind.known;
        solid += kind.solid;
        if (kind.solid && !kind.bad)
            add_tile(r, layer, &kind, at % width, at / width);
    }
    if (malformed > 0)
        level_problem_add(r->report, LEVEL_SKIP, 0, "layer '%.40s': %d cells are no tile numbers",
                          layer->name, malformed);
    if (unknown > 0)
        level_problem_add(
            r->report, LEVEL_SKIP, 0,
            "layer '%.40s': %d tiles belong to no tileset that is embedded in the map", layer->name,
            unknown);
    if (used > 0 && solid == 0)
        level_problem_add(r->report, LEVEL_NOTE, 0, "layer '%.40s': none of its %d tiles is solid",
                          layer->name, used);
}

void level_read_tiles(level_reader *r, const level_layer *layer) {
    if (cJSON_IsFalse(level_own_property(layer->json, "solid")))
        return;
    const cJSON *data = level_field(layer->json, "data");
    if (!cJSON_IsArray(data)) {
        level_problem_add(r->report, LEVEL_SKIP, 0,
                          "layer '%.40s': has no plain list of tiles; save the map with the tile "
                          "layer format CSV, not infinite",
                          layer->name);
        return;
    }
    level_values v = {.report = r->report, .chain = &layer->chain, .where = layer->name};
    double width = level_required(&v, layer->json, "width", 1, 1e6);
    double height = level_required(&v, layer->json, "height", 1, 1e6);
    if (v.bad)
        return;
    if (width != floor(width) || height != floor(height) || width * height > MOST_CELLS ||
        width * height != cJSON_GetArraySize(data)) {
        level_problem_add(r->report, LEVEL_SKIP, 0,
                          "layer '%.40s': %d tiles do not fill its %g columns and %g rows",
                          layer->name, cJSON_GetArraySize(data), width, height);
        return;
    }
    read_cells(r, layer, data, (int)width);
}
