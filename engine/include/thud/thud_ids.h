/* thud_ids.h: the names by which callers hold a world, its bodies and its shapes. */
#ifndef THUD_IDS_H
#define THUD_IDS_H

#include <stdint.h>

/* One world is used by one thread at a time; different worlds share nothing. */
typedef struct thud_world thud_world;

/* Handles are index and generation. A zero handle is the null handle. A stale handle, or one of
 * another world, is refused in every build. */
typedef struct thud_body_id {
    uint32_t index1;     /* slot + 1 */
    uint32_t generation; /* of the slot, mixed with the world's own number */
} thud_body_id;

typedef struct thud_shape_id {
    uint32_t index1;
    uint32_t generation;
} thud_shape_id;

#endif
