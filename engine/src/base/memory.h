/* memory.h: the allocator hooks, and growable arrays that remember their stride.
 *
 * Arrays hold indices, never pointers into each other, so that growing one moves nothing that
 * anybody else holds and a snapshot is a copy of the arrays. */
#ifndef TD_MEMORY_H
#define TD_MEMORY_H

#include "base/base.h"
#include "thud/thud_hooks.h"

typedef struct td_memory {
    thud_allocator hooks;
    uint64_t bytes;       /* held now */
    uint64_t allocations; /* ever made */
} td_memory;

typedef struct td_array {
    void *data; /* 64-byte aligned */
    int count, capacity;
    int stride; /* bytes an element */
} td_array;

/* Fills in the C library's allocator where the caller gave none. */
td_memory td_memory_make(thud_allocator hooks);
void *td_memory_get(td_memory *memory, size_t bytes); /* zeroed, 64-byte aligned; null on failure */
void td_memory_put(td_memory *memory, void *block, size_t bytes);

/* Makes room for `capacity` elements; new room is zeroed. False when memory is short, and the
 * array is as before. */
bool td_array_reserve(td_memory *memory, td_array *array, int capacity);
void td_array_free(td_memory *memory, td_array *array);

/* Where in its owner an array is, and how many bytes its elements have. */
typedef struct td_array_place {
    uint16_t at, stride;
} td_array_place;

#define TD_ARRAY_PLACE(owner, name, element) \
    { offsetof(owner, name), sizeof(element) }

/* Sets the strides of all arrays of an owner; makes room in all; frees them all. */
void td_arrays_init(void *owner, const td_array_place *places, size_t count);
bool td_arrays_reserve(td_memory *memory, void *owner, const td_array_place *places, size_t count,
                       int capacity);
void td_arrays_free(td_memory *memory, void *owner, const td_array_place *places, size_t count);

enum { TD_CHUNK = 64 };

/* Elements that are handed out one by one, the lowest freed last, and never move: they lie in
 * chunks, so that growing costs little whatever is there already. The free ones are chained through
 * their first int. */
typedef struct td_slots {
    td_array chunks; /* void *: TD_CHUNK elements each */
    int stride;      /* bytes an element */
    int count;       /* ever handed out */
    int free_head;   /* TD_NONE when none */
    int live;
} td_slots;

void td_slots_init(td_slots *slots, int stride);
bool td_slots_reserve(td_memory *memory, td_slots *slots, int more); /* room for `more` new ones */
int td_slots_take(td_slots *slots); /* after td_slots_reserve; contents as they were left */
void td_slots_give(td_slots *slots, int index);
void td_slots_free(td_memory *memory, td_slots *slots);

static inline void *td_at(const td_array *array, int index) {
    assert(index >= 0 && index < array->capacity);
    return (char *)array->data + (size_t)index * (size_t)array->stride;
}

static inline int td_slots_capacity(const td_slots *slots) {
    return slots->chunks.count * TD_CHUNK;
}

static inline void *td_slot_of(const td_slots *slots, int index, size_t stride) {
    assert(index >= 0 && index < td_slots_capacity(slots));
    char *chunk = ((void **)slots->chunks.data)[(unsigned)index / TD_CHUNK];
    return chunk + ((unsigned)index % TD_CHUNK) * stride;
}

static inline void *td_slot_at(const td_slots *slots, int index) {
    return td_slot_of(slots, index, (size_t)slots->stride);
}

/* An element of an array of a type; what has elements of another size is noticed where assertions
 * are on. */
#define TD_AT(type, array, index) ((type *)td_element_at((array), (index), sizeof(type)))

static inline void *td_element_at(const td_array *array, int index, size_t bytes) {
    assert(index >= 0 && index < array->capacity && (size_t)array->stride == bytes);
    return (char *)array->data + (size_t)index * bytes;
}

/* The element behind the last one of an array with room reserved, which then counts. */
#define TD_PUSH(type, array) (*(type *)td_append((array), sizeof(type)))

static inline void *td_append(td_array *array, size_t bytes) {
    return td_element_at(array, array->count++, bytes);
}

static inline int td_int_at(const td_array *array, int index) {
    return *TD_AT(int, array, index);
}

static inline void td_int_set(td_array *array, int index, int value) {
    *TD_AT(int, array, index) = value;
}

/* Appends one int to an array of ints with room reserved. */
static inline void td_push_int(td_array *array, int value) {
    TD_PUSH(int, array) = value;
}

/* Into rising order, whichever one they were found in. */
void td_sort_ints(td_array *array);

#endif
