/* edit.h: what changes of bodies and shapes share; see thud_edits.h. They act at once on the
 * records and on what hangs on them, and leave the rest to the change list, as joints do. */
#ifndef TD_EDIT_H
#define TD_EDIT_H

#include "state/world.h"

/* The angle in (-pi, pi] whose cosine and sine these are, with the same bits everywhere. */
double td_edit_angle_of(double c, double s);

/* As td_find_body and td_find_shape; THUD_ERROR_LOCKED inside a callback. */
thud_result td_edit_body(const thud_world *w, thud_body_id id, td_body_index *index);
thud_result td_edit_shape(const thud_world *w, thud_shape_id id, int *index);

/* Whether a constraint is a contact of this shape; TD_NONE: of any. */
static inline bool td_edit_concerns(const td_constraint *constraint, int shape) {
    return td_is_contact(constraint) &&
           (shape == TD_NONE || constraint->shape_a == shape || constraint->shape_b == shape);
}

/* The body wakes with the next step, and so does whatever touches this shape of it. */
void td_edit_wake(thud_world *w, td_body_index body, int shape);

/* Ends contacts of a body's shape, of all its shapes where it is TD_NONE: those that may not be any
 * more, or, where `all` is set, each. Whom it touched wakes. There is room for their events. */
void td_edit_end_contacts(thud_world *w, td_body_index body, int shape, bool all);
/* False when memory is short. */
bool td_edit_ends_reserve(thud_world *w, td_body_index body, int shape, bool all);

/* Contacts of a shape, also of what sleeps, take the settings of their surfaces and their rules
 * anew. */
void td_edit_settle_contacts(thud_world *w, int shape);

/* Its shape looks for pairs that it has not got. */
void td_edit_look_around(thud_world *w, int shape);

/* Weighs the body anew, of which these were the inverse mass and inertia. Impulses that bore a
 * weight which it no longer has would throw it, so they shrink with it. */
void td_edit_weigh(thud_world *w, td_body_index body, float inv_mass, float inv_inertia);

#endif
