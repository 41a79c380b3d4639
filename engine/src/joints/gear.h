/* gear.h: what gears have that other joints have not. */
#ifndef TD_GEAR_H
#define TD_GEAR_H

#include "joints/joint.h"

/* Whether a gear goes by the turn of this joint, and not by its length. */
bool td_gear_by_angle(const td_joint *joint);
/* Both its joints are there. */
bool td_gear_has_joints(const thud_world *w, const td_joint *gear);
/* It holds what its joints have now. */
void td_gear_set_rest(const thud_world *w, td_joint *gear);
/* By how much it is off, as the first joint has its value. */
double td_gear_gap(const thud_world *w, const td_joint *gear);
/* 1 / the mass that its row feels. */
float td_gear_inverse_mass(const thud_world *w, const td_block *block, int lane);

const td_constraint_ops *td_gear_ops(const thud_world *w);

#endif
