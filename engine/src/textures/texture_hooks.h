/* texture_hooks.h: what a step, edits of terrain and snapshots ask of the textures of a world
 * (thud_textured.h). A world gets this table with its first texture, so that a program without does
 * not link it. */
#ifndef TD_TEXTURE_HOOKS_H
#define TD_TEXTURE_HOOKS_H

#include "state/world.h"

typedef struct td_texture_hooks {
    /* Sets the friction of every lane on a line with a texture, at its contact's present point. */
    void (*settle)(thud_world *w);
    /* Replaces the settings of two shapes where one of them is a line with a texture, at the point
     * of a collision within the step. */
    void (*settle_one)(const thud_world *w, const thud_contact *seen,
                       thud_contact_settings *settings);
    /* Makes room for a line's values to follow a splice of its vertices (terrain_edit.c) that adds
     * `count`. False when memory is short. */
    bool (*reserve)(thud_world *w, int line, int count);
    /* Lets the values follow the splice, before the line changes: `removed` vertices from `first`
     * on are replaced by `count` others. */
    void (*splice)(thud_world *w, int line, int first, int removed, const thud_pos *points,
                   int count);
    void (*forget)(thud_world *w, int terrain); /* a terrain's slot is given back */
    /* For snapshots: the bytes of all textures; writes them; whether such bytes hold valid textures
     * for the terrains that they come with, `points_of` each (int32, unaligned); makes room to read
     * them, false when memory is short; replaces the textures by them. */
    uint64_t (*bytes)(const thud_world *w);
    void (*write)(const thud_world *w, char *to);
    bool (*valid)(const char *from, uint64_t bytes, const char *points_of, int terrains);
    bool (*make_room)(thud_world *w, const char *from, uint64_t bytes);
    void (*read)(thud_world *w, const char *from, uint64_t bytes);
    void (*end)(thud_world *w); /* frees the textures, as the world is destroyed */
} td_texture_hooks;

#endif
