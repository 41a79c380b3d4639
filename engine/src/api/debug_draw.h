/* debug_draw.h: what the parts of drawing share. */
#ifndef TD_DEBUG_DRAW_H
#define TD_DEBUG_DRAW_H

#include "state/world.h"

typedef struct td_drawing {
    const thud_world *w;
    const thud_debug_draw *draw;
    td_position origin, lower, upper;
} td_drawing;

/* drawing.c */
/* A position as callbacks get it: relative to the drawing's origin. */
thud_vec2 td_drawing_local(const td_drawing *d, td_position p);

/* A box given in bounds quanta. */
void td_drawing_bounds(const td_drawing *d, int64_t min_x, int64_t min_y, int64_t max_x,
                       int64_t max_y, thud_draw_style style);
/* A line, where there is somebody to draw it. */
void td_drawing_line(const td_drawing *d, thud_vec2 a, thud_vec2 b, thud_draw_style style);

/* A line from shape to shape of a pair, or between the bodies of another constraint; from a terrain
 * straight up or down. */
void td_drawing_pair(const td_drawing *d, const td_constraint *constraint, thud_draw_style style);

/* draw_detection.c: what detection goes by. The broadphase must hold the present bounds. */
void td_draw_cells(const td_drawing *d);
void td_draw_intervals(const td_drawing *d);
void td_draw_pairs(const td_drawing *d);
void td_draw_stages(const td_drawing *d);
void td_draw_motions(const td_drawing *d);

/* draw_contacts.c: what the solver goes by. */
void td_draw_contacts(const td_drawing *d);
void td_draw_direct(const td_drawing *d);
void td_draw_colours(const td_drawing *d);
void td_draw_manifolds(const td_drawing *d);

#endif
