/* thud_lists.h: what there is in a world, as lists of handles: all bodies and shapes, who is awake,
 * who has moved, what a sensor overlaps; whose the shapes of an event are, and who met whom.
 * Included by whoever uses it.
 *
 * A list is written to an array of the caller's: *count is how many there are, and as many as there
 * is room for (`capacity` >= 0) are written, in the order of their slots, the lowest first. `out`
 * may be null where capacity is 0, so that a program may ask for the count first:
 *
 *     int count;
 *     thud_world_bodies(world, NULL, 0, &count);
 *     thud_body_id *bodies = malloc((size_t)count * sizeof *bodies);
 *     thud_world_bodies(world, bodies, count, &count);
 *
 * Lists have what was created so far and lack what was destroyed, whether or not a step has been
 * made since. All calls may be made inside a callback. They allocate nothing, change nothing in the
 * world, and cost a step nothing. THUD_ERROR_NULL where world, count or, with a capacity, `out` is
 * null, THUD_ERROR_INVALID where capacity is negative: outputs are then as they were. */
#ifndef THUD_LISTS_H
#define THUD_LISTS_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- all there is: each a pass over the slots ---- */

/* Disabled and quarantined ones too. */
THUD_API thud_result thud_world_bodies(const thud_world *world, thud_body_id *out, int capacity,
                                       int *count);
/* Those of which thud_body_state says `awake`: dynamic and kinematic bodies that the next step will
 * move if something has them move. Inside a callback as the step under way has them. */
THUD_API thud_result thud_world_awake_bodies(const thud_world *world, thud_body_id *out,
                                             int capacity, int *count);
/* Sensors and terrains too, and those that were made inside a callback and wait for the next step.
 */
THUD_API thud_result thud_world_shapes(const thud_world *world, thud_shape_id *out, int capacity,
                                       int *count);

/* ---- from slot to handle ---- */

/* How many slots were ever used: every live body and shape has one below. That of a body is its row
 * in thud_world_poses, index1 - 1. Either may be null. Fewer again after thud_world_restore only.
 */
THUD_API thud_result thud_world_slots(const thud_world *world, int *bodies, int *shapes);
/* The null handle where nothing lives in the slot. THUD_ERROR_INVALID for a slot that is negative,
 * or was never used; THUD_ERROR_NULL. */
THUD_API thud_result thud_world_body_at(const thud_world *world, int slot, thud_body_id *out);
THUD_API thud_result thud_world_shape_at(const thud_world *world, int slot, thud_shape_id *out);

/* ---- who has moved ---- */

/* Where a body was when it was last told of, for thud_world_moved_bodies. All zero: never. */
typedef struct thud_body_seen {
    thud_body_id body;
    int64_t x, y, angle; /* of its origin; in units of the engine's own */
} thud_body_seen;

/* Bodies that are not as `seen` has them, so that a renderer, a network or a spatial index of the
 * caller's touches no others: those that are new to it, and those whose position or angle, as
 * thud_body_get gives them, is another to the last bit. `seen` is the caller's, an element a body
 * slot, zeroed before its first use, and brought up to date for each body that is written to `out`:
 * those for which there was no room are told by the next call.
 *
 *     thud_body_seen *seen = calloc((size_t)slots, sizeof *seen);
 *     ... each frame, after its steps:
 *     thud_world_moved_bodies(world, seen, slots, moved, room, &count);
 *
 * Asked after each step it tells what that step moved, and what was edited since the one before;
 * asked after several, what all of them did: what is back where it was has not moved.
 * - A created body is told once, and so is one that got the slot of another.
 * - One that was set elsewhere is told at once, or after the next step where that was inside a
 *   callback.
 * - Waking, falling asleep, being enabled or disabled is no motion. The step at whose end a body
 *   falls asleep may still have moved it, and then it is told. A quarantined one stays put.
 * - A shape that comes or goes moves the centre of mass, not the origin.
 * - A destroyed body is not told of, and `seen` forgets it. After a restore those are told that are
 *   back, or elsewhere than they were last told to be.
 *
 * A renderer that draws between two steps (thud_world_poses with alpha < 1) touches what is told,
 * and once more what was told the time before: what has stopped was drawn on its way there.
 *
 * A pass over `slots`; bodies in slots from there on are left out and not counted, see
 * thud_world_slots. THUD_ERROR_NULL where `seen` is null and `slots` is not 0, THUD_ERROR_INVALID
 * where `slots` is negative. */
THUD_API thud_result thud_world_moved_bodies(const thud_world *world, thud_body_seen *seen,
                                             int slots, thud_body_id *out, int capacity,
                                             int *count);

/* ---- what a sensor overlaps ---- */

/* The shapes that the sensor overlaps: those of which a sensor_begin told and no sensor_end yet
 * (thud_events.h), a terrain once. So they are what the last step found as it ended, inside a
 * callback too. What was destroyed or disabled since is left out at once;
 * all else follows with the next step at the latest. A pass over the contacts of the sensor's body.
 * THUD_ERROR_STALE; THUD_ERROR_INVALID for a shape that is no sensor. */
THUD_API thud_result thud_sensor_overlaps(const thud_world *world, thud_shape_id sensor,
                                          thud_shape_id *out, int capacity, int *count);

/* ---- whose the shapes of a contact or an event are ---- */

typedef struct thud_pair_side {
    thud_body_id body;              /* null: the shape has been destroyed, and all else is 0 */
    uint64_t body_data, shape_data; /* the user data of either */
    bool sensor;
} thud_pair_side;

typedef struct thud_pair {
    thud_pair_side a, b;
} thud_pair;

/* Of the two shapes of a thud_contact, thud_manifold, thud_contact_event or thud_hit_event, as they
 * are now. A shape of an event may have been destroyed since, and of an end event that is often why
 * it ended: no error, its side is all zero, as that of any handle that names nothing. What a
 * program wants to know of what is gone it keeps itself, by slot (index1 - 1). THUD_ERROR_NULL. */
THUD_API thud_result thud_pair_get(const thud_world *world, thud_shape_id shape_a,
                                   thud_shape_id shape_b, thud_pair *out);

/* ---- who met whom ---- */

/* Two shapes of two kinds that met in the last step or thud_world_advance. All zero before the
 * first one. */
typedef struct thud_met {
    thud_shape_id shape_a, shape_b;
    thud_pair_side a, b; /* a is of the first kind, whatever the event's order */
    int next;            /* how far thud_world_next_meeting has come; no event is below 0 */
} thud_met;

/* The next pair of two kinds, by the categories of shapes (bits of thud_filter.category), that
 * began to touch or hit each other in the last step, be they apart again, or of which one is a
 * sensor that began to overlap the other; false, and all but `next` is zero, where there is none
 * any more:
 *
 *     for (thud_met m = {0}; thud_world_next_meeting(world, BRICK, BALL, &m);)
 *         thud_body_destroy(world, m.a.body);
 *
 * A step tells a pair once; a bounce that hits in one step and touches in the next is told in both.
 * Where one was destroyed since, also by the caller and between two meetings, there was none. A
 * pair that is of the two kinds either way is told as its event has it. Each call goes on through
 * the events (thud_events.h), and compares what it found with those before. False, too, where world
 * or meeting is null or `next` is negative, which the log hears. */
THUD_API bool thud_world_next_meeting(const thud_world *world, uint32_t first, uint32_t second,
                                      thud_met *meeting);

#ifdef __cplusplus
}
#endif

#endif
