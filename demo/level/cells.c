/* cells.c: reads the tile numbers of a layer in each of their encodings: a JSON list, text with
 * commas, or base64, which may be compressed; in infinite maps in chunks. */
#include "reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Reports a problem of a layer. */
static void complain(const level_reader *r, const level_layer *layer, const char *what) {
    level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT, "layer '%.40s': %s", layer->name,
                      what);
}

static bool is_cell(double value) {
    return value >= 0 && value <= UINT32_MAX && value == floor(value);
}

/* Reads cells from a JSON list. Returns their number, which may be larger than `count`, the room in
 * `out`. Items that are no tile numbers become 0 and are counted in *malformed. */
static size_t from_list(const cJSON *list, uint32_t *out, size_t count, int *malformed) {
    size_t seen = 0;
    const cJSON *cell;
    cJSON_ArrayForEach(cell, list) {
        bool good = cJSON_IsNumber(cell) && is_cell(cell->valuedouble);
        *malformed += !good;
        if (seen < count)
            out[seen] = good ? (uint32_t)cell->valuedouble : 0;
        seen++;
    }
    return seen;
}

/* The same from a text with numbers between commas and white space. */
static size_t from_text(const char *text, uint32_t *out, size_t count, int *malformed) {
    static const char BETWEEN[] = ", \t\r\n";
    size_t seen = 0;
    for (text += strspn(text, BETWEEN); *text; text += strspn(text, BETWEEN)) {
        size_t length = strcspn(text, BETWEEN);
        char word[32] = "";
        double value = -1;
        if (length < sizeof word)
            memcpy(word, text, length);
        bool good = level_number_of(word, &value) && is_cell(value);
        *malformed += !good;
        if (seen < count)
            out[seen] = good ? (uint32_t)value : 0;
        seen++;
        text += length;
    }
    return seen;
}

/* Reads `count` cells from base64, little-endian 32-bit numbers. False after a report. */
static bool from_base64(const level_reader *r, const level_layer *layer, const char *text,
                        uint32_t *out, size_t count) {
    uint8_t *bytes = malloc(4 * count);
    if (!bytes) {
        r->s->failed = true;
        return false;
    }
    const char *why =
        level_unpack(text, level_field_text(layer->json, "compression", ""), bytes, 4 * count);
    for (size_t i = 0; !why && i < count; i++)
        out[i] = (uint32_t)bytes[4 * i] | (uint32_t)bytes[4 * i + 1] << 8 |
                 (uint32_t)bytes[4 * i + 2] << 16 | (uint32_t)bytes[4 * i + 3] << 24;
    free(bytes);
    if (why)
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT, "layer '%.40s': its tiles %s",
                          layer->name, why);
    return !why;
}

/* Reads the width * height cells of a layer or a chunk. False after a report. */
static bool read_numbers(const level_reader *r, const level_layer *layer, const cJSON *data,
                         uint32_t *out, size_t width, size_t height) {
    size_t count = width * height, seen = 0;
    int malformed = 0;
    if (cJSON_IsArray(data)) {
        seen = from_list(data, out, count, &malformed);
    } else if (!cJSON_IsString(data)) {
        complain(r, layer, "has no tiles");
        return false;
    } else if (strcmp(level_field_text(layer->json, "encoding", "csv"), "csv") == 0) {
        seen = from_text(data->valuestring, out, count, &malformed);
    } else if (strcmp(level_field_text(layer->json, "encoding", ""), "base64") == 0) {
        return from_base64(r, layer, data->valuestring, out, count);
    } else {
        complain(r, layer, "its tiles are written in a way that is not known");
        return false;
    }
    if (seen != count) {
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': %zu tiles do not fill its %zu columns and %zu rows",
                          layer->name, seen, width, height);
        return false;
    }
    if (malformed > 0)
        level_problem_add(r->report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "layer '%.40s': %d cells are no tile numbers", layer->name, malformed);
    return true;
}

/* Columns and rows, in cells. */
typedef struct area {
    int column, row, width, height;
} area;

/* Reads the columns and rows of a layer or a chunk. `placed`: it has a position; else that is (0,
 * 0). False after a report. */
