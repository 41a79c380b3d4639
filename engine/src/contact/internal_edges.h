/* internal_edges.h: contacts at internal edges are suppressed.
 *
 * Static shapes that stand side by side, such as the tiles of a floor, form one surface, and so do
 * the shapes of one moving body. The faces and corners between two neighbours are internal edges:
 * no other shape can reach them. Tested alone, each shape reports contacts with them nevertheless
 * (ghost collisions: Catto, "Ghost Collisions", box2d.org, 2020), and a body that slides over the
 * surface is caught. Bullet's btInternalEdgeUtility.h solves the same problem for triangle meshes.
 *
 * - edge_finder.c finds for each shape which of its faces and corners have a neighbour at them.
 * - internal_edges.c removes or changes contacts at those that are hidden.
 * - edge_neighbours.c has the geometric queries that both use. */
#ifndef TD_INTERNAL_EDGES_H
#define TD_INTERNAL_EDGES_H

#include "contact/box_faces.h"
#include "state/world.h"

/* The faces of a box. 1 << face is the bit of a face in two masks of td_shape:
 * - internal_edges: a neighbour covers some part of the face. Of a terrain only RIGHT and LEFT are
 *   used, for the ends of its line.
 * - hidden: one neighbour with the same filter covers the whole face, so that no normal of it is
 *   ever valid. */
enum { TD_FACE_RIGHT, TD_FACE_TOP, TD_FACE_LEFT, TD_FACE_BOTTOM, TD_FACES };

/* The bit of a corner of a box in the same masks. internal_edges: a neighbour stands at the corner.
 * hidden: a neighbour with the same filter goes on past the corner in both directions, so that no
 * normal between the corner's two faces is ever valid. */
static inline unsigned td_corner_bit(bool right, bool top) {
    return 1u << (TD_FACES + right + 2 * top);
}

/* A bit of td_shape.flags, of a static box whose neighbours have not been looked for, since nothing
 * has come near it. All bits of td_shape.internal_edges are set meanwhile. */
enum { TD_SHAPE_UNSEEN = 4 };

/* A pair of shapes whose contact is examined, and an instance of each, relative to a common
 * origin. */
typedef struct td_internal_edge_pair {
    thud_world *w;
    int shape[2];
    thud_geometry placed[2];
} td_internal_edge_pair;

/* The value of td_lane_marks.internal_edges for the lane of a and b: the mask of a, or all bits
 * where b has internal edges. The quick test by this mask (is_open) only looks at the faces of a;
 * with all bits it never passes, and is_ghost decides. */
static inline uint8_t td_internal_edges_of(const td_shape *a, const td_shape *b) {
    return b->internal_edges ? UINT8_MAX : a->internal_edges;
}

/* The functions of a world from its first box or terrain on (state/kind_*.c). */
typedef struct td_internal_edge_ops {
    /* A shape of a static body was created or has moved: marks it and its neighbours as
     * TD_SHAPE_UNSEEN. Where one of these already has contacts, finds its masks immediately, as
     * `see` does. False when memory is short. */
    bool (*find)(thud_world *w, int shape);
    /* Finds the masks of an unseen shape; before it gets its first contact. False when memory is
     * short. */
    bool (*see)(thud_world *w, int shape);
    /* Before the shapes of a static body are removed or moved: clears the masks of their neighbours
     * and marks those as moved, so that `find` gets them in the next step. False when memory is
     * short. */
    bool (*lose)(thud_world *w, td_body_index body);
    /* Finds the masks of all boxes of a body that is not static. */
    void (*join)(thud_world *w, td_body_index body);
    /* Corrects the contacts of a block that are at a hidden face or corner. Such a contact gets a
     * manifold along an axis that is not hidden, or loses its points and its bit of
     * td_block.touching. */
    void (*amend)(thud_world *w, td_block *block, int kind);
    /* Calls `amend` for all blocks of the step with lanes that may be at internal edges. Adds the
     * blocks in which a lane stops touching to scratch.separated, which has room. */
    void (*amend_all)(thud_world *w);
    /* Whether the unit normal, from the first shape to the second, belongs to a hidden face or
     * corner. */
    bool (*is_ghost)(const td_internal_edge_pair *pair, double nx, double ny);
    /* The contact of two boxes along the best axis that is not hidden. False where there is none,
     * and for other kinds of shapes. */
    bool (*contact)(const td_internal_edge_pair *pair, td_internal_edge_contact *contact);
} td_internal_edge_ops;

extern const td_internal_edge_ops td_internal_edges;

/* edge_finder.c: `find`, `see`, `lose` and `join` of td_internal_edge_ops. */
bool td_internal_edges_find(thud_world *w, int shape);
bool td_internal_edges_see(thud_world *w, int shape);
bool td_internal_edges_lose(thud_world *w, td_body_index body);
void td_internal_edges_join(thud_world *w, td_body_index body);

#endif
