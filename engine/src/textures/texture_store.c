/* texture_store.c: the memory of textures, and textures in snapshots. The bytes in a snapshot are,
 * for each terrain slot that has a texture, by rising slot: a td_kept_texture, then its values
 * (double) and its table (float), without alignment. */
#include "textures/textures.h"

#include "terrain/terrain_texture.h"

#include <string.h>

td_texture *td_texture_room(thud_world *w, int terrain, int vertices, int table) {
    td_array *of = &w->textures->of;
    if (!td_array_reserve(&w->memory, of, terrain + 1)) {
        return NULL;
    }
    of->count = td_max_int(of->count, terrain + 1);
    td_texture *texture = TD_AT(td_texture, of, terrain);
    texture->vertices.stride = (int)sizeof(double);
    texture->table.stride = (int)sizeof(float);
    return td_array_reserve(&w->memory, &texture->vertices, vertices) &&
                   td_array_reserve(&w->memory, &texture->table, table)
               ? texture
               : NULL;
}

typedef struct td_kept_texture {
    int32_t terrain, vertices, table, repeats;
} td_kept_texture;

/* The number of bytes of a texture, including its td_kept_texture. */
static uint64_t bytes_of(int vertices, int table) {
    return sizeof(td_kept_texture) + (uint64_t)vertices * sizeof(double) +
           (uint64_t)table * sizeof(float);
}

uint64_t td_textures_bytes(const thud_world *w) {
    uint64_t bytes = 0;
    for (int i = 0; i < w->textures->of.count; i++) {
        const td_texture *t = td_texture_of(w, i);
        bytes += t ? bytes_of(t->vertices.count, t->table.count) : 0;
    }
    return bytes;
}

/* Copies the elements of an array, and returns the address after them. */
static char *put(char *to, const td_array *array) {
    size_t bytes = (size_t)array->count * (size_t)array->stride;
    if (bytes) {
        memcpy(to, array->data, bytes);
    }
    return to + bytes;
}

void td_textures_write(const thud_world *w, char *to) {
    for (int32_t i = 0; i < w->textures->of.count; i++) {
        const td_texture *t = td_texture_of(w, i);
        if (t) {
            td_kept_texture kept = {i, t->vertices.count, t->table.count, t->repeats};
            memcpy(to, &kept, sizeof kept);
            to = put(put(to + sizeof kept, &t->vertices), &t->table);
        }
    }
}

/* ---- reading ---- */

/* Whether the values and table entries that follow a td_kept_texture are in their ranges. */
static bool numbers_valid(td_kept_texture kept, const char *from) {
    for (int i = 0; i < kept.vertices; i++) {
        double value;
        memcpy(&value, from + (size_t)i * sizeof value, sizeof value);
        if (!td_texture_vertex_valid(kept.table > 0, value)) {
            return false;
        }
    }
    from += (size_t)kept.vertices * sizeof(double);
    for (int i = 0; i < kept.table; i++) {
        float entry;
        memcpy(&entry, from + (size_t)i * sizeof entry, sizeof entry);
        if (!td_texture_entry_valid(entry)) {
            return false;
        }
    }
    return true;
}

/* Whether the number of values equals the terrain's number of points; a flat line, which stores
 * none, counts as two. */
static bool fits(td_kept_texture kept, const char *points_of) {
    int32_t points;
    memcpy(&points, points_of + (size_t)kept.terrain * sizeof points, sizeof points);
    return kept.vertices == (points ? points : 2) && kept.table >= 0 &&
           kept.table <= THUD_TERRAIN_COUNT_MAX && (kept.repeats & ~1) == 0;
}

bool td_textures_valid(const char *from, uint64_t bytes, const char *points_of, int terrains) {
    int last = -1;
    while (bytes) {
        td_kept_texture kept;
        if (bytes < sizeof kept) {
            return false;
        }
        memcpy(&kept, from, sizeof kept);
        if (kept.terrain <= last || kept.terrain >= terrains || !fits(kept, points_of) ||
            bytes < bytes_of(kept.vertices, kept.table) ||
            !numbers_valid(kept, from + sizeof kept)) {
            return false;
        }
        last = kept.terrain;
        from += bytes_of(kept.vertices, kept.table);
        bytes -= bytes_of(kept.vertices, kept.table);
    }
    return true;
}

bool td_textures_make_room(thud_world *w, const char *from, uint64_t bytes) {
    for (const char *end = from + bytes; from < end;) {
        td_kept_texture kept;
        memcpy(&kept, from, sizeof kept);
        if (!td_texture_room(w, kept.terrain, kept.vertices, kept.table)) {
            return false;
        }
        from += bytes_of(kept.vertices, kept.table);
    }
    return true;
}

/* Reads elements into an array, where memory is reserved, and returns the address after them. */
static const char *take(const char *from, td_array *array, int count) {
    size_t bytes = (size_t)count * (size_t)array->stride;
    if (bytes) {
        memcpy(array->data, from, bytes);
    }
    array->count = count;
    return from + bytes;
}

void td_textures_read(thud_world *w, const char *from, uint64_t bytes) {
    for (int i = 0; i < w->textures->of.count; i++) {
        td_texture *t = TD_AT(td_texture, &w->textures->of, i);
        t->vertices.count = t->table.count = 0;
    }
    for (const char *end = from + bytes; from < end;) {
        td_kept_texture kept;
        memcpy(&kept, from, sizeof kept);
        td_texture *t = TD_AT(td_texture, &w->textures->of, kept.terrain);
        from = take(from + sizeof kept, &t->vertices, kept.vertices);
        from = take(from, &t->table, kept.table);
        t->repeats = kept.repeats;
    }
}
