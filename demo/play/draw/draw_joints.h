/* draw_joints.h: joints over the bodies that they tie: hinges as discs, springs as zigzags, sliders
 * on their rails, limits as arcs. */
#ifndef THUD_PLAY_DRAW_JOINTS_H
#define THUD_PLAY_DRAW_JOINTS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

void draw_joints(canvas *c, const camera *view, session *s);
/* What each joint bears, the largest force in the picture with the longest arrow, and where joints
 * are open; the widest gap is told in figures. */
void draw_joint_forces(canvas *c, const camera *view, session *s);

#endif
