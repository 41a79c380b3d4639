/* thud_lists.h: lists of handles: all bodies and shapes of a world, awake bodies, moved bodies, and
 * the shapes that a sensor overlaps; also the bodies of the two shapes of an event, and pairs of
 * shapes of two categories that met. thud.h does not include this header.
 *
 * A list is written to an array of the caller. *count is the number of all elements; at most
 * `capacity` (>= 0) of them are written, in ascending order of slots. `out` may be null where
 * capacity is 0, to get the count first:
 *
 *     int count;
 *     thud_world_get_bodies(world, NULL, 0, &count);
 *     thud_body_id *bodies = malloc((size_t)count * sizeof *bodies);
 *     thud_world_get_bodies(world, bodies, count, &count);
 *
 * Lists contain all objects that have been created and not destroyed, whether or not a step has run
 * since. All calls are allowed inside a callback. They allocate nothing, do not change the world,
 * and add no cost to a step. THUD_ERROR_NULL if world, count or, with a capacity above 0, `out` is
 * null, THUD_ERROR_INVALID if capacity is negative: outputs are then not written. */
#ifndef THUD_LISTS_H
#define THUD_LISTS_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- all bodies and shapes: each call is a pass over the slots ---- */

/* All bodies, disabled and quarantined ones included. */
THUD_API thud_result thud_world_get_bodies(const thud_world *world, thud_body_id *out, int capacity,
                                           int *out_count);
/* Bodies with thud_body_state.awake: the dynamic and kinematic bodies that the next step
 * integrates. Inside a callback, those of the present step. */
THUD_API thud_result thud_world_get_awake_bodies(const thud_world *world, thud_body_id *out,
                                                 int capacity, int *out_count);
/* All shapes, including sensors, terrains, and shapes that were created inside a callback and wait
 * for the next step. */
THUD_API thud_result thud_world_get_shapes(const thud_world *world, thud_shape_id *out,
                                           int capacity, int *out_count);

/* ---- from slot to handle ---- */

/* The number of slots that have ever been used: the slots of all bodies and shapes are below it.
 * The slot of a body is its index in thud_world_get_poses, index1 - 1. Either output may be null.
 * Only thud_world_restore can decrease the numbers. */
THUD_API thud_result thud_world_get_slot_counts(const thud_world *world, int *out_bodies,
                                                int *out_shapes);
/* Both calls: the handle of the body or shape in a slot, or the null handle. THUD_ERROR_INVALID for
 * a slot that is negative or was never used; THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_body_at(const thud_world *world, int slot, thud_body_id *out);
THUD_API thud_result thud_world_get_shape_at(const thud_world *world, int slot, thud_shape_id *out);

/* ---- bodies that have moved ---- */

/* The pose of a body when thud_world_get_moved_bodies last listed it. All zero: it was never
 * listed. */
typedef struct thud_body_seen {
    thud_body_id body;
    int64_t x, y;  /* of its origin, in fixed-point units of the engine */
    int64_t angle; /* in fixed-point units of the engine */
} thud_body_seen;

/* Lists the bodies whose pose differs from the one in `seen`, so that a renderer, a network layer
 * or a spatial index need not process the others: bodies that are not in `seen` yet, and bodies
 * whose position or angle, as in thud_body_get_state, differs in any bit. `seen` is an array of the
 * caller with an element for each body slot, zeroed before its first use. The call updates it for
 * each body that it writes to `out`; bodies for which there was no room are listed by the next
 * call.
 *
 *     thud_body_seen *seen = calloc((size_t)slots, sizeof *seen);
 *     ... each frame, after its steps:
 *     thud_world_get_moved_bodies(world, seen, slots, moved, room, &count);
 *
 * A call after each step lists the bodies that this step, or edits since the previous call, have
 * moved. A call after several steps lists the bodies whose pose has changed over all of them: a
 * body that is back in its old pose is not listed.
 * - A new body is listed once, also in the slot of an old one.
 * - A body that thud_body_set_transform moved is listed at once; if that was inside a callback,
 * after the next step.
 * - Waking, falling asleep, enabling and disabling are not motion. The step at whose end a body
 * falls asleep may still have moved it: then it is listed. A quarantined body does not move.
 * - A shape that is added or destroyed moves the centre of mass, not the origin.
 * - A destroyed body is not listed, and its element of `seen` becomes zero. After a restore, bodies
 * are listed that exist again, or whose pose differs from the one last listed.
 *
 * A renderer that interpolates (thud_world_get_poses with alpha < 1) must update the listed bodies
 * and those of the call before: a body that has stopped was last drawn before its final pose.
 *
 * The call is a pass over `slots` slots; bodies in higher slots are left out and not counted, see
 * thud_world_get_slot_counts. THUD_ERROR_NULL where `seen` is null and `slots` is not 0,
 * THUD_ERROR_INVALID where `slots` is negative. */
