/* texture_hooks.h: the functions of friction textures (thud_textured.h) that a step, edits of
 * terrain and snapshots call. A world gets this table with its first texture, so that a program
 * without textures does not link it. */
#ifndef TD_TEXTURE_HOOKS_H
#define TD_TEXTURE_HOOKS_H

#include "state/world.h"

typedef struct td_texture_hooks {
    /* Sets the friction of every contact with a textured line, by the texture at the present
     * contact point. */
    void (*settle)(thud_world *w);
    /* If one of the two shapes is a textured line, replaces the settings of the pair by those at
     * the point of a collision within the step. */
    void (*settle_one)(const thud_world *w, const thud_contact *seen,
                       thud_contact_settings *settings);
    /* Reserves memory for the texture's values before a splice of the line's vertices
     * (terrain_edit.c) that adds `count` of them. False when memory is short. */
    bool (*reserve)(thud_world *w, int line, int count);
    /* Updates the texture's values for the splice, before the line changes: `removed` vertices from
     * `first` on are replaced by `count` others. */
    void (*splice)(thud_world *w, int line, int first, int removed, const thud_pos *points,
                   int count);
    void (*forget)(thud_world *w, int terrain); /* a terrain's slot is freed */
    /* For snapshots, in this order: the number of bytes of all textures; writes them; checks
     * whether such bytes hold valid textures for the snapshot's terrains, whose numbers of points
     * are `points_of` (int32, unaligned); reserves memory to read them, false when memory is short;
     * replaces the textures by them. */
    uint64_t (*bytes)(const thud_world *w);
    void (*write)(const thud_world *w, char *to);
    bool (*valid)(const char *from, uint64_t bytes, const char *points_of, int terrains);
    bool (*make_room)(thud_world *w, const char *from, uint64_t bytes);
    void (*read)(thud_world *w, const char *from, uint64_t bytes);
    void (*end)(thud_world *w); /* frees the textures, as the world is destroyed */
} td_texture_hooks;

#endif
