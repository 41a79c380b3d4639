/* thud_listeners.h: callbacks for contacts: the prologue before a contact is solved (pre-solve) and
 * the epilogue after it (post-solve), either called for each contact or once in a step for all; and
 * epilogues of single bodies and of categories of shapes. A prologue may also set the velocities
 * after a collision itself. A program links only the functions that it calls. For fixed behaviour
 * between kinds of shapes, the rules of thud_rules.h need no callbacks. */
#ifndef THUD_LISTENERS_H
#define THUD_LISTENERS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Called once in a step for every pair of shapes that touches or is about to touch, before it is
 * solved. If detection finds further collisions within the step, it is also called before each of
 * them is resolved (thud_detection_continuous calls it for static shapes in the order in which a
 * body meets them, up to the one that stops the body, and uses only the return value). It is not
 * called for pairs that a one-way or ignore rule lets pass. Each segment of a terrain makes a pair
 * of its own. Returns whether the pair collides; false: the pair has no effect in this step. */
typedef bool thud_prologue_fn(thud_world *world, const thud_contact *contact,
                              thud_contact_settings *settings, void *context);
/* Called after the motion of the step for every touching pair that was solved, then for every pair
 * whose velocities the prologue decided (thud_contact_decide), then for every collision that was
 * resolved within the step. */
typedef void thud_epilogue_fn(thud_world *world, const thud_contact *contact, void *context);

/* The answer of a prologue about a pair. */
typedef struct thud_contact_answer {
    thud_contact_settings settings; /* its surface in this step */
    bool collide;                   /* false: the pair has no effect in this step */
} thud_contact_answer;

/* The same for all pairs of a step in one call, for languages with slow callbacks. `answers` has an
 * element for each contact, which initially has the values of its shapes, and which the callback
 * may change. Collisions that detection finds within the step are passed one by one, with a count
 * of 1. */
typedef void thud_prologue_all_fn(thud_world *world, const thud_contact *contacts,
                                  thud_contact_answer *answers, int count, void *context);
/* The epilogues of all pairs of a step in one call. */
typedef void thud_epilogue_all_fn(thud_world *world, const thud_contact *contacts, int count,
                                  void *context);

/* The fields of thud_contact that take longest to compute. A listener that does not need them can
 * save this time. Where all contacts of a heap have a prologue and an epilogue with all fields, a
 * step takes 1.11 times as long as without. */
typedef enum thud_contact_part {
    THUD_CONTACT_BODIES = 1, /* body_a and body_b */
    THUD_CONTACT_POINT = 2   /* point */
} thud_contact_part;

/* The callbacks of a world. Null: none. Of prologue and epilogue, at most one of the two forms may
 * be set. */
typedef struct thud_listeners {
    thud_prologue_fn *prologue;
    thud_epilogue_fn *epilogue;
    thud_prologue_all_fn *prologue_all;
    thud_epilogue_all_fn *epilogue_all;
    void *context; /* passed to all */
    /* A sum of thud_contact_part: fields that these listeners never read. They are then not
     * computed, and may be zero. Default 0: all fields are set. */
    uint32_t without;
} thud_listeners;

/* Replaces the listeners of the world from the next step on; null: none. If the old or the new
 * listeners have a prologue, all bodies wake. A snapshot contains the prologue's answers about
 * touching pairs: a world without a prologue that is restored from it keeps these answers until the
 * pairs part. The world is locked during the callbacks: edits wait for the next step, or are
 * refused. The epilogues of bodies and categories, below, stay as they are. THUD_ERROR_NULL for a
 * null world, THUD_ERROR_INVALID for both forms of a prologue or epilogue or an unknown part,
 * THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a callback: then nothing has changed. */
THUD_API thud_result thud_world_set_listeners(thud_world *world, const thud_listeners *listeners);

/* ---- epilogues of single objects ---- */

/* Called for a contact of a body, or of a shape of a category, that has such an epilogue. It is
 * called for the same contacts as the epilogue of the world, with all fields of the contact, and
 * after it: directly after the call for the same contact, or after the one call for all contacts.
 * `side`: 0 if the object is a of the contact, 1 if it is b. For one contact, the epilogues of a
 * are called first (its body's, then those of its shape's categories, in the order in which they
 * were first set), then those of b. It is not called for a body that a callback of this step has
 * destroyed. Sensors have no contacts, and so no epilogues: for them see thud_events.h. */
