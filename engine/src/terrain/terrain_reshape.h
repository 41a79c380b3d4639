/* terrain_reshape.h: computes new vertices for a part of a terrain that is dug out or raised.
 * state/terrain_edit.c puts them into the world. */
#ifndef TD_TERRAIN_RESHAPE_H
#define TD_TERRAIN_RESHAPE_H

#include "thud/thud_geometry.h"

/* The shape by which a terrain is edited: a circle, which removes the ground inside and above it,
 * or a mound, which adds rise (1 - u^2)^2 to the height at x, with u = (x - tool.x) / radius.
 * Coordinates are relative to the terrain's origin. */
typedef struct td_tool {
    bool digs;   /* a circle; false: a mound */
    double x, y; /* centre; y is not read for a mound */
    double radius;
    double rise; /* height of a mound in its middle; negative: a hollow */
} td_tool;

/* The range of vertices strictly within the tool's width; not of a flat terrain. */
void td_tool_vertices(const thud_terrain *terrain, const td_tool *tool, int *first, int *count);

/* The maximum number of vertices that td_tool_reshape writes in place of `count` vertices. */
int td_tool_room(int count);

/* Writes the vertices that replace the `count` ones from `first` on, and returns their number. In a
 * uniform terrain only heights change. An irregular one also gets vertices where the changed ground
 * begins and ends, and along the tool's curve. No two of them are nearer to each other than 1/64 of
 * the radius, so that repeated digging in the same place does not add vertices without bound. */
int td_tool_reshape(const thud_terrain *terrain, const td_tool *tool, int first, int count,
                    thud_pos *out);

#endif
