/* draw_joints.h: draws joints over the bodies that they connect: hinges as discs, springs as
 * zigzags, sliders on their rails, limits as arcs. */
#ifndef THUD_PLAY_DRAW_JOINTS_H
#define THUD_PLAY_DRAW_JOINTS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

void draw_joints(canvas *c, const camera *view, session *s);
/* Draws the force of each joint as an arrow, whose length is relative to the largest force in view,
 * and rings at open joints. The widest gap is written as a number. */
void draw_joint_forces(canvas *c, const camera *view, session *s);

#endif
