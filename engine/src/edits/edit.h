/* edit.h: what the setters of thud_edits.h share. A setter changes the record of the body or shape
 * and its contacts at once, and puts the body on the list of changes (td_body_mark), which the next
 * step processes. All are refused inside callbacks. */
#ifndef TD_EDIT_H
#define TD_EDIT_H

#include "state/world.h"

/* As td_find_body and td_find_shape, but THUD_ERROR_LOCKED inside a callback. */
thud_result td_edit_body(const thud_world *w, thud_body_id id, td_body_index *index);
thud_result td_edit_shape(const thud_world *w, thud_shape_id id, int *index);

/* Whether a constraint is a contact of this shape, or of any shape where it is TD_NONE. */
static inline bool td_edit_concerns(const td_constraint *constraint, int shape) {
    return td_is_contact(constraint) &&
           (shape == TD_NONE || constraint->shape_a == shape || constraint->shape_b == shape);
}

/* Makes the next step wake the body and all bodies that touch this shape of it (TD_NONE: any of its
 * shapes). */
void td_edit_wake(thud_world *w, td_body_index body, int shape);

/* Ends the contacts of a body's shape (TD_NONE: of all its shapes) that its filter no longer
 * allows; with `all` every one. The bodies that it touched wake. td_edit_ends_reserve has reserved
 * room for the end events. */
void td_edit_end_contacts(thud_world *w, td_body_index body, int shape, bool all);
/* Reserves room for the end events of td_edit_end_contacts with the same arguments. False when
 * memory is short. */
bool td_edit_ends_reserve(thud_world *w, td_body_index body, int shape, bool all);

/* Recomputes friction, restitution, surface speed and rule of those contacts of a shape that act
 * (TD_TOUCHING), of sleeping bodies as well. */
void td_edit_settle_contacts(thud_world *w, int shape);

/* Makes the broadphase of the next step search for new pairs of the shape. */
void td_edit_look_around(thud_world *w, int shape);

/* Recomputes the mass of the body; inv_mass and inv_inertia are the inverses before the edit. If
 * the body has become lighter, the impulses with which its constraints start the next step are
 * scaled by the ratio of the new mass to the old one (or of the moments of inertia, if that ratio
 * is smaller): the impulses that carried the old weight would throw the body up. */
void td_edit_weigh(thud_world *w, td_body_index body, float inv_mass, float inv_inertia);

#endif
