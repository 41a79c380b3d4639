/* thud_draw.h: debug drawing: a world draws its shapes, and the bounds, pairs, contacts, islands
 * and joints of its last step, by calling functions of the caller. For viewers and tests. Included
 * by thud.h. */
#ifndef THUD_DRAW_H
#define THUD_DRAW_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a line, box, circle or point of debug drawing shows. */
typedef enum thud_style {
    THUD_STYLE_STATIC = 0,           /* shape of a static body */
    THUD_STYLE_KINEMATIC,            /* shape of an awake kinematic body */
    THUD_STYLE_DYNAMIC,              /* shape of an awake dynamic body */
    THUD_STYLE_SLEEPING,             /* shape of a sleeping body */
    THUD_STYLE_SENSOR,               /* sensor of any body */
    THUD_STYLE_BOUNDS,               /* box: fat bounds of a shape */
    THUD_STYLE_CELL,                 /* box: cell of the grid broadphase */
    THUD_STYLE_CONTACT,              /* point: the middle of a contact */
    THUD_STYLE_NORMAL,               /* line from the middle of a contact along its normal */
    THUD_STYLE_INTERVAL,             /* line: the interval along x of a shape's bounds */
    THUD_STYLE_INTERVAL_OVERLAPPING, /* the same, if it overlaps the interval of another shape */
    THUD_STYLE_PAIR,                 /* line between two centres: tight bounds overlap */
    THUD_STYLE_PAIR_TOUCHING,        /* line between two centres: the shapes touch */
    THUD_STYLE_MOTION,               /* outline of a swept volume */
    THUD_STYLE_PAIR_CANDIDATE,       /* line between two centres: only the fat bounds overlap */
    THUD_STYLE_DIRECT,   /* line between two centres: the pair's island was solved directly */
    THUD_STYLE_MANIFOLD, /* point: one contact point */
    THUD_STYLE_DEPTH,   /* line from a contact point along the normal, as long as the penetration */
    THUD_STYLE_IMPULSE, /* line from a contact point along the normal, as long as the distance by
                           which the point's impulse of one step alone would move the lighter body
                           in a second */
    THUD_STYLE_COLOUR,  /* line between two centres: the pair has graph colour 0 of the solver */
    THUD_STYLE_COLOUR_LAST =
        THUD_STYLE_COLOUR + 15, /* the same for colour 15 and all further ones */
    THUD_STYLE_JOINT,      /* line from a body's centre to its anchor of a joint, or between the two
                             anchors; points at the anchors */
    THUD_STYLE_JOINT_AXIS, /* line: the x axis of frame a, if the kind of joint uses it */
    THUD_STYLE_JOINT_LIMIT, /* lines: the range of positions or angles of b that limits allow */
    THUD_STYLE_JOINT_FORCE, /* line from b's anchor: the distance that the joint's force alone would
                              move b in a second, from rest */
    THUD_STYLE_COUNT
} thud_style;

/* Bits of thud_debug_draw.flags. */
enum {
    THUD_DRAW_SHAPES = 1 << 0,
    THUD_DRAW_SHAPE_BOUNDS = 1 << 1, /* fat bounds of shapes */
    THUD_DRAW_CELLS = 1 << 2, /* grid cells that contained awake shapes in the last step; only with
                                 the grid broadphase */
    THUD_DRAW_CONTACTS = 1 << 3, /* middles and normals of contacts that were solved in the last
                                    step (not of vetoed ones) */
    THUD_DRAW_ISLANDS = 1 << 4,  /* shapes with the number of their island, see `island`; and the
                                    pairs of islands that were solved directly */
    /* The intervals that a plane sweep broadphase kept sorted in the last step: bars in rows from
     * the lower edge of the view up, first those of awake shapes, then those of resting ones; if it
     * sorts along y, from the left edge to the right. For a sweep along both axes, the intervals
     * along x. If more than 12 intervals overlap, bars cover each other. */
    THUD_DRAW_AXES = 1 << 5,
    THUD_DRAW_PAIRS = 1 << 6, /* pairs of the last broadphase; lines to terrain are vertical */
    /* The swept volumes of the last step, for each shape of a body that moved further than a
     * quarter of its smallest size: the shape before and after, and the sides of their convex hull
     * that join the two. For a body that collided within the step, a straight motion from start to
     * end is drawn. */
    THUD_DRAW_MOTIONS = 1 << 7,
    THUD_DRAW_STAGES = 1 << 8,  /* pairs as THUD_DRAW_PAIRS, with a style for each stage that they
                                   passed: fat bounds overlap, tight bounds overlap, shapes touch */
    THUD_DRAW_COLOURS = 1 << 9, /* touching pairs by graph colour: no two pairs of one colour share
                                   a moving body, so that they are solved in parallel */
    THUD_DRAW_MANIFOLDS = 1 << 10,   /* contact points with depth and impulse */
    THUD_DRAW_JOINTS = 1 << 11,      /* anchors, axes and limits */
    THUD_DRAW_JOINT_FORCES = 1 << 12 /* see THUD_STYLE_JOINT_FORCE */
};

/* What to draw, and the functions that draw. Shapes are drawn at their poses after the edits made
 * so far, everything else as the last step left it; drawing does not change the world. Null
 * functions are not called. `island` is the number of the shape's island, or -1 without
 * THUD_DRAW_ISLANDS and for bodies that are not awake. (c, s) are cosine and sine of an angle. */
typedef struct thud_debug_draw {
    unsigned flags;        /* what to draw; default 0: nothing */
    thud_pos origin;       /* all coordinates are relative to it */
    thud_pos lower, upper; /* corners of the view; shapes outside are skipped */
    void *context;         /* passed to the functions */
    void (*circle)(thud_vec2 center, float radius, float c, float s, thud_style style, int island,
                   void *context);
    void (*box)(thud_vec2 center, thud_vec2 half, float c, float s, thud_style style, int island,
                void *context);
    void (*line)(thud_vec2 a, thud_vec2 b, thud_style style, void *context);
    void (*point)(thud_vec2 p, thud_style style, void *context);
} thud_debug_draw;

/* Draws the world. Unknown flags do nothing. The world is locked while the functions are called.
 * THUD_ERROR_NULL; THUD_ERROR_INVALID if origin, lower or upper is not finite or out of the range
 * of body positions; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_MEMORY. */
THUD_API thud_result thud_world_draw(thud_world *world, const thud_debug_draw *draw);

#ifdef __cplusplus
}
#endif

#endif
