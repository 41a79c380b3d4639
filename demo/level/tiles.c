/* tiles.c: reads a tile layer; adds a static body for every tile that collides.
 *
 * The property `solid` of the layer decides for all its tiles; where it has none, that of the tile
 * decides, then that of its tileset; without any a tile collides with the shapes that Tiled's
 * collision editor gave it, and one that has none is decoration. */
#include "reader.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What one tile number stands for in this layer. */
typedef struct tile_kind {
    uint32_t gid;
    bool known, full; /* full: it fills its cell, and stops what comes */
    level_solid solid;
    level_physics physics;
    level_forms forms;
    bool has_ground;
    double foot;            /* the highest that ground of it must reach down to, from its middle */
    double dx, dy;          /* from the cell's lower left corner to its middle */
    int placed, ungrounded; /* how many there are, and how many are no ground here */
} tile_kind;

/* Kinds by number: a table with open addressing, its size a power of two. */
typedef struct tile_kinds {
    tile_kind *slots;
    uint32_t size, used;
} tile_kinds;

static void free_kinds(tile_kinds *kinds) {
    for (uint32_t i = 0; i < kinds->size; i++)
        level_forms_free(&kinds->slots[i].forms);
    free(kinds->slots);
}

static tile_kind *slot_of(const tile_kinds *kinds, uint32_t gid) {
    uint32_t at = gid * 2654435769u & (kinds->size - 1);
    while (kinds->slots[at].gid != 0 && kinds->slots[at].gid != gid)
        at = (at + 1) & (kinds->size - 1);
    return &kinds->slots[at];
}

static bool grow(tile_kinds *kinds) {
    tile_kinds wider = {.size = kinds->size ? 2 * kinds->size : 64, .used = kinds->used};
    wider.slots = calloc(wider.size, sizeof *wider.slots);
    if (!wider.slots)
        return false;
    for (uint32_t i = 0; i < kinds->size; i++)
        if (kinds->slots[i].gid != 0)
            *slot_of(&wider, kinds->slots[i].gid) = kinds->slots[i];
    free(kinds->slots);
    *kinds = wider;
    return true;
}

/* Whether a form covers a cell of the map about the middle of which it lies. */
static bool covers(const level_reader *r, const level_form *form) {
    double near = 1e-3 * fmax(r->tile_width, r->tile_height);
    return form->kind == LEVEL_BOX && form->rotation == 0 && !form->physics.sensor &&
           fabs(form->x) + r->tile_width * 0.5 <= form->hx + near &&
           fabs(form->y) + r->tile_height * 0.5 <= form->hy + near;
}

/* How large a tile is drawn, and from where in its cell; false after a report. */
static bool lay_out(const level_reader *r, const level_values *v, const level_tile *tile,
                    uint32_t gid, double *width, double *height) {
    bool turned = gid & LEVEL_FLIP_TURN;
    double w = turned ? tile->height : tile->width, h = turned ? tile->width : tile->height;
    *width = tile->fills_cell ? r->tile_width : w;
    *height = tile->fills_cell ? r->tile_height : h;
    bool squeezed = fabs(*width * h - *height * w) > 1e-3 * (*width * h);
    if (tile->fills_cell && tile->keeps_aspect && squeezed) {
        level_complain(v, LEVEL_SKIP, "its picture neither fills the cell nor has its own size");
        return false;
    }
    return true;
}

static void read_kind(level_reader *r, const level_layer *layer, uint32_t gid, tile_kind *kind) {
    *kind = (tile_kind){.gid = gid, .solid = LEVEL_OPEN};
    level_tile tile = level_find_tile(r, &r->tilesets, gid);
    kind->known = tile.tileset != NULL;
    if (!kind->known)
        return;
    char where[100];
    const cJSON *id = level_field(tile.json, "id");
    snprintf(where, sizeof where, id ? "layer '%.40s', tile %g of '%.30s'" : "layer '%.40s'",
             layer->name, id ? id->valuedouble : 0, level_field_text(tile.tileset, "name", ""));
    level_chain chain = layer->chain;
    chain.links[chain.count++] = tile.tileset;
    if (tile.json)
        chain.links[chain.count++] = tile.json;
    level_values v = {.report = r->report, .chain = &chain, .where = where};
    double width, height;
    if (!lay_out(r, &v, &tile, gid, &width, &height))
        return;
    kind->solid = level_read_tile_forms(r, &v, &tile, gid, width, height, chain.count,
                                        &kind->physics, &kind->forms);
    kind->physics.kind = SCENE_STATIC;
    level_forms_settle(r, &v, &kind->physics, &kind->forms, 0, -DBL_MAX);
    r->s->failed = r->s->failed || kind->forms.failed;
    bool turned = gid & LEVEL_FLIP_TURN;
    kind->dx = tile.offset_x * (width / (turned ? tile.height : tile.width)) + width * 0.5;
    kind->dy = tile.offset_y * (height / (turned ? tile.width : tile.height)) - height * 0.5;
    kind->foot = DBL_MAX;
    for (int i = 0; i < kind->forms.count; i++) {
        const level_form *form = &kind->forms.items[i];
        level_form placed = *form;
        placed.x += kind->dx - r->tile_width * 0.5;
        placed.y += kind->dy + r->tile_height * 0.5;
        kind->full = kind->full || (!form->points && covers(r, &placed));
        kind->has_ground = kind->has_ground || form->ground;
        if (form->ground)
            kind->foot = fmin(kind->foot, form->y + form->foot + kind->dy);
    }
}

