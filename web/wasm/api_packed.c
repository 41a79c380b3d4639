/* api_packed.c: exports for packed snapshots. Packing and unpacking read two buffers, and write a
 * third one. */
#include "api.h"

#include <thud/thud_packed.h>

#include <stdlib.h>

/* Whose bytes a buffer has: of the base, of what is packed or unpacked, and of the result. */
enum { BASE, GIVEN, RESULT, BUFFERS };

static char *buffer[BUFFERS];
static size_t capacity[BUFFERS];

/* A buffer with room for at least `bytes` bytes; its contents are lost where it grows. Null where
 * memory is short. */
char *api_packed_room(uint32_t which, uint32_t bytes) {
    if (which < BUFFERS && bytes > capacity[which]) {
        free(buffer[which]);
        buffer[which] = malloc(bytes);
        capacity[which] = buffer[which] == NULL ? 0 : bytes;
    }
    return which < BUFFERS ? buffer[which] : NULL;
}

/* The base; none where it has no bytes. */
static thud_bytes base_of(uint32_t bytes) {
    return (thud_bytes){bytes ? buffer[BASE] : NULL, bytes};
}

/* Writes the address and the number of the result's bytes to the slots: a list that is valid until
 * the next call of this file. */
static int list_result(thud_result result, size_t bytes) {
    api_slots.list.address = (double)(uintptr_t)buffer[RESULT];
    api_slots.list.count = (double)bytes;
    return result;
}

/* Packs the `bytes` first bytes of the second buffer against the `base` first ones of the first. */
int api_world_pack(const thud_world *world, uint32_t base, uint32_t bytes) {
    size_t room = (size_t)bytes + bytes / 8 + 2048, packed = 0; /* thud_packed.h: never more */
    if (api_packed_room(RESULT, (uint32_t)room) == NULL)
        return THUD_ERROR_MEMORY;
    thud_result result = thud_world_pack(world, base_of(base), (thud_bytes){buffer[GIVEN], bytes},
                                         buffer[RESULT], room, &packed);
    return list_result(result, packed);
}

/* Unpacks likewise. */
int api_world_unpack(const thud_world *world, uint32_t base, uint32_t bytes) {
    size_t size = 0;
    thud_bytes from = base_of(base), packed = (thud_bytes){buffer[GIVEN], bytes};
    thud_result result = thud_world_unpack(world, from, packed, NULL, 0, &size);
    if (result != THUD_OK)
        return result;
    if (size > UINT32_MAX - 1 || api_packed_room(RESULT, (uint32_t)size + 1) == NULL)
        return THUD_ERROR_MEMORY;
    result = thud_world_unpack(world, from, packed, buffer[RESULT], size, &size);
    return list_result(result, size);
}
