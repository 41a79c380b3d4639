/* thud_packed.h: packed snapshots: the bytes of thud_snapshot.h, made small to be sent, saved or
 * kept in large numbers; alone, or against an earlier snapshot of the same world, the base, as a
 * delta. thud.h does not include this header; a program that uses it links what thud_snapshot.h
 * names.
 *
 *     thud_bytes base = {earlier, earlier_bytes}, now = {buffer, bytes};
 *     thud_world_pack(world, base, now, packed, capacity, &packed_bytes);
 *     ... where the base is known, too
 *     thud_world_unpack(world, base, (thud_bytes){packed, packed_bytes}, buffer, capacity, &bytes);
 *     thud_world_restore(world, buffer, bytes);
 *
 * Nothing is lost: unpacking gives the bytes of the snapshot again. The same snapshots give the
 * same packed bytes on every platform. Packing and unpacking allocate nothing and do not change the
 * world, which may be any of the same build; its log is told why a call is refused. */
#ifndef THUD_PACKED_H
#define THUD_PACKED_H

#include "thud_ids.h"
#include "thud_math.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes that a call reads. They need no alignment. */
typedef struct thud_bytes {
    const void *data; /* null: none */
    size_t count;     /* number of bytes; 0 where data is null */
} thud_bytes;

/* Packs a snapshot into `buffer` of `capacity` bytes; *out_bytes is the packed size. With a null
 * buffer and a capacity of 0 the call only writes *out_bytes, which takes as long as packing. The
 * packed size is never more than the snapshot's, an eighth of it and 2048 bytes.
 *
 * `base` is an earlier snapshot of the same world, which the program that unpacks must have as
 * well; the fewer steps lie between the two, the fewer the packed bytes. {NULL, 0}: none. The three
 * must not overlap in memory.
 *
 * THUD_ERROR_NULL for a null world, snapshot or out_bytes; THUD_ERROR_LOCKED inside a callback;
 * THUD_ERROR_INVALID where the base or the snapshot is damaged, or of another version or build of
 * thud, or where `capacity` is less than the packed size. Nothing is written then. */
THUD_API thud_result thud_world_pack(const thud_world *world, thud_bytes base, thud_bytes snapshot,
                                     void *buffer, size_t capacity, size_t *out_bytes);

/* Unpacks a snapshot into `buffer` of `capacity` bytes; *out_bytes is its size. With a null buffer,
 * and a capacity of 0, only *out_bytes is written, at once. `base` is the one that it was packed
 * against; {NULL, 0}: none. The three must not overlap in memory.
 *
 * THUD_ERROR_NULL for a null world, packed or out_bytes; THUD_ERROR_LOCKED inside a callback;
 * THUD_ERROR_INVALID for bytes that are cut short, damaged, nothing that thud_world_pack wrote, or
 * of another version or build of thud, for another base than that with which they were packed, and
 * where `capacity` is less than the snapshot's size. Nothing is written then. Checksums detect
 * damage as those of thud_world_restore do; forged bytes whose checksum is right are refused as
 * well, but after some of the buffer was written. */
THUD_API thud_result thud_world_unpack(const thud_world *world, thud_bytes base, thud_bytes packed,
                                       void *buffer, size_t capacity, size_t *out_bytes);

#ifdef __cplusplus
}
#endif

#endif