static bool read_area(level_reader *r, const level_layer *layer, const cJSON *json, bool placed,
                      area *a) {
    level_values v = {.report = r->report, .chain = &layer->chain, .where = layer->name};
    double x = placed ? level_required(&v, json, "x", -1e6, 1e6) : 0;
    double y = placed ? level_required(&v, json, "y", -1e6, 1e6) : 0;
    double width = level_required(&v, json, "width", 1, 1e6);
    double height = level_required(&v, json, "height", 1, 1e6);
    if (v.bad)
        return false;
    if (x != floor(x) || y != floor(y) || width != floor(width) || height != floor(height)) {
        complain(r, layer, "its columns and rows are no whole numbers");
        return false;
    }
    *a = (area){(int)x, (int)y, (int)width, (int)height};
    return true;
}

/* Allocates an area's cells, all empty. False after a report. */
static bool make_room(level_reader *r, const level_layer *layer, const area *a,
                      level_cells *cells) {
    double count = (double)a->width * a->height;
    if (count > r->cells) {
        complain(r, layer, "this map has more cells than are read, 16777216 in all");
        return false;
    }
    r->cells -= count;
    *cells = (level_cells){.at = calloc((size_t)count, sizeof *cells->at),
                           .width = a->width,
                           .height = a->height,
                           .column = a->column,
                           .row = a->row};
    r->s->failed = r->s->failed || !cells->at;
    return cells->at != NULL;
}

/* The smallest area that contains both. */
static area around(area a, area b) {
    int column = a.column < b.column ? a.column : b.column;
    int row = a.row < b.row ? a.row : b.row;
    int right_a = a.column + a.width, right_b = b.column + b.width;
    int below_a = a.row + a.height, below_b = b.row + b.height;
    return (area){column, row, (right_a > right_b ? right_a : right_b) - column,
                  (below_a > below_b ? below_a : below_b) - row};
}

/* Reads a chunk and copies its cells into those of the layer. */
static void read_chunk(level_reader *r, const level_layer *layer, const cJSON *chunk,
                       const level_cells *cells) {
    area a;
    level_cells own;
    if (!read_area(r, layer, chunk, true, &a) || !make_room(r, layer, &a, &own))
        return;
    if (read_numbers(r, layer, level_field(chunk, "data"), own.at, (size_t)a.width,
                     (size_t)a.height)) {
        size_t column = (size_t)(a.column - cells->column), row = (size_t)(a.row - cells->row);
        for (size_t j = 0; j < (size_t)a.height; j++)
            memcpy(cells->at + (row + j) * (size_t)cells->width + column,
                   own.at + j * (size_t)a.width, (size_t)a.width * sizeof *own.at);
    }
    free(own.at);
}

/* Reads all chunks of a layer of an infinite map. False after a report. */
static bool read_chunks(level_reader *r, const level_layer *layer, const cJSON *chunks,
                        level_cells *cells) {
    area all = {0};
    bool any = false;
    const cJSON *chunk;
    cJSON_ArrayForEach(chunk, chunks) {
        area a;
        if (!read_area(r, layer, chunk, true, &a))
            return false;
        all = any ? around(all, a) : a;
        any = true;
    }
    if (!any)
        return true;
    if (!make_room(r, layer, &all, cells))
        return false;
    cJSON_ArrayForEach(chunk, chunks)
        read_chunk(r, layer, chunk, cells);
    return true;
}

bool level_read_cells(level_reader *r, const level_layer *layer, level_cells *cells) {
    *cells = (level_cells){0};
    const cJSON *chunks = level_field(layer->json, "chunks");
    if (cJSON_IsArray(chunks))
        return read_chunks(r, layer, chunks, cells);
    const cJSON *data = level_field(layer->json, "data");
    if (!cJSON_IsArray(data) && !cJSON_IsString(data)) {
        complain(r, layer, "has no tiles");
        return false;
    }
    area a;
    if (!read_area(r, layer, layer->json, false, &a) || !make_room(r, layer, &a, cells))
        return false;
    if (read_numbers(r, layer, data, cells->at, (size_t)a.width, (size_t)a.height))
        return true;
    free(cells->at);
    *cells = (level_cells){0};
    return false;
}
