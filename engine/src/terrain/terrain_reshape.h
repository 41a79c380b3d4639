/* terrain_reshape.h: the vertices that a part of a ground line gets where it is dug out or raised.
 */
#ifndef TD_TERRAIN_RESHAPE_H
#define TD_TERRAIN_RESHAPE_H

#include "thud/thud_shapes.h"

/* A circle that takes away the ground in it and above it, or a mound. Coordinates are the line's.
 */
typedef struct td_tool {
    bool digs;
    double x, y; /* centre; a mound has no y */
    double radius;
    double rise; /* of a mound in its middle */
} td_tool;

/* The vertices strictly within the tool's width; of a line that is not flat. */
void td_tool_vertices(const thud_terrain *terrain, const td_tool *tool, int *first, int *count);

/* The most that td_tool_reshape writes for so many vertices. */
int td_tool_room(int count);

/* Writes what takes the place of those vertices, and returns how many they are. A uniform line
 * keeps its grid. An irregular one gets vertices where the ground begins to differ, and between
 * them; none nearer to each other than about a sixtieth of the radius, so that digging in the same
 * place for ever does not make ever more of them. */
int td_tool_reshape(const thud_terrain *terrain, const td_tool *tool, int first, int count,
                    thud_pos *out);

#endif
