/* hostile_memory.h: an allocator for worlds that fails at a chosen allocation, and counts the
 * blocks that are held. Allocations of the test itself do not go through it. */
#ifndef HOSTILE_MEMORY_H
#define HOSTILE_MEMORY_H

#include <stdlib.h>

#include <thud/thud.h>

static long memory_allowed = -1; /* allocations until one fails; negative: none fails */
static long memory_held;         /* blocks allocated and not yet released */
static long memory_refused;      /* allocations that failed */

static inline void *hostile_allocate(size_t bytes, void *context) {
    (void)context;
    if (memory_allowed >= 0 && memory_allowed-- == 0) {
        memory_refused++;
        return NULL;
    }
    memory_held++;
    return aligned_alloc(64, bytes);
}

static inline void hostile_release(void *block, size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    memory_held--;
    free(block);
}

static inline thud_allocator hostile_memory(void) {
    return (thud_allocator){hostile_allocate, hostile_release, NULL};
}

#endif
