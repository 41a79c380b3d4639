/* tiles.c: reads a tile layer, and adds a static body for each tile that collides.
 *
 * The property `solid` of the layer decides for all of its tiles. If the layer has none, that of
 * the tile decides, then that of its tileset. If none has it, a tile with collision shapes from
 * Tiled's collision editor collides, and other tiles do not. */
#include "reader.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What was read of one tile number for this layer. */
typedef struct tile_kind {
    uint32_t gid;
    /* known: a tileset that can be used has it; full: one of its forms covers its whole cell. */
    bool known, full;
    level_solid solid;
    level_physics physics;
    level_forms forms;
    bool has_ground;
    double foot;    /* the highest lower side of its ground, pixels below the cell's lower edge */
    double dx, dy;  /* from the cell's lower left corner to the tile's centre, pixels, y down */
    int ungrounded; /* tiles whose ground is left out */
    int far, many;  /* tiles of which something is left out: LEVEL_LEFT_FAR, LEVEL_LEFT_MANY */
} tile_kind;

/* A hash table of tile kinds by tile number, with linear probing; its size is a power of two. */
typedef struct tile_kinds {
    tile_kind *slots;
    uint32_t size, used;
} tile_kinds;

static void free_kinds(tile_kinds *kinds) {
    for (uint32_t i = 0; i < kinds->size; i++)
        level_forms_free(&kinds->slots[i].forms);
    free(kinds->slots);
}

/* The slot of a tile number, or the free one in which it belongs (gid 0). */
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

/* Whether a form covers a cell of the map; the form is relative to the cell's centre. */
static bool covers(const level_reader *r, const level_form *form) {
    double near = 1e-3 * fmax(r->tile_width, r->tile_height);
    return form->kind == LEVEL_BOX && form->rotation == 0 && !form->physics.sensor &&
           fabs(form->x) + r->tile_width * 0.5 <= form->hx + near &&
           fabs(form->y) + r->tile_height * 0.5 <= form->hy + near;
}

/* The size in pixels in which a tile is drawn. False after a report. */
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

/* Reads a tile number's forms and physics. */
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

/* The kind of a tile number, read when it is first asked for; null if memory runs out. It moves
 * when the table grows. */
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

/* For each column the first row of those at the bottom whose cells are all full; null if memory
 * runs out. In an infinite map the lowest row with a tile counts as the bottom. */
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

/* Adds the body of a tile. `on_floor`: all cells below it are full, so that its polygons may be
 * ground. */
static void add_tile(level_reader *r, const level_layer *layer, tile_kind *kind, double column,
                     double row, bool on_floor) {
    double x = (layer->ox + column * r->tile_width) + kind->dx;
    double y = (layer->oy + (row + 1) * r->tile_height) + kind->dy;
    bool grounded = on_floor && kind->foot >= -1e-3 * r->tile_height;
    kind->ungrounded += kind->has_ground && !grounded;
    level_added added = level_add_body(r, &kind->physics, 0, &kind->forms, grounded, x, y, 0);
    kind->far += added == LEVEL_LEFT_FAR;
    kind->many += added == LEVEL_LEFT_MANY;
}

static void report_left_out(const level_reader *r, const level_layer *layer,
                            const tile_kinds *kinds) {
    int ungrounded = 0, far = 0, many = 0;
    for (uint32_t i = 0; i < kinds->size; i++) {
        ungrounded += kinds->slots[i].ungrounded;
        far += kinds->slots[i].far;
        many += kinds->slots[i].many;
    }
    if (ungrounded > 0)
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': the polygons of %d tiles are no ground: all below them, "
                          "down to the map's lower edge, would have to be solid",
                          layer->name, ungrounded);
    if (far > 0)
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': the places of %d tiles are " LEVEL_TOO_FAR, layer->name,
                          far);
    if (many > 0)
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': %d tiles are left out: " LEVEL_TOO_MANY, layer->name,
                          many);
}

/* Adds the bodies of all cells, and reports what is wrong with them. */
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
                kind = slot_of(kinds, gid); /* find_floors may have made the table grow */
            }
            if (kind->forms.count > 0)
                add_tile(r, layer, kind, (double)cells->column + i, (double)cells->row + j,
                         kind->has_ground && j + 1 >= floors[i]);
        }
    }
    free(floors);
    report_left_out(r, layer, kinds);
    r->unmarked += unmarked;
    if (unknown > 0)
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': %d tiles belong to no tileset that can be used",
                          layer->name, unknown);
    if (used > 0 && colliding == 0 && unknown < used)
        level_problem_add(r->report, LEVEL_NOTE, LEVEL_NO_OBJECT,
                          "layer '%.40s': none of its %d tiles is solid", layer->name, used);
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