/* Null without memory. */
static tile_kind *kind_of(level_reader *r, const level_layer *layer, tile_kinds *kinds,
                          uint32_t gid) {
    if (2 * kinds->used >= kinds->size && !grow(kinds)) {
        r->s->failed = true;
        return NULL;
    }
    tile_kind *kind = slot_of(kinds, gid);
    if (kind->gid == 0) {
        read_kind(r, layer, gid, kind);
        kinds->used++;
    }
    return kind;
}

/* In each column the row from which on all cells are full; null without memory. What is below the
 * lowest row is out of the map. */
static int *find_floors(level_reader *r, const level_layer *layer, tile_kinds *kinds,
                        const level_cells *cells) {
    int *floors = malloc((size_t)cells->width * sizeof *floors), last = cells->height;
    if (!floors) {
        r->s->failed = true;
        return NULL;
    }
    bool infinite = cJSON_IsArray(level_field(layer->json, "chunks"));
    bool empty = infinite;
    while (last > 0 && empty) {
        for (int i = 0; i < cells->width; i++)
            empty = empty && cells->at[(size_t)(last - 1) * (size_t)cells->width + (size_t)i] == 0;
        last -= empty;
    }
    for (int i = 0; i < cells->width; i++) {
        int row = last;
        for (; row > 0; row--) {
            uint32_t gid = cells->at[(size_t)(row - 1) * (size_t)cells->width + (size_t)i];
            const tile_kind *kind =
                (gid & LEVEL_NUMBER) == 0 ? NULL : kind_of(r, layer, kinds, gid);
            if (!kind || !kind->full)
                break;
        }
        floors[i] = row;
    }
    return floors;
}

static void add_tile(level_reader *r, const level_layer *layer, tile_kind *kind, double column,
                     double row, bool on_floor) {
    double x = (layer->ox + column * r->tile_width) + kind->dx;
    double y = (layer->oy + (row + 1) * r->tile_height) + kind->dy;
    bool grounded = on_floor && kind->foot >= -1e-3 * r->tile_height;
    kind->placed++;
    kind->ungrounded += kind->has_ground && !grounded;
    level_add_body(r, &kind->physics, 0, &kind->forms, grounded, x, y, 0);
}

static void report_ungrounded(const level_reader *r, const level_layer *layer,
                              const tile_kinds *kinds) {
    int ungrounded = 0;
    for (uint32_t i = 0; i < kinds->size; i++)
        ungrounded += kinds->slots[i].ungrounded;
    if (ungrounded > 0)
        level_problem_add(r->report, LEVEL_SKIP, 0,
                          "layer '%.40s': the polygons of %d tiles are no ground: all below them, "
                          "down to the map's lower edge, would have to be solid",
                          layer->name, ungrounded);
}

static void read_cells(level_reader *r, const level_layer *layer, const level_cells *cells,
                       tile_kinds *kinds) {
    int used = 0, colliding = 0, unknown = 0, unmarked = 0;
    int *floors = NULL;
    for (int j = 0; j < cells->height && !r->s->failed; j++) {
        for (int i = 0; i < cells->width; i++) {
            uint32_t gid = cells->at[(size_t)j * (size_t)cells->width + (size_t)i];
            tile_kind *kind = (gid & LEVEL_NUMBER) == 0 ? NULL : kind_of(r, layer, kinds, gid);
            if (!kind)
                continue;
            used++;
            unknown += !kind->known;
            unmarked += kind->known && kind->solid == LEVEL_UNMARKED;
            colliding += kind->solid == LEVEL_SOLID;
            if (kind->has_ground && !floors) {
                floors = find_floors(r, layer, kinds, cells);
                if (!floors)
                    return;
                kind = slot_of(kinds, gid); /* the table may have grown */
            }
            if (kind->forms.count > 0)
                add_tile(r, layer, kind, (double)cells->column + i, (double)cells->row + j,
                         kind->has_ground && j + 1 >= floors[i]);
        }
    }
    free(floors);
    report_ungrounded(r, layer, kinds);
    r->unmarked += unmarked;
    if (unknown > 0)
        level_problem_add(r->report, LEVEL_SKIP, 0,
                          "layer '%.40s': %d tiles belong to no tileset that can be used",
                          layer->name, unknown);
    if (used > 0 && colliding == 0 && unknown < used)
        level_problem_add(r->report, LEVEL_NOTE, 0, "layer '%.40s': none of its %d tiles is solid",
                          layer->name, used);
}

void level_read_tiles(level_reader *r, const level_layer *layer) {
    if (level_flag_of(level_own_property(layer->json, "solid")) == 0)
        return;
    level_cells cells;
    if (!level_read_cells(r, layer, &cells))
        return;
    tile_kinds kinds = {0};
    read_cells(r, layer, &cells, &kinds);
    free_kinds(&kinds);
    free(cells.at);
}
