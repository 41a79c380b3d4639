/* thud_memory.h: where a world gets its memory from. */
#ifndef THUD_MEMORY_H
#define THUD_MEMORY_H

#include <stddef.h>

typedef struct thud_allocator {
    void *(*allocate)(size_t bytes, void *context); /* 64-byte aligned, or null */
    void (*release)(void *block, size_t bytes, void *context);
    void *context;
} thud_allocator; /* all zero: the C library's; one function without the other is refused */

#endif
