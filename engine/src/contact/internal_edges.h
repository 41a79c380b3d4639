/* internal_edges.h: static shapes that stand side by side make one ground, and so do those of one
 * body. What slides over the internal edge between two of them must not meet the face that each
 * hides from the other: a ghost. */
#ifndef TD_INTERNAL_EDGES_H
#define TD_INTERNAL_EDGES_H

#include "contact/box_faces.h"
#include "state/world.h"

/* Faces of a box, and the bits of td_shape.internal_edges: a neighbour covers a part of them; of a
 * terrain, its right and its left end. In td_shape.hidden: one that meets the same others covers
 * the whole face. */
enum { TD_FACE_RIGHT, TD_FACE_TOP, TD_FACE_LEFT, TD_FACE_BOTTOM, TD_FACES };

/* The bit of a corner, in td_shape.internal_edges and in td_shape.hidden. It is set in the first
 * where something stands at the corner, and in the second where a shape that meets
 * the same others makes a straight edge of it, so that no normal between the corner's faces is the
 * ground's. */
static inline unsigned td_corner_bit(bool right, bool top) {
    return 1u << (TD_FACES + right + 2 * top);
}

/* In td_shape.flags, of a static box that nothing has come near: nobody has looked yet what it
 * stands at, and every bit of td_shape.internal_edges is set. */
enum { TD_SHAPE_UNSEEN = 4 };

/* Two shapes where they stand, relative to anything. */
typedef struct td_internal_edge_pair {
    thud_world *w;
    int shape[2];
    thud_shape_instance placed[2];
} td_internal_edge_pair;

/* td_block.internal_edges of two shapes: all of them where the second has any, since lanes know the
 * faces of the first alone. */
static inline uint8_t td_internal_edges_of(const td_shape *a, const td_shape *b) {
    return b->internal_edges ? UINT8_MAX : a->internal_edges;
}

/* Plugged into a world with the first box or line, see kinds.h. */
typedef struct td_internal_edge_ops {
    /* A static shape came or moved: it and its neighbours are to be looked at, at once where they
     * have contacts. False when memory is short. */
    bool (*find)(thud_world *w, int shape);
    /* Looks what an unseen shape stands at, before it gets a contact. Likewise. */
    bool (*see)(thud_world *w, int shape);
    /* Before a static body's shapes leave or move: their neighbours will look anew. Likewise. */
    bool (*lose)(thud_world *w, td_body_index body);
    /* Looks for which shapes of a moving body stand next to each other. */
    void (*join)(thud_world *w, td_body_index body);
    /* Takes ghosts out of the lanes of a block: a contact with a hidden face moves to one that can
     * be met, or ends, which td_block.touching tells. */
    void (*amend)(thud_world *w, td_block *block, int kind);
    /* The same for all lanes of the step; adds to scratch.parted, which has room. */
    void (*amend_all)(thud_world *w);
    /* Whether a normal, from the first to the second, is that of a ghost. */
    bool (*is_ghost)(const td_internal_edge_pair *pair, double nx, double ny);
    /* Two boxes: where they touch along an axis on which they can; false where they do not. */
    bool (*contact)(const td_internal_edge_pair *pair, td_internal_edge_contact *contact);
} td_internal_edge_ops;

extern const td_internal_edge_ops td_internal_edges;

bool td_internal_edges_find(thud_world *w, int shape); /* edge_finder.c */
bool td_internal_edges_see(thud_world *w, int shape);
bool td_internal_edges_lose(thud_world *w, td_body_index body);
void td_internal_edges_join(thud_world *w, td_body_index body);

#endif
