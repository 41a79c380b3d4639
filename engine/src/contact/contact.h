/* contact.h: contacts: pairs of shapes whose fat bounds overlap. A contact exists from the step in
 * which the bounds first overlap to the one in which they part; while its shapes touch, it holds a
 * lane. */
#ifndef TD_CONTACT_H
#define TD_CONTACT_H

#include "constraint/constraint.h"

/* The pair kind of two shapes. Swaps the two indices where the kind needs the other order: a static
 * shape comes first, and so do a terrain, a sensor, and the box of a box and a circle. */
td_pair_kind td_pair_of(const thud_world *w, int *shape_a, int *shape_b);
/* Whether two shapes may make a contact. False for shapes of the same body or of a disabled one,
 * where neither body is dynamic (for a sensor: where both are static), and where filters, rules or
 * a joint keep the two from colliding. */
bool td_pair_allowed(const thud_world *w, int shape_a, int shape_b);

/* Whether one of two shapes was set to make no contact events (TD_SHAPE_SILENT). */
bool td_pair_is_silent(const thud_world *w, int shape_a, int shape_b);

/* Whether the fat bounds of two shapes, neither a terrain, overlap. Bounds wrap around after 2^32
 * bounds quanta, so that bounds that are far apart may seem to overlap in a vast world
 * (thud_world.vast); there the exact positions are compared, too. */
bool td_pair_meets(const thud_world *w, int shape_a, int shape_b);

/* Whether the fat bounds of a contact's shapes still overlap; if not, the contact is to be
 * destroyed. For a terrain only the segment of the contact counts. */
bool td_contact_bounds_meet(const thud_world *w, const td_contact *contact);

void td_contact_create(thud_world *w, td_pair_kind kind, int shape_a, int shape_b, int child);
/* Marks a contact as begun (it touches, or overlaps a sensor), and adds its begin event unless a
 * shape of it makes no events. Room in world.events must be reserved. */
void td_contact_begin(thud_world *w, int contact);
/* Marks a contact as ended, and adds its end event if it had a begin event. td_contact_end_reserve
 * must have made room. */
void td_contact_end(thud_world *w, int contact);
/* Ends and destroys a contact, or destroys the constraint of a joint, which has no events. */
void td_contact_destroy(thud_world *w, int constraint);
/* Destroys the contacts of the body, or only those of one of its shapes (`shape` not TD_NONE); with
 * `joints` also the constraints of its joints. */
void td_contacts_destroy(thud_world *w, td_body_index body, int shape, bool joints);
/* Makes room for the end events of `more` further contacts; for 0 it does nothing. False when
 * memory is short. */
bool td_contact_end_reserve(thud_world *w, int more);
/* Whether edits that wait for the next step will end the contact, or the constraint of a joint. */
bool td_contact_is_ending(const thud_world *w, const td_constraint *constraint);
/* Appends the event of a sensor's pair to `list`, and its time to `times`, both of which have room.
 * Of two sensors each gets an event. `time`: 0 at the start of the step to 1 at its end. */
void td_sensor_tell(thud_world *w, td_array *list, td_array *times, int shape_a, int shape_b,
                    float time);
/* Ends a touching contact, whose bounds still overlap: removes it from its lane, makes it wait, and
 * adds its end event. */
void td_contact_part(thud_world *w, int contact);

/* The public record of a contact between two shapes that have no lane, as for an impact that
 * detection finds. `at` is the middle between their closest points, `distance` their distance,
 * length. */
thud_contact td_contact_between(const thud_world *w, int shape_a, int shape_b, td_position at,
                                thud_vec2 normal, double distance);

/* The speed of a hit event, length/s: the closing speed, or FLT_MAX where that, the difference of
 * two great velocities, has overflowed to infinity. */
static inline float td_hit_speed(float closing_speed) {
    return closing_speed <= FLT_MAX ? closing_speed : FLT_MAX;
}

/* contact_view.c: the public view of a lane. Its point_count is 0 where the lane is muted
 * (td_surface_mute); separation and point mean nothing then. */
thud_contact td_contact_view(const thud_world *w, td_block *block, int lane);
/* The normal velocity at which the two bodies close at a point of a lane, length/s, for their
 * present velocities; negative where they part. */
float td_contact_closing_speed(const thud_world *w, const td_block *block, const td_point *p,
                               int lane);

#endif
