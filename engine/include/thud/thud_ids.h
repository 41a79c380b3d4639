/* thud_ids.h: the names by which callers hold a world, its bodies and its shapes. */
#ifndef THUD_IDS_H
#define THUD_IDS_H

#include <stdint.h>

/* One world is used by one thread at a time; different worlds share nothing. */
typedef struct thud_world thud_world;

/* Handles are index and generation. A zero handle is the null handle. A stale handle is refused in
 * every build until its slot has been used 2^32 times over. So is one of another world, but for one
 * case in which chance brings them together: with n worlds made in between, of two slots that were
 * used at least 2^32 / (2.24 n) times more in one world than in the other: 1.9 million with a
 * thousand. A world that a snapshot was restored to takes over the names of the world that it was
 * taken of. */
typedef struct thud_body_id {
    uint32_t index1;     /* slot + 1 */
    uint32_t generation; /* of the slot, mixed with the world's own number */
} thud_body_id;

typedef struct thud_shape_id {
    uint32_t index1;
    uint32_t generation;
} thud_shape_id;

#endif
