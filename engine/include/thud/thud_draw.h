/* thud_draw.h: a world drawn through the caller's functions, for viewers and tests. */
#ifndef THUD_DRAW_H
#define THUD_DRAW_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum thud_draw_style {
    THUD_DRAW_STATIC = 0,
    THUD_DRAW_KINEMATIC,
    THUD_DRAW_DYNAMIC,
    THUD_DRAW_SLEEPING,
    THUD_DRAW_SENSOR,
    THUD_DRAW_BOUNDS,
    THUD_DRAW_CELL,
    THUD_DRAW_CONTACT,
    THUD_DRAW_NORMAL,
    THUD_DRAW_INTERVAL,             /* of a shape's bounds along x; lines at the lower edge */
    THUD_DRAW_INTERVAL_OVERLAPPING, /* ... that overlaps another one's */
    THUD_DRAW_PAIR,                 /* line from centre to centre; bounds overlap */
    THUD_DRAW_PAIR_TOUCHING,        /* ... and so do the shapes */
    THUD_DRAW_MOTION,               /* outline of a swept volume */
    THUD_DRAW_PAIR_CANDIDATE,       /* line from centre to centre; only the fat bounds overlap */
    THUD_DRAW_DIRECT,               /* ...; the pair's island was solved directly */
    THUD_DRAW_MANIFOLD,             /* one point of a contact */
    THUD_DRAW_DEPTH,                /* line from it along the normal: as long as the penetration */
    THUD_DRAW_IMPULSE,              /* ...: as far as its impulse in a step, alone, would move the
                                       lighter of the two bodies in a second */
    THUD_DRAW_COLOUR, /* line from centre to centre of a pair of the solver's colour 0 */
    THUD_DRAW_COLOUR_LAST = THUD_DRAW_COLOUR + 15, /* ... 15, and of all further ones */
    THUD_DRAW_JOINT,       /* line from a body's centre to where a joint has it, or between both
                              places; points there */
    THUD_DRAW_JOINT_AXIS,  /* line: the x axis of frame a, where the joint has one */
    THUD_DRAW_JOINT_LIMIT, /* lines: between which places or angles b may be */
    THUD_DRAW_JOINT_FORCE, /* line from b's place: as far as the joint's force would move b alone
                              in a second, from rest */
    THUD_DRAW_STYLE_COUNT
} thud_draw_style;

enum {
    THUD_DRAW_SHAPES = 1 << 0,
    THUD_DRAW_SHAPE_BOUNDS = 1 << 1,
    THUD_DRAW_CELLS = 1 << 2, /* of the last step, that awake shapes lay in; only a grid has some */
    THUD_DRAW_CONTACTS = 1 << 3, /* points and normals */
    THUD_DRAW_ISLANDS = 1 << 4,  /* shapes carry their island's number, see `island`; and the pairs
                                    of islands that were solved directly */
    /* The order that a plane sweep kept in the last step: of each shape's bounds the interval along
     * x, side by side in rows from the lower edge of the view up, first of awake shapes, then of
     * resting ones. Where more than 12 overlap, bars lie upon each other. */
    THUD_DRAW_AXES = 1 << 5,
    THUD_DRAW_PAIRS = 1 << 6, /* of the last step's broadphase; to the ground straight down */
    /* The swept volumes of the last step, for each shape of a body that moved further than a
     * quarter of its smallest size: where it was, where it is, and the sides of their convex hull
     * that join the two. Of a body that collided on its way this is the straight way. */
    THUD_DRAW_MOTIONS = 1 << 7,
    THUD_DRAW_STAGES = 1 << 8,  /* pairs as THUD_DRAW_PAIRS, by how far they came: fat bounds
                                   overlap,  so do the true bounds, shapes touch */
    THUD_DRAW_COLOURS = 1 << 9, /* touching pairs by the solver's graph colour: no two pairs of one
                                   colour share a moving body, so that they are solved at once */
    THUD_DRAW_MANIFOLDS = 1 << 10, /* every point of every contact, its depth and its impulse */
    THUD_DRAW_JOINTS = 1 << 11,    /* places, axes and limits */
    THUD_DRAW_JOINT_FORCES = 1 << 12
};

/* Shapes are drawn where the edits made so far put them, all else as the last step left it, and
 * nothing changes. Null callbacks are skipped. `island` is -1 unless THUD_DRAW_ISLANDS is asked
 * for. Coordinates are relative to `origin`. */
typedef struct thud_debug_draw {
    unsigned flags;
    thud_pos origin;
    thud_pos lower, upper; /* shapes outside are skipped */
    void *context;
    void (*circle)(thud_vec2 center, float radius, float c, float s, thud_draw_style style,
                   int island, void *context);
    void (*box)(thud_vec2 center, thud_vec2 half, float c, float s, thud_draw_style style,
                int island, void *context);
    void (*line)(thud_vec2 a, thud_vec2 b, thud_draw_style style, void *context);
    void (*point)(thud_vec2 p, thud_draw_style style, void *context);
} thud_debug_draw;

/* THUD_ERROR_NULL; THUD_ERROR_INVALID where origin, lower or upper is not finite or farther out
 * than a body may be; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_MEMORY. Unknown flags do
 * nothing. */
THUD_API thud_result thud_world_draw(thud_world *world, const thud_debug_draw *draw);

#ifdef __cplusplus
}
#endif

#endif