THUD_API thud_result thud_world_get_moved_bodies(const thud_world *world, thud_body_seen *seen,
                                                 int slots, thud_body_id *out, int capacity,
                                                 int *out_count);

/* ---- overlaps of a sensor ---- */

/* The shapes that a sensor overlaps: those with a sensor_begin event and no sensor_end event yet
 * (thud_events.h), a terrain once. So the list is that at the end of the last step, also inside a
 * callback. Shapes that were destroyed or disabled since are left out at once; other changes appear
 * with the next step. The call is a pass over the contacts of the sensor's body. THUD_ERROR_STALE;
 * THUD_ERROR_INVALID for a shape that is not a sensor. */
THUD_API thud_result thud_shape_get_sensor_overlaps(const thud_world *world, thud_shape_id sensor,
                                                    thud_shape_id *out, int capacity,
                                                    int *out_count);

/* ---- the bodies of the shapes of a contact or an event ---- */

/* One of two shapes. */
typedef struct thud_pair_side {
    thud_body_id body;              /* null: the shape has been destroyed, and all fields are 0 */
    uint64_t body_data, shape_data; /* user data of body and shape */
    bool sensor;                    /* the shape is a sensor */
} thud_pair_side;

/* Two shapes of a contact or an event. */
typedef struct thud_pair {
    thud_pair_side a, b;
} thud_pair;

/* The two sides of a pair, for the shapes of a thud_contact, thud_manifold, thud_contact_event or
 * thud_hit_event, in their present state. A handle that names no shape is not an error: its side is
 * all zero. A shape of an event may have been destroyed since, which is often the cause of an end
 * event. A program that needs data of destroyed shapes must store it itself, by slot (index1 - 1).
 * THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_pair(const thud_world *world, thud_shape_id shape_a,
                                         thud_shape_id shape_b, thud_pair *out);

/* ---- pairs of two categories that met ---- */

/* Two shapes that met in the last step or thud_world_advance, and the state of the iteration. All
 * zero before the first call. */
typedef struct thud_event_pair {
    thud_shape_id shape_a, shape_b;
    thud_pair_side a, b; /* a is of the first category, whatever the order of the event */
    int next;            /* number of the event from which the next call continues, >= 0 */
} thud_event_pair;

/* Finds the next pair of shapes with categories of `first` and `second` (bits of
 * thud_filter.category) that began to touch or hit each other in the last step or
 * thud_world_advance, even if they are apart again, or of which one is a sensor that began to
 * overlap the other. If there are no more, the result is false, and all fields but `next` are zero:
 *
 *     for (thud_event_pair m = {0}; thud_world_next_event_pair(world, BRICK, BALL, &m);)
 *         thud_body_destroy(world, m.a.body);
 *
 * A pair is returned once for each thud_world_step or thud_world_advance, even if it met in several
 * of its steps. A pair with a destroyed shape is not returned, even if the caller destroyed
 * it between two calls. A pair that matches the categories in both orders is returned in the order
 * of its event. Each call continues the search through the events (thud_events.h), and compares a
 * pair that it finds with the earlier events. The result is also false, and the reason is logged,
 * if world or pair is null or `next` is negative. */
THUD_API bool thud_world_next_event_pair(const thud_world *world, uint32_t first, uint32_t second,
                                         thud_event_pair *pair);

#ifdef __cplusplus
}
#endif

#endif
