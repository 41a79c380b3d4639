/* thud_snapshot.h: going back in time: a world's whole state as plain bytes. For networked play
 * that predicts and corrects, for rewinding, for saved games. Included by whoever uses it.
 *
 *     size_t bytes;
 *     thud_world_snapshot_size(world, &bytes);
 *     void *buffer = malloc(bytes);
 *     thud_world_snapshot(world, buffer, bytes, NULL);
 *     ... steps, edits ...
 *     thud_world_restore(world, buffer, bytes);
 *
 * After a restore every call gives what it gave the first time, to the last bit: poses, events,
 * errors, hash and the handles of what is made then. So a game that keeps a snapshot and the calls
 * that followed can play them again, with other ones in between. Only time and memory are the
 * machine's: stats.bytes, stats.step_allocations and the seconds of stages; and a time_budget,
 * which goes by the clock.
 *
 * A snapshot has what can change in a running world: bodies, shapes, the lines of terrains,
 * contacts with their impulses, who sleeps, edits that wait for the next step, the events that are
 * told, the time that thud_world_advance left over and the forces in it, the settings that have a
 * setter (gravity, time step, quality, sleeping, max_error), and the rules between kinds of shapes
 * (thud_rules.h). What only the def says is not in it: the world that is restored must have the
 * same length scale, broadphase, substeps, contact_stiffness, contact_damping, push_speed,
 * restitution_threshold, hit_speed, maximum_speed, contact_events, time_budget and detection.
 * Callbacks (listeners, the filter of thud_world_set_filter), log, clock, job system, allocator and
 * baseline_simd stay as that world has them; other callbacks may well do something else. The
 * caller's own state is for the caller to copy; a thud_mover is a plain struct.
 *
 * A program that uses this links every shape kind, every detection and the island solver, since a
 * snapshot may name them; one that does not pays nothing. */
#ifndef THUD_SNAPSHOT_H
#define THUD_SNAPSHOT_H

#include "thud_ids.h"
#include "thud_math.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* *bytes is what a snapshot taken now needs: for each body with a shape about 0.5 kB, for
 * each touching pair about 0.25 kB. THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_snapshot_size(const thud_world *world, size_t *bytes);

/* Writes a snapshot to `buffer`, which needs no alignment; *bytes (may be null) is its size. It
 * costs two passes over the bytes, allocates nothing and does not change the world.
 * THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_INVALID where `capacity` is less
 * than thud_world_snapshot_size tells. The buffer is then as it was. */
THUD_API thud_result thud_world_snapshot(const thud_world *world, void *buffer, size_t capacity,
                                         size_t *bytes);

/* Puts the world, or another one from the same def, into the state that the snapshot was taken in.
 * Handles are valid again where they were then. Those made since are stale, until something takes
 * the same place: the same calls make the same handles again. Another world takes the snapshot's
 * handles over, and its own become stale. What thud_world_poses, thud_world_events and
 * thud_shape_terrain gave before is void. Memory that the world has is used again.
 *
 * THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_INVALID, with the reason in the
 * log, for bytes that are cut short, damaged, no snapshot, or of another version or build of thud
 * (snapshots are for the same version, word size, byte order and alignment), and for a world whose
 * def has another of the settings above, or that never had a joint (thud_world_use_joints) or a
 * rule (thud_world_use_rules) where the snapshot has some; THUD_ERROR_MEMORY. In each case the
 * world is as it was. `bytes` is exactly the snapshot's size, as thud_world_snapshot told it,
 * however large the buffer is: with more the snapshot is refused as damaged is.
 *
 * Damage is found by a checksum over all bytes: a change within one word of 8 bytes for certain,
 * any other but for one in 2^64. Sizes and counts are checked as well, so that restoring writes
 * only where there is room; but the values of bytes that somebody forged, checksum and all, can
 * name what is not there, which the next step follows: restore only what you trust. */
THUD_API thud_result thud_world_restore(thud_world *world, const void *buffer, size_t bytes);

/* ---- files ---- */

/* Writes the world to a file, by its path as fopen takes it, with `bytes` bytes of the caller's own
 * beside it (`own`; null where there are none): score, handles, movers. It is written under the
 * name with a ~ behind it first, so that where saving fails a file of that name is as it was.
 * THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_MEMORY for the time of the call;
 * THUD_ERROR_INVALID where the file cannot be written. */
THUD_API thud_result thud_world_save(thud_world *world, const char *path, const void *own,
                                     size_t bytes);

/* Reads it back, into this world or another one from the same def, as thud_world_restore does, and
 * the caller's bytes to `own`. Fails as that does; THUD_ERROR_INVALID, too, for a file that is not
 * there or cannot be read, is cut short, damaged or none of thud_world_save, and where it was saved
 * with another number of bytes. Then world and `own` are as they were. */
THUD_API thud_result thud_world_load(thud_world *world, const char *path, void *own, size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