typedef void thud_object_epilogue_fn(thud_world *world, const thud_contact *contact, int side,
                                     void *context);

/* Sets the epilogue of a body of any kind, from the next step on. It replaces the one that the body
 * had; null removes it. No body wakes, and no motion changes. It is removed when the body is
 * destroyed. Epilogues are not part of a snapshot: after thud_world_restore a body has the one that
 * was set for its handle, unless it had been destroyed for a step or more in between.
 * THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a callback: then
 * nothing has changed. */
THUD_API thud_result thud_body_set_epilogue(thud_world *world, thud_body_id body,
                                            thud_object_epilogue_fn *epilogue, void *context);

/* Sets the epilogue of all shapes whose filter has one of these categories (thud_filter.category)
 * when a step ends. It replaces the epilogue that was set for exactly these categories; null
 * removes it. If several epilogues have a category in common, each is called. Not part of a
 * snapshot. THUD_ERROR_NULL, THUD_ERROR_INVALID for no category, THUD_ERROR_MEMORY,
 * THUD_ERROR_LOCKED inside a callback: then nothing has changed. */
THUD_API thud_result thud_world_set_category_epilogue(thud_world *world, uint32_t categories,
                                                      thud_object_epilogue_fn *epilogue,
                                                      void *context);

/* ---- a prologue that decides the response ---- */

/* The velocities of a body right after a collision. Each component is clamped to the maximum speed
 * of the world, or THUD_ANGULAR_SPEED_MAX. */
typedef struct thud_velocities {
    thud_vec2 velocity;     /* of the centre of mass, length/s */
    float angular_velocity; /* rad/s; taken as 0 if the body's rotation is fixed */
} thud_velocities;

/* Inside a prologue: sets the velocities after the collision by the caller's own law, in place of
 * friction and restitution: for a pinball's kicker, a bat, or a portal that turns a body's
 * velocity. `contact` is the pointer that the prologue was given, or points into the list of
 * prologue_all. If `a` or `b` is null, the velocities of that body do not change. A body whose
 * velocities are given must be dynamic, and wakes; those of static and kinematic bodies cannot be
 * decided.
 *
 * A decided pair has no other effect in this step, as if it were vetoed, whatever the prologue
 * returns: neither the substeps nor direct islands solve it, and no detection stops its bodies at
 * each other. The next step calls the prologue for the pair again. The decision takes effect
 * - for a pair that touches or is about to touch as the step begins: before the step is solved.
 *   Gravity, damping, joints, other contacts and the maximum speed then act on the new velocities
 *   as usual. Such a pair makes no hit event and no impulse event;
 * - for a collision that thud_detection_bisect or thud_detection_swept finds within the step: at
 *   the time of that collision; the bodies move at these velocities for the rest of the step. If
 *   one of the two bodies sleeps or has joints, the decision has no effect, and the next step calls
 *   the prologue again;
 * - for a collision that thud_detection_continuous finds: not at all. The body stops there, with
 *   the velocity that it had, and the next step calls the prologue again.
 *
 * The epilogue is called for a decided pair, with the impulses that would give these velocities to
 * b, or to a if b does not change. thud_step_error.energy_decided has the change of kinetic energy
 * by decisions. If there are several decisions for a body or a contact in a step, the last one
 * holds. Snapshots contain the velocities, and the decision as a veto of the pair.
 *
 * THUD_ERROR_NULL where the world, the contact or both of `a` and `b` are null; THUD_ERROR_INVALID
 * for a contact for which no prologue is being called, for a body that is not dynamic, and for
 * velocities that are not finite; THUD_ERROR_MEMORY. The velocities are then not set, and the pair
 * is solved according to the prologue's answer. */
THUD_API thud_result thud_contact_decide(thud_world *world, const thud_contact *contact,
                                         const thud_velocities *a, const thud_velocities *b);

#ifdef __cplusplus
}
#endif

#endif
