/* debug_draw.h: the parts of thud_world_draw and the helpers that they share. Every part calls the
 * caller's functions in thud_debug_draw with coordinates relative to thud_debug_draw.origin. */
#ifndef TD_DEBUG_DRAW_H
#define TD_DEBUG_DRAW_H

#include "state/world.h"

/* One call of thud_world_draw. */
typedef struct td_drawing {
    const thud_world *w;
    const thud_debug_draw *draw;      /* the caller's flags and functions */
    td_position origin, lower, upper; /* those of `draw`, in fixed point; lower and upper are the
                                         corners of the view */
} td_drawing;

/* drawing.c */
/* A position relative to the drawing's origin, length. */
thud_vec2 td_drawing_local(const td_drawing *d, td_position p);

/* Draws a box whose sides are given in quanta of td_bounds (2^TD_COARSE_SHIFT units of
 * td_position). */
void td_drawing_bounds(const td_drawing *d, int64_t min_x, int64_t min_y, int64_t max_x,
                       int64_t max_y, thud_style style);
/* Draws a line, if the caller gave a function for lines. */
void td_drawing_line(const td_drawing *d, thud_vec2 a, thud_vec2 b, thud_style style);

/* Draws a line between the centres of a contact's two shapes, or of the two bodies of another
 * constraint; from a terrain the line begins at the point of the contact's segment with the x
 * nearest to the shape's centre. */
void td_drawing_pair(const td_drawing *d, const td_constraint *constraint, thud_style style);

/* draw_detection.c: cells, intervals and pairs of the broadphase, and swept motions. The broadphase
 * must hold the present bounds (td_broadphase_refresh). */
void td_draw_cells(const td_drawing *d);
void td_draw_intervals(const td_drawing *d);
void td_draw_pairs(const td_drawing *d);
void td_draw_stages(const td_drawing *d);
void td_draw_motions(const td_drawing *d);

/* draw_contacts.c: contacts, directly solved islands, graph colours and manifolds of the last step.
 */
void td_draw_contacts(const td_drawing *d);
void td_draw_direct(const td_drawing *d);
void td_draw_colours(const td_drawing *d);
void td_draw_manifolds(const td_drawing *d);

#endif
