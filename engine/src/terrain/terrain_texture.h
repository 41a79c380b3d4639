/* terrain_texture.h: the ranges of a texture's numbers (thud_textured.h). */
#ifndef TD_TERRAIN_TEXTURE_H
#define TD_TERRAIN_TEXTURE_H

#include "thud/thud_textured.h"

/* Whether the value of a vertex is in range: a texture coordinate with a table, a friction
 * coefficient without. */
bool td_texture_vertex_valid(bool has_table, double value);
/* Whether an entry of a table is in range. */
bool td_texture_entry_valid(float entry);

#endif
