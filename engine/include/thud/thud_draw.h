/* thud_draw.h: a world drawn through the caller's functions, for viewers and tests. */
#ifndef THUD_DRAW_H
#define THUD_DRAW_H

#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct thud_world thud_world;

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
    THUD_DRAW_STYLE_COUNT
} thud_draw_style;

enum {
    THUD_DRAW_SHAPES = 1 << 0,
    THUD_DRAW_SHAPE_BOUNDS = 1 << 1,
    THUD_DRAW_CELLS = 1 << 2,
    THUD_DRAW_CONTACTS = 1 << 3, /* points and normals */
    THUD_DRAW_ISLANDS = 1 << 4   /* shapes carry their island's number, see `island` */
};

/* Null callbacks are skipped. `island` is -1 unless THUD_DRAW_ISLANDS is asked for. Coordinates
 * are relative to `origin`. */
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

thud_result thud_world_draw(thud_world *world, const thud_debug_draw *draw);

#ifdef __cplusplus
}
#endif

#endif
