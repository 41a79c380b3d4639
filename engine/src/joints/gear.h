/* gear.h: functions of gears that other files of this folder call. */
#ifndef TD_GEAR_H
#define TD_GEAR_H

#include "joints/joint.h"

/* Whether the coordinate of this joint in a gear is its rotation (hinges, wheels), not a length. */
bool td_gear_by_angle(const td_joint *joint);
/* Whether both of the gear's joints exist. */
bool td_gear_has_joints(const thud_world *w, const td_joint *gear);
/* Sets td_gear.rest so that the present coordinates of both joints satisfy the gear's equation. */
void td_gear_set_rest(const thud_world *w, td_joint *gear);
/* The gap q0 + ratio q1 - rest, in units of the first joint's coordinate. */
double td_gear_gap(const thud_world *w, const td_joint *gear);
/* J M^-1 J' of the gear's row: the inverse of its effective mass. */
float td_gear_inverse_mass(const thud_world *w, const td_block *block, int lane);

/* The operations of the kind, for the world's instruction set. */
const td_constraint_ops *td_gear_ops(const thud_world *w);

#endif
