/* seams.h: static shapes that stand side by side make one ground. What slides over the seam between
 * two of them must not meet the face that each hides from the other: a ghost. */
#ifndef TD_SEAMS_H
#define TD_SEAMS_H

#include "world.h"

/* Faces of a box, and the bits of td_shape.seams: something static covers a part of them. Of a
 * terrain the first two, its right and its left end. */
enum { TD_FACE_RIGHT, TD_FACE_TOP, TD_FACE_LEFT, TD_FACE_BOTTOM, TD_FACES };

/* Looks for what a static shape that came or moved stands next to. False when memory is short. */
bool td_seams_find(thud_world *w, int shape);

/* Takes ghosts out of the lanes of a block whose first shapes are static: a contact with a hidden
 * face moves to one that can be met, or ends, which td_block.touching tells. */
void td_seams_amend(thud_world *w, td_block *block, int kind);
/* The same for all lanes of the step; adds to scratch.parted, which has room. */
void td_seams_amend_all(thud_world *w);

#endif
