/* thud_ids.h: the world and the handles of its bodies and shapes. */
#ifndef THUD_IDS_H
#define THUD_IDS_H

#include <stdint.h>

/* One world is used by one thread at a time; different worlds share nothing. */
typedef struct thud_world thud_world;

/* A handle is a slot and a generation, which changes with each use of the slot. An all-zero handle
 * is the null handle. A stale handle is refused until its slot has been used 2^32 times over. A
 * handle of another world is refused as well, with one exception: if n worlds were created between
 * the two, a slot can have the same generation in both only if it was used at least 2^32 / (2.24 n)
 * times more in one than in the other: 1.9 million with n a thousand. After a restore from a
 * snapshot, the handles of the world of which it was taken are valid in the restored world. */
typedef struct thud_body_id {
    uint32_t index1;     /* slot + 1 */
    uint32_t generation; /* of the slot, mixed with the world's own number */
} thud_body_id;

/* A handle of a shape, with the rules of thud_body_id. */
typedef struct thud_shape_id {
    uint32_t index1;     /* as in thud_body_id */
    uint32_t generation; /* likewise */
} thud_shape_id;

#endif
