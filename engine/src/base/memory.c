/* memory.c: see memory.h. Here are the default allocator, growth by doubling, chunks of slots with
 * a free list, and a heap sort. */
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

/* The default allocator: blocks that are aligned to 64 bytes and zeroed. calloc does not touch
 * fresh pages of the system, which are zero already, so that room that is not used yet costs
 * neither time nor memory. The word before the block is the pointer that calloc returned. */
static void *library_allocate(size_t bytes, void *context) {
    (void)context;
    char *whole = calloc(1, bytes + 64);
    if (!whole) {
        return NULL;
    }
    void **block = (void **)(whole + 64 - (uintptr_t)whole % 64);
    block[-1] = whole;
    return block;
}

static void library_release(void *block, size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    free(((void **)block)[-1]);
}

td_memory td_memory_make(thud_allocator hooks) {
    td_memory memory = {hooks, 0, 0};
    if (!hooks.allocate) {
        memory.hooks = (thud_allocator){library_allocate, library_release, NULL};
    }
    return memory;
}

static void *refuse(size_t bytes, void *context) {
    (void)bytes, (void)context;
    return NULL;
}

static void release_nothing(void *block, size_t bytes, void *context) {
    (void)block, (void)bytes, (void)context;
}

td_memory td_memory_none(void) {
    return (td_memory){{refuse, release_nothing, NULL}, 0, 0};
}

/* A size in whole cache lines. */
static size_t rounded(size_t bytes) {
    return (bytes + 63) & ~(size_t)63;
}

void *td_memory_get(td_memory *memory, size_t bytes) {
    size_t size = rounded(bytes);
    void *block = memory->hooks.allocate(size, memory->hooks.context);
    if (block) {
        if (memory->hooks.allocate != library_allocate) {
            memset(block, 0, size);
        }
        memory->bytes += size;
        memory->allocations++;
    }
    return block;
}

void td_memory_put(td_memory *memory, void *block, size_t bytes) {
    if (block) {
        memory->bytes -= rounded(bytes);
        memory->hooks.release(block, rounded(bytes), memory->hooks.context);
    }
}

bool td_array_reserve(td_memory *memory, td_array *array, int capacity) {
    if (capacity <= array->capacity) {
        return true;
    }
    size_t stride = (size_t)array->stride;
    /* Capacities double, so that appending n elements moves O(n) of them. They stay below 2^27;
     * snapshot.c relies on this limit. */
    int64_t grown = td_max_int(array->capacity, 8);
    while (grown < capacity) {
        grown *= 2;
    }
    if (grown > INT32_MAX / 16) {
        return false;
    }
    void *data = td_memory_get(memory, (size_t)grown * stride);
    if (!data) {
        return false;
    }
    if (array->data) {
        memcpy(data, array->data, (size_t)array->capacity * stride);
        td_memory_put(memory, array->data, (size_t)array->capacity * stride);
    }
    array->data = data;
    array->capacity = (int)grown;
    return true;
}

void td_array_free(td_memory *memory, td_array *array) {
    td_memory_put(memory, array->data, (size_t)array->capacity * (size_t)array->stride);
    array->data = NULL;
    array->count = 0;
    array->capacity = 0;
}

static td_array *array_at(void *owner, td_array_place place) {
    return (td_array *)((char *)owner + place.at);
}

void td_arrays_init(void *owner, const td_array_place *places, size_t count) {
    for (size_t i = 0; i < count; i++) {
        array_at(owner, places[i])->stride = places[i].stride;
    }
}

bool td_arrays_reserve(td_memory *memory, void *owner, const td_array_place *places, size_t count,
                       int capacity) {
    for (size_t i = 0; i < count; i++) {
        if (!td_array_reserve(memory, array_at(owner, places[i]), capacity)) {
            return false;
        }
    }
    return true;
}

void td_arrays_free(td_memory *memory, void *owner, const td_array_place *places, size_t count) {
    for (size_t i = 0; i < count; i++) {
        td_array_free(memory, array_at(owner, places[i]));
    }
}

void td_slots_init(td_slots *slots, int stride) {
    slots->chunks.stride = (int)sizeof(void *);
    slots->stride = stride;
    slots->free_head = TD_NONE;
}

/* Bytes of a chunk of TD_CHUNK elements. */
static size_t chunk_bytes(const td_slots *slots) {
    return TD_CHUNK * (size_t)slots->stride;
}

bool td_slots_reserve(td_memory *memory, td_slots *slots, int more) {
    while (td_slots_capacity(slots) - slots->live < more) {
        if (!td_array_reserve(memory, &slots->chunks, slots->chunks.count + 1)) {
            return false;
        }
        void *chunk = td_memory_get(memory, chunk_bytes(slots));
        if (!chunk) {
            return false;
        }
        ((void **)slots->chunks.data)[slots->chunks.count++] = chunk;
    }
    return true;
}

int td_slots_take(td_slots *slots) {
    int index = slots->free_head;
    if (index != TD_NONE) {
        slots->free_head = *(int *)td_slot_at(slots, index);
    } else {
        index = slots->count++;
    }
    slots->live++;
    return index;
}

void td_slots_give(td_slots *slots, int index) {
    *(int *)td_slot_at(slots, index) = slots->free_head;
    slots->free_head = index;
    slots->live--;
}

void td_slots_free(td_memory *memory, td_slots *slots) {
    for (int i = 0; i < slots->chunks.count; i++) {
        td_memory_put(memory, ((void **)slots->chunks.data)[i], chunk_bytes(slots));
    }
    td_array_free(memory, &slots->chunks);
}

/* Restores the order of a heap, the greatest value on top, below index `at`. */
static void sift_down(int *heap, int at, int count) {
    int value = heap[at];
    for (int child = 2 * at + 1; child < count; child = 2 * at + 1) {
        child += child + 1 < count && heap[child + 1] > heap[child];
        if (heap[child] <= value) {
            break;
        }
        heap[at] = heap[child];
        at = child;
    }
    heap[at] = value;
}

/* Heap sort (Williams, 1964): a tenth of the code that the C library's qsort links. */
void td_sort_ints(td_array *array) {
    int *heap = array->data;
    for (int i = array->count / 2 - 1; i >= 0; i--) {
        sift_down(heap, i, array->count);
    }
    for (int last = array->count - 1; last > 0; last--) {
        int greatest = heap[0];
        heap[0] = heap[last];
        sift_down(heap, 0, last);
        heap[last] = greatest;
    }
}
