/* memory.h: allocation by the caller's hooks, growable arrays, and slots (pools of records).
 *
 * Records refer to each other by index, never by pointer, so that an array may move when it grows,
 * and so that a snapshot is a copy of the arrays. */
#ifndef TD_MEMORY_H
#define TD_MEMORY_H

#include "base/base.h"
#include "thud/thud_hooks.h"

typedef struct td_memory {
    thud_allocator hooks;
    uint64_t bytes;       /* allocated at present */
    uint64_t allocations; /* number of allocations so far */
} td_memory;

/* A growable array. The owner sets `stride` before the first use. */
typedef struct td_array {
    void *data;   /* 64-byte aligned; null while capacity is 0 */
    int count;    /* elements in use */
    int capacity; /* elements that there is room for */
    int stride;   /* bytes of an element */
} td_array;

/* Memory by the caller's hooks; where they are null, by the C library's allocator. */
td_memory td_memory_make(thud_allocator hooks);
/* A memory from which every allocation fails, for workers, which must not allocate. */
td_memory td_memory_none(void);
/* Allocates a block, zeroed and 64-byte aligned; null when memory is short. */
void *td_memory_get(td_memory *memory, size_t bytes);
/* Frees a block of that size; null is allowed. */
void td_memory_put(td_memory *memory, void *block, size_t bytes);

/* Makes room for `capacity` elements; new room is zeroed. False when memory is short, and the
 * array is as before. */
bool td_array_reserve(td_memory *memory, td_array *array, int capacity);
void td_array_free(td_memory *memory, td_array *array);

/* Describes an array that is a member of a struct, its owner: offset of the array, bytes of an
 * element. */
typedef struct td_array_place {
    uint16_t at, stride;
} td_array_place;

#define TD_ARRAY_PLACE(owner, name, element) \
    { offsetof(owner, name), sizeof(element) }

/* For all listed arrays of an owner: set the strides; make room (false when memory is short); free.
 */
void td_arrays_init(void *owner, const td_array_place *places, size_t count);
bool td_arrays_reserve(td_memory *memory, void *owner, const td_array_place *places, size_t count,
                       int capacity);
void td_arrays_free(td_memory *memory, void *owner, const td_array_place *places, size_t count);

enum { TD_CHUNK = 64 }; /* elements of a chunk of td_slots. Chosen. */

/* A pool of records of one size, which are taken and given back one by one and never move: they lie
 * in chunks, so that the pool grows without copying. Free records form a list, last given first
 * taken, linked through their first int. */
typedef struct td_slots {
    td_array chunks; /* void *: TD_CHUNK elements each */
    int stride;      /* bytes of an element */
    int count;       /* indices 0 .. count - 1 have been taken at some time */
    int free_head;   /* first free record below `count`, or TD_NONE */
    int live;        /* records that are taken at present */
} td_slots;

void td_slots_init(td_slots *slots, int stride);
/* Makes room for `more` records. False when memory is short. */
bool td_slots_reserve(td_memory *memory, td_slots *slots, int more);
/* Takes a record, for which there must be room, and returns its index. A record that was given back
 * still has its old contents, except for its first int; one that was never taken is all zeros. */
int td_slots_take(td_slots *slots);
/* Gives a record back; its first int is overwritten. */
void td_slots_give(td_slots *slots, int index);
void td_slots_free(td_memory *memory, td_slots *slots);

/* Element `index` of an array, below its capacity. */
static inline void *td_at(const td_array *array, int index) {
    assert(index >= 0 && index < array->capacity);
    return (char *)array->data + (size_t)index * (size_t)array->stride;
}

static inline int td_slots_capacity(const td_slots *slots) {
    return slots->chunks.count * TD_CHUNK;
}

/* Record `index` of a pool; `stride` is passed so that it may be a constant. */
static inline void *td_slot_of(const td_slots *slots, int index, size_t stride) {
    assert(index >= 0 && index < td_slots_capacity(slots));
    char *chunk = ((void **)slots->chunks.data)[(unsigned)index / TD_CHUNK];
    return chunk + ((unsigned)index % TD_CHUNK) * stride;
}

static inline void *td_slot_at(const td_slots *slots, int index) {
    return td_slot_of(slots, index, (size_t)slots->stride);
}

/* Element `index` of an array, as a pointer to its type. An assertion compares the size of the type
 * with the stride. */
#define TD_AT(type, array, index) ((type *)td_element_at((array), (index), sizeof(type)))

static inline void *td_element_at(const td_array *array, int index, size_t bytes) {
    assert(index >= 0 && index < array->capacity && (size_t)array->stride == bytes);
    return (char *)array->data + (size_t)index * bytes;
}

/* The new last element of an array that has room, as an lvalue: TD_PUSH(int, &list) = 3. */
#define TD_PUSH(type, array) (*(type *)td_append((array), sizeof(type)))

static inline void *td_append(td_array *array, size_t bytes) {
    return td_element_at(array, array->count++, bytes);
}

/* Element `index` of an array of ints. */
static inline int td_int_at(const td_array *array, int index) {
    return *TD_AT(int, array, index);
}

static inline void td_int_set(td_array *array, int index, int value) {
    *TD_AT(int, array, index) = value;
}

/* Appends an int to an array of ints that has room. */
static inline void td_push_int(td_array *array, int value) {
    TD_PUSH(int, array) = value;
}

/* Sorts an array of ints in rising order. */
void td_sort_ints(td_array *array);

#endif
