/* thud_snapshot.h: snapshots: the whole state of a world as plain bytes, to restore it later: for
 * rollback in networked games, rewinding, and saved games. thud.h does not include this header.
 *
 *     size_t bytes;
 *     thud_world_get_snapshot_size(world, &bytes);
 *     void *buffer = malloc(bytes);
 *     thud_world_snapshot(world, buffer, bytes, NULL);
 *     ... steps, edits ...
 *     thud_world_restore(world, buffer, bytes);
 *
 * After a restore every call gives the same results as it did after the snapshot, bit for bit:
 * poses, events, errors, hash, and the handles of new bodies and shapes. So a game that stores a
 * snapshot and the calls that followed can repeat them, with further calls in between. Exceptions
 * are measurements of time and memory (stats.bytes, stats.step_allocations, the seconds of stages),
 * and worlds with a time_budget, which depend on the clock.
 *
 * A snapshot contains everything that can change in a world: bodies, shapes, the lines of terrains,
 * contacts with their impulses, sleep, edits that wait for the next step, events, the remaining
 * time of thud_world_advance and its forces, the settings with a setter (gravity, time step,
 * quality, sleeping, max_error), the rules of thud_rules.h, and the textures of thud_textured.h. It
 * does not contain settings that only the def can set: the restored world must have the same length
 * scale, broadphase, substeps, contact_stiffness, contact_damping, push_speed,
 * restitution_threshold, hit_speed, maximum_speed, contact_events, time_budget and detection.
 * Callbacks (listeners, the filter of thud_world_set_filter), log, clock, job system and allocator
 * of the restored world do not change; with other callbacks its results may differ. The caller must
 * copy its own state; a thud_mover is a plain struct.
 *
 * thud_packed.h makes the bytes small, to send or keep them.
 *
 * A program that uses snapshots links every shape kind, every detection and the island solver,
 * since a snapshot may need them. */
#ifndef THUD_SNAPSHOT_H
#define THUD_SNAPSHOT_H

#include "thud_ids.h"
#include "thud_math.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* *out_bytes: the size of a snapshot taken now: for each body with a shape about 0.5 kB, for each
 * touching pair about 0.25 kB. THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_get_snapshot_size(const thud_world *world, size_t *out_bytes);

/* Writes a snapshot to `buffer` of `capacity` bytes, which needs no alignment; *out_bytes (may be
 * null) is its size. The call makes two passes over the bytes, allocates nothing and does not
 * change the world. THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_INVALID where
 * `capacity` is less than the size by thud_world_get_snapshot_size. The buffer is then not written.
 */
THUD_API thud_result thud_world_snapshot(const thud_world *world, void *buffer, size_t capacity,
                                         size_t *out_bytes);

/* Restores the world, or another one made from the same def, to the state of the snapshot. Handles
 * that were valid then are valid again. Handles that were created since are stale, until a new body
 * or shape gets the same slot: the same calls return the same handles again. If another world is
 * restored, the handles of the snapshot become valid in it, and its own handles stale. Pointers
 * from thud_world_get_poses, thud_events_of and thud_shape_get_terrain become invalid. The world's
 * memory is reused.
 *
 * THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_INVALID, with the reason in the
 * log, for bytes that are truncated, damaged, not a snapshot, or of another version or build of
 * thud (snapshots are for the same version, byte order and alignment: those of 64-bit machines with
 * the byte order of x86-64 and of WebAssembly are the same), and for a world whose def differs in
 * one of the settings above, or that never had a joint (thud_world_use_joints), a rule
 * (thud_world_use_rules) or a texture (thud_world_use_textures) if the snapshot has some;
 * THUD_ERROR_MEMORY. In each case the world is unchanged. `bytes` must be exactly the snapshot's
 * size as thud_world_snapshot returned it, even where the buffer is larger.
 *
 * A checksum over all bytes detects damage: every change within one word of 8 bytes, and other
 * changes with a probability of 1 - 2^-64. Sizes and counts are also checked, so that a restore
 * never writes out of bounds. But a forged snapshot with a correct checksum can contain indices
 * that make the next step access memory out of bounds: restore only bytes that you trust. */
THUD_API thud_result thud_world_restore(thud_world *world, const void *buffer, size_t bytes);

/* ---- files ---- */

/* Writes a snapshot, packed (thud_packed.h), to a file, with `bytes` bytes of the caller's own data
 * (`own`; null if there are none): score, handles, movers. `path` is a path for fopen. The data is
 * first written to the path with a ~ appended, and then renamed, so that an existing file is
 * unchanged if saving fails; on Windows it is removed just before the renaming, and is lost if that
 * fails. THUD_ERROR_NULL; THUD_ERROR_LOCKED inside a callback;
 * THUD_ERROR_MEMORY, since the call allocates a buffer; THUD_ERROR_INVALID if the file cannot be
 * written. */
THUD_API thud_result thud_world_save(thud_world *world, const char *path, const void *own,
                                     size_t bytes);

/* Restores the world, or another one made from the same def, from such a file, as
 * thud_world_restore, and reads the caller's data to `out_own`. Errors as for thud_world_restore;
 * THUD_ERROR_INVALID also for a file that does not exist or cannot be read, is truncated, damaged
 * or not written by thud_world_save, or was saved with another number of `bytes`. World and
 * `out_own` are then unchanged. */
THUD_API thud_result thud_world_load(thud_world *world, const char *path, void *out_own,
                                     size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
