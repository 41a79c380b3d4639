/* textures.h: the textures of a world's terrain lines, by terrain slot. */
#ifndef TD_TEXTURES_H
#define TD_TEXTURES_H

#include "textures/texture_hooks.h"

#include "thud/thud_textured.h"

/* The texture of a line; thud_texture refers to these arrays. */
typedef struct td_texture {
    td_array vertices; /* double; empty: the line has no texture */
    td_array table;    /* float; empty: the values of the vertices are the friction */
    bool repeats;
} td_texture;

typedef struct td_textures {
    td_array of; /* td_texture, by terrain slot, up to the highest slot that has had one */
} td_textures;

/* The texture of a terrain slot; null: it has none. */
static inline td_texture *td_texture_of(const thud_world *w, int terrain) {
    const td_array *of = &w->textures->of;
    td_texture *texture = terrain < of->count ? TD_AT(td_texture, of, terrain) : NULL;
    return texture && texture->vertices.count ? texture : NULL;
}

/* The texture as the public API describes it. */
static inline thud_texture td_texture_view(const td_texture *t) {
    return (thud_texture){t->vertices.data, t->vertices.count,
                          t->table.count ? t->table.data : NULL, t->table.count, t->repeats};
}

/* texture_store.c. */
/* The slot's texture, with memory reserved for these numbers of values; its contents do not change.
 * Null when memory is short. */
td_texture *td_texture_room(thud_world *w, int terrain, int vertices, int table);

/* For snapshots; td_texture_hooks says what each does. */
uint64_t td_textures_bytes(const thud_world *w);
void td_textures_write(const thud_world *w, char *to);
bool td_textures_valid(const char *from, uint64_t bytes, const char *points_of, int terrains);
bool td_textures_make_room(thud_world *w, const char *from, uint64_t bytes);
void td_textures_read(thud_world *w, const char *from, uint64_t bytes);

#endif
